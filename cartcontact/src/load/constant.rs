//! A load applied at once and held.

use super::{Load, LoadError};
use crate::Scalar;
use crate::scalar::is_finite_and_not_negative;

/// A load of the given force, in N, applied at t = 0 and held for ever.
///
/// # Examples
///
/// ```
/// use cartcontact::load::{Constant, Load};
///
/// assert_eq!(Constant(100.0).impulse(3.0), 300.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<T>(
    /// The force, in N.
    pub T,
);

impl<T: Scalar> Load<T> for Constant<T> {
    #[inline(always)]
    fn force(&self, _t: T) -> T {
        self.0
    }

    #[inline(always)]
    fn impulse(&self, t: T) -> T {
        self.0 * t
    }

    fn is_linear_between_knots(&self) -> bool {
        true
    }

    fn recession(&self, _chi: T, _t: T) -> Option<T> {
        None
    }

    fn check(&self) -> Result<(), LoadError> {
        if is_finite_and_not_negative(self.0) {
            Ok(())
        } else {
            Err(LoadError::InvalidForce { time: 0.0, force: self.0.value() })
        }
    }
}
