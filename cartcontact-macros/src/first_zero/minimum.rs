//! Whether a convex polynomial that is positive at both ends of an interval, and falls at first, has roots inside.
//!
//! Two roots that nearly meet, or a minimum just above zero, would take a division of the interval for every bit by
//! which they miss. Where the curvature is at least m > 0, one point l near the minimum decides: either p(l) < 0, or
//! p stays above p(l) − p'(l)²/(2 m), as p(x) >= p(l) + p'(l) (x − l) + m (x − l)²/2. Newton's method for the root of
//! p' leads to such points; where a step leads out of the bracket of the minimum, or is not half as long as the one
//! before it, the bracket is halved instead.
//!
//! A point that is 2^-b from the minimum makes p(l) − p'(l)²/(2 m) differ from the least value by about m 2^-2b. So
//! values and slopes are computed to 2^-16 of that, and each point has about twice the bits of the step that led to it.
//! A value that does not decide yet tells how many bits will; at points with fewer bits no value is computed.
//!
//! Termination: the roots are simple, so p is not 0 where p' is. The points come arbitrarily close to the minimum and
//! their values arbitrarily close to the true ones; so p(l) is found to be negative or to exceed p'(l)²/(2 m). A value
//! that does not decide postpones the next one by a limited number of bits.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::first_zero::TooIntricate;
use crate::first_zero::part::Part;
use crate::first_zero::source::Source;
use crate::number::shifted;

/// The search for the minimum of a polynomial over a part.
pub(crate) struct Minimum<'a> {
    part: &'a Part,
    source: Source<'a>,
    /// A lower bound of the curvature, in units of 2^-digits.
    curvature: BigInt,
    digits: u64,
    bracket: Bracket,
    /// A step to the next point is accepted if it is shorter than 2^-steady of the part.
    steady: i64,
}

/// The point offset/2^bits of the part.
struct Point {
    offset: BigInt,
    bits: u64,
}

/// A value or a slope over the part, in units of 2^-digits and less than `error` units from the true one.
struct Approximate {
    number: BigInt,
    error: u64,
    digits: i64,
}

/// Between lower/2^bits and upper/2^bits of the part.
#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Bracket {
    pub(crate) lower: BigInt,
    pub(crate) upper: BigInt,
    pub(crate) bits: u64,
}

/// The bits of the first point; no point has fewer.
const FEWEST_BITS: u64 = 16;
/// Values are computed to 2^-16 of what the bits of the point are worth.
const SPARE_BITS: u64 = 16;

impl<'a> Minimum<'a> {
    /// The search in a polynomial from this source, with a lower bound of its curvature in units of 2^-digits.
    pub(crate) fn new(part: &'a Part, source: &Source<'a>, curvature: BigInt, digits: u64) -> Self {
        let bracket = Bracket { lower: BigInt::zero(), upper: BigInt::one(), bits: 0 };
        Minimum { part, source: source.clone(), curvature, digits, bracket, steady: 0 }
    }

    /// A bracket of the first root alone, if there is a root. The minimum is sought from `first` on, in units of 2^-16
    /// of the part. The bits of a point that were `enough` for the last minimum are likely to be enough again; zero if there was none.
    pub(crate) fn roots(
        mut self,
        first: u64,
        enough: &mut u64,
        most_digits: u64,
    ) -> Result<Option<Bracket>, TooIntricate> {
        let mut point = Point { offset: first.into(), bits: FEWEST_BITS };
        // Asks at once for the digits that are likely to be needed last: every later request for more takes as long.
        self.source.for_values(self.digits_for(2 * *enough).clamp(1, most_digits as i64) as u64);
        loop {
            let digits = self.digits_for(2 * point.bits).max(1);
            if digits > most_digits as i64 {
                return Err(TooIntricate);
            }
            let value = (point.bits >= *enough).then(|| self.value(&point, digits));
            if let Some(value) = &value
                && let Some(roots) = self.roots_beside(&point, value, enough)
            {
                return Ok(roots);
            }
            let slope = self.slope(&point, digits);
            self.bracket.take(&point, &slope);
            let (curvature, _) = self.derivative(2, &point, self.digits_for(point.bits));
            if let Some(value) = value {
                *enough = self.likely_enough(&point, &value, &slope, &curvature).unwrap_or(*enough);
            }
            point = self.newton(&point, &slope, curvature, *enough).unwrap_or_else(|| self.halved());
        }
    }

    /// The digits for a quantity about as large as the curvature times 2^-bits.
    fn digits_for(&self, bits: u64) -> i64 {
        (self.digits + bits + SPARE_BITS) as i64 - self.curvature.bits() as i64
    }

