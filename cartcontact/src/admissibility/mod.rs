//! Whether a geometry known at run time is admissible, and up to which radius.

mod fields;
mod first_zero;

use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::profile::{Parameters, ProfileError};
use crate::scalar::smallest_normal;
pub use fields::{check_positive, check_product, check_range_of_fields};
use first_zero::Slope;

/// Checks the terms (C, n) of a gap and returns the end of its admissible range, or infinity if the end is known to lie
/// beyond the `requested` radius.
///
/// Inlined, because exponents are mostly constants: a positive term then takes two comparisons.
///
/// # Errors
///
/// [`ProfileError`] for coefficients or exponents that are not usable, including too small ones, and for a gap that
/// does not open.
#[inline(always)]
fn admissible_range<T: Scalar>(terms: impl AsRef<[(T, T)]>, requested: Option<T>) -> Result<T, ProfileError> {
    if is_sum_of_positive_terms(terms.as_ref()) {
        return Ok(T::infinity());
    }
    // Moved, so that terms are written to memory only there.
    out_of_line(move || searched_range(terms.as_ref(), requested))
}

/// Whether the terms are usable, none of them is negative, and one is positive.
#[inline(always)]
fn is_sum_of_positive_terms<T: Scalar>(terms: &[(T, T)]) -> bool {
    // Up to this, twice c is finite, which spares a test of the bits of every coefficient.
    let most = smallest_normal::<T>().recip();
    let mut opens = false;
    // A loop is inlined into every caller; functions of iterators are not where it is large.
    for &(c, n) in terms {
        if has_digits(c, n) && c <= most {
            opens = true;
        } else if !c.is_zero() {
            return false;
        }
        if !is_exponent(n) {
            return false;
        }
    }
    opens
}

/// The end of the range where a term may be faulty or negative.
fn searched_range<T: Scalar>(terms: &[(T, T)], requested: Option<T>) -> Result<T, ProfileError> {
    let mut smallest = T::infinity();
    for &(c, n) in terms {
        if !is_exponent(n) {
            return Err(ProfileError::InvalidExponent { exponent: n.value() });
        }
        if !c.is_zero() {
            if !fits(c, n) {
                return Err(invalid(c, n));
            }
            smallest = smallest.min(n);
        }
    }
    if !smallest.is_finite() {
        return Err(ProfileError::Empty);
    }
    let slope = Slope { terms, smallest };
    let is_beyond = requested.is_some_and(|radius| slope.first_outweighs_negative_up_to(radius));
    let end = if is_beyond { T::infinity() } else { slope.first_zero() };
    if end > T::zero() {
        return Ok(end);
    }
    Err(ProfileError::NotOpening {
        exponent: smallest.value(),
        coefficient: coefficient_of(terms, smallest).value(),
        parameters: Parameters::default(),
    })
}

/// The sum of all coefficients of r^n, which a caller may have given in several terms.
fn coefficient_of<T: Scalar>(terms: &[(T, T)], n: T) -> T {
    terms.iter().filter(|(_, exponent)| *exponent == n).fold(T::zero(), |sum, &(c, _)| sum + c)
}

/// The highest exponent, as at compile time: at 0.999 of the radius where it is 1, r^1024 is 0.36, and beyond that a
/// contact cannot tell it from a step.
const HIGHEST_EXPONENT: f64 = 1024.0;

#[inline(always)]
fn is_exponent<T: Scalar>(n: T) -> bool {
    (n > T::zero()) & (n <= T::constant(HIGHEST_EXPONENT))
}

/// Checks that the coefficients of constant terms (C, n) fit the format that they are used in. No constant is zero
/// unless the format has rounded it to zero.
///
/// # Errors
///
/// [`ProfileError::InvalidCoefficient`] for the first that does not.
pub fn check_coefficients<T: Scalar>(terms: impl IntoIterator<Item = (T, T)>) -> Result<(), ProfileError> {
    terms.into_iter().try_for_each(|(c, n)| if fits(c, n) { Ok(()) } else { Err(invalid(c, n)) })
}

