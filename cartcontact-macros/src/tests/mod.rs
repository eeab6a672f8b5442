//! The whole way from tokens to proofs and code.

#![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]

mod admissibility;
mod curves;
mod documentation;
mod effort;
mod faults;
mod golden;
mod half_typed;
mod own_units;
mod random;
mod single_terms;
mod slips;
mod starts;
mod surface_faults;
mod surfaces;

use proc_macro2::TokenStream;
use quote::quote;

use crate::diagnostics::Diagnostics;
use crate::geometry::{Geometry, geometry};
use crate::number::Rational;
use crate::proof::Proof;
use crate::reading::{attribute, item, literal};

/// The number that a literal stands for.
pub(crate) fn exact(text: &str) -> Rational {
    literal::number(text).unwrap()
}

pub(crate) fn run(attribute: TokenStream, item: TokenStream) -> Result<Geometry, Vec<String>> {
    let mut diagnostics = Diagnostics::default();
    let attribute = attribute::parse(attribute, &mut diagnostics);
    let item = item::parse(item, &mut diagnostics);
    let geometry = item.and_then(|mut item| geometry(&attribute, &mut item, &mut diagnostics));
    if diagnostics.is_empty() { Ok(geometry.unwrap()) } else { Err(diagnostics.messages()) }
}

/// Asserts that reading an attribute reports one fault, whose message contains the `rule`.
fn assert_only_fault<T>(text: &str, read: Result<T, Vec<String>>, rule: &str) {
    let messages = read.err().unwrap();
    assert!(messages.len() == 1 && messages[0].contains(rule), "{text}: {messages:?}");
}

fn on_unit(text: &str) -> Result<Geometry, Vec<String>> {
    run(
        text.parse().unwrap(),
        quote!(
            struct Knee;
        ),
    )
}

fn on_ball(text: &str) -> Result<Geometry, Vec<String>> {
    run(
        text.parse().unwrap(),
        quote!(
            struct Ball {
                radius: f64,
                name: String,
            }
        ),
    )
}

/// `C r^n + ...` as it was understood.
fn shown(geometry: &Geometry) -> String {
    let terms = geometry.gap.terms.iter();
    terms.map(|term| format!("{} r^{}", term.coefficient, term.exponent)).collect::<Vec<_>>().join(" + ")
}

#[test]
fn the_language_means_what_it_says() {
    for (text, meaning) in [
        ("0.025 * r^2 + 1.09375e-4 * r^4", "0.025 r^2 + 1.09375e-4 r^4"),
        ("2*r^2^3 - -r", "1 r^1 + 2 r^8"),
        ("--r^2", "1 r^2"),
        ("(r^3 + r^5)/r", "1 r^2 + 1 r^4"),
        ("(r + r^2)^3", "1 r^3 + 3 r^4 + 3 r^5 + 1 r^6"),
        ("r^(5/2)/2 + r^2.5", "1.5 r^5/2"),
        ("r^-2 * r^4", "1 r^2"),
        ("r^4/r^2/2*3", "1.5 r^2"),
        ("r^2.3333333333", "1 r^23333333333/10000000000"),
        ("max_radius = 6, 2 * r^2", "2 r^2"),
        ("+r^2 + r^4 - r^2 * r^2", "1 r^2"),
        ("r*(1 + r) - r", "1 r^2"),
        ("(4*r^2)^0.5", "2 r^1"),
        ("(1 + r)^0 * r^2", "1 r^2"),
        ("(r + r^2)^0 * r^2 + r^(1 - 1) * r^4", "1 r^2 + 1 r^4"),
        ("sphere(10)^0 * r^2", "1 r^2"),
    ] {
        assert_eq!(on_unit(text).as_ref().map(shown), Ok(meaning.to_owned()), "{text}");
    }
}

#[test]
fn fields_are_symbols() {
    let ball = on_ball("r^2 / (2 * radius) + r^4 / (8 * radius^3), max_radius = radius / 2").unwrap();
    assert_eq!(shown(&ball), "1/(2·radius) r^2 + 1/(8·radius^3) r^4");
    assert_eq!(ball.proof, Proof::AtRunTime);
    for (text, rule) in [
        ("r^2 + radius", "remove `+ radius`"),
        ("r^2 - radius", "remove `- radius`"),
        ("(r - radius)^3", "write `+ radius^3` behind"),
        ("(r + radius)^2", "write `- radius^2` behind"),
        ("(r + 1)^2/(2*radius)", "write `- 1/(2 * radius)` behind"),
        ("(r + radius*(1 + radius))^2", "write `- radius^2 * (1 + radius)^2` behind"),
        ("2*(r^2 + radius - 1)", "behind"),
    ] {
        assert_only_fault(text, on_ball(text), rule);
    }
    assert!(
        on_ball("r^2/(radius - radius)").err().unwrap().iter().any(|message| message.contains("divisor"))
    );
}

