//! Numbers cut in two so that the products of their heads are exact.
//!
//! The head has half the digits of a word, the rest as many digits as a word. In the product
//!
//! ```text
//! (h + l)(h′ + l′) = h h′ + (h l′ + l (h′ + l′))
//! ```
//!
//! the first part is exact. The second, a share of 2⁻²⁴, or 2⁻¹¹ in single precision, is rounded: it is off by less
//! than 2⁻⁷⁵ of the product, or in single precision 2⁻³³ = ε/1000. That is less exact than a
//! [`DoubleWord`](super::double_word::DoubleWord) and takes a third of its operations. Derivatives are in the rest.

use super::bits::with_half_its_digits;
use crate::Scalar;
use crate::scalar::without_derivatives;

/// head + rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halved<T> {
    head: T,
    rest: T,
}

impl<T: Scalar> Halved<T> {
    #[inline(always)]
    pub(crate) fn of(word: T) -> Self {
        let head = with_half_its_digits(word);
        Self { head, rest: word - head }
    }

    /// The sum of two words, the second of which is far smaller.
    #[inline(always)]
    fn of_sum(high: T, low: T) -> Self {
        let head = with_half_its_digits(high + low);
        Self { head, rest: (high - head) + low }
    }

    /// `dividend` over the number, and the share of itself that the quotient lacks. All are near 1.
    #[inline(always)]
    pub(crate) fn divide(self, dividend: T) -> (T, T) {
        let quotient = dividend / self.word();
        let (high, low) = Self::of(quotient).parts_of_product(self);
        (quotient, ((dividend - high) - low) / dividend)
    }

    /// The number rounded.
    #[inline(always)]
    pub(crate) fn word(self) -> T {
        self.head + self.rest
    }

    /// The number rounded, and what the rounded number lacks.
    #[inline(always)]
    pub(crate) fn word_and_lost(self) -> (T, T) {
        let word = self.word();
        (word, (self.head - word) + self.rest)
    }

    #[inline(always)]
    pub(crate) fn head(self) -> T {
        self.head
    }

    #[inline(always)]
    pub(crate) fn rest(self) -> T {
        self.rest
    }

    #[inline(always)]
    pub(crate) fn times(self, other: Self) -> Self {
        let (high, low) = self.parts_of_product(other);
        Self::of_sum(high, low)
    }

    /// By how much `product` exceeds the product of two numbers, to which it is near.
    #[inline(always)]
    pub(crate) fn excess_of_product(self, product: T, other: Self) -> T {
        let (high, low) = self.parts_of_product(other);
        (product - high) - low
    }

    /// The product in two parts, of which the first is exact.
    #[inline(always)]
    pub(crate) fn parts_of_product(self, other: Self) -> (T, T) {
        (self.head * other.head, self.head * other.rest + self.rest * other.word())
    }

    #[inline(always)]
    pub(crate) fn square(self) -> Self {
        Self::of_sum(self.head * self.head, self.rest * (self.head + self.word()))
    }

    /// The k-th power by binary powering, k ≥ 2, from the number and its square.
    #[inline(always)]
    pub(crate) fn power(self, square: Self, k: u32) -> Self {
        debug_assert!(k >= 2, "the power {k}");
        // From the lowest bit up, so that products need not wait for each other.
        let (mut beside, mut power, mut rest) = ((k & 1 == 1).then_some(self), square, k >> 1);
        while rest > 1 {
            if rest & 1 == 1 {
                beside = Some(beside.map_or(power, |beside| beside.times(power)));
            }
            power = power.square();
            rest >>= 1;
        }
        beside.map_or(power, |beside| beside.times(power))
    }

    /// The `K`-th power, `K` ≥ 1, from the number and its square.
    #[inline(always)]
    pub(crate) fn whole_power<const K: u32>(self, square: Self) -> Self {
        if K == 1 { self } else { self.power(square, K) }
    }

    /// The value alone.
    #[inline(always)]
    pub(crate) fn without_derivatives(self) -> Self {
        Self { head: self.head, rest: without_derivatives(self.rest) }
    }

    /// The product with a power of two.
    #[inline(always)]
    pub(crate) fn scaled(self, power: T) -> Self {
        Self { head: self.head * power, rest: self.rest * power }
    }

    /// The sum with a number that is far smaller.
    #[inline(always)]
    pub(crate) fn plus_little(self, little: T) -> Self {
        Self { rest: self.rest + little, ..self }
    }

    /// The square root of a positive number, by one step of Newton's method from that of its word.
    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        let root = self.word().sqrt();
        let Self { head, rest } = Self::of(root);
        let left = (self.head - head * head) + (self.rest - rest * (head + root));
        Self { head, rest: rest + left / (root + root) }
    }
}

/// A product and what it lacks; exact if the factor has at most half the digits of a word.
#[inline(always)]
pub(crate) fn product_with_few_digits<T: Scalar>(x: T, factor: T) -> (T, T) {
    let (product, Halved { head, rest }) = (x * factor, Halved::of(x));
    (product, (head * factor - product) + rest * factor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::double_word::DoubleWord;
    use crate::worse::worse;

    /// The largest |x/y − 1| in units of ε, over numbers made of words.
    fn largest_difference<T: Scalar>() -> f64 {
        let mut largest = 0.0_f64;
        for k in 1..1000 {
            for (found, expected) in pairs(T::constant(1.013_f64.powi(k - 500))) {
                let found = DoubleWord::sum(found.head, found.rest);
                let error = found.plus(-expected).high() / expected.high();
                largest = worse(largest, error.abs().value());
            }
        }
        largest / T::default_epsilon().value()
    }

    fn pairs<T: Scalar>(x: T) -> [(Halved<T>, DoubleWord<T>); 4] {
        let (halved, third) = (Halved::of(x), T::constant(1.0 / 3.0));
        [
            (halved.times(Halved::of(third)), DoubleWord::product(x, third)),
            (halved.power(halved.square(), 9), DoubleWord::of(x).power(9)),
            (halved.whole_power::<10>(halved.square()), DoubleWord::of(x).power(10)),
            (halved.sqrt(), DoubleWord::of(x).sqrt()),
        ]
    }

    #[test]
    fn hardly_anything_is_rounded() {
        for error in [largest_difference::<f64>(), largest_difference::<f32>()] {
            assert!(error < 0.01, "{error} ε");
        }
    }
}
