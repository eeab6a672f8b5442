//! Fixed-point numbers of any length, and the one thing that is done with many of them: the triangle of sums.
//!
//! Every row of the triangle holds the sums of neighbours in the row before,
//!
//! ```text
//! v0          v1          v2
//!    v0+v1       v1+v2
//!       v0+2v1+v2
//! ```
//!
//! and its left and right edges are Σ_m C(r, m) v_m and Σ_m C(n−j, m) v_{j+m}. Taylor shifts, the change to
//! Bernstein's basis and de Casteljau's division of an interval are all this.
//!
//! Cargo does not optimise macros, so it is calls that take the time, and the arithmetic of big integers is made of
//! them. Here digits of the same rank stand side by side, a sum is one addition of machine numbers, and carries wait
//! for sixty rows.

use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, Zero};

/// Numbers in digits of 64 bits; all of a number's digits are from 0 to 2^64 but the highest, which has its sign.
#[derive(Clone)]
pub(crate) struct Numbers {
    /// The digits of all numbers by rank, the lowest first; there is one rank at least.
    ranks: Vec<Vec<i128>>,
}

const DIGIT: u32 = 64;
const MASK: i128 = (1 << DIGIT) - 1;
/// A digit of 64 bits stays below 2^127 in so many rows.
const ROWS_WITHOUT_CARRY: usize = 60;
/// What a highest digit may have before the rows of a triangle: they add one bit each.
const HIGHEST_BITS: u32 = 62;

impl Numbers {
    pub(crate) fn new(values: &[BigInt]) -> Self {
        let longest = values.iter().map(BigInt::bits).max().unwrap_or(0);
        let count = (longest + u64::from(DIGIT - HIGHEST_BITS)) / u64::from(DIGIT) + 1;
        let mut ranks = vec![vec![0; values.len()]; count as usize];
        for (index, value) in values.iter().enumerate() {
            let sign = if value.is_negative() { -1 } else { 1 };
            for (rank, digit) in ranks.iter_mut().zip(value.iter_u64_digits()) {
                rank[index] = sign * i128::from(digit);
            }
        }
        let mut numbers = Numbers { ranks };
        numbers.carry();
        numbers
    }

    pub(crate) fn len(&self) -> usize {
        self.ranks.first().map_or(0, Vec::len)
    }

    pub(crate) fn value(&self, index: usize) -> BigInt {
        let Some((highest, lower)) = self.ranks.split_last() else { return BigInt::zero() };
        let halves = lower.iter().flat_map(|rank| [rank[index] as u32, (rank[index] >> 32) as u32]);
        (BigInt::from(highest[index]) << (lower.len() * DIGIT as usize))
            + BigInt::new(Sign::Plus, halves.collect())
    }

    pub(crate) fn values(&self) -> Vec<BigInt> {
        (0..self.len()).map(|index| self.value(index)).collect()
    }

    /// The sign of a number that is less than `error` units from the true one, if they must agree.
    pub(crate) fn sign(&self, index: usize, error: i128) -> Option<Ordering> {
        let mut leading: i128 = 0;
        for rank in self.ranks.iter().rev() {
            // All lower digits are less than one unit of it, and so is the error.
            if leading.abs() >> 60 != 0 {
                break;
            }
            leading = (leading << DIGIT) + rank[index];
        }
        (leading.abs() >= error).then(|| leading.cmp(&0))
    }

    /// The left and the right edge of the triangle of sums.
    pub(crate) fn edges(mut self) -> [Numbers; 2] {
        let count = self.len();
        self.make_room(count.saturating_sub(1));
        let mut left = vec![Vec::with_capacity(count); self.ranks.len()];
        for row in 0..count {
            if row % ROWS_WITHOUT_CARRY == ROWS_WITHOUT_CARRY - 1 {
                self.carry();
            }
            for (rank, left) in self.ranks.iter_mut().zip(&mut left) {
                left.push(rank[0]);
                add_neighbours(&mut rank[..count - row]);
            }
        }
        let mut left = Numbers { ranks: left };
        left.carry();
        self.carry();
        [left, self]
    }

    /// Every number times 2^-steps, rounded down.
    pub(crate) fn shifted_down(&self, steps: impl Fn(usize) -> usize) -> Numbers {
        let Some((highest, lower)) = self.ranks.split_last() else { return self.clone() };
        let count = self.len();
        let mut ranks = vec![vec![0; count]; self.ranks.len()];
        for index in 0..count {
            let (ranks_down, bits) = (steps(index) / DIGIT as usize, steps(index) as u32 % DIGIT);
            let digit = |rank: usize| match lower.get(rank) {
                Some(lower) => lower[index],
                None => (highest[index] >> ((rank - lower.len()) * DIGIT as usize).min(127)) & MASK,
            };
            let mut here = digit(ranks_down);
            for (rank, target) in ranks.iter_mut().enumerate() {
                let above = digit(rank + ranks_down + 1);
                target[index] = ((here >> bits) | (above << (DIGIT - bits))) & MASK;
                here = above;
            }
            if let Some(last) = ranks.last_mut() {
                last[index] = highest[index] >> steps(index).min(127);
            }
        }
        let mut shifted = Numbers { ranks };
        shifted.trim();
        shifted
    }

