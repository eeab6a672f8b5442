//! [`Geometry`] -> [`Table`]: rows by octaves of the load integral, from which one step leads to the contact radius.
//!
//! Rows stand for quarters of octaves; 256 rows span 64 octaves. A row is four numbers in single precision, 4 KiB in
//! all, or more for [curves](crate::start::curves).
//!
//! **The window.** Where the gap is as wide as the radius, Φ(ℓ) = ℓ, a layer is no longer thin; where it is a
//! thousandth of the radius, the surfaces hardly part. For a sphere the contacts between these are y from 2⁻⁶⁰ J(ℓ) to
//! 2⁴ J(ℓ), with something to spare. Gaps that open more suddenly have room at both ends; for other gaps the flattest
//! contacts are outside. There, the radius is iterated.
//!
//! Symbols have one table in [units of their own](crate::start::own_units), if they do no more than set these units.
//! Its window lies mostly below y = 1, because higher terms are mostly corrections.

use core::ops::Range as Indices;

use crate::gap::Gap;
use crate::gap::range::Range;
use crate::geometry::Geometry;

/// Rows per octave of the load integral.
pub(crate) const ROWS_PER_OCTAVE: i32 = 4;
pub(crate) const OCTAVES: i32 = 64;
/// A shorter table is not worth its code.
pub(crate) const FEWEST_ROWS: usize = 32;
/// The rows of a whole table.
pub(crate) const ROWS: usize = (ROWS_PER_OCTAVE * OCTAVES) as usize;
/// The octaves of the window above J(ℓ), at least.
const OCTAVES_ABOVE: f64 = 4.0;
/// The ratio of gap to radius below which there is hardly a gap.
const FLATTEST: f64 = 1.0 / 1024.0;
/// The largest |log₂| of all that a step computes, without factors of exponents, for which nothing leaves the format
/// and products with the error of J at the seed keep as many digits as that error has.
pub(crate) const LARGEST_DOUBLE: f64 = 300.0;
pub(crate) const LARGEST_SINGLE: f64 = 100.0;

/// Rows for y = f · 2^e, 1 ≤ f < 2, by k = 4 e + ⌊4 (f − 1)⌋ − first.
pub(crate) struct Table<R = [f32; 4]> {
    pub(crate) first: i32,
    pub(crate) rows: Vec<R>,
    /// The first row for which single precision holds all that the step computes, and the number of such rows.
    pub(crate) single: (i32, usize),
}

/// A row, and whether single precision holds all that a step from it computes.
pub(crate) type Row<R = [f32; 4]> = (R, bool);

/// A row as the solver reads it.
pub(crate) trait Bytes: Copy {
    /// As many as the row has in memory.
    fn bytes(&self) -> Vec<u8>;
}

impl<const N: usize> Bytes for [f32; N] {
    fn bytes(&self) -> Vec<u8> {
        self.iter().flat_map(|number| number.to_le_bytes()).collect()
    }
}

impl<R: Bytes> Table<R> {
    /// The longest run of the rows that exist; the first of `rows` has the index `first`.
    pub(crate) fn of(first: i32, rows: &[Option<Row<R>>]) -> Option<Self> {
        let run = longest_run(rows.len(), &|index| rows[index].is_some());
        let first = first + run.start as i32;
        let rows: Vec<Row<R>> = rows[run].iter().copied().collect::<Option<_>>()?;
        let single = longest_run(rows.len(), &|index| rows[index].1);
        let single = (first + single.start as i32, single.len());
        (!rows.is_empty()).then(|| Self { first, rows: rows.iter().map(|(row, _)| *row).collect(), single })
    }

    /// A table without rows.
    pub(crate) fn empty() -> Self {
        Self { first: 0, rows: Vec::new(), single: (0, 0) }
    }

    /// The load integrals at both ends of the table.
    pub(crate) fn range(&self) -> [f64; 2] {
        [lower_end(self.first), lower_end(self.first + self.rows.len() as i32)]
    }

    /// The bytes of the rows in the places where the solver looks for them: the row of index k is at k − 4 modulo 256,
    /// which a number has in the last six bits of its biased exponent and the first two of its fraction.
    pub(crate) fn in_places(&self) -> Vec<u8> {
        let mut places = vec![0; Self::size_in_bytes()];
        for (row, index) in self.rows.iter().zip(self.first..) {
            let place = (index - ROWS_PER_OCTAVE).rem_euclid(ROWS as i32) as usize * size_of::<R>();
            places[place..place + size_of::<R>()].copy_from_slice(&row.bytes());
        }
        places
    }

    pub(crate) const fn size_in_bytes() -> usize {
        size_of::<[R; ROWS]>()
    }
}

/// The octave at which the table ends, for constant coefficients.
pub(crate) fn top(geometry: &Geometry, load_integral: impl Fn(f64) -> f64) -> Option<i32> {
    let octave = |a: f64| load_integral(a).log2().floor();
    let end = match &geometry.range {
        Range::Limited(end) => octave(end.to_f64()) + 1.0,
        Range::Unbounded | Range::Symbolic(_) => f64::INFINITY,
    };
    let flattest = octave(radius_of_slope(&geometry.gap, FLATTEST)?);
    let steepest = octave(radius_of_slope(&geometry.gap, 1.0)?) + OCTAVES_ABOVE;
    let spare = f64::from(OCTAVES) - (steepest - flattest);
    let top = (steepest + (0.5 * spare).max(0.0).floor()).min(end);
    (top.abs() < LARGEST_DOUBLE).then_some(top as i32)
}

/// The radius at which the gap over its radius is `slope`, or a slightly larger one, at which one of its terms alone is
/// enough.
fn radius_of_slope(gap: &Gap, slope: f64) -> Option<f64> {
    let alone = gap.terms.iter().filter_map(|term| {
        let (c, n) = (term.coefficient.as_constant()?.to_f64(), term.exponent.to_f64());
        (c > 0.0 && n > 1.0).then(|| (slope / c).powf(1.0 / (n - 1.0)))
    });
    alone.reduce(f64::min)
}

/// The longest run of indices below `count` that satisfy `is_in`; the last one of several.
fn longest_run(count: usize, is_in: &dyn Fn(usize) -> bool) -> Indices<usize> {
    let (mut longest, mut start) = (0..0, 0);
    for index in 0..count {
        if !is_in(index) {
            start = index + 1;
        } else if index + 1 - start >= longest.len() {
            longest = start..index + 1;
        }
    }
    longest
}

/// The load integral at which a row begins.
pub(crate) fn lower_end(index: i32) -> f64 {
    let (octave, quarter) = (index.div_euclid(ROWS_PER_OCTAVE), index.rem_euclid(ROWS_PER_OCTAVE));
    2f64.powi(octave) * (1.0 + f64::from(quarter) / f64::from(ROWS_PER_OCTAVE))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_run_is_kept() {
        let run = |values: &[bool]| longest_run(values.len(), &|index| values[index]);
        assert_eq!(run(&[true, false, true, true, false, false, true]), 2..4);
        assert_eq!(run(&[false, true, false, true]), 3..4);
        assert!(run(&[false, false]).is_empty() && run(&[]).is_empty());
    }

    #[test]
    fn single_precision_has_the_rows_that_it_holds() {
        let row = |is_held: bool| Some(([0.0; 4], is_held));
        let table = Table::of(-3, &[None, row(false), row(true), row(true), row(false)]);
        assert!(table.is_some_and(|table| (table.first, table.rows.len(), table.single) == (-2, 4, (-1, 2))));
        assert!(Table::<[f32; 4]>::of(0, &[None]).is_none());
    }
}
