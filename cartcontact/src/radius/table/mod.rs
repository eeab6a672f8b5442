//! A table that the macro has computed. Each row leads to the contact radius in one quarter of an octave of the load
//! integral.
//!
//! A row is a cubic in the fraction f of the load integral y = f · 2^e, 1 ≤ f < 2, that gives the radius to six digits,
//! see [`cubics`]. One [step](super::halley) from there reaches the last bit. In single precision the seed is first cut
//! to half its digits, so that its square is exact in both formats. The macro has checked the error after the step for
//! every row: it is less than ε/8. The weights of coefficients that depend on fields have few digits, see
//! [`Target`](super::halley::Target), so that they are rounded no more than constants. Where the gap begins with r, p is
//! least, and what its power loses is known. With whole powers about ten radii in a million are off by more than 1 ulp;
//! `cargo run --release -p tests --bin radii` counts them, and says by how much.
//!
//! Where powers are multiples of 1/2, the same is done with x, the square root of the radius, whose powers are whole.
//! Its square less the step is as exact as the radius would be, and what x^p loses is known, as p is twice as high; so
//! is, where the gap begins with r or √r, what its product with the rest of J loses. With fields and multiples of 1/3 to
//! 1/20 the powers of the root are so high that they are computed without any loss, see
//! [`NestedPowers`](crate::evaluate::steepness::NestedPowers).
//!
//! Where powers of constants are other fractions, or many, each row has the radius itself as a polynomial, see
//! [`curves`].
//!
//! Where the gap is one term, the radius is a root. Each row of its table has the root at the middle of the quarter,
//! see [`roots`].
//!
//! Load integrals outside the table (zero, NaN, beyond the range) are left to the general solution: one comparison
//! finds all of them.

mod cubics;
pub(crate) mod curves;
pub(crate) mod roots;
pub(crate) mod spans;
pub(crate) mod units;

use crate::Scalar;
use crate::numbers::bits::{least_of_quarter, of_bits, quarter};
use crate::scalar::{has_no_derivatives, is_single};

/// A row of `N` bytes for each quarter of an octave k = 4 e + ⌊4 (f − 1)⌋ of the load integral y = f · 2^e, 1 ≤ f < 2,
/// `BYTES` in all.
#[derive(Debug)]
pub struct Table<const N: usize = 16, const BYTES: usize = 4096> {
    /// The quarters k of the table, at most 256.
    pub quarters: Quarters,
    /// The subset of quarters in which y and all intermediates of a step fit single precision (within 2^±100).
    pub single: Quarters,
    /// The row of k is at k − 4 modulo 256.
    ///
    /// This index is eight bits of y, six of its exponent and two of its fraction, and needs no check of bounds.
    pub rows: Rows<BYTES>,
}

/// A range of quarters of octaves.
#[derive(Clone, Copy, Debug)]
pub struct Quarters {
    /// The first k.
    pub first: i32,
    /// How many there are.
    pub count: u32,
}

/// 256 rows, as bytes: the compiler reads one literal instead of a thousand. No row of 16 bytes straddles two cache
/// lines.
#[derive(Debug)]
#[repr(align(16))]
pub struct Rows<const BYTES: usize>(pub [u8; BYTES]);

/// Numbers, the low byte first: by default four in single precision.
#[derive(Clone, Copy, Debug)]
pub struct Row<const N: usize = 16>(pub(super) [u8; N]);

/// How a radius follows from its row of the table.
pub(super) trait Step<T, const N: usize = 16>: Copy {
    /// What is read from all rows of a block first, if that makes quicker vector code.
    type Start: Copy + Default;

    /// Whether the radius has the derivatives of the load integral and of what it depends on beside that.
    const HAS_DERIVATIVES: bool = false;

    /// The load integral that is looked up in the table, and how many periods of the table were taken out of it.
    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        (load_integral, 0)
    }

    /// What a row gives for the [`digits`] of a load integral and its periods.
    #[inline(always)]
    fn start(self, _row: &Row<N>, _digits: u32, _periods: i32) -> Self::Start {
        Self::Start::default()
    }

    fn radius(self, row: &Row<N>, start: Self::Start, load_integral: T) -> T;
}

