//! A polynomial's smallest positive root: an algebraic number, compared and narrowed exactly.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{Pow, Zero};

use crate::number::Rational;
use crate::proof::common_divisor::common_divisor;
use crate::proof::integer_polynomial::IntegerPolynomial;

/// A positive root that has no positive root below it.
pub(crate) struct FirstRoot {
    /// Has this root, and only simple ones.
    polynomial: IntegerPolynomial,
    place: Place,
}

/// In units of 2^exponent.
pub(crate) enum Place {
    At {
        offset: BigInt,
        exponent: i64,
    },
    /// Strictly between the two, where there is no other root.
    Between {
        lower: BigInt,
        upper: BigInt,
        exponent: i64,
    },
}

impl FirstRoot {
    pub(crate) fn new(polynomial: IntegerPolynomial, place: Place) -> Self {
        FirstRoot { polynomial, place }
    }

    /// Compares the root to the power `numerator/denominator` of a positive number.
    ///
    /// Both sides are raised to `denominator`. Halving the interval decides unless they are equal, and equal they are
    /// if the polynomial shares a root in the interval with x^denominator - number^numerator, which has one positive
    /// root. Halving takes long if the two are nearly equal; a number that need not be raised is then decided by the
    /// sign of the polynomial.
    pub(crate) fn compare_to_power(
        &mut self,
        number: &Rational,
        numerator: u32,
        denominator: u32,
    ) -> Ordering {
        let power = number.pow(numerator as i32);
        let compare = |offset: &BigInt, exponent: i64| {
            let exponent = exponent * i64::from(denominator);
            let (up, down) = (exponent.max(0) as u64, exponent.min(0).unsigned_abs());
            ((Pow::pow(offset, denominator) * power.denom()) << up).cmp(&(power.numer() << down))
        };
        let (mut checked, mut halvings) = (false, 0);
        loop {
            let (lower, upper, exponent) = match &self.place {
                Place::At { offset, exponent } => return compare(offset, *exponent),
                Place::Between { lower, upper, exponent } => (lower, upper, *exponent),
            };
            if compare(lower, exponent).is_ge() {
                return Ordering::Greater;
            }
            if compare(upper, exponent).is_le() {
                return Ordering::Less;
            }
            if !checked && self.satisfies(&power, denominator) {
                return Ordering::Equal;
            }
            checked = true;
            if denominator == 1 && halvings == PATIENCE {
                // No root lies below this one, so the polynomial is positive on its left.
                return self.polynomial.sign_at_fraction(&power);
            }
            halvings += 1;
            self.halve();
        }
    }

    /// Whether the root to this power is that number.
    fn satisfies(&self, power: &Rational, denominator: u32) -> bool {
        let Place::Between { lower, upper, exponent } = &self.place else { return false };
        let mut coefficients = vec![BigInt::zero(); denominator as usize];
        coefficients.push(power.denom().clone());
        if let Some(constant) = coefficients.first_mut() {
            *constant = -power.numer();
        }
        let shared = common_divisor(&self.polynomial, &IntegerPolynomial::new(coefficients));
        shared.degree() > 0 && sign_at(&shared, lower, *exponent) != sign_at(&shared, upper, *exponent)
    }

    /// Halves the interval, or nearly: at a point with no more digits than it takes to lie inside.
    fn halve(&mut self) {
        let Place::Between { lower, upper, exponent } = &mut self.place else { return };
        let mut spare = (&*upper - &*lower).bits();
        if spare < ROOM {
            *lower <<= ROOM;
            *upper <<= ROOM;
            *exponent -= ROOM as i64;
            spare += ROOM;
        }
        let steps = spare - ROOM;
        let middle: BigInt = (&*lower + &*upper) >> (steps + 1);
        // No root lies below this one, so the polynomial is positive on its left.
        match sign_at(&self.polynomial, &middle, *exponent + steps as i64) {
            Ordering::Greater => *lower = middle << steps,
            Ordering::Less => *upper = middle << steps,
            Ordering::Equal => {
                self.place = Place::At { offset: middle, exponent: *exponent + steps as i64 };
            }
        }
    }

    /// Narrows the root to an interval that is 2^-bits of its upper end.
    pub(crate) fn narrow(&mut self, bits: u64) {
        while let Place::Between { lower, upper, .. } = &self.place
            && (upper - lower) << bits > *upper
        {
            self.halve();
        }
    }

    /// The root to within a factor of two, as a power of two.
    pub(crate) fn binary_exponent(&self) -> i64 {
        let (Place::At { offset, exponent } | Place::Between { upper: offset, exponent, .. }) = &self.place;
        (offset.bits() as i64).saturating_add(*exponent)
    }
}

/// So many halvings cost about as much as the exact sign at a fraction.
const PATIENCE: u32 = 100;

/// The bits by which an interval is longer than the unit that its middle is rounded to.
const ROOM: u64 = 3;

/// The sign at offset * 2^exponent.
fn sign_at(polynomial: &IntegerPolynomial, offset: &BigInt, exponent: i64) -> Ordering {
    let bits = exponent.min(0).unsigned_abs();
    polynomial.value_at(&(offset << exponent.max(0)), bits).cmp(&BigInt::zero())
}
