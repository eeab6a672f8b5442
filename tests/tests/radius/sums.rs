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

#[test]
fn radii_of_sums_are_next_to_the_exact_ones() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for (kind, exponent) in (0..).zip(KINDS) {
        for case in 0..100 {
            let mut stream = Stream::of_case(kind, case);
            let terms = terms(&mut stream, exponent);
            let load_integral = stream.magnitude(-6.0, 6.0);
            let found = radius(&terms, load_integral);
            errors.add(found, exact_radius(&terms, load_integral), 1.0, &(&terms, load_integral));

            let single: Vec<(f32, f32)> = terms.iter().map(|&(c, n)| (c as f32, n as f32)).collect();
            let load_integral = load_integral as f32;
            let found = radius(&single, load_integral);
            let terms: Vec<(f64, f64)> = single.iter().map(|&(c, n)| (c.into(), n.into())).collect();
            let expected = exact_radius(&terms, load_integral.into());
            errors_of_single.add(found.into(), expected, 1.0, &(&terms, load_integral));
        }
    }
    errors.check();
    errors_of_single.check();
}

/// Powers above those for which a fixed number of steps is enough, up to the highest one, beside a low one.
#[test]
fn radii_of_the_highest_powers_are_next_to_the_exact_ones() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for highest in [100.0, 300.0, 700.0, 1024.0] {
        for low in [0.25, 2.0, 30.0] {
            // Both terms are as large as each other at 1.
            let terms = [low, highest].map(|n| ((n + 2.0) * (n + 4.0) / n, n));
            let single = terms.map(|(c, n)| (c as f32, n as f32));
            for k in 0..100 {
                let load_integral = 10f64.powf(f64::from(k) / 50.0 - 1.5);
                let found = radius(&terms, load_integral);
                errors.add(found, exact_radius(&terms, load_integral), 1.0, &(terms, load_integral));
                let load_integral = load_integral as f32;
                let expected = exact_radius(&single.map(|(c, n)| (c.into(), n.into())), load_integral.into());
                errors_of_single.add(
                    radius(&single, load_integral).into(),
                    expected,
                    1.0,
                    &(single, load_integral),
                );
            }
        }
    }
    errors.check();
    errors_of_single.check();
}
