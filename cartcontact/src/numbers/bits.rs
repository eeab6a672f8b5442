//! Functions of the bits of f64 and f32, without branches, so that they compile to vector code.
//!
//! Each format is read from its own bits: a microcontroller's f32 never passes through f64. Of dual numbers these are the
//! bits of the value. Digits are binary, here and wherever a number is said to have all, half or few of its digits.

use super::binary::scale;
use crate::Scalar;
use crate::scalar::{from_single, has_no_derivatives, is_single, single_value};

/// Fractional digits of a logarithm.
pub(crate) const LOGARITHM_DIGITS: u32 = 8;

/// The bits of 2⁵² and 2²³. Between this and its double, the fraction bits of a number are its excess over this, as an
/// integer.
const UNIT_OF_DOUBLE: u64 = 0x4330_0000_0000_0000;
const UNIT_OF_SINGLE: u32 = 0x4b00_0000;

/// 2⁵² and 2²³ with room for a sign: 3 · 2⁵¹ and 3 · 2²².
const SIGNED_UNIT_OF_DOUBLE: f64 = 6_755_399_441_055_744.0;
const SIGNED_UNIT_OF_SINGLE: f64 = 12_582_912.0;

/// A function of the bits of x.
#[inline(always)]
pub(crate) fn of_bits<T: Scalar, R>(x: T, single: impl FnOnce(u32) -> R, double: impl FnOnce(u64) -> R) -> R {
    if is_single::<T>() { single(single_value(x).to_bits()) } else { double(x.value().to_bits()) }
}

/// The number with these bits.
#[inline(always)]
fn from_bits<T: Scalar>(single: u32, double: u64) -> T {
    if is_single::<T>() { from_single(f32::from_bits(single)) } else { T::constant(f64::from_bits(double)) }
}

/// The number whose bits are a function of the bits of x, without derivatives.
#[inline(always)]
fn with_bits<T: Scalar>(x: T, single: impl FnOnce(u32) -> u32, double: impl FnOnce(u64) -> u64) -> T {
    of_bits(x, |bits| from_bits(single(bits), 0), |bits| from_bits(0, double(bits)))
}

/// The bias of exponents.
#[inline(always)]
pub(crate) fn bias<T: Scalar>() -> i32 {
    if is_single::<T>() { 127 } else { 1023 }
}

/// Whether 2^`exponent` is a normal number.
#[inline(always)]
pub(crate) fn is_normal<T: Scalar>(exponent: i32) -> bool {
    ((exponent + bias::<T>() - 1) as u32) < (2 * bias::<T>()) as u32
}

/// 2⁸ log₂ x plus a constant, too low by 23.04 at most, for positive x.
///
/// Exponent and first digits, read as an integer. It is converted without the conversion instruction `cvtsi2sd`,
/// because of its false dependency: it would wait for the earlier content of its register.
#[inline(always)]
pub(crate) fn log2_digits<T: Scalar>(x: T) -> T {
    with_bits(
        x,
        |bits| bits >> (23 - LOGARITHM_DIGITS) | UNIT_OF_SINGLE,
        |bits| bits >> (52 - LOGARITHM_DIGITS) | UNIT_OF_DOUBLE,
    )
}

/// ln x of a positive normal number, too low by 0.0624 at most, for what is a rounding itself.
#[inline(always)]
pub(crate) fn rough_ln<T: Scalar>(x: T) -> T {
    let per_octave = f64::from(1 << LOGARITHM_DIGITS);
    (log2_digits(x) - log2_digits(T::one())) * T::constant(core::f64::consts::LN_2 / per_octave)
}