    /// What the value and the slope at a point say. The slope is squared, so it takes half as many digits.
    fn roots_beside(&self, point: &Point, value: &Approximate, enough: &mut u64) -> Option<Option<Bracket>> {
        let slope = self.slope(point, self.digits_for(point.bits + SPARE_BITS).min(value.digits));
        let steepest = shifted(&(slope.number.abs() + slope.error), value.digits - slope.digits);
        let curvature = shifted(&self.curvature, value.digits - self.digits as i64);
        if value.number <= -BigInt::from(value.error) {
            return Some(Some(point.first_root(&(value.error - &value.number), &steepest, &curvature)));
        }
        let least = &value.number - value.error;
        let is_positive = least.is_positive() && (&curvature * &least) << 1 > &steepest * &steepest;
        is_positive.then(|| {
            *enough = curvature.bits().saturating_sub(least.bits()) / 2 + 4;
            None
        })
    }

    /// The bits of a point that are enough if the least value is that of the parabola that touches here, p − p'²/(2
    /// p''): then p''² (x − l)²/(2 m) is less. Nothing if that value is too small to be known.
    fn likely_enough(
        &self,
        point: &Point,
        value: &Approximate,
        slope: &Approximate,
        curvature: &BigInt,
    ) -> Option<u64> {
        if !curvature.is_positive() {
            return None;
        }
        let least = &value.number - ((&slope.number * &slope.number) >> (point.bits + 1)) / curvature;
        if least.bits() < SPARE_BITS / 2 {
            return None;
        }
        let least = least.bits() as i64 - slope.digits;
        let steepest = 2 * (curvature.bits() as i64 - self.digits_for(point.bits));
        let flattest = self.curvature.bits() as i64 - self.digits as i64;
        u64::try_from((steepest - flattest - least) / 2 + 2).ok().filter(|bits| *bits > point.bits)
    }

    fn value(&self, point: &Point, digits: i64) -> Approximate {
        let (number, [error, _]) = self.derivative(0, point, digits);
        Approximate { number, error, digits }
    }

    fn slope(&self, point: &Point, digits: i64) -> Approximate {
        let (number, [_, error]) = self.derivative(1, point, digits);
        Approximate { number, error, digits }
    }

    /// A derivative in units of 2^-digits, with the bounds for the errors of values and slopes.
    fn derivative(&self, order: u64, point: &Point, digits: i64) -> (BigInt, [u64; 2]) {
        let source = self.source.for_values(digits.max(0) as u64);
        let at = self.part.within(&point.offset, point.bits, point.bits);
        (source.derivative(order, &at, self.part, digits), source.errors())
    }

    /// Where Newton's method leads, if that is inside the bracket and the steps become shorter.
    fn newton(
        &mut self,
        point: &Point,
        slope: &Approximate,
        curvature: BigInt,
        enough: u64,
    ) -> Option<Point> {
        let finer = self.digits_for(point.bits) - slope.digits;
        // The step is about 2^-reach; the error of the slope is worth no more than 2^(-2 bits).
        let reach = curvature.bits() as i64 - slope.number.bits() as i64 - finer;
        let reach = reach.min(2 * point.bits as i64);
        if !curvature.is_positive() || reach <= self.steady {
            return None;
        }
        let longest = ((2 * reach + 4) as u64).min(2 * point.bits + 8).max(FEWEST_BITS);
        let bits = bits_on_the_way(enough, point.bits.max(reach as u64), longest);
        let step = shifted(&slope.number, bits as i64 + finer) / curvature;
        let offset = shifted(&point.offset, bits as i64 - point.bits as i64) - step;
        self.steady = reach.min(point.bits as i64);
        let next = Point { offset, bits };
        self.bracket.has(&next).then_some(next)
    }

    fn halved(&mut self) -> Point {
        let point = self.bracket.middle();
        self.steady = point.bits as i64 - ROOM;
        point
    }
}

impl Bracket {
    /// Takes in the sign of the slope at a point, if it is certain.
    fn take(&mut self, point: &Point, slope: &Approximate) {
        if slope.number.magnitude() < &slope.error.into() {
            return;
        }
        let bits = self.bits.max(point.bits);
        self.lower <<= bits - self.bits;
        self.upper <<= bits - self.bits;
        self.bits = bits;
        let offset = &point.offset << (bits - point.bits);
        if slope.number.is_negative() { self.lower = offset } else { self.upper = offset }
    }

    fn has(&self, point: &Point) -> bool {
        let bits = self.bits.max(point.bits);
        let offset = &point.offset << (bits - point.bits);
        &self.lower << (bits - self.bits) < offset && offset < &self.upper << (bits - self.bits)
    }

