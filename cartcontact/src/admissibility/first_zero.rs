//! The end of the admissible range of a geometry known at run time.
//!
//! A geometry is admissible up to a when δ₀′ > 0 on (0, a], that is, while f(x) = Σ d e^((n − n₁) x) > 0 with
//! d = 2 C n/(n+2), x = ln r and n₁ the smallest exponent. The first zero of f is found from the left, where
//! f > 0, in steps h that cannot pass it: with M ≥ |f″| on [x, x + ρ], Taylor's theorem gives
//! f(x + h) ≥ f + f′ h − M h²/2 for h ≤ ρ, and h is the zero of the right-hand side.
//!
//! **No zero at all.** Often this is seen at once. A negative term between the first and the last, both positive,
//! k = θ k₁ + (1−θ) k₂, never outweighs them if d ≤ (d₁/θ)^θ (d₂/(1−θ))^(1−θ), by the inequality between weighted
//! means; several do not if each is below its share of that. For three terms the condition is also necessary (S.
//! Iliman, T. de Wolff, Res. Math. Sci. 3 (2016), doi 10.1186/s40687-016-0052-2, call the right-hand side the circuit
//! number).
//!
//! **Bounds.** Below x₀, where each of the N negative terms is less than 1/(N+1) of the first term, f > 0; so it is above
//! x₁, where each is less than 1/(N+1) of the last term, if that is positive. So the march runs from x₀ to x₁, or
//! without end if the last coefficient is negative: then there is a zero. Positive terms do not count here: one whose
//! exponent is next to the first may outweigh it down to radii that no format has.
//!
//! **Termination.** Near a simple zero h is a Newton step; near a double zero, or a minimum just above zero, the
//! distance shrinks by a constant factor; elsewhere f is bounded below on the compact interval and so is h. The march
//! ends where f is positive by less than its own rounding. If it still runs after `MOST_STEPS`, the range ends where
//! the march stands: never too long, at worst too short.
//!
//! **Rounding.** Each d has three roundings, each k one. What these and all others may add to a result is subtracted
//! from it, so that a range never ends beyond the zero; terms that cancel may leave no range. Every rounding, of ε/2,
//! counts ε: that covers the roundings of these bounds themselves.

use crate::Scalar;
use crate::scalar::{from_single, smallest_normal};

/// The most steps of the march: where it ends early, because a slope nearly vanishes, the range is too short and
/// never too long.
const MOST_STEPS: u32 = 20_000;

/// δ₀′ as a sum of exponentials of x = ln r.
pub(super) struct Slope<'a, T> {
    /// The terms (C, n) of the gap.
    pub(super) terms: &'a [(T, T)],
    /// The smallest exponent.
    pub(super) smallest: T,
}

/// Lower bounds of f and f′ and an upper bound of |f″| on [x, x + ρ], in a common scale.
struct Expansion<T> {
    value: T,
    slope: T,
    curvature: T,
}

