//! The memory integrals over many short pieces of a load at once.
//!
//! A measured load has hundreds of pieces, during each of which little happens. For radii covered before they begin,
//! Eq. (28) integrated by parts over time reads
//!
//! ```text
//! (8/(π m)) ∫ Y′(τ) e^(−χ (end − τ)) {a² − low², 1, (a² − low²)²} / a⁴ dτ,    a = a(Y(τ))
//! ```
//!
//! Let v be the share of a piece that lies after a time in it. Then Y falls short of its final value by R v − B v²/2,
//! where R − B v is Y′ times the duration. The radii at all nodes of a batch of pieces are solved for together, in a
//! fraction of the time that one after the other takes, and summed; nothing else is done for each piece. A step is a
//! piece that takes no time.
//!
//! **Steps that only derivatives show** may lie between any two pieces, told or not: a force of equal value may have
//! other derivatives. Where numbers carry some, there is a node more for each piece, half-way up the step before it:
//! that is exact to second order in the step, and so in derivatives.
//!
//! **Which rule** is long enough for a piece: [`rule`].
//!
//! **Where w = a⁻⁴ has a singularity of its own**, which is where δ₀′ vanishes in the plane of complex radii, the radii
//! themselves show that the rule is too short. Such pieces are left to the other forms.

mod rule;

use super::Increment;
use super::radii_below::replace_drops_by_radii;
use crate::contact::Contact;
use crate::dispatch::wide_without_derivatives;
use crate::load::{Load, MOST_PIECES, Piece};
use crate::numbers::compensated_sum::CompensatedSum;
use crate::numbers::exponential::decay;
use crate::quadrature::Rule;
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};
use rule::{Growth, RULES, ShortRule};

/// The most nodes of all pieces, six for each of the most pieces. Records whose pieces need more are rare, and take up to
/// a third more time with a third fewer.
const MOST_NODES_OF_BATCH: usize = 6 * MOST_PIECES;

/// The most nodes of a step: one that takes more costs less over the radius.
const fn most_nodes_of_step(has_quick_radii: bool) -> usize {
    if has_quick_radii { 8 } else { 6 }
}

/// By how many e-foldings less a piece counts as faded where derivatives do: of a rule with n nodes those of second order
/// are off by up to (2n)² times as much as the value.
const OF_DERIVATIVES: f64 = 6.4;

/// The step of no height between a force and a piece that begins with it, and may have other derivatives.
#[inline(always)]
fn hidden_step<T: Scalar>(before: T, piece: &Piece<T>) -> T {
    if has_no_derivatives::<T>() { T::zero() } else { piece.start.1 - before }
}

/// How many nodes a piece has, with that of the hidden step before it.
#[inline(always)]
fn nodes_of_piece<T: Scalar>(rule: &Rule) -> usize {
    rule.len() + usize::from(!has_no_derivatives::<T>())
}

/// A number for every piece.
type PerPiece<T> = [T; MOST_PIECES];

