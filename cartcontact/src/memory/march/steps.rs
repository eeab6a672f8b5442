//! Loads that are not straight, step by step.
//!
//! Between knots such a load is followed in steps, within which its force is a [polynomial](crate::load::ForceSeries).
//! A step is taken whole and in two halves. If the force is no polynomial, or has another impulse than the load, or the
//! two results disagree, the step is shortened to its first half; otherwise the halves are kept, and the next step is
//! twice as long. No step is shorter than 2^−20 of the time between knots, nor than some roundings of the time, so the
//! march ends; where forces near zero are rounding, the first bound [grows](Shortest).
//!
//! **Jumps and kinks that no knot reports** are polynomials in no step. Because of them a limited number of steps is
//! halved further, down to roundings of the time; a force that is still no polynomial then has a jump. Behind it steps
//! grow again, resolved or not, up to the length that any number of steps may have: next to an instant at which a load
//! rises from zero, short ones only see how times are rounded.
//!
//! Drainage follows from the force wherever a step resolves it, so that the two results agree in the end even if the
//! impulse is that of another load.

use super::March;
use crate::load::{ForceSeries, Load, Shortest, least_step, rounding_within_load};
use crate::memory::degree::condition_of_radius;
use crate::memory::fading::Fading;
use crate::memory::stretch::Course;
use crate::scalar::without_derivatives;
use crate::{GapProfile, Scalar};

/// The most halvings of steps between knots because of their impulse, which may simply be that of another load. With 32
/// a rise as 1 − cos t loses digits; with 2048 impulses that cancel early take twice as many forces and more.
const MOST_DOUBTS: u32 = 256;
/// The most further halvings of the shortest steps: for some sixty jumps and kinks, with 32 halvings each.
const MOST_HALVINGS: u32 = 2048;

/// 2⁻²⁰ of the time between knots: most steps are no shorter.
const SHORTEST_SHARE: f64 = 1.0 / 1_048_576.0;

/// The length of steps.
///
/// Lengths carry no derivatives: where steps end within a history is not to depend on the time asked for. Ends that move
/// across a kink, of which no knot tells, would change what a step misses of it.
struct Pace<T> {
    step: T,
    /// The shortest length of a step.
    shortest: Shortest<T>,
    /// The shortest length of a limited number of steps: still long enough to move the time, also where the whole
    /// duration is few roundings of the time, or below the normal numbers.
    least: T,
    /// How many more steps may be shorter than `shortest`.
    halvings: u32,
    /// Whether the step before could not be shortened enough.
    follows_given_up: bool,
}

impl<T: Scalar> Pace<T> {
    fn over(duration: T, end: T) -> Self {
        let [duration, end] = [duration, end].map(without_derivatives);
        let least = least_step(end);
        let shortest = Shortest::of((duration * T::constant(SHORTEST_SHARE)).max(least), u32::MAX);
        Self { step: duration, shortest, least, halvings: MOST_HALVINGS, follows_given_up: false }
    }

    /// The end of a step that begins at `start`; no rest that is too short to divide may be left before `end`.
    fn stop(&self, start: T, end: T) -> T {
        let rest = self.step.min(self.shortest.length());
        if start + self.step + rest < end { start + self.step } else { end }
    }

    fn is_long(&self) -> bool {
        self.step > self.shortest.length()
    }

    /// False if the step may not be shortened.
    fn halve(&mut self) -> bool {
        let is_long = self.is_long();
        let is_last = self.step <= self.least || self.halvings == 0 || self.follows_given_up;
        if !is_long && is_last {
            return false;
        }
        self.halvings -= u32::from(!is_long);
        self.step =
            (self.step * T::constant(0.5)).max(if is_long { self.shortest.length() } else { self.least });
        true
    }

    /// Goes on after a step that is resolved.
    fn double(&mut self) {
        self.shortest.resolve(self.step);
        self.step += self.step;
        self.follows_given_up = false;
    }

