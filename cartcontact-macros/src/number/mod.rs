//! Exact numbers: what a literal means, and how a result is written back.
//!
//! Every number of a profile is rational from its first digit until it becomes an `f64` literal in the generated code,
//! so it is rounded once. Sizes are bounded wherever a short text could stand for a huge number.

pub(crate) mod common_factor;
mod convergent;
pub(crate) mod float;
mod rational;

use core::fmt::Debug;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};
use proc_macro2::{Literal, TokenStream};

pub(crate) use rational::Rational;

/// The largest power of ten that a literal may be written with: beyond every `f64`, and still short when written out.
const MAXIMUM_DECIMAL_EXPONENT: i64 = 400;
/// More than any `f64` has, all 767 of the longest included.
const MAXIMUM_DIGITS: usize = 1000;
/// The most bits that a power of a number may take; an `f64` has no use for more than 2100.
const MAXIMUM_POWER_BITS: u64 = 1 << 14;

pub(crate) fn integer(value: impl Into<BigInt>) -> Rational {
    Rational::from_integer(value.into())
}

/// The quotient of two integers; the second is not zero.
pub(crate) fn fraction(numerator: impl Into<BigInt>, denominator: impl Into<BigInt>) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// The least common denominator; the longest is taken first, as the others are likely to divide it.
pub(crate) fn common_denominator<'a>(fractions: impl Iterator<Item = &'a Rational>) -> BigInt {
    common_multiple(fractions.map(Rational::denom).collect())
}

fn common_multiple(denominators: Vec<&BigInt>) -> BigInt {
    let longest = denominators.iter().copied().max_by_key(|denominator| denominator.bits());
    let mut common = longest.map_or_else(BigInt::one, BigInt::clone);
    for denominator in denominators {
        let shared = common_factor::common_factor(&common, denominator);
        if shared != *denominator {
            common *= denominator / shared;
        }
    }
    common
}

/// The nearest `f64`, unless that is zero or infinite.
pub(crate) fn nearest(value: &Rational) -> Option<f64> {
    Some(value.to_f64()).filter(|nearest| nearest.is_finite() && *nearest != 0.0)
}

/// The nearest finite `f64`.
pub(crate) fn rounded(value: &Rational) -> f64 {
    value.to_f64().clamp(f64::MIN, f64::MAX)
}

/// The nearest finite `f64`, and the one nearest to the remainder.
pub(crate) fn nearest_and_rest(value: &Rational) -> (f64, f64) {
    let nearest = rounded(value);
    let rest = value - Rational::from_float(nearest).unwrap_or_else(Rational::zero);
    (nearest, rounded(&rest))
}

/// Whether the number is a power of two, apart from its sign.
pub(crate) fn is_power_of_two(value: &Rational) -> bool {
    is_binary(value) && value.numer().magnitude().count_ones() == 1
}

/// The nearest finite `f64` as a literal in its shortest form, such as `0.025f64`.
pub(crate) fn literal(value: &Rational) -> Literal {
    let nearest = rounded(value);
    format!("{nearest:?}f64").parse().unwrap_or_else(|_| Literal::f64_suffixed(nearest))
}

/// Numbers, tuples and arrays of them as code, in the shortest literals, as `Debug` writes them: the compiler reads one
/// text faster than its tokens one by one.
pub(crate) fn code(numbers: impl Debug) -> TokenStream {
    format!("{numbers:?}").parse().unwrap_or_default()
}

/// An integer times 2^steps, rounded down.
pub(crate) fn shifted(number: &BigInt, steps: i64) -> BigInt {
    if steps < 0 { number >> -steps } else { number << steps }
}

