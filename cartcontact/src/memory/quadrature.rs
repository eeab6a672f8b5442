//! Gauss-Legendre rules, and which of them an integrand needs.
//!
//! Let f be analytic within the ellipse whose foci are the ends of an interval and whose half-axes add up to ρ
//! half-lengths R of it, and |f| ≤ M there. Then the rule of n nodes is off by at most
//!
//! ```text
//! (64/15) R M ρ^(−2n) / (1 − ρ^(−2))
//! ```
//!
//! (L. N. Trefethen, Approximation Theory and Approximation Practice, SIAM 2013, Theorem 19.3). Memory
//! integrands are sums of powers times a fading: positive, largest at the end of the interval that is the edge
//! of the contact, and in the ellipse largest on the axis beyond it. If M = f(edge) e^G there, and f falls by w
//! e-foldings from the edge inwards, the integral is about 2 R f(edge)/(2 + w), and n nodes leave less than the
//! wanted share of it if
//!
//! ```text
//! 2 n ln ρ ≥ T + G
//! ```
//!
//! [`Continuation`] is G with the room that ρ may take; [`digits`] is T.
//!
//! For gaps with negative terms M may exceed its value on the axis; the bound is then an estimate, and the
//! quarter of a roundoff in T its reserve.

use crate::Scalar;
use crate::evaluate::binary::split;

/// Values at eight nodes: what is done to them side by side becomes vector instructions.
pub(crate) type Eight<T> = [T; 8];

/// A rule on [0, 1]: its nodes with their weights, in eights.
///
/// They are 40-digit values from the Legendre roots, rounded to f64: error 1/2 ulp, also of the nodes next to 0.
/// The end at 0 is where integrands are largest and least forgiving.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rule {
    nodes: &'static [(Eight<f64>, Eight<f64>)],
}

/// The rules of 8, 16 and 24 nodes.
const RULES: [Rule; 3] = [Rule { nodes: &NODES_8 }, Rule { nodes: &NODES_16 }, Rule::FINEST];

impl Rule {
    /// The rule of 24 nodes.
    pub(crate) const FINEST: Self = Self { nodes: &NODES_24 };
    const MOST_NODES: f64 = 24.0;

    /// The nodes on [low, high] with their weights, in eights.
    pub(crate) fn on<T: Scalar>(self, low: T, high: T) -> impl Iterator<Item = (Eight<T>, Eight<T>)> {
        let length = high - low;
        self.nodes.iter().map(move |(nodes, weights)| {
            (
                core::array::from_fn(|i| low + length * T::constant(nodes[i])),
                core::array::from_fn(|i| length * T::constant(weights[i])),
            )
        })
    }

    /// The nodes on [low, high] with their weights, one by one.
    pub(crate) fn nodes<T: Scalar>(self, low: T, high: T) -> impl Iterator<Item = (T, T)> {
        self.on(low, high).flat_map(|(nodes, weights)| nodes.into_iter().zip(weights))
    }
}

/// How far an integrand may be continued beyond the edge, and around the interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Continuation<T> {
    /// A distance beyond the edge, within which the integrand grows by at most e^`growth`.
    pub(crate) extension: T,
    pub(crate) growth: T,
    /// How far from every point of the interval there is no singularity.
    pub(crate) clearance: T,
}

impl<T: Scalar> Continuation<T> {
    /// The shortest rule that loses no more than e^(−`digits`) on an interval, if there is one.
    ///
    /// An ellipse that reaches x half-lengths beyond the foci has x = cosh ln ρ − 1, one that is y half-lengths
    /// high has y = sinh ln ρ.
    pub(crate) fn rule(&self, length: T, digits: T) -> Option<Rule> {
        let (one, two) = (T::one(), T::constant(2.0));
        let per_half = two / length;
        let (x, y) = (self.extension * per_half, self.clearance * per_half);
        let beyond = x + one + (x * (x + two)).sqrt();
        let around = y + (y * y + one).sqrt();
        let (needed, per_node) = (digits + self.growth, two * logarithm_from_below(beyond.min(around)));
        RULES.into_iter().find(|rule| needed <= per_node * T::constant(8.0 * rule.nodes.len() as f64))
    }

    /// The longest interval for the finest rule.
    pub(crate) fn longest(&self, digits: T) -> T {
        let two = T::constant(2.0);
        let rho = ((digits + self.growth) * T::constant(0.5 / Rule::MOST_NODES)).exp();
        let inverse = rho.recip();
        let half_lengths = (self.extension / (rho + inverse - two)).min(self.clearance / (rho - inverse));
        T::constant(4.0) * half_lengths
    }
}

/// T: how many e-foldings below the value at the edge the error of a rule must stay.
///
/// Its share of the integral is to be a quarter of a roundoff, ln(4/ε) = 37.4 in f64 and 17.3 in f32. That of a
/// factor s² − low² grows by 1 + x at most where the ellipse reaches x lengths beyond the edge, so that
/// ln((32/15)(2 + w)(1 + x)) is to be added, which is near 4.6 for every w from 1 to 40.
pub(crate) fn digits<T: Scalar>() -> T {
    let single = T::default_epsilon() > T::constant(1e-10);
    T::constant(if single { 21.9 } else { 42.0 })
}

/// ln x less at most 0.06, because the logarithm lies above its chords: log₂ f ≥ f − 1 for 1 ≤ f < 2.
pub(crate) fn logarithm_from_below<T: Scalar>(x: T) -> T {
    let (fraction, exponent) = split(x);
    (T::constant(f64::from(exponent)) + (fraction - T::one())) * T::ln_2()
}

