//! Sums of powers of r with exact coefficients and any rational exponents, and their arithmetic.
//!
//! They stand between the syntax and the gap: nothing is required of the exponents yet, so `(r^3 + r^5)/r` passes
//! through.

use num_bigint::Sign;
use num_traits::{ToPrimitive, Zero};

use crate::diagnostics::Extent;
use crate::gap::coefficient::Coefficient;
use crate::gap::like_terms::{LikeTerms, Summable};
use crate::number::{self, Rational, integer};

/// Bounds the work of multiplying out, far above what a profile needs.
const MAXIMUM_PRODUCTS: usize = 1 << 14;
/// The same for coefficients that depend on fields: sums in them are not multiplied out, so they grow several times
/// over with each square. Coefficients up to this size take about as long as this number of terms.
const MAXIMUM_SIZE: usize = 1 << 10;
/// Beyond this power, a sum that begins with r^(1/4) or a higher power has no power that a gap may have.
const HIGHEST_POWER_OF_A_SUM: u32 = 4096;

/// Terms by exponent; no coefficient is zero.
#[derive(Clone, Default)]
pub(crate) struct Polynomial {
    terms: LikeTerms<Rational, Monomial>,
}

#[derive(Clone)]
pub(crate) struct Monomial {
    pub(crate) coefficient: Coefficient,
    /// Where the first contribution to it was written, or the one that determined its sign.
    pub(crate) extent: Extent,
}

impl Summable for Monomial {
    fn add(&mut self, other: Self) {
        let sum = self.coefficient.add(&other.coefficient);
        if sum.certain_sign() != self.coefficient.certain_sign() {
            self.extent = other.extent;
        }
        self.coefficient = sum;
    }

    fn vanishes(&self) -> bool {
        self.coefficient.is_zero()
    }
}

impl Polynomial {
    pub(crate) fn new(coefficient: Coefficient, exponent: Rational, extent: Extent) -> Self {
        Polynomial { terms: LikeTerms::of(exponent, Monomial { coefficient, extent }) }
    }

    pub(crate) fn constant(coefficient: Coefficient, extent: Extent) -> Self {
        Polynomial::new(coefficient, Rational::zero(), extent)
    }

    pub(crate) fn one(extent: Extent) -> Self {
        Polynomial::constant(Coefficient::constant(integer(1)), extent)
    }

    pub(crate) fn terms(&self) -> &[(Rational, Monomial)] {
        &self.terms
    }

    pub(crate) fn into_terms(self) -> impl Iterator<Item = (Rational, Monomial)> {
        self.terms.into_iter()
    }

    /// The coefficient, if there is no power of r.
    pub(crate) fn as_coefficient(&self) -> Option<Coefficient> {
        match self.terms() {
            [] => Some(Coefficient::constant(Rational::zero())),
            [(exponent, monomial)] if exponent.is_zero() => Some(monomial.coefficient.clone()),
            _ => None,
        }
    }

    /// Gives a single term the place of the whole expression that makes it.
    pub(crate) fn located(self, extent: Extent) -> Self {
        if self.terms.len() == 1 { self.spread(extent) } else { self }
    }

    /// Gives all terms the place of the expression that they were multiplied out from.
    pub(crate) fn spread(mut self, extent: Extent) -> Self {
        self.terms.map(|monomial| monomial.extent = extent);
        self
    }

    pub(crate) fn add(&mut self, other: Polynomial) {
        for (exponent, monomial) in other.terms {
            self.accumulate(exponent, monomial);
        }
    }

    pub(crate) fn negated(mut self) -> Self {
        self.terms.map(|monomial| monomial.coefficient = monomial.coefficient.negated());
        self
    }

