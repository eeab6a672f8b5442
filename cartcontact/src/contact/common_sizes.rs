//! Numbers of common size, with which no formula leaves the format.
//!
//! Whether a radius has all its digits depends on Y, χ F, 4 F/(π m), J, a⁴, J/a⁵, F/a⁴, a J′, δ₀′ and, with an exponent
//! below 1, √(8/ε) δ₀′. Of these a J′ and δ₀′ are J and J/a⁵ up to a factor of at most 2056. If rate, force, time, load
//! integral and radius lie between 1/b and b, or time and rate at 0, and π m/4 = Y/J is not huge, all of these are normal
//! numbers, most of them between b⁻⁶ and b⁶ up to that factor and √(8/ε), 8192 in single and 1.9 · 10⁸ in double
//! precision: a few comparisons with constants replace a division and a dozen comparisons. Where numbers are less common,
//! the conditions themselves are checked.

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
        let (least, most) = if is_single::<T>() { (1e-5, 1e5) } else { (1e-49, 1e49) };
        Self { least: T::constant(least), most: T::constant(most) }
    }

    #[inline(always)]
    pub(super) fn contain(self, size: T) -> bool {
        (self.least <= size) & (size <= self.most)
    }

    /// Whether the rate is of common size, or zero, and neither Y = (π m/4) J leaves the format nor F/(π m/4) if F and J
    /// are of common size: a load that has fallen far leaves a large Y and a small F.
    #[inline(always)]
    pub(super) fn contain_medium(self, chi: T, load_per_integral: T) -> bool {
        let most = T::constant(if is_single::<T>() { 1e7 } else { 1e51 });
        (chi.is_zero() | self.contain(chi)) & (load_per_integral * most).is_finite()
    }

    /// The time itself if it is of common size, otherwise a time that is.
    #[inline(always)]
    pub(super) fn time_near(self, time: T) -> T {
        let zero = T::zero();
        lesser(if time >= zero { time } else { zero }, self.most)
    }

    /// Whether a load of common size is one that a contact accepts.
    ///
    /// An infinite impulse makes the load integral infinite or, times a rate of zero, not a number.
    #[inline(always)]
    pub(super) fn contain_load(self, loading: Loading<T>, load_integral: T) -> bool {
        (T::zero() <= loading.impulse) & self.contain(loading.force) & self.contain(load_integral)
    }
}