    /// v_i − 2 v_{i+1} + v_{i+2} for all i.
    pub(crate) fn second_differences(&self) -> Numbers {
        let difference = |three: &[i128]| match three {
            [left, middle, right] => left - 2 * middle + right,
            _ => 0,
        };
        let ranks = self.ranks.iter().map(|rank| rank.windows(3).map(difference).collect());
        let mut differences = Numbers { ranks: ranks.collect() };
        differences.carry();
        differences
    }

    fn carry(&mut self) {
        for rank in 1..self.ranks.len() {
            if let ([.., lower], [upper, ..]) = self.ranks.split_at_mut(rank) {
                for (lower, upper) in lower.iter_mut().zip(upper) {
                    *upper += *lower >> DIGIT;
                    *lower &= MASK;
                }
            }
        }
    }

    /// Adds ranks until as many rows of a triangle cannot exceed the highest.
    fn make_room(&mut self, rows: usize) {
        let missing = (rows as u32 + HIGHEST_BITS).saturating_sub(i128::BITS - 2);
        for _ in 0..missing.div_ceil(DIGIT) {
            self.ranks.push(vec![0; self.len()]);
        }
        self.carry();
    }

    /// Removes ranks that only repeat signs.
    fn trim(&mut self) {
        while let [.., lower, upper] = self.ranks.as_mut_slice()
            && lower
                .iter()
                .zip(upper.iter())
                .all(|(lower, upper)| matches!((lower >> HIGHEST_BITS, upper), (0, 0) | (3, -1)))
        {
            for (lower, upper) in lower.iter_mut().zip(upper) {
                *lower += *upper << DIGIT;
            }
            self.ranks.pop();
        }
    }
}

/// Adds to every number the one behind it. An index costs less than an iterator where nothing is optimised.
fn add_neighbours(numbers: &mut [i128]) {
    let mut next = 1;
    while next < numbers.len() {
        numbers[next - 1] += numbers[next];
        next += 1;
    }
}

/// C(n, 0), C(n, 1), …, C(n, n).
pub(crate) fn binomials(n: usize) -> Vec<BigInt> {
    let next =
        |(power, last): &(usize, BigInt)| (*power < n).then(|| (power + 1, last * (n - power) / (power + 1)));
    core::iter::successors(Some((0, BigInt::one())), next).map(|(_, value)| value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers() -> Vec<BigInt> {
        let long = BigInt::from(7) << 200;
        let power: BigInt = BigInt::one() << 128;
        let values = [3.into(), -&long, long + 1, BigInt::from(-1), -power, 0.into()];
        values.into_iter().cycle().take(150).collect()
    }

    #[test]
    fn numbers_are_kept() {
        assert_eq!(Numbers::new(&numbers()).values(), numbers());
        assert_eq!(Numbers::new(&numbers()).shifted_down(|_| 0).values(), numbers());
    }

    #[test]
    fn edges_are_sums_with_binomials() {
        for count in [1, 2, 7, 64, 65, 150] {
            let values = &numbers()[..count];
            let [left, right] = Numbers::new(values).edges();
            for index in 0..count {
                let sum = |from: usize, n: usize| -> BigInt {
                    binomials(n).iter().zip(&values[from..]).map(|(binomial, value)| binomial * value).sum()
                };
                assert_eq!(left.value(index), sum(0, index));
                assert_eq!(right.value(index), sum(index, count - 1 - index));
            }
        }
    }

    #[test]
    fn shifts_round_down() {
        for steps in [1, 63, 64, 65, 130, 199, 1000] {
            let expected: Vec<BigInt> = numbers().iter().map(|value| value >> steps).collect();
            assert_eq!(Numbers::new(&numbers()).shifted_down(|_| steps).values(), expected, "{steps}");
        }
    }

    #[test]
    fn signs_are_certain_or_none() {
        for (index, value) in numbers().iter().enumerate() {
            assert_eq!(Numbers::new(&numbers()).sign(index, 0), Some(value.cmp(&BigInt::zero())));
            let certain = Numbers::new(&numbers()).sign(index, 2);
            assert_eq!(certain, (value.bits() > 1).then(|| value.cmp(&BigInt::zero())));
        }
    }
}
