//! Messages about gaps that are no gaps.

use quote::quote;

use super::{assert_only_fault, on_ball, on_unit, run};

#[test]
fn a_parameter_with_the_name_of_its_struct_is_refused() {
    let item = quote!(
        struct Ball<Ball> {
            radius: Ball,
        }
    );
    let messages = run(quote!(r ^ 2 / radius), item).err().unwrap_or_default();
    assert!(matches!(&messages[..], [only] if only.contains("rename one of them")), "{messages:?}");
}

#[test]
fn a_field_is_no_exponent_whatever_its_type() {
    for kind in [quote!(f64), quote!(i32)] {
        let item = quote!(
            struct Knee {
                c: f64,
                n: #kind,
            }
        );
        let messages = run(quote!(c * r ^ n), item).err().unwrap_or_default();
        assert!(
            matches!(&messages[..], [only] if only.contains("an exponent must be a number")),
            "{messages:?}"
        );
    }
}

#[test]
fn a_second_profile_is_one_fault() {
    let item = "#[derive(Debug)] #[cartcontact::gap_profile(r^4)] struct Knee;".parse().unwrap();
    let output = crate::expand(quote!(r ^ 2), item).to_string();
    assert!(output.matches("compile_error").count() == 1 && output.contains("one gap profile"), "{output}");
    assert!(!output.contains("gap_profile (r ^ 4)"));
}

