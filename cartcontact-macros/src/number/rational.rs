//! Exact fractions.
//!
//! Nothing in a macro is optimised, and nearly all of its time goes into greatest common divisors: so they are taken of
//! as few and as short numbers as possible (D. E. Knuth, The Art of Computer Programming 2, section 4.5.1), and by
//! Euclid's algorithm, which soon reaches machine numbers where a fraction meets a short one.

use core::cmp::Ordering;
use core::fmt::{Display, Formatter, Result as Written};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::number::common_factor::common_factor;

/// A fraction in lowest terms with a positive denominator; only [`new_raw`](Self::new_raw) may return one that is not
/// in lowest terms.
#[derive(Clone, PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Rational {
    numerator: BigInt,
    denominator: BigInt,
}

impl Rational {
    /// The quotient of two numbers; the second is not zero.
    pub(crate) fn new(numerator: BigInt, denominator: BigInt) -> Self {
        let common = common_factor(&numerator, &denominator);
        let common = if denominator.is_negative() { -common } else { common };
        Rational { numerator: quotient(numerator, &common), denominator: quotient(denominator, &common) }
    }

    /// The same without a search for common factors; the second number is positive.
    pub(crate) fn new_raw(numerator: BigInt, denominator: BigInt) -> Self {
        Rational { numerator, denominator }
    }

    pub(crate) fn from_integer(numerator: BigInt) -> Self {
        Rational { numerator, denominator: BigInt::one() }
    }

    /// The exact value of a finite number.
    pub(crate) fn from_float(value: f64) -> Option<Self> {
        let bits = value.abs().to_bits();
        let (fraction, exponent) = (bits & (IMPLIED_BIT - 1), (bits / IMPLIED_BIT) as i32);
        let mantissa = BigInt::from(if exponent == 0 { fraction } else { fraction + IMPLIED_BIT });
        let (up, down) = ((exponent - 1075).max(0), (1075 - exponent.max(1)).max(0));
        let size = Rational::new(mantissa << up, BigInt::one() << down);
        value.is_finite().then(|| if value < 0.0 { -size } else { size })
    }

    pub(crate) fn numer(&self) -> &BigInt {
        &self.numerator
    }

    pub(crate) fn denom(&self) -> &BigInt {
        &self.denominator
    }

    pub(crate) fn is_integer(&self) -> bool {
        self.denominator.is_one()
    }

    pub(crate) fn is_positive(&self) -> bool {
        self.numerator.is_positive()
    }

    pub(crate) fn is_negative(&self) -> bool {
        self.numerator.is_negative()
    }

    pub(crate) fn abs(&self) -> Self {
        Rational { numerator: self.numerator.abs(), denominator: self.denominator.clone() }
    }

    pub(crate) fn floor(&self) -> Self {
        Rational::from_integer(self.numerator.div_floor(&self.denominator))
    }

    pub(crate) fn ceil(&self) -> Self {
        -(-self).floor()
    }

    /// The inverse of a number that is not zero.
    pub(crate) fn recip(&self) -> Self {
        let [numerator, denominator] = [&self.denominator, &self.numerator];
        if self.is_negative() {
            Rational { numerator: -numerator, denominator: -denominator }
        } else {
            Rational { numerator: numerator.clone(), denominator: denominator.clone() }
        }
    }

    /// To an integer power, which must not be negative for zero.
    pub(crate) fn pow(&self, exponent: i32) -> Self {
        let base = if exponent < 0 { self.recip() } else { self.clone() };
        let size = exponent.unsigned_abs();
        Rational { numerator: base.numerator.pow(size), denominator: base.denominator.pow(size) }
    }

    /// The nearest `f64`; of two, the even one.
    pub(crate) fn to_f64(&self) -> f64 {
        let size = self.numerator.magnitude();
        // A quotient of 64 or 65 bits, and one more bit that stands for all that follow.
        let scale = size.bits() as i64 - self.denominator.bits() as i64 - 64;
        let up = |value: &BigUint, steps: i64| value << steps.max(0).unsigned_abs();
        let (quotient, rest) = up(size, -scale).div_rem(&up(self.denominator.magnitude(), scale));
        let digits = quotient.to_u128().unwrap_or_default() << 1 | u128::from(!rest.is_zero());
        // The last digit of an `f64` of this size is worth at least 2^-1074.
        let bits = i64::from(u128::BITS - digits.leading_zeros());
        let cut = (bits - 53).max(-1074 - (scale - 1)).clamp(0, 127) as u32;
        let (kept, tail, half) = (digits >> cut, digits & ((1 << cut) - 1), (1 << cut) >> 1);
        let rounded = if tail > half || (tail == half && kept % 2 == 1) { kept + 1 } else { kept };
        let exponent = (scale - 1 + i64::from(cut)).clamp(-2200, 2200) as i32;
        // In two steps, as the whole power may not be an `f64`.
        let value = rounded as f64 * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
        if self.is_negative() { -value } else { value }
    }

    /// `numerator/denominator` in lowest terms, if all common factors of the two divide `factor`.
    fn reduced(numerator: BigInt, denominator: BigInt, factor: &BigInt) -> Self {
        let common = common_factor(&numerator, factor);
        Rational { numerator: quotient(numerator, &common), denominator: quotient(denominator, &common) }
    }
}

/// The implied leading bit of the significand of an `f64`, 2^52.
const IMPLIED_BIT: u64 = 1 << 52;

