//! Exact numbers: what a literal means, and how a result is written back.
//!
//! Every number of a profile is a rational from its first digit to the moment it becomes an `f64` literal in the
//! generated code, so it is rounded once. Sizes are bounded wherever a short text could stand for a huge number.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proc_macro2::Literal;

pub(crate) type Rational = BigRational;

/// The largest power of ten that a literal may be written with: beyond every `f64`, and short to write out.
const MAXIMUM_DECIMAL_EXPONENT: i64 = 400;
const MAXIMUM_DIGITS: usize = 1000;
/// The most bits that a power of a number may take; an `f64` has no use for more than 2100.
const MAXIMUM_POWER_BITS: u64 = 1 << 14;

pub(crate) fn integer(value: impl Into<BigInt>) -> Rational {
    Rational::from_integer(value.into())
}

/// The nearest `f64`, unless that is zero or infinite.
pub(crate) fn nearest(value: &Rational) -> Option<f64> {
    value.to_f64().filter(|nearest| nearest.is_finite() && *nearest != 0.0)
}

/// The nearest `f64` as a literal in its shortest form, such as `0.025f64`.
pub(crate) fn literal(value: &Rational) -> Literal {
    let nearest = value.to_f64().unwrap_or(0.0).clamp(f64::MIN, f64::MAX);
    format!("{nearest:?}f64").parse().unwrap_or_else(|_| Literal::f64_suffixed(nearest))
}

/// `digits` with `decimals` of them behind the point, times a power of ten.
pub(crate) fn from_decimal(digits: &str, decimals: usize, exponent: i64) -> Result<Rational, &'static str> {
    if digits.len() > MAXIMUM_DIGITS {
        return Err("a number may have at most 1000 digits");
    }
    if exponent.abs() > MAXIMUM_DECIMAL_EXPONENT {
        return Err("the exponent of a number must lie between -400 and 400");
    }
    let digits: BigInt = digits.parse().map_err(|_| "a number is written with decimal digits")?;
    let shift =
        i32::try_from(exponent - decimals as i64).map_err(|_| "a number may have at most 1000 digits")?;
    Ok(integer(digits) * integer(10).pow(shift))
}

/// `base` to an integer power; `None` if the result is too large to be of use. The base of a negative power must
/// not be zero.
pub(crate) fn power(base: &Rational, exponent: &BigInt) -> Option<Rational> {
    let exponent = exponent.to_i32()?;
    let bits = base.numer().bits() + base.denom().bits();
    let trivial = base.is_zero() || base.abs().is_one();
    let fits = bits.saturating_mul(exponent.unsigned_abs().into()) <= MAXIMUM_POWER_BITS;
    if trivial {
        let odd = exponent % 2 != 0;
        return Some(if odd { base.clone() } else { base * base })
            .filter(|_| exponent != 0)
            .or(Some(integer(1)));
    }
    fits.then(|| base.pow(exponent))
}

/// The root of a positive number, if it is rational.
pub(crate) fn root(base: &Rational, index: &BigInt) -> Option<Rational> {
    let index = index.to_u32().filter(|index| *index > 0 && base.is_positive())?;
    let root = Rational::new(base.numer().nth_root(index), base.denom().nth_root(index));
    let exact = root.numer().pow(index) == *base.numer() && root.denom().pow(index) == *base.denom();
    exact.then_some(root)
}

/// For people: a decimal if that is exact and short, else a short fraction, else the nearest `f64`.
pub(crate) fn decimal(value: &Rational) -> String {
    let shortest = value.to_f64().unwrap_or(0.0);
    match Rational::from_float(shortest).is_some_and(|nearest| nearest == *value)
        || is_written(value, shortest)
    {
        true => plain(shortest),
        false if value.numer().bits() + value.denom().bits() < 40 => {
            format!("{}/{}", value.numer(), value.denom())
        }
        false => plain(shortest),
    }
}

/// Whether the digits that stand for the `f64` are the number itself.
fn is_written(value: &Rational, shortest: f64) -> bool {
    crate::literal::number(&format!("{shortest:e}")).is_ok_and(|written| written == *value)
}

fn plain(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-3..1e7).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}
