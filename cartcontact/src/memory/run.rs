//! The memory integrals over many short pieces of a load at once.
//!
//! A measured load has hundreds of pieces, during each of which little happens. For radii covered before they begin, Eq.
//! (28) integrated by parts over time reads
//!
//! ```text
//! (8/(π m)) ∫ Y′(τ) e^(−χ (end − τ)) {a² − low², 1} / a⁴ dτ,    a = a(Y(τ))
//! ```
//!
//! With v the share of a piece that lies behind a time in it, Y falls short of its final value by R v − B v²/2, where
//! R − B v is Y′ times the duration. All nodes of a run of pieces are solved for their radii together, which takes
//! a fraction of the time of one radius after the other, and summed; nothing else is done for each piece.
//!
//! **Which rule.** e^(−χ age) changes by the piece's e-foldings. w(Y) = a⁻⁴ is nearly a power of Y; its singularity
//! is where Y, continued, is zero, further away than the root of |R| v + |B| v²/2 = Y. For every rule [`RULES`] holds
//! the most e-foldings and the least distance of which it makes an error of ε/4 alone, in Y′ w e^(−χ age) with any
//! w between Y^(−4/4.25) and Y^(−4/68) and any Y′, also one that vanishes at an end. What has faded by e^(−x) since
//! may have an error of e^x times that.
//!
//! **Where w has another singularity**, which is where δ₀′ vanishes in the plane of complex radii, the radii show it:
//! their highest Legendre coefficient that a rule of n nodes can see, of degree n − 1, is then not small enough for the
//! geometric fall from degree 1 on to reach rounding before degree 2 n. Such pieces are left to the other forms.

use super::Increment;
use super::fading::{FEW_FOLDS, decay_gain};
use super::quadrature::{NODES_4, NODES_6, NODES_8, NODES_10, NODES_12};
use crate::contact::Contact;
use crate::dispatch::wide;
use crate::load::{Load, Piece};
use crate::{GapProfile, Scalar};

/// The most pieces in a run. They lie beside each other, one to a lane of a vector.
const LANES: usize = 8;
/// The most nodes in a piece.
const ROWS: usize = 12;

/// A number for every piece.
type Lanes<T> = [T; LANES];

/// A Gauss-Legendre rule, and the pieces that are short enough for it.
#[derive(Clone, Copy, Debug)]
struct ShortRule {
    /// Its positive nodes on [−1, 1] with their weights.
    half: &'static [(f64, f64)],
    /// The factors of the Legendre coefficient of degree n − 1.
    highest: &'static [f64],
    folds: f64,
    distance: f64,
}

const RULES: [ShortRule; 5] = [
    ShortRule { half: &NODES_4, highest: &highest(NODES_4), folds: 0.067, distance: 75.0 },
    ShortRule { half: &NODES_6, highest: &highest(NODES_6), folds: 0.66, distance: 6.8 },
    ShortRule { half: &NODES_8, highest: &highest(NODES_8), folds: 2.1, distance: 2.5 },
    ShortRule { half: &NODES_10, highest: &highest(NODES_10), folds: 4.4, distance: 1.3 },
    ShortRule { half: &NODES_12, highest: &highest(NODES_12), folds: 7.6, distance: 0.82 },
];

/// (2n−1)/2 w P₍ₙ₋₁₎(x) at the positive nodes x of a rule of n nodes.
const fn highest<const HALF: usize>(half: [(f64, f64); HALF]) -> [f64; HALF] {
    let n = 2 * HALF;
    let mut factors = [0.0; HALF];
    let mut index = 0;
    while index < HALF {
        let (x, weight) = half[index];
        // (k+1) P₍ₖ₊₁₎ = (2k+1) x Pₖ − k P₍ₖ₋₁₎
        let (mut before, mut legendre) = (1.0, x);
        let mut k = 1;
        while k < n - 1 {
            let degree = k as f64;
            let next = ((2.0 * degree + 1.0) * x * legendre - degree * before) / (degree + 1.0);
            (before, legendre) = (legendre, next);
            k += 1;
        }
        factors[index] = (n as f64 - 0.5) * weight * legendre;
        index += 1;
    }
    factors
}

impl ShortRule {
    fn rows(&self) -> usize {
        2 * self.half.len()
    }

    /// The shares of a piece that lie behind the nodes, the later of every two first, with the weights.
    #[inline(always)]
    fn nodes<T: Scalar>(&self) -> impl Iterator<Item = (T, T)> {
        self.half.iter().flat_map(|&(node, weight)| {
            [0.5 - 0.5 * node, 0.5 + 0.5 * node].map(|share| (T::constant(share), T::constant(0.5 * weight)))
        })
    }
}

/// Short pieces one after the other, without a step between them; places that are left over are as long as nothing.
pub(super) struct Run<T> {
    count: usize,
    rule: &'static ShortRule,
    /// χ times the durations, and times what follows in all.
    folds: Lanes<T>,
    since_end: Lanes<T>,
    /// The hereditary loads at the ends, R and B of the module documentation.
    hereditary: Lanes<T>,
    rates: Lanes<T>,
    bends: Lanes<T>,
    /// By how much the hereditary load grows in all.
    pub(super) gain: T,
    /// ∫F at the end.
    pub(super) impulse: T,
}

