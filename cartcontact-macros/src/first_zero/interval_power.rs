//! Powers of numbers that are known to some digits.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::One;

/// A positive number between lower · 2^exponent and upper · 2^exponent.
pub(crate) struct Interval {
    lower: BigInt,
    upper: BigInt,
    exponent: i64,
    /// The bits that are kept of every number: a power to 1000 loses 12 of them, one to a million 22.
    bits: u64,
}

impl Interval {
    /// offset · 2^exponent, cut to this many bits.
    pub(crate) fn around(offset: &BigInt, exponent: i64, bits: u64) -> Self {
        Interval { lower: offset.clone(), upper: offset.clone(), exponent, bits }.shortened()
    }

    /// The power of the number by binary powering; all bits but the leading ones are cut off on the way.
    pub(crate) fn power(&self, power: u32) -> Self {
        let mut product = Interval::around(&BigInt::one(), 0, self.bits);
        for bit in (0..u32::BITS - power.leading_zeros()).rev() {
            product = product.times(&product);
            if power >> bit & 1 == 1 {
                product = product.times(self);
            }
        }
        product
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let (lower, upper) = (&self.lower * &other.lower, &self.upper * &other.upper);
        Interval { lower, upper, exponent: self.exponent + other.exponent, bits: self.bits }.shortened()
    }

    /// Which of two numbers is the larger, if their intervals tell.
    pub(crate) fn compare(&self, other: &Self) -> Option<Ordering> {
        let exponent = self.exponent.min(other.exponent);
        let [lower, upper] = [&self.lower, &self.upper].map(|end| end << (self.exponent - exponent));
        if lower > (&other.upper << (other.exponent - exponent)) {
            Some(Ordering::Greater)
        } else {
            (upper < (&other.lower << (other.exponent - exponent))).then_some(Ordering::Less)
        }
    }

    fn shortened(self) -> Self {
        let excess = self.upper.bits().saturating_sub(self.bits);
        if excess == 0 {
            return self;
        }
        Interval {
            lower: self.lower >> excess,
            upper: (self.upper >> excess) + 1,
            exponent: self.exponent + excess as i64,
            bits: self.bits,
        }
    }
}

#[cfg(test)]
mod tests {
    use num_traits::Pow;

    use super::*;

    #[test]
    fn a_power_lies_between_its_bounds() {
        for (number, power) in
            [(3_u32, 7), (12_345, 1000), (4_000_000_001, 999), (3, 1_023_999), (1, 1000), (7, 0)]
        {
            let Interval { lower, upper, exponent, .. } =
                Interval::around(&number.into(), -5, 192).power(power);
            let exact: BigInt = Pow::pow(BigInt::from(number), power);
            let shift = exponent + 5 * i64::from(power);
            assert!(shift >= 0, "{number}^{power}");
            assert!(&lower << shift <= exact && exact <= &upper << shift, "{number}^{power}");
            assert!((upper - &lower) << 160 <= lower, "{number}^{power}");
        }
    }
}