#[test]
fn each_fault_is_named() {
    for (text, rule) in [
        ("2r^2", "write `2 * r`"),
        ("2f64*r^2", "drop the suffix"),
        ("conic + r^2", "as in `conic(20, -0.5)`"),
        ("sphere(R = 10), order = 4", "write `sphere(10)`"),
        ("sphere(10,5), order = 4", "write `sphere(10.5)` or `conic(10, 5)`"),
        ("sphere(10, -0.5), order = 4", "write `conic(10, -0.5)`"),
        ("sphere(), order = 4", "as in `sphere(20)`"),
        ("sphere(R == 10), order = 4", "write `sphere(10)`"),
        ("sphere(10; 5), order = 4", "write `conic(10, 5)`"),
        ("sphere(2 radius, k), order = 4", "as in `sphere(20)`"),
        ("conic(10; 0.5), order = 4", "write `conic(10, 0.5)`"),
        ("conic(10,5; -0,5), order = 4", "write `conic(10.5, -0.5)`"),
        ("conic(10 -0.5), order = 4", "write `conic(10, -0.5)`"),
        ("conic(10 + 0.5), order = 4", "write `conic(10, 0.5)`"),
        ("conic(radius -0.5), order = 4", "add the conic constant after a comma"),
        ("conic(radius k), order = 4", "add the conic constant after a comma"),
        ("conic(2 * radius), order = 4", "write `conic(2 * radius, -0.5)`"),
        ("conic(R = 2 radius, k = 3), order = 4", "as in `conic(20, -0.5)`"),
        ("sphere 10, order = 4", "write `sphere(10)`"),
        ("sphere 2 * 10, order = 4", "as in `sphere(20)`"),
        ("sphere[10], order = 4", "write `sphere(10)`"),
        ("conic(20, -0,4), order = 4", "write `conic(20, -0.4)`"),
        ("conic(20,5, -0,4), order = 4", "write `conic(20.5, -0.4)`"),
        ("conic(20,5, 4), order = 4", "write `conic(20, 5.4)` or `conic(20.5, 4)`"),
        ("conic(k = -0.4, R: 15), order = 4", "write `conic(15, -0.4)`"),
        ("conic(-0.4, radius = 15), order = 4", "write `conic(15, -0.4)`"),
        ("conic(k = -0,4, R = 15,5), order = 4", "write `conic(15.5, -0.4)`"),
        ("sphere(R = 10, k = 5), order = 4", "write `conic(10, 5)`"),
        ("conic(R = 15), order = 4", "write `conic(15, -0.5)`"),
        ("conic(15), order = 4", "write `conic(15, -0.5)`"),
        ("conic(1, 2, 3, 4, 5, 6), order = 4", "as in `conic(20, -0.5)`"),
        ("r**2", "not `**`, as in"),
        ("r.powi(2)", "no methods"),
        ("self.radius*r", "write `radius`"),
        ("k.x*r", "write `x`, or `k` if that is the field"),
        ("sin(r)", "no functions"),
        ("gamma(r)", "without functions"),
        ("2 r", "an operator is missing"),
        ("(r)(r)", "an operator is missing"),
        ("q^2", "`q` is unknown; only `r` is known here; a field declares a symbol"),
        ("0.5 * r2", "for the power write `r^2`; a field declares a symbol, as in `struct Knee { r2: f64 }`"),
        ("0.5r2", "write `0.5 * r^2`, or `0.5 * r2` if `r2` is a field"),
        ("r^2/(2*R)", "the number, or declare a field, as in `struct Knee { R: f64 }`"),
        ("K * r^2", "not known here: write the number, or declare a field, as in `struct Knee { K: f64 }`"),
        ("r^2 < 3", "`<` has no meaning"),
        ("r^2 == 3", "`=` has no meaning"),
        ("[r]", "only parentheses group terms; write `( )` in place of `[ ]`"),
        ("{r}", "only parentheses group terms; write `( )` in place of `{ }`"),
        ("cone(10)", "as in `0.1 * r`"),
        ("2^1/2*r", "read as `(2^1)/2`"),
        ("(1 + r)^1/2", "read as `((...)^1)/2`"),
        ("()", "parentheses are empty"),
        ("r +", "something is missing here"),
        ("* r", "something is missing before `*`"),
        ("'r'", "is not a number"),
        ("true", "`true` is unknown"),
        ("1e999999999*r", "between -400 and 400"),
        ("2^999999999*r", "too large or too small"),
        ("sphere(2^9000), order = 4", "too large or too small"),
        ("r^r", "an exponent must be a number"),
        ("(1 + r)^-1", "must be a sum of powers of r"),
        ("(1 + r)^0.5", "must be a sum of powers of r"),
        ("(r + r^2)^5000", "powers up to 4096"),
        ("(r + r^2)^4000", "too many terms"),
        ("r/0", "divisor must not be zero"),
        ("r/(r - r)", "divisor must not be zero"),
        ("r^2 + 3", "remove `+ 3`"),
        ("r^2 - 3", "remove `- 3`"),
        ("3 + r^2", "remove `3`"),
        ("-(3 + r) + 2*r", "write `+ 3` behind the gap"),
        ("(r^2 + 0.5 + r)", "remove `+ 0.5`"),
        ("r^2 - 2/3", "remove this term"),
        ("r^2 + 1e-400", "remove this term"),
        ("r^2 + 1e-400 - 2e-400", "write behind the gap what takes it away"),
        ("r^2 + 1 + 2", "write `- 3` behind the gap"),
        ("(r + 1)^2", "write `- 1` behind the gap"),
        ("(r - 1)^3", "write `+ 1` behind the gap"),
        ("0.5*(1 + r^2)", "write `- 0.5` behind the gap"),
        ("(1 + r)^3/6", "write `- 1/6` behind the gap"),
        (
            "(1 + 1.000001*r)^2 + (0.123456789 + r)^3",
            "write `- 1001881676371789154860897069/1000000000000000000000000000` behind the gap",
        ),
        ("upper = r^2 + 3, lower = 0", "remove `+ 3`"),
        ("upper = r^2, lower = 0.5", "a flat body is `0`, as in `lower = 0`"),
        ("upper = sphere(20), lower = 10, order = 4", "a flat body is `0`, as in `lower = 0`"),
        ("upper = (1 + r)^2, lower = 1", "write `- 2` behind a body"),
        ("0.025 * r^0", "write one that opens with r, as in"),
        ("r^2 - r^2 + 3", "write one that opens with r, as in"),
        ("r^-2", "greater than 0"),
        ("r^2 - r^2", "zero everywhere"),
        ("(r - r)^2", "zero everywhere"),
        ("r^1025", "at most 1024"),
        ("r^(1/1025)", "at least 1/1024"),
        ("r^2 + r^1e-300", "at least 1/1024"),
        ("1e-390*r", "does not fit"),
        ("2^0.5*r", "not a fraction"),
        ("(-4)^0.5*r", "no root"),
        ("0^0*r", "no value"),
        ("r^2, max_radius = 0", "greater than 0"),
        ("r^2, max_radius = r", "must not depend on r"),
        ("r^2, max_radius = 1e400", "does not fit"),
        ("r^2, max_radius = (0..5)", "write `max_radius = 5`"),
        ("-r^2 + r^4, max_radius = 1", "falls from the centre"),
        ("r^2 - r^1.0001", "falls from the centre"),
        ("1e-300*r^2 + 1e300*r^1022 - 1e-300*r^1023", "too intricate"),
        ("r - r^1.001 + r^1.0001", "a common fraction"),
    ] {
        assert_only_fault(text, on_unit(text), rule);
    }
}

