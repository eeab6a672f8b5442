//! Loads that are not straight, step by step.
//!
//! Between knots such a load is followed in steps, within which its force is a
//! [polynomial](crate::load::ForceSeries). A step is taken in one piece and in two halves; if the force is no polynomial,
//! or has another impulse than the load, or the two do not agree, it is shortened to its first half, otherwise the next is
//! twice as long. The halves are kept. No step is shorter than 2^−20 of the time between knots, nor than some roundings of
//! the time, so the march ends.
//!
//! What drains follows from the force wherever a step resolves it, so that the two ways agree in the end even if the impulse
//! is that of another load.

use super::March;
use crate::load::{ForceSeries, Load};
use crate::memory::stretch::Course;
use crate::{GapProfile, Scalar};

/// How often steps between knots are halved at most because of their impulse, which may simply be that of another load.
const MOST_DOUBTS: u32 = 256;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to a time before which there is no knot.
    pub(super) fn advance_in_steps(&mut self, end: T) {
        let half = T::constant(0.5);
        let share = (end - self.now.time) * T::constant(1.0 / 1_048_576.0);
        // A step must move the time, also where all of them are few roundings of it.
        let shortest = share.max(end * T::default_epsilon() * T::constant(4.0));
        let mut step = end - self.now.time;
        let mut doubts = MOST_DOUBTS;
        while self.now.time < end {
            let start = self.now.time;
            // The last step must not leave a rest that is too short to divide.
            let stop = if start + step + shortest < end { start + step } else { end };
            let force = self.force_series(stop);
            let is_doubtful = doubts > 0 && self.misses(&force, stop);
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
            if agree || step <= shortest {
                *self = halves;
            }
            step = if agree { step + step } else { (step * half).max(shortest) };
        }
    }

    /// The force from now to the end of a step.
    fn force_series(&self, end: T) -> ForceSeries<T> {
        let times = (self.now.time, end);
        ForceSeries::without_noise(self.contact.load(), times, self.contact.medium().chi())
    }

    /// Whether the nodes of a step miss what the load does between them.
    fn misses(&self, force: &ForceSeries<T>, end: T) -> bool {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let (before, after) = (load.impulse(self.now.time), load.impulse(end));
        // Early on, χ ∫F may be less than the rounding of F.
        let rounding = after * T::constant(64.0) + load.force_before(end) / chi * T::constant(4.0);
        force.is_loose(end) || force.misses(after - before, rounding * T::default_epsilon())
    }

    /// Continues along a step, and through a jump at its end, of which a knot may tell or not.
    fn advance_smooth(&mut self, force: &ForceSeries<T>, end: T) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let start = self.now.time;
        let (first, last, impulse) = (load.force(start), load.force_before(end), load.impulse(end));
        // Where the series is rough, the difference of two impulses may be the better one.
        let (of_series, uncertainty) = force.impulse();
        let is_better = uncertainty <= impulse * T::default_epsilon();
        let gained = if is_better { of_series } else { impulse - load.impulse(start) };
        self.now.impulse.add(gained);
        let radius = self.radius_under(end, last);
        self.cover(radius, Course::smooth(force), (first, last), force.gain() + chi * (gained - of_series));
        self.now.time = end;
        self.jump(last, self.force_now());
    }
}
