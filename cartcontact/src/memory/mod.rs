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
//!
//! | module | what it does |
//! |---|---|
//! | `march` | goes from one time to another, knot by knot; `march::steps`: where the load is not straight |
//! | `run` | many short straight pieces of the load at once |
//! | `late` | radii that are reached late, stretch by stretch of time |
//! | `stretch` | one stretch without a knot: by `radius_form` (held or rising loads) or `time_form` (all others) |
//! | `held` | the integral over the radius of a held load, in one panel |
//! | `nodes` | the nodes of an integral over the radius |
//! | `line`, `fading` | how long ago Y was smaller, along a straight load; what is left after some e-foldings |
//!
//! Terms used throughout: a *stage* is a time with its contact radius; the *age* of a radius is the time since the edge
//! passed it; a *fold* is one e-folding, a duration of 1/χ; a *deficit* is the amount by which Y was smaller than at
//! the end of a stretch, and the *surplus* of a stage the amount by which Y exceeds that of its rounded radius; the
//! *strip* is the ring between the rounded radius and the exact one; the *reach* of a transition is the largest radius
//! that it holds for.

mod fading;
mod held;
mod late;
mod line;
mod march;
mod nodes;
mod radius_form;
mod run;
mod stretch;
mod time_form;

use crate::Scalar;
use crate::numbers::compensated_sum::CompensatedSum;
use crate::scalar::is_nothing;
use fading::Fading;

pub(crate) use fading::{FEW_FOLDS, decay_gain, faded_folds};
pub(crate) use late::Late;
pub(crate) use line::Line;
pub(crate) use march::march;

/// A stage of the contact: a time with its contact radius.
///
/// The radius is rounded, which moves pressures by up to (n+2) ε/2. `surplus` is the amount by which the hereditary
/// load exceeds that of the rounded radius; to first order the two together are the radius to twice the precision.
/// Stages along one history share the error of the first surplus, which amounts to a slightly different time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stage<T> {
    pub(crate) time: T,
    pub(crate) radius: T,
    pub(crate) surplus: T,
    /// ∫F from the beginning.
    pub(crate) impulse: CompensatedSum<T>,
}

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

/// ∫ δ₀′(s) e^(−χ age) {s² − low², 1, (s² − low²)²} ds over the radii from `low` to that at the end of a stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Increment<T> {
    offset: T,
    slope: T,
    spread: T,
}

impl<T: Scalar> Stage<T> {
    /// ∫ δ₀′ ds from the rounded radius to the exact one, 2 surplus/((π m/4) a⁴) because dJ = a⁴ δ₀′ da/2.
    #[inline(always)]
    pub(crate) fn strip(&self, integral_per_load: T) -> T {
        if is_nothing(self.surplus) || self.radius.is_zero() {
            return T::zero();
        }
        // One division, and a⁴ need not be in range.
        let per_square = (self.radius * self.radius).recip();
        T::constant(2.0) * self.surplus * integral_per_load * per_square * per_square
    }
}

/// The surplus of a stage, unless it is too large for its radius to be taken as exact to first order.
///
/// A surplus of x times the force adds a pressure of first order in x, and shifts all ages by x e-foldings, which takes
/// as much away, since a held load has little more to drain. When the hereditary load is at least 1/√ε times
/// the force, its rounding makes x² larger than rounding. Leaving the surplus out moves the radius by no more than a
/// rounding error.
pub(crate) fn surplus_that_counts<T: Scalar>(surplus: T, force: T) -> T {
    if surplus.abs() <= force * T::default_epsilon().sqrt() { surplus } else { T::zero() }
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

    /// The pressure after the transition at the radius `reach`, if there was none before it.
    pub(crate) fn first_pressure(&self) -> T {
        self.offset.value
    }

    /// Whether two computations of the same transition, at whose end the contact has a `radius`, differ by little more
    /// than rounding. Rounding counts the more, the narrower the ring beyond the reach is. The radius is off by
    /// `condition` roundings.
    fn agrees_with(&self, other: &Self, radius: T, condition: T) -> bool {
        if radius <= self.reach {
            // Nothing was covered.
            return true;
        }
        let edge = radius * condition / (radius - self.reach).max(radius * T::default_epsilon());
        let tolerance = T::default_epsilon() * T::constant(64.0) * (T::constant(8.0) + edge);
        let agree = |x: T, y: T| (x - y).abs() <= tolerance * x.abs().max(y.abs());
        agree(self.offset.value, other.offset.value) && agree(self.slope.value, other.slope.value)
    }

    /// Continues with a stretch that fades what there was and adds `increment` beyond the radius `low`.
    fn advance(&mut self, fading: Fading<T>, quarter_m: T, increment: Increment<T>, low: T) {
        let (offset, slope) = self.gain(quarter_m, increment, low);
        fading.pass(&mut self.decay, T::zero());
        fading.pass(&mut self.offset, offset);
        fading.pass(&mut self.slope, slope);
    }

    /// Adds an increment that takes no time.
    fn add(&mut self, quarter_m: T, increment: Increment<T>, low: T) {
        let (offset, slope) = self.gain(quarter_m, increment, low);
        self.offset.add(offset);
        self.slope.add(slope);
    }

    fn gain(&self, quarter_m: T, increment: Increment<T>, low: T) -> (T, T) {
        let margin = (low - self.reach) * (low + self.reach);
        (quarter_m * (increment.offset + increment.slope * margin), quarter_m * increment.slope)
    }
}