impl<const N: usize, const BYTES: usize> Table<N, BYTES> {
    /// The radius at which J is `load_integral`; none outside the table or beyond `limit`, and for scalars other than
    /// f32 and f64 if the step does not know derivatives.
    #[inline(always)]
    pub(super) fn find<T: Scalar, S: Step<T, N>>(&self, load_integral: T, limit: T, step: S) -> Option<T> {
        let (y, periods) = step.in_table(load_integral);
        if !((S::HAS_DERIVATIVES || has_no_derivatives::<T>()) && self.contains(y)) {
            return None;
        }
        let digits = digits(y);
        let row = self.row(digits);
        let radius = step.radius(&row, step.start(&row, digits, periods), load_integral);
        // Without the second condition a limit that is infinite at compile time would still be compared, as the radius
        // may be NaN. One that is infinite at run time takes one comparison.
        let is_within = radius <= limit || limit == T::infinity();
        is_within.then_some(radius)
    }

    /// Whether there is vector code for a scalar type, and rows for its precision.
    pub(super) fn has_blocks<T: Scalar>(&self) -> bool {
        has_no_derivatives::<T>() && self.quarters::<T>().count > 0
    }

    #[inline(always)]
    fn quarters<T: Scalar>(&self) -> Quarters {
        if is_single::<T>() { self.single } else { self.quarters }
    }

    /// If y is too small for the table or has its sign set, its index is too large.
    #[inline(always)]
    fn contains<T: Scalar>(&self, y: T) -> bool {
        let Quarters { first, count } = self.quarters::<T>();
        (quarter(y).wrapping_sub(first) as u32) < count
    }

    /// The load integrals at both ends of the rows for a scalar type.
    pub(super) fn ends<T: Scalar>(&self) -> [T; 2] {
        let Quarters { first, count } = self.quarters::<T>();
        [first, first + count as i32].map(least_of_quarter)
    }

    #[inline(always)]
    pub(super) fn row(&self, digits: u32) -> Row<N> {
        let (rows, _) = self.rows.0.as_chunks();
        Row(rows[usize::from(row_index(digits))])
    }

    /// The row of all these digits, if they have the same one.
    #[inline(always)]
    pub(super) fn row_of_all(&self, digits: &[u32]) -> Option<Row<N>> {
        let [first, .., last] = *digits else { return None };
        // Where load integrals are in no order, a look at two of them usually settles it.
        if row_index(first ^ last) != 0 {
            return None;
        }
        let differing = digits.iter().fold(0, |all, digits| all | (digits ^ first));
        (row_index(differing) == 0).then(|| self.row(first))
    }
}

impl<const N: usize> Default for Row<N> {
    fn default() -> Self {
        Self([0; N])
    }
}

impl<const N: usize> Row<N> {
    /// The number in single precision at a place from 0 on.
    #[inline(always)]
    pub(super) fn at(&self, place: usize) -> f32 {
        f32::from_le_bytes(self.bytes_at(place))
    }

    /// The number in double precision at a place from 0 on.
    #[inline(always)]
    pub(super) fn word(&self, place: usize) -> f64 {
        let (places, _) = self.0.as_chunks();
        f64::from_le_bytes(places[place])
    }

    /// The integer at a place from 0 on.
    #[inline(always)]
    fn integer_at(&self, place: usize) -> i32 {
        i32::from_le_bytes(self.bytes_at(place))
    }

    #[inline(always)]
    fn bytes_at(&self, place: usize) -> [u8; 4] {
        let (places, _) = self.0.as_chunks();
        places[place]
    }
}

/// No second start: the result is not found.
#[inline(always)]
pub fn nowhere<T: Scalar>(load_integral: T, _more: u32) -> (T, bool) {
    (load_integral, false)
}

/// Where the row of these digits is.
#[inline(always)]
fn row_index(digits: u32) -> u8 {
    (digits >> 21) as u8
}

/// 23 bits of the fraction of y, below the last bits of its exponent.
#[inline(always)]
pub(super) fn digits<T: Scalar>(y: T) -> u32 {
    of_bits(y, |bits| bits, |bits| (bits >> 29) as u32)
}
