//! Value and slope of a polynomial at a point from 1 to 2, in fixed point, by Horner's rule.
//!
//! Cargo does not optimise macros, so calls, checks and allocations take most of the time of big-integer products. Here
//! coefficients are cut at whole words and the point is 1 and a fraction of whole words, so nothing is shifted. Words of
//! a product that hardly matter for its last word are not formed, and a row of words is a loop without calls.
//!
//! **Error.** The columns of a product that are not formed lie behind the first column that is cut off; as there are
//! fewer than 2^32 words, they add up to less than 2^-31 of a unit. Cutting off the others loses less than one unit,
//! and cutting a coefficient loses less than its factor.

use num_bigint::{BigInt, Sign};
use num_traits::Signed;

/// Coefficients as signs and words, the lowest power and the lowest word first, in units of 2^-digits.
pub(crate) struct CoefficientTable {
    coefficients: Vec<(bool, Vec<u64>)>,
    /// The words of the longest coefficient.
    longest: usize,
    pub(crate) digits: i64,
}

const WORD: u64 = u64::BITS as u64;
/// This many columns of a product are formed behind its unit.
const FORMED: usize = 2;

/// The words behind the point of offset/2^bits, which is less than 1.
pub(crate) fn fraction(offset: &BigInt, bits: u64) -> Vec<u64> {
    let count = bits.div_ceil(WORD);
    let mut words = (offset << (count * WORD - bits)).magnitude().to_u64_digits();
    words.resize(count as usize, 0);
    words
}

impl CoefficientTable {
    pub(crate) fn new(coefficients: &[BigInt], digits: i64) -> Self {
        let in_words = |number: &BigInt| (number.is_negative(), number.magnitude().to_u64_digits());
        let coefficients: Vec<(bool, Vec<u64>)> = coefficients.iter().map(in_words).collect();
        let longest = coefficients.iter().map(|(_, words)| words.len()).max().unwrap_or(0);
        CoefficientTable { coefficients, longest, digits }
    }

    /// The value (order 0) or the slope (1) at 1 + fraction, and the digits of its unit, which are `digits` or up to 63
    /// more.
    pub(crate) fn derivative(&self, order: u32, fraction: &[u64], digits: i64) -> (BigInt, i64) {
        let cut = (self.digits - digits).max(0) as usize / WORD as usize;
        let room = self.longest.saturating_sub(cut) + 2;
        let mut value = Value { is_negative: false, words: vec![0; room], first: 0 };
        let mut coefficients = self.coefficients.as_slice();
        while let [left @ .., (is_negative, words)] = coefficients
            && left.len() >= order as usize
        {
            value.multiply(fraction, room);
            if let Some(words) = words.get(cut..) {
                value.add(*is_negative, words, (left.len() as u64).pow(order));
            }
            coefficients = left;
        }
        let size = integer(&value.words[value.first..]);
        let value = if value.is_negative { -size } else { size };
        (value, self.digits - (cut as u64 * WORD) as i64)
    }
}

/// An integer with its sign; there may be zeros before its first word.
struct Value {
    is_negative: bool,
    /// The value begins at `first`; the words before it are left over from a product.
    words: Vec<u64>,
    first: usize,
}

impl Value {
    /// Multiplies by 1 + fraction and cuts off what is behind the unit. The result has room for at least `room` words.
    fn multiply(&mut self, fraction: &[u64], room: usize) {
        let mut own = &self.words[self.first..];
        while let [left @ .., 0] = own {
            own = left;
        }
        let formed = fraction.len().min(FORMED);
        let mut product = vec![0; formed + room.max(own.len() + 1)];
        let sums = product.as_mut_slice();
        let mut place = 0;
        while place < fraction.len() {
            let unformed = fraction.len().saturating_sub(place + FORMED);
            if unformed < own.len() {
                let sums = &mut sums[place + unformed + formed - fraction.len()..];
                let carry = add_row(sums, &own[unformed..], fraction[place], 0);
                sums[own.len() - unformed] = carry;
            }
            place += 1;
        }
        let carry = add_row(&mut sums[formed..], own, 1, 0);
        sums[formed + own.len()] += carry;
        (self.words, self.first) = (product, formed);
    }

    /// Adds a multiple of a row. The room of a product is two words longer than a row, so nothing is carried out of the
    /// sum.
    fn add(&mut self, is_negative: bool, row: &[u64], factor: u64) {
        let words = &mut self.words[self.first..];
        if is_negative == self.is_negative {
            let mut carry = add_row(words, row, factor, 0);
            let mut rest = row.len();
            while carry != 0 && rest < words.len() {
                let (sum, exceeds) = words[rest].overflowing_add(carry);
                (words[rest], carry) = (sum, exceeds.into());
                rest += 1;
            }
        } else {
            let mut borrow = subtract_row(words, row, factor);
            let mut rest = row.len();
            while borrow != 0 && rest < words.len() {
                let (difference, exceeds) = words[rest].overflowing_sub(borrow);
                (words[rest], borrow) = (difference, exceeds.into());
                rest += 1;
            }
            if borrow != 0 {
                self.is_negative = !self.is_negative;
                negate(words);
            }
        }
    }
}

