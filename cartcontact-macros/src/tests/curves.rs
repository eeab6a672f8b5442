//! Polynomials for the contact radius, against J in 128 digits.

use super::on_unit;
use crate::closed_forms::ClosedForms;
use crate::number::Rational;
use crate::number::float::{Float, ONE};
use crate::start::Start;
use crate::start::curves::{Curves, DoubleRow, SingleRow};
use crate::start::table::lower_end;

const SUMS: [&str; 6] = [
    "0.02 * r^(2/3) + 1e-3 * r^2",
    "0.02 * r^0.25 + 1e-3 * r^8.75",
    "0.02 * r^0.61 + 1e-3 * r^2.29 + 1e-5 * r^4.83",
    "0.02 * r^2.0001 + 1e-3 * r^2.37",
    "0.02 * r^1.8 - 1e-5 * r^4.6, max_radius = 6",
    "sphere(10), order = 40, max_radius = 9",
];

fn start(text: &str) -> (ClosedForms, Option<Start>) {
    let geometry = on_unit(text).unwrap();
    let forms = ClosedForms::of(&geometry.gap);
    let start = Start::of(&geometry, &forms);
    (forms, start)
}

fn curves(text: &str) -> (ClosedForms, Curves) {
    match start(text) {
        (forms, Some(Start::Curves(curves))) => (forms, curves),
        _ => unreachable!("{text} has no curves"),
    }
}

/// The share of itself by which a radius of `y` is too large, from J(a)/y and from a J′(a)/y.
fn error(forms: &ClosedForms, radius: f64, y: f64) -> f64 {
    let [radius, inverse] = [radius, y].map(|number| Rational::from_float(number).unwrap());
    let inverse = Float::of(&inverse.recip()).unwrap();
    let (mut surplus, mut slope) = (-ONE, 0.0);
    for summand in &forms.load_integral.summands {
        let (j, p) = (summand.constant().unwrap(), &summand.exponent);
        let power = Float::real_root(&radius, &p.recip()).unwrap();
        let share = Float::of(&j.abs()).unwrap().times(inverse).times(power).fixed();
        let share = if j.is_negative() { -share } else { share };
        surplus += share;
        slope += p.to_f64() * share as f64;
    }
    surplus as f64 / slope
}

/// The place of y in its row, as the solver computes it.
fn from_middle(y: f64) -> f64 {
    let fraction = y / 2f64.powf(y.log2().floor());
    fraction - (1.125 + 0.25 * ((fraction - 1.0) * 4.0).floor())
}

fn value(&DoubleRow { words, rests }: &DoubleRow, y: f64) -> f64 {
    let w = from_middle(y);
    let [c2, c4, c3, c5, c6, c8, c7, c9, radius, c1] = words;
    let [c10, c12, c11, rest] = rests.map(f64::from);
    let coefficients = [c12, c11, c10, c9, c8, c7, c6, c5, c4, c3, c2, c1];
    radius + (rest + w * coefficients.iter().fold(0.0, |sum, c| sum * w + c))
}

fn value_of_single(row: &SingleRow, y: f32) -> f32 {
    let w = from_middle(y.into()) as f32;
    row[0] + (row[1] + w * row[2..].iter().rev().fold(0.0, |sum, c| sum * w + c))
}

/// From one end of a row to the other: half an ε for the result, and little for all else.
#[test]
fn radii_are_rounded_once() {
    for text in SUMS {
        let (forms, Curves { double, single }) = curves(text);
        for (place, share) in
            [0.0, 0.03, 0.2, 0.5, 0.71, 0.97, 0.999].into_iter().cycle().enumerate().take(256)
        {
            let at = |first: i32| {
                let [low, high] = [0, 1].map(|above| lower_end(first + place as i32 + above));
                low + share * (high - low)
            };
            let y = at(double.first);
            let of_double = error(&forms, value(&double.rows[place], y), y) / f64::EPSILON;
            let y = at(single.first) as f32;
            let found = value_of_single(&single.rows[place], y).into();
            let of_single = error(&forms, found, y.into()) / f64::from(f32::EPSILON);
            let are_small = of_double.abs() < 0.56 && of_single.abs() < 0.56;
            assert!(are_small, "{text}, row {place}: {of_double} ε, {of_single} ε");
        }
    }
}

#[test]
fn curves_cover_what_seeds_cover() {
    for text in SUMS {
        let (_, Curves { double, single }) = curves(text);
        assert_eq!((double.rows.len(), single.rows.len()), (256, 256), "{text}");
    }
    // Far apart, or of a common denominator that is too high.
    for text in ["0.02 * r^2.1 + 1e-9 * r^30.3", "0.02 * r^2 + 1e-3 * r^2.3456789"] {
        assert!(
            !matches!(start(text).1, Some(Start::Curves(curves)) if curves.double.rows.len() == 256),
            "{text}"
        );
    }
}

/// Beyond the radius where this gap hardly opens, the first two shares add up to less than −1.
#[test]
fn sums_of_shares_may_leave_the_range_of_numbers_in_between() {
    let (_, start) = start("0.10501 * r^1.5 - 69/110 * r^(11/6) + 25/26 * r^(13/6)");
    assert!(matches!(start, Some(Start::Seeds(_))));
}

#[test]
fn low_whole_powers_take_steps() {
    for text in
        ["0.02 * r^2 + 1e-3 * r^4", "0.02 * r^1.5 + 1e-3 * r^2", "sphere(10), order = 16, max_radius = 5"]
    {
        assert!(matches!(start(text).1, Some(Start::Seeds(_))), "{text}");
    }
}
