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

/// The first fault of a history up to `t`.
pub(super) fn first_fault<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> Option<Fault<T>> {
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
            let step = Piece { start: walk.end, end: piece.start };
            let fault = walk.pass(&step).or_else(|| walk.pass(piece));
            if fault.is_some() {
                return fault;
            }
        }
        let impulse = load.impulse(walk.end.0);
        let fault = walk.fault_of_impulse(impulse, tolerance);
        if fault.is_some() {
            return fault;
        }
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
    fn pass(&mut self, piece: &Piece<T>) -> Option<Fault<T>> {
        let invalid =
            [piece.start, piece.end].into_iter().find(|&(_, force)| !is_force(force, self.negligible));
        if let Some(invalid) = invalid {
            return Some(Fault::of_force(invalid));
        }
        self.end = piece.end;
        self.integral.add(piece.impulse());
        self.descent.pass(piece, self.t).map(Fault::Falls)
    }

    /// What is wrong with the impulse up to now.
    fn fault_of_impulse(&self, impulse: T, tolerance: T) -> Option<Fault<T>> {
        let now = (self.end.0, impulse);
        let contradiction = || Contradiction::with_integral(now, self.integral.value, tolerance);
        Fault::of_impulse(now).or_else(|| contradiction().map(Fault::Contradicts))
    }
}