/// `digits` with `decimals` of them after the point, times a power of ten.
pub(crate) fn from_decimal(digits: &str, decimals: usize, exponent: i64) -> Result<Rational, &'static str> {
    if digits.len() > MAXIMUM_DIGITS {
        return Err("a number may have at most 1000 digits; round it");
    }
    if exponent.abs() > MAXIMUM_DECIMAL_EXPONENT {
        return Err(
            "the exponent of a number must lie between -400 and 400; use a unit of length that brings it nearer to 1",
        );
    }
    let digits: BigInt = digits.parse().map_err(|_| "a number is written with decimal digits")?;
    Ok(integer(digits) * integer(10).pow((exponent - decimals as i64) as i32))
}

/// `base` to an integer power; `None` if the result is too large to be useful. Neither of them is zero.
pub(crate) fn power(base: &Rational, exponent: &BigInt) -> Option<Rational> {
    if base.abs().is_one() {
        return Some(if exponent.is_even() { Rational::one() } else { base.clone() });
    }
    let exponent = exponent.to_i32()?;
    let bits = base.numer().bits() + base.denom().bits();
    let fits = bits.saturating_mul(exponent.unsigned_abs().into()) <= MAXIMUM_POWER_BITS;
    fits.then(|| base.pow(exponent))
}

/// The root of a positive number, if it is rational. Its index is positive.
pub(crate) fn root(base: &Rational, index: &BigInt) -> Option<Rational> {
    if base.is_one() {
        return Some(Rational::one());
    }
    let index = index.to_u32()?;
    let root = Rational::new(base.numer().nth_root(index), base.denom().nth_root(index));
    let exact = root.numer().pow(index) == *base.numer() && root.denom().pow(index) == *base.denom();
    exact.then_some(root)
}

/// The largest number of `digits` or `digits` + 1 binary digits that is not above a value; the fraction need not be
/// reduced.
pub(crate) fn floor(value: &Rational, digits: u64) -> Rational {
    let (numerator, denominator) = (value.numer(), value.denom());
    let excess = numerator.bits().saturating_sub(denominator.bits() + digits);
    let shift = (denominator.bits() + digits).saturating_sub(numerator.bits());
    let quotient = (numerator << shift).div_floor(&(denominator << excess));
    Rational::new(quotient << excess, BigInt::one() << shift)
}

/// The same, rounded up.
pub(crate) fn ceil(value: &Rational, digits: u64) -> Rational {
    -floor(&-value, digits)
}

/// Whether the denominator is a power of two.
pub(crate) fn is_binary(value: &Rational) -> bool {
    value.denom().magnitude().count_ones() == 1
}

/// Whether a number of single precision has all its digits.
pub(crate) fn has_few_digits(value: &Rational) -> bool {
    is_binary(value) && value.numer().magnitude().bits() <= u64::from(f32::MANTISSA_DIGITS)
}

/// The number rounded to three digits, as the exact value of the `f64` that these digits are read as.
pub(crate) fn three_digits(value: f64) -> Option<Rational> {
    format!("{value:.2e}").parse::<f64>().ok().and_then(Rational::from_float)
}

/// For readers: a short fraction if it is not a decimal, otherwise the nearest `f64`.
pub(crate) fn decimal(value: &Rational) -> String {
    let (numerator, denominator) = (value.numer(), value.denom());
    let is_short = numerator.bits() + denominator.bits() < 40;
    if is_short && !is_binary(value) && !is_written(value) {
        format!("{numerator}/{denominator}")
    } else {
        plain(value.to_f64())
    }
}

/// The same after an operator that binds tighter than a fraction line.
pub(crate) fn operand(value: &Rational) -> String {
    let text = decimal(value);
    if text.contains('/') { format!("({text})") } else { text }
}