/// Each reading of what follows `/` is another geometry, so both are written out, and each means what it says.
#[test]
fn remedies_of_divisors_say_what_divides() {
    for (text, remedies) in [
        ("r^2/2radius", "write `(2 * radius)` if all of it divides, or `2 * radius` if only `2` does"),
        ("r^2/2 radius", "write `(2 * radius)` if all of it divides, or `2 * radius` if only `2` does"),
        ("1/2radius*r^2", "write `(2 * radius)` if"),
        ("r^2/radius + r^4/8radius^3", "write `(8 * radius^3)` if"),
        ("r^2/8radius**3", "write `(8 * radius^3)` if"),
        ("r^2/8radius**-3", "write `(8 * radius^-3)` if"),
        ("r^2/8radius^-3 - r", "write `(8 * radius^-3)` if"),
        (
            "1/2(r^2 + r^4)",
            "write `(2 * (r^2 + r^4))` if all of it divides, or `2 * (r^2 + r^4)` if only `2`",
        ),
        ("r^2/-2radius", "write `(-2 * radius)` if all of it divides, or `-2 * radius` if only `-2` does"),
        ("r^2/2 sphere(10)", "write `(2 * sphere(10))` if"),
        ("r^4/r^2radius", "write `(r^2 * radius)` if"),
        ("r^4/r(radius + 1) 2radius", "write `(r * (radius + 1) * 2 * radius)` if all"),
        ("r^2/2(radius +)", "write `*`, and parentheses around all that divides"),
        ("r^2/2 > radius r", "`>` has no meaning"),
        ("2 r^2", "write `*`, as in `2 * r`"),
        ("r^2 / 2 * radius radius", "write `*`, as in `2 * r`"),
    ] {
        let messages = on_ball(text).err().unwrap();
        assert!(
            messages.len() == 1 && messages[0].replace(" ^", "^").replace("^ ", "^").contains(remedies),
            "{text}: {messages:?}"
        );
    }
}

#[test]
fn what_a_gap_is_at_its_centre_can_be_taken_away() {
    for text in [
        "(r + 1)^2",
        "(1 + r)^3/6",
        "(1 + 1.000001*r)^2 + (0.123456789 + r)^3",
        "(1 + r)^2 + 1e3 + 1e-5 + 7e20",
        "(r + radius)^2",
        "(r + 1)^2/(2*radius)",
        "(r + radius - 1)^2",
        "2*(r^2 + radius - 1)",
    ] {
        let messages = on_ball(text).err().unwrap();
        let remedy = messages[0].split('`').nth(1).unwrap();
        assert!(on_ball(&format!("{text} {remedy}")).is_ok(), "{text}: {messages:?}");
    }
}

