//! When the edge passes the radii that a transition is for, along a load that is not straight.
//!
//! What was laid before does not count, so the march may begin shortly before then: at a time when the hereditary load
//! lacks a sixteenth, give or take a half, of what it gains beyond the reach. A step from there to the end is hardly
//! longer than what counts of it; longer ones, halved until they are, would take up to twenty times the forces.
//!
//! The time is searched for in a bracket, of which the force and the impulse at one time replace an end. False position
//! finds it within a few times along a smooth load; every second one halves the bracket, so that at most 2⁻¹⁶ of the
//! duration is left before a jump when the search ends, after 32 times at the latest, and the steps go on from there.

use super::March;
use crate::contact::Loading;
use crate::load::{Load, least_step};
use crate::scalar::without_derivatives;
use crate::{GapProfile, Scalar};

const MOST_TIMES: u32 = 32;

/// How far the hereditary load before the reach is from that of the reach, as a share of what it gains beyond it. Any
/// from 1/8 to 1/64 takes as many forces.
const MARGIN: f64 = 1.0 / 16.0;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to shortly before the edge passes the reach; to a time before which there is no knot, if it does not
    /// do so before.
    pub(super) fn approach_reach(&mut self, end: T) {
        let before = self.time_before_reach(end);
        if before > self.now.time {
            let force = self.force_series(before);
            self.advance_below_reach(&force);
        }
    }

    /// A time up to `end` at which the edge is still below the reach, by a margin if it is beyond the reach at the end.
    ///
    /// Such times carry no derivatives, as those that divide histories into steps.
    fn time_before_reach(&self, end: T) -> T {
        let (contact, load) = (self.contact, self.contact.load());
        let hereditary = |time| without_derivatives(contact.loading(time).hereditary);
        let at_end = Loading::new(load.force_before(end), load.impulse(end), contact.medium().chi());
        let last = without_derivatives(at_end.hereditary);
        let load_integral = contact.profile().quick_load_integral(self.transition.reach);
        let at_reach = without_derivatives(contact.load_per_integral() * load_integral);
        // Otherwise the radius might be rounded to the reach.
        let rounding = last * T::default_epsilon() * T::constant(32.0);
        let margin = ((last - at_reach) * T::constant(MARGIN)).max(rounding);
        let (half_margin, sought) = (margin * T::constant(0.5), at_reach - margin);
        let excess = |time| hereditary(time) - sought;
        let [start, stop] = [self.now.time, end].map(without_derivatives);
        let (mut before, mut after) = ((start, excess(start)), (stop, last - sought));
        if after.1 <= T::zero() {
            return end;
        }
        for count in 0..MOST_TIMES {
            let length = after.0 - before.0;
            if before.1 >= -half_margin || length <= least_step(stop) {
                break;
            }
            let share = if count % 2 == 1 { T::constant(0.5) } else { before.1 / (before.1 - after.1) };
            let time = before.0 + length * share;
            let place = (time, excess(time));
            if place.1 <= half_margin {
                before = place;
            } else {
                after = place;
            }
        }
        before.0
    }
}
