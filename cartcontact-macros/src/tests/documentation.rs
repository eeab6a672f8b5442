//! Formulas in the documentation of an item, as people read them.

use quote::quote;

use crate::expand;

/// The documentation of a gap that depends on fields.
fn documented(attribute: &str) -> String {
    let item = quote!(
        struct Knee {
            a: f64,
            x: f64,
            K: f64,
        }
    );
    expand(attribute.parse().unwrap(), item).to_string()
}

#[test]
fn variables_are_told_from_fields() {
    let text = documented("a * r^2 + x * r^2.5");
    for formula in [
        "Φ(r)   = a r² + x r^2.5",
        "δ₀(ρ)  = (a/2) ρ² + (4·x/9) ρ^2.5",
        "L(ξ)   = (a/16) ξ⁴ + (4·x/81) ξ^4.5",
        "κ(2, r/ρ) + (2·x/81) ρ^4.5 κ(2.5, r/ρ), κ(n,q)",
        "the ρ with (π m/4) J(ρ)",
    ] {
        assert!(text.contains(formula), "no {formula} in {text}");
    }
}

#[test]
fn signs_and_fractions_are_those_of_the_formula() {
    let text = documented("a * r - x * r^4 + 1/1296 * K^4 * r^18");
    assert!(text.contains("Φ(r)   = a r − x r⁴ + ((1/1296)·K^4) r¹⁸"), "{text}");
}

#[test]
fn documentation_is_in_the_language() {
    for (text, line) in [
        ("r^(7/3) - 1e-7*r^12, max_radius = 1/3", "Φ(r)   = r^(7/3) − 1e-7 r¹²"),
        ("r^2.5 + radius^(1/3) * r^(8/3)", "Φ(r)   = r^2.5 + (radius^(1/3)) r^(8/3)"),
        (
            "sphere(radius), order = 4, max_radius = 6, positive",
            "up to 6 mm, if the series of all surfaces go",
        ),
        ("sphere(radius), order = 4, max_radius = radius/2, positive", "used up to `radius/2` mm."),
    ] {
        let item = quote!(
            struct Ball {
                radius: f64,
            }
        );
        let expansion = expand(text.parse().unwrap(), item).to_string();
        assert!(expansion.contains(line), "{text}: {expansion}");
    }
}
