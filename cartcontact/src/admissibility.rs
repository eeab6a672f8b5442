//! The end of the admissible range of a geometry known at run time.
//!
//! A geometry is admissible up to a when δ₀′ > 0 on (0, a], that is, while f(x) = Σ d e^((n − n₁) x) > 0 with
//! d = 2 C n/(n+2), x = ln r and n₁ the smallest exponent. The first zero of f is found from the left, where
//! f > 0, in steps h that cannot pass it: with M ≥ |f″| on [x, x + ρ], Taylor's theorem gives
//! f(x + h) ≥ f + f′ h − M h²/2 for h ≤ ρ, and h is the zero of the right-hand side.
//!
//! **No zero at all.** Often that is seen at once. A negative term between the first and the last, both positive,
//! k = θ k₁ + (1−θ) k₂, never outweighs them if d ≤ (d₁/θ)^θ (d₂/(1−θ))^(1−θ), by the inequality between weighted
//! means; several do not if each is below its share of that. For three terms the condition is also necessary (S.
//! Iliman, T. de Wolff, Res. Math. Sci. 3 (2016), doi 10.1186/s40687-016-0052-2, call the right-hand side the
//! circuit number).
//!
//! **Bounds.** Below x₀, where each of the N−1 other terms is less than 1/N of the first, f > 0. Above x₁,
//! where each is less than 1/N of the last, f has the sign of the last term. So the march runs from x₀ to x₁,
//! or for ever if the last coefficient is negative: then there is a zero.
//!
//! **Termination.** Near a simple zero h is a Newton step; near a double zero, or a minimum just above zero,
//! the distance shrinks by a constant factor; elsewhere f is bounded below on the compact interval and so is
//! h. The march ends where f is positive by less than its own rounding. If it should still run after
//! `MOST_STEPS`, the range is cut where it stands: never too long, at worst too short.

use crate::Scalar;
use crate::parameters::Parameters;
use crate::profile::ProfileError;
use crate::scalar::smallest_normal;

const MOST_STEPS: u32 = 20_000;

/// Checks the terms (C, n) of a gap and returns the end of its admissible range.
///
/// Inlined, because exponents are mostly constants: what is asked of a positive term is then two comparisons.
///
/// # Errors
///
/// [`ProfileError`] for coefficients or exponents that are not usable, too small ones among them, and for a gap that does not open.
#[inline(always)]
fn admissible_range<T: Scalar>(terms: impl Iterator<Item = (T, T)> + Clone) -> Result<T, ProfileError> {
    if is_sum_of_positive_terms(terms.clone()) { Ok(T::infinity()) } else { searched_range(terms) }
}

/// Whether the terms are usable, none of them is negative, and one is positive.
#[inline(always)]
fn is_sum_of_positive_terms<T: Scalar>(terms: impl Iterator<Item = (T, T)>) -> bool {
    // Whether twice this is finite is not asked of the bits of every coefficient.
    let most = smallest_normal::<T>().recip();
    let (are_usable, opens) = terms.fold((true, false), |(are_usable, opens), (c, n)| {
        let is_positive = has_digits(c, n) & (c <= most);
        (are_usable & is_exponent(n) & (is_positive | c.is_zero()), opens | is_positive)
    });
    are_usable & opens
}

/// The end of the range if there may be a fault among the terms, or a negative one.
#[inline(never)]
fn searched_range<T: Scalar>(terms: impl Iterator<Item = (T, T)> + Clone) -> Result<T, ProfileError> {
    let mut smallest = T::infinity();
    for (c, n) in terms.clone() {
        if !is_exponent(n) {
            return Err(ProfileError::InvalidExponent { exponent: n.value() });
        }
        check_coefficient(c, n)?;
        if !c.is_zero() {
            smallest = smallest.min(n);
        }
    }
    if !smallest.is_finite() {
        return Err(ProfileError::Empty);
    }
    let leading = coefficient_of(terms.clone(), smallest);
    if leading <= T::zero() {
        return Err(ProfileError::NotOpening {
            exponent: smallest.value(),
            coefficient: leading.value(),
            parameters: Parameters::default(),
        });
    }
    Ok(Slope { terms, smallest }.first_zero())
}

