//! What is left of a memory: e^(−x).

use crate::Scalar;
use crate::evaluate::bits::{nearest_integer, power_of_two};
use crate::scalar::{is, is_plain};

/// The most e-foldings for which [`decay_gain`] is meant.
pub(crate) const FEW_FOLDS: f64 = 1.0 / 8.0;

/// e^(−x) − 1 for 0 ≤ x ≤ 1/8 by its Taylor series; the first term left out is below 3e-17 x.
#[inline(always)]
pub(crate) fn decay_gain<T: Scalar>(x: T) -> T {
    let mut sum = T::one();
    for k in [10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0] {
        sum = T::one() - x * T::constant(1.0 / k) * sum;
    }
    -x * sum
}

/// e^(−x) for x ≥ 0, or next to it, within ε; less than the smallest normal number counts as nothing.
///
/// For loops over many values: it has no branch and no table, and takes less than the exponential of a library that
/// cannot be compiled into them.
///
/// e^(−x) = 2^(−n) e^g with the whole n next to x/ln 2 and g = n ln 2 − x, |g| ≤ ln 2/2. The high part of ln 2 has so
/// few digits that its multiples are exact and cancel x without rounding. Of e^g the Taylor series leaves out less
/// than 7e-18 after g¹³, and less than 2e-11 after g⁹ for single precision.
#[inline(always)]
pub(super) fn decay<T: Scalar>(x: T) -> T {
    if !is_plain::<T>() {
        return (-x).exp();
    }
    let is_single = is::<T, f32>();
    let (longest, high, low) = if is_single { SINGLE } else { DOUBLE };
    let (n, octaves) = nearest_integer(x * T::constant(core::f64::consts::LOG2_E));
    let g = (n * T::constant(high) - x) + n * T::constant(low);
    let square = g * g;
    let four_terms = |k: usize| {
        let [c0, c1, c2, c3] = TAYLOR[k].map(T::constant);
        (c0 + c1 * g) + (c2 + c3 * g) * square
    };
    let fourth = square * square;
    let rest = if is_single { four_terms(1) } else { four_terms(1) + fourth * four_terms(2) };
    // The largest terms come last, and only they round.
    let power = T::one() + (g + square * (four_terms(0) + fourth * rest));
    if x > T::constant(longest) { T::zero() } else { power * power_of_two(-octaves) }
}

/// The largest x; ln 2 in two parts.
type Reduction = (f64, f64, f64);
/// The high part has 21 digits less than f64, and multiples up to 1022.
const DOUBLE: Reduction = (708.0, 0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10);
/// The high part has 9 digits less than f32, and multiples up to 126.
const SINGLE: Reduction = (87.0, 0.693_145_751_953_125, 1.428_606_820_309_417_3e-6);

/// 1/k! from k = 2 on.
const TAYLOR: [[f64; 4]; 3] = {
    let mut terms = [[0.5; 4]; 3];
    let mut k = 1;
    while k < 12 {
        terms[k / 4][k % 4] = terms[(k - 1) / 4][(k - 1) % 4] / (k + 2) as f64;
        k += 1;
    }
    terms
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_the_exponential() {
        for k in 0..=1000 {
            let x = FEW_FOLDS * f64::from(k) / 1000.0;
            assert!((decay_gain(x) - (-x).exp_m1()).abs() <= 2.0 * f64::EPSILON * x, "{x}");
        }
    }

    #[test]
    fn what_is_left_is_the_exponential() {
        for k in -10_000..=200_000 {
            let (x, single) = (708.0 / 2e5 * f64::from(k), 87.0 / 2e5 * k as f32);
            let error = (decay(x) - (-x).exp()) / (-x).exp();
            assert!(error.abs() <= f64::EPSILON, "{x}: {error}");
            let exact = (-f64::from(single)).exp();
            let error = (f64::from(decay(single)) - exact) / exact;
            assert!(error.abs() <= 0.75 * f64::from(f32::EPSILON), "{single}: {error}");
        }
    }

    #[test]
    fn nothing_is_left_of_what_is_too_old() {
        assert_eq!((decay(0.0_f64), decay(0.0_f32)), (1.0, 1.0));
        assert_eq!((decay(1e300_f64), decay(1e30_f32)), (0.0, 0.0));
        assert_eq!((decay(f64::INFINITY), decay(f32::INFINITY)), (0.0, 0.0));
        assert!(decay(f64::NAN).is_nan() && decay(f32::NAN).is_nan());
        assert!(decay(708.0_f64).is_normal() && decay(87.0_f32).is_normal());
    }
}
