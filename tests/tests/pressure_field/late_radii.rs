//! Rows of a field in which many radii are reached one after the other, against pressures one by one.

use cartcontact::load::Load;
use cartcontact::{ContactError, GapProfile};
use tests::budget;
use tests::condition::edge;
use tests::loads::{CountingForces, Knots, Rise, through};
use tests::measure::Errors;
use tests::profiles::{Decimals, Oblate, Paraboloid, Patellofemoral};
use tests::random::Stream;

use super::joint;

type Failure = Box<dyn core::error::Error>;

const CHI: f64 = 0.0015;

/// A record from zero on, of so many pieces that rise, are held, or fall as fast as e^(−χ t), and of steps.
fn record(stream: &mut Stream, count: usize, end: f64) -> Knots {
    let (mut t, mut force) = (0.0, 0.0);
    let mut knots = vec![(t, force)];
    for _ in 0..count {
        let duration = stream.between(0.1, 1.9) * end / count as f64;
        t += duration;
        force = match stream.below(5) {
            0 => force,
            1 => force / (1.0 + CHI * duration),
            2 => {
                knots.push((t, force));
                force + stream.between(0.0, 20.0 / count as f64)
            }
            _ => force + stream.between(0.0, 40.0 / count as f64),
        };
        knots.push((t, force));
    }
    through(&knots)
}

/// Compares a row at a time, the first of its field and after an early row, with the pressures one by one.
fn compare(
    profile: &dyn GapProfile<f64>,
    (load, chi): (&dyn Load<f64>, f64),
    (time, count): (f64, usize),
    errors: &mut Errors,
) -> Result<(), Failure> {
    let contact = joint(profile, chi, load);
    let now = contact.at(time)?;
    let radii: Vec<f64> = (0..count).map(|k| 1.05 * now.radius() * k as f64 / count as f64).collect();
    let (mut row, mut rows) = (vec![f64::NAN; count], vec![f64::NAN; 2 * count]);
    contact.pressure_field(&[time], &radii, &mut row)?;
    contact.pressure_field(&[0.01 * time, time], &radii, &mut rows)?;
    for (k, &r) in radii.iter().enumerate() {
        let expected = now.pressure(r);
        for found in [row[k], rows[count + k]] {
            if expected > 0.0 {
                errors.add(found, expected, edge(now.radius(), r), &(time, count, r));
            } else {
                assert_eq!(found, 0.0, "{time}, {r}");
            }
        }
    }
    Ok(())
}

#[test]
fn rows_are_pressures_one_by_one() -> Result<(), Failure> {
    let mut errors = Errors::of(budget::FIELD);
    let profiles: [&dyn GapProfile<f64>; 4] = [&Paraboloid, &Patellofemoral, &Decimals, &Oblate];
    let mut stream = Stream::of_case(1, 0);
    for (index, count) in [3, 4, 5, 30, 300, 700].into_iter().enumerate() {
        for pieces in [2, 17, 200] {
            let load = record(&mut stream, pieces, 300.0);
            let time = stream.between(1.0, 330.0);
            compare(profiles[index % 4], (&load, CHI), (time, count), &mut errors)?;
        }
    }
    // A history of many e-foldings, and one that has nearly ended.
    for (chi, time) in [(0.1, 290.0), (CHI, 1e4)] {
        let load = record(&mut stream, 60, 300.0);
        compare(&Patellofemoral, (&load, chi), (time, 200), &mut errors)?;
    }
    let ramp: Vec<(f64, f64)> = (0..60).map(|k| (5.0 * f64::from(k), f64::from(k - k % 3))).collect();
    for chi in [0.1, 1e-5, 0.0] {
        compare(&Patellofemoral, (&through(&ramp), chi), (290.0, 200), &mut errors)?;
    }
    errors.check();
    Ok(())
}

#[test]
fn rows_under_a_load_that_is_not_straight_are_too() -> Result<(), Failure> {
    let mut errors = Errors::of(budget::FIELD);
    for rate in [1e-3, 0.1, 3.0] {
        let load = Rise { start: 0.0, rise: 80.0, rate };
        for time in [1.0, 200.0] {
            compare(&Patellofemoral, (&load, CHI), (time, 100), &mut errors)?;
        }
    }
    errors.check();
    Ok(())
}

/// The knots between two rows are passed by sections of time, not by each radius that is reached between them.
#[test]
fn a_row_long_after_another_takes_as_long_as_alone() -> Result<(), ContactError> {
    let radii: Vec<f64> = (0..500).map(|k| 0.015 * f64::from(k)).collect();
    let load = CountingForces::new(record(&mut Stream::of_case(2, 0), 400, 300.0));
    let contact = joint(Patellofemoral, CHI, &load);
    let forces_for = |times: &[f64]| {
        contact.pressure_field(times, &radii, &mut vec![0.0; times.len() * radii.len()])?;
        Ok::<_, ContactError>(load.forces())
    };
    let (alone, after_another) = (forces_for(&[250.0])?, forces_for(&[2.5, 250.0])?);
    assert!(after_another < 2 * alone, "{after_another}, {alone}");
    Ok(())
}

/// Where a load has fallen as fast as it may the edge comes to rest, and hardly anything presses on what it reached last.
#[test]
fn radii_are_reached_before_the_edge_comes_to_rest() -> Result<(), Failure> {
    let mut errors = Errors::of(budget::FIELD);
    for folds in [1e-3, 0.0157, 0.1] {
        let duration: f64 = folds / CHI;
        let load = through(&[(0.0, 100.0), (duration, 100.0 / (1.0 + folds))]);
        let contact = joint(Patellofemoral, CHI, &load);
        let times = [0.0, 0.5 * duration, duration.next_down()];
        let now = contact.at(times[2])?;
        let radii: [f64; 9] = core::array::from_fn(|k| now.radius() * (1.0 - 0.1_f64.powi(k as i32 + 5)));
        let mut values = [f64::NAN; 27];
        contact.pressure_field(&times, &radii, &mut values)?;
        for (&r, &found) in radii.iter().zip(&values[18..]) {
            errors.add(found, now.pressure(r), edge(now.radius(), r), &(folds, r));
        }
    }
    errors.check();
    Ok(())
}
