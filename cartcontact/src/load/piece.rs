//! A straight part of a load.

use super::rounding::allowed_fall;
use crate::Scalar;
use crate::scalar::{has_no_derivatives, smallest_normal, with_value};

/// A part of a load that is linear in time, from one time in s with its force in N to another.
///
/// # Examples
///
/// ```
/// use cartcontact::load::{Load, Piece, PiecewiseLinear};
///
/// let ramp_and_hold = PiecewiseLinear::new([(0.0, 0.0), (20.0, 100.0)])?;
/// let mut pieces = [Piece { start: (0.0, 0.0), end: (0.0, 0.0) }; 4];
/// assert_eq!(ramp_and_hold.straight_pieces((5.0, 30.0), &mut pieces), 2);
/// assert_eq!(pieces[0], Piece { start: (5.0, 25.0), end: (20.0, 100.0) });
/// assert_eq!(pieces[1], Piece { start: (20.0, 100.0), end: (30.0, 100.0) });
/// # Ok::<(), cartcontact::load::LoadError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<T> {
    /// The time at which it starts, and the force from then on.
    pub start: (T, T),
    /// The time at which it ends, and the force up to then; the same time makes it a step.
    pub end: (T, T),
}

impl<T: Scalar> Piece<T> {
    /// A piece of no duration and no force.
    pub(crate) fn none() -> Self {
        Self { start: (T::zero(), T::zero()), end: (T::zero(), T::zero()) }
    }

    pub(crate) fn duration(&self) -> T {
        self.end.0 - self.start.0
    }

    /// Whether it takes no time.
    pub(crate) fn is_step(&self) -> bool {
        self.duration().is_zero()
    }

    /// By how much the force rises.
    pub(crate) fn rise(&self) -> T {
        self.end.1 - self.start.1
    }

    /// Whether the load is held along the piece and up to a later time with its force. Equal forces may have derivatives
    /// that are not.
    #[inline]
    pub(super) fn holds_until(&self, (_, force): (T, T)) -> bool {
        has_no_derivatives::<T>() && self.start.1 == self.end.1 && self.end.1 == force
    }

    /// The force at a time within the piece; after it, if it is a step.
    pub(crate) fn force(&self, t: T) -> T {
        if self.is_step() {
            return self.end.1;
        }
        // Starting from the smaller force, so that the addend loses none of its digits.
        let (from, to) =
            if self.end.1 < self.start.1 { (self.end, self.start) } else { (self.start, self.end) };
        let (elapsed, rise) = ((t - from.0).abs(), to.1 - from.1);
        let share = elapsed / self.duration();
        // So small a share has lost digits, but the slope has not.
        let gained = if share < smallest_normal() { rise / self.duration() * elapsed } else { rise * share };
        let force = from.1 + gained;
        // The sum may round to a neighbour of the force that was given.
        if share == T::one() {
            return with_value(to.1, force);
        }
        // Rounded to zero it would be no load, although χ ∫F may be one.
        let is_lost = force <= T::zero() && rise > T::zero() && elapsed > T::zero();
        if is_lost { force + smallest_normal::<T>() * T::default_epsilon() } else { force }
    }

    /// Half-way between the forces at its ends.
    pub(super) fn mean_force(&self) -> T {
        let half = T::constant(0.5);
        // The sum of the forces need not be in range.
        self.start.1 * half + self.end.1 * half
    }

    /// ∫F over the piece.
    pub(crate) fn impulse(&self) -> T {
        self.duration() * self.mean_force()
    }

    /// The part of it between two times, of which at least one is within the piece. The time at which it starts may have
    /// other derivatives than the same time `from`.
    #[inline]
    pub(crate) fn between(&self, from: T, until: T) -> Self {
        let starts_later = from > self.start.0 || !has_no_derivatives::<T>() && from == self.start.0;
        let start = if starts_later { (from, self.force(from)) } else { self.start };
        let end = if until < self.end.0 { (until, self.force(until)) } else { self.end };
        Self { start, end }
    }

    /// The part before a time within the piece.
    #[inline]
    pub(crate) fn before(&self, t: T) -> Self {
        self.between(self.start.0, t)
    }

    /// Whether it is a step, or F′ and F′ + χ F can be finite.
    pub(super) fn has_slope(&self) -> bool {
        let slope = self.rise() / self.duration();
        self.is_step() || (slope + slope).is_finite()
    }

