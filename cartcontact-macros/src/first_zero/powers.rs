//! A polynomial in powers, on the way to Bernstein's basis over part of an interval.
//!
//! **Way.** The coefficients c_j of p are expanded at the beginning of the part (`taylor`), and those of p(f + w x),
//! divided by C(n, j), give Bernstein's as the left edge of a triangle of sums.
//!
//! **Error.** In units of these coefficients, which are cut, the error after the division and its rounding is less than
//! 2 (n + 1) (M + 1) + 2 (`taylor`, for f of M words), and after the triangle less than 2^(n+22): n is at most 1024,
//! and M less than 1500, as numbers have no more words. [`GUARD`] digits more than n make it less than 2^-38 of the
//! unit.

use num_bigint::BigInt;
use num_traits::Zero;

use crate::first_zero::fixed_point::{Numbers, binomials};
use crate::first_zero::taylor::expand;
use crate::number::shifted;

/// Σ c_j x^j over the interval from 0 to 1.
pub(crate) struct Powers {
    pub(crate) numbers: Vec<BigInt>,
    /// The numbers are in units of 2^-guard.
    pub(crate) guard: u64,
    /// The polynomial is less than this many units from the true one.
    pub(crate) error: i128,
}

/// Digits that are lost on the way to Bernstein's basis over part of an interval, besides one for every power.
pub(crate) const GUARD: u64 = 60;

impl Powers {
    pub(crate) fn degree(&self) -> u64 {
        self.numbers.len().saturating_sub(1) as u64
    }

    /// The same in units of 2^digits, with as many guard digits as a change of the interval takes. The last change adds
    /// less than one unit to the error; cutting the coefficients is part of the error of the next one.
    pub(crate) fn cut(&self, digits: u64) -> Powers {
        let guard = self.degree() + GUARD;
        let missing = guard as i64 - (self.guard + digits) as i64;
        let numbers = self.numbers.iter().map(|number| shifted(number, missing)).collect();
        let error = ((self.error + 1) >> digits.min(126)) + 1;
        Powers { numbers, guard, error }
    }

    /// The polynomial over the part from start/2^bits on that is 2^-width long.
    pub(crate) fn over(mut self, start: &BigInt, bits: u64, width: u64) -> Powers {
        if start.is_zero() {
            let mut shift = 0;
            for number in &mut self.numbers {
                *number >>= shift;
                shift += width;
            }
            return self;
        }
        Powers { numbers: expand(&self.numbers, start, bits, width), ..self }
    }

    /// In Bernstein's basis, rounded down to units.
    pub(crate) fn bernstein(&self) -> Numbers {
        let binomials = binomials(self.degree() as usize);
        let mut divided = self.numbers.clone();
        for (number, binomial) in divided.iter_mut().zip(&binomials) {
            *number /= binomial;
        }
        let [left, _] = Numbers::new(&divided).edges();
        left.shifted_down(&|_| self.guard as usize)
    }
}
