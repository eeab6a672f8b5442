//! Up to when the solution covers a history: a hereditary load Y = F + χ ∫F that falls lets the edge of the contact
//! recede, and forces and impulses that contradict each other are not those of one load.
//!
//! | module | what it does |
//! |---|---|
//! | `search` | follows a load of any kind between its knots, in panels |
//! | `straight` | follows the pieces of a load that is straight between its knots |
//! | `descent` | sums the falls of pieces that each fall by no more than rounding |
//! | `contradiction` | bounds the impulses that the force can have |
//! | `fault` | what is found |

mod contradiction;
mod descent;
mod fault;
mod search;
mod straight;

use super::Load;
use crate::Scalar;
use contradiction::Contradiction;
use fault::{Fault, tolerances};

pub(super) use descent::Descent;

/// The first fault of a history up to `t`.
pub(super) fn first_fault<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> Option<Fault<T>> {
    if let Some(fault) = fault_of_start(load, chi, t) {
        return Some(fault);
    }
    let covered = if load.is_linear_between_knots() {
        straight::first_fault(load, chi, t)
    } else {
        search::first_fault(load, chi, t)
    };
    covered.err()
}

/// The fault of an impulse that does not begin at zero by more than it may be off in a history up to `t`.
fn fault_of_start<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> Option<Fault<T>> {
    let impulse = load.impulse(T::zero());
    if impulse.is_zero() {
        return None;
    }
    let (_, tolerance) = tolerances(load, chi, t);
    Contradiction::with_integral((T::zero(), impulse), T::zero(), tolerance).map(Fault::Contradicts)
}
