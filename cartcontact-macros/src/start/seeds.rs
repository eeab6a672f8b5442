//! [`Geometry`] -> [`Seeds`]: the contact radius to six digits as a table of cubics.
//!
//! J(a) = y is solved in one step of Halley's method from a seed that is near enough. As a ≈ y^(1/p) with p > 4, a(y)
//! is so smooth within a quarter of an octave of y that a cubic approximates it to 8 · 10⁻⁷ at p = 4, and to less above.
//! Rows of single precision hold such a cubic in the fraction f of y = f · 2^e, 1 ≤ f < 2.
//!
//! **The cubics** interpolate at four points next to Chebyshev's. Because J is explicit, the points are chosen as
//! radii: only the ends of the rows require the solution of an equation.
//!
//! **Roots.** If the powers are multiples of a common fraction such as 1/2 or 1/10, a stands for the root of the radius
//! in which all powers are whole.
//!
//! **The check.** One step leaves |C| e³ of a relative error e, where C = (a J″/2J′)² − a² J‴/6J′. The step for a root
//! beyond the square root has one more order, with p²/12 in C, p = a J′/J, and leaves |C − p²/12| e³. Every row is
//! evaluated as in the solver, in single precision, between its points and at an end, and with the loss where single
//! precision is all there is. The longest run of rows that stay below ε/8 is kept, for symbols the first run, and none
//! if it is shorter than eight octaves.

use core::ops::Range;

use num_traits::One;

use crate::closed_forms::{PowerSum, Stepped, Summand};
use crate::geometry::Geometry;
use crate::number::Rational;
use crate::start::load_integral::{Derivatives, LoadIntegral};
use crate::start::own_units;
use crate::start::table::{
    FEWEST_ROWS, LARGEST_DOUBLE, LARGEST_SINGLE, OCTAVES, ROWS_PER_OCTAVE, Row, Table, lower_end, top,
};

/// The octaves of a window that may lie above the load integral at which two terms are equal; 30 are left below it, where
/// the first term outweighs the second.
const MOST_OCTAVES_ABOVE_EQUALITY: f64 = 34.0;
/// The octaves of y on either side of that load integral in which single precision holds what a step computes: 20 fewer
/// than the window has, as coefficients may be 36.5 octaves from 1 (10^±11), see `EqualTerms`. Double precision holds a
/// whole window.
const LARGEST_SINGLE_OF_SYMBOLS: f64 = 44.0;
/// ε/8.
const ALLOWED_ERROR: f64 = f64::EPSILON / 8.0;
const ALLOWED_ERROR_OF_SINGLE: f64 = f32::EPSILON as f64 / 8.0;
/// The loss of a number that is rounded to half the digits of single precision, of which one is implied.
const CUT_OFF: f64 = 1.0 / 4096.0;
/// A factor on the measured error, for what lies between the points of the check.
const MARGIN: f64 = 1.25;
/// Where a cubic interpolates, as shares of a row: (1 ± cos(π/8))/2 and (1 ± cos(3π/8))/2, the zeros of Chebyshev's
/// polynomial of the fourth degree.
const NODES: [f64; 4] = [0.961_94, 0.691_34, 0.308_66, 0.038_06];
/// Where it is checked: at an end, and near the middle of each pair of nodes, where the error is largest.
const CHECKS: [f64; 4] = [1e-3, 0.15, 0.5, 0.85];

/// A table, and the J that it belongs to.
pub(crate) struct Seeds {
    pub(crate) table: Table,
    /// The coefficients of J, in units of its own if they are symbols.
    pub(crate) factors: Vec<f64>,
    /// The number by which a step divides a J′, and by whose square it divides a² J″/2.
    pub(crate) unit: Rational,
}

/// The table of a geometry, if its rows are near enough to the radius, or to the root in which J has whole powers.
pub(crate) fn seeds(geometry: &Geometry, stepped: &Stepped) -> Option<Seeds> {
    let is_constant = geometry.gap.is_constant();
    let load_integral = &stepped.load_integral;
    let factors: Vec<f64> = if is_constant {
        let constants = load_integral.summands.iter().map(|summand| summand.constant().map(Rational::to_f64));
        constants.collect::<Option<_>>()?
    } else {
        own_units::factors(&geometry.gap, load_integral)?
    };
    let exponents = load_integral.summands.iter().map(|summand| summand.exponent.to_f64());
    let terms = factors.iter().copied().zip(exponents).collect();
    let largest_single = if is_constant { LARGEST_SINGLE } else { LARGEST_SINGLE_OF_SYMBOLS };
    let unit = unit(load_integral);
    let steps = Steps::new(terms, stepped.root, logarithm(unit.to_f64()), largest_single);
    let top = if is_constant {
        top(geometry, |a| steps.sum.at(a.powf(steps.root.recip())).value)
    } else {
        steps.octaves_above_equality()
    };
    let top = top? * ROWS_PER_OCTAVE;
    let bottom = top - OCTAVES * ROWS_PER_OCTAVE;
    let rows = steps.rows(bottom..top);
    let table = Table::of(bottom, if is_constant { &rows } else { before_first_gap(&rows) });
    Some(Seeds { table: table.filter(|table| table.rows.len() >= FEWEST_ROWS)?, factors, unit })
}

