//! Geometries known at run time, and fields of generated geometries.

use cartcontact::load::Constant;
use cartcontact::{
    Contact, ContactError, GapProfile, Medium, Polynomial, ProfileError, RadiusError, gap_profile,
};
use tests::profiles::cases;

use super::{NOT_A_SIZE, contact, paraboloid, refused};

#[test]
fn coefficients_are_finite_and_exponents_positive() {
    refused(
        Polynomial::<f64, _>::new([]),
        |e| matches!(e, ProfileError::Empty),
        "no term with a coefficient",
    );
    refused(
        Polynomial::new([(0.0, 2.0)]),
        |e| matches!(e, ProfileError::Empty),
        "no term with a coefficient",
    );
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let result = Polynomial::new([(0.025, 2.0), (value, 4.0)]);
        refused(result, |e| matches!(e, ProfileError::InvalidCoefficient { .. }), value);
    }
    for value in NOT_A_SIZE.into_iter().chain([1024.5]) {
        let result = Polynomial::new([(0.025, 2.0), (1e-4, value)]);
        refused(result, |e| matches!(e, ProfileError::InvalidExponent { .. }), value);
    }
    let is_exponent = |e: &ProfileError| matches!(e, ProfileError::InvalidExponent { exponent: 1e-320 });
    refused(Polynomial::new([(1.0, 1e-320)]), is_exponent, "so near to 0");
}

#[test]
fn geometries_must_open_and_stay_open() {
    refused(Polynomial::new([(-0.5, 2.0)]), |e| matches!(e, ProfileError::NotOpening { .. }), "-0.5");
    // The second one outweighs the first where no number is as small.
    for terms in [[(1e-200, 2.0), (-1e200, 2.25)], [(1e-300, 2.0), (-1e300, 3.0)]] {
        let is_expected = |e: &ProfileError| matches!(e, ProfileError::NotOpening { .. });
        refused(Polynomial::new(terms), is_expected, "use a smaller unit of length");
    }
    let oblate = [(0.025, 2.0), (-1e-4, 4.0)];
    for value in NOT_A_SIZE.into_iter().filter(|&value| value != f64::INFINITY) {
        for terms in [oblate, [(0.025, 2.0), (1e-4, 4.0)]] {
            let is_limit = |e: &ProfileError| matches!(e, ProfileError::InvalidMaxRadius { .. });
            refused(Polynomial::with_max_radius(terms, value), is_limit, value);
            refused(Polynomial::with_max_radius(terms, value), is_limit, "or use `Polynomial::new`");
        }
    }
    let result = Polynomial::with_max_radius(oblate, 14.5);
    refused(result, |e| matches!(e, ProfileError::NotAdmissible { .. }), "14.5");
}

/// The range of an unlimited geometry is infinity.
#[test]
fn an_infinite_limit_is_none() -> Result<(), ProfileError> {
    for terms in [[(0.025, 2.0), (1e-4, 4.0)], [(0.025, 2.0), (-1e-4, 4.0)]] {
        let without = Polynomial::new(terms)?;
        assert_eq!(Polynomial::with_max_radius(terms, f64::INFINITY)?.max_radius(), without.max_radius());
    }
    let unlimited = Polynomial::new([(0.025_f32, 2.0)])?;
    let same = Polynomial::with_max_radius([(0.025_f32, 2.0)], unlimited.max_radius())?;
    assert_eq!(same.max_radius(), f32::INFINITY);
    Ok(())
}

#[test]
fn a_limit_that_is_none_holds_no_radius() {
    for case in cases() {
        let polynomial = case.polynomial();
        for profile in [case.double, &polynomial as &dyn GapProfile<f64>] {
            let load_integrals = [profile.load_integral(0.5); 200];
            let mut radii = [0.0; 200];
            for limit in [f64::NAN, f64::NEG_INFINITY, -1.0, 0.0] {
                let is_beyond = |e: &RadiusError| matches!(e, RadiusError::BeyondRange { .. });
                refused(profile.radius_within(load_integrals[0], limit), is_beyond, limit);
                refused(profile.radii_within(&load_integrals, limit, &mut radii), is_beyond, limit);
            }
        }
    }
}

#[test]
fn a_geometry_without_a_range_leads_to_its_check() {
    let is_beyond = |e: &RadiusError| matches!(e, RadiusError::BeyondRange { .. });
    for (c, d) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, 1.0), (-1.0, 1.0)] {
        refused(
            Two { c, d }.radius(1.0),
            is_beyond,
            "ask `GapProfile::check` what is wrong with the geometry",
        );
    }
}

