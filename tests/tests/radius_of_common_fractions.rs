//! Contact radii of gaps whose powers are multiples of a common fraction, and so whole powers of a root of the radius.

use cartcontact::{GapProfile, gap_profile};
use tests::budget;
use tests::condition::{of_radius, of_sizes};
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

/// The common fraction is too small for a root.
#[gap_profile(0.02 * r^2.37 + 1e-3 * r^3.5)]
struct Hundredths;

#[gap_profile(c * r^1.6 + d * r^2.2)]
struct FifthsOfFields<T> {
    c: T,
    d: T,
}

/// A geometry in both formats, with its terms as written and as numbers.
struct Kind {
    double: &'static dyn GapProfile<f64>,
    single: &'static dyn GapProfile<f32>,
    terms: &'static [(&'static str, &'static str)],
    numbers: &'static [(f64, f64)],
}

macro_rules! kinds {
    ($($profile:ident: $terms:expr,)*) => {
        [$(Kind {
            double: &$profile,
            single: &$profile,
            terms: &$terms,
            numbers: &$profile::TERMS,
        }),*]
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

impl Kind {
    /// The factor on the error of a radius.
    fn condition(&self, a: f64) -> f64 {
        let terms = self.numbers;
        let is_sum = terms.iter().all(|&(c, _)| c > 0.0);
        let of_differences = if is_sum { 1.0 } else { budget::RADIUS_OF_DIFFERENCES };
        of_differences * of_radius(self.double, &of_sizes(terms), a)
    }
}

#[test]
fn radii_are_exact() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for (index, kind) in (0..).zip(&KINDS) {
        let (oracle, mut stream) = (Profile::of_decimals(kind.terms), Stream::of_case(1, index));
        for _ in 0..200 {
            let size = stream.magnitude(-1.5, 0.75);
            let load_integral = kind.double.load_integral(size);
            let condition = kind.condition(size);
            let place = (kind.terms, load_integral);
            let expected = Exact::from(&oracle.radius(&double(load_integral)));
            errors.add(kind.double.radius(load_integral).unwrap_or(f64::NAN), expected, condition, &place);

            let single = load_integral as f32;
            let expected = Exact::from(&oracle.radius(&double(single.into())));
            let found = kind.single.radius(single).unwrap_or(f32::NAN);
            errors_of_single.add(found.into(), expected, condition, &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(2, index);
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
        // 80 decimals hold all digits of both.
        let coefficients = [c, d].map(|coefficient| format!("{coefficient:.80}"));
        let oracle = Profile::of_decimals(&[(&coefficients[0], "1.6"), (&coefficients[1], "2.2")]);
        let expected = Exact::from(&oracle.radius(&double(load_integral)));
        errors.add(profile.radius(load_integral).unwrap_or(f64::NAN), expected, 1.0, &(c, d, load_integral));
    }
    errors.check();
}
