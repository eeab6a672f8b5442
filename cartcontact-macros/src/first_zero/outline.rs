//! Where a polynomial is positive because one of its terms outweighs the others.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::first_zero::integer_polynomial::IntegerPolynomial;

/// The terms of a polynomial, each with the first bits of its coefficient.
pub(crate) struct Outline {
    positive: Vec<Term>,
    negative: Vec<Term>,
}

/// A term whose size is at least leading 2^shift x^power and less than (leading + 1) 2^shift x^power.
struct Term {
    leading: u64,
    shift: i64,
    power: i64,
}

/// The bits of `leading`, at most.
const LEADING_BITS: u64 = 32;

impl Outline {
    pub(crate) fn new(polynomial: &IntegerPolynomial) -> Self {
        let mut outline = Outline { positive: Vec::new(), negative: Vec::new() };
        for (coefficient, power) in polynomial.coefficients().iter().zip(0..) {
            if !coefficient.is_zero() {
                let same =
                    if coefficient.is_negative() { &mut outline.negative } else { &mut outline.positive };
                same.push(Term::new(coefficient, power));
            }
        }
        outline
    }

    /// A sufficient condition for p(x) > 0 from x = 2^exponent to 2^(exponent + 1).
    ///
    /// One positive term outweighs all negative ones at both ends, hence between them: on a logarithmic axis their
    /// sum divided by that term is convex.
    pub(crate) fn stays_positive_between_powers(&self, exponent: i64) -> bool {
        let (start, end) = (self.negative_below(exponent), self.negative_below(exponent + 1));
        for term in &self.positive {
            if term.is_at_least(start, exponent) && term.is_at_least(end, exponent + 1) {
                return true;
            }
        }
        false
    }

    /// A bound of the negative terms at x = 2^end: the size of their sum is less than the first number times 2 to the
    /// power of the second.
    fn negative_below(&self, end: i64) -> (u64, i64) {
        let mut top = i64::MIN;
        for term in &self.negative {
            top = top.max(term.shift_at(end));
        }
        let mut sum = 0;
        for term in &self.negative {
            sum += (term.leading >> (top - term.shift_at(end)).min(63)) + 1;
        }
        (sum, top)
    }
}

impl Term {
    fn new(coefficient: &BigInt, power: i64) -> Self {
        let excess = coefficient.bits().saturating_sub(LEADING_BITS);
        let leading = (coefficient.magnitude() >> excess).to_u64().unwrap_or(0);
        Term { leading, shift: excess as i64, power }
    }

    /// The shift at x = 2^end.
    fn shift_at(&self, end: i64) -> i64 {
        self.shift + self.power * end
    }

    fn is_at_least(&self, (sum, top): (u64, i64), end: i64) -> bool {
        let (leading, sum) = (u128::from(self.leading), u128::from(sum));
        match self.shift_at(end).saturating_sub(top) {
            more @ 0.. => leading << more.min(64) >= sum,
            less => leading >> -less.max(-64) >= sum,
        }
    }
}

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use num_traits::One;

    use super::*;

    #[test]
    fn the_bound_by_bits_is_sound() {
        let polynomial = IntegerPolynomial::new([1000, -30, 0, 1].map(BigInt::from).into());
        let outline = Outline::new(&polynomial);
        for exponent in -4..12 {
            let signs = [exponent, exponent + 1].map(|end| polynomial.sign_at(&BigInt::one(), end));
            let positive = outline.stays_positive_between_powers(exponent);
            assert!(!positive || signs == [Ordering::Greater; 2]);
        }
        assert!(outline.stays_positive_between_powers(-4) && outline.stays_positive_between_powers(11));
    }
}