/// 0.9338592 and 0.1 are larger in single precision, 0.7 is not; for `r^2` every range is proved.
#[test]
fn ends_of_proofs_are_rounded_down_where_a_format_may_round_them_up() {
    let item = quote!(
        struct Knee;
    );
    for (text, expected) in [
        ("0.001*r^2 - 86e-5*r^4, max_radius = 0.9338592", true),
        ("0.001*r^2 - 86e-5*r^4, max_radius = 0.7", false),
        ("sphere(0.101), order = 4, max_radius = 0.1", true),
        ("r^2, max_radius = 0.1", false),
    ] {
        let expansion = crate::expand(text.parse().unwrap(), item.clone()).to_string();
        assert_eq!(expansion.contains("not_above"), expected, "{text}");
    }
}

#[test]
fn raw_names_are_names() {
    let item = quote!(
        struct Ball {
            r#radius: f64,
            r#type: f64,
        }
    );
    let ball = run("radius * r^2 + r#type * r^4, positive = (radius, type)".parse().unwrap(), item);
    assert!(matches!(ball.map(|geometry| geometry.proof), Ok(Proof::AllRadii { .. })));
}

#[test]
fn signs_that_no_field_can_change_are_known() {
    let proof = |text| on_ball(text).map(|geometry| geometry.proof);
    for text in
        ["radius^2 * r^2 + r^4", "(1 + radius^2)^-3 * r^2", "r^2 + radius^0.5 * r^4, max_radius = radius"]
    {
        assert!(matches!(proof(text), Ok(Proof::AllRadii { .. })), "{text}");
    }
    for text in ["radius * r^2", "r^2 - radius^2 * r^4", "(radius^2 - 1) * r^2"] {
        assert_eq!(proof(text), Ok(Proof::AtRunTime), "{text}");
    }
    for text in ["radius * r^4 - r^2", "r^4 - r^2 / radius^2"] {
        let messages = proof(text).err().unwrap();
        assert!(messages.iter().all(|message| message.contains("falls from the centre")), "{text}");
    }
}

#[test]
fn signs_of_positive_fields_are_known() {
    let proof = |text| on_ball(text).map(|geometry| geometry.proof);
    for text in [
        "radius * r^2, positive",
        "r^2/(2*radius) + r^4/(8*radius^3), positive = radius, max_radius = radius/2",
        "sphere(radius) + conic(1 + radius, radius), order = 8, positive",
        "r^2 + (radius + 1)^-3 * r^4, positive",
    ] {
        assert!(matches!(proof(text), Ok(Proof::AllRadii { .. })), "{text}");
    }
    for text in [
        "sphere(radius) - sphere(20), order = 4, positive",
        "(radius - 1) * r^2, positive",
        "r^2 - radius * r^4, positive",
    ] {
        assert_eq!(proof(text), Ok(Proof::AtRunTime), "{text}");
    }
    for (text, rule) in [
        ("r^4 - radius * r^2, positive", "falls from the centre"),
        ("-sphere(radius), order = 4, positive", "falls from the centre"),
        ("radius * r^2, positive, max_radius = -2 * radius", "max_radius must be greater than 0"),
        ("r^2, positive = radius", "does not depend on `radius`"),
        ("r^2, positive", "depends on no field"),
    ] {
        assert_only_fault(text, proof(text), rule);
    }
}

#[test]
fn nesting_is_limited() {
    for (open, close) in [("(", ")"), ("-", ""), ("2^", "")] {
        let text = open.repeat(5000) + "r" + &close.repeat(5000);
        // The tokens themselves are nested as deeply, and reading them takes this much stack.
        let read =
            std::thread::Builder::new().stack_size(1 << 28).spawn(move || on_unit(&text).err().unwrap());
        let messages = read.unwrap().join().unwrap();
        assert!(messages.len() == 1 && messages[0].contains("nested too deeply"), "{messages:?}");
    }
    let long = vec!["r^2*1"; 20_000].join("+");
    assert_eq!(shown(&on_unit(&long).unwrap()), "20000 r^2");
}

#[test]
fn invisible_parentheses_group() {
    let sum: TokenStream = "1 + r".parse().unwrap();
    let group = proc_macro2::Group::new(proc_macro2::Delimiter::None, sum);
    let geometry = run(
        quote!(r * #group),
        quote!(
            struct Knee;
        ),
    )
    .unwrap();
    assert_eq!(shown(&geometry), "1 r^1 + 1 r^2");
}
