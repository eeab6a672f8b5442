//! How much terms of both signs, or a place near the edge, magnify errors of the input in a result.

use cartcontact::{GapProfile, Scalar};

use crate::budget;
use crate::random::{Sum, sum};

/// 1 + 2a/(a − r), the factor with which an error of the radius a counts in a pressure at r; 1 outside.
#[must_use]
pub fn edge<T: Scalar>(a: T, r: T) -> f64 {
    if r < a { edge_at(a.value(), (a - r).value()) } else { 1.0 }
}

/// [`edge`] at a distance a − r that is known to more digits than the difference of a and r.
#[must_use]
pub fn edge_at(a: f64, distance: f64) -> f64 {
    1.0 + 2.0 * a / distance
}

/// a J′/J, the degree of the load integral at a radius: the factor with which the relative error of a radius counts.
#[must_use]
pub fn degree(profile: &dyn GapProfile<f64>, a: f64) -> f64 {
    let square = a * a;
    square * square * (a * profile.approach_slope(a) / 2.0) / profile.load_integral(a)
}

/// The roundings of an approach and its degree a δ₀′/δ₀, with which the errors of the radius count.
#[must_use]
pub fn of_approach(profile: &dyn GapProfile<f64>, a: f64) -> f64 {
    budget::ROUNDINGS_OF_APPROACH + a * profile.approach_slope(a) / profile.approach(a)
}

/// Σ|terms of J|/(a J′) but at least 1, the factor with which errors of the terms count in a radius; `sizes` is the
/// geometry [`of_sizes`] of the same terms.
#[must_use]
pub fn of_radius(profile: &dyn GapProfile<f64>, sizes: &dyn GapProfile<f64>, a: f64) -> f64 {
    let slope = a.powi(5) * profile.approach_slope(a) / 2.0;
    (sizes.load_integral(a) / slope).max(1.0)
}

/// The geometry Σ |C| r^n of terms (C, n): its values are the sums of the absolute terms.
#[must_use]
pub fn of_sizes(terms: &[(f64, f64)]) -> Sum {
    sum(terms.iter().map(|&(c, n)| (c.abs(), n)).collect())
}
