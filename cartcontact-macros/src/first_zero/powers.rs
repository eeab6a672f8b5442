//! A polynomial in powers, on the way to Bernstein's basis over part of an interval.
//!
//! **Way.** The coefficients c_j of p are expanded at the beginning of the part (`taylor`), and those of p(f + w x),
//! divided by C(n, j), give Bernstein's as the left edge of a triangle of sums.
//!
//! **Error.** In units of these coefficients, which are cut, the error after the division and its rounding is less than
//! 2 (n + 1) (M + 1) + 2 (`taylor`, for f of M words), and after the triangle less than 2^(n+22): n is at most 1024,
//! and M less than 1500, as numbers have no more words. [`GUARD`] digits more than n make it less than 2^-38 of the
//! unit.
//!
//! **Degree.** Around few roots far from others the higher powers are next to nothing: p is q + r, with q of a lower
//! degree d and coefficients of r that add up to η < 2^-(d+24). What Bernstein's coefficients of q tell, if each is
//! more than 1 from 0, holds for p:
//!
//! - No change of sign: there is no root, as |q| > 1.
//! - One change, behind number m: with x = t/(1+t) and α = m + 1/2, the derivative of t^-α (1+t)^d q has terms of one
//!   sign, and divided by t^(-α-1) (1+t)^d it is more than 1/2, as |j − α| >= 1/2. What r adds is less than 2 n η. So
//!   the quotient of p, which has other signs at the ends, is monotonic, and has one root.
//! - As many changes over a piece as over the whole, both counted with the degree d: over the rest the coefficients of
//!   q have one sign, and at the ends they are more than 1, so that |q| > 2^(1-d) there.
//!
//! In the first two cases an end may also be known by the sign of p alone. With the values of r there given to q, as a
//! linear function, r has a factor x(1 − x), the others less than 2 n η; and x(1 − x) is what is left of the bounds
//! for q if the coefficients at the ends do not count. What r adds is less than 6 (n + 1)² η x(1 − x).

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
/// A degree below this one would save nothing.
const LEAST_DEGREE: u64 = 4;
/// A power that is left out is less than 2^-d by this many bits: 24 for the bound of η, which is the sum of all of
/// them, and 12 because there are up to 1024 of them, with errors of their own.
const NEGLIGIBLE: u64 = 36;

impl Powers {
    pub(crate) fn degree(&self) -> u64 {
        self.numbers.len().saturating_sub(1) as u64
    }

    /// The same in units of 2^digits, with as many guard digits as a change of the interval takes. Cutting the
    /// coefficients is part of the error of that change; leaving some of them out adds less than one unit.
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

    /// Without the highest powers, if they are negligible. For every d, the errors of those above d must add up to less
    /// than 2^(guard−d−26).
    pub(crate) fn without_negligible(&self) -> Option<Powers> {
        let mut degree = self.degree();
        while degree > LEAST_DEGREE
            && let Some(last) = self.numbers.get(degree as usize)
            && last.bits() + degree - 1 + NEGLIGIBLE <= self.guard
        {
            degree -= 1;
        }
        if degree == self.degree() {
            return None;
        }
        let mut numbers = self.numbers.clone();
        numbers.truncate(degree as usize + 1);
        Some(Powers { numbers, ..*self })
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
