//! A pressure field consists of the pressures of its snapshots.

use cartcontact::load::{Constant, Load};
use cartcontact::{ContactError, GapProfile};
use proptest::prelude::*;
use tests::budget;
use tests::loads::{CountingSearches, Rise, histories, through};
use tests::measure::{Errors, relative_error};
use tests::planted;
use tests::profiles::{Case, Patellofemoral, cases};
use tests::random;

use super::{Joint, Value, joint, values};

const CHI: f64 = 0.02;
const LAST_RADIUS: f64 = 5.0;

type Dynamic<'a> = Joint<'a, f64, &'a dyn GapProfile<f64>>;

/// A contact whose radius is [`LAST_RADIUS`] at the last of `times`.
fn contact<'a>(case: Case, load: &'a dyn Load<f64>, times: &[f64]) -> Result<Dynamic<'a>, ContactError> {
    planted::contact(case.double, load, CHI, LAST_RADIUS, times.last().copied().unwrap_or(0.0))
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
    for Value { t, r, found, expected, edge, .. } in values(&contact, times, radii, 1)? {
        errors.add(found, expected, edge, &(case, t, r));
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

/// This holds even where the edge has moved by less than the rounding of its radius.
#[test]
fn the_edge_carries_nothing() -> Result<(), ContactError> {
    for force in [1.0, 2.0, 3.7, 100.0] {
        let load = Constant(force);
        let contact = joint(Patellofemoral, 0.0015, &load);
        let radius = contact.at(0.0)?.radius();
        let times = [0.0, 1e-14, 1e-13, 1e-12, 1e-9, 1.0];
        // Also between radii that are in no order.
        for radii in [&[radius] as &[f64], &[0.0, radius, 0.1]] {
            let mut values = vec![f64::NAN; times.len() * radii.len()];
            contact.pressure_field(&times, radii, &mut values)?;
            for (t, row) in times.into_iter().zip(values.chunks(radii.len())) {
                let (now, value) = (contact.at(t)?, row[radii.len() / 2]);
                assert_eq!(value == 0.0, now.radius() <= radius, "{force} N, {t} s: {value:e}");
            }
        }
        // Nor does that of a row which no other is before.
        for t in times {
            let mut value = [f64::NAN];
            contact.pressure_field(&[t], &[contact.at(t)?.radius()], &mut value)?;
            assert_eq!(value, [0.0], "{force} N, {t} s");
        }
    }
    Ok(())
}

/// Next to the edge, what rows add is the difference of nearly equal numbers.
#[test]
fn pressures_at_the_edge_of_the_first_row_are_not_negative() -> Result<(), ContactError> {
    let contact = joint(Patellofemoral, CHI, &Constant(100.0));
    for case in 0..2000 {
        let start = 1.0 + f64::from(case) / 100.0;
        let times: Vec<f64> = (0..20).map(|row| start * (1.0 + f64::EPSILON * f64::from(1 << row))).collect();
        let edge = contact.at(times[0])?.radius();
        let radii: Vec<f64> = (1..40).map(|k| edge * (1.0 - 0.5 * f64::EPSILON * f64::from(k))).collect();
        let mut values = vec![f64::NAN; times.len() * radii.len()];
        contact.pressure_field(&times, &radii, &mut values)?;
        assert!(values.iter().all(|&pressure| pressure >= 0.0), "{start} s");
    }
    Ok(())
}

/// Once for the first row, and once for all, also where numbers are beyond the usual sizes, each of which is then looked
/// at.
#[test]
fn a_history_is_searched_twice_for_any_number_of_rows() -> Result<(), ContactError> {
    let times: Vec<f64> = (0..1000).map(|k| f64::from(k) * 0.1 / CHI).collect();
    let histories = histories(CHI);
    let rises = [100.0, 1e-200].map(|force| Rise { start: force, rise: force, rate: 0.01 });
    let loads = histories.iter().map(|(name, load)| (*name, load as &dyn Load<f64>));
    let rises = ["rise", "tiny rise"].into_iter().zip(rises.iter().map(|rise| rise as &dyn Load<f64>));
    for (name, load) in loads.chain(rises) {
        let (load, radii) = (CountingSearches::new(load), grid(4));
        let contact = joint(Patellofemoral, CHI, &load);
        contact.pressure_field(&times, &radii, &mut vec![0.0; times.len() * radii.len()])?;
        assert_eq!(load.searches(), 2, "{name}");
    }
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

/// Steps are so short that thousands of rows lie within one memory, and equal, so that their roundings are equal too.
#[test]
fn roundings_do_not_add_up_over_thousands_of_equal_steps() -> Result<(), ContactError> {
    let times: Vec<f64> = (0..6000).map(|row| f64::from(row) / 100.0).collect();
    let mut errors = Errors::of(budget::FIELD);
    for case in cases() {
        compare(&mut errors, case, &Constant(100.0), &times, &[0.0, 2.0, 4.7])?;
    }
    errors.check_worst();
    Ok(())
}

/// Most of these radii are covered one by one, some within a step that is long for the geometry, some within a short
/// one.
#[test]
fn radii_may_be_as_dense_as_the_edges() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::FIELD);
    let radii: Vec<f64> = (0..300).map(|k| 4.0 + f64::from(k) / 280.0).collect();
    for rows in [4, 30, 200] {
        let times: Vec<f64> = (0..rows).map(|row| f64::from(row) * 100.0 / f64::from(rows)).collect();
        for case in cases() {
            for (_, load) in histories(CHI) {
                compare(&mut errors, case, &load, &times, &radii)?;
            }
        }
    }
    errors.check();
    Ok(())
}

