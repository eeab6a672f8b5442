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

mod legendre;

use crate::Scalar;
use crate::numbers::tabled::{Tabled, of_precision};
pub(crate) use legendre::NODES_4;
use legendre::{NODES_6, NODES_8, NODES_10, NODES_12, NODES_16, NODES_24, legendre};

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

    /// From its positive nodes with their weights.
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

    /// The shortest rule for an integrand that changes by e^`folds`.
    pub(crate) fn for_folds<T: Scalar>(folds: T) -> &'static Self {
        RULES.into_iter().find(|rule| folds <= rule.folds()).unwrap_or(Self::FINEST)
    }

    pub(crate) fn is_finest(&self) -> bool {
        self.len() == Self::FINEST.len()
    }

    /// The most e-foldings it integrates to full accuracy in the arithmetic of `T`.
    pub(crate) fn folds<T: Scalar>(&self) -> T {
        of_precision(self.double.folds, self.single.folds)
    }

    /// The number of nodes.
    #[inline(always)]
    pub(crate) const fn len(&self) -> usize {
        // The compiler cannot know this, and would check all bounds.
        if self.count < MOST_NODES { self.count } else { MOST_NODES }
    }

    /// The factors with which a function's values at the nodes ±x of each pair add up to its Legendre coefficients of
    /// degree 1, n − 1 and n − 2: their difference to the first two, their sum to the third.
    #[inline(always)]
    pub(crate) fn coefficients<T: Scalar>(&self) -> impl Iterator<Item = [T; 3]> {
        let Self { double, single, .. } = self;
        (0..self.len() / 2).map(|pair| {
            [
                of_precision(double.first[pair], single.first[pair]),
                of_precision(double.highest[pair], single.highest[pair]),
                of_precision(double.next[pair], single.next[pair]),
            ]
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

    /// Whether the rule [`resolves`](Self::resolves) a function, by `next`, its coefficient of degree n − 2: a pair of
    /// complex singularities lets coefficients oscillate, so that the last one may be next to nothing.
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

    /// Whether the rule [`resolves`](Self::resolves) the function that has these `values` at the nodes, by either of its
    /// last two coefficients.
    #[inline(always)]
    pub(crate) fn resolves_values<T: Scalar>(&self, values: &[T], remaining: T) -> bool {
        let (mut first, mut highest, mut next) = (T::zero(), T::zero(), T::zero());
        let (pairs, _) = values.as_chunks::<2>();
        for (pair, [to_first, to_highest, to_next]) in pairs.iter().zip(self.coefficients::<T>()) {
            let (difference, sum) = (pair[1] - pair[0], pair[1] + pair[0]);
            first += to_first * difference;
            highest += to_highest * difference;
            next += to_next * sum;
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
            let node: T = of_precision(self.double.nodes[index], self.single.nodes[index]);
            let weight: T = of_precision(self.double.weights[index], self.single.weights[index]);
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
/// coefficients to the last ones, over n/2 − 1 degrees, the coefficients fall by a factor that is squared here for the
/// n + 1 degrees or more beyond: those of e^(c x) fall faster and faster, those of a function with a singularity as
/// before. Of two neighbours the larger one counts, because a pair of complex singularities lets coefficients oscillate.
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
        let pairs = pairs.iter().zip(rule.coefficients::<f64>());
        pairs.fold([0.0; 3], |[first, highest, next], (x, factors)| {
            let [low, high] = x.map(|x| legendre(degree, x));
            [
                first + factors[0] * (high - low),
                highest + factors[1] * (high - low),
                next + factors[2] * (high + low),
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
