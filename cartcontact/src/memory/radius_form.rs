//! The memory integrals over the radius: ∫ δ₀′(s) e^(−age(s)) {…} ds with the integrands of an [`Increment`].
//!
//! The variable is the depth below the edge: after a long history the integrand is a thin layer there, for which
//! rounded radii would be too coarse. Most held loads take one panel, see [`held`](super::held). All others take panels
//! as long as the finest rule integrates to full accuracy, usually one. What lies below a panel adds at most
//! e^(−age) (δ₀(s) − δ₀(low)), because ages only grow inwards; the integral ends when that no longer counts.
//!
//! Under a profile with fractional exponents the innermost quarter, `increment_of_core`, is integrated over s^(1/4)
//! instead. That makes multiples of 1/4 whole and leaves other powers s^n a singularity of order 4 (n+2) − 1, at least
//! 7; outside the core the singularity at r = 0 is far enough away for any rule.

use super::Increment;
use super::nodes::{Node, PanelIntegral};
use super::stretch::Stretch;
use crate::load::Load;
use crate::quadrature::Rule;
use crate::{GapProfile, Scalar};

/// How much larger slopes may be elsewhere than where they are evaluated.
///
/// Measured: a margin of 1.3 left up to 14 ε of the peak pressure where a few e-foldings fade over one panel, because
/// the age is a power of the radius and not a line; with 1.5 less than 6 ε were seen.
const MARGIN: f64 = 1.5;

/// How much larger the fading over a panel may be than measured: smaller than [`MARGIN`], because it is measured over
/// the whole panel and at its end, not extrapolated from its beginning.
const MARGIN_OF_MEASURED_FADING: f64 = 1.3;