/// The coefficient of the highest power in a J′, which is then 1 and spares a multiplication.
///
/// 1 if that would leave coefficients near the end of the format, as in expansions of a sphere beyond r⁴⁰, and if one
/// is a symbol: the ratio of two has no bound.
fn unit(load_integral: &PowerSum) -> Rational {
    let constants: Option<Vec<_>> = load_integral.summands.iter().map(Summand::constant).collect();
    let last = constants.and_then(|constants| constants.last().copied()).zip(load_integral.summands.last());
    let highest = last.map(|(constant, summand)| constant * &summand.exponent);
    let is_near_one = |highest: &Rational| 2.0 * logarithm(highest.to_f64()).abs() < LARGEST_DOUBLE;
    highest.filter(is_near_one).unwrap_or_else(Rational::one)
}

fn logarithm(number: f64) -> f64 {
    number.abs().log2()
}

/// The rows up to the first gap. After a gap, J may have turned back, and no radius may be admissible: with constants,
/// the range ends there.
fn before_first_gap(rows: &[Option<Row>]) -> &[Option<Row>] {
    let first = rows.iter().position(Option::is_some).unwrap_or(0);
    let count = rows[first..].iter().position(Option::is_none);
    &rows[..count.map_or(rows.len(), |count| first + count)]
}

/// J as a step from a row takes it.
struct Steps {
    sum: LoadIntegral,
    /// The radii are roots with this index.
    root: f64,
    /// The share of a that is cut off in single precision.
    cut_off: f64,
    /// The largest |log₂ y| that single precision may meet.
    largest_single: f64,
    /// The largest |log₂| of the coefficients of J, J′ and J″, from which a unit is taken out once and twice.
    largest_coefficient: f64,
    /// log₂ of the unit of J′.
    unit: f64,
    lowest: f64,
    /// The highest power that a step forms. With whole powers it is the lowest of J, or the ratio of one to the next
    /// or, as terms are added in pairs, to the next but one.
    highest_formed: f64,
}

impl Steps {
    fn new(terms: Vec<(f64, f64)>, root: u32, unit: f64, largest_single: f64) -> Self {
        let in_units = |&(j, _): &(f64, f64)| {
            let size = logarithm(j);
            size.abs().max((size - unit).abs()).max((size - 2.0 * unit).abs())
        };
        let largest_coefficient = terms.iter().map(in_units).fold(0.0, f64::max);
        let powers = || terms.iter().map(|&(_, p)| p);
        let lowest = powers().next().unwrap_or(0.0);
        let highest_formed = if powers().all(|p| p.fract() == 0.0) {
            let ratios = |apart| powers().zip(powers().skip(apart)).map(|(p, next)| next - p);
            ratios(1).chain(ratios(2)).fold(lowest, f64::max)
        } else {
            powers().fold(lowest, f64::max)
        };
        let cut_off = if root > 2 { 0.0 } else { CUT_OFF };
        let root = f64::from(root);
        let sum = LoadIntegral { terms };
        Self { sum, root, cut_off, largest_single, largest_coefficient, unit, lowest, highest_formed }
    }

    /// The octaves of its window above the load integral at which the first two terms are equal.
    ///
    /// The second term is mostly the correction. If its power is little higher, it is a correction already many octaves
    /// of the radius before, and the window goes far down; if its power is much higher, both sides have radii that are
    /// 2.5 octaves away, or nearly. If the second term is negative, J turns back before.
    fn octaves_above_equality(&self) -> Option<i32> {
        let [(_, first), (sign, second), ..] = self.sum.terms[..] else { return None };
        if sign < 0.0 {
            return Some(0);
        }
        let octaves_of_radius = (2.0 * (second - first) / self.root).min(2.5);
        Some((second / self.root * octaves_of_radius).min(MOST_OCTAVES_ABOVE_EQUALITY) as i32)
    }

    /// The rows with these indices that pass the check.
    fn rows(&self, indices: Range<i32>) -> Vec<Option<Row>> {
        let mut low = self.sum.radius(lower_end(indices.start));
        let rows = indices.map(move |index| {
            let high = low.and_then(|low| self.sum.radius_near(low, lower_end(index + 1)));
            let ends = core::mem::replace(&mut low, high).zip(high)?;
            let ([c0, c1, c2, c3], is_held) = self.row(index, ends)?;
            // In the order in which the solver has them.
            Some(([c0, c2, c1, c3], is_held))
        });
        rows.collect()
    }

    /// The largest logarithm of what a step from `a` computes: coefficients, powers, J and its derivatives divided by
    /// the lowest power and by the unit, and products of these.
    fn largest_logarithm(&self, a: f64, at: &Derivatives) -> f64 {
        let [y, a, first, second] = [at.value, a, at.first, at.second].map(|size| size.abs().log2());
        let power = self.lowest * a;
        let log_slope = first - self.unit;
        let slope = log_slope - power;
        let step = a - self.unit + slope;
        // A small value does no harm.
        let curvature = (second - 2.0 * self.unit - power).max(0.0);
        let powers = [self.largest_coefficient, self.highest_formed * a, y, y - power];
        let products = [slope, log_slope, log_slope + slope, step, step + y, curvature, curvature + y];
        powers.into_iter().chain(products).map(f64::abs).fold(0.0, f64::max)
    }

