//! Constants in scope that are named like variables of generated code, or like fields.

#![allow(dead_code, non_upper_case_globals, non_snake_case, reason = "what is here is in the way on purpose")]

use super::{OF_BALL, radius};

macro_rules! constants {
    ($($name:ident)*) => { $(const $name: f64 = 7.0;)* };
}

constants! {
    r c0 c1 t1 t2 s2 s3 a_squared r_squared inset base square profile error end fields radius_ R k
}

/// Needs Newton's method, a range and powers of fields.
#[cartcontact::gap_profile(r^2 / (2 * R) + k^5 * r^4 / (1e30 * R) + r^6 / 1e30, max_radius = R)]
struct Ball {
    R: f64,
    k: f64,
}

/// Needs a search for a root, and the rim of a surface.
#[cartcontact::gap_profile(sphere(R) - k * r^4, order = 6, max_radius = R / 2)]
struct Worn {
    R: f64,
    k: f64,
}

/// All fields are positive.
#[cartcontact::gap_profile(r^2 / (2 * R) + k^0.5 * r^2.5 / 1e30, positive)]
struct Declared {
    R: f64,
    k: f64,
}

#[test]
fn constants_in_scope_are_not_used() {
    let ball = Ball { R: 20.0, k: 1.0 };
    assert!((radius::<f64>(&ball) / OF_BALL - 1.0).abs() < 1e-12);
    assert!((radius::<f64>(&Declared { R: 20.0, k: 1.0 }) / OF_BALL - 1.0).abs() < 1e-12);
    assert!((radius::<f64>(&Worn { R: 20.0, k: 0.0 }) / OF_BALL - 1.0).abs() < 1e-2);
}
