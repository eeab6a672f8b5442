//! Contact radii of gaps whose powers are multiples of a common fraction: of a root of the radius they are whole.

use cartcontact::{GapProfile, gap_profile};
use tests::budget;
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::radii::assert_same_one_by_one;
use tests::random::Stream;

#[gap_profile(0.02 * r^(2/3) + 1e-3 * r^2)]
struct Thirds;

#[gap_profile(0.02 * r^0.25 + 1e-3 * r^8.75)]
struct Quarters;

#[gap_profile(0.02 * r^1.8 - 1e-5 * r^4.6, max_radius = 6)]
struct Fifths;

#[gap_profile(0.02 * r^(13/7) + 1e-3 * r^3)]
struct Sevenths;

#[gap_profile(0.02 * r^1.1 + 1e-3 * r^2.2 + 2e-4 * r^3.3)]
struct Tenths;

#[gap_profile(0.02 * r^0.35 + 1e-3 * r^4.05)]
struct Twentieths;

/// In steps too fine for a root.
#[gap_profile(0.02 * r^2.37 + 1e-3 * r^3.5)]
struct Hundredths;

#[gap_profile(c * r^1.6 + d * r^2.2)]
struct FifthsOfFields<T> {
    c: T,
    d: T,
}

/// A geometry in both formats, with its terms.
struct Kind {
    double: &'static dyn GapProfile<f64>,
    single: &'static dyn GapProfile<f32>,
    terms: &'static [(&'static str, &'static str)],
    /// How much worse J is conditioned than the sum of its sizes.
    condition: fn(f64) -> f64,
}

macro_rules! kind {
    ($profile:ident, $terms:expr) => {
        kind!($profile, $terms, |_| 1.0)
    };
    ($profile:ident, $terms:expr, $condition:expr) => {
        Kind { double: &$profile, single: &$profile, terms: &$terms, condition: $condition }
    };
}

const KINDS: [Kind; 7] = [
    kind!(Thirds, [("0.02", "2/3"), ("1e-3", "2")]),
    kind!(Quarters, [("0.02", "0.25"), ("1e-3", "8.75")]),
    kind!(Fifths, [("0.02", "1.8"), ("-1e-5", "4.6")], |a| {
        // J's terms are those of the gap times n/((n+2)(n+4)) a⁴, its slope those times n/(n+2) a³.
        let [low, high] = [0.02 * a.powf(1.8) * 1.8 / 3.8, 1e-5 * a.powf(4.6) * 4.6 / 6.6];
        5.8 * (low / 5.8 + high / 8.6) / (low - high)
    }),
    kind!(Sevenths, [("0.02", "13/7"), ("1e-3", "3")]),
    kind!(Tenths, [("0.02", "1.1"), ("1e-3", "2.2"), ("2e-4", "3.3")]),
    kind!(Twentieths, [("0.02", "0.35"), ("1e-3", "4.05")]),
    kind!(Hundredths, [("0.02", "2.37"), ("1e-3", "3.5")]),
];

#[test]
fn radii_are_exact() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for (index, kind) in KINDS.iter().enumerate() {
        let (oracle, mut stream) = (Profile::of_decimals(kind.terms), Stream::of_case(1, index as u64));
        for _ in 0..200 {
            let size = stream.magnitude(-1.5, 0.75);
            let load_integral = kind.double.load_integral(size);
            let place = (kind.terms, load_integral);
            let expected = Exact::from(&oracle.radius(&double(load_integral)));
            let found = kind.double.radius(load_integral).unwrap_or(f64::NAN);
            errors.add(found, expected, (kind.condition)(found).max(1.0), &place);

            let single = load_integral as f32;
            let expected = Exact::from(&oracle.radius(&double(single.into())));
            let found = f64::from(kind.single.radius(single).unwrap_or(f32::NAN));
            errors_of_single.add(found, expected, (kind.condition)(found).max(1.0), &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in KINDS.iter().enumerate() {
        let mut stream = Stream::of_case(2, index as u64);
        let load_integrals: Vec<f64> =
            (0..500).map(|_| kind.double.load_integral(stream.magnitude(-1.5, 0.75))).collect();
        assert_same_one_by_one(kind.double, &load_integrals, &kind.terms);
    }
}

#[test]
fn radii_are_exact_for_fields_of_any_size() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut stream = Stream::of_case(3, 0);
    for _ in 0..300 {
        let (c, d) = (stream.magnitude(-4.0, 4.0), stream.magnitude(-4.0, 4.0));
        let profile = FifthsOfFields { c, d };
        let load_integral = profile.load_integral(stream.magnitude(-6.0, 6.0));
        // All digits of both.
        let coefficients = [c, d].map(|coefficient| format!("{coefficient:.80}"));
        let oracle = Profile::of_decimals(&[(&coefficients[0], "1.6"), (&coefficients[1], "2.2")]);
        let expected = Exact::from(&oracle.radius(&double(load_integral)));
        errors.add(profile.radius(load_integral).unwrap_or(f64::NAN), expected, 1.0, &(c, d, load_integral));
    }
    errors.check();
}
