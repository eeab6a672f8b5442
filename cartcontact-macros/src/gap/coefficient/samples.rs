//! Coefficients for tests.

#![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use quote::format_ident;

use super::Coefficient;
use crate::number::fraction;

pub(crate) fn field(name: &str) -> Coefficient {
    Coefficient::field(format_ident!("{name}"))
}

pub(crate) fn power(of: &Coefficient, numerator: i64, denominator: i64) -> Coefficient {
    of.power(&fraction(numerator, denominator)).unwrap()
}

pub(crate) fn inverse(of: &Coefficient) -> Coefficient {
    power(of, -1, 1)
}

pub(crate) fn number(numerator: i64, denominator: i64) -> Coefficient {
    Coefficient::constant(fraction(numerator, denominator))
}
