//! [`Geometry`] -> [`Roots`]: for a gap of one term, the contact radius in the middle of every row of a table.
//!
//! J = j a^p = y has the root a = (y/j)^(1/p); with the middle u of a row and its root A = (u/j)^(1/p),
//!
//! ```text
//! a = A ((1 + s)/(1 − s))^(1/p) = A (1 + c₁ s + c₂ s² + …),     s = (y − u)/(y + u)
//! ```
//!
//! and (1 − s²) d/ds ((1 + s)/(1 − s))^α = 2α ((1 + s)/(1 − s))^α gives (k + 1) c₍ₖ₊₁₎ = 2α cₖ + (k − 1) c₍ₖ₋₁₎.
//!
//! A constant term has its window of y. If C is a symbol, or no length belongs to C r^n, as n ≤ 1, or a window would
//! hold few radii, the table is one of y/C from 1 to 2^k, p = k/q: over this range the radius becomes 2^q times as
//! long. If k is at most 16, the rows are sixteenths of octaves instead of quarters, and fewer terms of the series do.
//! If k is above 64, the table goes from 1 to 2⁶⁴, and a second one has the roots of all powers of 2⁶⁴. The weight w
//! that J has beside a symbol C, j = w C, is contained in the roots, so that the solver need not multiply by it.

use core::ops::Range;

use num_traits::{One, ToPrimitive};

use crate::closed_forms::Summand;
use crate::geometry::Geometry;
use crate::number::float::Float;
use crate::number::{Rational, fraction, integer, rounded};
use crate::start::table::{LARGEST_SINGLE, OCTAVES, Table, top};

pub(crate) struct Roots {
    pub(crate) table: Table,
    /// c₁ and the following coefficients.
    pub(crate) series: Vec<f64>,
    pub(crate) reach: Reach,
}

/// The load integrals whose radii a table leads to.
pub(crate) enum Reach {
    /// Those in the table.
    Window,
    /// All, for any coefficient, as the table is one whole period of the power k/q.
    Periods { k: u32, q: u32, parts: Parts },
    /// The same, with the factors by which spans of 64 octaves multiply radii.
    Spans(Spans),
}

/// 2^(64 h/p) at index h modulo 64: three parts of its fraction, and its exponent.
pub(crate) struct Spans(Vec<([f32; 3], i32)>);

/// This many spans hold the quotients of all normal numbers.
const SPANS: i32 = 64;

/// The parts of octaves that have a row each, and the terms that the series then needs.
#[derive(Clone, Copy)]
pub(crate) struct Parts {
    /// An octave has 2^`digits` of them.
    pub(crate) digits: u32,
    terms: u32,
}

/// Quarters, as in tables of seeds.
const QUARTERS: Parts = Parts { digits: 2, terms: 12 };
const SIXTEENTHS: Parts = Parts { digits: 4, terms: 8 };
/// As many octaves have room for sixteenths.
const OCTAVES_OF_SIXTEENTHS: i32 = OCTAVES >> (SIXTEENTHS.digits - QUARTERS.digits);

/// The lowest power with a window, times 4; slopes of the gap in it then differ by a factor of 2⁸ or more.
const LOWEST_POWER_IN_QUARTERS: i64 = 23;

/// The highest power with a window: it holds four octaves of radii.
const HIGHEST_POWER: i32 = 16;

/// Whether the table of a single term includes its coefficient.
pub(crate) fn has_window(only: &Summand) -> bool {
    let is_short =
        only.exponent >= fraction(LOWEST_POWER_IN_QUARTERS, 4) && only.exponent <= integer(HIGHEST_POWER);
    only.constant().is_some() && is_short
}

/// The table of a single term, if there is one.
pub(crate) fn roots(geometry: &Geometry, only: &Summand) -> Option<Roots> {
    let exponent = &only.exponent;
    let p = exponent.to_f64();
    let window = only.constant().filter(|_| has_window(only)).and_then(|j| {
        let size = j.to_f64();
        Some((j, top(geometry, |a| size * a.powf(p))? - OCTAVES))
    });
    let (octaves, j, reach) = match (window, exponent.numer().to_i32()) {
        (Some((j, bottom)), _) => (bottom..bottom + OCTAVES, Some(j), Reach::Window),
        (None, Some(k @ ..=OCTAVES)) => {
            let parts = if k <= OCTAVES_OF_SIXTEENTHS { SIXTEENTHS } else { QUARTERS };
            let q = exponent.denom().to_u32()?;
            (0..k, only.weight(), Reach::Periods { k: k.unsigned_abs(), q, parts })
        }
        (None, _) => (0..OCTAVES, only.weight(), Reach::Spans(Spans::of(exponent)?)),
    };
    let parts = if let Reach::Periods { parts, .. } = reach { parts } else { QUARTERS };
    let table = table(exponent, octaves, parts, j.unwrap_or(&Rational::one()))?;
    Some(Roots { table, series: series(rounded(&exponent.recip()), parts.terms), reach })
}