/// The rule of 4 nodes on [−1, 1], exact for polynomials up to degree 7: its positive half.
pub(crate) const NODES_4: [(f64, f64); 2] =
    [(0.33998104358485626, 0.6521451548625461), (0.8611363115940526, 0.34785484513745385)];

const NODES_8: [(Eight<f64>, Eight<f64>); 1] = [(
    [
        0.019855071751231884,
        0.10166676129318664,
        0.2372337950418355,
        0.4082826787521751,
        0.591717321247825,
        0.7627662049581645,
        0.8983332387068134,
        0.9801449282487681,
    ],
    [
        0.05061426814518813,
        0.11119051722668724,
        0.15685332293894363,
        0.181341891689181,
        0.181341891689181,
        0.15685332293894363,
        0.11119051722668724,
        0.05061426814518813,
    ],
)];
const NODES_16: [(Eight<f64>, Eight<f64>); 2] = [
    (
        [
            0.005299532504175033,
            0.02771248846338371,
            0.06718439880608412,
            0.12229779582249849,
            0.19106187779867811,
            0.2709916111713863,
            0.35919822461037054,
            0.4524937450811813,
        ],
        [
            0.013576229705877048,
            0.031126761969323947,
            0.04757925584124639,
            0.06231448562776694,
            0.07479799440828837,
            0.08457825969750127,
            0.09130170752246179,
            0.09472530522753425,
        ],
    ),
    (
        [
            0.5475062549188188,
            0.6408017753896295,
            0.7290083888286137,
            0.8089381222013219,
            0.8777022041775016,
            0.9328156011939158,
            0.9722875115366163,
            0.994700467495825,
        ],
        [
            0.09472530522753425,
            0.09130170752246179,
            0.08457825969750127,
            0.07479799440828837,
            0.06231448562776694,
            0.04757925584124639,
            0.031126761969323947,
            0.013576229705877048,
        ],
    ),
];
const NODES_24: [(Eight<f64>, Eight<f64>); 3] = [
    (
        [
            0.00240639000148932,
            0.012635722014345251,
            0.030862723998633622,
            0.056792236497799485,
            0.08999900701304854,
            0.12993790421072282,
            0.17595317403151223,
            0.22728926430558022,
        ],
        [
            0.0061706148999936,
            0.014265694314466832,
            0.022138719408709904,
            0.02964929245771839,
            0.03667324070554015,
            0.04309508076597664,
            0.04880932605205694,
            0.05372213505798282,
        ],
    ),
    (
        [
            0.2831032461869774,
            0.3424786601519183,
            0.40444056626319186,
            0.4679715535686972,
            0.5320284464313028,
            0.5955594337368082,
            0.6575213398480817,
            0.7168967538130225,
        ],
        [
            0.0577528340268628,
            0.060835236463901696,
            0.06291872817341415,
            0.06396909767337608,
            0.06396909767337608,
            0.06291872817341415,
            0.060835236463901696,
            0.0577528340268628,
        ],
    ),
    (
        [
            0.7727107356944197,
            0.8240468259684878,
            0.8700620957892772,
            0.9100009929869515,
            0.9432077635022005,
            0.9691372760013663,
            0.9873642779856547,
            0.9975936099985107,
        ],
        [
            0.05372213505798282,
            0.04880932605205694,
            0.04309508076597664,
            0.03667324070554015,
            0.02964929245771839,
            0.022138719408709904,
            0.014265694314466832,
            0.0061706148999936,
        ],
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_for_polynomials() {
        for rule in RULES {
            let n = 8 * rule.nodes.len();
            for degree in 0..2 * n as i32 {
                let integral =
                    rule.nodes(0.0, 1.0).fold(0.0, |sum, (x, w): (f64, f64)| sum + w * x.powi(degree));
                let error = integral * f64::from(degree + 1) - 1.0;
                // The power multiplies the rounding of the nodes by the degree.
                let bound = (4.0 + 0.5 * f64::from(degree)) * f64::EPSILON;
                assert!(error.abs() < bound, "{n} nodes, degree {degree}: {error:e}");
            }
        }
    }

    /// ∫₀¹ e^(−folds x) dx, an integrand that grows by e^14 within 14/folds beyond its edge.
    #[test]
    fn rules_hold_what_their_bound_promises() {
        for k in 0..200 {
            let folds = 0.02 * 1.04_f64.powi(k);
            let continuation =
                Continuation { extension: 14.0 / folds, growth: 14.0, clearance: f64::INFINITY };
            let length = continuation.longest(digits()).min(1.0);
            let rule = continuation.rule(length, digits()).unwrap_or(Rule::FINEST);
            let integral = rule.nodes(0.0, length).fold(0.0, |sum, (x, w)| sum + w * (-folds * x).exp());
            let error = integral * folds / -(-folds * length).exp_m1() - 1.0;
            assert!(error.abs() < 8.0 * f64::EPSILON, "{folds} folds: {error:e}");
        }
    }

    #[test]
    fn the_chord_lies_below_the_logarithm() {
        for k in -400..400 {
            let x = 1.0123_f64.powi(k);
            let defect = x.ln() - logarithm_from_below(x);
            assert!((-1e-15..0.06).contains(&defect), "{x}: {defect}");
        }
    }
}
