//! Types in scope that are named like the primitive ones.

use cartcontact::gap_profile;

use super::assert_ball;

#[allow(dead_code, non_camel_case_types, reason = "it is in the way on purpose")]
struct f32;

#[allow(dead_code, non_camel_case_types, reason = "it is in the way on purpose")]
struct f64;

#[allow(dead_code, non_camel_case_types, reason = "it is in the way on purpose")]
struct usize;

type Single = core::primitive::f32;
type Double = core::primitive::f64;

#[gap_profile(r^2 / 40 + r^4 / 1e30)]
struct Constant;

/// The field is converted to double precision.
#[gap_profile(r^2 / (2 * radius))]
struct OneTerm {
    radius: core::primitive::f32,
}

/// The same where coefficients are computed, with a range.
#[gap_profile(r^2 / (2 * radius) + depth^0.5 * r^2.5 / 1e30 + r^4 / (1e30 * radius), max_radius = radius)]
struct Mixed {
    radius: core::primitive::f32,
    depth: core::primitive::f64,
}

#[test]
fn types_in_scope_are_not_used() {
    let (one, mixed) = (OneTerm { radius: 20.0 }, Mixed { radius: 20.0, depth: 1.0 });
    assert_ball::<Double>(&Constant);
    assert_ball::<Double>(&one);
    assert_ball::<Double>(&mixed);
    assert_ball::<Single>(&Constant);
    assert_ball::<Single>(&one);
    assert_ball::<Single>(&mixed);
}
