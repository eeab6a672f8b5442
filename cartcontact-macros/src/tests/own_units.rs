//! Which geometries have one table for all values of their fields.

use quote::quote;

use super::run;
use crate::closed_forms::ClosedForms;
use crate::geometry::Geometry;
use crate::start::Start;
use crate::start::own_units;

/// A geometry with the fields R, k and m.
fn geometry(text: &str) -> Geometry {
    let item = quote!(
        struct Joint {
            R: f64,
            k: f64,
            m: f64,
        }
    );
    run(text.parse().unwrap(), item).unwrap()
}

/// The factors of J in its own units.
fn factors(text: &str) -> Option<Vec<f64>> {
    let geometry = geometry(text);
    own_units::factors(&geometry.gap, &ClosedForms::of(&geometry.gap).load_integral)
}

#[test]
fn fields_that_set_units_only_have_one_table() {
    for (text, expected) in [
        ("k*r^2 + m*r^4 + 0*R", &[1.0, 1.0][..]),
        ("k*r^2 - m*r^4 + 0*R", &[1.0, -1.0]),
        // A gap that begins with a negative term is taken for one with two positive terms.
        ("m*r^4 - k*r^2 + 0*R", &[1.0, 1.0]),
        ("k*(r^2 - (m + R)*r^4)", &[1.0, -1.0]),
        ("k*(r^2 - (m - R)*r^4)", &[1.0, 1.0]),
        ("sphere(R), order = 6", &[1.0, 1.0, 1.8]),
        ("sphere(R), order = 8", &[1.0, 1.0, 1.8, 4.0]),
        ("sphere(2*R + k), order = 6", &[1.0, 1.0, 1.8]),
        ("conic(R, -2), order = 6", &[1.0, -1.0, 1.8]),
        ("k*(r^2 + 4*r^4 + r^6)/m", &[1.0, 1.0, 0.9 / 16.0]),
        // J = a⁶/12 + 3 a⁷/35 + a⁸/12 for R = k = 1.
        ("k*(r^2 + r^3/R + r^4/R^2), positive", &[1.0, 1.0, 1225.0 / 1296.0]),
        ("k*(r^2 - r^3/R + r^4/R^2), positive", &[1.0, -1.0, 1225.0 / 1296.0]),
        ("k*(r^2 + r^2.5/R + r^3/R^2), positive", &[1.0, 1.0, 36.0 / 35.0 * 0.975 * 0.975]),
    ] {
        let found = factors(text).unwrap_or_default();
        let is_near = |(found, expected): (&f64, &f64)| (found / expected - 1.0).abs() < 1e-14;
        assert!(
            found.len() == expected.len() && found.iter().zip(expected).all(is_near),
            "{text}: {found:?}"
        );
    }
}

#[test]
fn others_have_none() {
    for text in [
        "k*r^2 + m*r^4 + r^6/R",
        "sphere(R) + sphere(k), order = 6",
        "conic(R, k), order = 6",
        "0.025*r^2 + k*r^4 + m*r^6",
        // R may be negative, and with it the second term.
        "k*(r^2 + r^3/R + r^4/R^2)",
    ] {
        assert_eq!(factors(text), None, "{text}");
    }
}

/// J of x⁶ − x⁸ has a maximum of 27/256.
#[test]
fn tables_end_where_j_turns_back() {
    let geometry = geometry("k*r^2 - m*r^4 + 0*R");
    let forms = ClosedForms::of(&geometry.gap);
    let Some(Start::Seeds(seeds)) = Start::of(&geometry, &forms) else { unreachable!("there is no table") };
    let [from, to] = seeds.table.range();
    assert!(from < 1e-18 && (0.05..27.0 / 256.0).contains(&to), "{from:e} to {to}");
}
