//! Coefficients of sums that are rounded once: words, or numbers that follow from fields with twice the digits.
//!
//! A field is a word, but its product with a weight such as 1/3 is not, nor is a quotient of fields. If rounded, each
//! of them would move its term by as much as the rounding of the sum does.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::arithmetic::Arithmetic;
use super::double_power::double_term;
use super::power::real_power;
use crate::Scalar;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::scalar::is_single;

/// A factor of a power.
pub trait Coefficient<T>: Copy {
    /// The number rounded and, if it is more than a word, what the word lacks.
    fn parts(self) -> (T, Option<T>);
}

impl<T: Scalar> Coefficient<T> for T {
    #[inline(always)]
    fn parts(self) -> (T, Option<T>) {
        (self, None)
    }
}

impl<T: Scalar, const FUSED: bool> Coefficient<T> for DoubleWord<T, FUSED> {
    #[inline(always)]
    fn parts(self) -> (T, Option<T>) {
        (self.high(), Some(self.low()))
    }
}

/// The coefficient as a number of an arithmetic.
#[inline(always)]
pub(super) fn number<T: Scalar, A: Arithmetic<T>>(coefficient: impl Coefficient<T>) -> A {
    match coefficient.parts() {
        (word, None) => A::of(word),
        (high, Some(low)) => A::sum(high, low),
    }
}

/// The coefficient added to a number.
#[inline(always)]
pub(super) fn added<T: Scalar, A: Arithmetic<T>>(number: A, coefficient: impl Coefficient<T>) -> A {
    match coefficient.parts() {
        (word, None) => number.plus_word(word),
        (high, Some(low)) => number.plus(A::sum(high, low)),
    }
}

/// The product of a number and the coefficient.
#[inline(always)]
pub(super) fn multiplied<T: Scalar, A: Arithmetic<T>>(number: A, coefficient: impl Coefficient<T>) -> A {
    match coefficient.parts() {
        (word, None) => number.times_word(word),
        (high, Some(low)) => number.times(A::sum(high, low)),
    }
}

/// The coefficients rounded.
#[inline(always)]
pub fn rounded<T, C: Coefficient<T>, const N: usize>(coefficients: [C; N]) -> [T; N] {
    coefficients.map(|coefficient| coefficient.parts().0)
}

/// A sum of powers of two fields as a product or, if that is zero, infinite or not a number, as it is written: one of the
/// fields may be infinite, as the radius of a plane is, or so large that its product with the other is.
#[inline(always)]
pub fn finite_or<T: Scalar>(product: T, sum: T) -> T {
    if product.is_finite() & !product.is_zero() { product } else { sum }
}

/// A coefficient with twice the digits of a word, unless the halves of its words overflow.
#[derive(Clone, Copy, Debug)]
pub struct Precise<T, const FUSED: bool>(DoubleWord<T, FUSED>);

impl<T: Scalar, const FUSED: bool> Precise<T, FUSED> {
    /// A coefficient that is a word.
    #[inline(always)]
    pub fn of(word: T) -> Self {
        Self(DoubleWord::of(word))
    }

    /// The sum of a literal and of what it lacks, at most half a unit in its last place.
    #[inline(always)]
    pub fn constant(nearest: f64, rest: f64) -> Self {
        let word = T::constant(nearest);
        if !is_single::<T>() {
            return Self(DoubleWord::of_parts(word, T::constant(rest)));
        }
        Self::checked(DoubleWord::sum(word, T::constant((nearest - word.value()) + rest)), word)
    }

    /// The power of a positive number, to first order in what its word lacks.
    #[inline(always)]
    pub fn power(self, exponent: Exponent<T>) -> Self {
        let (high, n) = (self.0.high(), exponent.value());
        let power = double_term(DoubleWord::of(T::one()), high, exponent);
        let lacking = power.high() * (n * (self.0.low() / high));
        Self::checked(power.plus_word(lacking), real_power(high, exponent))
    }

