//! Loads that are not straight, step by step.
//!
//! Between knots such a load is followed in steps, within which its force is a
//! [polynomial](crate::memory::force_series). A step is taken in one piece and in two halves; if the force is no polynomial,
//! or has another impulse than the load, or the two do not agree, it is shortened to its first half, otherwise the next is
//! twice as long. The halves are kept. No step is shorter than 2^−20 of the time between knots, so the march ends.
//!
//! Radii follow from impulses, ages from forces. Under an impulse that belongs to another force, which a load that is
//! not searched for it may have, no step is short enough for the two ways to agree. Where that was so often enough, what
//! drains is taken from the force alone, until the end, whose radius is given.

use super::March;
use crate::load::{Load, Sum};
use crate::memory::force_series::ForceSeries;
use crate::memory::stretch::Course;
use crate::{GapProfile, Scalar};

/// How often steps between knots are halved at most because of their impulse, which may simply be that of another load.
const MOST_DOUBTS: u32 = 256;

/// In how many steps of a march that disagree the force may have another impulse than the load before that is no longer
/// believed: some milliseconds. Where both are right, it is about one for each change of the load between samples.
pub(super) const MOST_CONFLICTS: u32 = 1024;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to a time before which there is no knot.
    pub(super) fn advance_in_steps(&mut self, end: T) {
        let half = T::constant(0.5);
        let shortest = (end - self.now.time) * T::constant(1.0 / 1_048_576.0);
        let mut step = end - self.now.time;
        let mut doubts = MOST_DOUBTS;
        while self.now.time < end {
            let start = self.now.time;
            // The last step must not leave a rest that is too short to divide.
            let stop = if start + step + shortest < end { start + step } else { end };
            let force = self.force_series(stop);
            let is_doubtful = doubts > 0 && self.believes_impulses() && self.misses(&force, stop);
            if (force.is_rough() || is_doubtful) && step > shortest {
                doubts -= u32::from(is_doubtful);
                step = (step * half).max(shortest);
                continue;
            }
            let middle = start + (stop - start) * half;
            let mut halves = self.clone();
            halves.advance_smooth(&self.force_series(middle), middle);
            if halves.now.radius <= self.transition.reach && stop - start > shortest {
                // Nothing of the first half counts, so the second would only be compared with itself.
                *self = halves;
                step += step;
                continue;
            }
            halves.advance_smooth(&halves.force_series(stop), stop);
            let mut whole = self.clone();
            whole.advance_smooth(&force, stop);
            let agree = whole.transition.agrees_with(&halves.transition, halves.now.radius);
            let conflicts =
                self.conflicts.saturating_sub(u32::from(!agree && self.is_contradicted(&force, stop)));
            if agree || step <= shortest {
                *self = halves;
            }
            self.conflicts = conflicts;
            step = if agree { step + step } else { (step * half).max(shortest) };
        }
    }

    /// The force from now to the end of a step.
    fn force_series(&self, end: T) -> ForceSeries<T> {
        let times = (self.now.time, end);
        ForceSeries::between(self.contact.load(), times, self.contact.medium().chi()).without_noise(end)
    }

    /// Whether the nodes of a step miss what the load does between them.
    fn misses(&self, force: &ForceSeries<T>, end: T) -> bool {
        force.is_loose(end) || self.is_contradicted(force, end)
    }

    /// Whether the load has another impulse over a step than its force.
    fn is_contradicted(&self, force: &ForceSeries<T>, end: T) -> bool {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let impulse = load.impulse(end);
        // Early on, χ ∫F may be less than the rounding of F.
        let noticed = impulse * T::constant(64.0) + load.force_before(end) / chi * T::constant(4.0);
        force.misses(impulse - self.now.impulse.value, noticed * T::default_epsilon())
    }

    /// Whether what drains is taken from the impulse of the load.
    fn believes_impulses(&self) -> bool {
        self.conflicts > 0
    }

    /// Continues along a step.
    fn advance_smooth(&mut self, force: &ForceSeries<T>, end: T) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let (start, impulse) = (self.now.time, load.impulse(end));
        let (first, last) = (load.force(start), load.force_before(end));
        let believes = self.believes_impulses();
        let before = if believes { self.now.impulse.value } else { load.impulse(start) };
        // Where the series is rough, the difference of two impulses may be the better one.
        let (of_series, uncertainty) = force.impulse();
        let is_better = uncertainty <= impulse * T::default_epsilon();
        let gained = if is_better { of_series } else { impulse - before };
        self.now.impulse.add(gained);
        if believes {
            self.now.impulse = Sum::from(impulse);
        }
        let radius = self.radius_under(end, last);
        self.cover(radius, Course::smooth(force), (first, last), force.gain() + chi * (gained - of_series));
        self.now.time = end;
    }
}