#[test]
fn single_precision_has_its_own_rounding() -> Result<(), ContactError> {
    let mut errors = Errors::of_single(budget::FIELD);
    let times: Vec<f32> = (0..500_u16).map(|row| f32::from(row) / 4.0).collect();
    let radii: Vec<f32> = (0..40_u16).map(|k| f32::from(k) / 12.0).collect();
    let load: &dyn Load<f32> = &Constant(100.0);
    for case in cases() {
        // A last radius of 3: 4^64 is beyond single precision.
        let contact = match planted::contact(case.single, load, CHI as f32, 3.0, times[499]) {
            // Its coefficient 1e-40 lacks digits in single precision.
            Err(ContactError::Profile(_)) if case.name == "FlatEnded" => continue,
            contact => contact?,
        };
        for Value { t, r, found, expected, edge, .. } in values(&contact, &times, &radii, 1)? {
            errors.add(f64::from(found), f64::from(expected), edge, &(case, t, r));
        }
    }
    errors.check_worst();
    Ok(())
}

proptest! {
    #![proptest_config(random::cases(200))]

    #[test]
    fn a_field_is_its_snapshots_in_any_scene(
        gap in random::positive_sums(),
        folds in random::magnitude(-3.0..3.0),
        growth in prop_oneof![Just(0.0), 0.0..20.0],
        steps in proptest::collection::vec(random::magnitude(-4.0..0.0), 2..150),
        radii in proptest::collection::vec(0.0..1.1, 1..20),
    ) {
        let end: f64 = steps.iter().sum();
        let mut now = 0.0;
        let times: Vec<f64> = steps.iter().map(|step| { now += step; now }).collect();
        let load = through(&[(0.0, 1.0), (0.6 * end, 1.0 + growth), (2.0 * end, 1.0 + growth)]);
        let chi = folds / end;
        let contact: Result<Dynamic<'_>, _> = planted::contact(&gap, &load, chi, 1.0, now);
        let values = contact.and_then(|contact| values(&contact, &times, &radii, 1));
        for Value { t, r, found, expected, edge, .. } in values.map_err(random::failure)? {
            let error = relative_error(found, expected, f64::EPSILON) / edge;
            prop_assert!(error <= budget::FIELD.double, "{error} ε at t = {t}, r = {r}: {found}");
        }
    }
}

/// Where a load falls as fast as e^(−χ t), the edge stands still and its time is as uncertain as a square
/// root.
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

/// What the edge passes last has a pressure in proportion to a rate that vanishes.
#[test]
fn rows_may_end_just_before_the_end_of_the_fastest_fall() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::FIELD);
    for folds in [0.003, 0.01, 0.03] {
        let end = folds / CHI;
        let fall = through(&[(0.0, 100.0), (end, 100.0 / (1.0 + folds))]);
        for case in cases() {
            for rest in [1e-3, 1e-4, 3e-5] {
                let times = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0 - rest, 1.0 - 0.1 * rest].map(|share| end * share);
                let before = contact(case, &fall, &times)?.at(times[5])?.radius();
                let radii = [0.1, 0.5].map(|share| before + (LAST_RADIUS - before) * share);
                compare(&mut errors, case, &fall, &times, &radii)?;
            }
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
