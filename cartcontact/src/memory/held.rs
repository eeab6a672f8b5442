//! The memory integral of a held load in one panel, however long the load was held.
//!
//! After X e-foldings the integrand is a layer at the edge, e^(−age) with ages that grow ever slower inwards: over the
//! length L of the stretch they would grow by E e-foldings at the rate of the edge, but grow by X only. In the variable
//! x with
//!
//! ```text
//! depth = x / (1 + β (1 − x/L)),  0 ≤ x ≤ L,    β = E/18
//! ```
//!
//! they grow at nearly one rate: nodes are 1 + β times as dense at the edge, and as thin at the other end.
//!
//! **How many nodes.** The limits below leave less than ε/5 of ∫ J′(s) s⁻⁴ e^(−age) {s² − low², 1} ds, most of it with
//! 16 nodes where both limits are reached, or ε/7 in single precision: computed in 25 digits for 27 000 random sums of
//! one to four powers p from 4.25 to 68 within the limits, and 7000 in single precision, of loads held from the
//! beginning and after other history. Because Y ≥ F when a load begins to be held, J cannot have grown by more than the
//! factor 1 + X since, so that s = 0, where s^(p−5) may be singular, is never near. What counts beside X is the highest
//! power p over the length, p L/a. (The `spread` of an [`Increment`], which no pressure contains, was not examined.)
//!
//! With terms of both signs zeros of δ₀′ may be near. If s δ₀′ rises from node to node, the finest rule still leaves
//! less than 0.002 ε in all but one of 4200 random cases, some of them with zeros at a distance of a thousandth of the
//! radius, and in that one 0.9 ε, with a condition number of 37. In single precision 12 nodes, which the last limits are
//! for, leave less than ε/5, in 6000 cases. Otherwise it may be anything, and the stretch is left to shorter panels.

use super::Increment;
use super::nodes::Node;
use super::stretch::{Course, Stretch};
use crate::load::Load;
use crate::numbers::tabled::{Tabled, tabled};
use crate::quadrature::Rule;
use crate::scalar::is_single;
use crate::{GapProfile, Scalar};

/// A rule, and how large p L/a and X may be.
type Limits = (&'static Rule, [Tabled; 2]);

const DOUBLE: [Limits; 3] = [
    (Rule::TWELVE, tabled([1.75, 5.5])),
    (Rule::SIXTEEN, tabled([5.0, 32.0])),
    (Rule::FINEST, tabled([15.0, 80.0])),
];
const SINGLE: [Limits; 2] = [(Rule::EIGHT, tabled([2.9, 20.0])), (Rule::TWELVE, tabled([15.0, 80.0]))];

/// The E for which β is 1. The best one is 15 to 20 for all rules.
const FOLDS_PER_BEND: f64 = 18.0;

/// E is below X (1 + p L/a), as p u/(1 − (1−u)^p) < 1 + p u. More comes of numbers that are out of range.
const MOST_FOLDS_AT_EDGE: f64 = 1500.0;

/// With terms of both signs, shorter rules and panels are quicker up to this X.
const MOST_FOLDS_OF_SHORT_PANELS: f64 = 4.0;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// What a held load adds to the pressure, up to the rounded radius at its end; none if no rule is for it.
    pub(super) fn increment_of_held_load(&self) -> Option<Increment<T>> {
        let rule = self.rule_for_held_load()?;
        let bend = self.folds_at_edge()? * T::constant(1.0 / FOLDS_PER_BEND);
        let length = self.high - self.low;
        let (most, per_length) = (T::one() + bend, bend / length);
        let panel = self.integrate(
            rule,
            (T::zero(), length),
            #[inline(always)]
            |x, dx| {
                let share = (most - per_length * x).recip();
                let depth = x * share;
                Node { s: self.high - depth, depth, weight: dx * (most * (share * share)) }
            },
        );
        panel.is_steady.then_some(panel.increment)
    }

    /// The shortest rule for the stretch, if its load was held.
    fn rule_for_held_load(&self) -> Option<&'static Rule> {
        if !matches!(self.course, Course::Linear(line) if line.is_held()) {
            return None;
        }
        let profile = self.contact.profile();
        let powers = (profile.highest_exponent() + T::constant(4.0)) * (self.high - self.low);
        let folds = self.course.folds();
        let limits: &[Limits] = if is_single::<T>() { &SINGLE } else { &DOUBLE };
        let first = if profile.has_only_positive_terms() {
            0
        } else if folds > T::constant(MOST_FOLDS_OF_SHORT_PANELS) {
            limits.len() - 1
        } else {
            return None;
        };
        let holds = |&&(_, most): &&Limits| {
            let [most_powers, most_folds] = most.map(Tabled::get::<T>);
            powers <= most_powers * self.high && folds <= most_folds
        };
        limits[first..].iter().find(holds).map(|&(rule, ..)| rule)
    }

    /// E, by how many e-foldings ages would grow over the stretch at the rate of the edge, dJ/ds = s⁴ δ₀′/2.
    fn folds_at_edge(&self) -> Option<T> {
        let (contact, square) = (self.contact, self.high * self.high);
        let slope = square * square * contact.profile().quick_approach_slope(self.high) * T::constant(0.5);
        let drop = slope * (self.high - self.low);
        let folds = self.age(contact.load_per_integral() * drop);
        (folds <= T::constant(MOST_FOLDS_AT_EDGE)).then_some(folds)
    }
}
