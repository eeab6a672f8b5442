//! The degree of the load integral, by which its errors are divided in a radius.

use crate::{GapProfile, Scalar};

/// a J′/J = a⁵ δ₀′/(2 J), the degree of the load integral at a radius, in an order that keeps the fifth power in range.
pub(crate) fn degree_of_load_integral<T: Scalar>(profile: &impl GapProfile<T>, a: T, load_integral: T) -> T {
    let square = a * a;
    let slope = profile.quick_approach_slope(a);
    (a * slope * T::constant(0.5)) * (square / (load_integral / square))
}
