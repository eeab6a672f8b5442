//! Contact radii of gaps whose first term is positive and whose second is negative for positive fields, like those of
//! oblate surfaces: one table holds them up to the end of their admissible range.

use cartcontact::{GapProfile, Polynomial, ProfileError, RadiusError, gap_profile};
use tests::budget;
use tests::condition::{of_radius, of_sizes};
use tests::measure::{Errors, relative_error};
use tests::random::Stream;

use super::checks::{assert_same_in_other_units, assert_slices_are_right, exact_radius};
use super::two_fields::{OfTwoFields, of_two_fields};

#[gap_profile(c * r^2 - d * r^4)]
struct Oblate<T> {
    c: T,
    d: T,
}

#[gap_profile(c * r^2 - d * r^12)]
struct Rimmed<T> {
    c: T,
    d: T,
}

#[gap_profile(c * r^1.5 - d * r^2.5)]
struct Halves<T> {
    c: T,
    d: T,
}

#[gap_profile(c * (0.02 * r^2 - r^3 / (100 * d)), positive)]
struct Scaled<T> {
    c: T,
    d: T,
}

/// Three terms in one unit; the last one turns J upwards again.
#[gap_profile(c * (r^2 / d - 0.4 * r^4 / d^3 + 0.02 * r^6 / d^5), positive)]
struct Turning<T> {
    c: T,
    d: T,
}

const KINDS: [OfTwoFields; 5] = [
    of_two_fields!(|c, d| Oblate { c, d }),
    of_two_fields!(|c, d| Rimmed { c, d }),
    of_two_fields!(|c, d| Halves { c, d }),
    of_two_fields!(|c, d| Scaled { c, d }),
    of_two_fields!(|c, d| Turning { c, d }),
];

/// Where J hardly rises, the last step takes away what the search in quick sums is off by: up to twice the condition.
///
/// The radii of f64 are exact enough here; so near the end, the steps of the oracle are too long.
#[test]
fn radii_of_single_precision_are_exact_next_to_the_end() -> Result<(), ProfileError> {
    let gaps = [
        [(0.118_805_97, 1.5), (-0.101_728_2, 9.0)],
        [(0.01, 3.5), (-0.01, 5.5)],
        [(0.05, 2.0), (-0.004, 3.0)],
    ];
    for terms in gaps {
        let terms: [(f32, f32); 2] = terms;
        let profile = Polynomial::new(terms)?;
        let terms = terms.map(|(c, n)| (f64::from(c), f64::from(n)));
        let (same, sizes) = (Polynomial::new(terms)?, of_sizes(&terms));
        for k in 0..500_u16 {
            let share = 1.0 - 10f32.powf(-1.0 - f32::from(k) / 200.0);
            let load_integral = profile.load_integral(share * profile.max_radius());
            let found = profile.radius(load_integral).map_or(f64::NAN, f64::from);
            let exact = same.radius(load_integral.into()).unwrap_or(f64::NAN);
            let error = (found / exact - 1.0).abs() / f64::from(f32::EPSILON);
            let condition = of_radius(&same, &sizes, exact);
            assert!(error <= 0.5 * condition, "{terms:?}, {share}: {error:.2} ε, condition {condition:.1}");
        }
    }
    Ok(())
}

