//! Constants in scope that are named like variables of generated code without their prefix, or like fields.

#![allow(dead_code, non_upper_case_globals, non_snake_case, reason = "what is here is in the way on purpose")]

use super::{assert_ball, radius};

macro_rules! constants {
    ($($name:ident)*) => { $(const $name: f64 = 7.0;)* };
}

constants! {
    r a s x c0 c1 c2 j0 j1 value values value0 first0 half_second0 base half square power scale depth slope log_slope
    limit more lost places profile radii load_integral load_integrals inverse_R inverse_k of_quarter2 coefficients
    precise_coefficients steepness quick_steepness last_steepness field_R field_k TABLE CURVES CURVES_OF_SINGLE SPANS
    FAULTS FUSED R k
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
    assert_ball::<f64>(&Ball { R: 20.0, k: 1.0 });
    assert_ball::<f64>(&Declared { R: 20.0, k: 1.0 });
    // The sphere of radius 20 up to the sixth order.
    let sphere = cartcontact::Polynomial::new([(1.0 / 40.0, 2.0), (1.0 / 64e3, 4.0), (1.0 / 51.2e6, 6.0)]);
    let expected = sphere.map_or(f64::NAN, |sphere| radius::<f64>(&sphere));
    assert!((radius::<f64>(&Worn { R: 20.0, k: 0.0 }) / expected - 1.0).abs() < 1e-12);
}
