//! The memory integrals over time, along a falling load or one that is not straight.
//!
//! Let D(x) be the amount by which the hereditary load x e-foldings before the end is below its final value: along a
//! straight load it is R x + G x²/2, where R = Y′/χ at the end and G = −F′/χ are forces. Then
//! δ₀′ ds = 2 dD/((π m/4) s⁴) turns the integrals over s into
//!
//! ```text
//! (8/(π m)) ∫ D′(x) e^(−x) {s² − low², 1, (s² − low²)²} / s⁴ · dx
//! ```
//!
//! with s from the inverse of J, up to the exact radius at the end. The integrand stays smooth where the load falls as
//! fast as e^(−χ t), Y′ = 0; over the radius it would contain a square root that vanishes.
//!
//! It is singular at the age d at which Y, continued backwards, reaches zero: there s behaves as (d − x)^(1/p). A panel
//! is integrated in the variable √(d − x), in which the singularity is farther away in comparison with the panel.
//!
//! The other singularities are where δ₀′ vanishes in the plane of complex radii. Where one is near, s changes so fast
//! that its values at the nodes show it; then the finest rule and shorter panels are used. Next to a singularity,
//! panels of √ε/16 of the stretch are short enough: over one of them s changes like a cube root at worst, by 1e-3 in
//! f64; 24 nodes miss up to 8e-3 of that, and the product with the length is 32 ε, while a J′ is 1e-6 times what it is
//! elsewhere and the condition number as much larger. Nothing shorter can be told from the rounding of s. A singularity
//! has one such panel or two, a geometry few singularities. But where terms cancel to all but a few digits, no panel is
//! resolved: the shortest one is therefore doubled whenever a panel of its length is not.

use super::Increment;
use super::degree::condition_of_radius;
use super::nodes::PerNode;
use super::stretch::Stretch;
use crate::contact::Contact;
use crate::dispatch::half_wide;
use crate::load::Load;
use crate::numbers::exponential::decay;
use crate::quadrature::Rule;
use crate::scalar::greater;
use crate::{GapProfile, Scalar};

/// The most halvings of panels. A user-defined geometry may have radii that no panel resolves.
const MOST_HALVINGS: u32 = 256;

/// As how many e-foldings one counts; what [`FOLDS_AT_DISTANCE`] was computed with.
const MARGIN: f64 = 1.2;

/// How many e-foldings are added to a panel, because D′ may vanish at the end; computed as [`FOLDS_AT_DISTANCE`] was.
const ADDED_FOLDS: f64 = 0.5;

/// The singularity counts as this many e-foldings in a length equal to its distance.
///
/// Along a straight load Y ≥ F puts it at least one e-folding before the beginning. All rules then leave less than ε/4,
/// computed in 40 digits for p from 4.25 to 68, parabolas D from a line to one with D′ = 0 at the end, and distances
/// from 1 to 100 000 e-foldings.
const FOLDS_AT_DISTANCE: f64 = 10.0;

/// [`FOLDS_AT_DISTANCE`] along a load that is not straight, whose singularity may be nearer, and whose force may vary
/// like a polynomial of high degree: computed for distances from 0.01 e-foldings on.
const FOLDS_AT_ANY_DISTANCE: f64 = 37.0;

/// The increment of a stretch during which the hereditary load falls short of its final value by D and rises at D′,
/// which `shortfall` gives for x; `rate` and `rise` are R and G of a parabola that nowhere rises less.
pub(super) fn increment<T, P, L>(
    stretch: &Stretch<'_, T, P, L>,
    (rate, rise): (T, T),
    shortfall: impl Fn(T) -> (T, T) + Copy,
) -> Increment<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let (contact, low) = (stretch.contact, stretch.low);
    let final_integral =
        contact.profile().quick_load_integral(stretch.high) + stretch.surplus * contact.integral_per_load();
    let condition = condition_of_radius(contact.profile(), stretch.high);
    let history = History { contact, final_integral, low, condition, shortfall };
    let longest = if stretch.is_whole { stretch.course.folds() } else { stretch.age_at(stretch.high - low) };
    let singular = history.age_of_nothing((rate + rise * longest, rise), longest);
    let is_straight = stretch.course.is_straight();
    let at_distance = T::constant(if is_straight { FOLDS_AT_DISTANCE } else { FOLDS_AT_ANY_DISTANCE });
    history.increment_up_to(longest, (singular, at_distance))
}

/// How far the hereditary load fell short of its final value, which is given by its load integral.
struct History<'a, T, P, L, S> {
    contact: &'a Contact<T, P, L>,
    final_integral: T,
    low: T,
    /// How many roundings a radius may be off by.
    condition: T,
    /// D and D′ of an age.
    shortfall: S,
}

