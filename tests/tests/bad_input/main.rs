//! Values that make no sense are refused where they enter, with the value and a remedy; nothing panics.

mod formats;
mod geometries;
mod loads;
mod media;
mod products;

use core::fmt::{Debug, Display};

use cartcontact::load::{Constant, Load, LoadError, PiecewiseLinear};
use cartcontact::{Contact, ContactError, GapProfile, Layer, Medium, MediumError, ProfileError, RadiusError};
use tests::profiles::{Oblate, Paraboloid, cases};

const NOT_A_SIZE: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0];
const NOT_AN_AMOUNT: [f64; 4] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0];

/// Expects an error whose message holds the rule, the value and, after the semicolon, a remedy.
fn refused<T, E: Display + Debug>(result: Result<T, E>, is_expected: fn(&E) -> bool, value: impl Display) {
    let value = value.to_string();
    let Err(error) = result else { unreachable!("{value} is accepted") };
    assert!(is_expected(&error), "{error:?} for {value}");
    let message = error.to_string();
    assert!(message.contains(&value), "no {value} in: {message}");
    let (rule, remedy) = message.split_once("; ").unwrap_or_default();
    assert!(!rule.is_empty() && !remedy.is_empty(), "no remedy in: {message}");
    assert!(message.starts_with(|first: char| !first.is_uppercase()) && !message.ends_with('.'), "{message}");
}

fn layer() -> Layer<f64> {
    Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 }
}

/// The contact of a geometry between two such layers under a load; neither is refused.
fn contact<P: GapProfile<f64>, L: Load<f64>>(profile: P, load: L) -> Contact<f64, P, L> {
    let medium = Medium::between(layer(), layer()).unwrap_or_else(|error| unreachable!("{error}"));
    Contact::new(profile, medium, load).unwrap_or_else(|error| unreachable!("{error}"))
}

fn paraboloid() -> Contact<f64, Paraboloid, Constant<f64>> {
    contact(Paraboloid, Constant(100.0))
}

#[test]
fn load_integrals_are_finite_and_within_the_range() {
    for case in cases() {
        for value in NOT_AN_AMOUNT {
            let is_expected = |e: &RadiusError| matches!(e, RadiusError::InvalidLoadIntegral { .. });
            refused(case.double.radius(value), is_expected, value);
            refused(case.single.radius(value as f32), is_expected, value);
            refused(case.polynomial().radius(value), is_expected, value);
        }
        if case.max_radius.is_some() {
            let is_expected = |e: &RadiusError| matches!(e, RadiusError::BeyondRange { .. });
            refused(case.double.radius(1e30), is_expected, "1e30");
        }
    }
}

#[test]
fn times_are_finite_and_not_negative() {
    for value in NOT_AN_AMOUNT {
        let is_time = |e: &ContactError| matches!(e, ContactError::InvalidTime { .. });
        refused(paraboloid().at(value), is_time, value);
        refused(paraboloid().radii(&[0.0, value], &mut [0.0; 2]), is_time, value);
        refused(paraboloid().pressure_field(&[value], &[0.0], &mut [0.0]), is_time, value);
    }
}

#[test]
fn slices_fit_together() {
    let contact = paraboloid();
    let is_empty = |e: &ContactError| matches!(e, ContactError::Empty { .. });
    refused(contact.radii(&[], &mut []), is_empty, "times");
    refused(contact.pressure_field(&[], &[1.0], &mut []), is_empty, "times");
    refused(contact.pressure_field(&[1.0], &[], &mut []), is_empty, "radii");
    let is_length = |e: &ContactError| matches!(e, ContactError::Length { .. });
    refused(contact.radii(&[1.0, 2.0], &mut [0.0; 3]), is_length, "3, but it needs 2");
    refused(contact.approaches(&[1.0, 2.0], &mut [0.0; 3]), is_length, "approaches");
    refused(contact.pressure_field(&[1.0, 2.0], &[1.0, 2.0], &mut [0.0; 3]), is_length, "3, but it needs 4");
    let is_unsorted = |e: &ContactError| matches!(e, ContactError::Unsorted { index: 1, .. });
    refused(contact.pressure_field(&[2.0, 1.5], &[1.0], &mut [0.0; 2]), is_unsorted, "1.5");
    refused(contact.pressure_matrix(&[2.0, 1.5], &[1.0]), is_unsorted, "1.5");
}

