//! Messages about attributes that are not written as such: what is likely to be meant is named.

use super::{on_ball, on_unit};

#[test]
fn likely_slips_are_understood() {
    for (text, rule) in [
        ("r^2 max_radius = 6", "a comma is missing before `max_radius`"),
        ("0,025*r^2", "write `0.025`"),
        ("r^2,5", "write `2.5`"),
        ("r^2,5 + r^4", "write `2.5`"),
        ("gap = r^2", "remove `gap =`"),
        ("0.025mm*r^2", "numbers have no units"),
        ("pi*r^2", "`3.141592653589793`"),
        ("Sphere(10), order = 4", "did you mean `sphere`?"),
        ("r^2, max_radius: 6", "write it as in `max_radius = 6.0`"),
        ("r^2 max_radius: 6", "a comma is missing before `max_radius`"),
        ("r^2 max_radius 6", "a comma is missing before `max_radius`; write `, max_radius = 6`"),
        ("sphere(10), max_radius = 6 order 4", "write `, order = 4`"),
        ("r^2, max_radius 6", "write it as in `max_radius = 6.0`"),
        ("r^2, max_radius < 6", "write it as in `max_radius = 6.0`"),
        ("max_radius < 6, r^2", "write it as in `max_radius = 6.0`"),
        ("sphere(10), order = auto, tolerance < 1e-6, max_radius = 3", "write it as in `tolerance = 1e-6`"),
        ("r^2, max-radius = 6", "write it as in `max_radius = 6.0`"),
        ("sphere(radius), order(4)", "write it as in `order = 4`"),
        ("r^2, maxradius = 6", "did you mean `max_radius`?"),
        ("r^2 - r^4, maxradius = 0.1", "did you mean `max_radius`?"),
        ("sphere(10), oder = 4", "did you mean `order`?"),
        ("r^2, max_radius", "write it as in `max_radius = 6.0`"),
        ("r^2, max_radius = 6,5", "write `6.5`"),
        ("2*r^2 + 0,5*r^4", "write `0.5`"),
        ("r^2; max_radius = 6", "write `,` for `;`"),
        ("max_radius = 6; r^2", "write `,` for `;`"),
        ("k·r^2 + r^4", "a product is written with `*`; write `k * r`"),
        ("r^2 + 2*radiusr", "write `radius * r`"),
        ("r^4/radius·r", "write `radius * r`, and parentheses around the product behind `/`"),
        ("sphere(radiusradius), order = 4", "write `radius * radius`"),
        ("radius * r^2, radius > 0", "write `positive = radius`"),
        ("radius * r^2, positive > 0", "write `positive`"),
        ("r^2, max_radius = sphere(2)", "max_radius must not be a surface"),
        ("r^2, max_radius = inf", "leave out a range without an end"),
        ("r^2, max_radius = f64::INFINITY", "leave out a range without an end"),
        ("upper = sphere(10), lower = sphere(inf), order = 4", "write a flat body as `lower = 0`"),
        ("upper = sphere(10), lower = flat, order = 4", "a flat body is `0`, as in `lower = 0`"),
        ("upper = sphere(10), lower = sphere(f64::INFINITY), order = 4", "a flat body as `lower = 0`"),
        ("std::f64::consts::PI * r^2", "`3.141592653589793`"),
        ("knee::CURVATURE * r^2", "write the number"),
        ("r^2, 5 * r^4", "one gap"),
        ("phi = r^2", "remove `phi =`"),
        ("sphere = 20, order = 4", "write it as in `sphere(20)`"),
        ("sphere: radius, order = 4", "write it as in `sphere(20)`"),
        ("order = 4, conic = (20, -0.5)", "write it as in `conic(20, -0.5)`"),
        ("gap(r) = r^2", "remove `gap(r) =`"),
        ("0.025 mm * r^2", "such as mm; remove `mm`; if it is a field"),
        ("0.025 cm^-1 * r^2", "convert the number to that of the others, and remove `cm^-1`"),
        ("sphere(1cm), order = 4", "convert the number to that of the others, and write it alone"),
        ("r^2 / cm", "convert the number to that of the others, and remove it and the operator before it"),
        ("0.025 * r^2 in mm", "remove `in mm`"),
        ("0.025 * r^2 mm", "numbers have no units"),
        ("0.025/mm * r^2", "remove it and the operator before it"),
        ("0.025 * pow(r, 2)", "write `r^2`"),
        ("powf(2 * r, -1.5)", "write `(2 * r)^(- 1.5)`"),
        (".5 * r^2", "write `0.5`"),
        (".5r^2", "write `0.5 * r`"),
        ("1.e-3 * r^2", "digits behind it"),
        ("radius as f64 * r^2", "remove `as`"),
        ("r^2 if r > 3 else 0", "one expression for all radii"),
        ("\"r^2\"", "without quotes"),
        ("sphere(10) - sphere(10), order = 4", "its terms cancel"),
        ("r^1000000000000000000000", "at most 1024"),
        ("radius * r^2, positive(radius)", "write it as in `positive = (c, d)`"),
        ("radius * r^2, positive = radius, depth", "write `positive = (radius, depth)`"),
        ("radius * r^2, positive = (radius), depth", "write `positive = (radius, depth)`"),
        ("0.025 mm^-1 * r^2", "remove `mm^-1`"),
        ("0.025 mm**-1 * r^2", "remove `mm**-1`"),
        ("0.025 mm^(-1) * r^2", "numbers have no units"),
        ("10**-4 * r^2", "not `**`"),
        ("r^1**2", "not `**`"),
        ("0.025 1/mm * r^2", "remove `1/mm`"),
        ("0.025 (1/mm) * r^2", "numbers have no units"),
        ("r^2, max_radius = 6 [mm]", "remove `[mm]`"),
        ("1.09375x10^-4 * r^4", "write `1.09375 * 10`"),
        ("1.09375X10^-4 * r^4", "write `1.09375 * 10`"),
        ("1.09375 x10^-4 * r^4", "write `1.09375 * 10`"),
        ("r^4/2x10^4", "write `(2 * 10^4)` if"),
        ("1.09375d-4 * r^4", "write `1.09375e-4`, or `1.09375 * d - 4` if `d` is a field"),
        ("1.09375D+04 * r^4", "write `1.09375e+04`, or"),
        ("2d*r^2", "write `2 * d`"),
        ("1.5 e-3 * r^2", "write `1.5e-3`, or `1.5 * e - 3` if `e` is a field"),
        ("sphere(10), order = 4, max_radius = 3, tolerance = 0.1%", "without `%`; write `0.001`"),
        ("r^2 + 3 % 2", "`%` has no meaning"),
        ("r << 2", "`<` has no meaning"),
        ("0.025 x r^2", "a product is written with `*`, not `x`"),
        ("r as f64 ^ 2", "remove `as`"),
        ("f64::powi(r, 2)", "write `r^2`"),
        ("Pow(2 * r, 2)", "write `(2 * r)^2`"),
        ("pow(r)", "as in `r^2`"),
        ("pow(2 r, 2)", "as in `r^2`"),
        ("radius * r^n", "`n` is unknown; write a number"),
        ("r^RADIUS", "`RADIUS` is unknown; write a number"),
        ("sphere(10), order = 4, tolerance = eps, max_radius = 3", "`eps` is unknown; write a number"),
        ("crate::K * r^2", "constants of a program"),
        ("r^2 * super::K", "constants of a program"),
        ("1 000 * r^2", "write `1000`"),
        ("1 000 000.5 * r^2", "write `1000000.5`"),
        ("r^2/1 000", "write `1000`"),
        ("0.5 250 * r^2", "an operator is missing"),
        ("r^2 3", "an operator is missing"),
        ("sphere 1 000, order = 4", "as in `sphere(20)`"),
        ("1.5 2.5 * r^2", "an operator is missing"),
        ("r^2, max_radius = 6 000", "write `6000`"),
        ("0.025 * square(r)", "write `r^2`"),
        ("f64::sin(r)", "functions such as `sin`"),
        ("20 - sqrt(400 - r^2)", "write `sphere(R)`"),
        ("0.025 * x^2", "is called `r`"),
        ("0.025 * ρ^2", "is called `r`"),
        ("paraboloid(20)", "write `conic(R, -1)`"),
        ("upper = Ellipsoid(10, 3), lower = 0, order = 4", "`k` above -1"),
        ("upper = sphere(10), lower = plane(), order = 4", "a flat body is `0`"),
        ("cylinder(10)", "axisymmetric"),
        ("r^2, r <= 3", "write `max_radius = 3`"),
        ("r^2, 0 < r < 3", "write `max_radius = 3`"),
        ("0 <= r <= 2 * radius, r^2", "write `max_radius = 2 * radius`"),
        ("r^2, 3 >= r", "write `max_radius = 3`"),
        ("r^2, 3 > r > 0", "write `max_radius = 3`"),
        ("r^2, r in 0..3", "a range is an option; write `max_radius = 3`"),
        ("r^2, r in [0, 3]", "a range is an option; write `max_radius = 3`"),
        ("r^2, r > 0", "positive anyway; remove this"),
        ("radius * r^2, 0 < radius", "write `positive = radius`"),
        ("r^2, max_radius = 0..3", "the end of the range, which begins at r = 0; write `max_radius = 3`"),
        ("r^2, max_radius = 0.0..=2 * radius", "write `max_radius = 2 * radius`"),
        ("r^2, max_radius = (0, 3)", "write `max_radius = 3`"),
        ("r^2, max_radius = [0, 3]", "write `max_radius = 3`"),
        ("r^2, max_radius = 0..r", "which begins at r = 0; write it as in `max_radius = 6.0`"),
        ("r^2, r < 3 radius", "a range is an option; write it as in `max_radius = 6.0`"),
        ("(r^3 + r^5)/ > r", "`>` has no meaning"),
        ("r^2, max_radius = 0..", "leave it out if the gap has no end"),
        ("r^2, r < 2 * radius", "write `max_radius = 2 * radius`"),
        ("r (1 + r)", "an operator is missing"),
        ("Ball.radius * r^2", "write `radius`"),
        ("gap: r^2", "remove `gap:`"),
        ("gap(r): r^2", "remove `gap(r):`"),
        ("gap(r) -> r^2", "remove `gap(r) ->`"),
        ("gap := r^2", "remove `gap :=`"),
        ("|r| 0.025 * r^2", "remove `|r|`"),
        ("0.025 * |r|^3", "`|` has no meaning"),
        ("r => r^2", "remove `r =>`"),
        ("r -> r^2", "remove `r ->`"),
        ("r#\"r^2\"#", "without quotes"),
        ("c[0]*r^2", "a field of its own, as in `c0`"),
        ("0.025*r^2 + c[i]^2*r^4", "a field of its own, as in `c1`"),
        ("radius [mm] * r^2", "numbers have no units"),
        ("r [r] * r^2", "only parentheses group terms"),
        ("CURVATURE * r^2", "are not known here: write the number, or a field of `Ball`"),
        ("phi = sphere(10), order = 4", "remove `phi =`"),
        ("let c = 2; c * r^2", "without `let`"),
        ("radius * r^2 positive", "a comma is missing before `positive`"),
        ("radius * r^2, Positive", "did you mean `positive`?"),
        ("sphere(10), max_radius = 6 order = 4", "a comma is missing before `order`"),
        ("radius * r^2, max_radius = 6 positive", "a comma is missing before `positive`"),
        ("upper = sphere(10) lower = 0, order = 4", "a comma is missing before `lower`"),
        ("1,000*r^2", "write `1000` or `1.000`"),
        ("r^2, max_radius = 12,500", "write `12500` or `12.500`"),
        ("1.000,5*r^2", "write `1000.5`"),
        ("r^2, max_radius = 1.000,5", "write `1000.5`"),
        ("r^2*1.5, 2*r^2", "one gap"),
        ("sphere(20,000), order = 4", "write `sphere(20000)` or `sphere(20.000)`"),
        ("conic(20,000; -0.5), order = 4", "write `conic(20000, -0.5)` or `conic(20.000, -0.5)`"),
        ("sphere(10), order = 4, tolerance = 0,001, max_radius = 3", "write `0.001`"),
        ("upper = sphere(10), lower = 0, order = 4, 0.025 * r^2", "remove `upper`"),
        ("upper = sphere(radius), lower = 0, order = 4, positive = radius, k", "`positive = (radius, k)`"),
        ("upper = sphere(radius), lower = 0, order = 4, positve", "did you mean `positive`?"),
        ("Positive, upper = sphere(radius), lower = 0, order = 4", "did you mean `positive`?"),
        ("upper = sphere(10), lower = 0, order = 4, auto", "a profile has one gap"),
        ("lower = 0,05 * r^2, upper = 0", "write `0.05`"),
        ("upper: sphere(10), lower = 0, order = 4", "as in `upper = sphere(20)`"),
        ("Upper = sphere(10), lower = 0, order = 4", "did you mean `upper`?"),
        ("lower = 0, upper, order = 4", "as in `upper = sphere(20)`"),
        ("upper = r^2, upper = r^2", "given twice"),
        ("sphere(R), order = 4", "write a number or a field of `Ball`"),
        ("0.025 * R^2", "did you mean `r`?"),
        ("r^2/(2*R)", "write a number or a field of `Ball`"),
        ("r^2, max_radius = R", "write a number or a field of `Ball`"),
    ] {
        let messages = on_ball(text).err().unwrap();
        assert!(messages.len() == 1 && messages[0].contains(rule), "{text}: {messages:?}");
    }
}

