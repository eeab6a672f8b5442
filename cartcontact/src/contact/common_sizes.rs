//! Numbers of common size, with which no formula leaves the format.
//!
//! Whether a contact has all its digits depends on 2 Y, 2 χ F, 4 F/(π m), J, a⁴, J/a⁵, F/a⁴, 4 F/(π m a⁴), a J′, δ₀′ and,
//! with an exponent below 1, √(8/ε) δ₀′. Of these a J′ and δ₀′ are J and J/a⁵ up to a factor of at most 2056; J is not
//! below 4 F/(π m), and Y/J is F over that. If force, these two load integrals, radius and rate lie between 1/b and b, or
//! the rate at 0, and the time between 0 and b, all others are normal numbers between b⁻⁶ and b⁶, up to that factor and
//! √(8/ε), 8192 in single and 1.9 · 10⁸ in double precision: a few comparisons with constants replace divisions and a
//! dozen comparisons. Where numbers are less common, the conditions themselves are checked.

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

    /// Whether the rate is of common size, or zero.
    #[inline(always)]
    pub(super) fn contain_rate(self, chi: T) -> bool {
        chi.is_zero() | self.contain(chi)
    }

    /// The time itself if it lies between 0 and b, otherwise 0 or b.
    #[inline(always)]
    pub(super) fn time_near(self, time: T) -> T {
        let zero = T::zero();
        lesser(if time >= zero { time } else { zero }, self.most)
    }

    /// Whether the load is of common size, with the load integrals of the force alone and of the whole load, and one that
    /// a contact accepts.
    ///
    /// An infinite impulse makes the load integral infinite or, times a rate of zero, not a number.
    #[inline(always)]
    pub(super) fn contain_load(self, loading: Loading<T>, (of_force, load_integral): (T, T)) -> bool {
        let is_common = self.contain(loading.force) & (self.least <= of_force) & (load_integral <= self.most);
        (T::zero() <= loading.impulse) & is_common
    }
}