/// Consecutive short pieces.
pub(super) struct Batch<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    count: usize,
    rule: &'static Rule,
    /// χ times the duration of each piece, and of all pieces after it.
    folds: PerPiece<T>,
    since_end: PerPiece<T>,
    /// The hereditary loads at the ends, and R and B of the module documentation.
    hereditary: PerPiece<T>,
    rates: PerPiece<T>,
    bends: PerPiece<T>,
    /// The steps before the pieces that only derivatives show.
    hidden_steps: PerPiece<T>,
    /// By how much the hereditary load grows in all.
    pub(super) gain: T,
    /// ∫F at the end.
    pub(super) impulse: CompensatedSum<T>,
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Batch<'a, T, P, L> {
    /// No pieces, after a history with an impulse.
    fn none(contact: &'a Contact<T, P, L>, impulse: CompensatedSum<T>) -> Self {
        let none = [T::zero(); MOST_PIECES];
        Self {
            contact,
            count: 0,
            rule: Rule::FOUR,
            folds: none,
            since_end: none,
            hereditary: none,
            rates: none,
            bends: none,
            hidden_steps: none,
            gain: T::zero(),
            impulse,
        }
    }

    /// The short ones among the first of `pieces`, before which the load had an impulse.
    ///
    /// `faded` is the least number of e-foldings by which what a piece lays down has faded when it counts.
    pub(super) fn of(
        contact: &'a Contact<T, P, L>,
        pieces: &[Piece<T>],
        impulse: CompensatedSum<T>,
        faded: impl Fn(&Piece<T>) -> T,
    ) -> Self {
        let (chi, has_quick_radii) = (contact.medium().chi(), contact.profile().has_quick_radii());
        let mut batch = Self::none(contact, impulse);
        // The logarithm of how much larger the rounding of T is than that of f64.
        let coarse = (T::default_epsilon() * T::constant(1.0 / f64::EPSILON)).ln();
        let coarse = if has_no_derivatives::<T>() { coarse } else { coarse - T::constant(OF_DERIVATIVES) };
        let mut rules = RULES.iter();
        let mut rule = rules.next();
        let mut force = pieces.first().map_or(T::zero(), |piece| piece.start.1);
        let begin = force + chi * impulse.value;
        for piece in pieces.iter().take(MOST_PIECES) {
            if piece.start.1 != force {
                break;
            }
            let growth = Growth::along(piece, chi);
            let hidden_step = hidden_step(force, piece);
            let gain = batch.gain + hidden_step + growth.in_all();
            let faded = coarse + faded(piece);
            while rule.is_some_and(|rule| !rule.suffices(&growth, begin + gain, faded)) {
                rule = rules.next();
            }
            let most =
                if piece.is_step() { most_nodes_of_step(has_quick_radii) } else { MOST_NODES_OF_BATCH };
            let Some(ShortRule { rule, .. }) = rule else { break };
            if rule.len() > most || nodes_of_piece::<T>(rule) * (batch.count + 1) > MOST_NODES_OF_BATCH {
                break;
            }
            batch.rule = rule;
            batch.push(&growth, hidden_step, begin + gain);
            batch.gain = gain;
            batch.impulse.add(piece.impulse());
            force = piece.end.1;
        }
        batch.set_times_since_ends(pieces.get(..batch.count).unwrap_or_default(), chi);
        batch
    }

    /// Takes one more piece, with the hidden step before it and the hereditary load at its end.
    fn push(&mut self, growth: &Growth<T>, hidden_step: T, hereditary: T) {
        let place = self.count;
        self.folds[place] = growth.folds;
        self.hereditary[place] = hereditary;
        self.rates[place] = growth.rate;
        self.bends[place] = growth.bend;
        self.hidden_steps[place] = hidden_step;
        self.count += 1;
    }

    /// Sets how many e-foldings before the end of the last piece each piece ends.
    fn set_times_since_ends(&mut self, pieces: &[Piece<T>], chi: T) {
        if let Some(last) = pieces.last() {
            for (since_end, piece) in self.since_end.iter_mut().zip(pieces) {
                *since_end = chi * (last.end.0 - piece.end.0);
            }
        }
    }

    /// How many pieces there are.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// What the batch adds to pressures at radii up to `low`, which are covered before it begins; none if the rule turns
    /// out to be too short, or radii are not found. The contact radius at the end of the batch is `edge`.
    ///
    /// Of what the batch has laid by its end, the share `remaining` is left at the time that counts.
    pub(super) fn increment(&self, (low, edge): (T, T), remaining: T) -> Option<Increment<T>> {
        let (contact, zero) = (self.contact, [T::zero(); MOST_NODES_OF_BATCH]);
        let (mut load_integrals, mut weights, mut radii) = (zero, zero, zero);
        let nodes = ..(self.count * nodes_of_piece::<T>(self.rule)).min(MOST_NODES_OF_BATCH);
        let (load_integrals, weights) = (&mut load_integrals[nodes], &mut weights[nodes]);
        let radii = &mut radii[nodes];
        wide_without_derivatives::<T, _>(
            #[inline(always)]
            || {
                // Until the radii are found, their places hold the ages.
                self.fill(load_integrals, weights, radii);
                load_integrals.iter_mut().for_each(|hereditary| *hereditary *= contact.integral_per_load());
            },
        );
        if !self.find_radii(edge, load_integrals, radii) {
            return None;
        }
        let are_positive = contact.profile().has_only_positive_terms();
        wide_without_derivatives::<T, _>(
            #[inline(always)]
            || {
                // The weights are forces.
                let factor = T::constant(2.0) * contact.integral_per_load();
                let increment = Increment::over_time(radii, weights, low).times(factor);
                self.is_resolved(radii, remaining, are_positive).then_some(increment)
            },
        )
    }

    /// The radii of load integrals of the batch; false if they are not found.
    fn find_radii(&self, edge: T, load_integrals: &[T], radii: &mut [T]) -> bool {
        let contact = self.contact;
        if contact.profile().has_quick_radii() || !has_no_derivatives::<T>() {
            return contact.radii_of(load_integrals, radii).is_ok();
        }
        let [.., last] = self.hereditary[..self.count] else { return false };
        let at_edge = last * contact.integral_per_load();
        for (radius, &load_integral) in radii.iter_mut().zip(load_integrals) {
            *radius = at_edge - load_integral;
        }
        replace_drops_by_radii(contact.profile(), edge, radii)
    }

    /// The hereditary loads at the nodes, one row of all pieces for each node of the rule, and the weights, which are
    /// what Y gains there and is left at the end. A last row has the hidden steps.
    #[inline(always)]
    fn fill(&self, hereditary: &mut [T], weights: &mut [T], ages: &mut [T]) {
        self.fill_rows(hereditary, weights, ages);
        for (weight, &age) in weights.iter_mut().zip(&*ages) {
            *weight *= decay(age);
        }
    }

    /// The hereditary loads at the nodes, what Y gains there, and how old that is at the end.
    #[inline(always)]
    fn fill_rows(&self, hereditary: &mut [T], weights: &mut [T], ages: &mut [T]) {
        let mut rows = self.rows_mut(hereditary).zip(self.rows_mut(weights)).zip(self.rows_mut(ages));
        let nodes = self.rule.nodes(T::zero(), T::one());
        for ((v, weight), ((hereditary, weights), ages)) in nodes.zip(&mut rows) {
            let half = v * T::constant(0.5);
            let growth = self.hereditary.iter().zip(&self.rates).zip(&self.bends);
            let places = hereditary.iter_mut().zip(weights);
            for ((hereditary, weights), ((&last, &rate), &bend)) in places.zip(growth) {
                *hereditary = last - v * (rate - bend * half);
                *weights = weight * (rate - bend * v);
            }
            for ((age, &since_end), &folds) in ages.iter_mut().zip(&self.since_end).zip(&self.folds) {
                *age = since_end + folds * v;
            }
        }
        if let Some(((hereditary, weights), ages)) = rows.next() {
            self.fill_hidden_steps(hereditary, weights, ages);
        }
    }

    /// The same half-way up the hidden steps, where the pieces begin.
    fn fill_hidden_steps(&self, hereditary: &mut [T], weights: &mut [T], ages: &mut [T]) {
        let half = T::constant(0.5);
        let places = hereditary.iter_mut().zip(weights).zip(ages);
        for (place, (((hereditary, weight), age), &step)) in places.zip(&self.hidden_steps).enumerate() {
            let growth = self.rates[place] - self.bends[place] * half;
            (*hereditary, *weight) = (self.hereditary[place] - growth - step * half, step);
            *age = self.since_end[place] + self.folds[place];
        }
    }

    /// The rows of numbers at all nodes.
    #[inline(always)]
    fn rows_mut<'v>(&self, values: &'v mut [T]) -> impl Iterator<Item = &'v mut [T]> {
        values.chunks_exact_mut(self.count.max(1))
    }

    /// Whether the rule resolves the radii at the nodes of every piece; of what is left at the end, the share
    /// `remaining` is left at the time that counts. With terms of both signs the last coefficient alone does not tell.
    #[inline(always)]
    fn is_resolved(&self, radii: &[T], remaining: T, are_positive: bool) -> bool {
        let none = [T::zero(); MOST_PIECES];
        let (mut first, mut highest, mut next) = (none, none, none);
        let count = self.count.clamp(1, MOST_PIECES);
        let pairs = || radii.chunks_exact(2 * count).map(|pair| pair.split_at(count));
        for ((later, earlier), [to_first, to_highest, _]) in pairs().zip(self.rule.coefficients::<T>()) {
            let sums = first.iter_mut().zip(&mut highest);
            for ((first, highest), (&later, &earlier)) in sums.zip(later.iter().zip(earlier)) {
                let odd = earlier - later;
                *first += to_first * odd;
                *highest += to_highest * odd;
            }
        }
        let all = |coefficients: &PerPiece<T>, is_resolved: fn(&Rule, T, T, T) -> bool| {
            let sums = first.iter().zip(coefficients).zip(&self.since_end);
            sums.zip(radii).fold(true, |all, (((&first, &coefficient), &since_end), &size)| {
                all & is_resolved(self.rule, first / size, coefficient / size, remaining * decay(since_end))
            })
        };
        let are_resolved = all(&highest, Rule::resolves);
        if are_positive || !are_resolved {
            return are_resolved;
        }
        for ((later, earlier), [_, _, to_next]) in pairs().zip(self.rule.coefficients::<T>()) {
            for (next, (&later, &earlier)) in next.iter_mut().zip(later.iter().zip(earlier)) {
                *next += to_next * (earlier + later);
            }
        }
        all(&next, Rule::resolves_by_next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::PiecewiseLinear;
    use crate::worse::worse;
    use crate::{Medium, Polynomial};

    type Joint<T> = Contact<T, Polynomial<T, Vec<(T, T)>>, PiecewiseLinear<T, Vec<(T, T)>>>;

    /// A load that rises along a line up to 320 s and is held, with knots on the line that change nothing.
    fn joint<T: Scalar>(terms: &[(f64, f64)], chi: f64, knots: u32) -> Option<Joint<T>> {
        let times = (0..=knots).map(|k| 320.0 * f64::from(k) / f64::from(knots));
        let load =
            PiecewiseLinear::new(times.map(|t| (T::constant(t), T::constant(50.0 + t / 4.0))).collect());
        let gap = terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))).collect::<Vec<_>>();
        let medium = Medium::from_constants(T::constant(0.375), T::constant(chi));
        Contact::new(Polynomial::new(gap).ok()?, medium.ok()?, load.ok()?).ok()
    }

    /// The largest error, over the share by which the rounding of the radius moves the edge.
    fn difference<T: Scalar>(terms: &[(f64, f64)], chi: f64, knots: u32) -> Option<f64> {
        let (one, many) = (joint::<T>(terms, chi, 1)?, joint::<T>(terms, chi, knots)?);
        let mut largest = 0.0_f64;
        for t in [7.0, 20.0, 101.0, 320.0, 400.0].map(T::constant) {
            let (one, many) = (one.at(t).ok()?, many.at(t).ok()?);
            for share in [0.0, 0.3, 0.7, 0.95, 0.999] {
                let r = one.radius() * T::constant(share);
                let (expected, found) = (one.pressure(r), many.pressure(r));
                let error = ((found - expected) / expected / T::default_epsilon()).value().abs();
                largest = worse(largest, error / (1.0 + 2.0 / (1.0 - share)));
            }
        }
        Some(largest)
    }

    #[test]
    fn knots_that_change_nothing_change_no_pressure() {
        for terms in [&[(0.025, 2.0)][..], &[(0.025, 2.0), (1.09375e-4, 4.0)], &[(0.01, 0.75), (1e-3, 2.6)]] {
            for chi in [1e-6, 1.5e-3, 0.02, 0.3] {
                for knots in [5, 20, 80, 320] {
                    for error in [difference::<f64>(terms, chi, knots), difference::<f32>(terms, chi, knots)]
                    {
                        assert!(error.is_some_and(|e| e < 3.0), "{terms:?}, {chi}, {knots} knots: {error:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_slope_that_nearly_vanishes_is_noticed() {
        // δ₀′ = s (1 − 2 (s/7) + (1 + 1e-6) (s/7)²), and the radius passes 7 mm.
        let terms = [(1.0, 2.0), (-5.0 / 21.0, 3.0), (0.75 * 1.000_001 / 49.0, 4.0)];
        for knots in [5, 20, 80, 320] {
            // There the terms of J cancel to 1/97, which multiplies rounding.
            let error = difference::<f64>(&terms, 1.5e-3, knots);
            assert!(error.is_some_and(|e| e < 97.0), "{knots} knots: {error:?}");
        }
    }
}
