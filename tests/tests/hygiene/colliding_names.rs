//! Fields named like the variables, functions and parameters of generated code, without the prefix that these have.
//!
//! The structs are written out: names that a macro is given cannot collide with those of code generated within it.

#![deny(warnings)]

use cartcontact::{GapProfile, gap_profile};

use super::assert_ball;

/// A ball of radius 20 whose other fields are 1.
macro_rules! ball {
    ($name:ident: $($field:ident)*) => { $name { radius: 20.0, $($field: 1.0),* } };
}

/// A closed form; the coefficient needs every field.
#[gap_profile(r^2 / (2 * radius * a * s * x * c * c0 * value * slope * depth * limit * load_integral * field_radius))]
struct OneTerm {
    radius: f64,
    a: f64,
    s: f64,
    x: f64,
    c: f64,
    c0: f64,
    value: f64,
    slope: f64,
    depth: f64,
    limit: f64,
    load_integral: f64,
    field_radius: f64,
}

/// A table for two fields that have no sign, and a range.
#[gap_profile(r^2 / (2 * radius) + r^4 * (profile - end) / 1e30, max_radius = radius)]
struct TwoTerms {
    radius: f64,
    profile: f64,
    end: f64,
}

/// Newton's method, roots, shared inverses and a range.
#[gap_profile(
    r^2 / (2 * radius)
        + a * s * x * c0 * c1 * c2 * j0 * j1 * value * values * base * r^2.5 / (1e30 * radius^3)
        + slope^0.5 * log_slope^0.25 * steepness * quick_steepness * last_steepness * power * scale * r^3 / 1e30
        + depth * units * places * coefficients * precise_coefficients * load_integral * load_integrals * r^4
            / (1e30 * inverse_radius^2)
        + radii * profile * error * lost * more * of_quarter2 * field_radius * first0 * value0 * r^6 / 1e30,
    max_radius = limit * end * radius
)]
struct Many {
    radius: f64,
    a: f64,
    s: f64,
    x: f64,
    c0: f64,
    c1: f64,
    c2: f64,
    j0: f64,
    j1: f64,
    value: f64,
    values: f64,
    base: f64,
    slope: f64,
    log_slope: f64,
    steepness: f64,
    quick_steepness: f64,
    last_steepness: f64,
    power: f64,
    scale: f64,
    depth: f64,
    units: f64,
    places: f64,
    coefficients: f64,
    precise_coefficients: f64,
    load_integral: f64,
    load_integrals: f64,
    inverse_radius: f64,
    radii: f64,
    profile: f64,
    error: f64,
    lost: f64,
    more: f64,
    of_quarter2: f64,
    field_radius: f64,
    first0: f64,
    value0: f64,
    limit: f64,
    end: f64,
}

/// The signs of all fields are known; some are named like constants, methods, crates and keywords.
#[gap_profile(
    r^2 / (2 * radius)
        + TABLE * FAULTS * FUSED * r^3 / 1e30
        + gap * max_radius * check * r#type * cartcontact * core * r^4 / 1e30,
    positive
)]
#[allow(non_snake_case, reason = "they are in the way on purpose")]
struct Positive {
    radius: f64,
    TABLE: f64,
    FAULTS: f64,
    FUSED: f64,
    gap: f64,
    max_radius: f64,
    check: f64,
    r#type: f64,
    cartcontact: f64,
    core: f64,
}

/// A parameter named like the scalar is a field like any other.
#[gap_profile(r^2 / (2 * T))]
#[allow(non_snake_case, reason = "it is in the way on purpose")]
struct NamedLikeTheScalar {
    T: f64,
}

#[gap_profile(r^2 / 40)]
struct T;

/// The compiler does not say that one field is never read.
#[gap_profile(r^2 / (2 * radius), max_radius = limit)]
struct Limited {
    radius: f64,
    limit: f64,
}

#[test]
fn names_of_fields_are_free() {
    let one = ball!(OneTerm: a s x c c0 value slope depth limit load_integral field_radius);
    let two = TwoTerms { profile: 0.5, ..ball!(TwoTerms: profile end) };
    let many = ball!(
        Many: a s x c0 c1 c2 j0 j1 value values base slope log_slope steepness quick_steepness last_steepness power
            scale depth units places coefficients precise_coefficients load_integral load_integrals inverse_radius
            radii profile error lost more of_quarter2 field_radius first0 value0 limit end
    );
    let positive = ball!(Positive: TABLE FAULTS FUSED gap max_radius check r#type cartcontact core);
    let named_like_the_scalar = NamedLikeTheScalar { T: 20.0 };
    for profile in [&one as &dyn GapProfile<f64>, &two, &many, &positive, &named_like_the_scalar, &T] {
        assert_ball(&profile);
        assert_eq!(profile.check(), Ok(()));
    }
    assert_eq!(GapProfile::<f64>::max_radius(&many), 20.0);
}

#[test]
fn a_field_may_be_used_by_the_range_only() {
    assert_eq!(GapProfile::<f64>::max_radius(&Limited { radius: 20.0, limit: 5.0 }), 5.0);
}
