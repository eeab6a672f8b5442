//! Sums of Chebyshev polynomials Σ cₖ Tₖ(ξ) of one degree: interpolation, derivatives and means.
//!
//! Source: J. C. Mason, D. C. Handscomb, Chebyshev Polynomials (2003), chapters 2.4, 6.3.

use crate::Scalar;
use crate::scalar::Tabled;

/// The degree N.
pub(super) const DEGREE: usize = 16;

/// cos(π j/16), rounded from 40 digits.
const COSINES: [Tabled; DEGREE / 2 + 1] = [
    Tabled::of(1.0),
    Tabled::of(0.980_785_280_403_230_4),
    Tabled::of(0.923_879_532_511_286_7),
    Tabled::of(0.831_469_612_302_545_2),
    Tabled::of(core::f64::consts::FRAC_1_SQRT_2),
    Tabled::of(0.555_570_233_019_602_2),
    Tabled::of(0.382_683_432_365_089_8),
    Tabled::of(0.195_090_322_016_128_28),
    Tabled::of(0.0),
];

/// The coefficients of Chebyshev polynomials.
pub(super) type Coefficients<T> = [T; DEGREE + 1];

/// cos(π k/16).
pub(super) fn cosine<T: Scalar>(k: usize) -> T {
    let turn = k % (2 * DEGREE);
    let half = turn.min(2 * DEGREE - turn);
    if half <= DEGREE / 2 { COSINES[half].get() } else { -COSINES[DEGREE - half].get::<T>() }
}

/// The coefficients of the polynomial through values at cos(π j/N).
pub(super) fn interpolate<T: Scalar>(values: Coefficients<T>) -> Coefficients<T> {
    // The first and the last count half in either sum.
    let weight = |index: usize| T::constant(if index.is_multiple_of(DEGREE) { 0.5 } else { 1.0 });
    core::array::from_fn(|k| {
        let terms = values.iter().enumerate().map(|(j, &value)| value * weight(j) * cosine(j * k));
        terms.fold(T::zero(), |sum, term| sum + term) * weight(k) * T::constant(2.0 / DEGREE as f64)
    })
}

/// The sum at ξ.
pub(super) fn sum_at<T: Scalar>(sum: &[T], x: T) -> T {
    let (mut before, mut value) = (T::one(), x);
    let mut total = T::zero();
    for &c in sum {
        total += c * before;
        (before, value) = (value, (x + x) * value - before);
    }
    total
}

/// The derivative of a sum: d₍ₖ₋₁₎ = d₍ₖ₊₁₎ + 2 k cₖ, with the first one halved.
pub(super) fn derivative<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let mut slope = [T::zero(); DEGREE + 1];
    for k in (1..sum.len()).rev() {
        let above = if k < DEGREE { slope[k + 1] } else { T::zero() };
        slope[k - 1] = above + sum[k] * T::constant(2.0) * T::constant(k as f64);
    }
    slope[0] *= T::constant(0.5);
    slope
}

/// The mean of a sum from ξ to 1.
///
/// With the coefficients aₖ of the integral, let βₖ = 2 β₍ₖ₊₁₎ − β₍ₖ₊₂₎ + aₖ. Then the integral over ξ − 1 is
/// β₁ + 2 Σ β₍ₖ₊₁₎ Tₖ.
pub(super) fn mean_to_the_end<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let at = |k: usize| sum.get(k).copied().unwrap_or(T::zero());
    let two = T::constant(2.0);
    let mut mean = [T::zero(); DEGREE + 1];
    let (mut above, mut next) = (T::zero(), T::zero());
    for k in (1..=sum.len()).rev() {
        let first = if k == 1 { two * at(0) } else { at(k - 1) };
        let of_integral = (first - at(k + 1)) * T::constant(0.5) / T::constant(k as f64);
        (above, next) = (next, two * next - above + of_integral);
        mean[k - 1] = if k == 1 { next } else { two * next };
    }
    mean
}
