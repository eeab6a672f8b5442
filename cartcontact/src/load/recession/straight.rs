//! When a user-defined load that is straight between its knots first falls too fast, or is not valid.
//!
//! Its pieces are all there is to know: the walk follows them as for [`PiecewiseLinear`](crate::load::PiecewiseLinear),
//! with two forces for each.

use super::contradiction::Contradiction;
use super::descent::Descent;
use super::fault::{Fault, tolerances};
use crate::Scalar;
use crate::load::rounding::is_force;
use crate::load::{Load, MOST_PIECES, Piece, pieces_between};
use crate::numbers::compensated_sum::CompensatedSum;

/// Fails with the first fault of a history up to `t`.
pub(super) fn first_fault<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> Result<(), Fault<T>> {
    let (negligible, tolerance) = tolerances(load, chi, t);
    let mut walk = Walk {
        t,
        negligible,
        descent: Descent::new(chi),
        end: (T::zero(), load.force(T::zero())),
        integral: T::zero().into(),
    };
    let mut pieces = [Piece::none(); MOST_PIECES];
    while walk.end.0 < t {
        for piece in pieces_between(load, (walk.end.0, t), &mut pieces) {
            walk.pass(&Piece { start: walk.end, end: piece.start })?;
            walk.pass(piece)?;
        }
        walk.check_impulse(load.impulse(walk.end.0), tolerance)?;
    }
    walk.pass(&Piece { start: walk.end, end: (t, load.force(t)) })
}

/// A walk in progress.
struct Walk<T> {
    t: T,
    /// By how much a force may be negative.
    negligible: T,
    descent: Descent<T>,
    /// The present time, and the force just before it.
    end: (T, T),
    /// ∫F up to now.
    integral: CompensatedSum<T>,
}

impl<T: Scalar> Walk<T> {
    /// Continues along a piece that begins now.
    fn pass(&mut self, piece: &Piece<T>) -> Result<(), Fault<T>> {
        for (time, force) in [piece.start, piece.end] {
            if !is_force(force, self.negligible) {
                return Err(Fault::of_force((time, force)));
            }
        }
        self.end = piece.end;
        self.integral.add(piece.impulse());
        self.descent.pass(piece, self.t).map_or(Ok(()), |since| Err(Fault::Falls(since)))
    }

    /// Compares the impulse up to now with the integral of the force.
    fn check_impulse(&self, impulse: T, tolerance: T) -> Result<(), Fault<T>> {
        let now = (self.end.0, impulse);
        Fault::check_impulse(now)?;
        let contradiction = Contradiction::with_integral(now, self.integral.value, tolerance);
        contradiction.map_or(Ok(()), |contradiction| Err(Fault::Contradicts(contradiction)))
    }
}
