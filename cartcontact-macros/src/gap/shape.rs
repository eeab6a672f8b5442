//! The value of an expression: a sum of powers of r and of surfaces, and its arithmetic.
//!
//! A surface stays whole until the order of its series is known, so only expressions linear in it have a value: sums,
//! differences and multiples that do not depend on r.

use num_traits::{One, Zero};

use crate::diagnostics::Extent;
use crate::gap::coefficient::Coefficient;
use crate::gap::polynomial::Polynomial;
use crate::gap::surface::Surface;
use crate::number::Rational;

/// The most products that a coefficient is a sum of: far more than a gap needs, and each further one takes as long to
/// add as all before it.
const MAXIMUM_PRODUCTS: usize = 256;

#[derive(Clone, Default)]
pub(crate) struct Shape {
    pub(crate) powers: Polynomial,
    /// No two are alike, and no weight is zero.
    pub(crate) surfaces: Vec<Surface>,
}

impl From<Polynomial> for Shape {
    fn from(powers: Polynomial) -> Self {
        Shape { powers, surfaces: Vec::new() }
    }
}

impl From<Surface> for Shape {
    fn from(surface: Surface) -> Self {
        Shape { powers: Polynomial::default(), surfaces: vec![surface] }
    }
}

impl Shape {
    /// The coefficient, if there is neither a power of r nor a surface.
    pub(crate) fn as_coefficient(&self) -> Option<Coefficient> {
        self.powers.as_coefficient().filter(|_| self.surfaces.is_empty())
    }

    /// The rule that is broken if a coefficient is too long a sum.
    pub(crate) fn check_length(&self) -> Result<(), &'static str> {
        let coefficients = self.powers.terms().iter().map(|(_, monomial)| &monomial.coefficient);
        let mut all = coefficients.chain(self.surfaces.iter().map(|surface| &surface.weight));
        if all.all(|coefficient| coefficient.products.len() <= MAXIMUM_PRODUCTS) {
            Ok(())
        } else {
            Err(TOO_LONG)
        }
    }

    /// Gives a single term the place of the whole expression that makes it.
    pub(crate) fn located(self, extent: Extent) -> Self {
        let Shape { powers, mut surfaces } = self;
        if let ([only], []) = (surfaces.as_mut_slice(), powers.terms()) {
            only.extent = extent;
        }
        Shape { powers: powers.located(extent), surfaces }
    }

    /// Gives all powers the place of the expression that they were multiplied out from.
    pub(crate) fn spread(self, extent: Extent) -> Self {
        Shape { powers: self.powers.spread(extent), ..self }
    }

    pub(crate) fn add(&mut self, other: Shape) {
        self.powers.add(other.powers);
        for surface in other.surfaces {
            match self.surfaces.iter_mut().find(|own| own.is_like(&surface)) {
                Some(own) => own.weight = own.weight.add(&surface.weight),
                None => self.surfaces.push(surface),
            }
        }
        self.surfaces.retain(|surface| !surface.weight.is_zero());
    }

    pub(crate) fn negated(self) -> Self {
        let minus = Coefficient::constant(-Rational::one());
        Shape { powers: self.powers.negated(), surfaces: weighted(self.surfaces, &minus) }
    }

    pub(crate) fn multiply(&self, other: &Shape) -> Result<Shape, &'static str> {
        let powers = self.powers.multiply(&other.powers)?;
        let surfaces = match (self.surfaces.as_slice(), other.surfaces.as_slice()) {
            ([], []) => Vec::new(),
            (surfaces, []) => weighted(surfaces.to_vec(), &other.as_coefficient().ok_or(NOT_LINEAR)?),
            ([], surfaces) => weighted(surfaces.to_vec(), &self.as_coefficient().ok_or(NOT_LINEAR)?),
            _ => return Err(NOT_LINEAR),
        };
        Ok(Shape { powers, surfaces })
    }

    pub(crate) fn power(&self, exponent: &Rational) -> Result<Shape, &'static str> {
        let Some(first) = self.surfaces.first() else { return self.powers.power(exponent).map(Into::into) };
        if exponent.is_zero() {
            return Ok(Polynomial::one(first.extent).into());
        }
        if exponent.is_one() {
            return Ok(self.clone());
        }
        Err(
            "a surface can neither be raised to a power nor be a divisor; add it, subtract it, or multiply it by a \
             number",
        )
    }
}

const TOO_LONG: &str = "a coefficient may be a sum of at most 256 terms; declare a field for it, and compute its value \
                        in the program";
const NOT_LINEAR: &str = "a surface may be multiplied only by what does not depend on r; a gap is a sum of surfaces \
                          and powers of r";

fn weighted(surfaces: Vec<Surface>, factor: &Coefficient) -> Vec<Surface> {
    let surfaces = surfaces.into_iter();
    let surfaces = surfaces.map(|surface| Surface { weight: surface.weight.multiply(factor), ..surface });
    surfaces.filter(|surface| !surface.weight.is_zero()).collect()
}