impl<T: Scalar> Run<T> {
    /// The first of `pieces`, before which the load had an impulse, as many as are short.
    ///
    /// `faded` says by how many e-foldings what a piece lays down has faded at least when it counts.
    pub(super) fn of(pieces: &[Piece<T>], chi: T, impulse: T, faded: impl Fn(&Piece<T>) -> T) -> Self {
        let none = [T::zero(); LANES];
        let mut run = Self {
            count: 0,
            rule: &RULES[0],
            folds: none,
            since_end: none,
            hereditary: none,
            rates: none,
            bends: none,
            gain: T::zero(),
            impulse,
        };
        // By how much the rounding of T is larger than that of f64.
        let coarse = (T::default_epsilon() * T::constant(1.0 / f64::EPSILON)).ln();
        let mut rules = RULES.iter();
        let mut rule = rules.next();
        let mut force = pieces.first().map_or(T::zero(), |piece| piece.start.1);
        for piece in pieces.iter().take(LANES) {
            let folds = chi * piece.duration();
            let bend = folds * piece.rise();
            // A load that falls as fast as it may has Y′ = 0, which rounding can make negative.
            let rate = (piece.rise() + folds * piece.end.1).max(T::zero());
            let impulse = run.impulse + piece.impulse();
            let hereditary = piece.end.1 + chi * impulse;
            while rule
                .is_some_and(|rule| !rule.suffices(folds, (hereditary, rate, bend), coarse + faded(piece)))
            {
                rule = rules.next();
            }
            let Some(rule) = rule else { break };
            if piece.start.1 != force {
                break;
            }
            let place = run.count;
            run.rule = rule;
            run.folds[place] = folds;
            run.hereditary[place..].fill(hereditary);
            run.rates[place] = rate;
            run.bends[place] = bend;
            run.gain += rate - bend * T::constant(0.5);
            run.impulse = impulse;
            run.count += 1;
            force = piece.end.1;
        }
        let pieces = &pieces[..run.count];
        if let Some(last) = pieces.last() {
            for (since_end, piece) in run.since_end.iter_mut().zip(pieces) {
                *since_end = chi * (last.end.0 - piece.end.0);
            }
        }
        run
    }

    /// How many pieces there are.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// What the run adds to pressures at radii up to `low`, which are covered before it begins; none if the rule turns
    /// out to be too short.
    ///
    /// `share` is what is left at the time that counts of what is there at the end.
    pub(super) fn increment<P, L>(&self, contact: &Contact<T, P, L>, low: T, share: T) -> Option<Increment<T>>
    where
        P: GapProfile<T>,
        L: Load<T>,
    {
        let last = self.count.checked_sub(1)?;
        let zero = [[T::zero(); LANES]; ROWS];
        let (mut hereditary, mut weights, mut fading, mut radii) = (zero, zero, zero, zero);
        let rows = self.rule.rows();
        let (hereditary, weights) = (&mut hereditary[..rows], &mut weights[..rows]);
        let (fading, radii) = (&mut fading[..rows], &mut radii[..rows]);
        wide(
            #[inline(always)]
            || self.fill(hereditary, weights, fading),
        );
        contact.radii_under(hereditary.as_flattened_mut(), radii.as_flattened_mut()).ok()?;
        self.fade(self.since_end[0] + self.folds[0], fading);
        let share = share * fading[0][last];
        wide(
            #[inline(always)]
            || {
                let offsets = hereditary;
                let sums = offsets.as_flattened_mut().iter_mut().zip(weights.as_flattened_mut());
                let nodes = fading.as_flattened().iter().zip(radii.as_flattened());
                for ((offset, weight), (&fading, &a)) in sums.zip(nodes) {
                    let square = a * a;
                    *weight = *weight * fading / (square * square);
                    *offset = *weight * ((a - low) * (a + low));
                }
                let factor = T::constant(2.0) * contact.per_stiffness();
                let increment = Increment { offset: factor * sum(offsets), slope: factor * sum(weights) };
                self.is_resolved(radii, share).then_some(increment)
            },
        )
    }

    /// The hereditary loads at the nodes, the weights of what grows there, and the ages.
    #[inline(always)]
    fn fill(&self, hereditary: &mut [Lanes<T>], weights: &mut [Lanes<T>], ages: &mut [Lanes<T>]) {
        let Self { folds, since_end, hereditary: final_loads, rates, bends, .. } = *self;
        let rows = hereditary.iter_mut().zip(weights).zip(ages);
        for (((hereditary, weights), ages), (v, weight)) in rows.zip(self.rule.nodes::<T>()) {
            let half = v * T::constant(0.5);
            *hereditary = each(|lane| final_loads[lane] - v * (rates[lane] - bends[lane] * half));
            *weights = each(|lane| weight * (rates[lane] - bends[lane] * v));
            *ages = each(|lane| since_end[lane] + folds[lane] * v);
        }
    }

