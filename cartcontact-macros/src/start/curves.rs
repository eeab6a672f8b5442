//! [`Geometry`] -> [`Curves`]: the contact radius as a polynomial in every row of a table, for constants whose powers are
//! not whole, or many.
//!
//! A step from a seed would have to form all these powers. A row has their result instead: around the middle u of the
//! row, where the radius is A,
//!
//! ```text
//! a(y) = A (1 + b₁ η + b₂ η² + …),     η = (y − u)/u,  |η| ≤ 1/9
//! ```
//!
//! is the inverse of J(A (1 + z))/u = 1 + g₁ z + g₂ z² + …, in which g_k = Σ τ binom(p, k) with the shares τ = j A^p/u of
//! the terms.
//!
//! **Shortening.** The series is cut off after η¹⁶, which leaves 10⁻¹⁸ as long as J is nearly a power. Then multiples
//! of Chebyshev polynomials are taken away until 12 powers are left, in single precision 6: T_k is at most 1 over the
//! row, and its leading coefficient 2^(k−1), so that η^k costs no more than (1/9)^k/2^(k−1). Rows that lose more than
//! ε/16 by either are left out, and with them all next to a double zero of J′, where the series does not converge.
//!
//! **Digits.** Only A needs more than f64 has. It is found near a = b^q, where b is an f64 and q the common denominator
//! of the powers, so that all a^p are whole powers of b. All else is less than 1/33 of A, as p > 4, and is computed with
//! the digits of f64.

use core::ops::Range;

use num_traits::ToPrimitive;

use crate::closed_forms::PowerSum;
use crate::geometry::Geometry;
use crate::number::float::{Float, ONE};
use crate::number::{Rational, common_denominator, integer};
use crate::start::load_integral::LoadIntegral;
use crate::start::table::{
    Bytes, FEWEST_ROWS, LARGEST_SINGLE, OCTAVES, ROWS_PER_OCTAVE, Table, lower_end, top,
};

/// The powers of the series before it is shortened, and after it.
const SERIES: usize = 16;
const POWERS: usize = 12;
const POWERS_OF_SINGLE: usize = 6;

/// The highest common denominator of powers: surpluses up to q ε are still small to second order.
const HIGHEST_DENOMINATOR: u32 = 1 << 16;

/// ε/16 of f64, and of f32.
const ALLOWED_ERROR: f64 = f64::EPSILON / 16.0;
const ALLOWED_ERROR_OF_SINGLE: f64 = f32::EPSILON as f64 / 16.0;

/// Half the width of a row, in units of the power of two at or below it.
const HALF_WIDTH: f64 = 1.0 / (2 * ROWS_PER_OCTAVE) as f64;

/// The tables for both formats.
pub(crate) struct Curves {
    pub(crate) double: Table<DoubleRow>,
    pub(crate) single: Table<SingleRow>,
}

impl Curves {
    pub(crate) const SIZES_IN_BYTES: [usize; 2] =
        [Table::<DoubleRow>::size_in_bytes(), Table::<SingleRow>::size_in_bytes()];
}

/// Coefficients of the powers of y − u, those from the second to the ninth, A and the first; with the digits of f32 the
/// other three and what A lacks. The solver takes them in pairs, c₂ with c₄ and c₃ with c₅.
#[derive(Clone, Copy)]
pub(crate) struct DoubleRow {
    pub(crate) words: [f64; 10],
    pub(crate) rests: [f32; 4],
}

/// A, what it lacks, and the coefficients of the powers of y − u.
pub(crate) type SingleRow = [f32; POWERS_OF_SINGLE + 2];

impl Bytes for DoubleRow {
    fn bytes(&self) -> Vec<u8> {
        let words = self.words.iter().flat_map(|number| number.to_le_bytes());
        words.chain(self.rests.bytes()).collect()
    }
}

/// Coefficients from the zeroth power on.
type Series = [f64; SERIES + 1];

/// The curve of a row: three parts of A, and the coefficients of the powers of t = (y − u)/(half the width) in
/// units of A.
struct Curve {
    radius: [f32; 3],
    series: Series,
}

