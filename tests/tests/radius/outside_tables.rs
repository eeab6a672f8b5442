//! Contact radii of geometries that have no table, and radii outside its rows.

use cartcontact::gap_profile;

use super::checks::{Kind, assert_exact, assert_random_slices_are_right};

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
    assert_exact(&KINDS, |_, _| 1.0);
}

#[test]
fn slices_have_the_same_radii() {
    assert_random_slices_are_right(&KINDS);
}
