//! The smallest positive root of a polynomial, exactly: Descartes' rule of signs on ever smaller intervals.
//!
//! The number of sign changes in the coefficients of (1+y)^n p((a + b y)/(1 + y)) bounds the number of roots in
//! (a, b): none if it is 0, one if it is 1, and it never grows when the interval is divided (the two parts and a root
//! at their border share it). So the interval in front is divided until the count is 0 or 1.
//!
//! The search goes from one power of two to the next, as roots may be of any magnitude; most of these intervals a
//! bound that costs nothing skips.
//!
//! Halving alone needs a step for every bit by which two roots differ. A cluster of k roots at c
//! gives p'/p = k/(x - c) nearby, so c is close to a - k p(a)/p'(a): if a small interval there keeps all k sign
//! changes, nothing else is left to look at, and the next leap may be twice as long in bits. If not, it is halved.
//! Two sign changes that are left where the polynomial is convex are decided by its minimum (`minimum`).
//!
//! Termination: the roots are simple (repeated ones are made so first), and by the theorem of the two circles
//! (Obreshkoff, Ostrowski) the count is 0 or 1 once the interval is shorter than a fraction of the distance between
//! two complex roots. Every step shortens the interval at least by half.
//!
//! G. E. Collins, A. G. Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976,
//! 272-275, doi 10.1145/800205.806346; M. Sagraloff, When Newton meets Descartes, ISSAC 2012, doi
//! 10.1145/2442829.2442872.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};

use crate::common_divisor::{common_divisor, square_free};
use crate::integer_polynomial::IntegerPolynomial;
use crate::minimum::{First, Undecided, first_of_convex};
use crate::number::{self, Rational};

/// A positive root that has no positive root below it.
#[derive(Debug)]
pub(crate) struct FirstRoot {
    /// Has this root, and only simple ones.
    polynomial: IntegerPolynomial,
    place: Place,
}

#[derive(Debug)]
enum Place {
    At(Rational),
    /// Strictly between the two, where there is no other root.
    Between(Rational, Rational),
}

/// Coefficients beyond this length, in bits, stand for differences that no measured gap has.
const MAXIMUM_LENGTH: u64 = 1 << 19;

/// The coefficients in some interval are longer than [`MAXIMUM_LENGTH`].
#[derive(Debug)]
pub(crate) struct TooIntricate;

/// The smallest positive root of a polynomial that is positive at 0.
pub(crate) fn first_root(polynomial: &IntegerPolynomial) -> Result<Option<FirstRoot>, TooIntricate> {
    if polynomial.sign_changes() == 0 {
        return Ok(None);
    }
    let polynomial = square_free(polynomial);
    let lowest = -polynomial.clone().reversed().root_bound();
    for exponent in lowest..polynomial.root_bound() {
        if polynomial.stays_positive_between_powers(exponent) {
            continue;
        }
        if exponent.unsigned_abs().saturating_mul(polynomial.degree() as u64) > MAXIMUM_LENGTH {
            return Err(TooIntricate);
        }
        let stretched = polynomial.clone().stretched(exponent);
        if is_clearly_positive(&stretched) {
            continue;
        }
        if let Some(place) = first_place(Interval::from_power(exponent, stretched))? {
            return Ok(Some(FirstRoot { polynomial, place }));
        }
    }
    Ok(None)
}

/// Whether the leading digits suffice to show that there is no root from 1 to 2.
fn is_clearly_positive(polynomial: &IntegerPolynomial) -> bool {
    polynomial.rounded_down().is_some_and(|below| {
        let below = below.shifted(&BigInt::one());
        below.constant().is_positive() && below.sign_changes_between_zero_and_one() == 0
    })
}

