//! A polynomial over part of the interval from 1 to 2, with as many digits as a decision takes.
//!
//! Over a part of width 2^-d the exact coefficients of a polynomial of degree n have n d bits more than its own, and no
//! sign depends on nearly all of these. Rounded to units of a power of two they stay short, and a sign is taken from
//! them only if the error cannot change it.
//!
//! **Error.** Cutting the coefficients c_j of the whole loses less than one unit of each. The Taylor shift to the
//! beginning only adds integers, so number j of the result is less than C(n+1, j+1) units off: less than `powers`
//! allows.
//!
//! **Values.** Horner's rule (`horner`) loses less than the factor of the coefficient and 2 in each step: at most 3 for a
//! value, and n + 2 for a slope. As points are at most 2, that grows at most 2^j times in the j steps that follow. With
//! guard digits for 2^n, for n + 1 steps, in a slope for n + 1 once more, and 3 others, it is less than one unit, and
//! rounding the result loses another one.

use core::cell::RefCell;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use crate::first_zero::fixed_point::Numbers;
use crate::first_zero::horner::{CoefficientTable, fraction};
use crate::first_zero::integer_polynomial::IntegerPolynomial;
use crate::first_zero::powers::{GUARD, Powers};
use crate::number::shifted;

/// The interval from 1 + offset/2^bits on, 2^-width long; 0 <= offset < 2^bits.
#[derive(Clone)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Part {
    pub(crate) offset: BigInt,
    pub(crate) bits: u64,
    pub(crate) width: u64,
}

impl Part {
    pub(crate) fn whole() -> Self {
        Part { offset: BigInt::zero(), bits: 0, width: 0 }
    }

    /// The part of this one from offset/2^bits on that is 2^-width long, as fractions of this one.
    pub(crate) fn within(&self, offset: &BigInt, bits: u64, width: u64) -> Part {
        let finest = self.bits.max(self.width + bits);
        let own = &self.offset << (finest - self.bits);
        let offset = own + (offset << (finest - self.width - bits));
        Part { offset, bits: finest, width: self.width + width }
    }

    /// Where a part of this one begins: offset/2^bits of this one.
    pub(crate) fn locate(&self, inner: &Part) -> (BigInt, u64) {
        (&inner.offset - (&self.offset << (inner.bits - self.bits)), inner.bits - self.width)
    }

    /// The lower end (0) or the upper end (1), in units of 2^-bits.
    pub(crate) fn end(&self, end: u32) -> BigInt {
        (BigInt::one() << self.bits) + &self.offset + (BigInt::from(end) << (self.bits - self.width))
    }
}

/// A polynomial over the interval from 2^exponent to 2^(exponent + 1), which stands for the one from 1 to 2.
///
/// Multiplied by a power of two, its coefficients there, c_j 2^(exponent j), are integers; only the digits that are
/// needed are formed.
pub(crate) struct Whole<'a> {
    pub(crate) polynomial: &'a IntegerPolynomial,
    pub(crate) exponent: i64,
    /// All c_j 2^(exponent j) lie below 2^top.
    top: i64,
    /// The length of the longest of the integers, in bits.
    pub(crate) length: u64,
    /// The coefficients with as many digits as were asked for so far.
    table: RefCell<CoefficientTable>,
}

impl<'a> Whole<'a> {
    pub(crate) fn new(polynomial: &'a IntegerPolynomial, exponent: i64) -> Self {
        let ends = polynomial.coefficients().iter().zip(0_i64..).filter_map(|(coefficient, power)| {
            let lowest = coefficient.trailing_zeros()? as i64;
            Some((lowest + exponent * power, coefficient.bits() as i64 + exponent * power))
        });
        let (bottom, top) = ends.reduce(|all, own| (all.0.min(own.0), all.1.max(own.1))).unwrap_or_default();
        let table = RefCell::new(CoefficientTable::new(&[], i64::MIN));
        Whole { polynomial, exponent, top, length: (top - bottom) as u64, table }
    }

