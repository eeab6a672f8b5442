//! A power of a positive number, compared with powers of others.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Pow};

use crate::first_zero::interval_power::Interval;
use crate::number::Rational;

/// The leading bits that are compared first; they nearly always decide.
const LEADING_BITS: u64 = 192;

/// base^exponent, computed to no more bits than a comparison needs.
pub(crate) struct ComparedPower<'a> {
    base: &'a Rational,
    exponent: u32,
}

impl<'a> ComparedPower<'a> {
    pub(crate) fn of(base: &'a Rational, exponent: u32) -> Self {
        ComparedPower { base, exponent }
    }

    /// An upper bound of the bits of its numerator and denominator together.
    pub(crate) fn bits(&self) -> u64 {
        let bits =
            |number: &BigInt| if number.is_one() { 1 } else { number.bits() * u64::from(self.exponent) };
        [self.base.numer(), self.base.denom()].map(bits).iter().sum()
    }

    pub(crate) fn exact(&self) -> Rational {
        self.base.pow(self.exponent as i32)
    }

    /// Compares (offset · 2^exponent)^power with this one.
    ///
    /// Each round compares four times as many bits, until they decide or all are compared.
    pub(crate) fn compare_to(&self, (offset, exponent): (&BigInt, i64), power: u32) -> Ordering {
        let most = self.bits().max(offset.bits() * u64::from(power));
        let mut bits = LEADING_BITS;
        while bits < most {
            let of = |number: &BigInt, exponent: i64, power: u32| {
                Interval::around(number, exponent, bits).power(power)
            };
            let raised = of(offset, exponent, power).times(&of(self.base.denom(), 0, self.exponent));
            if let Some(ordering) = raised.compare(&of(self.base.numer(), 0, self.exponent)) {
                return ordering;
            }
            bits *= 4;
        }
        let (exact, exponent) = (self.exact(), exponent * i64::from(power));
        let (up, down) = (exponent.max(0) as u64, exponent.min(0).unsigned_abs());
        let raised: BigInt = Pow::pow(offset, power);
        ((raised * exact.denom()) << up).cmp(&(exact.numer() << down))
    }
}
