//! Load integral → contact radius: J(a) = y solved for a.
//!
//! | module | for | how |
//! |---|---|---|
//! | [`table::curves`] | constants of fractional powers, or of many | a polynomial from a row of the macro's table |
//! | [`table`] | other constants; fields that set units | a row of the macro's table, and one step of [`halley`] |
//! | [`table::roots`] | one term | a root from a table, and a series |
//! | [`whole_powers`], [`real_powers`] | other sums of positive terms | [`leading_term`], and a fixed number of steps of [`halley`] |
//! | [`one_term`] | one term, whatever the load integral | the root, Eq. (18) |
//! | [`newton`] | all else | Newton's method inside a bracket |
//!
//! The first row that applies is tried. Load integrals that it cannot handle (outside its table, zero, NaN, beyond the
//! range) go [`out_of_line`](crate::dispatch::out_of_line): those outside a table of sums to the fourth row where that
//! applies, all others to the last two, which also name the fault. [`blocks`] finds many radii in vector code.

mod blocks;
mod halley;
mod leading_term;
pub(crate) mod newton;
pub(crate) mod one_term;
pub(crate) mod real_powers;
pub(crate) mod table;
pub(crate) mod whole_powers;

use crate::Scalar;
use crate::profile::RadiusError;
use crate::scalar::is_finite_and_positive;

/// Whether the radius has to be searched for: a load integral of zero has the radius zero.
///
/// # Errors
///
/// [`RadiusError`] for a load integral that is negative or not finite, and for any positive one if `limit` is not
/// positive.
fn needs_search<T: Scalar>(target: T, limit: T) -> Result<bool, RadiusError> {
    if target.is_zero() {
        Ok(false)
    } else if !is_finite_and_positive(target) {
        Err(RadiusError::InvalidLoadIntegral { load_integral: target.value() })
    } else if limit > T::zero() {
        Ok(true)
    } else {
        Err(beyond(target, T::zero(), limit))
    }
}

fn beyond<T: Scalar>(target: T, largest: T, limit: T) -> RadiusError {
    RadiusError::BeyondRange {
        load_integral: target.value(),
        largest: largest.value(),
        max_radius: limit.value(),
    }
}

#[cfg(test)]
mod tests {
    use super::newton::invert;
    use super::one_term::invert_one_term;
    use super::*;

    /// The radius by the two general solutions, for J = a⁶.
    fn radii(load_integral: f64, limit: f64) -> [Result<f64, RadiusError>; 2] {
        let (c, n) = (12.0, 2.0);
        let power = |a: f64| a.powi(6);
        let evaluate = |a| (power(a), 6.0 * power(a));
        let by_steps = invert(load_integral, limit, [(c, n)], false, evaluate, power);
        [by_steps, invert_one_term(load_integral, (c, n), limit)]
    }

    #[test]
    fn what_is_not_a_load_integral_is_refused() {
        for bad in [-1.0, f64::NAN, f64::INFINITY, -f64::INFINITY] {
            for found in radii(bad, f64::INFINITY) {
                assert!(matches!(found, Err(RadiusError::InvalidLoadIntegral { .. })), "{bad}");
            }
        }
        assert_eq!(radii(0.0, f64::INFINITY), [Ok(0.0), Ok(0.0)]);
    }

    #[test]
    fn there_is_no_radius_in_a_range_that_is_none() {
        for limit in [0.0, -1.0, -f64::INFINITY, f64::NAN] {
            for found in radii(1.0, limit) {
                assert!(matches!(found, Err(RadiusError::BeyondRange { largest: 0.0, .. })), "{found:?}");
            }
        }
    }

    /// The sixth powers of these ends are exact.
    #[test]
    fn the_end_of_the_range_is_inside() {
        for k in 1..256 {
            let end = f64::from(k) / 8.0;
            let largest = end.powi(6);
            for found in radii(largest, end) {
                let is_end = |a: f64| a <= end && a > end * (1.0 - 2.0 * f64::EPSILON);
                assert!(found.is_ok_and(is_end), "{end}: {found:?}");
            }
            for found in radii(largest * (1.0 + 1e-14), end) {
                let beyond = matches!(found, Err(RadiusError::BeyondRange { .. }));
                assert!(beyond, "{end}: {found:?}");
            }
        }
    }
}
