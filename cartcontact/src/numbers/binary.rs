//! Powers of two, taken out of a number and put back, so that roots and quotients neither overflow nor lose accuracy.

use super::bits::{bias, exponent, fraction, is_normal, power_of_two};
use crate::Scalar;
use crate::scalar::{floor, has_no_derivatives, is_finite_and_positive, is_single, smallest_normal};

/// The fraction f, with its derivatives, and the exponent e of a positive finite number x = f · 2^e with 1 ≤ f < 2.
#[inline]
pub(crate) fn split<T: Scalar>(x: T) -> (T, i32) {
    // 2⁵⁴ times a subnormal number is a normal one in either format.
    let (x, shift) =
        if x < smallest_normal() { (x * T::constant(18_014_398_509_481_984.0), 54) } else { (x, 0) };
    (fraction(x), exponent(x) - shift)
}

/// x · 2^e; exact unless the result over- or underflows.
#[inline]
pub(crate) fn scale<T: Scalar>(x: T, e: i32) -> T {
    if is_normal::<T>(e) {
        return x * power_of_two(e);
    }
    // In three factors: 2^e, and even its root, may lie outside the format although x · 2^e does not.
    let (third, most) = (e / 3, bias::<T>());
    let clamped = |e: i32| power_of_two::<T>(e.clamp(1 - most, most));
    x * clamped(third) * clamped(third) * clamped(e - 2 * third)
}

/// A quotient, such as that of numbers of similar size, or by a power of a radius. The derivative of one is a difference
/// of products over a square, which leave the format long before the numbers do.
#[inline(always)]
pub(crate) fn ratio<T: Scalar>(x: T, y: T) -> T {
    if has_no_derivatives::<T>() || !is_finite_and_positive(y) {
        return x / y;
    }
    let (y, exponent) = split(y);
    scale(x, -exponent) / y
}

/// The product of some numbers over that of others, which is out of range only if the result is.
///
/// Zeros, infinities and NaN are not split into a fraction and a power of two; they never leave the range.
pub(crate) fn quotient<T: Scalar, const N: usize, const M: usize>(factors: [T; N], divisors: [T; M]) -> T {
    // Of five numbers between 1/most and most all products are in range.
    let most = T::constant(if is_single::<T>() { 3e7 } else { 1e60 });
    let least = most.recip();
    if factors.iter().chain(&divisors).all(|&x| least <= x && x <= most) {
        return over(product(factors), divisors);
    }
    let parts = |x: T| if is_finite_and_positive(x) { split(x) } else { (x, 0) };
    let octaves = |parts: &[(T, i32)]| parts.iter().map(|&(_, octaves)| octaves).sum::<i32>();
    let (factors, divisors) = (factors.map(parts), divisors.map(parts));
    let fraction = |(fraction, _)| fraction;
    let quotient = over(product(factors.map(fraction)), divisors.map(fraction));
    scale(quotient, octaves(&factors) - octaves(&divisors))
}

fn product<T: Scalar, const N: usize>(factors: [T; N]) -> T {
    factors.into_iter().fold(T::one(), |product, factor| product * factor)
}

/// A number over some others by one division, the slowest of all operations.
fn over<T: Scalar, const N: usize>(number: T, divisors: [T; N]) -> T {
    if N == 0 { number } else { number / product(divisors) }
}

/// (x k/y)^(1/p) for p ≥ 4 within 1 %, by parabolas for the logarithm and the exponential: a start for an iteration.
///
/// It neither overflows nor depends on powers 2^(i p) in x/y; k has a size near 1, from 2^−64 to 2^64. Nor does what else
/// the numbers carry, such as derivatives: it would with 1/y² as a factor.
///
/// Error: log₂ f ≈ 2 f − f²/3 − 5/3 is off by at most 0.0098 on [1, 2), which costs 0.7 %/p; 2^u ≈ 1 + u (2 + u)/3 is
/// off by at most 0.4 % on [0, 1).
#[inline]
pub(crate) fn estimated_root_of_quotient<T: Scalar>(x: T, k: T, y: T, p: T) -> T {
    let third = T::constant(1.0 / 3.0);
    let ((x, exponent_x), (y, exponent_y)) = (split(x), split(y));
    let (f, exponent) = split(x * (k / y));
    let inverse = p.recip();
    let (whole, rest) = divide(exponent_x - exponent_y + exponent, p, inverse);
    let u = (rest + (T::constant(2.0) * f - f * f * third - T::constant(5.0 / 3.0))) * inverse;
    let (whole, u) = if u >= T::one() { (whole + 1, u - T::one()) } else { (whole, u) };
    scale(T::one() + u * (T::constant(2.0) + u) * third, whole)
}

/// The whole part of e/p and what remains, e = whole · p + rest with 0 ≤ rest < p.
pub(crate) fn divide<T: Scalar>(e: i32, p: T, inverse: T) -> (i32, T) {
    let total = T::constant(f64::from(e));
    // A product instead of a quotient, nudged so that rounding does not take multiples of p to the whole number below:
    // fractions of e/p are multiples of 1/(4 p), or of no consequence.
    let whole = floor(total * inverse + T::constant(1e-6));
    (whole, total - T::constant(f64::from(whole)) * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fraction_and_exponent_are_those_of_the_format() {
        for e in -1074..1024 {
            let x = if e < -1022 { f64::from_bits(1 << (e + 1074)) } else { power_of_two(e) };
            assert_eq!(split(x), (1.0, e));
        }
        for e in -149..128 {
            let x = if e < -126 { f32::from_bits(1 << (e + 149)) } else { power_of_two(e) };
            assert_eq!(split(x), (1.0, e));
        }
    }

    #[test]
    fn scale_reaches_both_ends_of_the_range() {
        assert_eq!(scale(f64::MIN_POSITIVE, 2045), 2f64.powi(1023));
        assert_eq!(scale(2f64.powi(1023), -2045), f64::MIN_POSITIVE);
        assert_eq!(scale(1.5_f32, 10), 1536.0);
        assert_eq!(
            (scale(0.0_f32, 600), scale(1.0_f32, 600), scale(1.0_f32, -600)),
            (0.0, f32::INFINITY, 0.0)
        );
    }

    #[test]
    fn estimates_are_within_one_percent() {
        for p in [4.0, 4.25, 5.0, 6.0, 6.5, 8.0, 68.0] {
            for k in [1.0, 12.3, 8200.0] {
                for y in [1.0, 1.3, 0.7, 1.999] {
                    for step in -2000..2000 {
                        let x = 1.01_f64.powi(step);
                        let ratio = estimated_root_of_quotient(x, k, y, p) / (x * k / y).powf(p.recip());
                        assert!((ratio - 1.0).abs() < 1e-2, "({x:e} * {k}/{y})^(1/{p}): {ratio}");
                    }
                }
            }
        }
    }
}