/// [`check_coefficients`] for terms in f64.
///
/// # Errors
///
/// As [`check_coefficients`].
pub fn check_constants<T: Scalar>(terms: &[(f64, f64)]) -> Result<(), ProfileError> {
    check_coefficients(terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))))
}

/// What is wrong with a term that does not fit: its exponent, if no coefficient of usual size would fit.
fn invalid<T: Scalar>(c: T, n: T) -> ProfileError {
    let (exponent, parameters) = (n.value(), Parameters::default());
    if !fits(T::one(), n) {
        return ProfileError::InvalidExponent { exponent };
    }
    ProfileError::InvalidCoefficient { coefficient: c.value(), exponent, parameters }
}

/// Whether C is a number and keeps its digits; twice C is the largest multiple of it in the closed forms.
fn fits<T: Scalar>(c: T, n: T) -> bool {
    (T::constant(2.0) * c).is_finite() && has_digits(c.abs(), n)
}

/// Whether C > 0 and C n keep all their digits when they are divided by 2 (n+2)², up to 2²¹, on the way to the kernels.
#[inline(always)]
fn has_digits<T: Scalar>(c: T, n: T) -> bool {
    let divisor = (n + T::constant(2.0)) * (n + T::constant(2.0)) / n.min(T::one());
    c >= smallest_normal::<T>() * T::constant(2.0) * divisor
}

/// The end of the range of a geometry, up to the `requested` radius if there is a finite one.
///
/// # Errors
///
/// [`ProfileError`] as `admissible_range`, and if `requested` is not positive or lies beyond the range.
#[inline(always)]
pub fn checked_range<T: Scalar>(
    terms: impl AsRef<[(T, T)]>,
    requested: Option<T>,
) -> Result<T, ProfileError> {
    let requested = requested.filter(|&max_radius| max_radius != T::infinity());
    let end = admissible_range(terms, requested)?;
    match requested {
        None => Ok(end),
        Some(max_radius) if max_radius > end => Err(ProfileError::NotAdmissible {
            max_radius: max_radius.value(),
            fails_at: end.value(),
            parameters: Parameters::default(),
        }),
        Some(max_radius) if max_radius > T::zero() => Ok(max_radius),
        Some(max_radius) => Err(ProfileError::InvalidMaxRadius {
            max_radius: max_radius.value(),
            parameters: Parameters::default(),
        }),
    }
}

/// The end ρ of a range if it lies inside every surface: |κ| ρ² < R² for all pairs (R, κ), so that their series
/// converge.
///
/// # Errors
///
/// [`ProfileError`] if it does not, and the error of `range` if there is no range.
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

/// The end of a range of which only the sign can be wrong; 0 if it is negative or NaN.
#[inline]
pub fn not_below_zero<T: Scalar>(end: T) -> T {
    if end > T::zero() { end } else { T::zero() }
}

