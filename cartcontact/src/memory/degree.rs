//! The degree of the load integral, by which its errors are divided in a radius.

use crate::{GapProfile, Scalar};

/// The degree at a radius where terms have both signs, which may make it nearly vanish; otherwise 4, the least that it
/// can be.
pub(super) fn least_degree<T: Scalar>(profile: &impl GapProfile<T>, a: T) -> T {
    if profile.has_only_positive_terms() {
        T::constant(4.0)
    } else {
        degree_of_load_integral(profile, a, profile.quick_load_integral(a))
    }
}

/// How many of its own roundings a radius is off by, at least 1, because the load integral is rounded: many where the
/// degree of the load integral nearly vanishes.
pub(super) fn condition_of_radius<T: Scalar>(profile: &impl GapProfile<T>, a: T) -> T {
    least_degree(profile, a).recip().max(T::one())
}

/// a J′/J = a⁵ δ₀′/(2 J), the degree of the load integral at a radius, in an order that keeps the fifth power in range.
pub(super) fn degree_of_load_integral<T: Scalar>(profile: &impl GapProfile<T>, a: T, load_integral: T) -> T {
    let square = a * a;
    let slope = profile.quick_approach_slope(a);
    (a * slope * T::constant(0.5)) * (square / (load_integral / square))
}