    pub(crate) fn multiply(&self, other: &Polynomial) -> Result<Polynomial, &'static str> {
        if self.terms.len() < other.terms.len() {
            return other.multiply(self);
        }
        if self.terms.len().saturating_mul(other.terms.len()) > MAXIMUM_PRODUCTS {
            return Err("this multiplies out to too many terms; write a gap of at most 256 terms");
        }
        // Each coefficient occurs in as many products as the other sum has terms.
        if self.terms.len() * other.size() + other.terms.len() * self.size() > MAXIMUM_SIZE {
            return Err(
                "this multiplies out to too long an expression in the fields, which every evaluation would have to \
                        compute; declare a field for each coefficient of the gap, and compute its value in the program",
            );
        }
        let mut product = Polynomial::default();
        for (exponent, monomial) in self.terms() {
            for (other_exponent, other_monomial) in other.terms() {
                let coefficient = monomial.coefficient.multiply(&other_monomial.coefficient);
                let monomial = Monomial { coefficient, extent: monomial.extent };
                product.accumulate(exponent + other_exponent, monomial);
            }
        }
        Ok(product)
    }

    pub(crate) fn power(&self, exponent: &Rational) -> Result<Polynomial, &'static str> {
        if let [(own, monomial)] = self.terms() {
            let coefficient = monomial.coefficient.power(exponent)?;
            return Ok(Polynomial::new(coefficient, own * exponent, monomial.extent));
        }
        if self.terms.is_empty() {
            return match exponent.numer().sign() {
                Sign::Plus => Ok(Polynomial::default()),
                Sign::NoSign => Err("0^0 has no value; write the number that is meant"),
                Sign::Minus => Err("a divisor must not be zero; write another, or remove the division"),
            };
        }
        if exponent.is_negative() || !exponent.is_integer() {
            return Err(
                "a gap must be a sum of powers of r; a sum that contains r can neither be a divisor nor have \
                        a root taken, and a round surface is written `sphere(R)` or `conic(R, k)`",
            );
        }
        let exponent = exponent.to_u32().filter(|exponent| *exponent <= HIGHEST_POWER_OF_A_SUM);
        let exponent = exponent.ok_or("a sum may be raised to powers up to 4096; write a lower one")?;
        match self.common_denominator() {
            Some(denominator) => {
                for (_, monomial) in self.terms() {
                    monomial.coefficient.power(&integer(exponent))?;
                }
                let power = self.scaled(&denominator).repeated(exponent)?;
                Ok(power.scaled(&denominator.pow(exponent as i32).recip()))
            }
            None => self.repeated(exponent),
        }
    }

    /// The common denominator of the coefficients, if all of them are numbers. Integers need no search for common
    /// factors, which otherwise takes most of the time of multiplying out.
    fn common_denominator(&self) -> Option<Rational> {
        let numbers = self.terms().iter().map(|(_, monomial)| monomial.coefficient.as_constant());
        let numbers: Vec<_> = numbers.collect::<Option<_>>()?;
        Some(integer(number::common_denominator(numbers.iter())))
    }

    fn scaled(&self, factor: &Rational) -> Polynomial {
        let mut scaled = self.clone();
        scaled.terms.map(|monomial| monomial.coefficient = monomial.coefficient.scaled(factor));
        scaled
    }

    /// By squaring, from the leading bit of the exponent down; 0 has none.
    fn repeated(&self, exponent: u32) -> Result<Polynomial, &'static str> {
        let mut result = self.clone();
        let Some(leading) = exponent.checked_ilog2() else {
            return Ok(self.terms().first().map_or(result, |(_, first)| Polynomial::one(first.extent)));
        };
        for bit in (0..leading).rev() {
            result = result.multiply(&result)?;
            if (exponent >> bit) & 1 == 1 {
                result = result.multiply(self)?;
            }
        }
        Ok(result)
    }

    /// The number of fields in its coefficients, each counted as often as it is written.
    fn size(&self) -> usize {
        self.terms().iter().map(|(_, monomial)| monomial.coefficient.size()).sum()
    }

    pub(crate) fn accumulate(&mut self, exponent: Rational, monomial: Monomial) {
        self.terms.add(exponent, monomial);
    }
}