#[test]
fn radii_of_a_field_are_finite_and_not_negative() {
    for value in NOT_AN_AMOUNT {
        let result = paraboloid().pressure_field(&[1.0], &[0.0, value], &mut [0.0; 2]);
        refused(result, |e| matches!(e, ContactError::InvalidRadius { index: 1, .. }), value);
    }
}

#[test]
fn a_pressure_anywhere_is_a_number_or_says_that_the_radius_is_none() -> Result<(), ContactError> {
    let contact = paraboloid();
    for t in [0.0, 200.0] {
        let now = contact.at(t)?;
        assert!(now.pressure(f64::NAN).is_nan());
        for r in [f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 8.5] {
            assert_eq!(now.pressure(r), 0.0);
        }
        assert_eq!(now.pressure(-0.0), now.peak_pressure());
    }
    Ok(())
}

#[test]
fn a_contact_that_leaves_its_range_says_when() {
    let contact = contact(Oblate, Constant(100.0));
    assert!(contact.at(0.0).is_ok());
    let Err(ContactError::BeyondRange { leaves_at, max_radius, .. }) = contact.at(1e5) else {
        unreachable!("the range is not left");
    };
    assert_eq!(max_radius, 8.0);
    assert!(contact.at(leaves_at).is_ok_and(|now| (now.radius() - 8.0).abs() < 1e-14));
    refused(contact.at(1e5), |e| matches!(e, ContactError::BeyondRange { .. }), "radius reaches 8");
}

#[test]
fn a_contact_that_jumps_out_of_its_range_leaves_it_at_the_jump() -> Result<(), ContactError> {
    for jump in [0.1, 5.0, 300.0] {
        let load = PiecewiseLinear::new([(0.0, 50.0), (jump, 50.0), (jump, 500.0)])?;
        let contact = contact(Oblate, load);
        for time in [jump, 2.0 * jump] {
            let Err(ContactError::BeyondRange { leaves_at, .. }) = contact.at(time) else {
                unreachable!("the range is not left");
            };
            assert_eq!(leaves_at, jump);
        }
    }
    // The range is left within a ramp, however steep the ramp is.
    let load = PiecewiseLinear::new([(0.0, 50.0), (5.0, 50.0), (5.001, 500.0)])?;
    let contact = contact(Oblate, load);
    let Err(ContactError::BeyondRange { leaves_at, .. }) = contact.at(6.0) else {
        unreachable!("the range is not left");
    };
    // A rounding of the time is 4e-10 N, which moves the edge by 4e-12 mm.
    assert!(contact.at(leaves_at).is_ok_and(|now| (now.radius() - 8.0).abs() < 1e-11));
    assert!(contact.at(leaves_at.next_up()).is_err());
    Ok(())
}

#[test]
fn a_contact_that_begins_beyond_its_range_says_so() {
    let contact = contact(Oblate, Constant(1e6));
    for t in [0.0, 200.0] {
        refused(
            contact.at(t),
            |e| matches!(e, ContactError::BeyondRange { leaves_at: 0.0, .. }),
            "as soon as the load is applied",
        );
    }
}

#[test]
fn the_message_of_an_error_inside_is_said_once() {
    let no_medium = MediumError::Stiffness { m: 0.0 };
    for (error, inside) in [
        (ContactError::from(ProfileError::Empty), ProfileError::Empty.to_string()),
        (ContactError::from(LoadError::Empty), LoadError::Empty.to_string()),
        (ContactError::from(no_medium), no_medium.to_string()),
    ] {
        assert_eq!(error.to_string(), inside);
        assert!(core::error::Error::source(&error).is_none());
    }
}

#[test]
fn a_function_of_layers_and_a_load_has_one_error() {
    let radius = |layer| -> Result<f64, ContactError> {
        let load = PiecewiseLinear::new([(0.0, 100.0)])?;
        Ok(Contact::new(Paraboloid, Medium::against_rigid(layer)?, load)?.at(0.0)?.radius())
    };
    assert!(radius(layer()).is_ok());
    let soft = Layer { shear_modulus: 0.0, ..layer() };
    refused(radius(soft), |e| matches!(e, ContactError::Medium(_)), "shear modulus is 0");
}
