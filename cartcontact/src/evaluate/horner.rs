//! Polynomials with coefficients in ascending order, densely stored: c\[0\] + c\[1\] x + c\[2\] x² + …

use super::coefficient::{Coefficient, added, number, rounded};
use crate::Scalar;
use crate::numbers::double_word::DoubleWord;

/// Horner's rule at `x`, and at the same time the quotient of the polynomial by (x − `y`) taken at `y`.
///
/// Synthetic division: with b₍N−1₎ = c₍N−1₎ and b₍k₎ = c₍k₎ + x b₍k+1₎ the value is b₀ and the quotient
/// Σ b₍k+1₎ y^k. The quotient is (P(x) − P(y))/(x − y), and P′(x) for y = x.
///
/// The two highest coefficients are taken out of the loop: no compiler may leave out a multiplication by zero.
#[inline(always)]
pub(super) fn value_and_quotient<T: Scalar, const N: usize>(x: T, y: T, coefficients: &[T; N]) -> (T, T) {
    let Some((&last, rest)) = coefficients.split_last() else { return (T::zero(), T::zero()) };
    let Some((&next, rest)) = rest.split_last() else { return (last, T::zero()) };
    rest.iter().rev().fold((last * x + next, last), |(value, quotient), &coefficient| {
        (value * x + coefficient, quotient * y + value)
    })
}

/// r^lowest Σ c\[k\] r^(2k), corrected for the rounding of r².
///
/// Horner's rule in s = r² multiplies the rounding error of s by the degree, which dominates from s⁴ upward. With
/// r² = s + e exactly, s^m P(s) lacks e s^(m−1) (s P′(s) + m P(s)).
///
/// Error for coefficients of one sign: at most (N + m + 2) ε, typically below 2 ε up to N = 12.
#[inline(always)]
pub fn quick_even_sum<T: Scalar, const N: usize>(r: T, lowest: u32, coefficients: [T; N]) -> T {
    let (exact, degree) = (<DoubleWord<T>>::product(r, r), lowest / 2);
    let square = exact.rounded();
    let (value, slope) = value_and_slope(square, coefficients);
    let corrected = if degree == 0 {
        value + slope * exact.low()
    } else {
        value * square + (slope * square + value * T::constant(f64::from(degree))) * exact.low()
    };
    // One by one: a power of the square alone may overflow although the result does not.
    let even = (1..degree).fold(corrected, |sum, _| sum * square);
    let sum = if lowest % 2 == 1 { even * r } else { even };
    // The exact product overflows beyond 2^996, where r² does not; and the degree times a value may, where the sum does not.
    if sum.is_finite() { sum } else { plain_even_sum(r, lowest, coefficients) }
}

/// x^lowest Σ c\[k\] x^k, rounded once: Horner's rule in twice the working precision.
///
/// Error for coefficients of one sign: 1/2 ulp, and that of the coefficients, which may be precise. For others, 2^−100
/// times the sizes of the terms is added.
#[inline(always)]
pub fn precise_sum<T: Scalar, C: Coefficient<T>, const FUSED: bool, const N: usize>(
    x: T,
    lowest: u32,
    coefficients: [C; N],
) -> T {
    let sum = precise_horner(<DoubleWord<T, FUSED>>::of(x), lowest, &coefficients);
    sum.rounded_or(|| plain_sum(x, lowest, rounded(coefficients)))
}

/// r^lowest Σ c\[k\] r^(2k), rounded once, see [`precise_sum`].
#[inline(always)]
pub fn precise_even_sum<T: Scalar, C: Coefficient<T>, const FUSED: bool, const N: usize>(
    r: T,
    lowest: u32,
    coefficients: [C; N],
) -> T {
    let even = precise_horner(<DoubleWord<T, FUSED>>::product(r, r), lowest / 2, &coefficients);
    let sum = if lowest % 2 == 1 { even.times_word(r) } else { even };
    sum.rounded_or(|| plain_even_sum(r, lowest, rounded(coefficients)))
}

/// r^lowest Σ c\[k\] r^(2k) with every operation rounded.
fn plain_even_sum<T: Scalar, const N: usize>(r: T, lowest: u32, coefficients: [T; N]) -> T {
    let even = plain_sum(r * r, lowest / 2, coefficients);
    if lowest % 2 == 1 { even * r } else { even }
}

