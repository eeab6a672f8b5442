//! The contact radius where the gap is one term: a root from a table, and a short series.
//!
//! J = j aᵖ = y has the root a = (y/j)^(1/p), Eq. (18). Let u be the middle of the part of an octave in which y lies,
//! a quarter or a sixteenth, and A = (u/j)^(1/p). Then
//!
//! ```text
//! a = A ((1 + s)/(1 − s))^(1/p) = A + A (c₁ s + c₂ s² + …),     s = (y − u)/(y + u),  |s| ≤ 1/17 or 1/65
//! ```
//!
//! Of quarters, twelve terms of the series leave 6 · 10⁻¹⁸, and eight 7 · 10⁻¹³ in single precision; of sixteenths,
//! eight leave 4 · 10⁻¹⁸, and four 1.1 · 10⁻¹⁰: most where p is near 4. No power of a is formed, so that p need not be
//! whole.
//!
//! **Any C.** If j = w C, where C depends on fields, the table is one of y/C and includes the weight w. With p = k/q in
//! lowest terms, y/C multiplied by 2^k multiplies a by 2^q: one table of k octaves holds the roots of all y/C. If k is
//! at most 16, it has sixteenths. Powers of two are taken out of y, C and a, so that nothing leaves the format, and a
//! change of units by a power of two changes no digit. Where k is above 64, the table has 64 octaves, and a second one
//! has the factors of a for whole spans of these, see [`spans`](super::spans).
//!
//! **Accuracy.** A row has A in three parts of single precision, and y − u is exact. All parts of A but the first,
//! and the series, are rounded: together less than 1/33 of the sum, whose last addition leaves 1/2 ulp. Two roundings of
//! y/C are left, a share of ε at the most, which p > 4 divides: less than 1/2 ulp. Of 320 000 random radii of nine
//! geometries none was off by more than 0.86 ulp, nor by more than 0.93 where C is itself a rounded quotient.

use super::{Row, Step, Table, nowhere};
use crate::Scalar;
use crate::numbers::bits::{
    exponent, fraction, is_normal, least_of_quarter, middle_of_part, part_of_octave, power_of_two,
};
use crate::numbers::series::four_terms;
use crate::profile::RadiusError;
use crate::scalar::{from_single, is_same};

/// A table of roots, and the series of N terms.
#[derive(Debug)]
pub struct Roots<const N: usize> {
    /// A in three parts, in the places 0, 3 and 1. The k-th part of an octave, a quarter or not, has the row of the k-th
    /// quarter.
    pub table: Table,
    /// c₁, c₂, …
    pub series: [f64; N],
}

/// Quotients y/C lie between 2^−2100 and 2^2100.
const MOST_OCTAVES: u32 = 2100;
/// Binary digits of the fixed-point 1/K, rounded up. For 5 ≤ K ≤ 64 and up to 4300 octaves the quotient is too large by
/// less than 0.005, never enough to reach the next integer, and the product before the shift is below 2³².
const DIGITS_OF_INVERSE: u32 = 20;

impl<const N: usize> Roots<N> {
    /// `Table::find` by a root and the series.
    #[inline(always)]
    pub fn radius<T: Scalar>(&self, load_integral: T, limit: T, term: impl Term<T>) -> Option<T> {
        self.table.find(load_integral, limit, Root { term, series: self.series })
    }

    /// `Table::find_all` by a root and the series.
    ///
    /// # Errors
    ///
    /// As `Table::find_all`.
    #[inline]
    pub fn radii<T: Scalar>(
        &self,
        values: (&[T], &mut [T]),
        limit: T,
        term: impl Term<T>,
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        self.table.find_all(values, limit, Root { term, series: self.series }, nowhere, general)
    }
}

/// The step from a root in the table.
#[derive(Clone, Copy)]
struct Root<D, const N: usize> {
    term: D,
    series: [f64; N],
}

/// The term of J, or the part of it that is in the table.
pub trait Term<T>: Copy {
    /// The factor by which radii grow over the periods of the table that were taken out of a load integral.
    type Periods: Copy + Default;

    /// y/j without whole periods of the table, and how many these are.
    fn in_table(self, load_integral: T) -> (T, i32);

    /// s.
    fn share(self, load_integral: T) -> T;