/// The tables of a geometry of constants, if they have enough rows.
pub(crate) fn curves(geometry: &Geometry, load_integral: &PowerSum) -> Option<Curves> {
    let source = Source::of(load_integral)?;
    let top = top(geometry, |a| source.sum.at(a).value)? * ROWS_PER_OCTAVE;
    let first = top - OCTAVES * ROWS_PER_OCTAVE;
    let (mut double, mut single) = (Vec::new(), Vec::new());
    for (curve, index) in source.curves(first..top).iter().zip(first..) {
        let is_single = lower_end(index).log2().abs() < LARGEST_SINGLE;
        double.push(curve.as_ref().and_then(Curve::double_row).map(|row| (row, false)));
        single.push(curve.as_ref().filter(|_| is_single).and_then(Curve::single_row).map(|row| (row, true)));
    }
    let double = Table::of(first, &double).filter(|table| table.rows.len() >= FEWEST_ROWS)?;
    Some(Curves { double, single: Table::of(first, &single).unwrap_or_else(Table::empty) })
}

/// J exactly, and with the digits of f64.
struct Source {
    sum: LoadIntegral,
    /// The size of each coefficient.
    sizes: Vec<Float>,
    /// The common denominator of the powers, and the powers times it.
    denominator: u32,
    numerators: Vec<u32>,
}

impl Source {
    fn of(load_integral: &PowerSum) -> Option<Self> {
        let summands = &load_integral.summands;
        let common = common_denominator(summands.iter().map(|summand| &summand.exponent));
        let denominator = common.to_u32().filter(|&denominator| denominator <= HIGHEST_DENOMINATOR)?;
        let (mut terms, mut sizes, mut numerators) = (Vec::new(), Vec::new(), Vec::new());
        for summand in summands {
            let (j, p) = (summand.constant()?, &summand.exponent);
            terms.push((j.to_f64(), p.to_f64()));
            sizes.push(Float::of(&j.abs())?);
            numerators.push((p * integer(denominator)).to_u32()?);
        }
        Some(Self { sum: LoadIntegral { terms }, sizes, denominator, numerators })
    }

    fn curves(&self, indices: Range<i32>) -> Vec<Option<Curve>> {
        let mut near = self.sum.radius(lower_end(indices.start));
        let curves = indices.map(|index| {
            let (octave, quarter) = (index.div_euclid(ROWS_PER_OCTAVE), index.rem_euclid(ROWS_PER_OCTAVE));
            let middle = 1.0 + f64::from(2 * quarter + 1) * HALF_WIDTH;
            let y = middle * 2f64.powi(octave);
            near = near.and_then(|near| self.sum.radius_near(near, y));
            self.curve(near?, y, HALF_WIDTH / middle)
        });
        curves.collect()
    }

    /// The curve around `y`, whose radius is `near`, for a row that is wider than y by this share on either side.
    fn curve(&self, near: f64, y: f64, half_width: f64) -> Option<Curve> {
        let root = Float::of(&Rational::from_float(near.powf(f64::from(self.denominator).recip()))?)?;
        let inverse = Float::of(&Rational::from_float(y)?.recip())?;
        let (mut surplus, mut shares) = (-ONE, Vec::new());
        for ((&size, &numerator), &(j, _)) in self.sizes.iter().zip(&self.numerators).zip(&self.sum.terms) {
            let share = size.times(inverse).times(root.power(numerator));
            // Larger ones are not fixed-point numbers, and nearly cancel.
            let share = if share.log2() < 1.0 { share.fixed() } else { return None };
            let share = if j < 0.0 { -share } else { share };
            // On the way to a sum near 0 it may leave the range of fixed-point numbers, and comes back.
            surplus = surplus.wrapping_add(share);
            shares.push(share as f64 / ONE as f64);
        }
        // The rounded root is a little off, and b^q by q ε/2: so are the radius and the shares.
        let powers = || self.sum.terms.iter().map(|&(_, p)| p);
        let slope: f64 = shares.iter().zip(powers()).map(|(share, p)| p * share).sum();
        let excess = surplus as f64 / slope;
        let radius = root.power(self.denominator).less(excess as i128);
        for (share, p) in shares.iter_mut().zip(powers()) {
            *share -= p * *share * (excess / ONE as f64);
        }
        let series = stretched(inverse_of(&self.ascending(&shares)), half_width);
        (series[SERIES].abs() < ALLOWED_ERROR).then_some(Curve { radius: radius.in_parts()?, series })
    }

