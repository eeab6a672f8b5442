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