    /// A point near the middle, with no more digits than it takes to lie inside.
    fn middle(&self) -> Point {
        let length = (&self.upper - &self.lower).bits() as i64;
        let bits = (self.bits as i64 - length + ROOM).max(FEWEST_BITS as i64);
        let offset = shifted(&(&self.lower + &self.upper), bits - self.bits as i64 - 1);
        Point { offset, bits: bits as u64 }
    }
}

impl Point {
    /// Where the first root lies if this point is between two roots.
    ///
    /// At a distance d, p is at least m d²/2 − |p'| d − |p|: positive from the d on at which half of the first term is
    /// no less than each of the others.
    fn first_root(&self, depth: &BigInt, steepest: &BigInt, curvature: &BigInt) -> Bracket {
        let [depth, steepest] =
            [depth, steepest].map(|size| curvature.bits().saturating_sub(size.bits() + 3));
        let near = steepest.min(depth / 2);
        let bits = self.bits.max(near);
        let upper = &self.offset << (bits - self.bits);
        let lower = (&upper - (BigInt::one() << (bits - near))).max(BigInt::zero());
        Bracket { lower, upper, bits }
    }
}

/// The bits of the next point, of which `longest`, at least 16, can be known: so many that doubling them leads to
/// `enough` and hardly beyond, unless `enough` is reached already.
fn bits_on_the_way(enough: u64, reached: u64, longest: u64) -> u64 {
    let mut bits = enough;
    while bits > longest {
        bits = bits / 2 + 3;
    }
    if bits > reached { bits } else { longest }
}

/// The bracket is this many bits longer than the unit that its middle is rounded to.
const ROOM: i64 = 4;

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use super::*;
    use crate::first_zero::bernstein::Bernstein;
    use crate::first_zero::integer_polynomial::IntegerPolynomial;
    use crate::first_zero::part::Whole;

    /// (x - 4/3)^2 + height/2^bits, times 9 * 2^bits.
    fn parabola(height: i64, bits: u64) -> IntegerPolynomial {
        let unit = BigInt::one() << bits;
        IntegerPolynomial::new(vec![&unit * 16 + height * 9, &unit * -24, unit * 9])
    }

    fn roots(
        polynomial: &IntegerPolynomial,
        first: u64,
        most_digits: u64,
    ) -> Result<Option<Bracket>, TooIntricate> {
        let (whole, part, digits) = (Whole::new(polynomial, 0), Part::whole(), 128);
        let local = Bernstein::new(&whole.powers(digits), false);
        let minimum = Minimum::new(&part, &Source::whole(&whole), local.least_curvature(), digits);
        minimum.roots(first, &mut 0, most_digits)
    }

    #[test]
    fn the_minimum_decides() {
        for first in [1, 21_845, 40_000, 65_535] {
            for bits in [4, 40, 400] {
                assert_eq!(roots(&parabola(1, bits), first, 1 << 10), Ok(None));
                let below = parabola(-1, bits);
                let Ok(Some(Bracket { lower, upper, bits: own })) = roots(&below, first, 1 << 10) else {
                    unreachable!("2^-{bits}")
                };
                assert!((&upper - &lower) << (bits / 2) <= BigInt::from(8) << own);
                for (offset, sign) in [(lower, Ordering::Greater), (upper, Ordering::Less)] {
                    let x = (BigInt::one() << own) + offset;
                    assert_eq!(below.value_at(&x, own).cmp(&BigInt::zero()), sign);
                }
            }
            assert_eq!(roots(&parabola(0, 1), first, 1 << 10), Err(TooIntricate));
        }
    }

    #[test]
    fn doubling_leads_to_enough() {
        for enough in [17, 100, 830, 2034] {
            let mut bits = bits_on_the_way(enough, 0, FEWEST_BITS);
            let mut steps = 0;
            while bits < enough {
                bits = bits_on_the_way(enough, bits, 2 * bits + 2);
                steps += 1;
            }
            assert!(bits == enough && enough >> steps > 4, "{enough}: {bits}, {steps}");
        }
        assert_eq!(bits_on_the_way(100, 100, 204), 204);
    }

    /// x^64 - 2^60 x + 2^60 - height: the curvature grows by 2^62 over the interval, so that Newton's method leads
    /// astray.
    #[test]
    fn steps_that_lead_astray_are_not_taken() {
        let steep = |constant: i64| {
            let mut coefficients = vec![BigInt::zero(); 65];
            let unit: BigInt = BigInt::one() << 60;
            coefficients[0] = &unit * constant;
            coefficients[1] = -unit;
            coefficients[64] = BigInt::one();
            IntegerPolynomial::new(coefficients)
        };
        for first in [1, 20_000, 65_535] {
            assert_eq!(roots(&steep(2), first, 1 << 10), Ok(None));
            assert!(matches!(roots(&steep(1), first, 1 << 10), Ok(Some(_))));
        }
    }
}