#[test]
fn radii_are_exact_up_to_their_condition() {
    let condition = |terms: &[(f64, f64)], radius| {
        let profile = Polynomial::new(terms).unwrap_or_else(|error| unreachable!("{error}"));
        budget::RADIUS_OF_DIFFERENCES * of_radius(&profile, &of_sizes(terms), radius)
    };
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(1, index);
        for _ in 0..300 {
            let share = stream.one_of(&[1e-4, 1e-2, 0.3, 0.6, 0.9, 0.99]) * stream.between(0.5, 1.0);
            let (c, d) = (stream.magnitude(-3.0, 3.0), stream.magnitude(-3.0, 3.0));
            let (terms, profile) = (kind.double)(c, d);
            let load_integral = profile.load_integral(share * profile.max_radius().min(10.0));
            let found = profile.radius(load_integral).unwrap_or(f64::NAN);
            let place = (index, c, d, share);
            errors.add(found, exact_radius(&terms, load_integral), condition(&terms, found), &place);

            // With a smaller share J would lack digits.
            let share = share.max(0.05) as f32;
            let (terms, profile) = (kind.single)(c.sqrt() as f32, d.sqrt() as f32);
            let load_integral = profile.load_integral(share * profile.max_radius().min(10.0));
            let found = f64::from(profile.radius(load_integral).unwrap_or(f32::NAN));
            let exact = exact_radius(&terms, load_integral.into());
            errors_of_single.add(found, exact, condition(&terms, found), &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

/// The table is consulted before the range, and must agree with it.
#[test]
fn no_radius_lies_beyond_the_range() {
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(2, index);
        for _ in 0..100 {
            let (_, profile) = (kind.double)(stream.magnitude(-3.0, 3.0), stream.magnitude(-3.0, 3.0));
            let limit = profile.max_radius();
            assert!(limit.is_finite(), "{index}");
            let largest = profile.load_integral(limit);
            for share in [0.5, 0.99, 0.999_999, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.000_001, 1.1, 2.0, 1e3] {
                let load_integral = share * largest;
                let found = profile.radius(load_integral);
                assert_eq!(found, profile.radius_within(load_integral, limit), "{index}: {share}");
                let is_inside = found.is_ok_and(|radius| radius <= limit);
                assert_eq!(is_inside, share <= 1.0, "{index}: {share}, {found:?}");
            }
        }
    }
}

#[test]
fn fields_of_other_signs_have_their_own_radii() {
    for (c, d) in [(0.02, -1e-4), (0.02, 0.0), (3.0, -1e3)] {
        let polynomial =
            Polynomial::new([(c, 2.0), (-d, 4.0)]).unwrap_or_else(|error| unreachable!("{error}"));
        for load_integral in [1e-6, 1.0, 1e5] {
            let found = Oblate { c, d }.radius(load_integral).unwrap_or(f64::NAN);
            let expected = polynomial.radius(load_integral).unwrap_or(f64::NAN);
            let error = relative_error(found, expected, f64::EPSILON);
            assert!(error <= 2.0 * budget::RADIUS.double, "{c}, {d}: {found}, {expected}");
        }
    }
    for (c, d) in [(-0.02, 1e-4), (-0.02, -1e-4), (f64::NAN, 1e-4), (0.02, f64::NAN)] {
        let profile = Oblate { c, d };
        assert!(profile.check().is_err(), "{c}, {d}");
        assert!(matches!(profile.radius(1.0), Err(RadiusError::BeyondRange { .. })), "{c}, {d}");
    }
}

#[test]
fn other_units_change_no_digit() {
    let mut stream = Stream::of_case(3, 0);
    for _ in 0..1000 {
        let (c, d) = (stream.magnitude(-3.0, 3.0), stream.magnitude(-3.0, 3.0));
        let load_integral = stream.between(1e-9, 1.0) * Oblate { c, d }.load_integral((0.7 * c / d).sqrt());
        // Coefficients stay between 1e-60 and 1e60, where the table applies.
        let [length, size] = [15, 100].map(|most| stream.power_of_two(most));
        let scaled = Oblate { c: c * size / length.powi(2), d: d * size / length.powi(4) };
        assert_same_in_other_units([&Oblate { c, d }, &scaled], load_integral, [length, size], &(c, d));
    }
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(&KINDS) {
        let (_, profile) = (kind.double)(0.3, 20.0);
        let largest = profile.load_integral(profile.max_radius().min(50.0));
        let mut stream = Stream::of_case(4, index);
        let load_integrals: Vec<f64> = (0..300).map(|_| largest * stream.magnitude(-9.0, 0.0)).collect();
        let (_, single) = (kind.single)(0.3, 20.0);
        assert_slices_are_right((&*profile, &*single), &load_integrals, &index);
    }
}
