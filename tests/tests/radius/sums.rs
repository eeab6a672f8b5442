//! Contact radii of random sums of positive powers, known at run time only.

use cartcontact::{GapProfile, Polynomial, Scalar};
use tests::budget;
use tests::measure::Errors;
use tests::random::Stream;

use super::checks::exact_radius;

/// Exponents with all the digits of the format, so that powers round once more.
const DECIMALS: [f64; 8] = [0.1, 0.3, 0.7, 1.3, 2.1, 3.7, 6.1, 9.3];

/// The kinds of exponents: quarters, whole numbers and decimals.
const KINDS: [fn(&mut Stream) -> f64; 3] = [
    |stream| (1 + stream.below(40)) as f64 / 4.0,
    |stream| (1 + stream.below(64)) as f64,
    |stream| stream.one_of(&DECIMALS),
];

/// Up to four terms (C, n), any of which may be the largest part of J.
fn terms(stream: &mut Stream, exponent: fn(&mut Stream) -> f64) -> Vec<(f64, f64)> {
    let count = 1 + stream.below(4);
    (0..count).map(|_| (stream.magnitude(-3.0, 3.0), exponent(stream))).collect()
}

fn radius<T: Scalar>(terms: &[(T, T)], load_integral: T) -> T {
    let radius = Polynomial::new(terms).map(|sum| sum.radius(load_integral));
    radius.ok().and_then(Result::ok).unwrap_or_else(|| unreachable!("{terms:?}, {load_integral}"))
}

/// Adds the errors of a radius of the terms in `f64`, and of the terms rounded to `f32`.
fn add_errors([double, single]: &mut [Errors; 2], terms: &[(f64, f64)], load_integral: f64) {
    let found = radius(terms, load_integral);
    double.add(found, exact_radius(terms, load_integral), 1.0, &(terms, load_integral));

    let rounded: Vec<(f32, f32)> = terms.iter().map(|&(c, n)| (c as f32, n as f32)).collect();
    let load_integral = load_integral as f32;
    let found = radius(&rounded, load_integral);
    let terms: Vec<(f64, f64)> = rounded.iter().map(|&(c, n)| (c.into(), n.into())).collect();
    single.add(found.into(), exact_radius(&terms, load_integral.into()), 1.0, &(&terms, load_integral));
}

/// None in both formats yet.
fn no_errors() -> [Errors; 2] {
    [Errors::of(budget::RADIUS_OF_SUMS), Errors::of_single(budget::RADIUS_OF_SUMS)]
}

#[test]
fn radii_of_sums_are_next_to_the_exact_ones() {
    let mut errors = no_errors();
    for (kind, exponent) in (0..).zip(KINDS) {
        for case in 0..100 {
            let mut stream = Stream::of_case(kind, case);
            let terms = terms(&mut stream, exponent);
            add_errors(&mut errors, &terms, stream.magnitude(-6.0, 6.0));
        }
    }
    errors.iter().for_each(Errors::check);
}

/// Powers above those for which a fixed number of steps is enough, up to the highest one, beside a low one.
#[test]
fn radii_of_the_highest_powers_are_next_to_the_exact_ones() {
    let mut errors = no_errors();
    for highest in [100.0, 300.0, 700.0, 1024.0] {
        for low in [0.25, 2.0, 30.0] {
            // Both terms are as large as each other at 1.
            let terms = [low, highest].map(|n| ((n + 2.0) * (n + 4.0) / n, n));
            for k in 0..100 {
                add_errors(&mut errors, &terms, 10f64.powf(f64::from(k) / 50.0 - 1.5));
            }
        }
    }
    errors.iter().for_each(Errors::check);
}
