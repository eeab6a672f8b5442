//! The contact radius where the gap is one term whose roots repeat only after more than 64 octaves.
//!
//! With p = k/q in lowest terms the roots (y/j)^(1/p) repeat after k octaves of y, which is 637 for r^2.37. A table of
//! 64 octaves holds them together with a second one of 2^(64 h/p): with y/C = f · 2^(64 h), 1 ≤ f < 2⁶⁴,
//!
//! ```text
//! (y/j)^(1/p) = (f/w)^(1/p) · 2^(64 h/p)
//! ```
//!
//! Both factors have three parts in single precision, see [`roots`](super::roots), and their product loses nothing of
//! the size of a rounding.

use super::Row;
use super::roots::{Divisor, Ratio, Term};
use crate::Scalar;
use crate::evaluate::bits::power_of_two;
use crate::evaluate::halved::Halved;

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
    #[inline(always)]
    fn ratio(self, load_integral: T) -> Ratio<T> {
        self.divisor.ratio::<2>(
            load_integral,
            #[inline(always)]
            |quarters| ((quarters as u32 % QUARTERS) as i32, quarters.div_euclid(QUARTERS as i32)),
        )
    }

    #[inline(always)]
    fn with_periods(self, (root, rest): (T, T), periods: i32) -> (T, T) {
        let row = self.spans.row(periods);
        let (factor, lacking) = row.root::<T>();
        let (product, lost) = Halved::of(root).times(Halved::of(factor)).word_and_lost();
        let unit = power_of_two::<T>(row.at(2) as i32);
        (product * unit, (lost + (root * lacking + rest * factor)) * unit)
    }
}
