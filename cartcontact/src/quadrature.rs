//! Gauss-Legendre rules, and which of them an integrand needs.
//!
//! On e^(c x), |x| ≤ 1, the rule of n nodes leaves the relative error
//!
//! ```text
//! 2^(2n+1) (n!)⁴ / ((2n+1) ((2n)!)³) · c^(2n+1) e^c / (2 sinh c)
//! ```
//!
//! (Abramowitz & Stegun 25.4.30 with the largest derivative). Memory integrands are positive sums of powers times an
//! exponential of one. The number of e-foldings by which they change over the interval, 2 c, bounds their logarithmic
//! slope and takes the place of 2 c here. `folds` below is where the error reaches ε/4 of f64 or f32, to four digits.

use crate::Scalar;
use crate::numbers::tabled::Tabled;
use crate::scalar::{from_single, is_single};

/// The most nodes of a rule.
pub(crate) const MOST_NODES: usize = 24;

/// A symmetric rule on [−1, 1].
#[derive(Debug)]
pub(crate) struct Rule {
    count: usize,
    double: Tables<f64>,
    /// The same in single precision: conversions are slow on microcontrollers.
    single: Tables<f32>,
}

/// The numbers of a rule, in one format.
#[derive(Debug)]
struct Tables<F> {
    /// Pair by pair from the middle outwards, the negative one first.
    nodes: [F; MOST_NODES],
    weights: [F; MOST_NODES],
    /// 3/2 w x at the positive node of each pair.
    first: [F; MOST_NODES / 2],
    /// (2n−1)/2 w P₍ₙ₋₁₎ there.
    highest: [F; MOST_NODES / 2],
    /// (2n−3)/2 w P₍ₙ₋₂₎ there.
    next: [F; MOST_NODES / 2],
    /// The most e-foldings it integrates to full accuracy in that format.
    folds: F,
}

impl<F: Copy> Tables<F> {
    const fn empty(zero: F, folds: F) -> Self {
        let (nodes, pairs) = ([zero; MOST_NODES], [zero; MOST_NODES / 2]);
        Self { nodes, weights: nodes, first: pairs, highest: pairs, next: pairs, folds }
    }
}

/// The rules to choose from. Their nodes fill vectors of four numbers, so that fewer would take as long.
const RULES: [&Rule; 4] = [Rule::EIGHT, Rule::TWELVE, Rule::SIXTEEN, Rule::FINEST];

impl Rule {
    pub(crate) const FOUR: &'static Self = &Self::of(NODES_4, (0.1321, 1.512));
    pub(crate) const SIX: &'static Self = &Self::of(NODES_6, (0.8733, 4.269));
    pub(crate) const EIGHT: &'static Self = &Self::of(NODES_8, (2.403, 7.884));
    pub(crate) const TEN: &'static Self = &Self::of(NODES_10, (4.632, 12.07));
    pub(crate) const TWELVE: &'static Self = &Self::of(NODES_12, (7.447, 16.64));
    pub(crate) const SIXTEEN: &'static Self = &Self::of(NODES_16, (14.42, 26.51));
    /// The rule of 24 nodes.
    pub(crate) const FINEST: &'static Self = &Self::of(NODES_24, (31.69, 47.76));

    /// From its positive nodes with their weights, which are the 40-digit values of the Legendre roots, rounded to f64:
    /// error 1/2 ulp.
    const fn of<const HALF: usize>(half: [(f64, f64); HALF], folds: (f64, f32)) -> Self {
        let count = 2 * HALF;
        let (mut double, mut single) = (Tables::empty(0.0, folds.0), Tables::empty(0.0, folds.1));
        let mut pair = 0;
        while pair < HALF {
            let (negative, positive) = (2 * pair, 2 * pair + 1);
            let (x, weight) = half[pair];
            let highest = (count as f64 - 0.5) * weight * legendre(count - 1, x);
            let next = (count as f64 - 1.5) * weight * legendre(count - 2, x);
            (double.nodes[negative], double.nodes[positive]) = (-x, x);
            (double.weights[negative], double.weights[positive]) = (weight, weight);
            (double.first[pair], double.highest[pair]) = (1.5 * x * weight, highest);
            (double.next[pair], single.next[pair]) = (next, next as f32);
            let (x, weight) = (x as f32, weight as f32);
            (single.nodes[negative], single.nodes[positive]) = (-x, x);
            (single.weights[negative], single.weights[positive]) = (weight, weight);
            (single.first[pair], single.highest[pair]) = (1.5 * x * weight, highest as f32);
            pair += 1;
        }
        Self { count, double, single }
    }

