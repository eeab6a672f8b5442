//! Numbers of twice the working precision, as unevaluated sums of two words.
//!
//! In plain arithmetic a sum of powers is off by a few ε: every operation rounds, a product of k factors is off by up
//! to k/2 ε, and repeated squaring multiplies the first rounding by k/2; for r^64 that is 30 ε. With the rounding error
//! of every operation carried along, only those of the coefficients and of the result are left.
//!
//! Sources: T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18
//! (1971), doi 10.1007/BF01397083 (split, product, sum of unequal words); M. Joldes, J.-M. Muller, V. Popescu, "Tight
//! and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44 (2017), doi
//! 10.1145/3121432 (product of double words, relative error below 7 · 2^-2p).

use crate::Scalar;
use crate::dispatch::{FUSES, out_of_line};
use crate::scalar::{has_no_derivatives, is_single};

/// high + low with |low| ≤ ulp(high)/2.
///
/// `FUSED` numbers take the error of a product from an instruction that multiplies and adds with one rounding. Others,
/// and those with derivatives, cut words into halves, with the same result unless halves over- or underflow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DoubleWord<T, const FUSED: bool = FUSES> {
    high: T,
    low: T,
}

// All of it is inlined: only code that is part of a function for a processor may use its instructions.
impl<T: Scalar, const FUSED: bool> DoubleWord<T, FUSED> {
    #[inline(always)]
    pub(crate) fn of(high: T) -> Self {
        Self { high, low: T::zero() }
    }

    /// The sum of a word and one that is at most half a unit in the last place of it.
    #[inline(always)]
    pub(crate) fn of_parts(high: T, low: T) -> Self {
        Self { high, low }
    }

    /// The product of two words, without any error while the product's error is representable.
    #[inline(always)]
    pub(crate) fn product(x: T, y: T) -> Self {
        let high = x * y;
        if FUSED && has_no_derivatives::<T>() {
            return Self { high, low: x.mul_add(y, -high) };
        }
        let ((x_head, x_tail), (y_head, y_tail)) = (halves(x), halves(y));
        let low = ((x_head * y_head - high) + x_head * y_tail + x_tail * y_head) + x_tail * y_tail;
        Self { high, low }
    }

    /// The sum of two words, without any error (Knuth).
    #[inline(always)]
    pub(crate) fn sum(x: T, y: T) -> Self {
        let high = x + y;
        let of_y = high - x;
        let low = (x - (high - of_y)) + (y - of_y);
        Self { high, low }
    }

    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        Self::renormalised(sum.high, sum.low + (self.low + other.low))
    }

    #[inline(always)]
    pub(crate) fn plus_word(self, word: T) -> Self {
        let sum = Self::sum(self.high, word);
        Self::renormalised(sum.high, sum.low + self.low)
    }

    #[inline(always)]
    pub(crate) fn times(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::renormalised(product.high, product.low + (self.high * other.low + self.low * other.high))
    }

    #[inline(always)]
    pub(crate) fn times_word(self, word: T) -> Self {
        let product = Self::product(self.high, word);
        Self::renormalised(product.high, product.low + self.low * word)
    }

    /// The quotient of two double words: that of the high words, and that of the remainder, unless the halves of such
    /// large words overflow.
    #[inline(always)]
    pub(crate) fn over(self, other: Self) -> Self {
        // Two divisions at the same time rather than one after the other.
        let (quotient, inverse) = (self.high / other.high, other.high.recip());
        let back = other.times_word(quotient);
        let lacking = ((self.high - back.high) + (self.low - back.low)) * inverse;
        if lacking.is_finite() { Self::renormalised(quotient, lacking) } else { Self::of(quotient) }
    }

    /// The square root of a positive number, by one step of Newton's method from that of the high word.
    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        let square = Self::product(root, root);
        let rest = ((self.high - square.high) - square.low) + self.low;
        Self::renormalised(root, rest / (root + root))
    }

    /// The k-th power by binary powering, k ≥ 1: at most 2 log₂ k products.
    #[inline(always)]
    pub(crate) fn power(self, k: u32) -> Self {
        debug_assert!(k >= 1, "the power {k}");
        let mut power = self;
        for bit in (0..k.ilog2()).rev() {
            power = power.times(power);
            if k >> bit & 1 == 1 {
                power = power.times(self);
            }
        }
        power
    }

    #[inline(always)]
    pub(crate) fn rounded(self) -> T {
        self.high + self.low
    }

    /// The number rounded or, where that is not finite, the result of plain arithmetic: beyond 2^996 the halves
    /// overflow a little before their results do.
    #[inline(always)]
    pub(crate) fn rounded_or(self, plain: impl FnOnce() -> T) -> T {
        let rounded = self.rounded();
        if rounded.is_finite() { rounded } else { out_of_line(plain) }
    }

    /// The number to within half an ulp.
    #[inline(always)]
    pub(crate) fn high(self) -> T {
        self.high
    }

    /// What `high` lacks.
    #[inline(always)]
    pub(crate) fn low(self) -> T {
        self.low
    }

    /// The same number for the other way to multiply.
    #[inline(always)]
    pub(crate) fn converted<const OTHER: bool>(self) -> DoubleWord<T, OTHER> {
        DoubleWord { high: self.high, low: self.low }
    }

    /// The product with a power of two.
    #[inline(always)]
    pub(crate) fn scaled(self, power: T) -> Self {
        Self { high: self.high * power, low: self.low * power }
    }

    /// The sum of two words, the second of which is far smaller (Dekker).
    #[inline(always)]
    fn renormalised(high: T, low: T) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }
}

