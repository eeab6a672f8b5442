//! Fixed-point numbers of any length, and what is computed from many of them: the triangle of sums.
//!
//! Every row of the triangle holds the sums of neighbours in the row before,
//!
//! ```text
//! v0          v1          v2
//!    v0+v1       v1+v2
//!       v0+2v1+v2
//! ```
//!
//! and its left and right edges are Σ_m C(r, m) v_m and Σ_m C(n−j, m) v_{j+m}. The change to Bernstein's basis and de
//! Casteljau's division of an interval are such triangles; Taylor shifts are sums of the same kind.
//!
//! Cargo does not optimise macros, so most of the time goes into calls and checks, which big-integer arithmetic is full
//! of. Here digits of the same rank stand side by side, a sum is one addition of machine numbers in an array of known
//! length, and carries wait for many rows.

use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, Zero};

/// Numbers in digits of 96 bits. All digits of a number are from 0 to 2^96, except the highest, which has its sign.
#[derive(Clone)]
pub(crate) struct Numbers {
    /// The digits of all numbers by rank, the lowest first; there is at least one rank. Zeros fill the last block.
    ranks: Vec<Vec<Block>>,
    count: usize,
}

const BLOCK: usize = 8;
type Block = [i128; BLOCK];

const DIGIT: u32 = 96;
const MASK: i128 = (1 << DIGIT) - 1;
/// A digit of 96 bits stays below 2^127 for this many rows.
const ROWS_WITHOUT_CARRY: usize = 30;
/// The bits that a highest digit may have before a triangle: every row adds one.
const HIGHEST_BITS: u32 = 62;

impl Numbers {
    pub(crate) fn new(values: &[BigInt]) -> Self {
        let longest = values.iter().map(BigInt::bits).max().unwrap_or(0);
        let count = (longest + u64::from(DIGIT - HIGHEST_BITS)) / u64::from(DIGIT) + 1;
        let mut numbers = Numbers::zeros(count as usize, values.len());
        for (index, value) in values.iter().enumerate() {
            let sign = if value.is_negative() { -1 } else { 1 };
            let mut halves = value.iter_u32_digits();
            for rank in &mut numbers.ranks {
                let mut digit = || i128::from(halves.next().unwrap_or(0));
                rank[index / BLOCK][index % BLOCK] = sign * (digit() | digit() << 32 | digit() << 64);
            }
        }
        numbers.carry();
        numbers
    }

    fn zeros(ranks: usize, count: usize) -> Self {
        Numbers { ranks: vec![zeros(count); ranks], count }
    }

    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// An upper bound of the bits of the longest number.
    pub(crate) fn length(&self) -> u64 {
        let Some((highest, lower)) = self.ranks.split_last() else { return 0 };
        let sizes =
            highest.as_flattened().iter().map(|digit| i128::BITS - digit.unsigned_abs().leading_zeros());
        u64::from(sizes.max().unwrap_or(0)) + lower.len() as u64 * u64::from(DIGIT)
    }

    /// The bits of the shortest number whose sign is certain (`sign`).
    pub(crate) fn shortest(&self, error: i128) -> u64 {
        let mut shortest = u64::MAX;
        let mut index = 0;
        while index < self.count {
            let (leading, lower) = self.leading(index);
            if leading.abs() >= error {
                let bits = u64::from(i128::BITS - leading.unsigned_abs().leading_zeros());
                shortest = shortest.min(bits + lower as u64 * u64::from(DIGIT));
            }
            index += 1;
        }
        shortest
    }

    /// The first digits of a number, enough for 30 bits or all of them, and how many digits follow.
    fn leading(&self, index: usize) -> (i128, usize) {
        let mut leading: i128 = 0;
        let mut lower = self.ranks.len();
        while lower > 0 && leading >> 30 == leading >> 127 {
            lower -= 1;
            leading = (leading << DIGIT) + at(&self.ranks[lower], index);
        }
        (leading, lower)
    }

    pub(crate) fn value(&self, index: usize) -> BigInt {
        let Some((highest, lower)) = self.ranks.split_last() else { return BigInt::zero() };
        let mut thirds = Vec::with_capacity(3 * lower.len());
        for rank in lower {
            let digit = at(rank, index);
            thirds.extend([digit as u32, (digit >> 32) as u32, (digit >> 64) as u32]);
        }
        (BigInt::from(at(highest, index)) << (lower.len() * DIGIT as usize)) + BigInt::new(Sign::Plus, thirds)
    }

