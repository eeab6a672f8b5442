//! Contact radii of geometries that have no table, and radii outside its rows.

use cartcontact::{GapProfile, gap_profile};
use tests::budget;
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::radii::assert_same_one_by_one;
use tests::random::Stream;

/// The table has rows only below r = 1.2.
#[gap_profile(0.02 * r^2 + 1e-6 * r^64)]
struct Steep;

/// The table has no rows.
#[gap_profile(0.02 * r^2 + 1e-30 * r^400)]
struct Steepest;

/// The table has rows up to r = 4.8.
#[gap_profile(0.02 * r^2 + 1e-4 * r^4 + 1e-16 * r^23)]
struct ThreeTerms;

#[gap_profile(0.02 * r^1.3 + 1e-3 * r^2.71 + 1e-4 * r^3.9)]
struct Fractional;

/// The table of two terms with fields has rows where neither is much less than the other.
#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3))]
struct Ball<T> {
    radius: T,
}

#[gap_profile(c * r^2 + d * r^3)]
struct TwoFields<T> {
    c: T,
    d: T,
}

#[gap_profile(c * r^2.5 + d * r^4)]
struct Halves<T> {
    c: T,
    d: T,
}

/// A geometry in both formats, with its terms as written.
struct Kind {
    double: &'static dyn GapProfile<f64>,
    single: &'static dyn GapProfile<f32>,
    terms: &'static [(&'static str, &'static str)],
    /// The decades in which radii are drawn.
    decades: [f64; 2],
}

const KINDS: [Kind; 7] = [
    Kind { double: &Steep, single: &Steep, terms: &[("0.02", "2"), ("1e-6", "64")], decades: [-3.0, 0.5] },
    Kind {
        double: &Steepest,
        single: &Steepest,
        terms: &[("0.02", "2"), ("1e-30", "400")],
        decades: [-2.0, 0.1],
    },
    Kind {
        double: &ThreeTerms,
        single: &ThreeTerms,
        terms: &[("0.02", "2"), ("1e-4", "4"), ("1e-16", "23")],
        decades: [-4.0, 1.4],
    },
    Kind {
        double: &Fractional,
        single: &Fractional,
        terms: &[("0.02", "1.3"), ("1e-3", "2.71"), ("1e-4", "3.9")],
        decades: [-4.0, 4.0],
    },
    // Coefficients that no format rounds.
    Kind {
        double: &Ball { radius: 4096.0 },
        single: &Ball { radius: 4096.0 },
        terms: &[("1.220703125e-4", "2"), ("1.818989403545856475830078125e-12", "4")],
        decades: [-3.0, 2.0],
    },
    Kind {
        double: &TwoFields { c: 0.015625, d: 0.0 },
        single: &TwoFields { c: 0.015625, d: 0.0 },
        terms: &[("0.015625", "2")],
        decades: [-3.0, 3.0],
    },
    Kind {
        double: &Halves { c: 0.015625, d: 9.5367431640625e-7 },
        single: &Halves { c: 0.015625, d: 9.536_743e-7 },
        terms: &[("0.015625", "2.5"), ("9.5367431640625e-7", "4")],
        decades: [-3.0, 1.0],
    },
];

#[test]
fn radii_are_exact() {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for (index, kind) in (0..).zip(&KINDS) {
        let (oracle, mut stream) = (Profile::of_decimals(kind.terms), Stream::of_case(1, index));
        let [from, to] = kind.decades;
        for _ in 0..200 {
            let load_integral = kind.double.load_integral(stream.magnitude(from, to));
            let place = (kind.terms, load_integral);
            let expected = Exact::from(&oracle.radius(&double(load_integral)));
            errors.add(kind.double.radius(load_integral).unwrap_or(f64::NAN), expected, 1.0, &place);

            let single = load_integral as f32;
            if single.is_normal() {
                let expected = Exact::from(&oracle.radius(&double(single.into())));
                let found = kind.single.radius(single).unwrap_or(f32::NAN);
                errors_of_single.add(found.into(), expected, 1.0, &place);
            }
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(2, index);
        let [from, to] = kind.decades;
        let load_integrals: Vec<f64> =
            (0..500).map(|_| kind.double.load_integral(stream.magnitude(from, to))).collect();
        assert_same_one_by_one(kind.double, &load_integrals, &kind.terms);
    }
}
