//! Laws of the contact radius: it inverts the load integral, for any load.

use cartcontact::load::Constant;
use cartcontact::{Contact, GapProfile, Medium, Polynomial, RadiusError, Scalar, gap_profile};
use proptest::prelude::*;
use tests::budget;
use tests::condition::degree;
use tests::measure::{relative_error, ulps};
use tests::profiles::{Case, case, cases};
use tests::random::{self, failure, magnitude, positive_sums};

use super::checks::{assert_same_one_by_one, in_single};

/// In units of ε; J is rounded twice, and its degree divides its error.
const ALLOWED: f64 = budget::RADIUS.double + 2.0 * budget::LOAD_INTEGRAL.double / 4.0;

proptest! {
    #![proptest_config(random::cases(300))]

    #[test]
    fn a_planted_radius_is_recovered(profile in positive_sums(), a in magnitude(-4.0..4.0)) {
        let found = profile.radius(profile.load_integral(a)).unwrap_or(f64::NAN);
        prop_assert!(relative_error(found, a, f64::EPSILON) <= ALLOWED, "{found} instead of {a}");
    }

    #[test]
    fn a_planted_radius_is_recovered_by_generated_solvers(index in 0..cases().len(), share in 1e-6..1.0) {
        let case = cases()[index];
        let a = share * case.max_radius.unwrap_or(20.0);
        let condition = case.of_sizes().load_integral(a) / case.double.load_integral(a);
        let found = case.double.radius(case.double.load_integral(a)).unwrap_or(f64::NAN);
        let error = relative_error(found, a, f64::EPSILON);
        prop_assert!(error <= ALLOWED * condition, "{case:?}: {found} instead of {a}");
    }

    #[test]
    fn a_larger_load_makes_a_larger_contact(
        profile in positive_sums(),
        load in magnitude(-9.0..9.0),
        growth in magnitude(-11.0..1.0),
    ) {
        let radius = |load| profile.radius(load).unwrap_or(f64::NAN);
        prop_assert!(radius(load) < radius(load * (1.0 + growth)));
    }

    #[test]
    fn no_load_is_too_small_or_too_large(
        profile in positive_sums(),
        force in magnitude(-300.0..300.0),
        m in magnitude(-3.0..3.0),
    ) {
        let medium = Medium::from_constants(m, 0.0).map_err(failure)?;
        let contact = Contact::new(&profile, medium, Constant(force)).map_err(failure)?;
        let now = contact.at(1.0).map_err(failure)?;
        let a = now.radius();
        let carried = profile.load_integral(a) * m * core::f64::consts::FRAC_PI_4;
        let allowed = budget::LOAD_INTEGRAL.double + ALLOWED * degree(&profile, a);
        prop_assert!(relative_error(carried, force, f64::EPSILON) <= allowed, "{a}: {carried:e}, {force:e}");
        prop_assert!(now.approach() > 0.0 && now.approach().is_finite());
        prop_assert!(now.peak_pressure() > 0.0 && now.peak_pressure().is_finite());
    }
}

/// Whether J of the radius found is `load_integral`, up to the rounding of the radius times the degree of J.
fn is_recovered(profile: &dyn GapProfile<f64>, load_integral: f64) -> bool {
    let a = profile.radius(load_integral).unwrap_or(f64::NAN);
    let allowed = budget::LOAD_INTEGRAL.double + ALLOWED * degree(profile, a);
    relative_error(profile.load_integral(a), load_integral, f64::EPSILON) <= allowed
}

#[test]
fn radii_reach_both_ends_of_the_format() {
    for case in cases().into_iter().filter(|case| case.max_radius.is_none()) {
        for load_integral in [f64::MIN_POSITIVE, 1e-300, 1e-200, 1e200, 1e300, 1e305] {
            assert!(is_recovered(case.double, load_integral), "{case:?}, {load_integral:e}");
            assert!(is_recovered(&case.polynomial(), load_integral), "{case:?}, {load_integral:e}");
        }
    }
}

/// Where a J′, its degree times J, no longer fits into an `f64`, a radius is right or refused.
#[test]
fn radii_are_not_wrong_where_the_slope_overflows() {
    for case in cases().into_iter().filter(|case| case.max_radius.is_none()) {
        for load_integral in [3e307, 1e308, 1.7e308] {
            let profile: &dyn GapProfile<f64> = &case.polynomial();
            for profile in [case.double, profile] {
                let refused = profile.radius(load_integral).is_err();
                assert!(refused || is_recovered(profile, load_integral), "{case:?}, {load_integral:e}");
            }
        }
    }
}