impl<T: Scalar> Slope<'_, T> {
    /// The terms (d, n − n₁) with d ≠ 0.
    fn exponentials(&self) -> impl Iterator<Item = (T, T)> + Clone + '_ {
        let two = T::constant(2.0);
        let shifted = move |&(c, n): &(T, T)| (c * (two * n / (n + two)), n - self.smallest);
        self.terms.iter().map(shifted).filter(|(d, _)| !d.is_zero())
    }

    fn negative_exponentials(&self) -> impl Iterator<Item = (T, T)> + Clone + '_ {
        self.exponentials().filter(|&(d, _)| d < T::zero())
    }

    fn count(&self) -> T {
        from_single(self.exponentials().count() as f32)
    }

    /// N, the number of negative terms.
    fn negative_count(&self) -> T {
        from_single(self.negative_exponentials().count() as f32)
    }

    /// A lower bound of the coefficient d of an exponent: terms of the same exponent may cancel.
    fn least_coefficient(&self, exponent: T) -> T {
        // Three roundings of d, the product below, and a sum for each term.
        let rounding = T::default_epsilon() * (T::constant(4.0) + self.count());
        let terms = self.exponentials().filter(|&(_, k)| k == exponent);
        terms.fold(T::zero(), |sum, (d, _)| sum + (d - d.abs() * rounding))
    }

    /// Whether the first term alone outweighs all negative ones at a radius, and hence at all smaller radii.
    pub(super) fn first_outweighs_negative_up_to(&self, radius: T) -> bool {
        let (zero, one) = (T::zero(), T::one());
        // Three roundings of d, two of the power, three of the factors below, and a sum for each term.
        let rounding = T::default_epsilon() * (T::constant(8.0) + self.count());
        // The rounding of k, in the power.
        let per_exponent = T::default_epsilon() * radius.ln().abs();
        let negative =
            self.negative_exponentials().filter(|&(_, k)| !k.is_zero()).fold(zero, |sum, (d, k)| {
                // The power may be too small for its format.
                sum - d * radius.powf(k).max(smallest_normal()) * (one + rounding + per_exponent * k)
            });
        negative < self.least_coefficient(zero)
    }

    pub(super) fn first_zero(&self) -> T {
        let (zero, one) = (T::zero(), T::one());
        let first = self.least_coefficient(zero);
        if first <= zero {
            return zero;
        }
        let span = self.exponentials().fold(zero, |most, (_, k)| most.max(k));
        if self.is_positive_by_its_ends(span) {
            return T::infinity();
        }
        if let Some(zero) = self.zero_of_two_terms(first) {
            return zero;
        }
        let step = span.recip();
        // The exponential at the end may be off by ε, and its product is rounded; and a step of less than the spacing of
        // numbers next to x does not move it.
        let rounding = T::default_epsilon() * T::constant(4.0);
        let end = self.last_term_dominates_from(span);
        let mut x = self.first_term_dominates_up_to(first);
        for _ in 0..MOST_STEPS {
            if end.is_some_and(|end| x >= end) {
                return T::infinity();
            }
            let here = self.expansion(x, step);
            if here.value <= zero {
                break;
            }
            let safe = here.safe_step().min(step);
            if safe <= rounding * x.abs() {
                break;
            }
            x += safe;
        }
        x.exp() * (one - rounding)
    }

    /// The zero of a positive and a negative term: x = ln(d₁/|d₂|)/k, and a little less.
    fn zero_of_two_terms(&self, first: T) -> Option<T> {
        let mut others = self.exponentials().filter(|&(_, k)| k > T::zero());
        let (Some((d, k)), None) = (others.next(), others.next()) else { return None };
        let (first, last) = (first.ln(), d.abs().ln());
        // Each logarithm is off by ε, and by the roundings of its number; k and the difference are rounded.
        let rounding = T::default_epsilon() * T::constant(4.0) * (first.abs() + last.abs() + k + T::one());
        (d < T::zero()).then(|| ((first - last - rounding) / k).exp())
    }

    /// Whether the first and the last term outweigh the negative ones between them at every radius.
    ///
    /// Compared as logarithms; terms too close for that are left to the march.
    fn is_positive_by_its_ends(&self, span: T) -> bool {
        let (zero, one) = (T::zero(), T::one());
        let (first, last) = (self.least_coefficient(zero), self.least_coefficient(span));
        if last <= zero {
            return false;
        }
        let (log_first, log_last) = (first.ln(), last.ln());
        let log_count = self.negative_count().ln();
        // Six logarithms, and some ten operations with numbers no larger than `size`.
        let rounding = T::default_epsilon() * T::constant(16.0);
        self.negative_exponentials().all(|(d, k)| {
            let weight = k / span;
            let rest = one - weight;
            let (of_first, of_last) = (rest * (log_first - rest.ln()), weight * (log_last - weight.ln()));
            let log_size = (-d).ln() + log_count;
            let size = log_size.abs() + log_first.abs() + log_last.abs() + one;
            log_size + rounding * size < of_first + of_last
        })
    }

    /// x₀: every negative term is below 1/(N+1) of the first.
    fn first_term_dominates_up_to(&self, first: T) -> T {
        let log_count = (self.negative_count() + T::one()).ln();
        self.negative_exponentials()
            .filter(|&(_, k)| k > T::zero())
            .fold(T::infinity(), |x, (d, k)| x.min((first.ln() - log_count - d.abs().ln()) / k))
    }

    /// x₁: every negative term is below 1/(N+1) of the last; none if the last coefficient is not positive.
    fn last_term_dominates_from(&self, span: T) -> Option<T> {
        let log_count = (self.negative_count() + T::one()).ln();
        let last = self.least_coefficient(span);
        (last > T::zero()).then(|| {
            self.negative_exponentials()
                .filter(|&(_, k)| k < span)
                .fold(-T::infinity(), |x, (d, k)| x.max((log_count + d.abs().ln() - last.ln()) / (span - k)))
        })
    }

    fn expansion(&self, x: T, step: T) -> Expansion<T> {
        let log_size = |(d, k): (T, T)| d.abs().ln() + k * x;
        let scale = self.exponentials().map(log_size).fold(-T::infinity(), T::max);
        let (zero, four) = (T::zero(), T::constant(4.0));
        let (mut value, mut slope, mut curvature, mut error) = (zero, zero, zero, zero);
        for (d, k) in self.exponentials() {
            let size = (log_size((d, k)) - scale).exp();
            let term = size.copysign(d);
            value += term;
            slope += k * term;
            curvature += k * k * size * (k * step).exp();
            // In units of ε: of the logarithms, which are rounded, multiplied and added; of d and the exponential; and of
            // the sum so far.
            let of_logarithms = d.abs().ln().abs() + (k * x).abs();
            error += size * (four + T::constant(1.5) * of_logarithms) + value.abs();
        }
        let error = error * T::default_epsilon();
        Expansion { value: value - error, slope: slope - error / step, curvature }
    }
}