impl ToPrimitive for Rational {
    /// The integer part.
    fn to_i64(&self) -> Option<i64> {
        (&self.numerator / &self.denominator).to_i64()
    }

    /// The integer part.
    fn to_u64(&self) -> Option<u64> {
        (&self.numerator / &self.denominator).to_u64()
    }

    // The default would be the integer part.
    fn to_f64(&self) -> Option<f64> {
        Some(Rational::to_f64(self))
    }
}

impl Zero for Rational {
    fn zero() -> Self {
        Rational::from_integer(BigInt::zero())
    }

    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl One for Rational {
    fn one() -> Self {
        Rational::from_integer(BigInt::one())
    }

    fn is_one(&self) -> bool {
        self.numerator == self.denominator
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        let signs = self.numerator.sign().cmp(&other.numerator.sign());
        signs.then_with(|| {
            if self.denominator == other.denominator {
                self.numerator.cmp(&other.numerator)
            } else {
                (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator))
            }
        })
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Display for Rational {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Written {
        if self.is_integer() {
            self.numerator.fmt(formatter)
        } else {
            write!(formatter, "{}/{}", self.numerator, self.denominator)
        }
    }
}

fn sum(left: &Rational, right: &Rational) -> Rational {
    let common = common_factor(&left.denominator, &right.denominator);
    if common.is_one() {
        let numerator = &left.numerator * &right.denominator + &right.numerator * &left.denominator;
        return Rational { numerator, denominator: &left.denominator * &right.denominator };
    }
    let (of_left, of_right) = (&left.denominator / &common, &right.denominator / &common);
    let numerator = &left.numerator * &of_right + &right.numerator * of_left;
    Rational::reduced(numerator, &left.denominator * of_right, &common)
}

fn product(left: &Rational, right: &Rational) -> Rational {
    let falling = common_factor(&left.numerator, &right.denominator);
    let rising = common_factor(&right.numerator, &left.denominator);
    Rational {
        numerator: quotient(left.numerator.clone(), &falling) * quotient(right.numerator.clone(), &rising),
        denominator: quotient(left.denominator.clone(), &rising)
            * quotient(right.denominator.clone(), &falling),
    }
}

impl Neg for Rational {
    type Output = Rational;

    fn neg(self) -> Rational {
        Rational { numerator: -self.numerator, ..self }
    }
}

impl Neg for &Rational {
    type Output = Rational;

    fn neg(self) -> Rational {
        -self.clone()
    }
}

/// An operator for numbers and references to them.
macro_rules! operator {
    ($operator:ident, $method:ident, |$left:ident, $right:ident| $value:expr) => {
        impl $operator<&Rational> for &Rational {
            type Output = Rational;

            fn $method(self, $right: &Rational) -> Rational {
                let $left = self;
                $value
            }
        }

        impl $operator<Rational> for &Rational {
            type Output = Rational;

            fn $method(self, right: Rational) -> Rational {
                self.$method(&right)
            }
        }

        impl $operator<&Rational> for Rational {
            type Output = Rational;

            fn $method(self, right: &Rational) -> Rational {
                (&self).$method(right)
            }
        }

        impl $operator for Rational {
            type Output = Rational;

            fn $method(self, right: Rational) -> Rational {
                (&self).$method(&right)
            }
        }
    };
}

operator!(Add, add, |left, right| sum(left, right));
operator!(Sub, sub, |left, right| sum(left, &-right));
operator!(Mul, mul, |left, right| product(left, right));
operator!(Div, div, |left, right| product(left, &right.recip()));

impl AddAssign for Rational {
    fn add_assign(&mut self, other: Rational) {
        *self = &*self + other;
    }
}

/// The quotient of a division without remainder.
fn quotient(number: BigInt, divisor: &BigInt) -> BigInt {
    if divisor.is_one() { number } else { number / divisor }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;
    use crate::number::fraction;

    #[test]
    fn fractions_are_in_lowest_terms() {
        for (value, numerator, denominator) in [
            (fraction(6, -4), -3, 2),
            (fraction(0, -4), 0, 1),
            (fraction(1, 6) + fraction(1, 10), 4, 15),
            (fraction(1, 6) - fraction(2, 12), 0, 1),
            (fraction(3, 4) + fraction(2, 9), 35, 36),
            (fraction(4, 9) * fraction(-3, 8), -1, 6),
            (fraction(4, 9) / fraction(-2, 3), -2, 3),
            (fraction(-2, 3).pow(-3), -27, 8),
            (fraction(-7, 2).floor(), -4, 1),
            (fraction(-7, 2).ceil(), -3, 1),
        ] {
            assert_eq!((value.numer(), value.denom()), (&numerator.into(), &denominator.into()));
        }
    }

    #[test]
    fn fractions_have_an_order() {
        let ascending = [fraction(-5, 2), fraction(-2, 3), fraction(0, 1), fraction(3, 5), fraction(2, 3)];
        assert!(ascending.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn doubles_are_fractions_and_back() {
        for value in [0.1, -3.5, 1e300, 5e-324, 2.3e-310, f64::MAX, f64::MIN_POSITIVE, 0.0] {
            assert_eq!(Rational::from_float(value).unwrap().to_f64(), value);
        }
        assert_eq!(Rational::from_float(f64::INFINITY), None);
        assert_eq!(fraction(10, 1).pow(400).to_f64(), f64::INFINITY);
        assert_eq!(fraction(10, 1).pow(-400).to_f64(), 0.0);
    }
}