#[gap_profile(1e15 * r + 1e-15 * r^64)]
struct Steep;

/// The search ends with an interval of ε; the error of J, ε times half its degree, may move it by another ε/2. An ε is up
/// to 2 ulp.
#[test]
fn radii_are_halved_to_where_the_slope_overflows() {
    for load_integral in [5.281_584_5e36, 2.355_637_6e37, 6.120_69e37, 9.029_46e37_f32] {
        let (single, double) = (Steep.radius(load_integral), Steep.radius(f64::from(load_integral)));
        let (single, double) = (single.map_or(f64::NAN, f64::from), double.unwrap_or(f64::NAN));
        let error = ulps(single, double.into(), f64::from(f32::EPSILON));
        assert!(error <= 3.0, "{load_integral:e}: {error} ulp");
    }
}

#[gap_profile(b * r^2 + c * r^4)]
struct Fields {
    b: f64,
    c: f64,
}

/// In a step from the table that all geometries of two fields share, squares of these numbers would leave the format.
#[test]
fn coefficients_of_any_size_have_all_digits() {
    for exponent in -290..290 {
        let unit = 10f64.powi(exponent);
        let polynomial =
            Polynomial::new([(unit, 2.0), (unit, 4.0)]).unwrap_or_else(|error| unreachable!("{error}"));
        for load_integral in [0.01, 1.0, 70.0].map(|share| share * unit) {
            let found = Fields { b: unit, c: unit }.radius_within(load_integral, f64::INFINITY);
            let expected = polynomial.radius(load_integral).unwrap_or(f64::NAN);
            let error = relative_error(found.unwrap_or(f64::NAN), expected, f64::EPSILON);
            assert!(error <= 2.0 * budget::RADIUS.double, "{unit:e}, {load_integral:e}: {error} ε");
        }
    }
}

/// The same for planted radii and two coefficients of different sizes.
#[test]
fn two_coefficients_of_any_sizes_have_all_digits() {
    fn check<T: Scalar>(decades: i32, most: f64)
    where
        Fields: GapProfile<T>,
    {
        let fits = |size: f64| (most.recip()..most).contains(&size);
        for (b, c) in (-30..=30).flat_map(|i| (-30..=30).map(move |k| (i, k))) {
            let [b, c] = [b, c].map(|place| 10f64.powi(decades * place));
            for share in [0.01_f64, 0.3, 1.0, 20.0] {
                let a = (b / c).sqrt() * share;
                // All products lie between b and the last.
                let load_integral = (0..6).fold(b / 12.0, |product, _| product * a) * (1.0 + share * share);
                if fits(a) && fits(load_integral) {
                    let found = Fields { b, c }.radius_within(T::constant(load_integral), T::infinity());
                    let found = found.map_or(f64::NAN, |radius| radius.value());
                    let error = relative_error(found, a, T::default_epsilon().value());
                    assert!(error <= 2.0, "{b:e}, {c:e}, {load_integral:e}: {found:e}, {error} ε");
                }
            }
        }
    }
    check::<f64>(10, 1e300);
    check::<f32>(1, 1e36);
}

#[test]
fn no_load_makes_no_contact() {
    for case in cases() {
        assert_eq!(case.double.radius(0.0), Ok(0.0), "{case:?}");
        assert_eq!(case.single.radius(0.0), Ok(0.0), "{case:?}");
        assert_eq!(case.polynomial().radius(0.0), Ok(0.0), "{case:?}");
    }
}

#[test]
fn the_end_of_the_range_is_reached_and_not_passed() {
    for case in cases() {
        let Some(end) = case.max_radius else { continue };
        let largest = case.double.load_integral(end);
        assert!(case.double.radius(largest * (1.0 - 1e-12)).is_ok_and(|a| a <= end), "{case:?}");
        assert!(case.double.radius(largest * (1.0 + 1e-12)).is_err(), "{case:?}");
    }
}

/// The load integral at the end of a range has a radius within the range, to the last bit.
#[test]
fn the_load_integral_of_the_end_is_inside() {
    fn is_inside<T: Scalar>(profile: &dyn GapProfile<T>, end: T) -> bool {
        let found = profile.radius_within(profile.load_integral(end), end);
        profile.check().is_err() || found.is_ok_and(|radius| radius <= end)
    }
    for case in cases() {
        for k in 1..1000 {
            let end = case.max_radius.unwrap_or(20.0) * f64::from(k) / 1000.0;
            assert!(is_inside(case.double, end), "{case:?}, {end}");
            assert!(is_inside(&case.polynomial(), end), "{case:?}, {end}");
            assert!(is_inside(case.single, end as f32), "{case:?}, {end}");
        }
    }
}

