//! The contact radius where the gap is one term whose power has no period of few octaves.
//!
//! With p = k/q in lowest terms the roots (y/j)^(1/p) repeat themselves after k octaves of y, which of r^2.37 are 637. A table
//! of 64 octaves holds them with a second one of 2^(64 h/p): with y/C = f · 2^(64 h), 1 ≤ f < 2⁶⁴,
//!
//! ```text
//! (y/j)^(1/p) = (f/w)^(1/p) · 2^(64 h/p)
//! ```
//!
//! Both factors have three parts in single precision, see [`roots`](super::roots), and lose nothing of the size of a
//! rounding in their product.

use super::Row;
use super::roots::{Ratio, Term};
use crate::Scalar;
use crate::evaluate::bits::{
    exponent, fraction, is_normal, least_of_quarter, middle_of_quarter, power_of_two, quarter,
};
use crate::evaluate::halved::Halved;

/// Quarters of octaves in a span: all that a table has rows for.
const QUARTERS: u32 = 256;

/// 2^(64 h/p) at h modulo 64: its fraction in three parts in the places 0, 3 and 1, its exponent in place 2. Quotients of
/// numbers with exponents from −1022 to 1023 have h from −32 to 31.
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

/// C w aᵖ with any p, with a table for all C that has w in it.
#[derive(Clone, Copy, Debug)]
pub struct AnyPower<T> {
    /// One over the fraction of C, and the exponent of C.
    inverse: T,
    exponent: i32,
    spans: &'static Spans,
}

impl<T: Scalar> AnyPower<T> {
    /// From C.
    #[inline(always)]
    pub fn of(c: T, spans: &'static Spans) -> Self {
        Self { inverse: fraction(c).recip(), exponent: exponent(c), spans }
    }
}

impl<T: Scalar> Term<T> for AnyPower<T> {
    #[inline(always)]
    fn ratio(self, load_integral: T) -> Ratio<T> {
        let exponent_of_load = exponent(load_integral);
        let quotient = fraction(load_integral) * self.inverse;
        let middle = middle_of_quarter(quotient);
        let quarters = quarter(quotient) + 4 * (exponent_of_load - self.exponent);
        // With their signs set, exponents are none of normal numbers; zero lies in no table.
        let has_place = is_normal::<T>(exponent_of_load) & is_normal::<T>(self.exponent);
        let in_table =
            if has_place { least_of_quarter((quarters as u32 % QUARTERS) as i32) } else { T::zero() };
        Ratio {
            in_table,
            difference: quotient - middle,
            sum: quotient + middle,
            periods: quarters.div_euclid(QUARTERS as i32),
        }
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