#[test]
fn only_the_digits_of_a_number_are_offered_as_a_conic_constant() {
    for (arguments, meant) in [
        ("10, 0", "`sphere(10.0)` or `conic(10, 0)`"),
        ("0,5", "`sphere(0.5)`"),
        ("10,05", "`sphere(10.05)`"),
        ("20,000", "`sphere(20000)` or `sphere(20.000)`"),
    ] {
        let messages = on_unit(&format!("sphere({arguments}), order = 4")).err().unwrap();
        assert_eq!(messages, [format!("`sphere` takes the radius of the sphere; write {meant}")]);
    }
}

/// A diameter, a curvature or an eccentricity is not a number to copy.
#[test]
fn arguments_of_other_names_are_not_taken_for_those_of_a_surface() {
    for arguments in
        ["diameter = 20", "D == 20", "curvature = 0.05", "k = 0.05", "R = 20, e = 0.5", "d = 1, 5"]
    {
        let messages = on_unit(&format!("sphere({arguments}), order = 4")).err().unwrap();
        let message = "`sphere` takes the radius of the sphere; write it as in `sphere(20)`";
        assert_eq!(messages, [message], "{arguments}");
    }
    for arguments in [
        "e = 0.5, R = 10",
        "R = 10, e = 0.5",
        "10, p = 0.8",
        "k = -0.5",
        "k = -0.5, 10",
        "D = 10",
        "R = 1, R = 2",
    ] {
        let messages = on_unit(&format!("conic({arguments}), order = 4")).err().unwrap();
        let message =
            "`conic` takes the radius at the vertex and the conic constant; write it as in `conic(20, -0.5)`";
        assert_eq!(messages, [message], "{arguments}");
    }
}

#[test]
fn a_double_star_is_read_as_a_power() {
    let messages = on_unit("r**2 - r**4, max_radius = 0.5").err().unwrap();
    assert!(messages.len() == 2 && messages.iter().all(|message| message.contains("not `**`")));
}
