//! A polynomial in powers, on the way to Bernstein's basis over part of an interval.
//!
//! **Way.** The coefficients c_j f^j of p(f x) give those of p(f + f x) by a Taylor shift, these times (w/f)^j are
//! those of p(f + w x), and divided by C(n, j) they give Bernstein's as the left edge of a triangle of sums.
//!
//! **Error.** In units of these coefficients, if c_j are integers of them, f is at most 1 and w at most f: rounding
//! the powers of f leaves less than n + 2 in each, the shift (n + 2) C(n+1, j+1), of which (w/f)^j is left, and
//! rounding its powers n + 2 more. Divided by C(n, j) and rounded that is less than (n + 3)², and 2^(n+22) after the
//! triangle, as n is at most 1024.
//!
//! **Degree.** Around few roots far from others the higher powers are next to nothing: p is q + r, with q of a lower
//! degree d and coefficients of r that add up to η < 2^-(d+24). What Bernstein's coefficients of q tell, if each is
//! more than 1 from 0, holds for p:
//!
//! - No change of sign: there is no root, as |q| > 1.
//! - One change, behind number m: with x = t/(1+t) and α = m + 1/2, the derivative of t^-α (1+t)^d q has terms of one
//!   sign, and divided by t^(-α-1) (1+t)^d it is more than 1/2, as |j − α| >= 1/2. What r adds is less than 2 n η. So
//!   the quotient of p, which has other signs at the ends, is monotonic, and has one root.
//! - As many changes over a piece as over the whole, both counted with the degree of the whole: over what is left the
//!   coefficients of q have one sign, and at the ends they are more than 1, so that |q| > 2^(1-d) there.
//!
//! In the first two cases an end may also be known by the sign of p alone. With the values of r there given to q, as a
//! linear function, r has a factor x(1 − x), the others less than 2 n η; and x(1 − x) is what is left of the bounds
//! for q if the coefficients at the ends do not count. What r adds is less than 6 (n + 1)² η x(1 − x).

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::proof::fixed_point::{Numbers, binomials};

/// Σ c_j x^j over the interval from 0 to 1.
pub(crate) struct Powers {
    numbers: Vec<BigInt>,
    /// They are in units of 2^-guard.
    guard: u64,
    /// The polynomial is less than so many units from the true one.
    pub(crate) error: i128,
}

/// A lower degree would save nothing.
const LEAST_DEGREE: u64 = 4;
/// 24 digits for the bound of what is left out, and 12 for its being a sum with errors of its own.
const NEGLIGIBLE: u64 = 36;

impl Powers {
    pub(crate) fn new(numbers: Vec<BigInt>, guard: u64, error: i128) -> Self {
        Powers { numbers, guard, error }
    }

    fn degree(&self) -> u64 {
        self.numbers.len().saturating_sub(1) as u64
    }

    /// Over the part from start/2^bits on that is 2^-width long.
    pub(crate) fn over(mut self, start: &BigInt, bits: u64, width: u64) -> Powers {
        if start.is_zero() {
            let mut shift = 0;
            for number in &mut self.numbers {
                *number >>= shift;
                shift += width;
            }
            return self;
        }
        let digits = longest(&self.numbers);
        let (short, bits) = shortened(start, bits, digits.max(width));
        multiply_by_powers(&mut self.numbers, digits, &|power| (power * &short) >> bits);
        // They are less than 2^digits 3^n after the shift; behind these the powers of w/f leave nothing of them.
        let ratio = (short.bits() + width).saturating_sub(bits + 1);
        let last = (digits + 2 * self.degree()).checked_div(ratio).unwrap_or(digits);
        let wanted = self.numbers.len().min(last as usize + 1);
        let mut shifted = Numbers::new(&self.numbers).taylor_shift(wanted).values();
        let digits = longest(&shifted);
        // Around a cluster f is much shorter than its reciprocal, and so is this division than a multiplication.
        multiply_by_powers(&mut shifted[..wanted], digits, &|power| (power << (bits - width)) / &short);
        Powers { numbers: shifted, ..self }
    }

    /// Without the highest powers, if they are negligible; they must be right to 2^(guard−d−26) in all behind every d.
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

fn longest(numbers: &[BigInt]) -> u64 {
    numbers.iter().map(BigInt::bits).max().unwrap_or(0)
}

/// offset/2^bits with so many bits at most.
fn shortened(offset: &BigInt, bits: u64, most: u64) -> (BigInt, u64) {
    let excess = bits.saturating_sub(most);
    (offset >> excess, bits - excess)
}

/// Multiplies number j by a fraction to the power j, in units of 2^-precision; `next` multiplies by the fraction.
fn multiply_by_powers(numbers: &mut [BigInt], precision: u64, next: &dyn Fn(&BigInt) -> BigInt) {
    let one = BigInt::one() << precision;
    let mut power = next(&one);
    if power == one {
        return;
    }
    for number in numbers.iter_mut().skip(1) {
        // What is below the unit of the product is not worth a multiplication.
        let excess = precision.saturating_sub(number.bits() + 2);
        *number = (&*number * (&power >> excess)) >> (precision - excess);
        power = next(&power);
    }
}