fn first_place(whole: Interval) -> Result<Option<Place>, TooIntricate> {
    let mut ahead = vec![whole];
    while let Some(front) = ahead.pop() {
        if front.local.length() > MAXIMUM_LENGTH {
            return Err(TooIntricate);
        }
        if front.local.constant().is_zero() {
            return Ok(Some(Place::At(front.lower)));
        }
        match front.local.sign_changes_between_zero_and_one() {
            0 => {}
            1 => {
                let upper = &front.lower + front.width;
                return Ok(Some(Place::Between(front.lower, upper)));
            }
            2 if front.is_convex() => {
                if let Some(place) = front.place_beside_minimum()? {
                    return Ok(Some(place));
                }
            }
            count => match front.around_cluster(count) {
                Some(closer) => ahead.push(closer),
                None => ahead.extend(front.halves()),
            },
        }
    }
    Ok(None)
}

/// A leap of b bits tries an interval 2^(b-1) times shorter.
const SHORTEST_LEAP: u32 = 2;

struct Interval {
    lower: Rational,
    width: Rational,
    /// The polynomial over this interval, in a variable that runs from 0 to 1.
    local: IntegerPolynomial,
    leap: u32,
}

impl Interval {
    /// From 2^exponent to 2^(exponent + 1).
    fn from_power(exponent: i64, stretched: IntegerPolynomial) -> Interval {
        let start = power_of_two(exponent);
        let local = stretched.shifted(&BigInt::one());
        Interval { lower: start.clone(), width: start, local, leap: SHORTEST_LEAP }
    }

    /// Where Newton's method for a root of this multiplicity points, if no sign change is lost.
    fn around_cluster(&self, count: usize) -> Option<Interval> {
        let (value, slope) = (self.local.constant(), self.local.linear());
        let inside = value.is_negative() != slope.is_negative() && (&value * count).abs() <= slope.abs();
        if !inside || slope.is_zero() {
            return None;
        }
        let steps = BigInt::one() << self.leap;
        let centre: BigInt = -((value * count) << self.leap) / slope;
        let offset: BigInt = centre * 2 - 1;
        let offset = offset.clamp(BigInt::zero(), steps * 2 - 4);
        let closer = self.part(&offset, self.leap + 1, 2).with_leap(self.leap * 2);
        (closer.local.sign_changes_between_zero_and_one() == count).then_some(closer)
    }

    /// Whether the curvature has no zero inside, by Descartes' rule; it is positive where the ends are.
    fn is_convex(&self) -> bool {
        self.local.derivative().derivative().sign_changes_between_zero_and_one() == 0
    }

    /// The first root of a convex polynomial that is positive at both ends; with leading digits as long as these decide.
    fn place_beside_minimum(&self) -> Result<Option<Place>, TooIntricate> {
        let mut digits = 4 * self.local.degree() as u64 + 256;
        let first = loop {
            match self.local.leading_digits(digits) {
                Some(rounded) => match first_of_convex(&rounded, Some(0), MAXIMUM_LENGTH) {
                    Ok(first) => break first,
                    Err(Undecided) => digits *= 4,
                },
                None => {
                    break first_of_convex(&self.local, None, MAXIMUM_LENGTH).map_err(|_| TooIntricate)?;
                }
            }
        };
        let at = |offset, bits: u64| {
            &self.lower + &self.width * number::integer(offset) * power_of_two(-(bits as i64))
        };
        Ok(match first {
            First::None => None,
            First::At(offset, bits) => Some(Place::At(at(offset, bits))),
            First::Before(offset, bits) => Some(Place::Between(self.lower.clone(), at(offset, bits))),
        })
    }

    /// The upper half and, to be looked at first, the lower one.
    fn halves(&self) -> [Interval; 2] {
        let leap = (self.leap / 2).max(SHORTEST_LEAP);
        let lower = self.part(&BigInt::zero(), 1, 0).with_leap(leap);
        let upper = Interval {
            lower: &lower.lower + &lower.width,
            width: lower.width.clone(),
            local: lower.local.clone().shifted(&BigInt::one()),
            leap,
        };
        [upper, lower]
    }

