//! Polynomials with coefficients in ascending order, densely stored: c\[0\] + c\[1\] x + c\[2\] x² + …

use super::double_word::DoubleWord;
use crate::Scalar;

/// Σ c\[k\] r^(2k), corrected for the rounding of r².
///
/// Horner's rule in s = r² multiplies the rounding error of s by the degree, which dominates from s⁴ upward.
/// With r² = s + e exactly, P(s + e) = P(s) + e P'(s) takes it out again.
///
/// Error for coefficients of one sign: at most (N + 2) ε, typically below 2 ε up to N = 12.
#[inline]
pub fn even_sum<T: Scalar, const N: usize>(r: T, coefficients: [T; N]) -> T {
    let square = DoubleWord::product(r, r);
    let s = square.rounded();
    let (mut value, mut slope) = (T::zero(), T::zero());
    for &coefficient in coefficients.iter().rev() {
        slope = slope * s + value;
        value = value * s + coefficient;
    }
    let corrected = value + slope * square.low();
    // Beyond 2^996 the exact product overflows although r² does not.
    if corrected.is_finite() { corrected } else { value }
}

/// The value P(x) and the slope P'(x).
#[inline]
pub fn value_and_slope<T: Scalar, const N: usize>(x: T, coefficients: [T; N]) -> (T, T) {
    let (mut value, mut slope) = (T::zero(), T::zero());
    for &coefficient in coefficients.iter().rev() {
        slope = slope * x + value;
        value = value * x + coefficient;
    }
    (value, slope)
}

/// (P(x) − P(y)) / (x − y) without a difference, hence without cancellation for coefficients of one sign.
///
/// Synthetic division: with b₍N−1₎ = c₍N−1₎ and b₍k₎ = c₍k₎ + y b₍k+1₎ the quotient is Σ b₍k+1₎ x^k; both
/// recurrences run in one loop.
#[inline]
pub fn divided_difference<T: Scalar, const N: usize>(x: T, y: T, coefficients: [T; N]) -> T {
    let (mut remainder, mut quotient) = (T::zero(), T::zero());
    for &coefficient in coefficients.iter().rev() {
        quotient = quotient * x + remainder;
        remainder = remainder * y + coefficient;
    }
    quotient
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_integers_are_exact() {
        assert_eq!(even_sum(3.0, [1.0, 2.0, 0.0, 5.0]), 1.0 + 18.0 + 5.0 * 729.0);
        assert_eq!(value_and_slope(2.0, [1.0, 0.0, 3.0]), (13.0, 12.0));
        // (x³ − y³)/(x − y) = x² + x y + y².
        assert_eq!(divided_difference(3.0, 2.0, [7.0, 0.0, 0.0, 1.0]), 19.0);
        assert_eq!(divided_difference(2.0, 2.0, [7.0, 0.0, 0.0, 1.0]), 12.0);
    }

    #[test]
    fn even_sum_stays_finite_up_to_the_end_of_the_range() {
        assert_eq!(even_sum(1e153, [0.0, 1e-10]), 1e306 * 1e-10);
    }
}