    /// The factor for so many periods.
    fn periods(self, periods: i32) -> Self::Periods;

    /// A root in the table and what it lacks, with the periods put back.
    fn with_periods(self, root: (T, T), periods: Self::Periods) -> (T, T);
}

impl<T: Scalar, D: Term<T>, const N: usize> Step<T> for Root<D, N> {
    type Start = D::Periods;

    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        self.term.in_table(load_integral)
    }

    #[inline(always)]
    fn start(self, _row: &Row, _digits: u32, periods: i32) -> D::Periods {
        self.term.periods(periods)
    }

    #[inline(always)]
    fn radius(self, row: &Row, periods: D::Periods, load_integral: T) -> T {
        let s = self.term.share(load_integral);
        // Independent of s, so that it need not wait for the division.
        let (root, rest) = self.term.with_periods(row.root(), periods);
        root + ((root + rest) * s * growth_per_s(s, &self.series) + rest)
    }
}

impl Row {
    /// The first of the three parts that a number is stored in, and what it lacks.
    ///
    /// The second part is in the last place: if that were not read, compilers would leave the last rows to code without
    /// vectors.
    #[inline(always)]
    pub(super) fn root<T: Scalar>(&self) -> (T, T) {
        let part = |place: usize| from_single::<T>(self.at(place));
        (part(0), if is_same::<T, f32>() { part(3) } else { part(3) + part(1) })
    }
}

/// c₁ + c₂ s + …, without the last four terms in single precision.
#[inline(always)]
fn growth_per_s<T: Scalar, const N: usize>(s: T, series: &[f64; N]) -> T {
    let (square, (rows, _)) = (s * s, series.as_chunks());
    let row = |k: usize| four_terms(&rows[k], s, square);
    let fourth = square * square;
    let terms = if is_same::<T, f32>() { N - 4 } else { N };
    let mut sum = row(0);
    if terms > 4 {
        sum += row(1) * fourth;
    }
    if terms > 8 {
        sum += row(2) * (fourth * fourth);
    }
    sum
}

/// A term whose j is in the table.
#[derive(Clone, Copy, Debug)]
pub struct OwnTerm;

impl<T: Scalar> Term<T> for OwnTerm {
    type Periods = ();

    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        (load_integral, 0)
    }

    #[inline(always)]
    fn share(self, load_integral: T) -> T {
        share::<_, 2>(load_integral)
    }

    #[inline(always)]
    fn periods(self, _periods: i32) {}

    #[inline(always)]
    fn with_periods(self, root: (T, T), _periods: ()) -> (T, T) {
        root
    }
}

/// s of y/j, in an octave of 2^`DIGITS` parts.
#[inline(always)]
fn share<T: Scalar, const DIGITS: u32>(ratio: T) -> T {
    let middle = middle_of_part::<_, DIGITS>(ratio);
    (ratio - middle) / (ratio + middle)
}

/// A coefficient C that depends on fields, by which load integrals are divided.
#[derive(Clone, Copy, Debug)]
pub(super) struct Divisor<T> {
    /// 2^`exponent`/C, above 1/2 and at most 1.
    inverse: T,
    /// The exponent of C; that of no normal number if C has no table.
    exponent: i32,
}

impl<T: Scalar> Divisor<T> {
    #[inline(always)]
    pub(super) fn of(c: T) -> Self {
        Self { inverse: fraction(c).recip(), exponent: exponent(c) }
    }

    /// From 1/C.
    #[inline(always)]
    fn of_inverse(inverse: T) -> Self {
        let exponent = exponent(inverse);
        // One that is not of a normal number has to remain so.
        let exponent = if is_normal::<T>(exponent) { -exponent } else { exponent };
        Self { inverse: fraction(inverse), exponent }
    }

    /// y/C, divided by a power of two.
    #[inline(always)]
    fn quotient(self, load_integral: T) -> T {
        fraction(load_integral) * self.inverse
    }

    /// s of y/C, in an octave of 2^`DIGITS` parts.
    #[inline(always)]
    pub(super) fn share<const DIGITS: u32>(self, load_integral: T) -> T {
        share::<_, DIGITS>(self.quotient(load_integral))
    }

