//! Dense polynomials with integer coefficients: the exact operations that isolating a root takes.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::number::common_factor::common_factor;
use crate::number::{Rational, common_denominator};

/// Coefficients in ascending order of powers; the last is not zero. Zero itself has none.
#[derive(Clone, PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct IntegerPolynomial {
    coefficients: Vec<BigInt>,
}

impl IntegerPolynomial {
    pub(crate) fn new(mut coefficients: Vec<BigInt>) -> Self {
        let leading = coefficients.iter().rposition(|coefficient| !coefficient.is_zero());
        coefficients.truncate(leading.map_or(0, |leading| leading + 1));
        IntegerPolynomial { coefficients }
    }

    pub(crate) fn coefficients(&self) -> &[BigInt] {
        &self.coefficients
    }

    pub(crate) fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    pub(crate) fn leading(&self) -> BigInt {
        self.coefficients.last().cloned().unwrap_or_default()
    }

    /// The value at 0.
    pub(crate) fn constant(&self) -> BigInt {
        self.coefficients.first().cloned().unwrap_or_default()
    }

    pub(crate) fn negated(&self) -> Self {
        IntegerPolynomial { coefficients: self.coefficients.iter().map(|coefficient| -coefficient).collect() }
    }

    pub(crate) fn derivative(&self) -> Self {
        let terms = self.coefficients.iter().enumerate().skip(1);
        IntegerPolynomial::new(terms.map(|(power, coefficient)| coefficient * power).collect())
    }

    /// Divided by the greatest common divisor of its coefficients.
    pub(crate) fn primitive(&self) -> Self {
        let content = greatest_divisor(self.coefficients.iter().collect());
        let parts = self.coefficients.iter().map(|coefficient| quotient(coefficient, &content));
        IntegerPolynomial { coefficients: parts.collect() }
    }

    /// The value at offset/2^bits, times 2^(bits n) for the degree n.
    fn value_at(&self, offset: &BigInt, bits: u64) -> BigInt {
        let coefficients = self.coefficients.iter().rev().zip(0_u64..);
        coefficients.fold(BigInt::zero(), |value, (coefficient, steps)| {
            value * offset + (coefficient << (bits * steps))
        })
    }

    /// The sign at offset · 2^exponent.
    pub(crate) fn sign_at(&self, offset: &BigInt, exponent: i64) -> Ordering {
        let bits = exponent.min(0).unsigned_abs();
        self.value_at(&(offset << exponent.max(0)), bits).cmp(&BigInt::zero())
    }

    /// x^n p(1/x), for a p that is not zero at 0.
    pub(crate) fn reversed(mut self) -> Self {
        self.coefficients.reverse();
        self
    }

    /// The exponent of a power of two above every positive root.
    ///
    /// With B = 2 max |c_i/c_n|^(1/(n-i)) over the c_i of the other sign than c_n, x >= B gives |c_i| x^i <= |c_n| x^n
    /// 2^(i-n), and the sum of these stays below |c_n| x^n (J. B. Kioustelidis, J. Comput. Appl. Math. 16 (1986)
    /// 241-244).
    pub(crate) fn root_bound(&self) -> i64 {
        let negative = self.leading().is_negative();
        let leading = self.leading().bits() as i64;
        let terms = self.coefficients.iter().enumerate();
        let opposed =
            terms.filter(|(_, coefficient)| !coefficient.is_zero() && coefficient.is_negative() != negative);
        let bounds = opposed.map(|(power, coefficient)| {
            let ratio = coefficient.bits() as i64 - leading + 1;
            Integer::div_ceil(&ratio, &((self.degree() - power) as i64))
        });
        bounds.max().map_or(0, |bound| bound + 1)
    }

    /// The quotient, if the division leaves no remainder and the quotient has integer coefficients.
    pub(crate) fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let leading = divisor.coefficients.last()?;
        let mut remainder = self.coefficients.clone();
        let mut quotient = Vec::new();
        while remainder.len() >= divisor.coefficients.len() {
            let (next, rest) = remainder.pop()?.div_rem(leading);
            if !rest.is_zero() {
                return None;
            }
            let lower = divisor.coefficients.iter().rev().skip(1);
            for (target, coefficient) in remainder.iter_mut().rev().zip(lower) {
                *target -= &next * coefficient;
            }
            quotient.push(next);
        }
        quotient.reverse();
        remainder.iter().all(Zero::is_zero).then(|| IntegerPolynomial::new(quotient))
    }
}