/// A pressure without the negative remainder that rounding may leave at the edge; NaN stays NaN.
#[inline(always)]
pub(crate) fn not_negative<T: Scalar>(pressure: T) -> T {
    if pressure < T::zero() { T::zero() } else { pressure }
}

impl<T: Scalar> Increment<T> {
    fn zero() -> Self {
        Self { offset: T::zero(), slope: T::zero(), spread: T::zero() }
    }

    /// An increment laid at the radius s: `weight` is ∫ δ₀′ e^(−χ age) ds.
    #[inline(always)]
    fn at(s: T, weight: T, low: T) -> Self {
        let rise = (s - low) * (s + low);
        Self { offset: weight * rise, slope: weight, spread: weight * rise * rise }
    }

    /// An increment laid at some radii, with a weight for each.
    #[inline(always)]
    fn of(radii: &[T], weights: &[T], low: T) -> Self {
        // One sum after the other: vectors then take several radii, instead of all values of one.
        let offset = sum(
            radii,
            weights,
            #[inline(always)]
            |s, weight| weight * ((s - low) * (s + low)),
        );
        let slope = sum(
            radii,
            weights,
            #[inline(always)]
            |_, weight| weight,
        );
        let spread = sum(
            radii,
            weights,
            #[inline(always)]
            |s, weight| {
                let rise = (s - low) * (s + low);
                weight * rise * rise
            },
        );
        Self { offset, slope, spread }
    }

    /// The increment of an integral over time, where δ₀′ ds is 2 dJ/s⁴: the weights are those of 2 e^(−χ age) dJ, and
    /// are divided by s⁴ here.
    #[inline(always)]
    fn over_time(radii: &[T], weights: &mut [T], low: T) -> Self {
        for (weight, &s) in weights.iter_mut().zip(radii) {
            let square = s * s;
            *weight /= square * square;
        }
        Self::of(radii, weights, low)
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self {
            offset: self.offset + other.offset,
            slope: self.slope + other.slope,
            spread: self.spread + other.spread,
        }
    }

    fn times(self, factor: T) -> Self {
        Self { offset: self.offset * factor, slope: self.slope * factor, spread: self.spread * factor }
    }

    /// The increment scaled so that it carries `load`, (π m/8) ∫ δ₀′ e^(−χ age) s⁴ ds, in units of π m/4.
    ///
    /// The load follows from the forces at both ends of the stretch, and the pressure from the load, except for where
    /// in the stretch it is laid: the roundings of m cancel, and so do those of δ₀′ and of ages that all nodes have in
    /// common. After a long history the rounding of radii counts beside the layer's thickness, but not beside its load.
    fn scaled_to_load(self, load: T, low: T) -> Self {
        let carried = self.doubled_load(low);
        if load > T::zero() && carried > T::zero() { self.times((load + load) / carried) } else { self }
    }

    /// The increment [scaled](Self::scaled_to_load) to a load, unless it is rounding: then it carries another load.
    fn scaled_if_resolved(self, load: T, low: T) -> Option<Self> {
        let (carried, doubled) = (self.doubled_load(low), load + load);
        let is_resolved = load > T::zero() && carried <= doubled + doubled && load <= carried;
        is_resolved.then(|| self.times(doubled / carried))
    }

    /// Twice the load that the increment carries.
    fn doubled_load(&self, low: T) -> T {
        let square = low * low;
        // s⁴ = low⁴ + 2 low² (s² − low²) + (s² − low²)²: in a thin layer the first term counts, and cancels against the
        // slope.
        self.slope * (square * square) + (self.offset * (square + square) + self.spread)
    }
}

/// The sum of a function of radii and weights.
#[inline(always)]
fn sum<T: Scalar>(radii: &[T], weights: &[T], at: impl Fn(T, T) -> T) -> T {
    // Four sums side by side, for vectors.
    let mut sums = [T::zero(); 4];
    let ((radii, radii_left), (weights, weights_left)) = (radii.as_chunks::<4>(), weights.as_chunks::<4>());
    for (radii, weights) in radii.iter().zip(weights) {
        for ((sum, &s), &weight) in sums.iter_mut().zip(radii).zip(weights) {
            *sum += at(s, weight);
        }
    }
    let left = radii_left.iter().zip(weights_left).map(|(&s, &weight)| at(s, weight));
    sums.into_iter().chain(left).fold(T::zero(), |all, value| all + value)
}