    /// Goes on after a step that could not be shortened.
    ///
    /// The next one may not be much shorter. After a jump it is resolved. But behind an instant at which a load rises
    /// from zero, all that short steps see is how times are rounded: they have to grow beyond that.
    fn give_up(&mut self) {
        if self.step >= self.shortest.length() {
            self.shortest.give_up();
        }
        self.step += self.step;
        self.follows_given_up = true;
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to a time before which there is no knot.
    pub(super) fn advance_in_steps(&mut self, end: T) {
        let mut pace = Pace::over(end - self.now.time, end);
        let mut doubts = MOST_DOUBTS;
        // A share x of the force leaves a share x^((n+2)/(n+4)) of the pressure on the axis, and nothing elsewhere.
        let negligible = self.force_at_end * (T::default_epsilon() * T::default_epsilon());
        while self.now.time < end {
            let force = self.force_series(pace.stop(self.now.time, end));
            if force.largest() <= negligible {
                self.advance_through_jump(&force);
                pace.double();
                continue;
            }
            if force.is_rough() {
                if self.advance_below_reach(&force) {
                    pace.double();
                } else if !pace.halve() {
                    if force.is_unresolved() {
                        self.advance_through_jump(&force);
                    } else {
                        self.advance_smooth(&force);
                    }
                    pace.give_up();
                }
                continue;
            }
            // What a stretch adds that begins within the step is not scaled to forces.
            if !self.is_covered() && force.falls_far() && pace.is_long() {
                pace.halve();
                continue;
            }
            if doubts > 0 && pace.is_long() && self.leaves_something_out(&force) {
                doubts -= 1;
                pace.halve();
                continue;
            }
            self.advance_in_halves(&force, &mut pace);
        }
    }

    /// Continues along the halves of a step, or only shortens it if they do not add what the whole does.
    fn advance_in_halves(&mut self, force: &ForceSeries<T>, pace: &mut Pace<T>) {
        let middle = self.now.time + force.duration() * T::constant(0.5);
        if middle <= self.now.time || middle >= force.end() {
            // The middle of neighbouring times is one of them, and a load that jumps there would do so twice.
            self.advance_smooth(force);
            pace.double();
            return;
        }
        let mut halves = self.clone();
        halves.advance_smooth(&self.force_series(middle));
        if halves.now.radius <= self.transition.reach && force.duration() > pace.shortest.length() {
            // Nothing of the first half counts, so the second would only be compared with itself.
            *self = halves;
            pace.double();
            return;
        }
        halves.advance_smooth(&halves.force_series(force.end()));
        let mut whole = self.clone();
        whole.advance_smooth(force);
        let radius = halves.now.radius;
        let edge = (radius, condition_of_radius(self.contact.profile(), radius));
        if whole.transition.agrees_with(&halves.transition, edge, self.roundings_of_halves()) {
            *self = halves;
            pace.double();
        } else if !pace.halve() {
            *self = halves;
            pace.give_up();
        }
    }

    /// How many roundings the halves of a step may add up to beside the whole: half of what pressures may be off.
    ///
    /// Next to a kink, or where a load rises from zero, the halves are off by nearly as much as the whole is: with eight
    /// times as many, pressures in single precision were off by 20 ε, with 128 times by 150 ε. Terms of both signs round
    /// by more than that, and would ask for forces in vain.
    fn roundings_of_halves(&self) -> T {
        T::constant(if self.contact.profile().has_only_positive_terms() { 0.5 } else { 64.0 })
    }

    /// The force from now to the end of a step.
    pub(super) fn force_series(&self, end: T) -> ForceSeries<T> {
        let times = (self.now.time, end);
        ForceSeries::without_noise(self.contact.load(), times, self.contact.medium().chi())
    }

    /// Whether the series of a step leaves out more than rounding, or its nodes miss what the load does between them.
    fn leaves_something_out(&self, force: &ForceSeries<T>) -> bool {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let (before, after) = (load.impulse(self.now.time), load.impulse(force.end()));
        // Early on, χ ∫F may be less than the rounding of F, which is a few ε.
        let of_force = force.last() / chi * T::default_epsilon() * T::constant(4.0);
        force.is_loose() || force.misses(after - before, rounding_within_load(after) + of_force)
    }

    /// Continues along a step, and through a jump at its end.
    fn advance_smooth(&mut self, force: &ForceSeries<T>) {
        let (gained, of_series) = self.take_impulse(force);
        let gain = force.gain() + self.contact.medium().chi() * (gained - of_series);
        self.arrive(force.end(), &Course::smooth(force), force.ends(), gain);
    }

    /// Continues through a step in which the force jumps, as if it jumped at the end.
    ///
    /// By then, as much of what the hereditary load gains has drained as lets the pressures carry the force. Most jumps
    /// are narrowed down to an instant, in which nothing drains; but a step may also be long, where the search for
    /// shorter ones was given up.
    fn advance_through_jump(&mut self, force: &ForceSeries<T>) {
        let (end, chi) = (force.end(), self.contact.medium().chi());
        let (first, last) = force.ends();
        let (gained, _) = self.take_impulse(force);
        let folds = chi * (end - self.now.time);
        let fading = Fading::over(folds);
        let (gain, (kept, _)) = ((last - first) + chi * gained, fading.kept_of((first, last)));
        // An impulse larger than such a force can make is rounding, and says nothing about what has drained.
        let is_of_force = chi * gained <= folds * (force.largest() + force.largest());
        let age = if is_of_force && T::zero() < kept && kept < gain { (gain / kept).ln() } else { T::zero() };
        self.fade(fading);
        // Time has passed already.
        let course = Course::Step { age, folds: T::zero() };
        self.arrive(end, &course, (fading.after(first, T::zero()), last), gain);
    }

    /// Covers what the contact reaches at the end of a step, and passes a jump there, which a knot may report or not.
    fn arrive(&mut self, end: T, course: &Course<'_, T>, forces: (T, T), gain: T) {
        let radius = self.radius_under(end, forces.1);
        self.cover(radius, course, forces, gain);
        self.now.time = end;
        self.jump(forces.1, self.force_now());
    }

    /// Continues through a step if the contact stays below the radii that the transition is for: then only the impulse
    /// counts, and any way will do.
    pub(super) fn advance_below_reach(&mut self, force: &ForceSeries<T>) -> bool {
        let mut ahead = self.clone();
        ahead.advance_through_jump(force);
        let is_below = ahead.now.radius < self.transition.reach;
        if is_below {
            *self = ahead;
        }
        is_below
    }

    /// Adds the gain of the impulse up to the end of a step, and returns it with the gain according to the series.
    fn take_impulse(&mut self, force: &ForceSeries<T>) -> (T, T) {
        let load = self.contact.load();
        let impulse = load.impulse(force.end());
        // Where the series is rough, the difference of two impulses may be more accurate.
        let (of_series, uncertainty) = force.impulse();
        let is_better = uncertainty <= impulse.max(of_series) * T::default_epsilon();
        let gained = if is_better { of_series } else { impulse - load.impulse(self.now.time) };
        self.now.impulse.add(gained);
        (gained, of_series)
    }
}
