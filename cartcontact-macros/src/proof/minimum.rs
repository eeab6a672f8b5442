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
//! Values are computed in fixed point, with as many digits as the coefficients have. They are less than 2 (n + 1) units
//! from the true ones, slopes less than 2 (n + 1)^2, as every coefficient and every product is less than one off. A sign
//! that this leaves open is taken from the exact polynomial if its numbers are no longer there, or else asked for
//! again with more digits.
//!
//! Termination: the roots are simple, so p is not 0 where p' is; near the minimum either it is negative, or the
//! tangents come arbitrarily close to it.
//!
//! J. Abbott, Quadratic interval refinement for real roots, ACM Commun. Comput. Algebra 48 (2014) 3-12, doi
//! 10.1145/2644288.2644291.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::proof::integer_polynomial::IntegerPolynomial;

/// Where the first root in the interval from 0 to 1 is.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum First {
    None,
    /// At offset/2^bits.
    At(BigInt, u64),
    /// Alone between 0 and offset/2^bits.
    Before(BigInt, u64),
}

/// The errors of the coefficients might change the answer.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Undecided;

/// The point offset/2^bits with the slope of the polynomial.
struct Point {
    offset: BigInt,
    bits: u64,
    slope: BigInt,
}

/// A polynomial that is convex from 0 to 1 and positive at both.
#[derive(Debug)]
pub(crate) struct Convex {
    /// Less than a unit from the true ones.
    polynomial: IntegerPolynomial,
    slope: IntegerPolynomial,
    /// Values, slopes, and their sums are less than 2^margin units from the true ones.
    margin: u64,
}

/// The exact signs of value and slope at offset/2^bits.
pub(crate) trait Exact {
    fn value(&self, offset: &BigInt, bits: u64) -> Ordering;
    fn slope(&self, offset: &BigInt, bits: u64) -> Ordering;
}

impl Convex {
    /// From coefficients that are less than a unit from the true ones.
    pub(crate) fn new(polynomial: IntegerPolynomial) -> Self {
        let log_degree = u64::from(u64::BITS - (polynomial.degree() as u64 + 1).leading_zeros());
        Convex { slope: polynomial.derivative(), polynomial, margin: 2 * log_degree + 2 }
    }

    /// The first root from 0 to 1.
    pub(crate) fn first_root(&self, exact: &impl Exact) -> Result<First, Undecided> {
        let [mut lower, mut upper] = [0, 1].map(|end| self.point(end.into(), 0));
        if self.rises_at(&lower, exact)? || !self.rises_at(&upper, exact)? {
            return Ok(First::None);
        }
        let mut leap = 1;
        // The polynomial falls at the lower point, or is flat, and rises at the upper one.
        loop {
            let value = at(&self.polynomial, &lower.offset, lower.bits);
            if self.stays_above_tangent(&lower, &value, &upper) {
                return Ok(First::None);
            }
            if let Some(found) = self.found(&lower, &value, exact)? {
                return Ok(found);
            }
            (lower, upper, leap) = self.narrowed(lower, upper, leap, exact)?;
        }
    }

    /// One step of the refinement: the two points and the next leap.
    fn narrowed(
        &self,
        lower: Point,
        upper: Point,
        leap: u64,
        exact: &impl Exact,
    ) -> Result<(Point, Point, u64), Undecided> {
        let bits = lower.bits + leap;
        if bits > self.polynomial.length() {
            return Err(Undecided);
        }
        let [from, to] = cell(&lower, &upper, leap);
        // The ends that stay are written with the new bits.
        let finer = |point: Point| Point { offset: point.offset << leap, bits, ..point };
        let from = self.point(from, bits);
        if self.rises_at(&from, exact)? {
            return Ok((finer(lower), from, (leap / 2).max(1)));
        }
        let to = self.point(to, bits);
        Ok(match self.rises_at(&to, exact)? {
            true => (from, to, leap * 2),
            false => (to, finer(upper), (leap / 2).max(1)),
        })
    }

    fn point(&self, offset: BigInt, bits: u64) -> Point {
        let slope = at(&self.slope, &offset, bits);
        Point { offset, bits, slope }
    }

