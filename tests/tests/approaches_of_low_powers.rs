//! Approaches of gaps of one low power: the power moves them little, so that the rounding of their own coefficient counts.

use cartcontact::load::Constant;
use cartcontact::{Contact, ContactError, GapProfile, Medium, Scalar, gap_profile};
use tests::budget;
use tests::condition;
use tests::measure::Errors;
use tests::oracle::{Oracle, Profile};
use tests::random::Stream;

// Coefficients that lose much of a unit in the last place when 2 C/(n+2) is rounded.
#[gap_profile(0.1 * r)]
struct Cone;
#[gap_profile(0.09 * r^0.5)]
struct Root;
#[gap_profile(0.7 * r^0.5)]
struct SteepRoot;
#[gap_profile(0.3 * r^0.25)]
struct FourthRoot;

/// The approach at once, under a held load.
fn approach<T: Scalar>(profile: &dyn GapProfile<T>, m: T, force: T) -> Result<f64, ContactError> {
    let contact = Contact::new(profile, Medium::from_constants(m, T::zero())?, Constant(force))?;
    Ok(contact.at(T::zero())?.approach().value())
}

#[test]
fn approaches_in_single_precision_are_those_of_double() -> Result<(), ContactError> {
    let mut errors = Errors::of_single(budget::CONTACT_APPROACH);
    let mut add = |single: &dyn GapProfile<f32>, double: &dyn GapProfile<f64>| {
        let mut stream = Stream::of_case(10, 0);
        for _ in 0..40_000 {
            let (m, force) = (stream.between(0.1, 10.0) as f32, stream.between(1.0, 500.0) as f32);
            let (found, expected) =
                (approach(single, m, force)?, approach::<f64>(double, m.into(), force.into())?);
            errors.add(found, expected, condition::of_approach(double, 1.0), &(m, force));
        }
        Ok::<_, ContactError>(())
    };
    add(&Cone, &Cone)?;
    add(&Root, &Root)?;
    add(&SteepRoot, &SteepRoot)?;
    add(&FourthRoot, &FourthRoot)?;
    errors.check_worst();
    Ok(())
}

#[test]
fn approaches_are_those_of_the_oracle() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::CONTACT_APPROACH);
    let mut add = |profile: &dyn GapProfile<f64>, term: (&str, &str)| {
        let mut stream = Stream::of_case(10, 0);
        for _ in 0..400 {
            let (m, force) = (stream.between(0.1, 10.0), stream.between(1.0, 500.0));
            let expected = Oracle::new(Profile::of_decimals(&[term]), m, 0.0, &[(0.0, force)]).approach(0.0);
            let (found, condition) = (approach(profile, m, force)?, condition::of_approach(profile, 1.0));
            errors.add(found, &expected, condition, &(term, m, force));
        }
        Ok::<_, ContactError>(())
    };
    add(&Cone, ("0.1", "1"))?;
    add(&Root, ("0.09", "0.5"))?;
    add(&SteepRoot, ("0.7", "0.5"))?;
    add(&FourthRoot, ("0.3", "0.25"))?;
    errors.check_worst();
    Ok(())
}
