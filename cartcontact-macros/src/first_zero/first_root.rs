//! A polynomial's smallest positive root: an algebraic number, compared and narrowed exactly.
//!
//! Two roots may be so close to each other, and to the number that they are compared with, that halving an interval
//! would take thousands of steps. So Newton's method says where to look. A step that finds the root there makes the
//! next step try to gain twice as many bits; a step that does not, half as many. A step that gains one bit is a halving
//! (J. Abbott, Quadratic interval refinement for real roots, ACM Commun. Comput. Algebra 48 (2014) 3-12, doi
//! 10.1145/2644288.2644291).

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, ToPrimitive, Zero};

use crate::first_zero::common_divisor::common_divisor;
use crate::first_zero::compared_power::ComparedPower;
use crate::first_zero::integer_polynomial::IntegerPolynomial;
use crate::first_zero::part::{Part, Whole};
use crate::number::Rational;

/// A positive root that has no positive root below it.
pub(crate) struct FirstRoot {
    /// Has this root; all its roots are simple.
    polynomial: IntegerPolynomial,
    place: RootPlace,
    /// The bits that the next step tries to gain.
    gain: u64,
}

/// In units of 2^exponent.
pub(crate) enum RootPlace {
    At {
        offset: BigInt,
        exponent: i64,
    },
    /// Strictly between the two ends, with no other root there.
    Between {
        lower: BigInt,
        upper: BigInt,
        exponent: i64,
    },
}

impl FirstRoot {
    pub(crate) fn new(polynomial: IntegerPolynomial, place: RootPlace) -> Self {
        FirstRoot { polynomial, place, gain: 1 }
    }

    /// Compares the root to the power `numerator/denominator` of a positive number.
    ///
    /// Both sides are raised to `denominator`. Narrowing the interval decides unless they are equal. Once the interval is
    /// shorter than the digits of the number suggest, both sides are equal if the polynomial shares a root in the
    /// interval with x^denominator - number^numerator, which has one positive root.
    pub(crate) fn compare_to_power(
        &mut self,
        number: &Rational,
        numerator: u32,
        denominator: u32,
    ) -> Ordering {
        let power = ComparedPower::of(number, numerator);
        let bits = power.bits();
        let compare = |offset: &BigInt, exponent: i64| power.compare_to((offset, exponent), denominator);
        let mut checked = false;
        loop {
            let (lower, upper, exponent) = match &self.place {
                RootPlace::At { offset, exponent } => return compare(offset, *exponent),
                RootPlace::Between { lower, upper, exponent } => (lower, upper, *exponent),
            };
            if compare(lower, exponent).is_ge() {
                return Ordering::Greater;
            }
            if compare(upper, exponent).is_le() {
                return Ordering::Less;
            }
            if !checked && self.is_narrow(bits) {
                if self.satisfies(&power.exact(), denominator) {
                    return Ordering::Equal;
                }
                checked = true;
            }
            self.step();
        }
    }

    /// Whether the root to the power `denominator` equals `power`.
    fn satisfies(&self, power: &Rational, denominator: u32) -> bool {
        let RootPlace::Between { lower, upper, exponent } = &self.place else { return false };
        let mut coefficients = vec![BigInt::zero(); denominator as usize + 1];
        coefficients[0] = -power.numer();
        coefficients[denominator as usize] = power.denom().clone();
        let shared = common_divisor(&self.polynomial, &IntegerPolynomial::new(coefficients));
        shared.degree() > 0 && shared.sign_at(lower, *exponent) != shared.sign_at(upper, *exponent)
    }

