//! A polynomial over part of the interval from 1 to 2, with as many digits as a decision takes.
//!
//! Over a part of width 2^-d the exact coefficients of a polynomial of degree n have n d bits more than it had itself,
//! nearly all of which no sign depends on. Rounded to units of a power of two they stay short, and a sign is taken
//! from them only if the error cannot change it.
//!
//! **Error.** On the way that `powers` takes, for f from 1 to 2, in units of a number with some digits more: cutting c_j
//! and the powers of f leaves less than 2^(j+2); the shift and the division less than 4 · 3^n, as
//! C(i, j)/C(n, j) ≤ C(n−j, i−j), times (w/f)^j; rounding the powers of w/f and the quotients n + 3 more; and the left
//! edge 4 · 3^n (1 + w)^n and (n + 3) 2^n. All of it is less than one unit of the result if there are [`guard`] digits
//! more. Over at most half of the whole, number j has an error of less than 2^(2n+3−j) + n + 2 before the division, so
//! that negligible powers may be left out.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use crate::proof::bernstein::Bernstein;
use crate::proof::integer_polynomial::IntegerPolynomial;
use crate::proof::powers::Powers;

/// From 1 + offset/2^bits on, 2^-width long; 0 <= offset < 2^bits.
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

    /// The lower end or the upper one, in units of 2^-bits.
    pub(crate) fn end(&self, end: u32) -> BigInt {
        (BigInt::one() << self.bits) + &self.offset + (BigInt::from(end) << (self.bits - self.width))
    }
}

/// A polynomial over the interval from 2^exponent to 2^(exponent + 1), which stands for the one from 1 to 2.
///
/// Multiplied by a power of two its coefficients there, c_j 2^(exponent j), are integers, which are formed as far as
/// they are needed only.
pub(crate) struct Whole<'a> {
    pub(crate) polynomial: &'a IntegerPolynomial,
    pub(crate) exponent: i64,
    /// Below which power of two all c_j 2^(exponent j) lie.
    top: i64,
    /// That of the longest of the integers, in bits.
    pub(crate) length: u64,
}

/// Digits that are lost on the way to Bernstein's basis over a part of width 2^-width: by 16 more than
/// log2 (8 (n + 3) 3^n (1 + 2^-width)^n), as log2 3 < 1.59 and log2 (1 + w) < w + 0.09.
fn guard(degree: u64, width: u64) -> u64 {
    2 * degree + (degree >> width.min(63)) + 32
}

impl<'a> Whole<'a> {
    pub(crate) fn new(polynomial: &'a IntegerPolynomial, exponent: i64) -> Self {
        let ends = polynomial.coefficients().iter().zip(0_i64..).filter_map(|(coefficient, power)| {
            let lowest = coefficient.trailing_zeros()? as i64;
            Some((lowest + exponent * power, coefficient.bits() as i64 + exponent * power))
        });
        let (bottom, top) = ends.reduce(|all, own| (all.0.min(own.0), all.1.max(own.1))).unwrap_or_default();
        Whole { polynomial, exponent, top, length: (top - bottom) as u64 }
    }

    pub(crate) fn degree(&self) -> u64 {
        self.polynomial.degree() as u64
    }

    /// The sign at the lower end of a part, or at its upper one.
    pub(crate) fn sign_at(&self, part: &Part, end: u32) -> Ordering {
        self.sign_of(self.polynomial, part, end)
    }

    /// The sign of another polynomial there.
    pub(crate) fn sign_of(&self, polynomial: &IntegerPolynomial, part: &Part, end: u32) -> Ordering {
        let exponent = self.exponent - part.bits as i64;
        let offset = part.end(end) << exponent.max(0);
        polynomial.value_at(&offset, exponent.min(0).unsigned_abs()).cmp(&BigInt::zero())
    }

    /// The coefficients, of which the longest has so many binary digits; what is below these is cut.
    pub(crate) fn coefficients(&self, digits: u64) -> Vec<BigInt> {
        let coefficients = self.polynomial.coefficients().iter().zip(0_i64..);
        let with_digits =
            coefficients.map(|(coefficient, power)| match self.exponent * power + digits as i64 - self.top {
                missing @ 0.. => coefficient << missing,
                excess => coefficient >> -excess,
            });
        with_digits.collect()
    }

    /// In Bernstein's basis, in units of which the longest coefficient of the whole has `digits` binary digits.
    pub(crate) fn over(&self, part: &Part, digits: u64) -> Bernstein {
        let powers = self.powers_over(part, digits);
        // Undecided numbers are zero where the unit is finer than what all of them are multiples of.
        let multiple = || common_multiple(self.polynomial.degree()).bits();
        let finest = self.length + self.degree() * part.bits + u64::from(u64::BITS);
        let is_exact = digits > finest && digits > finest + multiple();
        let fewer = if part.width > 0 && !is_exact { powers.without_negligible() } else { None };
        Bernstein::new(&fewer.unwrap_or(powers), is_exact)
    }

    /// In powers from the beginning of the part on, in the same units.
    pub(crate) fn powers_over(&self, part: &Part, digits: u64) -> Powers {
        let guard = guard(self.degree(), part.width);
        let powers = Powers::new(self.coefficients(digits + guard), guard, 0);
        powers.over(&part.end(0), part.bits, part.width)
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
    use crate::proof::fixed_point::binomials;

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