impl<T: Scalar> Expansion<T> {
    /// The positive zero of f + f′ h − M h²/2, without cancellation.
    fn safe_step(&self) -> T {
        let two = T::constant(2.0);
        let root = (self.slope * self.slope + two * self.curvature * self.value).sqrt();
        if self.slope >= T::zero() {
            (self.slope + root) / self.curvature
        } else {
            two * self.value / (root - self.slope)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// r², r⁵¹² and r¹⁰²⁴ with 2 C n/(n+2) = a + b, −a and −b, so that the zero is at 1. In so steep a sum, roundings
    /// move it by less than the rounding of e^x moves a radius.
    #[test]
    fn radii_before_a_steep_zero_are_rounded_down() {
        for a in (1..40).map(f64::from) {
            let b = 1024.0 - a;
            let terms = [(a + b, 2.0), (-257.0 / 512.0 * a, 512.0), (-513.0 / 1024.0 * b, 1024.0)];
            let found = Slope { terms: &terms, smallest: 2.0 }.first_zero();
            assert!(found < 1.0 && found > 1.0 - 1e-13, "{a}: {found}");
        }
    }

    /// The difference of the exponents, 62 + 2⁻⁴⁹, is rounded to 62, and the power of 2¹⁶ with it by 88 ε. The last term
    /// seems to be 40 ε smaller than the first, and is 48 ε larger.
    #[test]
    fn exponents_may_be_rounded() {
        let (radius, smallest) = (2f64.powi(16), 2.0 - 2f64.powi(-49));
        let last = 33.0 / 64.0 * 2f64.powi(-16 * 62) * (1.0 - 40.0 * f64::EPSILON);
        let terms = [(1.0, smallest), (-last, 64.0)];
        let slope = Slope { terms: &terms, smallest };
        assert!(!slope.first_outweighs_negative_up_to(radius));
        assert!(slope.first_outweighs_negative_up_to(radius * (1.0 - 1e-12)));
    }
}