    /// The product with a power of two, which rounds nothing.
    #[inline(always)]
    pub fn scaled(self, power_of_two: f64) -> Self {
        Self(self.0.scaled(T::constant(power_of_two)))
    }

    /// The number, or the result of plain arithmetic where it is not finite.
    #[inline(always)]
    fn checked(number: DoubleWord<T, FUSED>, plain: T) -> Self {
        if number.rounded().is_finite() { Self(number) } else { Self::of(plain) }
    }
}

impl<T: Scalar, const FUSED: bool> Coefficient<T> for Precise<T, FUSED> {
    #[inline(always)]
    fn parts(self) -> (T, Option<T>) {
        self.0.parts()
    }
}

impl<T: Scalar, const FUSED: bool> Add for Precise<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::checked(self.0.plus(other.0), self.0.high() + other.0.high())
    }
}

impl<T: Scalar, const FUSED: bool> Sub for Precise<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Scalar, const FUSED: bool> Mul for Precise<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::checked(self.0.times(other.0), self.0.high() * other.0.high())
    }
}

impl<T: Scalar, const FUSED: bool> Div for Precise<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self::checked(self.0.over(other.0), self.0.high() / other.0.high())
    }
}

impl<T: Scalar, const FUSED: bool> Neg for Precise<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dispatch::FUSES;

    type Number = Precise<f64, FUSES>;

    #[test]
    fn products_and_quotients_keep_what_is_lost() {
        let third = Number::constant(1.0 / 3.0, 1.850_371_707_708_594e-17);
        let radius = Number::of(7.3);
        let one = third * radius / (radius * radius * radius) * radius * radius * Number::of(3.0);
        let (high, low) = (one - Number::of(1.0)).parts();
        assert!((high + low.unwrap_or(f64::NAN)).abs() < 1e-31, "{high:e}");
        let single = Precise::<f32, FUSES>::constant(1.0 / 3.0, 1.850_371_707_708_594e-17).parts();
        assert!((1.0 / 3.0 - f64::from(single.0) - single.1.map_or(f64::NAN, f64::from)).abs() < 1e-15);
    }

    /// (x + δ)^(3/2) squared is (x + δ)³.
    #[test]
    fn powers_know_what_their_base_lacks() {
        let base = Number::of(2.0) / Number::of(3.0);
        let power = base.power(Exponent::in_parts(1, 0.5, 0.0));
        let inverse = base.power(Exponent::in_parts(-2, 0.5, 0.0));
        let (high, low) = (power * power - base * base * base).parts();
        assert!((high + low.unwrap_or(f64::NAN)).abs() < 1e-30, "{high:e}");
        assert!((power * inverse - Number::of(1.0)).parts().0.abs() < 1e-30);
    }

    #[test]
    fn nothing_is_lost_at_the_ends_of_the_range_but_digits() {
        let large = Number::of(1e305);
        assert_eq!((large * Number::constant(0.1, -5.551_115_123_125_783e-18)).parts().0, 1e305 * 0.1);
        assert_eq!((Number::of(1e305) / Number::of(1e304)).parts().0, 1e305 / 1e304);
        assert_eq!((Number::of(1.0) / (large * large)).parts().0, 0.0);
        assert_eq!(large.scaled(2f64.powi(20)).parts().0, f64::INFINITY);
        assert_eq!((Number::of(1.0) / Number::of(f64::INFINITY)).scaled(0.5).parts(), (0.0, Some(0.0)));
        assert_eq!(Precise::<f32, FUSES>::constant(1e300, 0.0).parts().0, f32::INFINITY);
        assert_eq!(Number::of(0.0).power(Exponent::in_parts(0, 0.5, 0.0)).parts().0, 0.0);
        assert!(Number::of(-1.0).power(Exponent::in_parts(0, 0.5, 0.0)).parts().0.is_nan());
    }
}
