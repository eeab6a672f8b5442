//! What counts as rounding in the history of a load.
//!
//! | allowance | for | why |
//! |---|---|---|
//! | 8 ε | a fall of the force along a piece, or of the hereditary load in a panel | forces, impulses and their sum are each rounded once or twice when a record is made and when it is followed |
//! | 64 ε | a force or an impulse that a user-defined load computes | its formula may have a dozen roundings, and lose some bits by cancellation |
//! | √ε | impulses, and the sum of allowed falls | an impulse may be the result of a quadrature; falls add up along a record, and such a share of the force still changes pressures little |

use crate::Scalar;
use crate::scalar::{from_single, smallest_normal};

/// How many ε a force may fall along a piece, or the hereditary load in a panel, without counting as falling.
const ALLOWED_FALL: f32 = 8.0;

/// By how much a force or a hereditary load of some size may fall in one piece or panel.
pub(super) fn allowed_fall<T: Scalar>(size: T) -> T {
    size * T::default_epsilon() * from_single(ALLOWED_FALL)
}

/// By how much rounding may make a hereditary load fall in a panel; near zero all numbers are rounded alike.
pub(crate) fn rounding_of_hereditary<T: Scalar>(hereditary: T) -> T {
    allowed_fall(hereditary.max(smallest_normal()))
}

/// By how much a force or an impulse may be off because a load computes it from numbers of the given size.
pub(crate) fn rounding_within_load<T: Scalar>(size: T) -> T {
    size * T::default_epsilon() * T::constant(64.0)
}

/// Whether a number is a valid force, which may be negative by up to `negligible`.
pub(super) fn is_force<T: Scalar>(number: T, negligible: T) -> bool {
    number >= -negligible && number.is_finite()
}

/// By how much an impulse may be off in a history that ends with a hereditary load.
///
/// Infinite without drainage, as impulses then do not count.
pub(crate) fn impulse_tolerance<T: Scalar>(hereditary: T, chi: T) -> T {
    if chi.is_zero() { T::infinity() } else { half_of_the_digits(hereditary / chi) }
}

/// What the allowed falls of many pieces or panels may add up to, under a force before them.
pub(super) fn tolerance_of_falls<T: Scalar>(force: T) -> T {
    half_of_the_digits(force)
}

/// Whether the falls of so many pieces, each within its allowance, can add up to too much.
pub(super) fn may_add_up<T: Scalar>(count: usize) -> bool {
    from_single::<T>(count as f32 * ALLOWED_FALL) * T::default_epsilon() > tolerance_of_falls(T::one())
}

/// √ε of a number.
fn half_of_the_digits<T: Scalar>(size: T) -> T {
    size * T::default_epsilon().sqrt()
}