    /// g₀ = 1, g₁, … from the shares of the terms.
    fn ascending(&self, shares: &[f64]) -> Series {
        let mut sums = [0.0; SERIES + 1];
        for (&share, &(_, p)) in shares.iter().zip(&self.sum.terms) {
            let mut addend = share;
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum += addend;
                addend *= (p - k as f64) / (k + 1) as f64;
            }
        }
        sums
    }
}

/// The coefficients of Σ c x^k as a series in x/`unit`.
fn stretched(mut series: Series, unit: f64) -> Series {
    let mut power = 1.0;
    for coefficient in &mut series {
        *coefficient *= power;
        power *= unit;
    }
    series
}

/// 1, b₁, b₂, … with z = b₁ η + b₂ η² + … where g₁ z + g₂ z² + … = η.
///
/// The coefficient of η^k in z^j, j > 1, follows from those of z and z^(j−1) below η^k.
fn inverse_of(ascending: &Series) -> Series {
    // powers[j − 1][k] belongs to η^k in z^j.
    let mut powers = [[0.0; SERIES + 1]; SERIES];
    for k in 1..=SERIES {
        let mut left = if k == 1 { 1.0 } else { 0.0 };
        for j in 2..=k {
            // Plain loops: nothing in a macro is optimised.
            let mut product = 0.0;
            for i in 1..k + 2 - j {
                product += powers[0][i] * powers[j - 2][k - i];
            }
            powers[j - 1][k] = product;
            left -= ascending[j] * product;
        }
        powers[0][k] = left / ascending[1];
    }
    let [mut series, ..] = powers;
    series[0] = 1.0;
    series
}

impl Curve {
    /// The coefficients of the powers of y − u with only `powers` of them left, in units of A; none if that loses more
    /// than `allowed`.
    fn shortened(&self, powers: usize, allowed: f64) -> Option<Series> {
        let (mut series, mut lost) = (self.series, 0.0);
        for (k, chebyshev) in CHEBYSHEV.iter().enumerate().skip(powers + 1).rev() {
            let amount = series[k] / chebyshev[k];
            for (coefficient, of_chebyshev) in series.iter_mut().zip(chebyshev) {
                *coefficient -= amount * of_chebyshev;
            }
            lost += amount.abs();
        }
        // Not true for NaN.
        (lost <= allowed).then(|| stretched(series, 1.0 / HALF_WIDTH))
    }

    fn double_row(&self) -> Option<DoubleRow> {
        let series = self.shortened(POWERS, ALLOWED_ERROR)?;
        let [first, second, third] = self.radius.map(f64::from);
        let size = (first + second) + third;
        // What shortening takes from `series[0]`, less than ε/16, does not change that 1.
        let lost = ((first + second) - size) + third;
        let c = |k: usize| size * series[k];
        Some(DoubleRow {
            words: [c(2), c(4), c(3), c(5), c(6), c(8), c(7), c(9), size, c(1)],
            rests: [c(10), c(12), c(11), lost].map(|rest| rest as f32),
        })
    }

    fn single_row(&self) -> Option<SingleRow> {
        let series = self.shortened(POWERS_OF_SINGLE, ALLOWED_ERROR_OF_SINGLE)?;
        let [size, lost, _] = self.radius.map(f64::from);
        let lost = lost + size * (series[0] - 1.0);
        let place = |k: usize| match k {
            0 => size,
            1 => lost,
            k => size * series[k - 1],
        };
        Some(core::array::from_fn(|k| place(k) as f32))
    }
}

/// The coefficients of the Chebyshev polynomials T₀, T₁, … by T₍k+1₎ = 2 t T₍k₎ − T₍k−1₎.
const CHEBYSHEV: [Series; SERIES + 1] = {
    let mut all = [[0.0; SERIES + 1]; SERIES + 1];
    (all[0][0], all[1][1]) = (1.0, 1.0);
    let mut k = 2;
    while k <= SERIES {
        let mut i = 0;
        while i <= k {
            let raised = if i == 0 { 0.0 } else { all[k - 1][i - 1] };
            all[k][i] = 2.0 * raised - all[k - 2][i];
            i += 1;
        }
        k += 1;
    }
    all
};
