//! The radii that a geometry is declared for.

use num_traits::One;

use crate::gap::coefficient::{Coefficient, Sign};
use crate::number::{self, Rational};

/// The radii that the geometry is declared for.
#[derive(Clone)]
pub(crate) enum Range {
    Unbounded,
    /// Up to the exact value of an `f64`.
    Limited(Rational),
    /// Up to a radius that depends on the fields.
    Symbolic(Coefficient),
}

impl Range {
    /// The range up to the value of `max_radius`, or why that is no range.
    pub(crate) fn of(value: Coefficient) -> Result<Self, &'static str> {
        let Some(radius) = value.as_constant() else {
            return match value.certain_sign() {
                Some(Sign::NotPositive) => Err(NOT_POSITIVE),
                _ if value.is_representable() => Ok(Self::Symbolic(value)),
                _ => Err(UNREPRESENTABLE),
            };
        };
        if !radius.is_positive() {
            return Err(NOT_POSITIVE);
        }
        let unrepresentable = if radius < Rational::one() { TOO_SMALL } else { UNREPRESENTABLE };
        number::nearest(&radius).and_then(Rational::from_float).map(Self::Limited).ok_or(unrepresentable)
    }

    pub(crate) fn end(&self) -> Option<Coefficient> {
        match self {
            Self::Unbounded => None,
            Self::Limited(radius) => Some(Coefficient::constant(radius.clone())),
            Self::Symbolic(radius) => Some(radius.clone()),
        }
    }
}

const NOT_POSITIVE: &str = "max_radius must be greater than 0; leave it out if the gap has no end";
const TOO_SMALL: &str =
    "max_radius is too small for an `f64`; use a unit of length that brings it nearer to 1";
const UNREPRESENTABLE: &str = "max_radius does not fit into an `f64`; leave it out if the gap has no end";