/// Turns a number of n words into 2^(64 n) minus that number.
pub(crate) fn negate(words: &mut [u64]) {
    let mut carry = true;
    for word in words {
        (*word, carry) = (!*word).overflowing_add(carry.into());
    }
}

pub(crate) fn integer(words: &[u64]) -> BigInt {
    let mut halves = Vec::with_capacity(2 * words.len());
    for word in words {
        halves.push(*word as u32);
        halves.push((word >> 32) as u32);
    }
    BigInt::new(Sign::Plus, halves)
}

/// Adds a multiple of a row to the first words of `sums`; returns what is to be added to the next.
pub(crate) fn add_row(mut sums: &mut [u64], mut row: &[u64], factor: u64, carry: u64) -> u64 {
    let (factor, mut carry) = (u128::from(factor), u128::from(carry));
    while row.len() & 3 != 0 {
        let ([s0, sums_left @ ..], [r0, row_left @ ..]) = (sums, row) else { return carry as u64 };
        let sum = u128::from(*r0).wrapping_mul(factor).wrapping_add(u128::from(*s0)).wrapping_add(carry);
        (*s0, carry) = (sum as u64, sum >> WORD);
        (sums, row) = (sums_left, row_left);
    }
    while let ([s0, s1, s2, s3, sums_left @ ..], [r0, r1, r2, r3, row_left @ ..]) = (sums, row) {
        let sum = u128::from(*r0).wrapping_mul(factor).wrapping_add(u128::from(*s0)).wrapping_add(carry);
        (*s0, carry) = (sum as u64, sum >> WORD);
        let sum = u128::from(*r1).wrapping_mul(factor).wrapping_add(u128::from(*s1)).wrapping_add(carry);
        (*s1, carry) = (sum as u64, sum >> WORD);
        let sum = u128::from(*r2).wrapping_mul(factor).wrapping_add(u128::from(*s2)).wrapping_add(carry);
        (*s2, carry) = (sum as u64, sum >> WORD);
        let sum = u128::from(*r3).wrapping_mul(factor).wrapping_add(u128::from(*s3)).wrapping_add(carry);
        (*s3, carry) = (sum as u64, sum >> WORD);
        (sums, row) = (sums_left, row_left);
    }
    carry as u64
}

/// Subtracts a multiple of a row from the first words of `sums`; returns what is to be subtracted from the next.
fn subtract_row(mut sums: &mut [u64], mut row: &[u64], factor: u64) -> u64 {
    let factor = u128::from(factor);
    let mut borrow: u128 = 0;
    while let ([s0, sums_left @ ..], [r0, row_left @ ..]) = (sums, row) {
        let product = u128::from(*r0).wrapping_mul(factor).wrapping_add(borrow);
        let (difference, is_less) = s0.overflowing_sub(product as u64);
        (*s0, borrow) = (difference, (product >> WORD) + u128::from(is_less));
        (sums, row) = (sums_left, row_left);
    }
    borrow as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::{One, Zero};

    /// Against the exact ones, with words cut off and without.
    #[test]
    fn values_and_slopes_are_as_near_as_they_say() {
        let number = |power: u32| {
            let size: BigInt = (BigInt::from(7 * power + 1) << 700) >> (power * 61 % 690);
            if power % 3 == 1 { -size } else { size }
        };
        let coefficients: Vec<BigInt> = (0..20).map(number).collect();
        let table = CoefficientTable::new(&coefficients, 800);
        for (offset, bits) in [(0_u64, 0), (1, 1), (u64::MAX, 64), (5, 300), (1 << 40 | 1, 41)] {
            for order in [0, 1] {
                let x = BigInt::from(offset) + (BigInt::one() << bits);
                let mut exact = BigInt::zero();
                for power in (order..20_u32).rev() {
                    let factor = power.pow(order);
                    exact = exact * &x + ((&coefficients[power as usize] * factor) << (bits * (19 - power)));
                }
                for digits in [800, 700, 500, 136] {
                    let (value, unit) =
                        table.derivative(order, &fraction(&offset.into(), bits.into()), digits);
                    let scale = i64::from(bits * (19 - order)) + 800 - unit;
                    let most: BigInt = BigInt::from(20 * (19_i64.pow(order) + 2)) << 20;
                    assert!(
                        ((value << scale) - &exact).magnitude() < (most << scale).magnitude(),
                        "{offset}/2^{bits}, {order}, {digits}"
                    );
                }
            }
        }
    }
}
