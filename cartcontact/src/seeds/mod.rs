//! The contact radius in one step, from a table that the macro has computed.
//!
//! A row of the table is a cubic in the fraction of the load integral y that meets the radius to six digits.
//! From there one step of Halley's method reaches the last bit,
//!
//! ```text
//! a ← a − a f aJ′/((aJ′)² − f a²J″/2),    f = J(a) − y
//! ```
//!
//! in single precision, too, where the seed is cut to half its digits first, so that its square is exact in both. The macro
//! has checked what the step leaves at every row: less than ε/8. J itself, whose error is divided by p = a J′/J > 4, and the
//! last subtraction round. Symbols have few digits for weights, see [`Target`], so that they round no more than constants.
//! Of five million random radii each of eleven geometries with whole powers, fewer than one in a million was off by more than
//! 1 ulp, and 5 in single precision; 15 where the gap begins with r, whose p is the least, by 1.16 at the most.
//!
//! Where powers are multiples of 1/2 the same is done with the square root of the radius, x, of which they are whole. Its square
//! less the step is as exact as the radius would be, and what x^p loses is known, as p is twice as high: of five million radii
//! of nine such geometries 8 in a million were off by more than 1 ulp, 3 in single precision, by 1.16 at the most.
//!
//! Where the gap is one term, the radius is a root, which its table has in the middle of every row, see [`roots`].
//!
//! What lies outside the table, be it zero, not a number, or beyond the range, is left to the general solution:
//! one comparison finds all of it.

mod blocks;
mod halley;
mod leading_term;
mod roots;
mod table;
mod units;
mod whole_powers;

pub use halley::Steepness;
use halley::Target;
pub use leading_term::radius_of_real_powers;
pub use roots::{OwnTerm, Roots, SingleTerm};
pub use table::{Quarters, Rows, Table};
pub use units::{EqualTerms, OwnUnits, Squared};
pub use whole_powers::{WholePowers, radii_of_whole_powers};

/// The general solution, out of the way of the step from the table.
#[cold]
#[inline(never)]
pub fn elsewhere<R>(solve: impl FnOnce() -> R) -> R {
    solve()
}
