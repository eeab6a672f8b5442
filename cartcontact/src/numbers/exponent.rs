//! Exponents with twice the digits of a number: an exponent that is off by δ makes x^n off by δ ln x.
//!
//! In one word 6.3 is off by up to 4e-16, and 1000^6.3 by 12 ε; so is 2.3 + 4, even where the word 2.3 is exactly what
//! is meant. A whole number and a fraction keep the digits that their sum has no room for.

use super::double_word::DoubleWord;
use crate::Scalar;
use crate::scalar::floor;

/// The exponent n = whole + fraction + rest.
#[derive(Clone, Copy, Debug)]
pub struct Exponent<T> {
    value: T,
    pub(crate) whole: i32,
    /// From 0 to 1.
    pub(crate) fraction: T,
    /// What the fraction lacks.
    pub(crate) rest: T,
}

impl<T: Scalar> Exponent<T> {
    /// An exponent that is a number of the format.
    #[inline]
    pub fn of(value: T) -> Self {
        let whole = floor(value);
        Self { value, whole, fraction: value - T::constant(f64::from(whole)), rest: T::zero() }
    }

    /// A whole exponent.
    #[inline]
    pub fn whole(whole: i32) -> Self {
        Self { value: T::constant(f64::from(whole)), whole, fraction: T::zero(), rest: T::zero() }
    }

    /// Any exponent, from its whole part, the f64 nearest to its fraction, and what that lacks.
    #[inline]
    pub fn in_parts(whole: i32, fraction: f64, rest: f64) -> Self {
        let value = T::constant(f64::from(whole) + fraction);
        let word = T::constant(fraction);
        Self { value, whole, fraction: word, rest: T::constant((fraction - word.value()) + rest) }
    }

    /// n + k.
    #[inline]
    pub(crate) fn plus(self, k: i32) -> Self {
        Self { value: self.value + T::constant(f64::from(k)), whole: self.whole + k, ..self }
    }

    /// n rounded.
    #[inline]
    pub(crate) fn value(self) -> T {
        self.value
    }

    /// What n rounded lacks.
    #[inline]
    pub(crate) fn lacking(self) -> T {
        (self.fraction - (self.value - T::constant(f64::from(self.whole)))) + self.rest
    }

    /// n in twice the working precision.
    #[inline(always)]
    pub(crate) fn double<const FUSED: bool>(self) -> DoubleWord<T, FUSED> {
        DoubleWord::sum(T::constant(f64::from(self.whole)), self.fraction).plus_word(self.rest)
    }
}

/// The terms (c, n) of constants with whole exponents.
#[inline(always)]
pub fn whole_terms<T: Scalar>(
    terms: &'static [(f64, i32)],
) -> impl Iterator<Item = (T, Exponent<T>)> + Clone {
    terms.iter().map(|&(c, whole)| (T::constant(c), Exponent::whole(whole)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_add_up_to_the_exponent() {
        // 2.3 is its nearest f64 plus 1.8e-16; 0.3 is its nearest f64 plus 1.1e-17.
        let decimal = Exponent::<f64>::in_parts(2, 0.3, 1.110_223_024_625_156_6e-17);
        let number = Exponent::of(2.3_f64);
        assert_eq!(decimal.value(), number.value());
        for lacking in [decimal.double::<false>().plus(-number.double()).rounded(), decimal.lacking()] {
            assert!((lacking - 1.776_356_839_400_250_5e-16).abs() < 1e-31, "{lacking:e}");
        }
        assert_eq!(number.lacking(), 0.0);
        let single = Exponent::<f32>::in_parts(2, 0.3, 1.110_223_024_625_156_6e-17);
        let lacking = 0.3 - (f64::from(single.fraction) + f64::from(single.rest));
        assert!(lacking.abs() < f64::from(f32::EPSILON).powi(2) * 0.3, "{lacking:e}");
        assert_eq!((single.plus(4).value(), single.plus(4).whole), (6.3, 6));
    }
}
