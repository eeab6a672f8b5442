//! The expansion of a polynomial at another point f, by repeated division by x − f.
//!
//! Every pass of Horner's rule leaves one more coefficient of the expansion, and behind it the quotient for the next
//! pass. The coefficient of x^k is needed only times w^k, so pass k leaves out as many words as w^k has zeros for.
//!
//! As everywhere in a macro, calls and allocations would take most of the time of big-integer products. So numbers are
//! words of one length here, modulo a power of two, with their signs in the highest bit.
//!
//! **Error.** In pass m, in units of w^-m at most, a product with a factor of M words loses less than M, and leaving
//! out words less than 1. As number m + i of that pass goes into coefficient k with C(i, k−m) f^(i-k+m), all of it
//! comes to (M + 1) C(n−m+1, k−m+1) w^(k-m) units of that coefficient. C(n−m+1, k−m+1) is at most C(n+1, k+1), which is
//! (n+1)/(k+1) C(n, k): with cut c_j that is less than 2 (n + 1) (M + 1) C(n, k) from all passes. And as w is at most
//! 1/2 and Σ C(j+t, j) 2^-t is 2^(j+1), it is less than (M + 1) 2^(n-k+2), which is small for the highest powers.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::first_zero::horner::{add_row, fraction, integer, negate};

const WORD: u64 = u64::BITS as u64;

/// The coefficients of p(f + 2^-width x) for those of p, where f = offset/2^bits is at least 2^-width and less than 1.
pub(crate) fn expand(coefficients: &[BigInt], offset: &BigInt, bits: u64, width: u64) -> Vec<BigInt> {
    let longest = coefficients.iter().map(BigInt::bits).max().unwrap_or(0);
    // The coefficients grow by binomials of the degree.
    let length = ((longest + coefficients.len() as u64 + 2) / WORD + 1) as usize;
    let mut rows: Vec<Vec<u64>> = coefficients.iter().map(|number| words(number, length)).collect();
    let mut factor = fraction(offset, bits);
    // Words this far behind its highest one do not reach any row.
    factor.drain(..factor.len().saturating_sub(length + 1));
    let mut expanded = Vec::with_capacity(coefficients.len());
    for power in 0..coefficients.len() {
        let (shift, unused) = (power as u64 * width % WORD, (power as u64 * width / WORD) as usize);
        if unused >= length {
            break;
        }
        for index in (power + 1..coefficients.len()).rev() {
            if let [.., row, next] = &mut rows[..=index] {
                add_product(&mut row[unused..], &next[unused..], &factor);
            }
        }
        expanded.push(signed(&rows[power][unused..]) >> shift);
    }
    expanded.resize(coefficients.len(), BigInt::zero());
    expanded
}

/// A number modulo 2^(64 length).
fn words(number: &BigInt, length: usize) -> Vec<u64> {
    let mut words = number.magnitude().to_u64_digits();
    words.resize(length, 0);
    if number.is_negative() {
        negate(&mut words);
    }
    words
}

fn is_negative(words: &[u64]) -> bool {
    words.last().is_some_and(|last| last >> (WORD - 1) == 1)
}

fn signed(words: &[u64]) -> BigInt {
    let size = integer(words);
    if is_negative(words) { size - (BigInt::one() << (words.len() * WORD as usize)) } else { size }
}

/// Adds the product of a row and a fraction to another row; less than one unit is lost for every word of the fraction.
fn add_product(sums: &mut [u64], row: &[u64], fraction: &[u64]) {
    let length = row.len();
    for (place, &factor) in fraction.iter().enumerate() {
        let behind = fraction.len() - place;
        if factor == 0 || behind > length {
            continue;
        }
        let carry = (u128::from(row[behind - 1]) * u128::from(factor)) >> WORD;
        let carry = add_row(&mut sums[..length - behind], &row[behind..], factor, carry as u64);
        // All words beyond the highest of a row are its sign.
        let mut rest = i128::from(carry) - if is_negative(row) { i128::from(factor) } else { 0 };
        for word in &mut sums[length - behind..] {
            let sum = i128::from(*word) + rest;
            (*word, rest) = (sum as u64, sum >> WORD);
            if rest == 0 {
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::first_zero::fixed_point::binomials;

    /// With coefficients of very different lengths and mixed signs, against the definition.
    #[test]
    fn expansions_are_sums_with_binomials() {
        let number = |power: u32| {
            let size: BigInt = (BigInt::from(7 * power + 1) << 200) >> (power * 13 % 190);
            if power % 3 == 1 { -size } else { size }
        };
        let numbers: Vec<BigInt> = (0..40).map(number).collect();
        for (offset, bits, width) in
            [(1_u64, 1, 1), (5, 3, 2), (123_456_789, 27, 27), (u64::MAX, 64, 30), (3, 200, 199)]
        {
            for (k, expanded) in expand(&numbers, &offset.into(), bits, width).iter().enumerate() {
                let term = |i: usize| {
                    let product = &numbers[i] * &binomials(i)[k] * BigInt::from(offset).pow((i - k) as u32);
                    product << (bits * (39 + k - i) as u64)
                };
                let exact = (k..40).map(term).sum::<BigInt>();
                let unit = BigInt::one() << (bits * 39 + width * k as u64);
                let most = &unit * (5_u64 << (39 - k + 2));
                assert!((expanded * &unit - exact).magnitude() < most.magnitude(), "{offset}/2^{bits}: {k}");
            }
        }
    }
}
