//! The attribute works wherever a struct may stand, whatever names are in scope.

mod colliding_names;
mod constants;
mod extension_traits;
mod f32_fields;
mod generics;
mod lints;
mod no_prelude;
mod places;
mod primitive_names;
mod shadowed_names;

extern crate cartcontact as renamed;

use tests::budget;
use tests::measure::relative_error;
use tests::stress::precision::Precision;

/// The radius at which the load integral is 1; NaN if that is beyond the range of the geometry.
fn radius<T: cartcontact::Scalar>(profile: &impl cartcontact::GapProfile<T>) -> f64 {
    profile.radius(T::constant(1.0)).map_or(f64::NAN, T::value)
}

/// Asserts that a gap is r²/(2 · 20), beside which terms with 1e-30 count for nothing, and has its radius, the sixth root
/// of 480.
fn assert_ball<T: Precision>(profile: &impl cartcontact::GapProfile<T>) {
    const OF_BALL: f64 = 2.798_166_414_339_527_3;
    let found = radius(profile);
    let error = relative_error(found, OF_BALL, T::EPSILON);
    assert!(error <= T::allowed(budget::RADIUS), "{found}: {error} ε");
}
