//! By what an allowance is multiplied for a scene: how much larger errors are there that nothing can be done about.

use super::exact::Kernels;
use super::precision::Precision;
use super::scene::Scene;
use crate::budget::{PRESSURE_KERNEL, PRESSURE_KERNEL_OF_REAL_POWERS};

/// The radius is within 2 ulp instead of 1 where terms cancel, because the sums of the last step are the quick ones.
pub(super) const MIXED_SIGNS: f64 = 2.0;

/// Σ|terms of J|/(a J′), if it is above 1: errors of J are divided by its degree and grow where its terms cancel.
pub(super) fn of_radius(here: &Kernels) -> f64 {
    (here.load_integral.size / here.log_slope.value).value().max(1.0)
}

/// 1 + 2a/(a − r), by how much an error of the radius counts at r.
pub(super) fn edge<T: Precision>(a: T, r: T) -> f64 {
    if r < a { 1.0 + 2.0 * a.value() / (a - r).value() } else { 1.0 }
}

/// What more is allowed for the pressure kernel of exponents that are no multiples of 1/4, or are above 16 and no
/// multiples of 1/2.
pub(super) fn real_powers<T: Precision>(scene: &Scene<T>) -> f64 {
    let is_root = |n: f64| (4.0 * n).fract() == 0.0 && (n <= 16.0 || (2.0 * n).fract() == 0.0);
    if scene.exact_terms().iter().all(|&(_, n)| is_root(n)) {
        1.0
    } else {
        T::allowed(PRESSURE_KERNEL_OF_REAL_POWERS) / T::allowed(PRESSURE_KERNEL)
    }
}
