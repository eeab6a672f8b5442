//! Sums of thousands of impulses, or of a quantity that fades between gains.

use crate::Scalar;

/// Kahan's sum: a measured load may have a hundred thousand knots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CompensatedSum<T> {
    pub(crate) value: T,
    /// How much the value is too large.
    excess: T,
}

impl<T: Scalar> From<T> for CompensatedSum<T> {
    fn from(value: T) -> Self {
        Self { value, excess: T::zero() }
    }
}

impl<T: Scalar> CompensatedSum<T> {
    #[inline(always)]
    pub(crate) fn add(&mut self, x: T) {
        let corrected = x - self.excess;
        let next = self.value + corrected;
        self.excess = (next - self.value) - corrected;
        self.value = next;
    }

    /// The sum of numbers that are not negative: infinite once it has left the format, where the excess, a difference of
    /// infinite numbers, would make it NaN.
    #[inline(always)]
    pub(crate) fn total(self) -> T {
        if self.value.is_finite() { self.value } else { T::infinity() }
    }
}