    /// The part from offset/2^bits on that is 2^stretch/2^bits long, as fractions of the whole.
    fn part(&self, offset: &BigInt, bits: u32, stretch: u32) -> Interval {
        let bits = i64::from(bits);
        let stretch = i64::from(stretch);
        let unit = &self.width * power_of_two(-bits);
        Interval {
            lower: &self.lower + &unit * number::integer(offset.clone()),
            width: unit * power_of_two(stretch),
            local: self.local.clone().stretched(-bits).shifted(offset).stretched(stretch),
            leap: self.leap,
        }
    }

    fn with_leap(self, leap: u32) -> Interval {
        Interval { leap, ..self }
    }
}

impl FirstRoot {
    /// Compares the root to the power `numerator/denominator` of a positive number.
    ///
    /// Both sides are raised to `denominator`. Halving the interval decides unless they are equal, and equal they are
    /// if the polynomial shares a root in the interval with x^denominator - number^numerator, which has one positive
    /// root.
    pub(crate) fn compare_to_power(
        &mut self,
        number: &Rational,
        numerator: u32,
        denominator: u32,
    ) -> Ordering {
        let power = Pow::pow(number, numerator);
        let mut checked = false;
        loop {
            let (lower, upper) = match &self.place {
                Place::At(root) => return Pow::pow(root, denominator).cmp(&power),
                Place::Between(lower, upper) => (lower, upper),
            };
            if Pow::pow(lower, denominator) >= power {
                return Ordering::Greater;
            }
            if Pow::pow(upper, denominator) <= power {
                return Ordering::Less;
            }
            if !checked && self.satisfies(&power, denominator) {
                return Ordering::Equal;
            }
            checked = true;
            self.halve();
        }
    }

    /// Whether the root to this power is that number.
    fn satisfies(&self, power: &Rational, denominator: u32) -> bool {
        let Place::Between(lower, upper) = &self.place else { return false };
        let mut coefficients = vec![BigInt::zero(); denominator as usize];
        coefficients.push(power.denom().clone());
        if let Some(constant) = coefficients.first_mut() {
            *constant = -power.numer();
        }
        let shared = common_divisor(&self.polynomial, &IntegerPolynomial::new(coefficients));
        shared.degree() > 0 && shared.sign_at(lower) != shared.sign_at(upper)
    }

    /// Halves the interval once.
    fn halve(&mut self) {
        let Place::Between(lower, upper) = &self.place else { return };
        let middle = middle(lower, upper);
        // No root lies below this one, so the sign on its left is the sign at 0.
        self.place = match self.polynomial.sign_at(&middle) {
            Ordering::Equal => Place::At(middle),
            sign if sign == self.polynomial.sign_at(&Rational::zero()) => {
                Place::Between(middle, upper.clone())
            }
            _ => Place::Between(lower.clone(), middle),
        };
    }

    /// Narrows the root to an interval that is 2^-bits of its upper end.
    pub(crate) fn narrow(&mut self, bits: i64) {
        while let Place::Between(lower, upper) = &self.place
            && (upper - lower) > upper * power_of_two(-bits)
        {
            self.halve();
        }
    }

    /// The root to within a factor of two, as a power of two.
    pub(crate) fn binary_exponent(&self) -> i64 {
        let (Place::At(root) | Place::Between(_, root)) = &self.place;
        (root.numer().bits() as i64).saturating_sub(root.denom().bits() as i64)
    }
}

/// A number near the middle of an interval, with no more digits than it takes to lie there.
fn middle(lower: &Rational, upper: &Rational) -> Rational {
    let width = upper - lower;
    let unit = power_of_two(width.numer().bits() as i64 - width.denom().bits() as i64 - 3);
    ((lower + upper) / (number::integer(2) * &unit)).round() * unit
}

fn power_of_two(exponent: i64) -> Rational {
    let power = BigInt::one() << exponent.unsigned_abs();
    let power = number::integer(power);
    if exponent < 0 { power.recip() } else { power }
}
