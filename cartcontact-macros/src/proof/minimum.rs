//! Whether a convex polynomial that is positive at both ends of an interval has roots inside.
//!
//! Two roots that nearly meet, or a minimum just above zero, would take a division of the interval for every bit by
//! which they miss. Where the polynomial is convex, its minimum decides: the root of the slope p' is narrowed until
//! either p <= 0 somewhere, or a tangent to the left of the minimum, which p stays above, is still positive to the
//! right of it.
//!
//! The root of the slope is narrowed by quadratic interval refinement: the interval is divided into 2^b parts, the
//! secant says which one to try, and if the root is in it, b is doubled, otherwise halved.
//!
//! Values are computed in fixed point by Horner's rule, from coefficients cut to as many digits. Its argument x is at
//! most 2, and every coefficient and every product is less than one off, so that values are less than 2^(n+2) units from
//! the true ones, and slopes less than (n + 1) 2^(n+1). A sign that this leaves open is taken from the exact polynomial
//! if its numbers are no longer there, or else asked for again with more digits.
//!
//! Termination: the roots are simple, so p is not 0 where p' is; near the minimum either it is negative, or the
//! tangents come arbitrarily close to it.
//!
//! J. Abbott, Quadratic interval refinement for real roots, ACM Commun. Comput. Algebra 48 (2014) 3-12, doi
//! 10.1145/2644288.2644291.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::proof::integer_polynomial::{IntegerPolynomial, derivative};
use crate::proof::part::{Part, Whole};

/// Where the first root in a part is, in units of its length.
#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) enum First {
    None,
    /// At offset/2^bits.
    At(BigInt, u64),
    /// Alone between 0 and offset/2^bits.
    Before(BigInt, u64),
}

/// The errors of the coefficients might change the answer.
#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Undecided;

/// From lower/2^bits to upper/2^bits of the part the slope changes its sign, if anywhere.
pub(crate) struct Bracket {
    lower: BigInt,
    upper: BigInt,
    bits: u64,
    /// The next step divides it into 2^leap.
    leap: u64,
}

impl Bracket {
    pub(crate) fn whole() -> Self {
        Bracket { lower: BigInt::zero(), upper: BigInt::one(), bits: 0, leap: 2 }
    }
}

/// The point offset/2^bits of the part with the slope of the polynomial.
struct Point {
    offset: BigInt,
    bits: u64,
    slope: BigInt,
}

/// A polynomial that is convex over a part of the interval from 1 to 2, and positive at both ends.
pub(crate) struct Convex<'a> {
    exact: &'a Whole<'a>,
    part: &'a Part,
    /// Less than a unit from the true ones.
    coefficients: Vec<BigInt>,
    /// Those of the slope.
    slope: Vec<BigInt>,
    digits: u64,
    /// Values, slopes, and their sums are less than 2^margin units from the true ones.
    margin: u64,
}

impl<'a> Convex<'a> {
    /// With so many digits behind those that the evaluation loses.
    pub(crate) fn new(exact: &'a Whole<'a>, part: &'a Part, digits: u64) -> Self {
        let degree = exact.degree();
        let margin = degree + u64::from(u64::BITS - (degree + 1).leading_zeros()) + 3;
        let digits = digits + margin;
        let coefficients = exact.coefficients(digits);
        let slope = derivative(&coefficients);
        Convex { exact, part, coefficients, slope, digits, margin }
    }

    /// The first root, from what is known about the minimum; what more is learnt stays if that is not enough.
    pub(crate) fn first_root(&self, minimum: &mut Bracket) -> Result<First, Undecided> {
        let mut lower = self.point(minimum.lower.clone(), minimum.bits);
        let mut upper = self.point(minimum.upper.clone(), minimum.bits);
        if self.rises_at(&lower)? || !self.rises_at(&upper)? {
            return Ok(First::None);
        }
        // The polynomial falls at the lower point, or is flat, and rises at the upper one.
        loop {
            let value = self.at(&self.coefficients, &lower.offset, lower.bits);
            if self.stays_above_tangent(&lower, &value, &upper) {
                return Ok(First::None);
            }
            if let Some(found) = self.found(&lower, &value)? {
                return Ok(found);
            }
            let leap;
            (lower, upper, leap) = self.narrowed(lower, upper, minimum.leap)?;
            *minimum =
                Bracket { lower: lower.offset.clone(), upper: upper.offset.clone(), bits: lower.bits, leap };
        }
    }

    /// One step of the refinement: the two points and the next leap.
    fn narrowed(&self, lower: Point, upper: Point, leap: u64) -> Result<(Point, Point, u64), Undecided> {
        let bits = lower.bits + leap;
        if bits > self.digits {
            return Err(Undecided);
        }
        let [from, to] = cell(&lower, &upper, leap);
        // The ends that stay are written with the new bits.
        let finer = |point: Point| Point { offset: point.offset << leap, bits, ..point };
        let from = self.point(from, bits);
        if self.rises_at(&from)? {
            return Ok((finer(lower), from, (leap / 2).max(1)));
        }
        let to = self.point(to, bits);
        Ok(match self.rises_at(&to)? {
            true => (from, to, leap * 2),
            false => (to, finer(upper), (leap / 2).max(1)),
        })
    }

