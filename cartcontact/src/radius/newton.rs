//! The contact radius from the load integral: J(a) = y solved by Newton's method inside a bracket.
//!
//! J(a) = Σ j a^p is nearly a power of a, so the step is taken on logarithms: with f = ln(J/y) and d f/d ln a = a J′/J
//! the Newton step of ln a is −f J/(a J′). Replacing ln by its first Padé approximant, ln z ≈ 2 (z−1)/(z+1) with
//! z = J/y, and exp likewise keeps the order of convergence and needs only one division:
//!
//! ```text
//! a ← a (A − B)/(A + B),    A = (z + 1) a J′/y,    B = (z − 1) z
//! ```
//!
//! For a single power its error is of third order, so that an estimate within 2 % is enough to start from.
//!
//! **The bracket.** Let a_i solve the i-th positive term alone, j_i a_i^(p_i) = y. The positive terms can only
//! add to each other, so without negative terms a ≤ min a_i; and where every positive term is below y/N, J is
//! below y, so a ≥ min a_i N^(−1/p_min) with or without negative terms. With negative terms the upper end is
//! the end of the admissible range, or is found by doubling.
//!
//! **Termination.** Every evaluation replaces one end of the bracket by the point evaluated. A step that would leave the
//! bracket by more than rounding, and every second step after the eighth, is replaced by the geometric mean of the ends,
//! which halves the bracket in ln a. Its width is below ln 2^2100 at the start and the iteration ends when it is below ε,
//! so there are at most 8 + 2 · 63 evaluations; 3 or 4 are usual.
//!
//! **Accuracy.** The last step is an uncorrected Newton step from a point so near the root, see [`close_enough`], that
//! its error is that of J divided by p = a J′/J, and p is at least n+4 for one term. There J is rounded once: in plain
//! arithmetic its error is up to p/2 ε, and after division by p it is no longer small beside the rounding of the
//! result.
//!
//! **Derivatives** follow from the radius that plain numbers lead to, see [`halley`](super::halley).

use super::halley::with_derivatives;
use super::{beyond, needs_search};
use crate::Scalar;
use crate::numbers::binary::{estimated_root_of_quotient, scale, split};
use crate::profile::RadiusError;
use crate::scalar::{has_no_derivatives, lesser, without_derivatives};

/// Solves J(a) = `target` on (0, `limit`] for a gap of the terms (C, n), in any order.
///
/// `has_negative_terms` tells whether a C is negative. `evaluate` gives J(a) and a J′(a), and `load_integral` J(a)
/// rounded once.
///
/// # Errors
///
/// [`RadiusError`] if `target` is negative or not finite, or exceeds J(`limit`), and where terms of a J′ have both signs
/// and leave the format, or derivatives do.
#[inline]
pub fn invert<T: Scalar>(
    mut target: T,
    limit: T,
    terms: impl IntoIterator<Item = (T, T)>,
    has_negative_terms: bool,
    evaluate: impl Fn(T) -> (T, T),
    load_integral: impl Fn(T) -> T,
) -> Result<T, RadiusError> {
    if !needs_search(target, limit)? {
        return Ok(T::zero());
    }
    let plain_limit = without_derivatives(limit);
    let plain_terms = terms.into_iter().map(|(c, n)| (without_derivatives(c), without_derivatives(n)));
    let Seed { radius: start, mut bracket } = Seed::of(without_derivatives(target), plain_terms);
    // J(`limit`) as it is known to a caller who asks for the end of the range. Plain arithmetic may give less; with
    // fields, whose coefficients are rounded here, even this may be less by some roundings.
    let is_end_near = limit.is_finite() && (has_negative_terms || limit <= bracket.high);
    let largest = if is_end_near { load_integral(limit) } else { T::infinity() };
    if target > largest * (T::one() + T::default_epsilon() * T::constant(16.0)) {
        return Err(beyond(target, largest, limit));
    }
    if largest.is_finite() {
        target = lesser(target, largest);
        bracket.high = plain_limit;
    } else if has_negative_terms {
        // Also where J(`limit`) is the difference of infinite terms.
        let high = above(target, bracket.high, &evaluate);
        bracket.high = high.ok_or_else(|| beyond(target, -T::infinity(), limit))?.min(plain_limit);
    }
    bracket.low = bracket.low.min(bracket.high);
    let close = close_enough(has_negative_terms);
    let plain = |(value, log_slope)| (without_derivatives(value), without_derivatives(log_slope));
    let functions = (|a| plain(evaluate(a)), |a| without_derivatives(load_integral(a)));
    let start = start.min(bracket.high);
    let (radius, log_slope) = iterate(without_derivatives(target), start, bracket, close, functions);
    // Where J is the difference of infinite terms, it is not known whether that exceeds y; the terms of a J′ are larger.
    if has_negative_terms && !log_slope.is_finite() {
        return Err(RadiusError::Unrepresentable { load_integral: target.value() });
    }
    // The last step may end a few units in the last place beyond the bracket.
    if radius > limit || has_no_derivatives::<T>() {
        return Ok(lesser(radius, limit));
    }
    // The reciprocal of a slope may leave the format, if that is not divided by a power of two near y.
    let (_, exponent) = split(target);
    let radius = with_derivatives(radius, scale(target, -exponent), |a| {
        let (value, log_slope) = evaluate(a);
        (scale(value - target, -exponent), scale(without_derivatives(log_slope), -exponent).recip())
    });
    // J or a J′ may leave the format where y is at an end of it, and infinite derivatives make the value no number.
    if radius.value().is_nan() {
        return Err(RadiusError::Unrepresentable { load_integral: target.value() });
    }
    Ok(radius)
}

