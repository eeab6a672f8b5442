//! The contact radius where the gap is one term whose roots repeat only after more than 64 octaves.
//!
//! With p = k/q in lowest terms the roots (y/j)^(1/p) repeat after k octaves of y, which is 637 for r^2.37. A table of
//! 64 octaves holds them together with a second one of 2^(64 h/p): with y/C = f · 2^(64 h), 1 ≤ f < 2⁶⁴,
//!
//! ```text
//! (y/j)^(1/p) = (f/w)^(1/p) · 2^(64 h/p)
//! ```
//!
//! Both factors have three parts in single precision, see [`roots`](super::roots). The product of the first two is exact
//! in double precision, and the product of all loses nothing of the size of a rounding.

use super::Row;
use super::roots::{Divisor, Term};
use crate::Scalar;
use crate::numbers::bits::power_of_two;
use crate::numbers::halved::Halved;
use crate::scalar::is_same;

/// Quarters of octaves in a span: as many as a table has rows.
const QUARTERS: u32 = 256;

/// 2^(64 h/p) at index h modulo 64: its fraction in three parts in the places 0, 3 and 1, its exponent in place 2.
/// Quotients of numbers with exponents from −1022 to 1023 have h from −32 to 31.
#[derive(Debug)]
#[repr(align(16))]
pub struct Spans(pub [u8; 1024]);

impl Spans {
    #[inline(always)]
    fn row(&self, span: i32) -> Row {
        let (rows, _) = self.0.as_chunks();
        Row(rows[span as usize % 64])
    }
}

/// C w aᵖ with any p. One table, which includes w, serves all C.
#[derive(Clone, Copy, Debug)]
pub struct AnyPower<T> {
    divisor: Divisor<T>,
    spans: &'static Spans,
}

impl<T: Scalar> AnyPower<T> {
    /// From C.
    #[inline(always)]
    pub fn of(c: T, spans: &'static Spans) -> Self {
        Self { divisor: Divisor::of(c), spans }
    }
}

impl<T: Scalar> Term<T> for AnyPower<T> {
    type Periods = Row;

    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        self.divisor.in_table::<2>(
            load_integral,
            #[inline(always)]
            |quarters| ((quarters as u32 % QUARTERS) as i32, quarters.div_euclid(QUARTERS as i32)),
        )
    }

    #[inline(always)]
    fn share(self, load_integral: T) -> T {
        self.divisor.share::<2>(load_integral)
    }

    #[inline(always)]
    fn periods(self, periods: i32) -> Row {
        self.spans.row(periods)
    }

    #[inline(always)]
    fn with_periods(self, (root, rest): (T, T), row: Row) -> (T, T) {
        let (factor, lacking) = row.root::<T>();
        let (product, lost) = product_of_parts(root, factor);
        let lost = lost + (root * lacking + rest * (factor + lacking));
        let unit = power_of_two::<T>(row.integer_at(2));
        (product * unit, lost * unit)
    }
}

/// The product of two numbers of single precision, and what it lacks: nothing in double precision.
#[inline(always)]
fn product_of_parts<T: Scalar>(x: T, y: T) -> (T, T) {
    if is_same::<T, f32>() { Halved::of(x).times(Halved::of(y)).word_and_lost() } else { (x * y, T::zero()) }
}
