//! A whole pressure field is the pressures of its snapshots.

use core::f64::consts::FRAC_PI_4;

use cartcontact::load::{Constant, Load};
use cartcontact::{Contact, ContactError, GapProfile, Medium};
use tests::budget;
use tests::loads::{Rise, histories, through};
use tests::measure::Errors;
use tests::profiles::{Case, cases};

const CHI: f64 = 0.02;
const LAST_RADIUS: f64 = 5.0;

type Dynamic<'a> = Contact<f64, &'a dyn GapProfile<f64>, &'a dyn Load<f64>>;

/// A contact whose radius is [`LAST_RADIUS`] at the last of `times`.
fn contact<'a>(case: Case, load: &'a dyn Load<f64>, times: &[f64]) -> Result<Dynamic<'a>, ContactError> {
    let t = times.last().copied().unwrap_or(0.0);
    let stiffness = (load.force(t) + CHI * load.impulse(t)) / case.double.load_integral(LAST_RADIUS);
    let medium = Medium::from_constants(stiffness / FRAC_PI_4, CHI).unwrap_or_else(|e| unreachable!("{e}"));
    Contact::new(case.double, medium, load)
}

/// Compares every value of a field with the pressure of the snapshot at its time.
fn compare(
    errors: &mut Errors,
    case: Case,
    load: &dyn Load<f64>,
    times: &[f64],
    radii: &[f64],
) -> Result<(), ContactError> {
    let contact = contact(case, load, times)?;
    let mut values = vec![f64::NAN; times.len() * radii.len()];
    contact.pressure_field(times, radii, &mut values)?;
    for (&t, row) in times.iter().zip(values.chunks(radii.len())) {
        let now = contact.at(t)?;
        for (&r, &value) in radii.iter().zip(row) {
            let edge = if r < now.radius() { 1.0 + 2.0 * now.radius() / (now.radius() - r) } else { 1.0 };
            errors.add(value, now.pressure(r), edge, &(case, t, r));
        }
    }
    Ok(())
}

/// Radii from the axis to outside the contact.
fn grid(count: u32) -> Vec<f64> {
    (0..count).map(|index| 1.1 * LAST_RADIUS * f64::from(index) / f64::from(count - 1)).collect()
}

#[test]
fn a_field_is_its_snapshots_for_every_geometry_and_load() -> Result<(), ContactError> {
    let times: Vec<f64> = [0.0, 1e-3, 0.1, 0.25, 0.8, 1.0, 2.0, 3.0].map(|time| time / CHI).into();
    let mut errors = Errors::of(budget::FIELD);
    for case in cases() {
        for (_, load) in histories(CHI) {
            compare(&mut errors, case, &load, &times, &grid(12))?;
        }
        compare(&mut errors, case, &Rise { start: 10.0, rise: 90.0, rate: 0.01 }, &times, &grid(6))?;
    }
    errors.check();
    Ok(())
}

#[test]
fn radii_may_come_in_any_order() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::FIELD);
    let radii = [3.0, 0.0, 5.2, 4.9, 1e-9, 4.9, 2.0, 5.0, 3.0];
    for case in cases() {
        compare(&mut errors, case, &Constant(100.0), &[0.0, 10.0, 50.0, 100.0], &radii)?;
    }
    errors.check();
    Ok(())
}

#[test]
fn times_may_repeat_and_lie_far_apart() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::FIELD);
    let times = [0.0, 0.0, 1.0, 1.0, 1e4, 1e4, 1e4 + 1.0, 1e6];
    for case in cases() {
        for (_, load) in histories(CHI) {
            compare(&mut errors, case, &load, &times, &grid(8))?;
        }
    }
    errors.check();
    Ok(())
}

#[test]
fn roundings_do_not_add_up_over_many_rows() -> Result<(), ContactError> {
    let times: Vec<f64> = (0..400).map(f64::from).collect();
    let mut errors = Errors::of(budget::FIELD);
    for case in cases() {
        for (_, load) in histories(CHI) {
            compare(&mut errors, case, &load, &times, &[0.0, 3.0, 4.5])?;
        }
    }
    errors.check();
    Ok(())
}

/// Where a load falls as fast as e^(−χ t), the edge stands still and its time is as uncertain as a square root.
#[test]
fn a_step_of_the_field_may_begin_within_the_fastest_fall() -> Result<(), ContactError> {
    let fall = through(&[(0.0, 100.0), (12.5, 80.0), (100.0, 80.0)]);
    let mut errors = Errors::of(budget::FIELD);
    for case in cases() {
        for last in [12.5, 12.6, 13.0, 15.0, 40.0] {
            compare(&mut errors, case, &fall, &[11.0, 12.0, last], &[0.0, 3.0])?;
        }
    }
    errors.check();
    Ok(())
}

#[test]
fn a_field_may_start_late() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::FIELD);
    for case in cases() {
        for (_, load) in histories(CHI) {
            compare(&mut errors, case, &load, &[30.0, 31.0, 70.0], &grid(8))?;
        }
    }
    errors.check();
    Ok(())
}

#[test]
fn a_matrix_holds_the_same_field() -> Result<(), ContactError> {
    let (times, radii) = ([0.0, 20.0, 80.0], [0.0, 1.0, 4.0, 6.0]);
    for case in cases() {
        let contact = contact(case, &Constant(100.0), &times)?;
        let mut values = [0.0; 12];
        contact.pressure_field(&times, &radii, &mut values)?;
        let matrix = contact.pressure_matrix(&times, &radii)?;
        assert_eq!(matrix.shape(), (3, 4));
        assert!(matrix.transpose().iter().eq(&values), "{case:?}");
    }
    Ok(())
}
