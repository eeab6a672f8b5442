//! The memory of the pressure: what a load history leaves behind, K⁻¹ of Eq. (28) without cancellation.
//!
//! Between two times t₁ < t₂ the pressure at a radius r covered throughout obeys
//!
//! ```text
//! P(r, t₂) = E P(r, t₁) + (m/4) ∫ₐ₍ₜ₁₎^ₐ₍ₜ₂₎ δ₀′(s) (s² − r²) e^(−χ (t₂ − τ(s))) ds,    E = e^(−χ (t₂ − t₁))
//! ```
//!
//! with τ(s) the time at which the contact radius is s; a radius covered only later starts at s = r. Every
//! term is positive. Writing s² − r² = (s² − c²) + (c² − r²) leaves two integrals that do not depend on r.
//!
//! Source: I. Argatov, Mech. Res. Commun. 38 (2011), Eqs. (25), (28), doi 10.1016/j.mechrescom.2010.11.006,
//! integrated by parts.

pub(crate) mod quadrature;
mod radius_form;
mod stretch;
mod time_form;

use crate::contact::Contact;
use crate::load::Load;
use crate::{GapProfile, Scalar};
use stretch::{Course, Stretch};

/// A time with the contact radius at it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment<T> {
    pub(crate) time: T,
    pub(crate) radius: T,
}

/// How pressures at radii r up to `reach` change from one moment to another:
/// P ← decay · P + offset + slope (reach² − r²).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transition<T> {
    pub(crate) decay: T,
    pub(crate) offset: T,
    pub(crate) slope: T,
    pub(crate) reach: T,
}

/// ∫ δ₀′(s) e^(−χ age) {s² − low², 1} ds over the radii from `low` to those of a stretch's end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Increment<T> {
    offset: T,
    slope: T,
}

impl<T: Scalar> Transition<T> {
    pub(crate) fn none(reach: T) -> Self {
        Self { decay: T::one(), offset: T::zero(), slope: T::zero(), reach }
    }

    /// The pressure after the transition, at a radius up to `reach`, from that before it.
    pub(crate) fn apply(&self, pressure: T, radius: T) -> T {
        self.decay * pressure + (self.offset + self.slope * ((self.reach - radius) * (self.reach + radius)))
    }

    /// [`apply`](Self::apply) to many radii, with two multiply-adds and a square per value.
    ///
    /// Taking the parabola from the axis instead of from `reach` costs up to ε reach/(a − r) near the edge.
    pub(crate) fn apply_to_row(&self, pressures: &[T], radii: &[T], results: &mut [T]) {
        let on_axis = self.offset + self.slope * self.reach * self.reach;
        for ((result, &pressure), &r) in results.iter_mut().zip(pressures).zip(radii) {
            *result = self.decay * pressure + (on_axis - self.slope * (r * r));
        }
    }

    /// This transition followed by another, which reaches further, for the radii that this one reaches.
    pub(crate) fn then(&self, next: &Self) -> Self {
        let margin = (next.reach - self.reach) * (next.reach + self.reach);
        Self {
            decay: self.decay * next.decay,
            offset: self.offset * next.decay + (next.offset + next.slope * margin),
            slope: self.slope * next.decay + next.slope,
            reach: self.reach,
        }
    }

    /// Continues with a stretch that multiplies by `decay` and adds `increment` beyond the radius `low`.
    fn advance(&mut self, decay: T, quarter_m: T, increment: Increment<T>, low: T) {
        let margin = (low - self.reach) * (low + self.reach);
        self.decay *= decay;
        self.offset = self.offset * decay + quarter_m * (increment.offset + increment.slope * margin);
        self.slope = self.slope * decay + quarter_m * increment.slope;
    }
}

impl<T: Scalar> Increment<T> {
    fn zero() -> Self {
        Self { offset: T::zero(), slope: T::zero() }
    }

    /// Adds the value of one node: `weight` is that of δ₀′ e^(−χ age) ds at the radius s.
    fn add(&mut self, weight: T, s: T, low: T) {
        self.offset += weight * ((s - low) * (s + low));
        self.slope += weight;
    }
}

/// The transition from one moment to another for radii up to `reach`, which is at least the first radius.
pub(crate) fn transition<T, P, L>(
    contact: &Contact<T, P, L>,
    from: Moment<T>,
    to: Moment<T>,
    reach: T,
) -> Transition<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let (load, chi) = (contact.load(), contact.medium().chi());
    let quarter_m = contact.medium().m() * T::constant(0.25);
    let mut transition = Transition::none(reach);
    let mut impulse = load.impulse(from.time);
    let mut now = from;
    while now.time < to.time {
        let end = load.next_knot(now.time).map_or(to.time, |knot| knot.min(to.time));
        let duration = end - now.time;
        let (first, last) = (load.force(now.time), load.force_before(end));
        impulse = if load.is_linear_between_knots() {
            impulse + duration * (first + last) * T::constant(0.5)
        } else {
            load.impulse(end)
        };
        let after = load.force(end);
        let jumps = after > last;
        let radius_at = |force: T| contact.radius_under(force + chi * impulse).unwrap_or(to.radius);
        // The radius at the end is known, and must be met to the last bit.
        let behind = if end < to.time { radius_at(after) } else { to.radius };
        let before = if jumps { radius_at(last).min(behind) } else { behind };

        let course = Course::between(load, chi, now.time, duration, (first, last));
        for (course, high) in [(course, before), (Course::Step, behind)] {
            let low = reach.max(now.radius);
            let decay = course.decay(chi);
            let increment = Stretch { contact, course, low, high }.increment();
            transition.advance(decay, quarter_m, increment, low);
            now.radius = high;
            if !jumps {
                break;
            }
        }
        now.time = end;
    }
    transition
}
