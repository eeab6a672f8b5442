//! Sums of powers of r with exact coefficients and any rational exponents, and their arithmetic.
//!
//! Between the syntax and the gap: nothing is required of the exponents yet, so `(r^3 + r^5)/r` passes through.

use std::collections::BTreeMap;

use num_traits::{ToPrimitive, Zero};

use crate::diagnostics::Extent;
use crate::gap::coefficient::Coefficient;
use crate::number::Rational;

/// Bounds the work of multiplying out, far above what a profile needs.
const MAXIMUM_PRODUCTS: usize = 1 << 14;

/// Terms by exponent; no coefficient is zero.
#[derive(Clone, Debug, Default)]
pub(crate) struct Polynomial {
    terms: BTreeMap<Rational, Monomial>,
}

#[derive(Clone, Debug)]
pub(crate) struct Monomial {
    pub(crate) coefficient: Coefficient,
    /// Where the first contribution to it was written.
    pub(crate) extent: Extent,
}

impl Polynomial {
    pub(crate) fn new(coefficient: Coefficient, exponent: Rational, extent: Extent) -> Self {
        let mut polynomial = Polynomial::default();
        polynomial.accumulate(exponent, Monomial { coefficient, extent });
        polynomial
    }

    pub(crate) fn constant(coefficient: Coefficient, extent: Extent) -> Self {
        Polynomial::new(coefficient, Rational::zero(), extent)
    }

    pub(crate) fn terms(&self) -> impl Iterator<Item = (&Rational, &Monomial)> {
        self.terms.iter()
    }

    pub(crate) fn into_terms(self) -> impl Iterator<Item = (Rational, Monomial)> {
        self.terms.into_iter()
    }

    /// The coefficient, if there is no power of r.
    pub(crate) fn as_coefficient(&self) -> Option<Coefficient> {
        match self.single_term() {
            Some((exponent, monomial)) => exponent.is_zero().then(|| monomial.coefficient.clone()),
            None => self.terms.is_empty().then(|| Coefficient::constant(Rational::zero())),
        }
    }

    /// A single term is where the whole expression that makes it is written.
    pub(crate) fn located(mut self, extent: Extent) -> Self {
        if self.terms.len() == 1 {
            self.terms.values_mut().for_each(|monomial| monomial.extent = extent);
        }
        self
    }

    pub(crate) fn add(&mut self, other: Polynomial) {
        for (exponent, monomial) in other.terms {
            self.accumulate(exponent, monomial);
        }
    }

    pub(crate) fn negated(mut self) -> Self {
        for monomial in self.terms.values_mut() {
            monomial.coefficient = monomial.coefficient.negated();
        }
        self
    }

    pub(crate) fn multiply(&self, other: &Polynomial) -> Result<Polynomial, &'static str> {
        if self.terms.len() < other.terms.len() {
            return other.multiply(self);
        }
        if self.terms.len().saturating_mul(other.terms.len()) > MAXIMUM_PRODUCTS {
            return Err("this multiplies out to too many terms; write a gap of at most 256 terms");
        }
        let mut product = Polynomial::default();
        for (exponent, monomial) in &self.terms {
            for (other_exponent, other_monomial) in &other.terms {
                let coefficient = monomial.coefficient.multiply(&other_monomial.coefficient);
                let monomial = Monomial { coefficient, extent: monomial.extent };
                product.accumulate(exponent + other_exponent, monomial);
            }
        }
        Ok(product)
    }

    pub(crate) fn power(&self, exponent: &Rational) -> Result<Polynomial, &'static str> {
        if let Some((own, monomial)) = self.single_term() {
            let coefficient = monomial.coefficient.power(exponent)?;
            return Ok(Polynomial::new(coefficient, own * exponent, monomial.extent));
        }
        if self.terms.is_empty() {
            return match exponent.is_positive() {
                true => Ok(Polynomial::default()),
                false => Err("a divisor must not be zero; this expression cancels to zero"),
            };
        }
        if exponent.is_negative() || !exponent.is_integer() {
            return Err(
                "a gap must be a sum of powers of r; a sum that contains r can neither be a divisor nor have \
                        a root taken, and a round surface is written `sphere(R)` or `conic(R, k)`",
            );
        }
        let exponent = exponent.to_u32().filter(|exponent| *exponent <= 4096);
        self.repeated(exponent.ok_or("a sum may be raised to powers up to 4096")?)
    }

    /// By squaring, from the leading bit of the exponent down.
    fn repeated(&self, exponent: u32) -> Result<Polynomial, &'static str> {
        let mut result = self.clone();
        for bit in (0..exponent.checked_ilog2().unwrap_or(0)).rev() {
            result = result.multiply(&result)?;
            if (exponent >> bit) & 1 == 1 {
                result = result.multiply(self)?;
            }
        }
        Ok(result)
    }

    fn single_term(&self) -> Option<(&Rational, &Monomial)> {
        self.terms.iter().next().filter(|_| self.terms.len() == 1)
    }

    pub(crate) fn accumulate(&mut self, exponent: Rational, monomial: Monomial) {
        let sum = match self.terms.remove(&exponent) {
            Some(own) => Monomial { coefficient: own.coefficient.add(&monomial.coefficient), ..own },
            None => monomial,
        };
        if !sum.coefficient.is_zero() {
            self.terms.insert(exponent, sum);
        }
    }
}