#[inline(always)]
fn is_exponent<T: Scalar>(n: T) -> bool {
    (n > T::zero()) & (n <= T::constant(1024.0))
}

/// Checks that the coefficients of constant terms (C, n) fit the format that they are used in; no constant is zero
/// unless the format has made it so.
///
/// # Errors
///
/// [`ProfileError::InvalidCoefficient`] for the first that does not.
pub fn check_coefficients<T: Scalar>(terms: impl IntoIterator<Item = (T, T)>) -> Result<(), ProfileError> {
    terms.into_iter().try_for_each(|(c, n)| if fits(c, n) { Ok(()) } else { Err(invalid(c, n)) })
}

/// [`check_coefficients`] of numbers.
///
/// # Errors
///
/// As [`check_coefficients`].
pub fn check_constants<T: Scalar>(terms: &[(f64, f64)]) -> Result<(), ProfileError> {
    check_coefficients(terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))))
}

fn check_coefficient<T: Scalar>(c: T, n: T) -> Result<(), ProfileError> {
    if c.is_zero() || fits(c, n) { Ok(()) } else { Err(invalid(c, n)) }
}

fn invalid<T: Scalar>(c: T, n: T) -> ProfileError {
    let parameters = Parameters::default();
    ProfileError::InvalidCoefficient { coefficient: c.value(), exponent: n.value(), parameters }
}

/// Whether C is a number and keeps its digits; twice C is the largest multiple of it in the closed forms.
fn fits<T: Scalar>(c: T, n: T) -> bool {
    (T::constant(2.0) * c).is_finite() && has_digits(c.abs(), n)
}

/// Whether C > 0 and C n keep all their digits when they are divided by 2 (n+2)², up to 2²¹, on the way to the kernels.
#[inline(always)]
fn has_digits<T: Scalar>(c: T, n: T) -> bool {
    let weight = n.min(T::one()) / ((n + T::constant(2.0)) * (n + T::constant(2.0)));
    c * weight >= smallest_normal::<T>() * T::constant(2.0)
}

/// The end of the range of a geometry that is asked for up to `requested`, if at all.
///
/// # Errors
///
/// [`ProfileError`] as `admissible_range`, and if `requested` is not positive or lies beyond the range.
#[inline(always)]
pub fn checked_range<T: Scalar>(
    terms: impl Iterator<Item = (T, T)> + Clone,
    requested: Option<T>,
) -> Result<T, ProfileError> {
    let end = admissible_range(terms)?;
    match requested {
        None => Ok(end),
        Some(max_radius) if !(max_radius > T::zero() && max_radius.is_finite()) => {
            Err(ProfileError::InvalidMaxRadius {
                max_radius: max_radius.value(),
                parameters: Parameters::default(),
            })
        }
        Some(max_radius) if max_radius >= end => Err(ProfileError::NotAdmissible {
            max_radius: max_radius.value(),
            fails_at: end.value(),
            parameters: Parameters::default(),
        }),
        Some(max_radius) => Ok(max_radius),
    }
}

/// The end of a range if it lies inside every surface: |κ| ρ² < R² for all pairs (R, κ), so that their series
/// converge; ρ is the end.
///
/// # Errors
///
/// [`ProfileError`] if it does not, and that of the range if there is none.
pub fn inside_surfaces<T: Scalar, const N: usize>(
    range: Result<T, ProfileError>,
    surfaces: [(T, T); N],
) -> Result<T, ProfileError> {
    let end = range?;
    let rim = |(radius, shape): (T, T)| radius.abs() / shape.abs().sqrt();
    let is_inside = |rim: &T| end < *rim;
    match surfaces.into_iter().map(rim).find(|rim| !is_inside(rim)) {
        None => Ok(end),
        Some(rim) => Err(ProfileError::BeyondSurface {
            max_radius: end.value(),
            rim: rim.value(),
            parameters: Parameters::default(),
        }),
    }
}