impl<T, P, L, S> History<'_, T, P, L, S>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
    S: Fn(T) -> (T, T) + Copy,
{
    /// The age at which the hereditary load would have been zero, if it rose at `rate` at the `longest` age, and before
    /// that faster by `rise` per e-folding.
    fn age_of_nothing(&self, (rate, rise): (T, T), longest: T) -> T {
        let two = T::constant(2.0);
        // As shares of the hereditary load then: the squares of forces may be out of range.
        let hereditary =
            self.contact.load_per_integral() * self.contact.profile().quick_load_integral(self.low);
        let (rate, rise) = (rate / hereditary, rise / hereditary);
        let before = two / (rate + (rate * rate + two * rise).sqrt());
        // However little there was, panels must not shrink to nothing.
        (longest + before).max(longest * (T::one() + T::default_epsilon().sqrt()))
    }

    /// The increment of ages up to the `longest`, if a singularity at the age `singular` counts as `at_distance`
    /// e-foldings in a length equal to its distance.
    fn increment_up_to(&self, longest: T, (singular, at_distance): (T, T)) -> Increment<T> {
        let most = Rule::FINEST.folds::<T>();
        let mut sum = Increment::zero();
        let mut start = T::zero();
        let mut length = longest;
        let mut shortest = length * T::default_epsilon().sqrt() * T::constant(1.0 / 16.0);
        let (mut is_simple, mut halvings) = (true, 0);
        // Beyond two panels' worth of e-foldings nothing counts any more.
        while start < longest && start < most + most {
            let distance = singular - start;
            let density = T::constant(MARGIN) + at_distance / distance;
            length = length.min(most / density);
            let end = if start + length < longest { start + length } else { longest };
            let rule = if is_simple {
                Rule::for_folds(density * (end - start) + T::constant(ADDED_FOLDS))
            } else {
                Rule::FINEST
            };
            let (increment, is_resolved) =
                self.increment_of_panel(rule, Substitution::between((start, end), distance));
            if is_resolved || length <= shortest || halvings >= MOST_HALVINGS {
                sum = sum.plus(increment);
                start = end;
                length += length;
                if !is_resolved {
                    shortest += shortest;
                }
            } else if is_simple {
                is_simple = false;
            } else {
                length *= T::constant(0.5);
                halvings += 1;
            }
        }
        sum
    }

    /// The increment by a rule over the panel of a substitution, and whether the rule resolves the radius.
    fn increment_of_panel(&self, rule: &Rule, substitution: Substitution<T>) -> (Increment<T>, bool) {
        let nodes = ..rule.len();
        let [mut load_integrals, mut weights, mut radii] = [PerNode::zero(); 3];
        let (load_integrals, weights) = (&mut load_integrals.0[nodes], &mut weights.0[nodes]);
        let radii = &mut radii.0[nodes];
        half_wide(
            #[inline(always)]
            || self.fill(rule, substitution, load_integrals, weights),
        );
        self.find_radii(load_integrals, radii);
        half_wide(
            #[inline(always)]
            || {
                let increment = Increment::over_time(radii, weights, self.low);
                // No rule resolves what radii are off by.
                let counts = (-substitution.start).exp() / self.condition;
                (increment, rule.resolves_values(radii, counts))
            },
        )
    }

    /// The load integrals at the nodes, and the weights 2 e^(−x) dD/(π m/4), which an [`Increment`] takes for its
    /// integrands.
    #[inline(always)]
    fn fill(&self, rule: &Rule, substitution: Substitution<T>, load_integrals: &mut [T], weights: &mut [T]) {
        // Copies, which cannot alias what is written: otherwise they would be read again for every node.
        let (shortfall, final_integral) = (self.shortfall, self.final_integral);
        let integral_per_load = self.contact.integral_per_load();
        let doubled = integral_per_load + integral_per_load;
        for ((load_integral, weight), (x, dx)) in
            load_integrals.iter_mut().zip(weights).zip(substitution.nodes(rule))
        {
            let (deficit, rate) = shortfall(x);
            *load_integral = final_integral - deficit * integral_per_load;
            *weight = dx * doubled * rate * decay(x);
        }
    }

    /// The radii of load integrals, not below `low`.
    fn find_radii(&self, load_integrals: &[T], radii: &mut [T]) {
        if self.contact.radii_of(load_integrals, radii).is_err() {
            for (s, &load_integral) in radii.iter_mut().zip(load_integrals) {
                *s = self.contact.radius_of_integral(load_integral).unwrap_or(self.low);
            }
        }
        radii.iter_mut().for_each(|s| *s = greater(self.low, *s));
    }
}

/// Ages from `start` on, in the variable y that is proportional to √d − √(d − x + start), for a singularity at a
/// distance d from the start:
///
/// ```text
/// x = start + y (1 − y/(4 d)),  0 ≤ y ≤ last
/// ```
#[derive(Clone, Copy)]
struct Substitution<T> {
    start: T,
    last: T,
    /// 1/(4 d)
    bend: T,
}

impl<T: Scalar> Substitution<T> {
    fn between((start, end): (T, T), distance: T) -> Self {
        let (length, one, two) = (end - start, T::one(), T::constant(2.0));
        let last = two * length / (one + (one - length / distance).sqrt());
        Self { start, last, bend: (T::constant(4.0) * distance).recip() }
    }

    /// The nodes of a rule, ages with their weights.
    #[inline(always)]
    fn nodes(self, rule: &Rule) -> impl Iterator<Item = (T, T)> {
        rule.nodes(T::zero(), self.last).map(
            #[inline(always)]
            move |(y, dy)| {
                let bent = self.bend * y;
                (self.start + y * (T::one() - bent), dy * (T::one() - (bent + bent)))
            },
        )
    }
}
