//! Whether the values of fields, and the coefficients that are products of them, fit the format of a contact.

use super::invalid;
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::profile::ProfileError;
use crate::scalar::{is_finite_and_positive, smallest_normal};

/// Checks the fields that a geometry declares positive.
///
/// # Errors
///
/// [`ProfileError::NotPositive`] for the first that is not a finite number above 0.
pub fn check_positive<T: Scalar, const N: usize>(
    names: &[&'static str; N],
    values: [T; N],
) -> Result<(), ProfileError> {
    match names.iter().zip(values).find(|(_, value)| !is_finite_and_positive(*value)) {
        None => Ok(()),
        Some((field, value)) => Err(ProfileError::NotPositive { field, value: value.value() }),
    }
}

/// Checks that fields in f64 are in the range of the format in which they are used. What is not finite is left to the
/// checks of what follows from it.
///
/// # Errors
///
/// [`ProfileError::OutOfFormat`] for the first that the format rounds by more than half its ε.
#[inline]
pub fn check_range_of_fields<T: Scalar, const N: usize>(
    names: &[&'static str; N],
    values: [f64; N],
) -> Result<(), ProfileError> {
    let rounding = T::default_epsilon().value() * 0.5;
    let is_kept = |value: f64| (T::constant(value).value() - value).abs() <= rounding * value.abs();
    match names.iter().zip(values).find(|(_, value)| value.is_finite() && !is_kept(*value)) {
        None => Ok(()),
        Some((field, value)) => Err(ProfileError::OutOfFormat { field, value }),
    }
}

/// Checks that the coefficient C of a term (C, n) is not zero, as if the term were absent, because the format has rounded
/// a product in it to zero, one of `factors` and inverses of `divisors`, or a product that it is divided by to infinity.
/// Products that cancel are no fault.
///
/// # Errors
///
/// [`ProfileError::InvalidCoefficient`] if C is zero and the product, too, or below the normal numbers, although no
/// factor is zero and no divisor infinite; or if the product is infinite although no factor is and no divisor is zero.
#[inline]
pub fn check_product<T: Scalar, const FACTORS: usize, const DIVISORS: usize>(
    (c, n): (T, T),
    product: impl FnOnce() -> T,
    factors: [T; FACTORS],
    divisors: [T; DIVISORS],
) -> Result<(), ProfileError> {
    let is_absent = || factors.iter().any(T::is_zero) || divisors.iter().any(|divisor| !divisor.is_finite());
    let is_infinite = || !factors.iter().all(T::is_finite) || divisors.iter().any(T::is_zero);
    let is_rounded = || {
        let product = product();
        if product.is_finite() { product.abs() < smallest_normal() && !is_absent() } else { !is_infinite() }
    };
    if c.is_zero() && out_of_line(is_rounded) { Err(invalid(c, n)) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_precision_refuses_what_it_does_not_hold() {
        let check = |value| check_range_of_fields::<f32, 2>(&["fine", "field"], [0.1, value]);
        for value in [0.0, 1.0 / 3.0, -1e38, f64::from(f32::MIN_POSITIVE), f64::INFINITY, f64::NAN] {
            assert_eq!(check(value), Ok(()), "{value:e}");
        }
        for value in [1e-60, -1e-60, 1e-320, 1.234_567_8e-42, 1e-39, 1e39, -1e300] {
            assert_eq!(check(value), Err(ProfileError::OutOfFormat { field: "field", value }), "{value:e}");
            assert_eq!(check_range_of_fields::<f64, 1>(&["field"], [value]), Ok(()), "{value:e}");
        }
    }

    #[test]
    fn products_are_zero_only_if_a_factor_is() {
        let check = |(c, product): (f64, f64), factors: [f64; 2], divisors: [f64; 1]| {
            check_product((c, 2.0), || product, factors, divisors).is_ok()
        };
        assert!(check((1e-300, 1e-300), [1e-150, 1e-150], [1.0]));
        assert!(!check((0.0, 0.0), [1e-200, 1e-200], [1.0]));
        assert!(!check((-0.0, -0.0), [1.0, -1.0], [f64::MAX]));
        assert!(check((0.0, 0.0), [1.0, 0.0], [1.0]));
        assert!(check((0.0, 0.0), [1.0, 1.0], [f64::INFINITY]));
        // Products that the coefficient is divided by.
        assert!(!check((0.0, f64::INFINITY), [1e200, 1e200], [1.0]));
        assert!(check((0.0, f64::INFINITY), [1e200, f64::INFINITY], [1.0]));
        assert!(check((0.0, f64::INFINITY), [1.0, 1.0], [0.0]));
        // What cancels is left out, unless it is nothing but rounding.
        assert!(check((0.0, 1e-300), [1e-150, 1e-150], [1.0]));
        assert!(!check((0.0, -5e-324), [1e-162, -5e-162], [1.0]));
    }
}