/// Large blocks, small blocks and incomplete ones, in the table or with some load integrals outside it.
#[test]
fn many_radii_are_those_of_single_ones() {
    for case in cases() {
        let largest = case.double.load_integral(case.max_radius.unwrap_or(100.0));
        for ratio in [0.99_f64, 0.9] {
            let falling = (0..1000).map(|k| largest * ratio.powi(k * 37 % 1000));
            let load_integrals: Vec<f64> = falling.chain([0.0, largest]).collect();
            let single = in_single(&case.single, &load_integrals);
            for length in [1, 15, 16, 17, 63, 64, 65, 127, 128, 129, 1002] {
                let place = (case, ratio, length);
                assert_same_one_by_one(&case.double, &load_integrals[..length], &place);
                assert_same_one_by_one(&case.single, &single[..length.min(single.len())], &place);
            }
        }
    }
}

#[test]
fn the_first_fault_among_many_is_named() {
    let case = case("Oblate");
    let beyond = 2.0 * case.double.load_integral(8.0);
    let faults = [1.0, beyond, -1.0];
    let found = case.double.radii(&faults, &mut [0.0; 3]);
    assert!(matches!(found, Err(RadiusError::BeyondRange { load_integral, .. }) if load_integral == beyond));
    let length = case.double.radii(&faults, &mut [0.0; 2]);
    assert_eq!(length, Err(RadiusError::Length { load_integrals: 3, radii: 2 }));
}

#[gap_profile(0.02 * r^1.8 - 1e-5 * r^4.6, max_radius = 6)]
struct BoundedPolynomials;

#[gap_profile(0.05 * r^2 - 1e-4 * r^4, max_radius = 6)]
struct BoundedSteps;

#[gap_profile(c * r^2 + d * r^3 + e * r^5, max_radius = 6)]
struct BoundedFields {
    c: f64,
    d: f64,
    e: f64,
}

/// Whether the rows of the table hold polynomials or seeds, or there is no table.
#[test]
fn slices_end_with_the_range() {
    let fields = BoundedFields { c: 0.05, d: 1e-3, e: 1e-5 };
    for profile in [&BoundedPolynomials as &dyn GapProfile<f64>, &BoundedSteps, &fields] {
        let end = profile.load_integral(6.0);
        let mut load_integrals: Vec<f64> = (0..500).map(|k| end * 0.97_f64.powi(k)).collect();
        assert_same_one_by_one(&profile, &load_integrals, &end);
        load_integrals[300] = 1.001 * end;
        let refused = profile.radii(&load_integrals, &mut vec![f64::NAN; load_integrals.len()]);
        assert!(refused.is_err());
        assert_eq!(refused, profile.radius(1.001 * end).map(drop));
    }
}

/// A load integral at which a row of a table may begin.
fn border(quarter: i32) -> f64 {
    2f64.powi(quarter.div_euclid(4)) * (1.0 + f64::from(quarter.rem_euclid(4)) / 4.0)
}

/// The first row of a table begins with a border between rows, and the last one ends with another.
#[test]
fn slices_have_the_radii_of_single_ones_at_the_ends_of_tables() {
    fn check<T: Scalar>(profile: &dyn GapProfile<T>, border: T, case: Case) {
        let mut radii = [T::constant(f64::NAN); 16];
        if let Ok(radius) = profile.radius(border) {
            assert_eq!(profile.radii(&[border; 16], &mut radii), Ok(()), "{case:?}, {border}");
            assert_eq!(radii, [radius; 16], "{case:?}, {border}");
        }
    }
    for case in cases() {
        for quarter in -1200..1200_i32 {
            check(case.double, border(quarter), case);
            check(case.single, border(quarter) as f32, case);
        }
    }
}

/// On both sides of every border between rows of the tables, and at their ends, neighbours have neighbouring radii.
#[test]
fn radii_are_continuous_from_row_to_row() {
    for case in cases() {
        let mut count = 0;
        for quarter in -400..400_i32 {
            let above = border(quarter);
            let radius = |load_integral: f64| case.double.radius(load_integral);
            let (Ok(above), Ok(below)) = (radius(above), radius(above.next_down())) else { continue };
            let error = relative_error(above, below, f64::EPSILON);
            assert!(error <= 2.0 * budget::RADIUS.double, "{case:?}: {below:e}, {above:e}");
            count += 1;
        }
        // If the range ends, half of the octaves are beyond it.
        assert!(count >= if case.max_radius.is_some() { 400 } else { 800 }, "{case:?}: {count}");
    }
}