    /// Shortens the interval to about half or less, at points with no more digits than needed.
    fn step(&mut self) {
        let RootPlace::Between { lower, upper, exponent } = &mut self.place else { return };
        let missing = (self.gain + ROOM).saturating_sub((&*upper - &*lower).bits());
        *lower <<= missing;
        *upper <<= missing;
        *exponent -= missing as i64;
        let whole = Whole::new(&self.polynomial, *exponent + lower.bits() as i64 - 1);
        let line = Line { whole: &whole, exponent: *exponent };
        let reach = (&*upper - &*lower).bits() - 1 - self.gain;
        let piece = BigInt::one() << reach;
        let guess = if self.gain > 1 { line.newton(lower, self.gain) } else { None };
        let guess = guess.unwrap_or_else(|| (&*lower + &*upper) >> 1);
        let fine = (reach + 1).saturating_sub(ROOM);
        let mut point = (guess.clamp(&*lower + &piece, &*upper - &piece) >> fine) << fine;
        for _ in 0..2 {
            if point <= *lower || *upper <= point {
                break;
            }
            // No root lies below this one, so the polynomial is positive on its left.
            match line.sign(&point) {
                Ordering::Greater => {
                    *lower = point;
                    point = &*lower + &piece;
                }
                Ordering::Less => {
                    *upper = point;
                    point = &*upper - &piece;
                }
                Ordering::Equal => {
                    self.place = RootPlace::At { offset: point, exponent: *exponent };
                    return;
                }
            }
        }
        let found = &*upper - &*lower <= piece << 1;
        self.gain = if found { 2 * self.gain } else { (self.gain / 2).max(1) };
    }

    /// Whether the root is known to 2^-bits of its upper end.
    fn is_narrow(&self, bits: u64) -> bool {
        match &self.place {
            RootPlace::At { .. } => true,
            RootPlace::Between { lower, upper, .. } => (upper - lower) << bits <= *upper,
        }
    }

    /// Narrows the root to an interval no longer than 2^-bits of its upper end.
    pub(crate) fn narrow(&mut self, bits: u64) {
        while !self.is_narrow(bits) {
            self.step();
        }
    }

    /// The decimal logarithm of the upper end, which is as near as the root has been [narrowed](Self::narrow).
    pub(crate) fn log10(&self) -> f64 {
        let (RootPlace::At { offset, exponent } | RootPlace::Between { upper: offset, exponent, .. }) =
            &self.place;
        let excess = offset.bits().saturating_sub(64);
        let leading = (offset >> excess).to_f64().unwrap_or(f64::NAN);
        (leading.log2() + (excess as i64 + exponent) as f64) * core::f64::consts::LOG10_2
    }
}

/// A piece of an interval is this many bits longer than the unit that its ends are rounded to.
const ROOM: u64 = 3;
/// The digits of the first value that is computed at a point, beyond those of the point.
const MORE_DIGITS: u64 = 64;

/// The polynomial at points in units of 2^exponent, from one power of two to the next.
struct Line<'a> {
    whole: &'a Whole<'a>,
    exponent: i64,
}

impl Line<'_> {
    fn point(&self, offset: &BigInt) -> Part {
        let bits = (self.whole.exponent - self.exponent) as u64;
        let offset = offset - (BigInt::one() << bits);
        let zeros = offset.trailing_zeros().unwrap_or(bits).min(bits);
        Part { offset: offset >> zeros, bits: bits - zeros, width: 0 }
    }

    /// The value at a point, with this many correct bits, and its digits; nothing if the value is 0 or next to it.
    fn value(&self, point: &Part, bits: u64) -> Option<(BigInt, u64)> {
        let mut digits = point.bits + MORE_DIGITS;
        while digits < self.whole.length + self.whole.degree() * point.bits + bits + MORE_DIGITS {
            if let Some(value) = self.whole.value(point, digits)
                && value.bits() > bits + 1
            {
                return Some((value, digits));
            }
            digits *= 2;
        }
        None
    }

    fn sign(&self, offset: &BigInt) -> Ordering {
        let point = self.point(offset);
        match self.value(&point, 0) {
            Some((value, _)) => value.cmp(&BigInt::zero()),
            None => self.whole.sign_at(&point, 0),
        }
    }

    /// Where Newton's method leads from a point at which the polynomial falls.
    fn newton(&self, offset: &BigInt, bits: u64) -> Option<BigInt> {
        let point = self.point(offset);
        let (value, digits) = self.value(&point, bits)?;
        let slope = self.whole.slope(&point, digits);
        let scale = (self.whole.exponent - self.exponent) as u64;
        (slope < BigInt::zero()).then(|| offset - (value << scale) / slope)
    }
}