    pub(crate) fn values(&self) -> Vec<BigInt> {
        (0..self.len()).map(|index| self.value(index)).collect()
    }

    /// The sign of a number that is less than `error` < 2^30 units from the true one, if both must have the same sign.
    pub(crate) fn sign(&self, index: usize, error: i128) -> Option<Ordering> {
        // The lower digits are less than one unit of the leading ones, and so is the error.
        let (leading, _) = self.leading(index);
        (leading.abs() >= error).then(|| leading.cmp(&0))
    }

    /// The left and the right edge of the triangle of sums.
    pub(crate) fn edges(mut self) -> [Numbers; 2] {
        self.make_room(self.count.saturating_sub(1));
        let mut left = Numbers::zeros(self.ranks.len(), self.count);
        let mut right = Numbers::zeros(self.ranks.len(), self.count);
        let filled = self.filled_blocks();
        for start in (0..self.count).step_by(ROWS_WITHOUT_CARRY) {
            let rows = start..self.count.min(start + ROWS_WITHOUT_CARRY);
            for ((rank, left), right) in self.ranks.iter_mut().zip(&mut left.ranks).zip(&mut right.ranks) {
                for row in rows.clone() {
                    let last = self.count - 1 - row;
                    left[row / BLOCK][row % BLOCK] = rank[0][0];
                    right[last / BLOCK][last % BLOCK] = rank[last / BLOCK][last % BLOCK];
                    // What stands behind the last number of a row never enters the triangle.
                    add_neighbours(&mut rank[..filled.min(last / BLOCK + 1)]);
                }
            }
            self.carry();
        }
        left.carry();
        right.carry();
        [left, right]
    }

    /// Σ_m C(j+m, m) v_{j+m}, the coefficients of Σ v_j (1 + x)^j.
    ///
    /// Number j results from j + 1 passes of sums from the end.
    pub(crate) fn taylor_shift(mut self) -> Numbers {
        self.make_room(self.count);
        let without_carry = passes_without_carry(self.count);
        for start in (0..self.count).step_by(without_carry) {
            for rank in &mut self.ranks {
                for first in start..self.count.min(start + without_carry) {
                    sum_from_the_end(rank, first);
                }
            }
            self.carry();
        }
        self
    }

    /// Every number times 2^-steps, rounded down.
    pub(crate) fn shifted_down(&self, steps: &dyn Fn(usize) -> usize) -> Numbers {
        let Some((highest, lower)) = self.ranks.split_last() else { return self.clone() };
        let mut shifted = Numbers::zeros(self.ranks.len(), self.count);
        for index in 0..self.count {
            let (ranks_down, bits) = (steps(index) / DIGIT as usize, steps(index) as u32 % DIGIT);
            let (block, place, highest) = (index / BLOCK, index % BLOCK, at(highest, index));
            let digit = |rank: usize| match lower.get(rank) {
                Some(lower) => lower[block][place],
                None => (highest >> ((rank - lower.len()) * DIGIT as usize).min(127)) & MASK,
            };
            let mut here = digit(ranks_down);
            for (rank, target) in shifted.ranks.iter_mut().enumerate() {
                let above = digit(rank + ranks_down + 1);
                target[block][place] = ((here >> bits) | (above << (DIGIT - bits))) & MASK;
                here = above;
            }
            if let Some(last) = shifted.ranks.last_mut() {
                last[block][place] = highest >> steps(index).min(127);
            }
        }
        shifted.trim();
        shifted
    }

    fn carry(&mut self) {
        for rank in 1..self.ranks.len() {
            if let ([.., lower], [upper, ..]) = self.ranks.split_at_mut(rank) {
                let (lower, upper) = (lower.as_flattened_mut(), upper.as_flattened_mut());
                let mut index = 0;
                while index < lower.len() {
                    let digit = lower[index];
                    if digit >> DIGIT != 0 {
                        upper[index] += digit >> DIGIT;
                        lower[index] = digit & MASK;
                    }
                    index += 1;
                }
            }
        }
    }