    /// Replaces the ages of the nodes, up to `oldest`, by e^(−age).
    fn fade(&self, oldest: T, ages: &mut [Lanes<T>]) {
        if oldest <= T::constant(FEW_FOLDS) {
            wide(
                #[inline(always)]
                || ages.as_flattened_mut().iter_mut().for_each(|age| *age = T::one() + decay_gain(*age)),
            );
        } else {
            let ages = ages.iter_mut().flat_map(|row| &mut row[..self.count]);
            ages.for_each(|age| *age = (-*age).exp());
        }
    }

    /// Whether the radii at the nodes of every piece fall fast enough, with their highest coefficient over the first
    /// h/g and over the radius h: geometrically, h (h/g)^(3/2) is more than that of degree 2 n.
    #[inline(always)]
    fn is_resolved(&self, radii: &[Lanes<T>], share: T) -> bool {
        let (mut first, mut highest) = ([T::zero(); LANES], [T::zero(); LANES]);
        let factors = self.rule.half.iter().zip(self.rule.highest);
        for (pair, (&(node, weight), &factor)) in radii.chunks_exact(2).zip(factors) {
            let (to_first, to_highest) = (T::constant(1.5 * node * weight), T::constant(factor));
            let odd: Lanes<T> = each(|lane| pair[0][lane] - pair[1][lane]);
            first = each(|lane| first[lane] + to_first * odd[lane]);
            highest = each(|lane| highest[lane] + to_highest * odd[lane]);
        }
        let epsilon = T::default_epsilon();
        let (rounding, most) = (T::constant(4.0) * epsilon, epsilon * epsilon * T::constant(1.0 / 64.0));
        // Only what is above rounding says anything.
        let error: Lanes<T> = each(|lane| share * (highest[lane] / radii[0][lane]).abs());
        let ratio: Lanes<T> = each(|lane| (highest[lane] / first[lane]).abs());
        let bound: Lanes<T> =
            each(|lane| error[lane] * error[lane] * (ratio[lane] * ratio[lane] * ratio[lane]));
        (0..LANES).fold(true, |all, lane| all & ((error[lane] <= rounding) | (bound[lane] <= most)))
    }
}

#[inline(always)]
fn each<T>(value: impl Fn(usize) -> T) -> Lanes<T> {
    core::array::from_fn(value)
}

/// The sum of all, lane by lane first.
#[inline(always)]
fn sum<T: Scalar>(rows: &[Lanes<T>]) -> T {
    let lanes = rows.iter().fold([T::zero(); LANES], |sum, row| each(|lane| sum[lane] + row[lane]));
    lanes.into_iter().fold(T::zero(), |sum, x| sum + x)
}

impl ShortRule {
    /// Whether the rule is long enough for a piece of some e-foldings and of which e^(−faded) is left, with Y, R and B.
    fn suffices<T: Scalar>(&self, folds: T, (hereditary, rate, bend): (T, T, T), faded: T) -> bool {
        // e^(faded/(2n+1)), or a little less.
        let root = T::one() + faded * T::constant(0.25 / (2 * self.rows() + 1) as f64);
        let square = root * root;
        let of_distance = (square * square - folds * T::constant(self.folds.recip())).max(T::zero());
        // |R| v + |B| v²/2 = Y at v = 2/(r + √(r² + 2 b)), with r = R/Y and b = |B|/Y.
        let two = T::constant(2.0);
        let (rate, bend) = (rate / hereditary, bend.abs() / hereditary);
        let sum = rate + (rate * rate + two * bend).sqrt();
        (two - sum).max(T::zero()) * of_distance >= T::constant(self.distance) * sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::PiecewiseLinear;
    use crate::{Medium, Polynomial};

    #[test]
    fn factors_give_the_coefficient_of_the_highest_degree() {
        for rule in RULES {
            let n = rule.rows();
            for degree in (1..n).step_by(2) {
                let legendre = |x: f64| {
                    (1..degree).fold((1.0, x), |(before, now), k| {
                        let k = k as f64;
                        (now, ((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0))
                    })
                };
                let nodes = rule.half.iter().zip(rule.highest);
                // An odd function has the same at both nodes of a pair.
                let found: f64 = nodes.map(|(&(x, _), factor)| factor * legendre(x).1).sum::<f64>() * 2.0;
                let expected = if degree == n - 1 { 1.0 } else { 0.0 };
                assert!((found - expected).abs() < 1e-14, "{n} nodes, degree {degree}: {found}");
            }
        }
    }

    type Load<T> = PiecewiseLinear<T, Vec<(T, T)>>;
    type Joint<T> = Contact<T, Polynomial<T, Vec<(T, T)>>, Load<T>>;

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
                largest = largest.max(error / (1.0 + 2.0 / (1.0 - share)));
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
            // The terms of J cancel to one in 97 there, which multiplies what is rounded.
            let error = difference::<f64>(&terms, 1.5e-3, knots);
            assert!(error.is_some_and(|e| e < 97.0), "{knots} knots: {error:?}");
        }
    }
}