/// Nobody checks a geometry before its radii are asked for within a limit, nor that limit.
#[test]
fn a_radius_that_does_not_exist_is_not_sought_for_ever() -> Result<(), ProfileError> {
    let closing: [&dyn GapProfile<f64>; 5] = [
        &Closing,
        &Polynomial::new([(0.025, 2.0), (-1e-4, 4.0)])?,
        &Two { c: 1.0, d: -1.0 },
        &Two { c: -1.0, d: -1.0 },
        &Fractional { c: 1.0, d: -1.0 },
    ];
    for profile in closing {
        for load_integral in [1e5, 1e10, 1e100] {
            for limit in [f64::INFINITY, 1e300, 1e60, 1e5, 20.0] {
                let is_beyond = |e: &RadiusError| matches!(e, RadiusError::BeyondRange { .. });
                refused(profile.radius_within(load_integral, limit), is_beyond, "lower the load");
                let mut radii = [0.0; 2];
                let found = profile.radii_within(&[load_integral; 2], limit, &mut radii);
                refused(found, is_beyond, "lower the load");
            }
        }
    }
    Ok(())
}

#[gap_profile(0.025 * r^2 - 1e-4 * r^4, max_radius = 10)]
struct Closing;

#[gap_profile(c * r^2 + d * r^4)]
struct Two {
    c: f64,
    d: f64,
}

#[gap_profile(c * r^2)]
struct One {
    c: f64,
}

/// Before anything is computed by the closed form.
#[test]
fn the_coefficient_of_a_single_term_is_checked() {
    let contact = |c| Contact::new(One { c }, *paraboloid().medium(), Constant(100.0));
    let is_coefficient =
        |e: &ContactError| matches!(e, ContactError::Profile(ProfileError::InvalidCoefficient { .. }));
    refused(contact(f64::INFINITY), is_coefficient, "inf");
    let is_closing = |e: &ContactError| matches!(e, ContactError::Profile(ProfileError::NotOpening { .. }));
    refused(contact(-1.0), is_closing, "-1");
    assert!(contact(1.0).is_ok());
}

#[gap_profile(c * r^2 + d * r^3.3)]
struct Fractional {
    c: f64,
    d: f64,
}

/// A ball whose radius comes from a measurement.
#[gap_profile(r^2 / (2 * radius) - r^4 / (8 * radius^3), max_radius = limit)]
struct Ball {
    radius: f64,
    limit: f64,
}

#[test]
fn symbols_of_a_generated_geometry_are_checked() {
    let checked = |radius, limit| GapProfile::<f64>::check(&Ball { radius, limit });
    assert_eq!(checked(20.0, 10.0), Ok(()));
    for radius in [0.0, f64::NAN] {
        refused(
            checked(radius, 10.0),
            |e| matches!(e, ProfileError::InvalidCoefficient { .. }),
            format_args!("radius = {radius}"),
        );
    }
    refused(checked(f64::INFINITY, 10.0), |e| matches!(e, ProfileError::Vanishing { .. }), "radius = inf");
    refused(checked(-20.0, 10.0), |e| matches!(e, ProfileError::NotOpening { .. }), "-0.025");
    refused(checked(20.0, 40.0), |e| matches!(e, ProfileError::NotAdmissible { .. }), "40");
    for value in NOT_A_SIZE.into_iter().filter(|&value| value != f64::INFINITY) {
        let is_limit = |e: &ProfileError| matches!(e, ProfileError::InvalidMaxRadius { .. });
        refused(checked(20.0, value), is_limit, value);
    }
    let unlimited = Ball { radius: 20.0, limit: f64::INFINITY };
    let polynomial = Polynomial::new([(1.0 / 40.0, 2.0), (-1.0 / 64_000.0, 4.0)]).map(|gap| gap.max_radius());
    assert_eq!(GapProfile::<f64>::check(&unlimited), Ok(()));
    assert_eq!(Ok(unlimited.max_radius()), polynomial);
    let contact = Contact::new(Ball { radius: -20.0, limit: 1.0 }, *paraboloid().medium(), Constant(1.0));
    refused(contact, |e| matches!(e, ContactError::Profile(ProfileError::NotOpening { .. })), "-0.025");
}

/// A worn ball, whose sizes are measured and cannot be negative.
#[gap_profile(r^2 / (2 * radius) + depth * r^4 / radius^4, positive = (depth, radius), max_radius = limit)]
struct Declared<T> {
    radius: T,
    depth: T,
    limit: f64,
}