    /// y/C without whole periods, and how many these are. `fold` takes them out of parts of octaves, 2^`DIGITS` of each.
    #[inline(always)]
    pub(super) fn in_table<const DIGITS: u32>(
        self,
        load_integral: T,
        fold: impl Fn(i32) -> (i32, i32),
    ) -> (T, i32) {
        let exponent_of_load = exponent(load_integral);
        let octaves = exponent_of_load - self.exponent;
        let part = part_of_octave::<_, DIGITS>(self.quotient(load_integral));
        let (place, periods) = fold(part + (octaves << DIGITS));
        // With the sign set, an exponent is not that of a normal number; zero lies in no table.
        let has_place = is_normal::<T>(exponent_of_load) & is_normal::<T>(self.exponent);
        (if has_place { least_of_quarter(place) } else { T::zero() }, periods)
    }
}

/// C w aᵖ with p = `K`/`Q`. One table, which includes w and has 2^`DIGITS` rows per octave, serves all C.
#[derive(Clone, Copy, Debug)]
pub struct SingleTerm<T, const K: u32, const Q: i32, const DIGITS: u32>(Divisor<T>);

impl<T: Scalar, const K: u32, const Q: i32, const DIGITS: u32> SingleTerm<T, K, Q, DIGITS> {
    /// From C.
    #[inline(always)]
    pub fn of(c: T) -> Self {
        Self(Divisor::of(c))
    }

    /// From 1/C.
    #[inline(always)]
    pub fn of_inverse(inverse: T) -> Self {
        Self(Divisor::of_inverse(inverse))
    }
}

impl<T: Scalar, const K: u32, const Q: i32, const DIGITS: u32> Term<T> for SingleTerm<T, K, Q, DIGITS> {
    /// The octaves by which they raise the root.
    type Periods = i32;

    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        self.0.in_table::<DIGITS>(
            load_integral,
            #[inline(always)]
            |parts| {
                // Whole periods are added so that the number is never negative.
                let periods_below = const { MOST_OCTAVES.div_ceil(K) };
                let parts = (parts as u32).wrapping_add((periods_below * K) << DIGITS);
                let inverse = const { (1 << DIGITS_OF_INVERSE) / K + 1 };
                let periods = (parts >> DIGITS).wrapping_mul(inverse) >> DIGITS_OF_INVERSE;
                (
                    parts.wrapping_sub((periods * K) << DIGITS) as i32,
                    periods.wrapping_sub(periods_below) as i32,
                )
            },
        )
    }

    #[inline(always)]
    fn share(self, load_integral: T) -> T {
        self.0.share::<DIGITS>(load_integral)
    }

    #[inline(always)]
    fn periods(self, periods: i32) -> i32 {
        periods * Q
    }

    #[inline(always)]
    fn with_periods(self, (root, rest): (T, T), octaves: i32) -> (T, T) {
        let unit = power_of_two::<T>(octaves);
        (root * unit, rest * unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a quotient is in a table of all quarters, and how it differs from the middle there.
    fn place_and_share(divisor: Divisor<f64>, load_integral: f64) -> (f64, f64) {
        let (in_table, _) = divisor.in_table::<2>(load_integral, |place| (place, 0));
        (in_table, divisor.share::<2>(load_integral))
    }

    #[test]
    fn a_divisor_may_be_given_by_its_inverse() {
        for (c, inverse) in [(0.125, 8.0), (1024.0, 2f64.powi(-10)), (0.4, 2.5), (6.25, 0.16)] {
            for load_integral in [0.03, 1.0, 1.7, 3e8] {
                let (place, share) = place_and_share(Divisor::of(c), load_integral);
                let (same_place, same_share) = place_and_share(Divisor::of_inverse(inverse), load_integral);
                assert_eq!(same_place, place, "{load_integral}/{c}");
                assert!((same_share - share).abs() < f64::EPSILON, "{load_integral}/{c}");
            }
        }
    }

    #[test]
    fn invalid_divisors_find_no_row() {
        for c in [0.0, f64::MIN_POSITIVE / 2.0, -2.0, f64::INFINITY, f64::NAN] {
            for divisor in [Divisor::of(c), Divisor::of_inverse(c)] {
                assert_eq!(place_and_share(divisor, 1.0).0, 0.0, "{c}");
            }
        }
    }
}