    /// The number of blocks up to the last that is not zero.
    fn filled_blocks(&self) -> usize {
        let last = |rank: &Vec<Block>| rank.iter().rposition(|block| *block != [0; BLOCK]);
        self.ranks.iter().filter_map(last).max().map_or(0, |last| last + 1)
    }

    /// Adds ranks until this many rows of a triangle cannot overflow the highest.
    fn make_room(&mut self, rows: usize) {
        let missing = (rows as u32 + HIGHEST_BITS).saturating_sub(i128::BITS - 2);
        for _ in 0..missing.div_ceil(DIGIT) {
            self.ranks.push(zeros(self.count));
        }
        self.carry();
    }

    /// Removes ranks that only repeat signs.
    fn trim(&mut self) {
        while let [.., lower, upper] = self.ranks.as_mut_slice()
            && lower.as_flattened().iter().zip(upper.as_flattened()).all(|(lower, upper)| {
                *lower >> HIGHEST_BITS == *upper & (MASK >> HIGHEST_BITS) && *upper >> 1 == *upper
            })
        {
            for (lower, upper) in lower.as_flattened_mut().iter_mut().zip(upper.as_flattened()) {
                *lower += *upper << DIGIT;
            }
            self.ranks.pop();
        }
    }
}

fn zeros(count: usize) -> Vec<Block> {
    vec![[0; BLOCK]; count.div_ceil(BLOCK)]
}

fn at(rank: &[Block], index: usize) -> i128 {
    rank[index / BLOCK][index % BLOCK]
}

/// Adds to every number the one behind it. Constant indices into an array are not checked, even in unoptimised code,
/// and slice patterns are not calls.
fn add_neighbours(mut blocks: &mut [Block]) {
    let mut behind = 0;
    while let [before @ .., block] = blocks {
        let first = block[0];
        block[0] += block[1];
        block[1] += block[2];
        block[2] += block[3];
        block[3] += block[4];
        block[4] += block[5];
        block[5] += block[6];
        block[6] += block[7];
        block[7] += behind;
        behind = first;
        blocks = before;
    }
}

/// Adds to every number from `first` on all numbers behind it.
fn sum_from_the_end(blocks: &mut [Block], first: usize) {
    let mut behind = 0;
    let (before, mut after) = blocks.split_at_mut(first / BLOCK + 1);
    while let [others @ .., block] = after {
        block[7] += behind;
        block[6] += block[7];
        block[5] += block[6];
        block[4] += block[5];
        block[3] += block[4];
        block[2] += block[3];
        block[1] += block[2];
        block[0] += block[1];
        behind = block[0];
        after = others;
    }
    for number in before.as_flattened_mut()[first..].iter_mut().rev() {
        *number += behind;
        behind = *number;
    }
}

/// The largest number k of passes without a carry. After k passes number i is Σ_m C(m+k−1, m) v_{i+m}, and these
/// binomials add up to at most C(count, k), which must stay below 2^30.
fn passes_without_carry(count: usize) -> usize {
    let (mut passes, mut growth) = (0, 1);
    while growth >> 30 == 0 && passes < count {
        growth = growth * (count - passes) as u64 / (passes + 1) as u64;
        passes += 1;
    }
    if growth >> 30 == 0 { passes } else { passes - 1 }
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
        assert_eq!(Numbers::new(&numbers()).shifted_down(&|_| 0).values(), numbers());
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
    fn taylor_shifts_are_sums_with_binomials() {
        for count in [1, 2, 7, 64, 65, 150] {
            let values = &numbers()[..count];
            let shifted = Numbers::new(values).taylor_shift();
            for index in 0..count {
                let term = |power: usize| &values[power] * &binomials(power)[index];
                assert_eq!(shifted.value(index), (index..count).map(term).sum());
            }
        }
    }

    #[test]
    fn shifts_round_down() {
        for steps in [1, 63, 64, 65, 95, 96, 97, 130, 199, 1000] {
            let expected: Vec<BigInt> = numbers().iter().map(|value| value >> steps).collect();
            assert_eq!(Numbers::new(&numbers()).shifted_down(&|_| steps).values(), expected, "{steps}");
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
