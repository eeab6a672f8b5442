//! Fields of type `f32`, alone and beside `f64`, in solvers of either precision.

use cartcontact::gap_profile;

use super::assert_ball;

/// A measured radius, and one from a data sheet.
#[gap_profile(r^2 / (4 * measured) + r^2 / (4 * nominal))]
struct Mixed {
    measured: f32,
    nominal: core::primitive::f64,
}

/// Any scalar, with a height that is always single.
#[gap_profile(height * r^2 / radius)]
struct Scaled<T> {
    height: f32,
    radius: T,
}

#[test]
fn fields_of_both_precisions_mix() {
    let mixed = Mixed { measured: 20.0, nominal: 20.0 };
    assert_ball::<f64>(&mixed);
    assert_ball::<f32>(&mixed);
    assert_ball(&Scaled { height: 0.5, radius: 20.0_f64 });
    assert_ball(&Scaled { height: 0.5, radius: 20.0_f32 });
}