/// The nearest integer, of 21 digits and a sign, as a `T` and as an `i32`.
#[inline(always)]
pub(crate) fn nearest_integer<T: Scalar>(x: T) -> (T, i32) {
    let unit = T::constant(if is_single::<T>() { SIGNED_UNIT_OF_SINGLE } else { SIGNED_UNIT_OF_DOUBLE });
    // A sum of this size has no fractional digits, and the integer in its last bits.
    let sum = x + unit;
    // Of f32 the ten bits above the sign of the integer are shifted out and come back as copies of the sign.
    let integer = of_bits(sum, |bits| (bits << 10) as i32 >> 10, |bits| bits as i32);
    (sum - unit, integer)
}

/// 1 plus the last eight bits of an integer as a fraction.
#[inline(always)]
pub(crate) fn one_and_digits<T: Scalar>(integer: i32) -> T {
    let digits = integer as u32 & ((1 << LOGARITHM_DIGITS) - 1);
    from_bits(
        digits << (23 - LOGARITHM_DIGITS) | 0x3f80_0000,
        u64::from(digits) << (52 - LOGARITHM_DIGITS) | 0x3ff0_0000_0000_0000,
    )
}

/// 2^e if that is a normal number; otherwise something else.
#[inline(always)]
pub(crate) fn power_of_two<T: Scalar>(e: i32) -> T {
    let biased = e + bias::<T>();
    from_bits((biased as u32) << 23, (biased as u64) << 52)
}

/// The exponent e of x = f · 2^e, 1 ≤ f < 2. For a negative number, zero, infinity and NaN it is not that of a normal
/// number.
#[inline(always)]
pub(crate) fn exponent<T: Scalar>(x: T) -> i32 {
    of_bits(x, |bits| (bits >> 23) as i32, |bits| (bits >> 52) as i32) - bias::<T>()
}

/// The fraction f of x = f · 2^e, 1 ≤ f < 2, with its derivatives.
#[inline(always)]
pub(crate) fn fraction<T: Scalar>(x: T) -> T {
    if !has_no_derivatives::<T>() {
        return scale(x, -exponent(x));
    }
    with_bits(
        x,
        |bits| bits & 0x007f_ffff | 0x3f80_0000,
        |bits| bits & 0x000f_ffff_ffff_ffff | 0x3ff0_0000_0000_0000,
    )
}

/// The part of an octave, of 2^`DIGITS` equal ones, that a positive normal number is in: k = 2^`DIGITS` e +
/// ⌊2^`DIGITS` (f − 1)⌋ of f · 2^e, 1 ≤ f < 2.
#[inline(always)]
pub(crate) fn part_of_octave<T: Scalar, const DIGITS: u32>(x: T) -> i32 {
    let biased = of_bits(x, |bits| (bits >> (23 - DIGITS)) as i32, |bits| (bits >> (52 - DIGITS)) as i32);
    biased - (bias::<T>() << DIGITS)
}

/// The quarter of an octave that a positive normal number is in.
#[inline(always)]
pub(crate) fn quarter<T: Scalar>(x: T) -> i32 {
    part_of_octave::<T, 2>(x)
}

/// The least number in the quarter k of an octave, if that has normal numbers.
#[inline(always)]
pub(crate) fn least_of_quarter<T: Scalar>(k: i32) -> T {
    let biased = (k + 4 * bias::<T>()) as u32;
    from_bits(biased << 21, u64::from(biased) << 50)
}

/// The middle of the [part of an octave](part_of_octave) that a positive number is in; it has two digits more than
/// `DIGITS`.
#[inline(always)]
pub(crate) fn middle_of_part<T: Scalar, const DIGITS: u32>(x: T) -> T {
    let (single, double) = const { (1_u32 << (22 - DIGITS), 1_u64 << (51 - DIGITS)) };
    with_bits(x, |bits| bits & !(2 * single - 1) | single, |bits| bits & !(2 * double - 1) | double)
}