/// The primitive integer polynomial with the same roots as a sum of `coefficient * x^power`.
///
/// Over a common denominator, the terms share only the factors that their numerators in lowest terms share: a prime
/// factor of that denominator is missing in the term that it comes from.
pub(crate) fn from_terms(terms: &[(usize, &Rational)]) -> IntegerPolynomial {
    let denominator = common_denominator(terms.iter().map(|(_, coefficient)| *coefficient));
    let content = greatest_divisor(terms.iter().map(|(_, coefficient)| coefficient.numer()).collect());
    let degree = terms.iter().map(|(power, _)| *power).max().unwrap_or(0);
    let mut coefficients = vec![BigInt::zero(); degree + 1];
    for &(power, coefficient) in terms {
        coefficients[power] =
            quotient(coefficient.numer(), &content) * quotient(&denominator, coefficient.denom());
    }
    IntegerPolynomial::new(coefficients)
}

/// The quotient of a number and one of its divisors.
///
/// A quotient of b bits is the integer nearest to the quotient of what is left of both when all but b + 64 bits of the
/// divisor are cut off. Cutting takes less than 1 from each, which changes the quotient by less than 2^b/2^(b+63). So a
/// short quotient of long numbers, as among the denominators of decimals, needs no division of all their bits.
fn quotient(multiple: &BigInt, divisor: &BigInt) -> BigInt {
    if divisor.is_one() {
        return multiple.clone();
    }
    let bits = (multiple.bits() + 1).saturating_sub(divisor.bits());
    let excess = divisor.bits().saturating_sub(bits + 64);
    let divisor: BigInt = divisor >> excess;
    let twice: BigInt = (multiple >> excess) << 1_u32;
    (twice + &divisor).div_floor(&(divisor << 1))
}

/// The greatest common divisor; the short numbers come first, as they have few divisors.
fn greatest_divisor(mut numbers: Vec<&BigInt>) -> BigInt {
    numbers.sort_by_key(|number| number.bits());
    let mut common = BigInt::zero();
    for number in numbers {
        common = common_factor(number, &common);
        if common.is_one() {
            break;
        }
    }
    common
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[i64]) -> IntegerPolynomial {
        IntegerPolynomial::new(coefficients.iter().map(|&coefficient| coefficient.into()).collect())
    }

    #[test]
    fn division_is_exact_or_refused() {
        let product = polynomial(&[-6, 1, 1]);
        assert_eq!(product.exact_quotient(&polynomial(&[-2, 1])), Some(polynomial(&[3, 1])));
        assert_eq!(product.exact_quotient(&polynomial(&[-1, 1])), None);
        assert_eq!(product.exact_quotient(&polynomial(&[2])), None);
    }

    #[test]
    fn quotients_of_multiples_are_exact() {
        let long = BigInt::from(7).pow(500);
        for divisor in [BigInt::one(), 3.into(), long.clone(), (&long << 300) + 1, (BigInt::one() << 900) - 1]
        {
            for short in [-5, -1, 0, 1, 2, 1_000_000_007, i64::MAX] {
                assert_eq!(quotient(&(&divisor * short), &divisor), short.into());
                assert_eq!(quotient(&(&divisor * &long * short), &divisor), &long * short);
            }
        }
    }

    #[test]
    fn the_root_bound_holds() {
        assert!(polynomial(&[-1000, 0, 1]).root_bound() >= 5);
        assert!(polynomial(&[1000, -1]).root_bound() >= 10);
        assert!((1 << polynomial(&[-7, 3, -40, 1]).root_bound()) > 39);
        // Sums of terms that are all as large as the bound allows: roots of 3.1 and 10.9.
        assert!(polynomial(&[-15, -7, -3, -1, 1]).root_bound() >= 2);
        assert!(polynomial(&[-127, -31, -7, 1]).root_bound() >= 4);
    }
}
