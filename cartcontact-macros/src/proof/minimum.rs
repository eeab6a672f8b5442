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
//! Values are computed in fixed point by Horner's rule, with the powers of a point of the part. Bernstein's
//! coefficients are less than e units off, so that the polynomial is, and its slope less than 2 n e; the powers follow
//! from them exactly. Every product is less than one unit off and does not grow any more. While the minimum is known
//! to few digits, values are computed with about twice as many, which is what a secant can use. A sign that this
//! leaves open is computed with all of them, taken from the exact polynomial if its numbers are no longer there, or
//! else asked for again with more digits.
//!
//! Termination: the roots are simple, so p is not 0 where p' is; near the minimum either it is negative, or the
//! tangents come arbitrarily close to it.
//!
//! J. Abbott, Quadratic interval refinement for real roots, ACM Commun. Comput. Algebra 48 (2014) 3-12, doi
//! 10.1145/2644288.2644291.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::proof::bernstein::Bernstein;
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

    /// A part that begins with the bracket and is less than twice as long; the bracket is one of this part then.
    pub(crate) fn part(&mut self, part: &Part) -> Part {
        let length = &self.upper - &self.lower;
        let bits = (&length - 1_u32).bits();
        let closer = part.within(&self.lower, self.bits, self.bits - bits);
        *self = Bracket { lower: BigInt::zero(), upper: length, bits, leap: self.leap };
        closer
    }
}

/// The point offset/2^bits of the part with the slope of the polynomial.
struct Point {
    offset: BigInt,
    bits: u64,
    slope: Value,
}

/// A number less than 2^margin units from the true one.
struct Value {
    number: BigInt,
    margin: u64,
}

impl Value {
    /// The sign, if the error cannot change it.
    fn sign(&self) -> Option<Ordering> {
        (self.number.bits() > self.margin).then(|| self.number.cmp(&BigInt::zero()))
    }
}

/// A polynomial that is convex over a part of the interval from 1 to 2, and positive at both ends.
pub(crate) struct Convex<'a> {
    exact: &'a Whole<'a>,
    part: &'a Part,
    /// In powers from the beginning of the part on.
    coefficients: Vec<BigInt>,
    /// Those of the slope.
    slope: Vec<BigInt>,
    digits: u64,
    /// Of the longest coefficient of the slope, in bits.
    length: u64,
    /// Values, slopes, and their sums are less than 2^margin units from the true ones.
    margin: u64,
}

impl<'a> Convex<'a> {
    /// With Bernstein's coefficients over the part, in units of which the longest coefficient of the whole has so many
    /// digits.
    pub(crate) fn new(exact: &'a Whole<'a>, part: &'a Part, local: &Bernstein, digits: u64) -> Self {
        let coefficients = local.powers();
        let slope = derivative(&coefficients);
        let length = slope.iter().map(BigInt::bits).max().unwrap_or(0);
        let error = 4 * i128::from(exact.degree() + 1) * (local.error() + 1);
        let margin = u64::from(i128::BITS - error.leading_zeros());
        Convex { exact, part, coefficients, slope, digits, length, margin }
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
            let value = self.at(&self.coefficients, &lower.offset, lower.bits, 2 * lower.bits);
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
        if bits > self.length {
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
        let slope = self.at(&self.slope, &offset, bits, 2 * bits);
        Point { offset, bits, slope }
    }

    /// The value of a polynomial at offset/2^bits of the part, with about so many digits if they are enough for its
    /// sign.
    fn at(&self, coefficients: &[BigInt], offset: &BigInt, bits: u64, digits: u64) -> Value {
        // Behind what is lost where the terms cancel.
        let digits = digits + 2 * self.exact.degree() + u64::from(u64::BITS);
        let few = self.cut_at(coefficients, offset, bits, self.length.saturating_sub(digits));
        if few.sign().is_none() { self.cut_at(coefficients, offset, bits, 0) } else { few }
    }

    /// By Horner's rule, from coefficients without their last digits.
    fn cut_at(&self, coefficients: &[BigInt], offset: &BigInt, bits: u64, cut: u64) -> Value {
        let mut number = BigInt::zero();
        for coefficient in coefficients.iter().rev() {
            number = (number * offset) >> bits;
            match cut {
                0 => number += coefficient,
                _ => number += coefficient >> cut,
            }
        }
        Value { number: number << cut, margin: self.margin + cut }
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
        point.slope.sign().or_else(exactly).map(Ordering::is_gt).ok_or(Undecided)
    }

    /// Whether the tangent in one point is certainly positive up to another; the polynomial lies above it.
    fn stays_above_tangent(&self, point: &Point, value: &Value, other: &Point) -> bool {
        let distance = &other.offset - &point.offset;
        let number = &value.number + ((&point.slope.number * distance) >> point.bits);
        let margin = value.margin.max(point.slope.margin);
        Value { number, margin }.sign() == Some(Ordering::Greater)
    }

    /// What the value at a point where the polynomial falls or is flat says about the first root.
    fn found(&self, point: &Point, value: &Value) -> Result<Option<First>, Undecided> {
        let exactly = || self.exact_sign(self.exact.polynomial, &point.offset, point.bits);
        let found = match value.sign().or_else(exactly).ok_or(Undecided)? {
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
    let index = (-&lower.slope.number << leap) / (&upper.slope.number - &lower.slope.number);
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
        let (whole, part) = (Whole::new(polynomial, 0), Part::whole());
        Convex::new(&whole, &part, &whole.over(&part, digits), digits).first_root(&mut Bracket::whole())
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