    fn point(&self, offset: BigInt, bits: u64) -> Point {
        let slope = self.at(&self.slope, &offset, bits);
        Point { offset, bits, slope }
    }

    /// The value of a polynomial at offset/2^bits of the part, by Horner's rule.
    fn at(&self, coefficients: &[BigInt], offset: &BigInt, bits: u64) -> BigInt {
        let point = self.part.within(offset, bits, bits);
        let x = point.end(0);
        let ascending = coefficients.iter().rev();
        ascending.fold(BigInt::zero(), |value, coefficient| ((value * &x) >> point.bits) + coefficient)
    }

    /// The sign of a number, if its error cannot change it.
    fn sign(&self, number: &BigInt) -> Option<Ordering> {
        (number.bits() > self.margin).then(|| number.cmp(&BigInt::zero()))
    }

    /// The exact sign of a polynomial at offset/2^bits of the part, if the numbers are no longer than those computed
    /// with.
    fn exact_sign(&self, polynomial: &IntegerPolynomial, offset: &BigInt, bits: u64) -> Option<Ordering> {
        let point = self.part.within(offset, bits, bits);
        let is_short = self.exact.length + point.bits * self.exact.degree() <= self.digits;
        is_short.then(|| self.exact.sign_of(polynomial, &point, 0))
    }

    fn rises_at(&self, point: &Point) -> Result<bool, Undecided> {
        let exactly = || self.exact_sign(&self.exact.polynomial.derivative(), &point.offset, point.bits);
        self.sign(&point.slope).or_else(exactly).map(Ordering::is_gt).ok_or(Undecided)
    }

    /// Whether the tangent in one point is certainly positive up to another; the polynomial lies above it.
    fn stays_above_tangent(&self, point: &Point, value: &BigInt, other: &Point) -> bool {
        let distance = &other.offset - &point.offset;
        let tangent = value + ((&point.slope * distance) >> (point.bits + self.part.width));
        self.sign(&tangent) == Some(Ordering::Greater)
    }

    /// What the value at a point where the polynomial falls or is flat says about the first root.
    fn found(&self, point: &Point, value: &BigInt) -> Result<Option<First>, Undecided> {
        let exactly = || self.exact_sign(self.exact.polynomial, &point.offset, point.bits);
        let found = match self.sign(value).or_else(exactly).ok_or(Undecided)? {
            Ordering::Greater => return Ok(None),
            Ordering::Less => First::Before,
            Ordering::Equal => First::At,
        };
        Ok(Some(found(point.offset.clone(), point.bits)))
    }
}

/// The ends of the part in which the secant of the slope has its root, of 2^leap parts, each as long as the whole was
/// in units of its bits.
fn cell(lower: &Point, upper: &Point, leap: u64) -> [BigInt; 2] {
    let width = &upper.offset - &lower.offset;
    let index = (-&lower.slope << leap) / (&upper.slope - &lower.slope);
    let index = index.min((BigInt::one() << leap) - 1);
    let from = (&lower.offset << leap) + &width * index;
    [from.clone(), from + width]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x - 4/3)^2 + height/2^bits, times 9 * 2^bits.
    fn parabola(height: i64, bits: u64) -> IntegerPolynomial {
        let unit = BigInt::one() << bits;
        IntegerPolynomial::new(vec![&unit * 16 + height * 9, &unit * -24, unit * 9])
    }

    fn first(polynomial: &IntegerPolynomial, digits: u64) -> Result<First, Undecided> {
        Convex::new(&Whole::new(polynomial, 0), &Part::whole(), digits).first_root(&mut Bracket::whole())
    }

    #[test]
    fn the_minimum_decides() {
        for bits in [4, 40, 400] {
            assert_eq!(first(&parabola(1, bits), bits + 10), Ok(First::None));
            let below = parabola(-1, bits);
            let Ok(First::Before(offset, own)) = first(&below, bits + 10) else { unreachable!("2^-{bits}") };
            let x = (BigInt::one() << own) + offset;
            assert_eq!(below.value_at(&x, own).cmp(&BigInt::zero()), Ordering::Less);
        }
        assert_eq!(first(&parabola(0, 1), 1 << 10), Err(Undecided));
    }

    #[test]
    fn errors_of_the_coefficients_are_kept_in_mind() {
        for height in [1, -1] {
            assert_eq!(first(&parabola(height, 40), 30), Err(Undecided));
        }
        assert_eq!(first(&parabola(1 << 38, 40), 30), Ok(First::None));
    }

    #[test]
    fn a_root_that_is_met_is_found() {
        // (4 x - 5)(4 x - 7), with its minimum in the middle of the interval.
        let exact = IntegerPolynomial::new([35, -48, 16].map(BigInt::from).into());
        assert_eq!(first(&exact, 40), Ok(First::Before(2.into(), 2)));
    }
}
