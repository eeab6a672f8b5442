//! A trait in scope that gives every value methods named like those that generated code calls.

use cartcontact::gap_profile;

use super::assert_ball;

#[allow(dead_code, reason = "its methods are in the way on purpose")]
trait Extension: Sized {
    fn radius(self) {}
    fn radii(self) {}
    fn solve(self) {}
    fn with_exact_power(self) {}
    fn scaled(self) {}
    fn map(self) {}
    fn sqrt(self) {}
}

impl<T> Extension for T {}

#[gap_profile(r^2 / 40)]
struct OneTerm;

#[gap_profile(r^2 / 40 + r^2.5 / 1e30 + r^4 / 1e30)]
struct Constants;

#[gap_profile(r^2 / (2 * radius))]
struct OneField {
    radius: f64,
}

#[gap_profile(r^2 / (2 * radius) + curvature * r^4)]
struct Fields {
    radius: f64,
    curvature: f64,
}

#[gap_profile(r^2 / (2 * radius) + curvature * r^2.71 - curvature * r^4)]
struct RealPowers {
    radius: f64,
    curvature: f64,
}

#[test]
fn methods_in_scope_are_not_called() {
    let (ball, curvature) = (20.0, 1e-30);
    assert_ball::<f64>(&OneTerm);
    assert_ball::<f64>(&Constants);
    assert_ball::<f64>(&OneField { radius: ball });
    assert_ball::<f64>(&Fields { radius: ball, curvature });
    assert_ball::<f64>(&RealPowers { radius: ball, curvature });
}
