//! Faults of a history, which the solution then does not cover.

use super::contradiction::Contradiction;
use crate::Scalar;
use crate::load::rounding::{impulse_tolerance, rounding_within_load};
use crate::load::{Load, LoadError};

/// Why the solution does not cover a history.
pub(in crate::load) enum Fault<T> {
    /// The hereditary load falls by more than rounding, from a time on.
    Falls(T),
    /// Its impulse is not that of its force.
    Contradicts(Contradiction<T>),
    /// At a time, its force is negative, or its force or impulse is not finite.
    IsInvalid(T, LoadError),
}

impl<T: Scalar> Fault<T> {
    /// An invalid force at a time.
    pub(super) fn of_force((time, force): (T, T)) -> Self {
        Self::IsInvalid(time, LoadError::InvalidForce { time: time.value(), force: force.value() })
    }

    /// Fails if an impulse up to a time is not finite. Early on, a valid one may be negative by rounding; more than that
    /// is a contradiction.
    pub(super) fn check_impulse((time, impulse): (T, T)) -> Result<(), Self> {
        if impulse.is_finite() {
            return Ok(());
        }
        let (at, impulse) = (time.value(), impulse.value());
        Err(Self::IsInvalid(time, LoadError::InvalidImpulse { time: at, impulse }))
    }

    /// Since when the history is not covered.
    pub(in crate::load) fn time(&self) -> T {
        match self {
            Self::Falls(since) => *since,
            Self::Contradicts(contradiction) => contradiction.from(),
            Self::IsInvalid(time, _) => *time,
        }
    }

    /// The error of the load, unless it falls.
    pub(in crate::load) fn contradiction(&self) -> Option<LoadError> {
        match *self {
            Self::Falls(_) => None,
            Self::Contradicts(contradiction) => Some(contradiction.error()),
            Self::IsInvalid(_, error) => Some(error),
        }
    }
}

/// By how much forces may be negative, and impulses off, in the history of a load up to `t`.
#[inline]
pub(super) fn tolerances<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> (T, T) {
    let hereditary = load.force(t) + chi * load.impulse(t);
    (rounding_within_load(hereditary), impulse_tolerance(hereditary, chi))
}