/// Checks the fields that a geometry declares positive.
///
/// # Errors
///
/// [`ProfileError::NotPositive`] for the first that is not a finite number above 0.
pub fn check_positive<T: Scalar, const N: usize>(
    names: &[&'static str; N],
    values: [T; N],
) -> Result<(), ProfileError> {
    match names.iter().zip(values).find(|(_, value)| !(*value > T::zero() && value.is_finite())) {
        None => Ok(()),
        Some((field, value)) => Err(ProfileError::NotPositive { field, value: value.value() }),
    }
}

/// The end of a range that nothing but its own sign can spoil; 0 if that does, or if it is not a number.
#[inline]
pub fn not_below_zero<T: Scalar>(end: T) -> T {
    if end > T::zero() { end } else { T::zero() }
}

/// The sum of all coefficients of r^n, which a caller may have given in several terms.
fn coefficient_of<T: Scalar>(terms: impl Iterator<Item = (T, T)>, n: T) -> T {
    terms.filter(|&(_, exponent)| exponent == n).fold(T::zero(), |sum, (c, _)| sum + c)
}

/// δ₀′ as a sum of exponentials of x = ln r.
struct Slope<I, T> {
    terms: I,
    smallest: T,
}

/// f, f′ and a bound of |f″| on [x, x + ρ], and the sum of the sizes of the terms of f, in a common scale.
struct Expansion<T> {
    value: T,
    slope: T,
    curvature: T,
    size: T,
}

impl<T: Scalar, I: Iterator<Item = (T, T)> + Clone> Slope<I, T> {
    /// The terms (d, n − n₁) with d ≠ 0.
    fn exponentials(&self) -> impl Iterator<Item = (T, T)> + Clone + '_ {
        let two = T::constant(2.0);
        let shifted = move |(c, n): (T, T)| (c * (two * n / (n + two)), n - self.smallest);
        self.terms.clone().map(shifted).filter(|(d, _)| !d.is_zero())
    }

    fn first_zero(&self) -> T {
        let span = self.exponentials().fold(T::zero(), |most, (_, k)| most.max(k));
        if self.is_positive_by_its_ends(span) {
            return T::infinity();
        }
        let step = span.recip();
        let rounding = T::default_epsilon() * T::constant(4.0);
        let end = self.last_term_dominates_from(span);
        let mut x = self.first_term_dominates_up_to();
        for _ in 0..MOST_STEPS {
            if end.is_some_and(|end| x >= end) {
                return T::infinity();
            }
            let here = self.expansion(x, step);
            if here.value <= here.size * rounding {
                break;
            }
            let safe = here.safe_step().min(step);
            if safe <= rounding * x.abs() {
                break;
            }
            x += safe;
        }
        x.exp()
    }

    /// Whether the first and the last term outweigh the negative ones between them wherever that may be.
    ///
    /// Compared as logarithms; what is too close for them to tell is left to the march.
    fn is_positive_by_its_ends(&self, span: T) -> bool {
        let (zero, one) = (T::zero(), T::one());
        let ends = (zero, zero, zero);
        let (first, last, count) = self.exponentials().fold(ends, |(first, last, count), (d, k)| {
            let at = |exponent| if k == exponent { d } else { zero };
            (first + at(zero), last + at(span), count + if d < zero { one } else { zero })
        });
        if last <= zero {
            return false;
        }
        let (log_first, log_last, log_count) = (first.ln(), last.ln(), count.ln());
        let rounding = T::default_epsilon() * T::constant(16.0);
        self.exponentials().filter(|&(d, _)| d < zero).all(|(d, k)| {
            let weight = k / span;
            let rest = one - weight;
            let (of_first, of_last) = (rest * (log_first - rest.ln()), weight * (log_last - weight.ln()));
            let log_size = (-d).ln() + log_count;
            let size = log_size.abs() + log_first.abs() + log_last.abs() + one;
            log_size + rounding * size < of_first + of_last
        })
    }

    /// x₀: every other term is below 1/N of the first.
    fn first_term_dominates_up_to(&self) -> T {
        let first = coefficient_of(self.exponentials(), T::zero());
        let count = T::constant(self.exponentials().count() as f64);
        self.exponentials()
            .filter(|&(_, k)| k > T::zero())
            .fold(T::infinity(), |x, (d, k)| x.min((first.ln() - count.ln() - d.abs().ln()) / k))
    }

    /// x₁: every other term is below 1/N of the last; none if the last coefficient is not positive.
    fn last_term_dominates_from(&self, span: T) -> Option<T> {
        let last = coefficient_of(self.exponentials(), span);
        let count = T::constant(self.exponentials().count() as f64);
        (last > T::zero()).then(|| {
            self.exponentials()
                .filter(|&(_, k)| k < span)
                .fold(-T::infinity(), |x, (d, k)| x.max((count.ln() + d.abs().ln() - last.ln()) / (span - k)))
        })
    }

    fn expansion(&self, x: T, step: T) -> Expansion<T> {
        let log_size = |(d, k): (T, T)| d.abs().ln() + k * x;
        let scale = self.exponentials().map(log_size).fold(-T::infinity(), T::max);
        let zero = T::zero();
        let mut sum = Expansion { value: zero, slope: zero, curvature: zero, size: zero };
        for (d, k) in self.exponentials() {
            let size = (log_size((d, k)) - scale).exp();
            let value = size.copysign(d);
            sum.value += value;
            sum.slope += k * value;
            sum.curvature += k * k * size * (k * step).exp();
            sum.size += size;
        }
        sum
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

    fn range(terms: &[(f64, f64)]) -> f64 {
        admissible_range(terms.iter().copied()).unwrap_or(f64::NAN)
    }

    #[test]
    fn zeros_are_those_of_the_slope() {
        // δ₀′ = c₂ a + (4/3) c₄ a³ vanishes at a² = −3 c₂/(4 c₄).
        let expected = (0.75 * 0.025 / 1e-4_f64).sqrt();
        let found = range(&[(-1e-4, 4.0), (0.025, 2.0)]);
        assert!((found / expected - 1.0).abs() < 1e-14, "{found}");
        assert!(found <= expected * (1.0 + 4.0 * f64::EPSILON));
    }

    #[test]
    fn negative_terms_need_not_limit_the_range() {
        assert_eq!(range(&[(0.05, 2.0), (-0.004, 3.0), (2e-4, 4.0)]), f64::INFINITY);
        assert_eq!(range(&[(0.025, 2.0), (1e-4, 4.0)]), f64::INFINITY);
    }

    #[test]
    fn a_touching_zero_is_found_and_a_near_miss_is_not() {
        // δ₀′ ∝ a (1 − 2 b a + a²) in units where d₂ = d₄ = 1: double zero at a = 1 for b = 1.
        let geometry = |b: f64| [(1.0, 2.0), (-2.0 * b * 5.0 / 6.0, 3.0), (0.75, 4.0)];
        let touching = range(&geometry(1.0));
        assert!((touching - 1.0).abs() < 1e-6, "{touching}");
        assert_eq!(range(&geometry(1.0 - 1e-9)), f64::INFINITY);
        let crossing = range(&geometry(1.0 + 1e-9));
        assert!((crossing - 1.0).abs() < 1e-4, "{crossing}");
    }

    #[test]
    fn extreme_coefficients_do_not_overflow() {
        let found = range(&[(1e300, 2.0), (-1e-300, 64.0)]);
        let expected = 10f64.powf((600.0 + (33.0_f64 / 64.0).log10()) / 62.0);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found:e} {expected:e}");
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(admissible_range([].into_iter().map(|x: (f64, f64)| x)), Err(ProfileError::Empty));
        assert!(matches!(
            admissible_range([(-1.0, 2.0), (1.0, 4.0)].into_iter()),
            Err(ProfileError::NotOpening { exponent: 2.0, .. })
        ));
        assert!(matches!(
            checked_range([(0.025, 2.0), (-1e-4, 4.0)].into_iter(), Some(14.0)),
            Err(ProfileError::NotAdmissible { .. })
        ));
    }
}