    /// The sign of a number, if its error cannot change it.
    fn sign(&self, number: &BigInt) -> Option<Ordering> {
        (number.bits() > self.margin).then(|| number.cmp(&BigInt::zero()))
    }

    /// Whether an exact number at a point is no longer than those computed with.
    fn is_short(&self, point: &Point) -> bool {
        point.bits * self.polynomial.degree() as u64 <= self.polynomial.length()
    }

    fn rises_at(&self, point: &Point, exact: &impl Exact) -> Result<bool, Undecided> {
        let exactly = || self.is_short(point).then(|| exact.slope(&point.offset, point.bits));
        self.sign(&point.slope).or_else(exactly).map(Ordering::is_gt).ok_or(Undecided)
    }

    /// Whether the tangent in one point is certainly positive up to another; the polynomial lies above it.
    fn stays_above_tangent(&self, point: &Point, value: &BigInt, other: &Point) -> bool {
        let tangent = value + ((&point.slope * (&other.offset - &point.offset)) >> point.bits);
        self.sign(&tangent) == Some(Ordering::Greater)
    }

    /// What the value at a point where the polynomial falls or is flat says about the first root.
    fn found(&self, point: &Point, value: &BigInt, exact: &impl Exact) -> Result<Option<First>, Undecided> {
        let exactly = || self.is_short(point).then(|| exact.value(&point.offset, point.bits));
        let found = match self.sign(value).or_else(exactly).ok_or(Undecided)? {
            Ordering::Greater => return Ok(None),
            Ordering::Less => First::Before,
            Ordering::Equal => First::At,
        };
        Ok(Some(found(point.offset.clone(), point.bits)))
    }
}

/// The value of a polynomial at offset/2^bits, by Horner's rule.
fn at(polynomial: &IntegerPolynomial, offset: &BigInt, bits: u64) -> BigInt {
    let coefficients = polynomial.coefficients().iter().rev();
    coefficients.fold(BigInt::zero(), |value, coefficient| ((value * offset) >> bits) + coefficient)
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

    /// (x - 1/3)^2 + height/2^bits, times 9 * 2^bits.
    fn parabola(height: i64, bits: u64) -> IntegerPolynomial {
        let unit = BigInt::one() << bits;
        IntegerPolynomial::new(vec![&unit + height * 9, &unit * -6, unit * 9])
    }

    impl Exact for IntegerPolynomial {
        fn value(&self, offset: &BigInt, bits: u64) -> Ordering {
            self.value_at(offset, bits).cmp(&BigInt::zero())
        }

        fn slope(&self, offset: &BigInt, bits: u64) -> Ordering {
            self.derivative().value_at(offset, bits).cmp(&BigInt::zero())
        }
    }

    /// With more digits in units of 2^-more.
    fn first(height: i64, bits: u64, more: u64) -> Result<First, Undecided> {
        let exact = parabola(height, bits);
        let finer = exact.coefficients().iter().map(|coefficient| coefficient << more).collect();
        Convex::new(IntegerPolynomial::new(finer)).first_root(&exact)
    }

    #[test]
    fn the_minimum_decides() {
        for bits in [4, 40, 400] {
            assert_eq!(first(1, bits, 10), Ok(First::None));
            let Ok(First::Before(offset, own)) = first(-1, bits, 10) else { unreachable!("2^-{bits}") };
            assert_eq!(parabola(-1, bits).value_at(&offset, own).cmp(&BigInt::zero()), Ordering::Less);
        }
        assert_eq!(first(0, 1, 1 << 10), Err(Undecided));
    }

    #[test]
    fn errors_of_the_coefficients_are_kept_in_mind() {
        for height in [1, -1] {
            assert_eq!(first(height, 40, 0), Err(Undecided));
        }
        assert_eq!(first(1 << 38, 40, 0), Ok(First::None));
    }

    #[test]
    fn a_root_that_is_met_is_found() {
        // (4 x - 1)(4 x - 3), with its minimum in the middle of the interval.
        let exact =
            IntegerPolynomial::new([3, -16, 16].map(|coefficient| BigInt::from(coefficient) << 40).into());
        assert_eq!(Convex::new(exact.clone()).first_root(&exact), Ok(First::Before(1.into(), 1)));
    }
}
