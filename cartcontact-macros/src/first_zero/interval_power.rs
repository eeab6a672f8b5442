//! Powers of numbers that are known to some digits.

use num_bigint::BigInt;
use num_traits::One;

/// A positive number between lower · 2^exponent and upper · 2^exponent.
pub(crate) struct Interval {
    pub(crate) lower: BigInt,
    pub(crate) upper: BigInt,
    pub(crate) exponent: i64,
}

/// The bits that are kept of every number. A power to 1000 loses 20 of them, and the rest nearly always decide how it
/// compares.
const BITS: u64 = 192;

impl Interval {
    /// offset · 2^exponent, cut to so many bits that it is quick to compute with.
    pub(crate) fn around(offset: &BigInt, exponent: i64) -> Self {
        Interval { lower: offset.clone(), upper: offset.clone(), exponent }.shortened()
    }

    /// The power of the number by binary powering; all bits but the leading ones are cut off on the way.
    pub(crate) fn power(&self, power: u32) -> Self {
        let mut product = Interval { lower: BigInt::one(), upper: BigInt::one(), exponent: 0 };
        for bit in (0..u32::BITS - power.leading_zeros()).rev() {
            product = product.times(&product);
            if power >> bit & 1 == 1 {
                product = product.times(self);
            }
        }
        product
    }

    fn times(&self, other: &Self) -> Self {
        let (lower, upper) = (&self.lower * &other.lower, &self.upper * &other.upper);
        Interval { lower, upper, exponent: self.exponent + other.exponent }.shortened()
    }

    fn shortened(self) -> Self {
        let excess = self.upper.bits().saturating_sub(BITS);
        if excess == 0 {
            return self;
        }
        Interval {
            lower: self.lower >> excess,
            upper: (self.upper >> excess) + 1,
            exponent: self.exponent + excess as i64,
        }
    }
}

#[cfg(test)]
mod tests {
    use num_traits::Pow;

    use super::*;

    #[test]
    fn a_power_lies_between_its_bounds() {
        for (number, power) in [(3_u32, 7), (12_345, 1000), (4_000_000_001, 999), (1, 1000), (7, 0)] {
            let Interval { lower, upper, exponent } = Interval::around(&number.into(), -5).power(power);
            let exact: BigInt = Pow::pow(BigInt::from(number), power);
            let shift = exponent + 5 * i64::from(power);
            assert!(shift >= 0, "{number}^{power}");
            assert!(&lower << shift <= exact && exact <= &upper << shift, "{number}^{power}");
            assert!((upper - &lower) << 160 <= lower, "{number}^{power}");
        }
    }
}