/// The number with half its digits, so that its square is exact. f32, which has no digits to waste, is rounded, f64 is
/// cut off.
#[inline(always)]
pub(crate) fn with_half_its_digits<T: Scalar>(x: T) -> T {
    // Wrapping, as all bits of a NaN may be set.
    with_bits(x, |bits| bits.wrapping_add(0x0800) & !0x0fff, |bits| bits & !0x07ff_ffff)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_those_of_the_exponent_and_eight_digits() {
        for k in 1..2000 {
            let x = 1.07f64.powi(k - 1000);
            let double = (log2_digits(x) - log2_digits(1.0)) / 256.0;
            assert!((-0.0901..0.001).contains(&(double - x.log2())), "{x:e}: {double}");
            if (1e-30..1e30).contains(&x) {
                assert_eq!(f64::from(log2_digits(x as f32) - log2_digits(1.0_f32)) / 256.0, double, "{x:e}");
            }
        }
    }

    #[test]
    fn integers_are_the_nearest() {
        for (x, expected) in
            [(-1000.4, -1000), (-0.6, -1), (0.0, 0), (0.4, 0), (7.6, 8), (262_143.3, 262_143)]
        {
            assert_eq!(nearest_integer(x), (f64::from(expected), expected));
            assert_eq!(nearest_integer(x as f32), (expected as f32, expected));
        }
    }

    #[test]
    fn numbers_are_put_together_from_what_they_are_taken_apart_to() {
        for x in [1.0, 1.75, 3.0e-300, 7.25e300, f64::MIN_POSITIVE] {
            assert_eq!(fraction(x) * power_of_two::<f64>(exponent(x)), x);
        }
        for x in [1.0, 1.75, 3.0e-30, 7.25e30, f32::MIN_POSITIVE] {
            assert_eq!(fraction(x) * power_of_two::<f32>(exponent(x)), x);
        }
        assert_eq!(one_and_digits::<f64>(0x140), 1.25);
        assert_eq!(one_and_digits::<f32>(-1), 2.0 - 2f32.powi(-8));
        for x in [0.0, f64::MIN_POSITIVE / 2.0, f64::INFINITY, f64::NAN, -1.0, -f64::INFINITY] {
            assert!(!is_normal::<f64>(exponent(x)), "{x:e}");
        }
        for x in [0.0, f32::MIN_POSITIVE / 2.0, f32::INFINITY, f32::NAN, -1.0, -f32::INFINITY] {
            assert!(!is_normal::<f32>(exponent(x)), "{x:e}");
        }
    }

    #[test]
    fn parts_of_octaves_have_their_middle() {
        let parts: [(f64, [f64; 2], i32); 4] = [
            (1.0, [1.125, 1.03125], 0),
            (1.24, [1.125, 1.21875], 3),
            (1.5, [1.625, 1.53125], 8),
            (7.99, [7.5, 7.875], 2 * 16 + 15),
        ];
        for (x, middles, sixteenth) in parts {
            let single = x as f32;
            assert_eq!([middle_of_part::<_, 2>(x), middle_of_part::<_, 4>(x)], middles);
            assert_eq!(
                [middle_of_part::<_, 2>(single), middle_of_part::<_, 4>(single)].map(f64::from),
                middles
            );
            assert_eq!([part_of_octave::<_, 4>(x), part_of_octave::<_, 4>(single)], [sixteenth; 2]);
            assert_eq!(quarter(x), quarter(x as f32));
            assert_eq!(least_of_quarter::<f64>(quarter(x)), f64::from(least_of_quarter::<f32>(quarter(x))));
            assert!((least_of_quarter(quarter(x))..least_of_quarter(quarter(x) + 1)).contains(&x));
        }
    }

    #[test]
    fn squares_of_half_the_digits_are_exact() {
        let third = with_half_its_digits(1.0 / 3.0_f64);
        assert_eq!((third * third).to_bits() & 1, 0);
        assert!((3.0 * third - 1.0).abs() < 2f64.powi(-25));
        let third = with_half_its_digits(1.0 / 3.0_f32);
        assert_eq!(f64::from(third * third), f64::from(third) * f64::from(third));
        let below_two = 2.0 - f32::EPSILON;
        assert_eq!(with_half_its_digits(below_two), 2.0);
    }
}
