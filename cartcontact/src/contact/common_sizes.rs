//! Numbers of common size, which leave the format in no formula.
//!
//! Whether a radius has all its digits depends on χ F, J, a⁴, J/a⁵, F/a⁴, δ₀′ and a J′, of which the last two are J/a⁵
//! and J but for a factor of the exponents. If rate, force, load integral and radius lie between 1/b and b, all of
//! these lie between b⁻⁶ and b⁶ but for that factor, which are normal numbers: a few comparisons with constants stand
//! for a division and a dozen of them. What is not so common is asked the conditions themselves.

use super::Loading;
use crate::Scalar;
use crate::scalar::{is_single, lesser};

/// From 1/b to b.
#[derive(Clone, Copy)]
pub(super) struct CommonSizes<T> {
    least: T,
    most: T,
}

impl<T: Scalar> CommonSizes<T> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        let (least, most) = if is_single::<T>() { (1e-6, 1e6) } else { (1e-50, 1e50) };
        Self { least: T::constant(least), most: T::constant(most) }
    }

    #[inline(always)]
    pub(super) fn contain(self, size: T) -> bool {
        (self.least <= size) & (size <= self.most)
    }

    #[inline(always)]
    pub(super) fn contain_rate(self, chi: T) -> bool {
        chi.is_zero() | self.contain(chi)
    }

    /// The time itself if it is one of common size, otherwise one that is.
    #[inline(always)]
    pub(super) fn time_near(self, time: T) -> T {
        let zero = T::zero();
        lesser(if time >= zero { time } else { zero }, self.most)
    }

    /// Whether the load is such as a contact accepts.
    ///
    /// An infinite impulse makes the load integral infinite or, times a rate of zero, not a number.
    #[inline(always)]
    pub(super) fn contain_load(self, loading: Loading<T>, load_integral: T) -> bool {
        (T::zero() <= loading.impulse) & self.contain(loading.force) & self.contain(load_integral)
    }
}
