//! What lies at the edge itself: strips, and gains that are laid at one radius.
//!
//! **The strip** is the ring between the rounded radius and the exact one. An integral over the radius runs between
//! rounded radii, so it lays the strip at its beginning a second time: that strip is taken out first, and the strip at
//! the very end is added after the march. Integrals over time, and pressures laid at once where the edge stands still,
//! do not use rounded radii: there the strip stays, and fades with the rest. Counting it as new would be wrong under a
//! load that falls as fast as e^(−χ t): it would soon be the whole pressure.

use super::March;
use crate::load::Load;
use crate::memory::fading::Fading;
use crate::memory::{Increment, Stage, surplus_that_counts};
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Adds the strip at the present edge to the pressures, or takes it away, and returns the load that strips carry at
    /// the end of a stretch beside its integral: none if the strip `stays`, otherwise that of the strip at the end less
    /// what is left of the one taken away.
    pub(super) fn settle_strips(&mut self, stays: bool, surplus: T, fading: Fading<T>) -> T {
        if stays {
            self.add_strip();
            return T::zero();
        }
        self.leave_strip();
        fading.after(-self.now.surplus, surplus)
    }

    /// Adds the strip.
    pub(super) fn add_strip(&mut self) {
        if !self.has_strip {
            self.add_at_edge(self.now.strip(self.contact.integral_per_load()));
            self.has_strip = true;
        }
    }

    /// Takes away the strip, which an integral over the radius lays again, because it begins at the rounded radius.
    pub(super) fn leave_strip(&mut self) {
        if self.has_strip {
            self.add_at_edge(-self.now.strip(self.contact.integral_per_load()));
            self.has_strip = false;
        }
    }

    fn add_at_edge(&mut self, weight: T) {
        let increment = Increment::at(self.now.radius, weight, self.transition.reach);
        self.transition.add(self.quarter_m(), increment);
    }

    /// Lays all that a stretch gains at its last radius, which is some roundings from its first.
    ///
    /// After a long history the layer that still counts is thinner than the spacing of numbers, and no integral over
    /// radii can resolve it. Because Y′ e^(χ τ) = (F e^(χ τ))′, what is left of the gain at the end is F₂ − E F₁,
    /// whatever the course; one radius for the whole gain puts the pressure off by less than the share by which the
    /// radius grew. The gain includes the strip, which is as old as the rest.
    pub(super) fn cover_at_once(&mut self, high: T, fading: Fading<T>, forces: (T, T), gain: T) {
        self.add_strip();
        let (kept, _) = fading.kept_of(forces);
        let increment = self.laid_at_once(high, kept, gain);
        let low = self.low();
        self.transition.advance(fading, self.quarter_m(), increment, low);
        let surplus = surplus_that_counts(self.surplus_at(high, gain), forces.1);
        self.now = Stage { radius: high, surplus, ..self.now };
    }

    /// The increment of what is `kept` of a gain during a stretch that covers hardly more than now, laid at one radius.
    pub(super) fn laid_at_once(&self, high: T, kept: T, gain: T) -> Increment<T> {
        // The mean place of what is kept: half-way if nothing drains, and next to the edge if nearly all does.
        let share = if !has_no_derivatives::<T>() {
            // The same place but for rounding, and there second derivatives are those of the gain.
            T::constant(0.5)
        } else if T::zero() < kept && kept <= gain {
            kept / (kept + gain)
        } else {
            T::zero()
        };
        let at = high - (high - self.now.radius) * share;
        let laid = Stage { radius: at, surplus: kept, ..self.now };
        let low = self.low();
        Increment::at(at, laid.strip(self.contact.integral_per_load()), low)
    }
}