impl Spans {
    fn of(p: &Rational) -> Option<Self> {
        let mut rows = vec![([0.0; 3], 0); SPANS as usize];
        for span in -SPANS / 2..SPANS / 2 {
            let (fraction, octave) = Float::real_root(&integer(2).pow(span * OCTAVES), p)?.split();
            rows[span.rem_euclid(SPANS) as usize] = (fraction.in_parts()?, i32::try_from(octave).ok()?);
        }
        Some(Self(rows))
    }

    /// The bytes of the rows in the places where the solver looks for them.
    pub(crate) fn in_places(&self) -> Vec<u8> {
        let row = |&([first, second, third], octave): &([f32; 3], i32)| {
            [first.to_le_bytes(), third.to_le_bytes(), octave.to_le_bytes(), second.to_le_bytes()]
        };
        self.0.iter().flat_map(row).flatten().collect()
    }

    pub(crate) const fn size_in_bytes() -> usize {
        size_of::<[([f32; 3], i32); SPANS as usize]>()
    }
}

/// The rows of these octaves.
fn table(p: &Rational, octaves: Range<i32>, parts: Parts, j: &Rational) -> Option<Table> {
    let (first, rows_per_octave) = (octaves.start, 1 << parts.digits);
    let lowest = |part: i32| {
        let middle = integer(1) + fraction(2 * part + 1, 2 * rows_per_octave);
        Float::real_root(&(middle * integer(2).pow(first) / j), p)
    };
    let octave = Float::real_root(&integer(2), p)?;
    let mut roots = (0..rows_per_octave).map(lowest).collect::<Option<Vec<_>>>()?;
    let mut rows = Vec::new();
    for at in octaves {
        for root in &mut roots {
            let is_held = [f64::from(at), root.log2()].iter().all(|octave| octave.abs() < LARGEST_SINGLE);
            rows.push(root.in_parts().map(|[first, second, third]| ([first, third, 0.0, second], is_held)));
            *root = root.times(octave);
        }
    }
    Table::of(first * rows_per_octave, &rows)
}

/// c₁ and the following coefficients, for α = 1/p.
fn series(alpha: f64, terms: u32) -> Vec<f64> {
    let (mut before, mut c) = (1.0, 2.0 * alpha);
    let terms = (1..=terms).map(|k| {
        let k = f64::from(k);
        let next = (2.0 * alpha * c + (k - 1.0) * before) / (k + 1.0);
        (before, c) = (c, next);
        before
    });
    terms.collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;

    #[test]
    fn series_are_those_of_powers() {
        for alpha in [0.25, 1.0 / 6.0, 10.0 / 63.0, 1.0 / 68.0] {
            for Parts { digits, terms } in [QUARTERS, SIXTEENTHS] {
                let most = 1.0 / f64::from((4 << digits) + 1);
                for s in [-most, -0.17 * most, 0.34 * most, most] {
                    let sum = series(alpha, terms).iter().rev().fold(0.0, |sum, c| (sum + c) * s);
                    let power = (2.0 * alpha * s.atanh()).exp_m1();
                    let bound = 8.0 * f64::EPSILON * power.abs();
                    assert!((sum - power).abs() < bound, "{alpha}, {s}: {sum}, not {power}");
                }
            }
        }
    }

    #[test]
    fn spans_are_powers_of_the_first() {
        let Spans(rows) = Spans::of(&fraction(637, 100)).unwrap();
        let root = |span: i32| {
            let (parts, octave) = rows[span.rem_euclid(SPANS) as usize];
            parts.map(f64::from).iter().sum::<f64>().ln() + f64::from(octave) * core::f64::consts::LN_2
        };
        assert_eq!(rows[0], ([1.0, 0.0, 0.0], 0));
        for span in -32..32 {
            // The logarithms go up to 450 and are rounded in sums and products.
            let error = root(span) - f64::from(span) * root(1);
            assert!(error.abs() < 1e-12, "{span}: {error:e}");
        }
        let expected = 64.0 / 6.37 * core::f64::consts::LN_2;
        assert!((root(1) - expected).abs() < 4.0 * f64::EPSILON * expected);
    }

    #[test]
    fn rows_are_roots_of_their_middles() {
        let tables = [
            (5, 1, QUARTERS, -7..57),
            (9, 2, SIXTEENTHS, 0..9),
            (16, 3, SIXTEENTHS, 0..16),
            (25, 4, QUARTERS, -7..57),
            (63, 10, QUARTERS, -7..57),
        ];
        for (k, q, parts, octaves) in tables {
            let (p, start, per_octave) = (fraction(k, q), octaves.start, 1 << parts.digits);
            let table = table(&p, octaves, parts, &fraction(1, 30)).unwrap();
            for (row, &[first, third, rest, second]) in (0..).zip(&table.rows) {
                let part = fraction(2 * (row % per_octave) + 1, 2 * per_octave);
                let middle = integer(2).pow(row / per_octave + start) * (integer(1) + part);
                let root = Float::real_root(&(middle * integer(30)), &p).unwrap().in_parts().unwrap();
                assert_eq!(([first, second], rest), ([root[0], root[1]], 0.0), "{row} of {k}/{q}");
                assert!((third - root[2]).abs() <= 2f32.powi(-72) * first, "{row} of {k}/{q}: {third:e}");
            }
        }
    }
}