#[test]
fn fields_declared_positive_are_held_to_it() {
    let declared = Declared { radius: 20.0, depth: 0.5, limit: 10.0 };
    assert_eq!((declared.check(), declared.max_radius()), (Ok(()), 10.0));
    let is_depth = |e: &ProfileError| matches!(e, ProfileError::NotPositive { field: "depth", .. });
    let is_radius = |e: &ProfileError| matches!(e, ProfileError::NotPositive { field: "radius", .. });
    for value in NOT_A_SIZE {
        let deep = Declared { depth: value, ..Declared { radius: 20.0, depth: 0.5, limit: 10.0 } };
        refused(deep.check(), is_depth, format_args!("`depth` is {value}"));
        let contact = Contact::new(deep, *paraboloid().medium(), Constant(1.0));
        refused(contact, |e| matches!(e, ContactError::Profile(ProfileError::NotPositive { .. })), "depth");
        let flat = Declared { radius: value as f32, depth: 0.5, limit: 10.0 };
        refused(flat.check(), is_radius, "`radius` is");
        let endless = Declared { radius: 20.0, depth: 0.5, limit: value };
        if value == f64::INFINITY {
            assert_eq!((endless.check(), endless.max_radius()), (Ok(()), value));
        } else {
            let is_limit = |e: &ProfileError| matches!(e, ProfileError::InvalidMaxRadius { .. });
            refused(endless.check(), is_limit, value);
            assert_eq!(endless.max_radius(), 0.0);
        }
    }
    let tiny = Declared { radius: 1e-200, depth: 0.5, limit: 10.0 };
    refused(tiny.check(), |e| matches!(e, ProfileError::InvalidCoefficient { .. }), "r^4");
}

/// A ball in a socket.
#[gap_profile(sphere(radius) - conic(k, 20 / k - 1), order = 2, max_radius = 6)]
struct Socket {
    radius: f64,
    k: f64,
}

/// A ball whose coefficients cannot be negative.
#[gap_profile(sphere(radius), order = 4, max_radius = 12, positive)]
struct Sphere {
    radius: f64,
}

#[test]
fn a_range_ends_inside_its_surfaces() {
    let (wide, narrow) = (Sphere { radius: 20.0 }, Sphere { radius: 10.0 });
    let ends: [f64; 2] = [wide.max_radius(), narrow.max_radius()];
    assert_eq!(ends, [12.0, 0.0]);
    let load_integral: f64 = narrow.load_integral(5.0);
    refused(narrow.radius(load_integral), |e| matches!(e, RadiusError::BeyondRange { .. }), "");
    let socket = |radius, k| GapProfile::<f64>::check(&Socket { radius, k });
    assert_eq!(socket(6.1, 20.0), Ok(()));
    assert_eq!(socket(10.0, -20.0), Ok(()));
    let is_expected = |e: &ProfileError| matches!(e, ProfileError::BeyondSurface { max_radius: 6.0, .. });
    refused(socket(6.0, 20.0), is_expected, "with radius = 6, k = 20: ");
    refused(socket(5.9, 20.0), is_expected, "ends at r = 5.9");
}

/// A coefficient that fits into the format is refused if the numbers computed from it do not fit.
#[test]
fn coefficients_leave_room_for_the_closed_forms() {
    let is_expected = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { .. });
    for n in [1.0, 2.0, 4.0, 64.0, 1024.0] {
        for coefficient in [f64::MAX, f64::MAX / 1.9] {
            refused(Polynomial::new([(coefficient, n)]), is_expected, "must be a finite number");
        }
        let largest = Polynomial::new([(f64::MAX / 2.1, n)]).unwrap_or_else(|error| unreachable!("{error}"));
        let contact = contact(largest, Constant(100.0));
        for time in [0.0, 200.0] {
            let now = contact.at(time).unwrap_or_else(|error| unreachable!("{error}"));
            let results = [now.radius(), now.approach(), now.peak_pressure()];
            assert!(results.iter().all(|result| result.is_finite() && *result > 0.0), "r^{n}: {results:?}");
        }
    }
    refused(Polynomial::new([(3e38_f32, 2.0)]), is_expected, "must be a finite number");
}

/// The same geometry is good in double precision, and in single precision in another unit of length.
#[test]
fn constants_need_a_format_that_holds_them() {
    let is_expected = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 64.0, .. });
    refused(
        GapProfile::<f32>::check(&tests::profiles::FlatEnded),
        is_expected,
        "a format with more exponents",
    );
    assert_eq!(GapProfile::<f64>::check(&tests::profiles::FlatEnded), Ok(()));
    refused(GapProfile::<f32>::check(&Faint), is_expected, "the format rounds it to that");
    assert_eq!(GapProfile::<f64>::check(&Faint), Ok(()));
    let beside_field = FaintBesideField { curvature: 0.025 };
    refused(GapProfile::<f32>::check(&beside_field), is_expected, "with curvature = 0.025");
    refused(GapProfile::<f32>::check(&beside_field), is_expected, "r^64 is 0, but only because the format");
    assert_eq!(GapProfile::<f64>::check(&beside_field), Ok(()));
    let contact = Contact::new(
        &beside_field,
        Medium::from_constants(1.0_f32, 0.0).unwrap_or_else(|e| unreachable!("{e}")),
        Constant(1.0),
    );
    assert!(matches!(contact, Err(ContactError::Profile(_))), "{contact:?}");
}

/// A term that is zero in single precision, although at r = 9 it is larger than the other one.
#[gap_profile(0.025 * r^2 + 1e-60 * r^64)]
struct Faint;

/// The same term beside a field.
#[gap_profile(curvature * r^2 + 1e-60 * r^64)]
struct FaintBesideField {
    curvature: f64,
}