#[test]
fn faults_of_all_terms_are_reported_together() {
    let messages = on_ball("2r^2 + sin(r) + raduis*r - name*r*name + r^radius + 3, depth = 3").err().unwrap();
    for rule in ["`2 * r`", "functions", "did you mean `radius`", "field `name`", "exponent", "`depth`"] {
        assert!(messages.iter().any(|message| message.contains(rule)), "{rule}: {messages:?}");
    }
    // The constant may be what makes the unknown function vanish.
    assert_eq!(messages.len(), 6);
    for (text, rules) in [
        ("r^2 + 3, max_radius = 0, order = 3", ["remove `+ 3`", "greater than 0", "even"].as_slice()),
        ("-r^2, foo = 3", &["not an option", "falls from the centre"]),
        ("-r^2, max_radius = -3", &["greater than 0", "falls from the centre"]),
        ("r^2, max_radius = 1e400*radius", &["does not fit"]),
        ("r^2 - r^2, depth = 3", &["not an option", "its terms cancel"]),
        ("r^2 - r^4 + 1", &["remove `+ 1`", "add `max_radius"]),
        ("r^2 - r^4, maximum = 0.5", &["not an option"]),
        ("2x * raduis * r^2", &["one literal", "did you mean `radius`?"]),
        ("sin(r) * raduis * r^2", &["no functions", "did you mean `radius`?"]),
        (
            "raduis^3 / f64::powi(r, 2).abs() / depth",
            &["`^`", "did you mean `radius`?", "`depth` is unknown"],
        ),
        ("femur = sphere(10), tibia = sphere(20), order = 4", &["write `upper =`", "write `lower =`"]),
        ("tibia = r^2, order = 3, femur = -2*r^2", &["write `upper =`", "write `lower =`", "even", "falls"]),
        ("bottom = 0, top = sphere(20), order = 4", &["write `lower =`", "write `upper =`"]),
        ("top = sphere(10), lower = 0, order = 4", &["`top` is not an option; the two"]),
        ("upper = sphere(10), bottom = 0, order = 4", &["write `lower =`"]),
        ("upper = r^2, tibia = sphere(20) + raduis, order = 4", &["write `lower =`", "`raduis`"]),
        ("a = r^2, b = r^2, c = r^2", &["remove `a =`", "`b` is not", "`c` is not"]),
        ("a = r^2, a = r^2", &["remove `a =`", "given twice"]),
        ("gap = r^2; max_radius = 3", &["write `,` for `;`", "remove `gap =`"]),
        ("phi = r^2 max_radius = 3", &["a comma is missing", "remove `phi =`"]),
        ("gap = sphere(10) order = 4", &["a comma is missing", "remove `gap =`"]),
        ("r^2 - r^4, depth = 3 max_radius = 0.1", &["a comma is missing"]),
        ("femur = sphere(10) order = 4, tibia = sphere(20)", &["a comma is missing", "write `lower =`"]),
        ("upper = 2r^2, lower = 3*R^2", &["write `2 * r`", "write a number or a field of `Ball`"]),
        ("[2] * raduis * r^2", &["only parentheses", "did you mean `radius`?"]),
        ("c[0] * raduis * r^2", &["without an index", "did you mean `radius`?"]),
        ("r.powi(2) * raduis", &["no methods", "did you mean `radius`?"]),
        ("sphere(1, 2) * raduis", &["takes the radius", "did you mean `radius`?"]),
        ("r^1/2 * raduis", &["exponent in parentheses", "did you mean `radius`?"]),
    ] {
        let messages = on_ball(text).err().unwrap();
        assert_eq!(messages.len(), rules.len(), "{text}: {messages:?}");
        for rule in rules {
            assert!(messages.iter().any(|message| message.contains(rule)), "{text}: {messages:?}");
        }
    }
}