/// A radius of which J is not below `target`, from `high` on; none if J falls further than it has to rise, as that of a
/// geometry that is not admissible may: then it is not sought in vain.
fn above<T: Scalar>(target: T, mut high: T, evaluate: impl Fn(T) -> (T, T)) -> Option<T> {
    let (mut value, mut log_slope) = evaluate(high);
    // Not a number, if terms of both signs overflow, ends it too.
    while value < target {
        if log_slope < -target {
            return None;
        }
        high += high;
        (value, log_slope) = evaluate(high);
    }
    Some(high)
}

/// Where the search begins.
struct Seed<T> {
    /// The least of the radii that positive terms have alone.
    radius: T,
    /// Its upper end holds without negative terms only.
    bracket: Bracket<T>,
}

impl<T: Scalar> Seed<T> {
    fn of(target: T, terms: impl IntoIterator<Item = (T, T)>) -> Self {
        let (two, four) = (T::constant(2.0), T::constant(4.0));
        let (mut radius, mut count, mut least_power) = (T::infinity(), T::zero(), T::infinity());
        for (c, n) in terms.into_iter().filter(|&(c, _)| c > T::zero()) {
            // j a^p = y for p = n + 4 and 1/j = (n+2)(n+4)/(C n).
            let p = n + four;
            radius = radius.min(estimated_root_of_quotient(target, (n + two) * (p / n), c, p));
            least_power = least_power.min(p);
            count += T::one();
        }
        // N^(−1/p) ≥ 1 − (ln N)/p ≥ 1 − (N−1)/p, but never below N^(−1/4) ≥ 1/N.
        let shrink = (T::one() - (count - T::one()) / least_power).max(count.recip());
        // Both ends are widened by the error of the estimates.
        let margin = T::constant(0.02);
        let (low, high) = (radius * shrink * (T::one() - margin), radius * (T::one() + margin));
        Self { radius, bracket: Bracket { low, high } }
    }
}

/// J(low) ≤ target ≤ J(high).
struct Bracket<T> {
    low: T,
    high: T,
}

impl<T: Scalar> Bracket<T> {
    /// Next to the root a step may leave by a rounding, which is no reason to begin again in the middle.
    fn contains(&self, a: T) -> bool {
        let rounding = a * T::default_epsilon() * T::constant(4.0);
        self.low - rounding <= a && a <= self.high + rounding
    }

    fn middle(&self) -> T {
        self.low.sqrt() * self.high.sqrt()
    }

    fn is_narrow(&self) -> bool {
        self.high - self.low <= T::default_epsilon() * self.high
    }
}

/// Steps accepted as they are before bisection is mixed in.
const FREE_STEPS: usize = 8;

/// Halvings of ln a that make the widest bracket narrow; beside each there is one more free step.
const HALVINGS: usize = 63;

