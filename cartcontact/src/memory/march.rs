//! From one moment to another, knot by knot.
//!
//! **Rounding.** The hereditary load Y grows like χ t, and an error ε Y is an error ε Y/F in χ t: after a long history
//! two moments computed on their own would not agree on what lies between them. So only differences are used: a
//! surplus follows from the one before it by what Y and J gained since, both without cancellation.
//!
//! **Loads that are not straight.** Between knots such a load is followed in steps. A step is taken in one piece and
//! in two halves; if the two do not agree, it is shortened to its first half, otherwise the next is twice as
//! long. The halves are kept. No step is shorter than 2^−20 of the time between knots, so the march ends.

use super::stretch::{Course, Stretch};
use super::{Increment, Moment, Transition, not_negative};
use crate::contact::{Contact, Loading};
use crate::load::Load;
use crate::{GapProfile, Scalar};

/// The transition for radii up to `reach`, at least the first radius, to a time with its contact radius; and the
/// moment at its end.
pub(crate) fn march<T, P, L>(
    contact: &Contact<T, P, L>,
    from: Moment<T>,
    (time, radius): (T, T),
    reach: T,
) -> (Transition<T>, Moment<T>)
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let impulse = contact.load().impulse(from.time);
    let mut march = March { contact, time, radius, now: from, impulse, transition: Transition::none(reach) };
    let stiffness = contact.stiffness();
    // The pressures at the start have the strip beyond its rounded radius, the integrals begin at that radius.
    if reach <= from.radius {
        march.transition.slope -= march.quarter_m() * from.strip(stiffness);
    }
    while march.now.time < time {
        march.advance_to_next_knot();
    }
    let slope = march.now.strip(stiffness);
    let offset = slope * ((radius - reach) * (radius + reach));
    march.transition.advance(T::one(), march.quarter_m(), Increment { offset, slope }, reach);
    march.transition.offset = not_negative(march.transition.offset);
    (march.transition, march.now)
}

/// After how many e-foldings a pressure is below rounding, with a margin.
pub(crate) fn faded_folds<T: Scalar>() -> T {
    -T::default_epsilon().ln() + T::constant(4.0)
}

/// The surplus of a moment, unless it is too large for its radius to be taken as exact to first order.
///
/// A surplus of x times the force is a pressure of x times the force, and makes all ages later by x e-foldings; to
/// first order the two cancel, since a held load has little more to drain. When the hereditary load is 1/√ε times
/// the force and more, its rounding makes x² more than rounding. Leaving the surplus out moves the radius by a rounding
/// error and no more.
pub(crate) fn surplus_that_counts<T: Scalar>(surplus: T, force: T) -> T {
    if surplus.abs() <= force * T::default_epsilon().sqrt() { surplus } else { T::zero() }
}

/// A transition on its way.
struct March<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    /// Where it ends; that radius must be met to the last bit.
    time: T,
    radius: T,
    now: Moment<T>,
    impulse: T,
    transition: Transition<T>,
}