    /// The cubic for the row between two radii, if it passes the check.
    fn row(&self, index: i32, (low, high): (f64, f64)) -> Option<Row> {
        let unit = 2f64.powi(index.div_euclid(ROWS_PER_OCTAVE));
        let between = |share: f64| low * (high / low).powf(share);
        let radii = NODES.map(between);
        let fractions = radii.map(|a| self.sum.at(a).value / unit);
        let row = interpolate(fractions, radii).map(|coefficient| coefficient as f32);
        let mut largest = 0.0_f64;
        let mut passes = |share: f64| {
            let a = between(share);
            let at = self.sum.at(a);
            let error = MARGIN * (f64::from(value(row, at.value)) / a - 1.0).abs();
            let (half_second, third) = (at.second / (2.0 * at.first), at.third / (6.0 * at.first));
            let next_order = if self.root > 2.0 { (at.first / at.value).powi(2) / 12.0 } else { 0.0 };
            let of_a = (half_second * half_second - third - next_order).abs();
            let left = |error: f64| self.root * of_a * error * error * error;
            largest = largest.max(self.largest_logarithm(a, &at));
            left(error) <= ALLOWED_ERROR && left(error + self.cut_off) <= ALLOWED_ERROR_OF_SINGLE
        };
        let is_near = CHECKS.into_iter().all(&mut passes);
        let is_single = largest < LARGEST_SINGLE && unit.log2().abs() <= self.largest_single;
        (is_near && largest < LARGEST_DOUBLE).then_some((row, is_single))
    }
}

/// The cubic as the solver evaluates it at y, whose fraction is cut off after 23 bits.
fn value(row: [f32; 4], y: f64) -> f32 {
    let f = f32::from_bits((y.to_bits() >> 29) as u32 & 0x007f_ffff | 0x3f80_0000);
    (row[0] + row[1] * f) + (row[2] + row[3] * f) * (f * f)
}

/// The coefficients of the cubic through four points (f, a), by divided differences.
fn interpolate(nodes: [f64; 4], values: [f64; 4]) -> [f64; 4] {
    let mut differences = values;
    for order in 1..4 {
        for index in (order..4).rev() {
            differences[index] =
                (differences[index] - differences[index - 1]) / (nodes[index] - nodes[index - order]);
        }
    }
    // Newton's form multiplied out, from the innermost bracket.
    let mut cubic = [0.0; 4];
    for index in (0..4).rev() {
        for power in (1..4).rev() {
            cubic[power] = cubic[power - 1] - nodes[index] * cubic[power];
        }
        cubic[0] = differences[index] - nodes[index] * cubic[0];
    }
    cubic
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;

    impl Steps {
        fn octave(&self, octave: i32) -> Option<Vec<[f32; 4]>> {
            let rows = octave * ROWS_PER_OCTAVE..(octave + 1) * ROWS_PER_OCTAVE;
            let ends = |index| self.sum.radius(lower_end(index)).zip(self.sum.radius(lower_end(index + 1)));
            rows.map(|index| Some(self.row(index, ends(index)?)?.0)).collect()
        }
    }

    /// At points other than the check's.
    #[test]
    fn seeds_have_six_digits() {
        let two_terms =
            Steps::new(vec![(0.025 / 12.0, 6.0), (1.09375e-4 / 12.0, 8.0)], 1, 0.0, LARGEST_SINGLE);
        for octave in -20..30 {
            let rows = two_terms.octave(octave).unwrap();
            for k in 0..1000 {
                let y = 2f64.powi(octave) * (1.0 + f64::from(k) / 1000.0);
                let seed = f64::from(value(rows[k as usize / 250], y));
                let error = seed / two_terms.sum.radius(y).unwrap() - 1.0;
                assert!(error.abs() < 1e-6, "{y}: {error:e}");
            }
        }
    }

    /// Where J has a maximum, as at the end of an admissible range, no step leads to the radius.
    #[test]
    fn rows_that_are_too_coarse_are_left_out() {
        let oblate = Steps::new(vec![(0.025 / 12.0, 6.0), (-1e-4 / 12.0, 8.0)], 1, 0.0, LARGEST_SINGLE);
        let end = 187.5_f64.sqrt();
        let last = oblate.sum.at(end).value.log2().floor() as i32;
        assert!(oblate.octave(last).is_none());
        assert!(oblate.octave(last - 3).is_some());
    }

    #[test]
    fn cubics_are_reproduced() {
        let nodes = [1.0, 1.1, 1.2, 1.5];
        let expected = [3.0, -1.0, 0.0, 2.0];
        let found = interpolate(nodes, nodes.map(|f| 3.0 - f + 2.0 * f * f * f));
        assert!(found.iter().zip(expected).all(|(c, e)| (c - e).abs() < 1e-11), "{found:?}");
    }
}