/// The proved end of a range, in a format that may have to round it: down, as nothing is known beyond.
#[inline]
pub fn not_above<T: Scalar>(end: f64) -> T {
    let nearest = T::constant(end);
    if nearest.value() > end { nearest * (T::one() - T::default_epsilon()) } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(terms: &[(f64, f64)]) -> f64 {
        admissible_range(terms, None).unwrap_or(f64::NAN)
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

    /// δ₀′ ∝ a (1 − 3 a + a²): either half of the term between would leave it positive, by the inequality of means, but
    /// not both.
    #[test]
    fn several_negative_terms_share_what_the_ends_allow() {
        let expected = (3.0 - 5f64.sqrt()) / 2.0;
        let found = range(&[(1.0, 2.0), (-1.25, 3.0), (-1.25, 3.0), (0.75, 4.0)]);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found}");
        let found = range(&[(1.0, 2.0), (-1.25, 2.875), (-1.25, 3.125), (0.75, 4.0)]);
        assert!((found / expected - 1.0).abs() < 0.1, "{found}");
    }

    #[test]
    fn extreme_coefficients_do_not_overflow() {
        let found = range(&[(1e300, 2.0), (-1e-300, 64.0)]);
        let expected = 10f64.powf((600.0 + (33.0_f64 / 64.0).log10()) / 62.0);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found:e} {expected:e}");
    }

    /// A requested range is not searched for where the first term outweighs the others; the answer is the same.
    #[test]
    fn a_requested_range_is_the_one_that_a_search_finds() {
        for terms in [
            &[(0.025, 2.0), (-1e-4, 4.0)][..],
            &[(0.05, 2.0), (-0.009, 3.0), (2e-4, 4.0)],
            &[(0.05, 2.0), (1e-3, 3.0), (-1e-5, 4.5), (-1e-9, 12.0)],
            &[(0.05, 2.0), (-0.04, 2.0), (-1e-3, 2.25)],
        ] {
            let end = range(terms);
            assert!(end.is_finite(), "{terms:?}");
            for share in [1e-3, 0.5, 0.9, 0.999, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.001, 2.0, 1e3] {
                let found = checked_range(terms, Some(share * end));
                assert_eq!(found.is_ok(), share <= 1.0, "{terms:?} up to {share} of {end}: {found:?}");
            }
        }
    }

    /// No range reaches `zero`, where δ₀′ vanishes, or ends long before it; the same holds for requested ranges.
    fn assert_ends_at(terms: &[(f64, f64)], zero: f64, tolerance: f64) {
        let end = range(terms);
        assert!(end <= zero && end > zero * (1.0 - tolerance), "{terms:?}: {end:e} instead of {zero:e}");
        let request = |radius| checked_range(terms, Some(radius));
        assert!(request(zero).is_err(), "{terms:?} up to {zero:e}");
        assert!(request(zero * (1.0 - tolerance)).is_ok(), "{terms:?} up to nearly {zero:e}");
    }

    /// 2 C n/(n+2) is the same for C = 4 + h of r^(2+h) as for C = 4 + 2 h of r².
    #[test]
    fn ranges_of_two_terms_do_not_reach_the_zero() {
        for h in (1..64).map(|j| f64::from(j) / 256.0) {
            for k in 1..50 {
                let k = f64::from(k);
                // Multiples of a number with few digits are exact; logarithms of coefficients just below 1 are near 0.
                for scale in [k.powi(16) * 1e-25, (1.0 - 1e-6 * k) / (4.0 + 2.0 * h)] {
                    let scale = f64::from(scale as f32);
                    let terms = [((4.0 + 2.0 * h) * scale, 2.0), (-(4.0 + h) * scale, 2.0 + h)];
                    assert_ends_at(&terms, 1.0, 2e-13 * (1.0 + 1.0 / h));
                }
            }
        }
    }

    /// A part δ of r³ remains, whose slope is that of 3 δ/4 of r⁸.
    #[test]
    fn ranges_of_terms_that_cancel_do_not_reach_the_zero() {
        let delta = 2f64.powi(-30);
        for k in 1..200 {
            let c = f64::from(k) / 7.0;
            let (first, least) = (c, c - delta);
            let rest = first - least;
            let split = (0.25 * least, least - 0.25 * least);
            let last = (-0.75 * rest, 8.0);
            assert_ends_at(&[(first, 3.0), (-least, 3.0), last], 1.0, 1e-4);
            assert_ends_at(&[(first, 3.0), (-split.0, 3.0), (-split.1, 3.0), last], 1.0, 1e-4);
        }
    }

    /// r², r⁴ and r⁶ with 2 C n/(n+2) = a + 3 b, −a and −3 b in units of any length and force.
    #[test]
    fn ranges_in_extreme_units_do_not_reach_the_zero() {
        for k in 1..40 {
            let (a, b) = (f64::from(k), f64::from(41 - k));
            for (length, force) in [(0, 0), (30, 0), (-40, 200), (100, -300), (-150, -400), (140, 500)] {
                let unit = |power: i32| 2f64.powi(force - power * length);
                let terms =
                    [((a + 3.0 * b) * unit(0), 2.0), (-0.75 * a * unit(2), 4.0), (-2.0 * b * unit(4), 6.0)];
                assert_ends_at(&terms, 2f64.powi(length), 1e-11);
            }
        }
    }

    /// r², r⁴ and r⁶ with 2 C n/(n+2) = p², −2 p q and q², all exact: δ₀′ touches zero at √(p/q). The larger a logarithm
    /// is, the more its rounding could hide that.
    #[test]
    fn ranges_do_not_pass_a_zero_without_a_change_of_sign() {
        for unit in [1.0, 2f64.powi(-300), 2f64.powi(300)] {
            for p in (1..40).map(f64::from) {
                for q in (3..90).step_by(3).map(f64::from) {
                    let terms = [(p * p * unit, 2.0), (-1.5 * p * q * unit, 4.0), (q * q / 1.5 * unit, 6.0)];
                    assert_ends_at(&terms, (p / q).sqrt(), 2e-6);
                }
            }
        }
    }

    /// r², r^(2+h) and r⁴ with 2 C n/(n+2) = 1/50, 1 and −51/50: the second term outweighs the first down to 50^(−1/h).
    #[test]
    fn exponents_next_to_the_first_do_not_shorten_the_range() {
        for h in [0.1, 0.01, 1e-3, 1e-4, 1e-5] {
            let terms = [(0.02, 2.0), ((4.0 + h) / (4.0 + 2.0 * h), 2.0 + h), (-0.75 * 1.02, 4.0)];
            // The rounding of the coefficients moves the zero.
            assert_ends_at(&terms, 1.0 + 1e-15, 1e-13);
        }
    }

    #[test]
    fn a_proved_end_is_rounded_down() {
        for end in [0.1, 0.3, 1.0 / 3.0, 6.0, 1e-3, 1e3 + 1e-9, 5.5] {
            let (single, nearest) = (f64::from(not_above::<f32>(end)), f64::from(end as f32));
            assert!(single <= end && end - single <= 2.0 * f64::from(f32::EPSILON) * end, "{end}: {single}");
            assert!(nearest > end || single == nearest, "{end}: {single}");
            assert_eq!(not_above::<f64>(end), end);
        }
    }

    #[test]
    fn powers_below_the_format_are_not_taken_for_nothing() {
        // The zero is at 1e-300, and at 1e-25.
        assert!(checked_range([(1e-300, 2.0), (-1e300, 4.0)], Some(1e-200)).is_err());
        assert!(checked_range([(1e-20_f32, 2.0), (-1e30, 4.0)], Some(1e-23)).is_err());
    }

    /// The rounded slopes add up to less than zero.
    #[test]
    fn a_leading_coefficient_that_is_all_rounding_gives_no_range() {
        for k in 1..1000 {
            let c = 1.0 + f64::from(k) * f64::EPSILON;
            let terms = [(c, 3.5), (-0.3, 3.5), (-0.7, 3.5), (-1.0, 4.0)];
            // As f64, 0.3 and 0.7 add up to a quarter of an ε less than 1.
            let left = c - 1.0 + 0.25 * f64::EPSILON;
            match admissible_range(terms, None) {
                Ok(end) => assert!(0.0 < end && end <= left * left, "{c}: {end:e}"),
                Err(error) => {
                    assert!(k < 20 && matches!(error, ProfileError::NotOpening { .. }), "{c}: {error}");
                }
            }
        }
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(admissible_range::<f64>([], None), Err(ProfileError::Empty));
        assert!(matches!(
            admissible_range([(-1.0, 2.0), (1.0, 4.0)], None),
            Err(ProfileError::NotOpening { exponent: 2.0, .. })
        ));
        assert!(matches!(
            checked_range([(0.025, 2.0), (-1e-4, 4.0)], Some(14.0)),
            Err(ProfileError::NotAdmissible { .. })
        ));
    }
}
