//! Many changes one after the other.
//!
//! Beside a change as large as that of a jump, small ones that are equal are rounded alike, and their roundings would
//! add up.

use super::sweep::Change;
use crate::Scalar;
use crate::numbers::compensated_sum::CompensatedSum;

/// Slow changes one after the other, see [`Change`]; `gain` is the decay minus 1.
#[derive(Clone, Copy)]
pub(super) struct LongChange<T> {
    gain: CompensatedSum<T>,
    on_axis: CompensatedSum<T>,
    slope: CompensatedSum<T>,
}

impl<T: Scalar> LongChange<T> {
    /// No change.
    pub(super) fn none() -> Self {
        let none = CompensatedSum::from(T::zero());
        Self { gain: none, on_axis: none, slope: none }
    }

    /// Goes on with another slow change.
    pub(super) fn pass(&mut self, change: Change<T>) {
        let Self { gain, on_axis, slope } = self;
        gain.add(change.gain + change.gain * gain.value);
        on_axis.add(change.gain * on_axis.value + change.on_axis);
        slope.add(change.gain * slope.value + change.slope);
    }

    /// All of them as one change.
    pub(super) fn rounded(&self) -> Change<T> {
        let [gain, on_axis, slope] = [self.gain, self.on_axis, self.slope].map(|sum| sum.value);
        Change { kept: T::one(), gain, on_axis, slope }
    }
}