/// Whether the shortest digits of the nearest `f64` are the number itself.
pub(crate) fn is_written(value: &Rational) -> bool {
    let written = format!("{:e}", value.to_f64());
    let (mantissa, exponent) = written.split_once('e').unwrap_or((&written, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{decimals}");
    let number = from_decimal(digits.trim_start_matches('-'), decimals.len(), exponent.parse().unwrap_or(0));
    number.is_ok_and(|number| number == value.abs())
}

fn plain(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-3..1e7).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;

    #[test]
    fn literals_are_rounded_once_and_shortest() {
        assert_eq!(literal(&fraction(1, 40)).to_string(), "0.025f64");
        assert_eq!(literal(&fraction(1, 3)).to_string(), "0.3333333333333333f64");
        assert_eq!(literal(&integer(10).pow(-300)).to_string(), "1e-300f64");
    }

    /// Halfway between two neighbours to the even one, otherwise to the nearest on either side, down to the subnormal
    /// numbers.
    #[test]
    fn rounding_is_to_the_nearest() {
        let tiny = integer(10).pow(-400);
        for bits in [1, 2, 3, 4503599627370494, 4503599627370496, 4607182418800017409, 9218868437227405310] {
            let (lower, upper) = (f64::from_bits(bits), f64::from_bits(bits + 1));
            let middle =
                (Rational::from_float(lower).unwrap() + Rational::from_float(upper).unwrap()) / integer(2);
            assert_eq!(nearest(&(&middle - &tiny)), Some(lower));
            assert_eq!(nearest(&(&middle + &tiny)), Some(upper));
            assert_eq!(nearest(&middle), Some(if bits % 2 == 0 { lower } else { upper }));
        }
        assert_eq!(nearest(&tiny), None);
        assert_eq!(nearest(&tiny.recip()), None);
    }

    #[test]
    fn floors_are_near_and_not_above() {
        let third = Rational::new_raw(5.into(), 15.into());
        for value in [third.clone(), -third, integer(10).pow(40) / integer(7), fraction(3, 4), integer(0)] {
            let (below, unit) = (floor(&value, 20), integer(2).pow(-19));
            assert!(below <= value && value - &below <= unit * below.abs() && below.numer().bits() <= 134);
        }
        assert_eq!(floor(&fraction(3, 4), 20), fraction(3, 4));
    }

    #[test]
    fn powers_of_two_have_one_binary_digit() {
        assert!(
            [(1, 1), (8, 1), (-2, 1), (1, 4), (-1, 64)]
                .iter()
                .all(|&(n, d)| is_power_of_two(&fraction(n, d)))
        );
        assert!(
            ![(0, 1), (1, 3), (3, 1), (3, 4), (-2, 5)].iter().any(|&(n, d)| is_power_of_two(&fraction(n, d)))
        );
    }

    #[test]
    fn shifts_round_down() {
        let shifts =
            [(-5, -1), (5, -1), (-5, 2), (7, 0)].map(|(number, steps)| shifted(&number.into(), steps));
        assert_eq!(shifts, [-3, 2, -20, 7].map(BigInt::from));
    }

    #[test]
    fn people_read_decimals_or_fractions() {
        assert_eq!(decimal(&fraction(1, 40)), "0.025");
        assert_eq!(decimal(&fraction(7, 64_000)), "1.09375e-4");
        assert_eq!(decimal(&fraction(-1, 3)), "-1/3");
        assert_eq!(decimal(&(fraction(1, 3) * integer(10).pow(-30))), "3.3333333333333333e-31");
    }

    #[test]
    fn powers_and_roots_are_exact_or_refused() {
        assert_eq!(power(&fraction(2, 3), &(-3).into()), Some(fraction(27, 8)));
        assert_eq!(power(&integer(2), &999_999_999.into()), None);
        assert_eq!(power(&integer(-1), &999_999_999.into()), Some(integer(-1)));
        assert_eq!(power(&integer(-1), &(-2).into()), Some(integer(1)));
        assert_eq!(root(&fraction(8, 27), &3.into()), Some(fraction(2, 3)));
        assert_eq!(root(&integer(1), &BigInt::from(10).pow(20)), Some(integer(1)));
        assert_eq!(root(&integer(2), &2.into()), None);
        assert_eq!([fraction(9, 5), fraction(5, 9)].map(|base| root(&base, &2.into())), [None, None]);
    }
}
