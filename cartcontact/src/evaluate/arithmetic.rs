//! The arithmetics in which kernels are evaluated: plain words where a result is one of many that are summed, and double
//! words where the result itself is asked for.

use super::double_power::double_term;
use super::power::term;
use super::real_exponent_kernel;
use crate::Scalar;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;

/// What kernels need from numbers made of words of type `T`.
pub(super) trait Arithmetic<T>: Copy {
    fn of(word: T) -> Self;
    fn sum(x: T, y: T) -> Self;
    fn product(x: T, y: T) -> Self;
    fn plus(self, other: Self) -> Self;
    fn plus_word(self, word: T) -> Self;
    fn times(self, other: Self) -> Self;
    fn times_word(self, word: T) -> Self;
    fn rounded(self) -> T;
    /// n, rounded to what the number can hold.
    fn exponent(n: Exponent<T>) -> Self;
    /// c x^n.
    fn term(c: Self, x: T, n: Exponent<T>) -> Self;
    /// K(q) for any exponent n, from 1 − q and q.
    fn kernel_of_real_exponent(inset: Self, ratio: Self, n: Exponent<T>) -> Self;
    fn over(self, other: Self) -> Self;
    /// The square root of a positive number.
    fn sqrt(self) -> Self;
}

/// A word, rounded after every operation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<T>(T);

impl<T: Scalar> Arithmetic<T> for Word<T> {
    #[inline(always)]
    fn of(word: T) -> Self {
        Self(word)
    }
    #[inline(always)]
    fn sum(x: T, y: T) -> Self {
        Self(x + y)
    }
    #[inline(always)]
    fn product(x: T, y: T) -> Self {
        Self(x * y)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    #[inline(always)]
    fn plus_word(self, word: T) -> Self {
        Self(self.0 + word)
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    #[inline(always)]
    fn times_word(self, word: T) -> Self {
        Self(self.0 * word)
    }
    #[inline(always)]
    fn rounded(self) -> T {
        self.0
    }
    #[inline(always)]
    fn exponent(n: Exponent<T>) -> Self {
        Self(n.value())
    }
    #[inline(always)]
    fn term(c: Self, x: T, n: Exponent<T>) -> Self {
        Self(term(c.0, x, n))
    }
    #[inline(always)]
    fn kernel_of_real_exponent(inset: Self, ratio: Self, n: Exponent<T>) -> Self {
        Self(real_exponent_kernel::quick_kernel(inset.0, ratio.0, n.value()))
    }
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
}

impl<T: Scalar, const FUSED: bool> Arithmetic<T> for DoubleWord<T, FUSED> {
    #[inline(always)]
    fn of(word: T) -> Self {
        Self::of(word)
    }
    #[inline(always)]
    fn sum(x: T, y: T) -> Self {
        Self::sum(x, y)
    }
    #[inline(always)]
    fn product(x: T, y: T) -> Self {
        Self::product(x, y)
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self::plus(self, other)
    }
    #[inline(always)]
    fn plus_word(self, word: T) -> Self {
        Self::plus_word(self, word)
    }
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self::times(self, other)
    }
    #[inline(always)]
    fn times_word(self, word: T) -> Self {
        Self::times_word(self, word)
    }
    #[inline(always)]
    fn rounded(self) -> T {
        Self::rounded(self)
    }
    #[inline(always)]
    fn exponent(n: Exponent<T>) -> Self {
        n.double()
    }
    #[inline(always)]
    fn term(c: Self, x: T, n: Exponent<T>) -> Self {
        double_term(c, x, n)
    }
    #[inline(always)]
    fn kernel_of_real_exponent(inset: Self, ratio: Self, n: Exponent<T>) -> Self {
        real_exponent_kernel::kernel(inset, ratio, n.double())
    }
    #[inline(always)]
    fn over(self, other: Self) -> Self {
        Self::over(self, other)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
}