/// The radius, and a J′ next to it.
fn iterate<T: Scalar>(
    target: T,
    start: T,
    mut bracket: Bracket<T>,
    close: T,
    (evaluate, load_integral): (impl Fn(T) -> (T, T), impl Fn(T) -> T),
) -> (T, T) {
    let one = T::one();
    let per_target = target.recip();
    let mut a = start;
    for step in 0..FREE_STEPS + 2 * HALVINGS {
        let (value, log_slope) = evaluate(a);
        if value < target {
            bracket.low = a;
        } else {
            bracket.high = a;
        }
        let ratio = value * per_target;
        let (near, far) = ((ratio - one) * ratio, (ratio + one) * (log_slope * per_target));
        let next = a * ((far - near) / (far + near));
        // Also false for NaN, which a slope of zero can cause.
        if bracket.contains(next) && !(step > FREE_STEPS && step % 2 == 1) {
            a = next;
            if near.abs() <= close * far {
                break;
            }
        } else if !bracket.is_narrow() {
            a = bracket.middle();
        }
        if bracket.is_narrow() {
            break;
        }
    }
    let (_, log_slope) = evaluate(a);
    let correction = a * ((load_integral(a) - target) / log_slope);
    // Where the slope nearly vanishes, there is no usable correction: see `close_enough` for how large it may be.
    let is_usable = correction.abs() <= a * T::default_epsilon().sqrt();
    (if is_usable { a - correction } else { a }, log_slope)
}

