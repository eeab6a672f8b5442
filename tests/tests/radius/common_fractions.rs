//! Contact radii of gaps whose powers are multiples of a common fraction, and so whole powers of a root of the radius.

use cartcontact::{GapProfile, gap_profile};
use tests::budget;
use tests::condition::{of_radius, of_sizes};
use tests::fractions::{Hundredths, Quarters, Tenths, Thirds, Twentieths};
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::random::Stream;

use super::checks::{Kind, assert_exact, assert_random_slices_are_right};

#[gap_profile(0.02 * r^1.8 - 1e-5 * r^4.6, max_radius = 6)]
struct Fifths;

#[gap_profile(0.02 * r^(13/7) + 1e-3 * r^3)]
struct Sevenths;

#[gap_profile(c * r^1.6 + d * r^2.2)]
struct FifthsOfFields<T> {
    c: T,
    d: T,
}

macro_rules! kinds {
    ($($profile:ident: $terms:expr,)*) => {
        [$(Kind { double: &$profile, single: &$profile, terms: &$terms, decades: [-1.5, 0.75] }),*]
    };
}

const KINDS: [Kind; 7] = kinds! {
    Thirds: [("0.02", "2/3"), ("1e-3", "2")],
    Quarters: [("0.02", "0.25"), ("1e-3", "8.75")],
    Fifths: [("0.02", "1.8"), ("-1e-5", "4.6")],
    Sevenths: [("0.02", "13/7"), ("1e-3", "3")],
    Tenths: [("0.02", "1.1"), ("1e-3", "2.2"), ("2e-4", "3.3")],
    Twentieths: [("0.02", "0.35"), ("1e-3", "4.05")],
    Hundredths: [("0.02", "2.37"), ("1e-3", "3.5")],
};

#[test]
fn radii_are_exact() {
    assert_exact(&KINDS, |kind, a| {
        if kind.terms.iter().any(|(coefficient, _)| coefficient.starts_with('-')) {
            budget::RADIUS_OF_DIFFERENCES * of_radius(&Fifths, &of_sizes(&Fifths::TERMS), a)
        } else {
            1.0
        }
    });
}

#[test]
fn slices_have_the_same_radii() {
    assert_random_slices_are_right(&KINDS);
}

#[test]
fn radii_are_exact_for_fields_of_any_size() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut stream = Stream::of_case(3, 0);
    for _ in 0..300 {
        let (c, d) = (stream.magnitude(-4.0, 4.0), stream.magnitude(-4.0, 4.0));
        let profile = FifthsOfFields { c, d };
        let load_integral = profile.load_integral(stream.magnitude(-6.0, 6.0));
        // 80 decimals hold all digits of both.
        let coefficients = [c, d].map(|coefficient| format!("{coefficient:.80}"));
        let oracle = Profile::of_decimals(&[(&coefficients[0], "1.6"), (&coefficients[1], "2.2")]);
        let expected = Exact::from(&oracle.radius(&double(load_integral)));
        errors.add(profile.radius(load_integral).unwrap_or(f64::NAN), expected, 1.0, &(c, d, load_integral));
    }
    errors.check();
}
