//! Coefficients for tests.

#![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use super::Coefficient;
use crate::number::fraction;

pub(crate) fn power(of: &Coefficient, numerator: i64, denominator: i64) -> Coefficient {
    of.power(&fraction(numerator, denominator)).unwrap()
}

pub(crate) fn number(numerator: i64, denominator: i64) -> Coefficient {
    Coefficient::constant(fraction(numerator, denominator))
}
