//! Derivatives by differences of values on one side, which the tests compare those of dual numbers with, and how exact
//! these are.

use tests::budget;
use tests::measure::relative_error;

/// In ε: a derivative has no entry in the table, and is allowed as much as two pressures; the worst is 2.8 ε off.
pub const SLOPE: f64 = 2.0 * budget::PRESSURE.double;

/// Asserts that a number is off by no more than `allowed` ε.
///
/// # Panics
///
/// If it is.
pub fn assert_close(found: f64, expected: f64, allowed: f64) {
    let error = relative_error(found, expected, f64::EPSILON);
    assert!(error <= allowed, "{found} instead of {expected}, {error:.2} of {allowed} ε");
}

/// The first derivative where the first of five values was taken, to fourth order in the `step` between them.
#[must_use]
pub fn slope(values: [f64; 5], step: f64) -> f64 {
    weighted(values, [-25.0, 48.0, -36.0, 16.0, -3.0]) / (12.0 * step)
}

/// The second derivative where the first of six values was taken, to fourth order in the `step` between them.
#[must_use]
pub fn curvature(values: [f64; 6], step: f64) -> f64 {
    weighted(values, [45.0, -154.0, 214.0, -156.0, 61.0, -10.0]) / (12.0 * step * step)
}

fn weighted<const N: usize>(values: [f64; N], weights: [f64; N]) -> f64 {
    values.iter().zip(weights).map(|(value, weight)| value * weight).sum()
}
