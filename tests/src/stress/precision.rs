//! The two number formats of the campaign.

use cartcontact::{GapProfile, Scalar};

use crate::budget::Allowance;
use crate::profiles::Case;

/// A format with the ends of its range.
pub trait Precision: Scalar {
    /// The distance from 1 to the next number.
    const EPSILON: f64;
    /// The smallest normal number.
    const LEAST: f64;
    /// The largest number.
    const MOST: f64;
    /// Decades that loads, moduli and lengths may span on either side of 1.
    const DECADES: f64;

    /// The number whose bits are the leading ones of a word.
    fn from_leading_bits(word: u64) -> Self;

    /// The exact number 2^k.
    fn power_of_two(k: i32) -> Self {
        Self::constant(2_f64.powi(k))
    }

    /// The generated solver of a geometry.
    fn solver(case: &Case) -> &'static dyn GapProfile<Self>;

    /// The error that the table allows, in units of ε.
    fn allowed(allowance: Allowance) -> f64;
}

impl Precision for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const LEAST: f64 = f64::MIN_POSITIVE;
    const MOST: f64 = f64::MAX;
    const DECADES: f64 = 150.0;

    fn from_leading_bits(word: u64) -> Self {
        f64::from_bits(word)
    }

    fn solver(case: &Case) -> &'static dyn GapProfile<Self> {
        case.double
    }

    fn allowed(allowance: Allowance) -> f64 {
        allowance.double
    }
}

impl Precision for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const LEAST: f64 = f32::MIN_POSITIVE as f64;
    const MOST: f64 = f32::MAX as f64;
    const DECADES: f64 = 18.0;

    fn from_leading_bits(word: u64) -> Self {
        f32::from_bits((word >> 32) as u32)
    }

    fn solver(case: &Case) -> &'static dyn GapProfile<Self> {
        case.single
    }

    fn allowed(allowance: Allowance) -> f64 {
        allowance.single
    }
}