    pub(crate) fn degree(&self) -> u64 {
        self.polynomial.degree() as u64
    }

    /// The sign at the lower end (0) or the upper end (1) of a part.
    pub(crate) fn sign_at(&self, part: &Part, end: u32) -> Ordering {
        self.polynomial.sign_at(&part.end(end), self.exponent - part.bits as i64)
    }

    /// The coefficients, cut so that the longest has this many binary digits.
    fn coefficients(&self, digits: i64) -> Vec<BigInt> {
        let coefficients = self.polynomial.coefficients().iter().zip(0_i64..);
        let missing = |power: i64| self.exponent * power + digits - self.top;
        coefficients.map(|(coefficient, power)| shifted(coefficient, missing(power))).collect()
    }

    /// The value at the beginning of a part in units of 2^-digits, less than two units from the true one; nothing if
    /// that leaves its sign open, or at the end of the interval.
    pub(crate) fn value(&self, point: &Part, digits: u64) -> Option<BigInt> {
        let is_inside = point.offset.bits() <= point.bits;
        is_inside.then(|| self.derivative(0, point, digits)).filter(|value| value.bits() > 1)
    }

    /// The slope at the beginning of a part, in units of 2^-digits and less than two units from the true one.
    pub(crate) fn slope(&self, point: &Part, digits: u64) -> BigInt {
        self.derivative(1, point, digits)
    }

    fn derivative(&self, order: u32, point: &Part, digits: u64) -> BigInt {
        let steps = u64::BITS - self.degree().leading_zeros();
        let fine = (digits + self.degree() + u64::from((order + 1) * steps) + 3) as i64;
        let mut table = self.table.borrow_mut();
        if table.digits < fine {
            *table = CoefficientTable::new(&self.coefficients(fine), fine);
        }
        let (value, unit) = table.derivative(order, &fraction(&point.offset, point.bits), fine);
        shifted(&value, digits as i64 - unit)
    }

    /// Whether numbers over the part are zero if this many digits leave their sign open: the unit is then finer than a
    /// number of which all of them are multiples.
    pub(crate) fn is_exact_over(&self, part: &Part, digits: u64) -> bool {
        let finest = self.length + self.degree() * part.bits + u64::from(u64::BITS);
        digits > finest && digits > finest + common_multiple(self.polynomial.degree()).bits()
    }

    /// The polynomial in powers from the beginning of the interval on, in units such that the longest coefficient has
    /// this many binary digits.
    pub(crate) fn powers(&self, digits: u64) -> Powers {
        let guard = self.degree() + GUARD;
        let numbers = Numbers::new(&self.coefficients((digits + guard) as i64));
        Powers { numbers: numbers.taylor_shift().values(), guard, error: 0 }
    }
}

/// The least common multiple of C(n, 0), …, C(n, n): that of 1, …, n + 1 divided by n + 1 (B. Farhi, Amer. Math.
/// Monthly 116 (2009) 836-839).
fn common_multiple(degree: usize) -> BigInt {
    let multiple = (2..=degree + 1).fold(BigInt::one(), |multiple, next| {
        let shared = (&multiple % next).to_usize().unwrap_or(0).gcd(&next);
        multiple * (next / shared)
    });
    multiple / (degree + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::first_zero::fixed_point::binomials;

    #[test]
    fn ends_of_parts_are_where_they_say() {
        let deep = Part::whole().within(&123_456_789.into(), 40, 38);
        let deeper = deep.within(&5.into(), 3, 3);
        let [lower, upper] = [0, 1].map(|end| deeper.end(end));
        assert_eq!((upper - lower, deeper.bits, deeper.width), (BigInt::one(), 41, 41));
    }

    #[test]
    fn common_multiples_are_the_least() {
        for degree in [1, 2, 5, 20, 64] {
            let multiple = binomials(degree).iter().fold(BigInt::one(), |multiple, next| multiple.lcm(next));
            assert_eq!(common_multiple(degree), multiple);
        }
    }
}
