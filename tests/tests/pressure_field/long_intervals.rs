//! Pressures long after the row before, and after histories so long that an e-folding is only a few roundings of the
//! time.

use cartcontact::load::{Constant, Load};
use cartcontact::{ContactError, GapProfile, Polynomial};
use tests::budget;
use tests::loads::{Announced, Swing};
use tests::measure::Errors;
use tests::profiles::Paraboloid;

use super::{Value, joint, values};

#[test]
fn rows_after_long_intervals_are_those_of_single_times() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    let gap = Polynomial::new([(0.025, 2.0), (1.09375e-4, 4.0)])?;
    let radii = [0.0, 3.0, 7.0, 11.0, 20.0];
    for (chi, frequency, amplitude) in [(1.0, 1.0, 10.0), (0.0015, 0.01, 5.0)] {
        let swing = Swing { mean: 100.0, amplitude, frequency };
        let contact = joint(&gap as &dyn GapProfile<f64>, chi, &swing);
        for folds in [
            &[0.0, 30.0, 60.0][..],
            &[0.0, 1.0, 1.1, 90.0, 90.1, 1e3, 1e4],
            &[0.5, 1e6, 1e6 + 1.0, 1e6 + 41.0, 1e7],
        ] {
            let times: Vec<f64> = folds.iter().map(|folds| folds / chi).collect();
            for Value { t, r, found, expected, edge, .. } in values(&contact, &times, &radii, 1)? {
                errors.add(found, expected, edge, &(chi, t, r));
            }
        }
    }
    errors.check();
    Ok(())
}

/// For a paraboloid δ₀ and the pressure grow with a², and a⁶ ~ Y ~ χ t: P(0) = 2F/(π a²) (1 + 1/(3 χ t)).
#[test]
fn a_long_history_carries_the_force_in_single_precision() -> Result<(), ContactError> {
    for (chi, frequency, amplitude) in [(0.0015, 0.01, 5.0), (1.0, 5.0, 1.0), (1.0, 1.0, 10.0)] {
        let swing = Swing { mean: 100.0, amplitude, frequency };
        let contact = joint::<f32, _>(Paraboloid, chi, &swing);
        for sixteenth in 40..100 {
            let folds = 10_f32.powf(sixteenth as f32 / 16.0);
            let now = contact.at(folds / chi as f32)?;
            let [force, radius, peak] = [now.force(), now.radius(), now.peak_pressure()].map(f64::from);
            let (folds, epsilon) = (f64::from(folds), f64::from(f32::EPSILON));
            let excess = peak * core::f64::consts::PI * radius * radius / (2.0 * force) - 1.0;
            // The radius is rounded too.
            let allowed = 0.05 / folds + (budget::PEAK_PRESSURE.single + 2.0) * epsilon;
            let error = (excess - 1.0 / (3.0 * folds)).abs();
            assert!(error < allowed, "{chi}, {frequency}, {folds}: {error:e} of {allowed:e}");
        }
    }
    Ok(())
}

/// Where tens of e-foldings are a few roundings of the time, those that count must not be rounded away.
#[test]
fn a_held_load_is_carried_however_long() {
    fn check(load: &dyn Load<f64>) {
        let contact = joint(Paraboloid, 1.0, load);
        for step in 0..4000 {
            let time = 10f64.powf(15.0 + f64::from(step) / 800.0);
            let Ok(now) = contact.at(time) else { unreachable!("{time:e}") };
            let mean = now.force() / (core::f64::consts::PI * now.radius() * now.radius());
            let error = (now.peak_pressure() / (2.0 * mean) - 1.0).abs() / f64::EPSILON;
            // The radius is rounded too.
            assert!(error <= budget::PEAK_PRESSURE.double + 2.0, "{time:e}: {error} ε");
        }
    }
    check(&Constant(100.0));
    check(&Announced::curved(Constant(100.0)));
}