    /// The [`fall`](Self::fall) if rounding has made the force at the end smaller, by 8 ε of the first one. A fall as
    /// fast as e^(−χ t) may be too fast by that much when its forces are rounded: a long fall leaves so little that this
    /// is more than its own rounding.
    pub(super) fn fall_beyond_rounding(&self) -> T {
        self.fall(allowed_fall(self.start.1))
    }

    /// −F′/F at the end of the piece, where it is largest, if the force there has been rounded down by as much as
    /// `rounding`; 0 only if the load does not fall by more.
    fn fall(&self, rounding: T) -> T {
        let (first, last) = (self.start.1, self.end.1);
        let drop = (first - last) - rounding;
        // A drop is a share of the force that the format can hold, so only the result can leave the format.
        if drop > T::zero() {
            (drop / (last + rounding) / self.duration()).max(smallest_normal())
        } else {
            T::zero()
        }
    }

    /// Whether it ends with no less than the bound F/(1 + χ Δt), as the format has it: that is no fall of the hereditary
    /// load, however often the bound is rounded the same way.
    pub(super) fn keeps_bound(&self, chi: T) -> bool {
        self.end.1 >= self.start.1 / (T::one() + chi * self.duration())
    }

    /// The smallest rate χ, but at least `least`, with which the piece [keeps its bound](Self::keeps_bound); infinite if
    /// there is none.
    ///
    /// The bound falls with χ, also as it is rounded, so that numbers can be halved between one with which it is not
    /// kept and one with which it is. Among the pieces of a load few have a larger one than all before them.
    pub(super) fn least_rate(&self, least: T) -> T {
        if self.keeps_bound(least) {
            return least;
        }
        let (mut low, mut high) = (least, self.fall(T::zero()).max(least));
        let mut step = high * T::default_epsilon();
        while high.is_finite() && !self.keeps_bound(high) {
            high += step;
            step += step;
        }
        loop {
            let middle = low + (high - low) * T::constant(0.5);
            let is_between = low < middle && middle < high && high.is_finite();
            if !is_between {
                return high;
            }
            if self.keeps_bound(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
    }

    /// The first time within the piece at which F′ + χ F < 0, if it is by more than rounding.
    pub(super) fn recession(&self, chi: T) -> Option<T> {
        // F′ + χ F is least at the end.
        if self.fall_beyond_rounding() <= chi {
            return None;
        }
        // χ F = −F′ within the piece, or the piece begins with a recession.
        let drop = self.start.1 - self.end.1;
        let held = self.duration() * (self.start.1 / drop) - chi.recip();
        Some(self.start.0 + held.max(T::zero()).min(self.duration()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_the_least_that_keep_the_bound() {
        let piece = |start, end| Piece { start, end };
        for (piece, rate) in [
            (piece((1.0, 5.0), (1.0, 4.0)), f64::INFINITY),
            (piece((1.0, 5.0), (2.0, 0.0)), f64::INFINITY),
            (piece((1.0, 4.0), (1.0, 5.0)), 0.25),
            (piece((1.0, 4.0), (2.0, 4.0)), 0.25),
            // 1 + χ is rounded to 2.
            (piece((1.0, 4.0), (2.0, 2.0)), 1.0 - f64::EPSILON / 2.0),
        ] {
            assert_eq!(piece.least_rate(0.25), rate, "{piece:?}");
        }
    }

    /// The sum of the smaller force and the difference of both may be the larger one's neighbour.
    #[test]
    fn forces_at_the_ends_are_those_that_were_given() {
        let (small, large) = (9.313_970_874_327_678, 26.472_158_698_259_218);
        assert!(small + (large - small) != large);
        for forces in [(small, large), (large, small)] {
            let piece = Piece { start: (0.5, forces.0), end: (1.25, forces.1) };
            assert_eq!((piece.force(0.5), piece.force(1.25)), forces);
        }
    }

    /// The sum of two forces may be above the range, and the rate of a slow fall below it.
    #[test]
    fn impulses_and_falls_stay_in_range() {
        let held = Piece { start: (0.0, f64::MAX), end: (1.0, f64::MAX) };
        assert_eq!(held.impulse(), f64::MAX);
        let falling = Piece { start: (0.0, 1.0), end: (f64::MAX, 1.0 - 9.0 * f64::EPSILON) };
        assert!(falling.fall_beyond_rounding() > 0.0);
    }

    #[test]
    fn eight_roundings_are_no_fall() {
        let to = |roundings: f64| Piece { start: (0.0, 1.0), end: (1.0, 1.0 - roundings * f64::EPSILON) };
        assert_eq!(to(8.0).recession(0.0), None);
        assert_eq!(to(9.0).recession(0.0), Some(0.0));
    }
}
