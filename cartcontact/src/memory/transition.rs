//! How pressures change from one stage to another.

use super::Increment;
use super::fading::Fading;
use crate::Scalar;
use crate::numbers::compensated_sum::CompensatedSum;

/// How pressures at radii r up to `reach` change from one stage to another:
/// P ← decay · P + offset + slope (reach² − r²).
///
/// Along a record of a hundred thousand pieces each sum changes a little that many times, and is rounded as often.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transition<T> {
    pub(crate) decay: CompensatedSum<T>,
    pub(crate) offset: CompensatedSum<T>,
    pub(crate) slope: CompensatedSum<T>,
    pub(crate) reach: T,
}

impl<T: Scalar> Transition<T> {
    pub(crate) fn none(reach: T) -> Self {
        let zero = CompensatedSum::from(T::zero());
        Self { decay: T::one().into(), offset: zero, slope: zero, reach }
    }

    /// The pressure after the transition, at a radius up to `reach`, from that before it.
    ///
    /// Where the rounded radius exceeds the exact one, the strip between them leaves a small negative remainder.
    #[inline(always)]
    pub(crate) fn apply(&self, pressure: T, radius: T) -> T {
        let gain = self.offset.value + self.slope.value * ((self.reach - radius) * (self.reach + radius));
        not_negative(self.decay.value * pressure + gain)
    }

    /// Whether two computations of the same transition, at whose end the contact has a `radius`, differ by no more than
    /// some `roundings`. These count the more, the narrower the ring beyond the reach is. The radius is off by
    /// `condition` roundings.
    pub(super) fn agrees_with(&self, other: &Self, (radius, condition): (T, T), roundings: T) -> bool {
        if radius <= self.reach {
            // Nothing was covered.
            return true;
        }
        let edge = radius * condition / (radius - self.reach).max(radius * T::default_epsilon());
        let tolerance = T::default_epsilon() * roundings * (T::constant(8.0) + edge);
        let agree = |x: T, y: T| (x - y).abs() <= tolerance * x.abs().max(y.abs());
        agree(self.offset.value, other.offset.value) && agree(self.slope.value, other.slope.value)
    }

    /// Continues with a stretch that fades what there was and adds `increment` beyond the radius `low`.
    pub(super) fn advance(&mut self, fading: Fading<T>, quarter_m: T, increment: Increment<T>, low: T) {
        let margin = (low - self.reach) * (low + self.reach);
        fading.pass(&mut self.decay, T::zero());
        fading.pass(&mut self.offset, quarter_m * (increment.offset + increment.slope * margin));
        fading.pass(&mut self.slope, quarter_m * increment.slope);
    }

    /// Continues with a time during which nothing is laid.
    pub(super) fn fade(&mut self, fading: Fading<T>) {
        for sum in [&mut self.decay, &mut self.offset, &mut self.slope] {
            fading.pass(sum, T::zero());
        }
    }

    /// Adds an increment beyond the reach that takes no time.
    pub(super) fn add(&mut self, quarter_m: T, increment: Increment<T>) {
        self.offset.add(quarter_m * increment.offset);
        self.slope.add(quarter_m * increment.slope);
    }
}

/// A pressure without the negative remainder that rounding may leave at the edge; NaN stays NaN.
#[inline(always)]
pub(crate) fn not_negative<T: Scalar>(pressure: T) -> T {
    if pressure < T::zero() { T::zero() } else { pressure }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As under δ₀′ that nearly vanishes, where the strip between the rounded edge and the exact one is wide.
    #[test]
    fn what_rounding_takes_beyond_the_edge_is_no_negative_pressure() {
        let none = Transition::none(1.0);
        let transition = Transition { offset: (-1e-11).into(), slope: 1e-5.into(), ..none };
        assert_eq!(transition.apply(0.0, 1.0 - 1e-7), 0.0);
    }
}
