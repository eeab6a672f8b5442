//! What a stretch of history adds to the pressures, before it is multiplied by m/4.

use crate::Scalar;
use crate::numbers::binary::ratio;

/// ∫ δ₀′(s) e^(−age) {s² − low², 1, (s² − low²)²} ds over the radii from `low` to that at the end of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Increment<T> {
    /// The pressure at `low`, in units of m/4.
    pub(super) offset: T,
    /// By how much the pressure falls with r².
    pub(super) slope: T,
    /// Not part of any pressure: with the other two it gives the [load](Self::doubled_load) that the increment carries,
    /// to which it is scaled.
    spread: T,
}

impl<T: Scalar> Increment<T> {
    pub(super) fn zero() -> Self {
        Self { offset: T::zero(), slope: T::zero(), spread: T::zero() }
    }

    /// An increment laid at the radius s: `weight` is ∫ δ₀′ e^(−age) ds.
    #[inline(always)]
    pub(super) fn at(s: T, weight: T, low: T) -> Self {
        let rise = (s - low) * (s + low);
        Self { offset: weight * rise, slope: weight, spread: weight * rise * rise }
    }

    /// An increment laid at some radii, with a weight for each.
    #[inline(always)]
    pub(super) fn of(radii: &[T], weights: &[T], low: T) -> Self {
        // One sum after the other: vectors then take several radii, instead of all values of one.
        let offset = sum(
            radii,
            weights,
            #[inline(always)]
            |s, weight| Self::at(s, weight, low).offset,
        );
        let slope = sum(
            radii,
            weights,
            #[inline(always)]
            |s, weight| Self::at(s, weight, low).slope,
        );
        let spread = sum(
            radii,
            weights,
            #[inline(always)]
            |s, weight| Self::at(s, weight, low).spread,
        );
        Self { offset, slope, spread }
    }

    /// The increment of an integral over time, where δ₀′ ds is 2 dJ/s⁴: the weights are those of 2 e^(−age) dJ, and
    /// are divided by s⁴ here.
    #[inline(always)]
    pub(super) fn over_time(radii: &[T], weights: &mut [T], low: T) -> Self {
        for (weight, &s) in weights.iter_mut().zip(radii) {
            let square = s * s;
            *weight = ratio(*weight, square * square);
        }
        Self::of(radii, weights, low)
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            offset: self.offset + other.offset,
            slope: self.slope + other.slope,
            spread: self.spread + other.spread,
        }
    }

    pub(super) fn times(self, factor: T) -> Self {
        Self { offset: self.offset * factor, slope: self.slope * factor, spread: self.spread * factor }
    }

    /// The increment scaled so that it carries `load`, (π m/8) ∫ δ₀′ e^(−age) s⁴ ds, in units of π m/4.
    ///
    /// The load follows from the forces at both ends of the stretch, and the pressure from the load, except for where
    /// in the stretch it is laid: the roundings of m cancel, and so do those of δ₀′ and of ages that all nodes have in
    /// common. After a long history the rounding of radii counts beside the layer's thickness, but not beside its load.
    ///
    /// None where a load is left of which the increment carries nothing: the layer lies between its last radius and the
    /// first node of its rule.
    pub(super) fn scaled_to_load(self, load: T, low: T) -> Option<Self> {
        let carried = self.doubled_load(low);
        if load > T::zero() && carried > T::zero() {
            return Some(self.times(ratio(load + load, carried)));
        }
        let is_lost = load > T::zero() && carried.is_zero();
        (!is_lost).then_some(self)
    }

    /// The increment [scaled](Self::scaled_to_load) to a load, unless it is rounding: then it carries another load.
    pub(super) fn scaled_if_resolved(self, load: T, low: T) -> Option<Self> {
        let (carried, doubled) = (self.doubled_load(low), load + load);
        let is_resolved = load > T::zero() && carried <= doubled + doubled && load <= carried;
        is_resolved.then(|| self.times(ratio(doubled, carried)))
    }

    /// Twice the load that the increment carries.
    fn doubled_load(&self, low: T) -> T {
        let square = low * low;
        // s⁴ = low⁴ + 2 low² (s² − low²) + (s² − low²)²: in a thin layer the first term counts, and cancels against the
        // slope.
        self.slope * (square * square) + (self.offset * (square + square) + self.spread)
    }
}

/// The sum of a function of radii and weights.
#[inline(always)]
fn sum<T: Scalar>(radii: &[T], weights: &[T], at: impl Fn(T, T) -> T) -> T {
    // Four sums side by side, for vectors.
    let mut sums = [T::zero(); 4];
    let ((radii, radii_left), (weights, weights_left)) = (radii.as_chunks::<4>(), weights.as_chunks::<4>());
    for (radii, weights) in radii.iter().zip(weights) {
        for ((sum, &s), &weight) in sums.iter_mut().zip(radii).zip(weights) {
            *sum += at(s, weight);
        }
    }
    let left = radii_left.iter().zip(weights_left).map(|(&s, &weight)| at(s, weight));
    sums.into_iter().chain(left).fold(T::zero(), |all, value| all + value)
}