impl<T: Scalar, const FUSED: bool> core::ops::Neg for DoubleWord<T, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

/// Cuts x into two halves of at most half the digits each, whose products are exact (Veltkamp).
#[inline(always)]
fn halves<T: Scalar>(x: T) -> (T, T) {
    // 2^⌈p/2⌉ + 1 for the precision p = 53 of f64 and p = 24 of f32.
    let splitter = if is_single::<T>() { T::constant(4097.0) } else { T::constant(134_217_729.0) };
    let scaled = splitter * x;
    let head = scaled - (scaled - x);
    (head, x - head)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn products_are_exact<const FUSED: bool>() {
        let (x, y) = (1.0 + 2f64.powi(-40), 1.0 - 2f64.powi(-41));
        let product = DoubleWord::<f64, FUSED>::product(x, y);
        assert_eq!((product.high, product.low), (1.0 + 2f64.powi(-41), -(2f64.powi(-81))));
        // 3^k is exact up to k = 33; (1 + 2^-20)^64 to 30 digits from exact rational arithmetic.
        assert_eq!(DoubleWord::<f64, FUSED>::of(3.0).power(33).rounded(), 5_559_060_566_555_523.0);
        assert_eq!(DoubleWord::<f32, FUSED>::of(3.0).power(15).rounded(), 14_348_907.0);
        let power = DoubleWord::<f64, FUSED>::of(1.0 + 2f64.powi(-20)).power(64).rounded();
        assert_eq!(power, 1.000_061_036_989_827_5);
    }

    #[test]
    fn products_of_either_kind_are_exact() {
        products_are_exact::<true>();
        products_are_exact::<false>();
    }

    fn nothing_is_lost<const FUSED: bool>() {
        let tiny = 2f64.powi(-70);
        let sum = DoubleWord::<f64, FUSED>::sum(1.0, tiny);
        assert_eq!((sum.high, sum.low), (1.0, tiny));
        // (1 + 2^-70)/3 and its product with 3; the root of (1 + 2^-70)².
        let back = sum.over(DoubleWord::of(3.0)).times_word(3.0);
        assert_eq!((back.high, back.low), (1.0, tiny));
        let root = sum.times(sum).sqrt();
        assert_eq!((root.high, root.low), (1.0, tiny));
        assert_eq!(sum.plus(DoubleWord::of(-1.0)).high, tiny);
    }

    #[test]
    fn sums_quotients_and_roots_keep_what_is_lost() {
        nothing_is_lost::<true>();
        nothing_is_lost::<false>();
    }

    /// A few operations with the products of a sequence of numbers with random digits, from 2^−`octaves` to 2^`octaves`.
    fn words<T: Scalar, const FUSED: bool>(octaves: i32) -> impl Iterator<Item = [T; 2]> {
        let mut state = 1_u64;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            T::constant((state >> 11) as f64 * 2f64.powi(-53) + 0.5)
        };
        let powers = (0..20_000).map(move |k| T::constant(2f64.powi(k % (2 * octaves) - octaves)));
        powers.flat_map(move |power| {
            let [x, y, z] = [random() * power, random(), random()].map(DoubleWord::<T, FUSED>::of);
            let product = x.times(y);
            [product, product.times(z), product.over(z), product.sqrt(), product.plus(z.times_word(y.high))]
                .map(|number| [number.high, number.low])
        })
    }

    #[test]
    fn fused_and_split_products_are_the_same_to_the_last_bit() {
        assert!(words::<f64, true>(450).eq(words::<f64, false>(450)));
        assert!(words::<f32, true>(45).eq(words::<f32, false>(45)));
    }
}