/// x^lowest Σ c\[k\] x^k with every operation rounded. No power alone is larger than the result.
#[inline(always)]
fn plain_sum<T: Scalar, const N: usize>(x: T, lowest: u32, coefficients: [T; N]) -> T {
    (0..lowest).fold(value_and_slope(x, coefficients).0, |sum, _| sum * x)
}

#[inline(always)]
fn precise_horner<T: Scalar, C: Coefficient<T>, const FUSED: bool, const N: usize>(
    x: DoubleWord<T, FUSED>,
    lowest: u32,
    coefficients: &[C; N],
) -> DoubleWord<T, FUSED> {
    let Some((&last, rest)) = coefficients.split_last() else { return DoubleWord::of(T::zero()) };
    let step = |sum: DoubleWord<T, FUSED>, &coefficient: &C| added(sum.times(x), coefficient);
    let sum = rest.iter().rev().fold(number(last), step);
    // One by one: a power of x alone may overflow although the result does not.
    (0..lowest).fold(sum, |sum, _| sum.times(x))
}

/// The value P(x) and the slope P'(x).
#[inline]
pub fn value_and_slope<T: Scalar, const N: usize>(x: T, coefficients: [T; N]) -> (T, T) {
    value_and_quotient(x, x, &coefficients)
}

/// (P(x) − P(y)) / (x − y) without a difference, hence without cancellation for coefficients of one sign.
#[inline(always)]
pub fn divided_difference<T: Scalar, const N: usize>(x: T, y: T, coefficients: [T; N]) -> T {
    value_and_quotient(x, y, &coefficients).1
}

/// [`divided_difference`] of Σ c\[k\] x^(2k).
#[inline(always)]
pub fn even_divided_difference<T: Scalar, const N: usize>(x: T, y: T, coefficients: [T; N]) -> T {
    (x + y) * divided_difference(x * x, y * y, coefficients)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_integers_are_exact() {
        assert_eq!(quick_even_sum(3.0, 0, [1.0, 2.0, 0.0, 5.0]), 1.0 + 18.0 + 5.0 * 729.0);
        assert_eq!(quick_even_sum(3.0, 5, [1.0, 2.0]), 243.0 + 2.0 * 2187.0);
        assert_eq!(value_and_slope(2.0, [1.0, 0.0, 3.0]), (13.0, 12.0));
        // (x³ − y³)/(x − y) = x² + x y + y².
        assert_eq!(divided_difference(3.0, 2.0, [7.0, 0.0, 0.0, 1.0]), 19.0);
        assert_eq!(divided_difference(2.0, 2.0, [7.0, 0.0, 0.0, 1.0]), 12.0);
        // x⁴ + 2 x² + 7, at 3 and 2.
        assert_eq!(even_divided_difference(3.0, 2.0, [7.0, 2.0, 1.0]), 81.0 - 16.0 + 2.0 * (9.0 - 4.0));
    }

    #[test]
    fn sums_stay_finite_up_to_the_end_of_the_range() {
        assert_eq!(quick_even_sum(1e153, 2, [1e-10]), 1e306 * 1e-10);
        // Here the correction is infinite times nothing.
        assert_eq!(quick_even_sum(0.25, 8, [8e307]), 8e307 / 65_536.0);
        precise_sums_are_exact::<true>();
        precise_sums_are_exact::<false>();
    }

    fn precise_sums_are_exact<const FUSED: bool>() {
        let even_sum = |r, lowest, coefficients| precise_even_sum::<_, _, FUSED, 2>(r, lowest, coefficients);
        let sum = |x, lowest, coefficients| precise_sum::<_, _, FUSED, 2>(x, lowest, coefficients);
        assert_eq!(even_sum(3.0, 3, [1.0, 2.0]), 27.0 + 2.0 * 243.0);
        assert_eq!(sum(3.0, 1, [1.0, 2.0]), 3.0 + 2.0 * 9.0);
        assert_eq!(even_sum(1e153, 2, [1e-10, 0.0]), 1e306 * 1e-10);
        assert_eq!(sum(1e153, 2, [1e-10, 0.0]), 1e306 * 1e-10);
    }
}
