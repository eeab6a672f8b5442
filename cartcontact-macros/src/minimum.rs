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
//! Termination: the roots are simple, so p is not 0 where p' is; near the minimum either it is negative, or the
//! tangents come arbitrarily close to it.
//!
//! J. Abbott, Quadratic interval refinement for real roots, ACM Commun. Comput. Algebra 48 (2014) 3-12, doi
//! 10.1145/2644288.2644291.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::integer_polynomial::IntegerPolynomial;

/// Where the first root in the interval from 0 to 1 is.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum First {
    None,
    /// At offset/2^bits.
    At(BigInt, u64),
    /// Alone between 0 and offset/2^bits.
    Before(BigInt, u64),
}

/// The errors of the coefficients might change the answer, or it would take longer numbers than the limit.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Undecided;

/// The point offset/2^bits with the values of polynomial and slope, times the powers of two that make them integers.
struct Point {
    offset: BigInt,
    bits: u64,
    value: BigInt,
    slope: BigInt,
}

struct Convex<'a> {
    polynomial: &'a IntegerPolynomial,
    slope: IntegerPolynomial,
    /// Values, slopes, and their sums are less than 2^margin from the true ones; nothing if they are exact.
    margin: Option<u64>,
}

/// The first root from 0 to 1 of a polynomial that is convex and positive at both; its coefficients are less than
/// 2^error from the true ones, if they are not exact.
pub(crate) fn first_of_convex(
    polynomial: &IntegerPolynomial,
    error: Option<u64>,
    limit: u64,
) -> Result<First, Undecided> {
    let log_degree = u64::from(u64::BITS - (polynomial.degree() as u64 + 1).leading_zeros());
    let margin = error.map(|error| error + 2 * log_degree + 1);
    let convex = Convex { polynomial, slope: polynomial.derivative(), margin };
    let [mut lower, mut upper] = [0, 1].map(|end| convex.at(end.into(), 0));
    let mut leap = 1;
    while convex.slope_at(&lower)?.is_lt() && convex.slope_at(&upper)?.is_gt() {
        if convex.stays_above_tangent(&lower, &upper) {
            return Ok(First::None);
        }
        let bits = lower.bits + leap;
        if bits * polynomial.degree() as u64 > limit {
            return Err(Undecided);
        }
        let [from, to] = cell(&lower, &upper, leap).map(|offset| convex.at(offset, bits));
        for point in [&from, &to] {
            if let Some(found) = convex.found(point)? {
                return Ok(found);
            }
        }
        // The ends that stay are written with the new bits.
        let finer = |point: Point| convex.at(point.offset << leap, bits);
        (lower, upper, leap) = match (convex.slope_at(&from)?.is_lt(), convex.slope_at(&to)?.is_gt()) {
            (true, true) => (from, to, leap * 2),
            (true, false) => (to, finer(upper), (leap / 2).max(1)),
            (false, _) => (finer(lower), from, (leap / 2).max(1)),
        };
    }
    Ok(First::None)
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

impl Convex<'_> {
    fn at(&self, offset: BigInt, bits: u64) -> Point {
        let (value, slope) = (self.polynomial.value_at(&offset, bits), self.slope.value_at(&offset, bits));
        Point { offset, bits, value, slope }
    }

    /// The sign of a number that was multiplied by 2^scale.
    fn sign(&self, scaled: &BigInt, scale: u64) -> Result<Ordering, Undecided> {
        match self.margin {
            Some(margin) if scaled.bits() <= margin + scale => Err(Undecided),
            _ => Ok(scaled.cmp(&BigInt::zero())),
        }
    }

    fn scale(&self, point: &Point) -> u64 {
        point.bits * self.polynomial.degree() as u64
    }

    fn slope_at(&self, point: &Point) -> Result<Ordering, Undecided> {
        self.sign(&point.slope, self.scale(point) - point.bits)
    }

    /// Whether the tangent in one point is certainly positive up to another; the polynomial lies above it.
    fn stays_above_tangent(&self, point: &Point, other: &Point) -> bool {
        let tangent = &point.value + &point.slope * (&other.offset - &point.offset);
        self.sign(&tangent, self.scale(point)) == Ok(Ordering::Greater)
    }

    /// What a point says about the first root.
    fn found(&self, point: &Point) -> Result<Option<First>, Undecided> {
        let offset = || point.offset.clone();
        Ok(match (self.sign(&point.value, self.scale(point))?, self.slope_at(point)) {
            (Ordering::Greater, _) => None,
            (Ordering::Less, _) | (_, Ok(Ordering::Greater)) => Some(First::Before(offset(), point.bits)),
            (Ordering::Equal, _) => Some(First::At(offset(), point.bits)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x - 1/3)^2 + height/2^bits, times 9 * 2^bits.
    fn parabola(height: i64, bits: u64) -> IntegerPolynomial {
        let unit = BigInt::one() << bits;
        IntegerPolynomial::new(vec![&unit + height * 9, &unit * -6, unit * 9])
    }

    fn first(height: i64, bits: u64) -> Result<First, Undecided> {
        first_of_convex(&parabola(height, bits), None, 1 << 16)
    }

    #[test]
    fn the_minimum_decides() {
        for bits in [4, 40, 400] {
            assert_eq!(first(1, bits), Ok(First::None));
            let Ok(First::Before(offset, own)) = first(-1, bits) else { unreachable!("2^-{bits}") };
            assert_eq!(parabola(-1, bits).value_at(&offset, own).cmp(&BigInt::zero()), Ordering::Less);
        }
        let touching = first_of_convex(&parabola(0, 1), None, 1 << 10);
        assert_eq!(touching, Err(Undecided));
    }

    #[test]
    fn errors_of_the_coefficients_are_kept_in_mind() {
        for height in [1, -1] {
            assert_eq!(first_of_convex(&parabola(height, 40), Some(44), 1 << 16), Err(Undecided));
        }
        assert_eq!(first_of_convex(&parabola(1 << 38, 40), Some(20), 1 << 16), Ok(First::None));
    }
}
