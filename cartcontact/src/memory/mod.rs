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
///
/// The radius is rounded, which moves pressures by up to (n+2) ε/2. `surplus` is what the hereditary load exceeds
/// that of the rounded radius; to first order the two together are the radius to twice the precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment<T> {
    pub(crate) time: T,
    pub(crate) radius: T,
    pub(crate) surplus: T,
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

impl<T: Scalar> Moment<T> {
    /// ∫ δ₀′ ds from the rounded radius to the exact one, 2 surplus/((π m/4) a⁴) because dJ = a⁴ δ₀′ da/2.
    pub(crate) fn strip(&self, stiffness: T) -> T {
        if self.surplus.is_zero() {
            return T::zero();
        }
        let square = self.radius * self.radius;
        T::constant(2.0) * self.surplus / stiffness / square / square
    }
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
    let (stiffness, quarter_m) = (contact.stiffness(), contact.medium().m() * T::constant(0.25));
    let mut march = March {
        contact,
        to,
        now: from,
        impulse: contact.load().impulse(from.time),
        transition: Transition::none(reach),
    };
    // The pressures at the start have the strip beyond its rounded radius, the integrals begin at that radius.
    if reach <= from.radius {
        march.transition.slope -= quarter_m * from.strip(stiffness);
    }
    while march.now.time < to.time {
        march.advance_to_next_knot();
    }
    let slope = to.strip(stiffness);
    let offset = slope * ((to.radius - reach) * (to.radius + reach));
    march.transition.advance(T::one(), quarter_m, Increment { offset, slope }, reach);
    march.transition
}

/// A transition on its way from knot to knot.
struct March<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    to: Moment<T>,
    now: Moment<T>,
    impulse: T,
    transition: Transition<T>,
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to the next knot or the end, and through the jump that the load may make there.
    fn advance_to_next_knot(&mut self) {
        let (load, chi) = (self.contact.load(), self.contact.medium().chi());
        let start = self.now.time;
        let end = load.next_knot(start).map_or(self.to.time, |knot| knot.min(self.to.time));
        let duration = end - start;
        let (first, last, after) = (load.force(start), load.force_before(end), load.force(end));
        self.impulse = if load.is_linear_between_knots() {
            self.impulse + duration * (first + last) * T::constant(0.5)
        } else {
            load.impulse(end)
        };
        let (jumps, is_end) = (after > last, end >= self.to.time);
        // The radius at the end is known, and must be met to the last bit.
        let final_radius = if is_end { self.to.radius } else { self.radius_under(after) };
        let radius = if jumps { self.radius_under(last).min(final_radius) } else { final_radius };

        let at_end = is_end && !jumps;
        let surplus =
            if at_end { self.to.surplus } else { self.contact.surplus(last + chi * self.impulse, radius) };
        let course = Course::between(load, chi, start, duration, (first, last));
        self.cover(radius, course, surplus);
        if jumps {
            self.cover(final_radius, Course::Step, T::zero());
        }
        self.now.time = end;
    }

    /// Extends the contact to the radius `high` along a course of the load.
    fn cover(&mut self, high: T, course: Course<'_, T, L>, surplus: T) {
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let low = self.transition.reach.max(self.now.radius);
        let decay = course.decay(chi);
        let increment = Stretch { contact, course, low, high, surplus }.increment();
        self.transition.advance(decay, contact.medium().m() * T::constant(0.25), increment, low);
        self.now.radius = high;
    }

    /// The contact radius under a force at the impulse so far; a contact never exceeds that at the end.
    fn radius_under(&self, force: T) -> T {
        let hereditary = force + self.contact.medium().chi() * self.impulse;
        self.contact.radius_under(hereditary).unwrap_or(self.to.radius)
    }
}
