//! Numbers that a format holds without all their digits, or whose products it does not hold.

use cartcontact::load::{Constant, LoadError, PiecewiseLinear};
use cartcontact::{Contact, ContactError, Medium, Polynomial};
use tests::budget;
use tests::measure::ulps;

/// Scenes whose numbers have lost digits are refused, not solved.
#[test]
fn numbers_without_digits_are_refused() -> Result<(), Box<dyn core::error::Error>> {
    let paraboloid = || Polynomial::new([(0.025, 2.0)]);
    let at = |m: f64, force: f64| {
        let contact = Contact::new(paraboloid()?, Medium::from_constants(m, 0.01)?, Constant(force))?;
        Ok::<_, Box<dyn core::error::Error>>(contact.at(1.0).err())
    };
    for (m, force) in [(1.0, 5e-324), (1.0, 1e-310), (1e200, 1e-150)] {
        assert!(matches!(at(m, force)?, Some(ContactError::Unrepresentable { .. })), "{m:e}, {force:e}");
    }
    assert_eq!(at(1.0, 1e-290)?, None);
    assert!(Medium::from_constants(1e-310, 0.0).is_err() && Medium::from_constants(1.0, 1e-310).is_err());
    assert!(Polynomial::new([(1e-306, 64.0)]).is_err());
    // Most of Y is χ ∫F, and ∫F is subnormal.
    let draining = Contact::new(paraboloid()?, Medium::from_constants(1e-170, 1e150)?, Constant(1e-200))?;
    assert!(matches!(draining.at(1e-120), Err(ContactError::Unrepresentable { .. })));
    assert!(draining.at(1e-100).is_ok());
    // J is in range, but a J′ = 710 J is not.
    let medium = Medium::from_constants(6e-306, 5e-8)?;
    let steep = Contact::new(Polynomial::new([(8.0, 706.0)])?, medium, Constant(0.135))?;
    assert!(matches!(steep.at(3e10), Err(ContactError::Unrepresentable { .. })));
    Ok(())
}

/// From where the documentation of the language says that they are.
#[test]
fn small_coefficients_of_high_powers_are_usable() {
    assert!(Polynomial::new([(2e-304, 64.0)]).is_ok() && Polynomial::new([(1e-304, 64.0)]).is_err());
    assert!(Polynomial::new([(1.1e-34_f32, 64.0)]).is_ok() && Polynomial::new([(1e-34_f32, 64.0)]).is_err());
    assert!(Polynomial::new([(7.237e35_f32, 64.0)]).is_ok());
}

/// Y is in range, but neither F′ nor χ F is: ages would not be numbers.
#[test]
fn rates_out_of_range_are_refused() -> Result<(), Box<dyn core::error::Error>> {
    let ramp = PiecewiseLinear::new([(0.0, 3e16_f32), (2.5e-23, 4e17)]);
    assert!(matches!(ramp, Err(LoadError::TooSteep { knot: 1, .. })), "{ramp:?}");
    let medium = Medium::from_constants(1.0, 1e25_f32)?;
    let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, Constant(1e20))?;
    for time in [0.0, 1e-30, 1e-24] {
        assert!(matches!(contact.at(time), Err(ContactError::Unrepresentable { .. })), "{time:e}");
    }
    Ok(())
}

/// J is in range, but what the force adds to it in an e-folding, 4 F/(π m), has lost its digits.
#[test]
fn pressures_without_digits_are_refused() -> Result<(), Box<dyn core::error::Error>> {
    let contact = |m, chi, force| {
        let medium = Medium::from_constants(m, chi)?;
        Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, Constant(force))
    };
    for size in [1e15, 1e20, 1e30] {
        let contact = contact(1e300, size, 1.0 / size)?;
        assert!(matches!(contact.at(1.0), Err(ContactError::Unrepresentable { .. })), "{size:e}");
        let mut radii = [0.0; 2];
        let found = contact.radii(&[1.0; 2], &mut radii);
        assert!(matches!(found, Err(ContactError::Unrepresentable { .. })), "{size:e}");
    }
    // After many e-foldings P is a paraboloid, but for 1/(3 χ t) of it and 1/(χ t)².
    let contact = contact(1e300, 1e10, 1e-5)?;
    let now = contact.at(1.0)?;
    let paraboloid = 2.0 * now.force() / (core::f64::consts::PI * now.radius() * now.radius());
    let expected = paraboloid * (1.0 + 1.0 / 3e10);
    let error = ulps(now.peak_pressure(), expected.into(), f64::EPSILON);
    // The radius squared, and the rounding of what is expected.
    let allowed = budget::PEAK_PRESSURE.double + 2.0 * budget::CONTACT_RADIUS.double + 4.0;
    assert!(error <= allowed, "{error} ulp");
    Ok(())
}