    /// A number from the tables of the format that `T` has.
    #[inline(always)]
    fn number<T: Scalar>(
        &self,
        double: impl Fn(&Tables<f64>) -> f64,
        single: impl Fn(&Tables<f32>) -> f32,
    ) -> T {
        if is_single::<T>() { from_single(single(&self.single)) } else { T::constant(double(&self.double)) }
    }

    /// The shortest rule for an integrand that changes by e^`folds`.
    pub(crate) fn for_folds<T: Scalar>(folds: T) -> &'static Self {
        RULES.into_iter().find(|rule| folds <= rule.folds()).unwrap_or(Self::FINEST)
    }

    pub(crate) fn is_finest(&self) -> bool {
        self.len() == Self::FINEST.len()
    }

    /// The most e-foldings it integrates to full accuracy in the arithmetic of `T`.
    pub(crate) fn folds<T: Scalar>(&self) -> T {
        self.number(|tables| tables.folds, |tables| tables.folds)
    }

    /// The number of nodes.
    #[inline(always)]
    pub(crate) const fn len(&self) -> usize {
        // The compiler cannot know this, and would check all bounds.
        if self.count < MOST_NODES { self.count } else { MOST_NODES }
    }

    /// The factors with which a function's differences between the nodes ±x of each pair add up to its Legendre
    /// coefficients of degree 1 and n − 1.
    #[inline(always)]
    pub(crate) fn coefficients<T: Scalar>(&self) -> impl Iterator<Item = (T, T)> {
        (0..self.len() / 2).map(|pair| {
            let first = self.number(|tables| tables.first[pair], |tables| tables.first[pair]);
            (first, self.number(|tables| tables.highest[pair], |tables| tables.highest[pair]))
        })
    }

    /// Whether the rule integrates a function whose Legendre coefficient of degree n − 1 is `highest`, if the
    /// coefficients fall geometrically from that of degree 1 on. The first one that the rule does not see, of degree
    /// 2n, is then
    ///
    /// ```text
    /// highest · (highest/first)^((n+1)/(n−2)),    (n+1)/(n−2) ≥ 3/2 for n ≤ 8 and ≥ 1 for all n
    /// ```
    ///
    /// All are relative to the size of the function; the share `remaining` of the integral is left when it is used.
    #[inline(always)]
    pub(crate) fn resolves<T: Scalar>(&self, first: T, highest: T, remaining: T) -> bool {
        let (height, ratio) = (remaining * highest.abs(), (highest / first).abs());
        let fall = if self.len() <= 8 { ratio * ratio.sqrt() } else { ratio };
        is_negligible(height, fall, 4)
    }

    /// The same from `next`, the coefficient of degree n − 2: a pair of complex singularities lets coefficients
    /// oscillate, so that the last one may be next to nothing.
    ///
    /// The coefficient of degree 2n is then next · (next/first)^((n+2)/(n−3)). The exponent is 6 for n = 4, and at least
    /// 5/2, 2 and 1 for n ≤ 6, n ≤ 8 and all n.
    #[inline(always)]
    pub(crate) fn resolves_by_next<T: Scalar>(&self, first: T, next: T, remaining: T) -> bool {
        let (height, ratio) = (remaining * next.abs(), (next / first).abs());
        let square = ratio * ratio;
        let fall = match self.len() {
            ..=4 => square * square * square,
            5..=6 => square * ratio.sqrt(),
            7..=8 => square,
            _ => ratio,
        };
        // Sums of values have more rounding than their differences.
        is_negligible(height, fall, self.len())
    }

    /// The factor with which the sum of a function's values at the nodes ±x of a pair adds to its Legendre coefficient of
    /// degree n − 2.
    #[inline(always)]
    pub(crate) fn factor_of_next<T: Scalar>(&self, pair: usize) -> T {
        self.number(|tables| tables.next[pair], |tables| tables.next[pair])
    }

    /// Whether the rule [`resolves`](Self::resolves) the function that has these `values` at the nodes, by either of its
    /// last two coefficients.
    #[inline(always)]
    pub(crate) fn resolves_values<T: Scalar>(&self, values: &[T], remaining: T) -> bool {
        let (mut first, mut highest, mut next) = (T::zero(), T::zero(), T::zero());
        let (pairs, _) = values.as_chunks::<2>();
        for (place, (pair, factors)) in pairs.iter().zip(self.coefficients::<T>()).enumerate() {
            let (difference, sum) = (pair[1] - pair[0], pair[1] + pair[0]);
            first += factors.0 * difference;
            highest += factors.1 * difference;
            next += self.factor_of_next::<T>(place) * sum;
        }
        let size = values.last().map_or(T::zero(), |&value| value);
        let (first, highest, next) = (first / size, highest / size, next / size);
        self.resolves(first, highest, remaining) & self.resolves_by_next(first, next, remaining)
    }

    /// The nodes on [low, high], pair by pair from the middle outwards, with their weights.
    #[inline]
    pub(crate) fn nodes<T: Scalar>(&self, low: T, high: T) -> impl Iterator<Item = (T, T)> {
        let half = T::constant(0.5);
        let (middle, radius) = ((low + high) * half, (high - low) * half);
        (0..self.len()).map(move |index| {
            let node: T = self.number(|tables| tables.nodes[index], |tables| tables.nodes[index]);
            let weight: T = self.number(|tables| tables.weights[index], |tables| tables.weights[index]);
            (middle + radius * node, radius * weight)
        })
    }
}