/// A singularity of the integrand counts as this many e-foldings in a length equal to its distance: the rule of 24
/// nodes needs panels of at most 2.2 distances (its error falls as ρ^(−48), with ρ = 2.26 for a distance of 0.45 of the
/// length), or of 31 folds.
const FOLDS_AT_DISTANCE: f64 = 14.4;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// What the stretch adds to the pressure, up to the rounded radius at its end.
    pub(super) fn increment_over_radius(&self) -> Increment<T> {
        if self.is_steepest_at_edge() && self.changes_little() {
            return self.panel(Rule::EIGHT, (T::zero(), self.high - self.low)).increment;
        }
        if let Some(increment) = self.increment_of_held_load() {
            return increment;
        }
        self.increment_of_panels()
    }

    /// Whether ages grow fastest at the edge, as J′ of positive terms rises with the radius.
    fn is_steepest_at_edge(&self) -> bool {
        self.contact.profile().has_only_positive_terms() && self.course.is_held()
    }

    /// What the stretch adds, in as many panels as it takes.
    fn increment_of_panels(&self) -> Increment<T> {
        let (profile, deepest) = (self.contact.profile(), self.high - self.low);
        let three_quarters = self.high * T::constant(0.75);
        // The depth at which the core begins.
        let core = if profile.is_smooth_at_centre() { deepest } else { deepest.min(three_quarters) };
        let mut sum = Increment::zero();
        let (mut depth, mut age) = (T::zero(), T::zero());
        while depth < core {
            let (end, rule) = self.next_panel((depth, age), core);
            let (increment, end) = self.increment_from(depth, end, rule);
            sum = sum.plus(increment);
            depth = end;
            if depth < deepest {
                age = self.age_at(depth);
                if self.is_all_that_counts((depth, age), &sum) {
                    return sum;
                }
            }
        }
        if core < deepest {
            sum = sum.plus(self.increment_of_core(self.high - core));
        }
        sum
    }

    /// The end, at most `core`, of the panel that begins at a depth with an age, and the rule for it.
    fn next_panel(&self, (depth, age): (T, T), core: T) -> (T, &'static Rule) {
        let most = Rule::FINEST.folds::<T>();
        let (of_powers, of_fading) = self.folds_per_length(depth, age);
        let rate = of_powers + of_fading;
        let end = if rate * (core - depth) <= most {
            core
        } else {
            (depth + (most / rate).max(self.shortest_panel())).min(core)
        };
        if self.is_steepest_at_edge() {
            return (end, Rule::for_folds(rate * (end - depth)));
        }
        let (end, folds) = self.end_of_panel((depth, age), end, of_powers);
        (end, Rule::for_folds((rate * (end - depth)).max(folds)))
    }

    /// Whether what lies below a depth with an age adds nothing to the sum of what lies above.
    fn is_all_that_counts(&self, (depth, age): (T, T), sum: &Increment<T>) -> bool {
        let profile = self.contact.profile();
        let negligible = T::default_epsilon() * T::constant(0.0625);
        let uncertainty = T::default_epsilon() * T::constant(8.0);
        let (low, top) = (self.low, self.high - depth);
        let (at_top, at_low) = (profile.quick_approach(top), profile.quick_approach(low));
        // Two powers near the zeroth may differ by less than their rounding, which then bounds what is left.
        let rest = (-age).exp() * ((at_top - at_low) + at_top * uncertainty);
        let rest_offset = rest * ((top - low) * (top + low));
        rest <= sum.slope * negligible && rest_offset <= sum.offset * negligible
    }

    /// The increment from a depth to another, and where it ends: before, if the finest rule does not resolve the
    /// integrand up to there.
    fn increment_from(&self, depth: T, mut end: T, rule: &'static Rule) -> (Increment<T>, T) {
        let mut panel = self.panel(rule, (depth, end));
        if !panel.is_steady && !rule.is_finest() {
            panel = self.panel(Rule::FINEST, (depth, end));
        }
        let shortest = self.shortest_panel();
        while panel.error > T::default_epsilon() && end - depth > shortest {
            let middle = depth + (end - depth) * T::constant(0.5);
            let half = self.panel(Rule::FINEST, (depth, middle));
            // Over half the panel, what is smooth is resolved far better; what is not is rounding.
            if half.error > panel.error * T::constant(0.25) {
                break;
            }
            (panel, end) = (half, middle);
        }
        (panel.increment, end)
    }

    /// The integral by a rule between two depths.
    ///
    /// Where δ₀′ nearly vanishes, at u = 0, and rises again further in, the integrand is like u² e^(−c u³). In the
    /// plane of complex radii this grows faster than any exponential that is as steep in the panel: for c = 1/2 on one
    /// side of it, 12 nodes are needed instead of 8. The finest rule leaves 1e-16 for all c that its panels allow, on
    /// either side or on both; what else the integrand may be like, its estimate of the error tells.
    fn panel(&self, rule: &Rule, (start, end): (T, T)) -> PanelIntegral<T> {
        let edge = self.high;
        self.integrate(
            rule,
            (start, end),
            #[inline(always)]
            |depth, weight| Node { s: edge - depth, depth, weight },
        )
    }

    /// Whatever the integrand, there are at most some thousand panels.
    fn shortest_panel(&self) -> T {
        (self.high - self.low) * T::constant(1.0 / 4096.0)
    }

    /// The end of a panel, moved closer until the integrand changes by no more than the finest rule integrates, and the
    /// number of e-foldings by which it does: those of its powers, per length, and those by which the history fades,
    /// with a margin.
    ///
    /// The rate at its beginning does not bound the rate further in where δ₀′ nearly vanishes there and rises again.
    fn end_of_panel(&self, (depth, age): (T, T), end: T, of_powers: T) -> (T, T) {
        let margin = T::constant(MARGIN_OF_MEASURED_FADING);
        let most = Rule::FINEST.folds::<T>();
        let mut length = end - depth;
        loop {
            let age_at_end = self.age_at(depth + length);
            // The rate at the end, from the last 64th of the panel.
            let age_before_end = self.age_at(depth + length * T::constant(63.0 / 64.0));
            let fading = margin * (age_at_end - age).max((age_at_end - age_before_end) * T::constant(64.0));
            let folds = of_powers * length + fading;
            // NaN, which derivatives may be, gets no better.
            let is_halved = folds > most && length > self.shortest_panel();
            if !is_halved {
                return (depth + length, folds);
            }
            length *= T::constant(0.5);
        }
    }

    /// The increment of the radii from `low` to `top`, at most a quarter of the contact radius, in the variable
    /// s^(1/4).
    ///
    /// Next to the centre a slope s^(n−1) may leave the format. Nodes that do not count need not lie there.
    fn increment_of_core(&self, top: T) -> Increment<T> {
        let fourth_root = |s: T| if s.is_zero() { s } else { s.sqrt().sqrt() };
        let ends = (fourth_root(self.low), fourth_root(top));
        let least = (self.high * share_that_counts()).max(self.low);
        let panel = self.integrate(
            Rule::FINEST,
            ends,
            #[inline(always)]
            |x, weight| {
                let cube = x * x * x;
                let s = (cube * x).max(least);
                Node { s, depth: self.high - s, weight: weight * T::constant(4.0) * cube }
            },
        );
        panel.increment
    }

    /// Whether the shortest rule suffices for a whole stretch of a held load under positive terms, whatever its panels
    /// are.
    ///
    /// The [`folds_per_length`](Self::folds_per_length) are greatest at the edge, where ages grow by J′/Y′ per length.
    /// For a term of power p, over the share u of the radius, that adds up to p u/(1 − (1−u)^p) < 1 + p u times the
    /// growth of the ages, which is at most χ times the duration.
    fn changes_little(&self) -> bool {
        let (contact, high) = (self.contact, self.high);
        let (n, length) = (contact.profile().highest_exponent(), high - self.low);
        let powers = (n + T::one()) * length;
        let fading = self.course.folds() * (high + (n + T::constant(4.0)) * length);
        let centre = folds_at_centre(contact.profile()) * length;
        // Both sides times the radius, so that nothing is divided.
        T::constant(MARGIN) * (powers + fading) + centre <= Rule::EIGHT.folds::<T>() * high
    }

    /// How fast the integrand changes at a depth, in e-foldings per length, for the choice of a rule: its powers, and
    /// e^(−age).
    ///
    /// These are the logarithmic slopes of its powers and of e^(−age), with a [`MARGIN`], and what singularities
    /// count as, [`FOLDS_AT_DISTANCE`].
    fn folds_per_length(&self, depth: T, age: T) -> (T, T) {
        let profile = self.contact.profile();
        let top = self.high - depth;
        let n = profile.highest_exponent();
        // The rate at which ages grow, from the first 64th of what is left, and before a high power has fallen off.
        let step =
            ((top - self.low) * T::constant(1.0 / 64.0)).min(top * T::constant(0.5) / (n + T::constant(4.0)));
        // δ₀′ (s² − low²); a high power may add little here, but no short rule integrates it.
        let powers = (n + T::one()) / top;
        let fading = (self.age_at(depth + step) - age) / step;
        let of_singularity =
            self.singularity(top).map_or(T::zero(), |distance| T::constant(FOLDS_AT_DISTANCE) / distance);
        let of_centre = folds_at_centre(profile) / top;
        (powers * T::constant(MARGIN) + of_singularity + of_centre, fading * T::constant(MARGIN))
    }
}

/// √(ε/8), the share of the contact radius within which less than ε/8 is laid: s^(n+2) of ∫ δ₀′ s² ds.
pub(crate) fn share_that_counts<T: Scalar>() -> T {
    (T::default_epsilon() * T::constant(0.125)).sqrt()
}

/// How many e-foldings the centre counts as, in a length equal to its distance: a short rule notices s^(n−1) next to
/// s = 0 from far away.
fn folds_at_centre<T: Scalar, P: GapProfile<T>>(profile: &P) -> T {
    if profile.is_smooth_at_centre() { T::zero() } else { T::constant(FOLDS_AT_DISTANCE) }
}
