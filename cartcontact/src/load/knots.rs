//! The knots (time, force) of a load that is linear between them.

use super::{LoadError, Piece};
use crate::Scalar;
use crate::scalar::is_finite_and_not_negative;

/// The pieces between neighbouring knots, including steps.
pub(super) fn pieces<T: Scalar>(knots: &[(T, T)]) -> impl Iterator<Item = Piece<T>> {
    knots.iter().zip(knots.iter().skip(1)).map(|(&start, &end)| Piece { start, end })
}

/// Checks that knots are in the order of time from 0 on, at most two of them at one time, and forces not negative.
pub(super) fn check<T: Scalar>(knots: &[(T, T)]) -> Result<(), LoadError> {
    let Some(&(first, _)) = knots.first() else {
        return Err(LoadError::Empty);
    };
    for (knot, &(time, force)) in knots.iter().enumerate() {
        if !time.is_finite() {
            return Err(LoadError::InvalidTime { knot, time: time.value() });
        }
        if !is_finite_and_not_negative(force) {
            return Err(LoadError::InvalidForce { time: time.value(), force: force.value() });
        }
    }
    if !first.is_zero() {
        return Err(LoadError::LateStart { time: first.value() });
    }
    for (knot, piece) in pieces(knots).enumerate() {
        let (previous, time) = (piece.start.0, piece.end.0);
        if time < previous {
            let (time, previous) = (time.value(), previous.value());
            return Err(LoadError::Unsorted { knot: knot + 1, time, previous });
        }
    }
    for (knot, three) in knots.windows(3).enumerate() {
        if let &[(first, _), _, (time, _)] = three
            && first == time
        {
            return Err(LoadError::RepeatedTime { knot: knot + 2, time: time.value() });
        }
    }
    Ok(())
}