/// Whether a Legendre coefficient becomes negligible by a fall. One no larger than the `rounding`, in units of ε, says
/// nothing.
#[inline(always)]
fn is_negligible<T: Scalar>(height: T, fall: T, rounding: usize) -> bool {
    let epsilon = T::default_epsilon();
    (height <= T::constant(rounding as f64) * epsilon) | (height * fall <= epsilon * T::constant(0.125))
}

/// The degrees of the Legendre coefficients by which the finest rule judges itself: two in the middle of those that it
/// sees, and the last two.
const DEGREES: [usize; 4] = [MOST_NODES / 2 - 1, MOST_NODES / 2, MOST_NODES - 2, MOST_NODES - 1];

/// (2k+1) Pₖ of these degrees k at the positive nodes of the finest rule.
const POLYNOMIALS: [[Tabled; MOST_NODES / 2]; 4] = {
    let mut rows = [[Tabled::of(0.0); MOST_NODES / 2]; 4];
    let mut row = 0;
    while row < rows.len() {
        let (degree, mut pair) = (DEGREES[row], 0);
        while pair < MOST_NODES / 2 {
            rows[row][pair] = Tabled::of((2 * degree + 1) as f64 * legendre(degree, NODES_24[pair].0));
            pair += 1;
        }
        row += 1;
    }
    rows
};

/// The relative error of an integral by the finest rule, estimated from its summands: the values of the integrand at
/// the nodes, multiplied by the weights.
///
/// It is the first Legendre coefficient that the rule does not see, of degree 2n, over the mean. From the middle
/// coefficients to the last ones, over n/2 degrees, the coefficients fall by a factor that is squared here for the n
/// degrees beyond: those of e^(c x) fall faster and faster, those of a function with a singularity as before. Of two
/// neighbours the larger one counts, because a pair of complex singularities lets coefficients oscillate.
#[inline(always)]
pub(crate) fn error_of_finest<T: Scalar>(summands: &[T]) -> T {
    let mut sums = [T::zero(); 4];
    let mut mean = T::zero();
    let (pairs, _) = summands.as_chunks::<2>();
    for (place, pair) in pairs.iter().enumerate().take(MOST_NODES / 2) {
        let (difference, sum) = (pair[1] - pair[0], pair[1] + pair[0]);
        mean += sum;
        for ((coefficient, row), degree) in sums.iter_mut().zip(&POLYNOMIALS).zip(DEGREES) {
            *coefficient += row[place].get::<T>() * if degree % 2 == 1 { difference } else { sum };
        }
    }
    let [first, second, third, last] = sums.map(|sum| (sum / mean).abs());
    let (middle, end) = (first.max(second), third.max(last));
    let fall = end / middle;
    end * (fall * fall)
}

/// The Legendre polynomial of a degree, by (k+1) P₍ₖ₊₁₎ = (2k+1) x Pₖ − k P₍ₖ₋₁₎.
const fn legendre(degree: usize, x: f64) -> f64 {
    let (mut before, mut now) = (0.0, 1.0);
    let mut k = 0;
    while k < degree {
        let next = ((2 * k + 1) as f64 * x * now - k as f64 * before) / (k + 1) as f64;
        (before, now) = (now, next);
        k += 1;
    }
    now
}

/// The rule of 4 nodes, exact for polynomials up to degree 7.
pub(crate) const NODES_4: [(f64, f64); 2] =
    [(0.33998104358485626, 0.6521451548625461), (0.8611363115940526, 0.34785484513745385)];
