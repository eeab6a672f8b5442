//! The contact radius as a polynomial in each row, where powers of constants are not whole, or many.
//!
//! ```text
//! a = A + (c₁ w + c₂ w² + …),     w = y/2^e − u,  |w| ≤ 1/8
//! ```
//!
//! with y = f · 2^e, 1 ≤ f < 2, and u the middle of the quarter of an octave that f lies in. Twelve terms leave less than
//! ε/16, and six in single precision; the macro has checked that for every row. No power of a radius is formed, so
//! that powers need not be whole, nor few.
//!
//! **Accuracy.** A has two parts, and w is exact. What is rounded besides the last sum is less than 1/33 of it, and less
//! than 1/50 where p ≥ 6, as a changes by a factor of (9/8)^(1/p) at the most: 1/2 ulp and little more is left.

use core::array::from_fn;

use super::{Row, Step, Table};
use crate::Scalar;
use crate::numbers::bits::{fraction, middle_of_part};
use crate::profile::RadiusError;
use crate::scalar::{from_single, is_same};

/// Rows of five pairs of f64, c₂ c₄, c₃ c₅, c₆ c₈, c₇ c₉, A c₁, and two of f32, c₁₀ c₁₂ and c₁₁ with what A lacks. What
/// is done with the numbers of a pair is the same, so that vectors of 128 bits, which all processors with vectors have,
/// do it at once.
pub type DoubleCurves = Table<96, 24576>;

/// Rows of eight f32: A, what it lacks, and c₁ to c₆.
pub type SingleCurves = Table<32, 8192>;

/// The tables of both formats. A program contains those of the formats that it uses.
#[derive(Clone, Copy, Debug)]
pub struct Curves {
    /// For f64.
    pub double: &'static DoubleCurves,
    /// For f32.
    pub single: &'static SingleCurves,
}

impl Curves {
    /// `Table::find` by a polynomial.
    #[inline(always)]
    pub fn radius<T: Scalar>(self, load_integral: T, limit: T) -> Option<T> {
        if is_same::<T, f32>() {
            self.single.find(load_integral, limit, SingleCurve)
        } else {
            self.double.find(load_integral, limit, DoubleCurve)
        }
    }

    /// `Table::find_all` by a polynomial.
    ///
    /// # Errors
    ///
    /// As `Table::find_all`.
    #[inline]
    pub fn radii<T: Scalar>(
        self,
        values: (&[T], &mut [T]),
        limit: T,
        solve: impl Fn(T, u32) -> (T, bool),
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        if is_same::<T, f32>() {
            self.single.find_all(values, limit, SingleCurve, solve, general)
        } else {
            self.double.find_all(values, limit, DoubleCurve, solve, general)
        }
    }
}

/// The distance w from the middle of its quarter of an octave.
#[inline(always)]
fn from_middle<T: Scalar>(load_integral: T) -> T {
    let fraction = fraction(load_integral);
    fraction - middle_of_part::<_, 2>(fraction)
}

#[derive(Clone, Copy)]
struct DoubleCurve;

impl<T: Scalar> Step<T, 96> for DoubleCurve {
    type Start = ();

    #[inline(always)]
    fn radius(self, row: &Row<96>, _start: (), load_integral: T) -> T {
        let w = from_middle(load_integral);
        let word = |place: usize| T::constant(row.word(place));
        let rest = |place: usize| from_single::<T>(row.at(20 + place));
        let square = w * w;
        let fourth = square * square;
        // Sums of every fourth power. There is no c₁₃: what A lacks is in its place, and times w¹³ it is nothing.
        let even: [T; 2] = from_fn(
            #[inline(always)]
            |k| word(k) + fourth * (word(4 + k) + fourth * rest(k)),
        );
        let odd: [T; 2] = from_fn(
            #[inline(always)]
            |k| word(2 + k) + fourth * (word(6 + k) + fourth * rest(2 + k)),
        );
        let [low, high] = from_fn(
            #[inline(always)]
            |k| even[k] + odd[k] * w,
        );
        word(8) + ((rest(3) + word(9) * w) + square * (low + high * square))
    }
}

#[derive(Clone, Copy)]
struct SingleCurve;

impl<T: Scalar> Step<T, 32> for SingleCurve {
    type Start = ();

    #[inline(always)]
    fn radius(self, row: &Row<32>, _start: (), load_integral: T) -> T {
        let w = from_middle(load_integral);
        let c = |place: usize| from_single::<T>(row.at(place));
        let square = w * w;
        let high = (c(3) + c(4) * w) + ((c(5) + c(6) * w) + c(7) * square) * square;
        c(0) + ((c(1) + c(2) * w) + square * high)
    }
}