// Not derived, because neither profile nor load need be `Clone`.
impl<T: Scalar, P, L> Clone for March<'_, T, P, L> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to the next knot or the end, and through the jump that the load may make there.
    fn advance_to_next_knot(&mut self) {
        let load = self.contact.load();
        let end = load.next_knot(self.now.time).map_or(self.time, |knot| knot.min(self.time));
        if load.is_linear_between_knots() {
            self.skip_what_fades(end);
            self.advance_straight(end);
        } else {
            self.advance_in_steps(end);
        }
        let (before, after) = (load.force_before(end), load.force(end));
        if after > before {
            let radius = self.radius_under(end, after);
            self.cover(radius, Course::Step, (before, after), after - before);
        }
    }

    /// Leaves out what a straight stretch that does not fall adds so early that nothing of it is left at its end.
    ///
    /// What a held load covered `folds` e-foldings ago carries e^(−folds) of it. The panels of an integral are chosen for
    /// what counts, next to the edge, and could not resolve it within a much longer stretch.
    fn skip_what_fades(&mut self, end: T) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let folds = faded_folds::<T>();
        let (start, force) = (self.now.time, load.force(self.now.time));
        if chi * (end - start) <= folds + folds
            || start >= end * (T::one() - T::default_epsilon() * T::constant(8.0))
            || load.force_before(end) < force
        {
            return;
        }
        // At least a few roundings of the time, lest nothing is left.
        let time = end - (folds / chi).max(end * T::default_epsilon() * T::constant(4.0));
        let skipped = load.force(time);
        self.impulse += (time - start) * (force + skipped) * T::constant(0.5);
        let radius = self.radius_under(time, skipped).max(self.now.radius);
        let decay = (-(chi * (time - start))).exp();
        self.transition.advance(decay, self.quarter_m(), Increment::zero(), radius);
        self.now = self.contact.moment_under(Loading::new(skipped, self.impulse, chi), time, radius);
    }

    fn advance_straight(&mut self, end: T) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let duration = end - self.now.time;
        let (first, last) = (load.force(self.now.time), load.force_before(end));
        let impulse = duration * (first + last) * T::constant(0.5);
        self.impulse += impulse;
        let radius = self.radius_under(end, last);
        let gain = (last - first) + chi * impulse;
        self.cover(radius, Course::straight(chi, duration, (first, last)), (first, last), gain);
        self.now.time = end;
    }

    fn advance_in_steps(&mut self, end: T) {
        let half = T::constant(0.5);
        let shortest = (end - self.now.time) * T::constant(1.0 / 1_048_576.0);
        let mut step = end - self.now.time;
        while self.now.time < end {
            let start = self.now.time;
            // The last step must not leave a rest that is too short to divide.
            let stop = if start + step + shortest < end { start + step } else { end };
            let mut halves = self.clone();
            halves.advance_smooth(start + (stop - start) * half);
            if halves.now.radius <= self.transition.reach && stop - start > shortest {
                // Nothing of the first half counts, so the second would only be compared with itself.
                *self = halves;
                continue;
            }
            halves.advance_smooth(stop);
            let mut whole = self.clone();
            whole.advance_smooth(stop);
            let agree = whole.transition.agrees_with(&halves.transition);
            if agree || step <= shortest {
                *self = halves;
            }
            step = if agree { step + step } else { (step * half).max(shortest) };
        }
    }

    fn advance_smooth(&mut self, end: T) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let start = self.now.time;
        let first = load.force(start);
        let before = first + chi * self.impulse;
        self.impulse = load.impulse(end);
        let last = load.force_before(end);
        let radius = self.radius_under(end, last);
        let course = Course::Smooth { load, start, duration: end - start };
        self.cover(radius, course, (first, last), last + chi * self.impulse - before);
        self.now.time = end;
    }

    /// Extends the contact to a radius along a course of the load between two forces, on which the hereditary load
    /// gains `gain`.
    fn cover(&mut self, high: T, course: Course<'_, T, L>, forces: (T, T), gain: T) {
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let decay = course.decay(chi);
        let depth = high - self.now.radius;
        if depth <= high * T::default_epsilon() * T::constant(16.0)
            && self.transition.reach <= self.now.radius
        {
            self.cover_at_once(high, course.fading(chi), decay, forces);
            return;
        }
        let growth = contact.profile().load_integral_drop(high, depth);
        let exact_surplus = self.now.surplus + (gain - contact.stiffness() * growth);
        let surplus = surplus_that_counts(exact_surplus, forces.1);
        let low = self.transition.reach.max(self.now.radius);
        let is_left_out = surplus != exact_surplus && self.transition.reach <= self.now.radius;
        let kept = is_left_out.then(|| (forces.1 - forces.0) + forces.0 * course.fading(chi));
        let mut increment = Stretch { contact, course, low, high, surplus }.increment();
        if let Some(kept) = kept {
            increment.carry(kept / contact.stiffness(), (low, high));
        }
        self.transition.advance(decay, self.quarter_m(), increment, low);
        self.now = Moment { radius: high, surplus, ..self.now };
    }

    /// Lays what a stretch gains at its last radius, which is the first one but for some roundings.
    ///
    /// After a long history the layer that still counts is thinner than the spacing of numbers, and no integral over radii
    /// can resolve it. Because Y′ e^(χ τ) = (F e^(χ τ))′, what is left of the gain at the end is F₂ − E F₁, whatever
    /// the course; with one radius for all of it the pressure is off by the share by which the radius grew.
    fn cover_at_once(&mut self, high: T, fading: T, decay: T, (first, last): (T, T)) {
        let kept = Moment { radius: high, surplus: (last - first) + first * fading, ..self.now };
        let low = self.transition.reach.max(self.now.radius);
        let slope = kept.strip(self.contact.stiffness());
        let offset = slope * ((high - low) * (high + low));
        self.transition.advance(decay, self.quarter_m(), Increment { offset, slope }, low);
        self.now.radius = high;
    }

    /// The contact radius at a time under a force at the impulse so far; a contact never exceeds that at the end.
    fn radius_under(&self, time: T, force: T) -> T {
        let load = self.contact.load();
        if time >= self.time && force >= load.force(time) {
            return self.radius;
        }
        let hereditary = force + self.contact.medium().chi() * self.impulse;
        self.contact.radius_under(hereditary).unwrap_or(self.radius).min(self.radius)
    }

    fn quarter_m(&self) -> T {
        self.contact.medium().m() * T::constant(0.25)
    }
}