const NODES_6: [(f64, f64); 3] = [
    (0.2386191860831969, 0.46791393457269104),
    (0.6612093864662645, 0.3607615730481386),
    (0.932469514203152, 0.17132449237917036),
];
const NODES_8: [(f64, f64); 4] = [
    (0.1834346424956498, 0.362683783378362),
    (0.525532409916329, 0.31370664587788727),
    (0.7966664774136267, 0.22238103445337448),
    (0.9602898564975363, 0.10122853629037626),
];
const NODES_10: [(f64, f64); 5] = [
    (0.14887433898163122, 0.29552422471475287),
    (0.4333953941292472, 0.26926671930999635),
    (0.6794095682990244, 0.21908636251598204),
    (0.8650633666889845, 0.1494513491505806),
    (0.9739065285171717, 0.06667134430868814),
];
const NODES_12: [(f64, f64); 6] = [
    (0.1252334085114689, 0.24914704581340277),
    (0.3678314989981802, 0.2334925365383548),
    (0.5873179542866175, 0.20316742672306592),
    (0.7699026741943047, 0.16007832854334622),
    (0.9041172563704749, 0.10693932599531843),
    (0.9815606342467192, 0.04717533638651183),
];
const NODES_16: [(f64, f64); 8] = [
    (0.09501250983763744, 0.1894506104550685),
    (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254),
    (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388),
    (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.062253523938647894),
    (0.9894009349916499, 0.027152459411754096),
];
const NODES_24: [(f64, f64); 12] = [
    (0.06405689286260563, 0.12793819534675216),
    (0.1911188674736163, 0.1258374563468283),
    (0.3150426796961634, 0.12167047292780339),
    (0.4337935076260451, 0.1155056680537256),
    (0.5454214713888396, 0.10744427011596563),
    (0.6480936519369755, 0.09761865210411388),
    (0.7401241915785544, 0.08619016153195327),
    (0.820001985973903, 0.0733464814110803),
    (0.8864155270044011, 0.05929858491543678),
    (0.9382745520027328, 0.04427743881741981),
    (0.9747285559713095, 0.028531388628933663),
    (0.9951872199970213, 0.0123412297999872),
];

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [&Rule; 7] =
        [Rule::FOUR, Rule::SIX, Rule::EIGHT, Rule::TEN, Rule::TWELVE, Rule::SIXTEEN, Rule::FINEST];

    #[test]
    fn rules_are_exact_for_polynomials() {
        for rule in ALL {
            let n = rule.len();
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

    /// Sums over the pairs of nodes: of Pₖ times the factors for the Legendre coefficients of degree 1, n − 1 and n − 2.
    fn coefficients_of_legendre(rule: &Rule, degree: usize) -> [f64; 3] {
        let (pairs, _) = rule.double.nodes.as_chunks::<2>();
        let pairs = pairs.iter().zip(rule.coefficients::<f64>()).enumerate();
        pairs.fold([0.0; 3], |[first, highest, next], (place, (x, factors))| {
            let [low, high] = x.map(|x| legendre(degree, x));
            [
                first + factors.0 * (high - low),
                highest + factors.1 * (high - low),
                next + rule.factor_of_next::<f64>(place) * (high + low),
            ]
        })
    }

    #[test]
    fn coefficients_are_those_of_legendre() {
        for rule in ALL {
            let n = rule.len();
            for degree in 0..n {
                let found = coefficients_of_legendre(rule, degree);
                for (found, (its_degree, bound)) in
                    found.into_iter().zip([(1, 1e-14), (n - 1, 1e-13), (n - 2, 1e-13)])
                {
                    let expected = if degree == its_degree { 1.0 } else { 0.0 };
                    assert!((found - expected).abs() < bound, "{n} nodes, {its_degree} of {degree}: {found}");
                }
            }
        }
    }

    #[test]
    fn rules_hold_what_their_folds_promise() {
        for rule in ALL {
            let folds = rule.folds::<f64>();
            let integral =
                rule.nodes(0.0, 1.0).fold(0.0, |sum, (x, w): (f64, f64)| sum + w * (folds * (x - 1.0)).exp());
            let error = integral * folds / -(-folds).exp_m1() - 1.0;
            assert!(error.abs() < 8.0 * f64::EPSILON, "{folds} folds: {error:e}");
        }
    }

    /// The formula at the top: a rule may be far better than it says, so that sums of exponentials do not show a fold too
    /// many.
    #[test]
    fn folds_are_where_the_error_reaches_a_quarter_of_a_rounding() {
        let ln_factorial = |k: usize| (1..=k).map(|i| (i as f64).ln()).sum::<f64>();
        for rule in ALL {
            let (n, odd) = (rule.len(), (2 * rule.len() + 1) as f64);
            let factorials = 4.0 * ln_factorial(n) - 3.0 * ln_factorial(2 * n);
            let double = (rule.folds::<f64>(), f64::EPSILON);
            for (folds, epsilon) in [double, (rule.folds::<f32>().into(), f32::EPSILON.into())] {
                let error = (factorials + odd * folds.ln()).exp() / odd / -(-folds).exp_m1();
                // Folds have four digits.
                assert!(
                    (error / epsilon * 4.0 - 1.0).abs() < 1e-3 * odd,
                    "{n} nodes, {folds} folds: {error:e}"
                );
            }
        }
    }
}