/// Half the relative change, B/A, below which one more step of each kind ends the iteration.
///
/// A step on logarithms leaves v/(2 p) times the square of the error, where v is the variance of the powers weighted by
/// their terms; a Newton step leaves p/2 times its square. Without negative terms v/p is below the highest power p₂, so
/// that both leave less than p₂³/8 times the fourth power of the error: below √ε/8 that is less than ε/8 for powers up
/// to 1028, also in single precision.
///
/// With negative terms v and p, then a J″/J′, have no bound: next to a double zero of δ₀′ the slope doubles within a
/// share w of the radius, and both are of the size of 1/w. Steps below ε^(3/4) leave ε while w is above √ε. If the
/// condition number is above ε^(−1/4), rounding of J keeps steps from becoming that short, and the bracket is halved to
/// its end instead. The point found is then off by some ε times the condition number, which the last step takes away:
/// it leaves the square of that, times up to the condition number, and so is of use while it is below √ε.
fn close_enough<T: Scalar>(has_negative_terms: bool) -> T {
    let root = T::default_epsilon().sqrt();
    root * if has_negative_terms { root.sqrt() } else { T::constant(0.125) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MIXED: [(f64, f64); 3] = [(0.05, 2.0), (-0.004, 3.0), (2e-4, 4.0)];

    /// J and a J′ of [`MIXED`] terms.
    fn mixed(a: f64) -> (f64, f64) {
        MIXED.iter().fold((0.0, 0.0), |(value, slope), &(c, n)| {
            let term = c * n * a.powf(n + 4.0) / ((n + 2.0) * (n + 4.0));
            (value + term, slope + (n + 4.0) * term)
        })
    }

    fn load_integral(a: f64) -> f64 {
        mixed(a).0
    }

    fn radius(target: f64, limit: f64) -> Result<f64, RadiusError> {
        invert(target, limit, MIXED, true, mixed, load_integral)
    }

    #[test]
    fn planted_radii_are_recovered_with_negative_terms() {
        for k in -60..60 {
            let planted = 10f64.powf(f64::from(k) / 10.0);
            let target = mixed(planted).0;
            let found = radius(target, f64::INFINITY);
            let error = found.map(|a| (a / planted - 1.0).abs());
            assert!(error.is_ok_and(|e| e < 1e-15), "{planted}: {found:?}");
        }
    }

    /// J and a J′ where δ₀′ ∝ a (1 − 2 b a + a²), and the sum of the sizes of the terms of J.
    fn nearly_flat(b: f64, a: f64) -> ((f64, f64), f64) {
        let terms = [(1.0 / 6.0, 6.0), (-2.0 * b / 7.0, 7.0), (1.0 / 8.0, 8.0)];
        let sum = |weight: fn(f64, f64) -> f64| terms.iter().map(|&(j, p)| weight(j * a.powf(p), p)).sum();
        ((sum(|term, _| term), sum(|term, p| p * term)), sum(|term, _| term.abs()))
    }

    /// By how much [`nearly_flat`] of the radius that is found misses that of a planted one, as a share of the sizes of its
    /// terms. The bracket is that of `positive` terms.
    fn missed(
        positive: impl IntoIterator<Item = (f64, f64)>,
        b: f64,
        planted: f64,
    ) -> Result<f64, RadiusError> {
        let evaluate = |a| nearly_flat(b, a).0;
        let ((target, _), size) = nearly_flat(b, planted);
        let found = invert(target, f64::INFINITY, positive, true, evaluate, |a| evaluate(a).0);
        found.map(|a| (evaluate(a).0 - target).abs() / size)
    }

    #[test]
    fn nearly_flat_load_integrals_are_met_to_their_rounding() {
        for k in 0..1000 {
            let b = 1.0 - 10f64.powf(-6.0 - 7.0 * f64::from(k % 31) / 31.0);
            let planted = 1.0 + 2e-5 * (f64::from(k) / 500.0 - 1.0);
            let missed = missed([(2.0, 2.0), (1.5, 4.0)], b, planted);
            assert!(missed.is_ok_and(|missed| missed < f64::EPSILON), "{k}: {missed:?}");
        }
    }

    /// The slope nearly vanishes where the search begins, and bisection goes on from a bracket of more terms than the
    /// least power has units.
    #[test]
    fn brackets_of_many_terms_begin_above_zero() {
        let parts = 28_u8;
        let positive = [(2.0, 2.0), (1.5, 4.0)].map(|(c, n)| (c / f64::from(parts), n)).repeat(parts.into());
        for k in 1..100 {
            let planted = 1.0 - 1e-3 * f64::from(k);
            let missed = missed(positive.iter().copied(), 1.0 - 1e-6, planted);
            assert!(missed.is_ok_and(|missed| missed < f64::EPSILON), "{planted}: {missed:?}");
        }
    }

    /// J = a⁸, the difference of terms that are a hundred times as large.
    #[test]
    fn radii_beyond_finite_terms_are_refused() {
        let evaluate = |a: f64| {
            let power = a.powi(8);
            (101.0 * power - 100.0 * power, 808.0 * power - 800.0 * power)
        };
        for (a, is_known) in [(1e30_f64, true), (1e38, true), (1.6e38, false), (3e38, false)] {
            let target = a.powi(8);
            let found =
                invert(target, f64::INFINITY, [(101.0 * 12.0, 4.0)], true, evaluate, |a| evaluate(a).0);
            if is_known {
                assert!(
                    found.is_ok_and(|found| (found / a - 1.0).abs() < 100.0 * f64::EPSILON),
                    "{a:e}: {found:?}"
                );
            } else {
                assert_eq!(found, Err(RadiusError::Unrepresentable { load_integral: target }));
            }
        }
    }

    #[test]
    fn the_end_of_the_range_is_inside() {
        let end = mixed(5.0).0;
        let found = radius(end, 5.0);
        assert!(found.is_ok_and(|a| (a - 5.0).abs() <= 1e-15), "{found:?}");
        assert!(matches!(
            radius(end * 1.000_001, 5.0),
            Err(RadiusError::BeyondRange { max_radius: 5.0, .. })
        ));
    }

    /// All terms are as large as each other at 1, so that each alone is a third of J.
    #[test]
    fn the_bracket_has_the_radius_of_many_equal_terms() {
        let powers = [6, 7, 8];
        let terms = powers.map(|p| {
            let n = f64::from(p - 4);
            ((n + 2.0) * (n + 4.0) / n, n)
        });
        let sum =
            |a: f64, weight: fn(i32) -> i32| powers.map(|p| f64::from(weight(p)) * a.powi(p)).iter().sum();
        let evaluate = |a: f64| -> (f64, f64) { (sum(a, |_| 1), sum(a, |p| p)) };
        for has_negative_terms in [false, true] {
            let found = invert(3.0, f64::INFINITY, terms, has_negative_terms, evaluate, |a| evaluate(a).0);
            assert!(found.is_ok_and(|a| (a - 1.0).abs() < 2.0 * f64::EPSILON), "{found:?}");
        }
    }

    #[test]
    fn the_middle_of_a_bracket_is_in_the_format() {
        for unit in [2f64.powi(-600), 1.0, 2f64.powi(600)] {
            let middle = Bracket { low: unit, high: 4.0 * unit }.middle();
            assert!((middle / (2.0 * unit) - 1.0).abs() <= f64::EPSILON, "{unit:e}: {middle:e}");
        }
    }
}
