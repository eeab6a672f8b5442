//! Records and fields of many thousands of steps: their roundings must not add up, and many times at once make no
//! difference.

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::through;
use tests::measure::{Errors, ulps};
use tests::profiles::Patellofemoral;

/// One sample per millisecond, for ten seconds.
const SAMPLES: u16 = 10_000;

const CHI: f64 = 1e-4;

fn times(count: u32) -> Vec<f32> {
    (0..=count).map(|k| (f64::from(k) / 1000.0) as f32).collect()
}

/// With a last bit that differs from sample to sample, so that each is followed: a held force would be one piece.
#[test]
fn a_record_of_a_held_load_is_a_held_load() -> Result<(), Box<dyn core::error::Error>> {
    let forces = [100.0_f32, 100.0_f32.next_up()].into_iter().cycle();
    let record: Vec<(f32, f32)> = times(SAMPLES.into()).into_iter().zip(forces).collect();
    let one = joint(Patellofemoral, CHI, Constant(100.0));
    let many = joint(Patellofemoral, CHI, PiecewiseLinear::new(record)?);
    let (mut radius, mut pressure) =
        (Errors::of_single(budget::CONTACT_RADIUS), Errors::of_single(budget::PRESSURE));
    for t in [0.0, 0.0375, 1.0, 3.333, 10.0, 100.0] {
        let (one, many) = (one.at(t)?, many.at(t)?);
        // Either may be off by the allowance.
        radius.add(many.radius().into(), f64::from(one.radius()), 2.0, &t);
        for share in [0.0, 0.3, 0.9, 0.999] {
            let r = one.radius() * share;
            let condition = 2.0 * edge(one.radius(), r);
            pressure.add(many.pressure(r).into(), f64::from(one.pressure(r)), condition, &(t, share));
        }
    }
    radius.check();
    pressure.check();
    Ok(())
}

#[test]
fn the_last_row_of_a_long_field_is_what_it_is_alone() -> Result<(), Box<dyn core::error::Error>> {
    let times = times(10 * u32::from(SAMPLES));
    let radii = [0.0, 3.0, 6.0];
    let mut field = vec![0.0; times.len() * radii.len()];
    let contact = joint(Patellofemoral, CHI, Constant(100.0));
    contact.pressure_field(&times, &radii, &mut field)?;
    let now = contact.at(*times.last().ok_or("no times")?)?;
    let row = field.rchunks(radii.len()).next().ok_or("no rows")?;
    for (&found, r) in row.iter().zip(radii) {
        let error = ulps(found.into(), f64::from(now.pressure(r)).into(), f32::EPSILON.into());
        assert!(error <= budget::FIELD.single * edge(now.radius(), r), "r = {r}: {error} ulp");
    }
    Ok(())
}

/// The sums go on from one time to the next, but round as sums of their own.
#[test]
fn impulses_at_many_times_are_those_one_by_one() {
    for count in [1, 2, 64, 65, 1000, 5000] {
        let knots: Vec<(f64, f64)> =
            (0..count).map(|k| (0.1 * f64::from(k), 3.0 + (f64::from(k) * 0.7).sin())).collect();
        let load = through(&knots);
        let ascending: Vec<f64> = (0..3 * count).map(|k| 0.037 * f64::from(k)).collect();
        let mut times: Vec<f64> = ascending.iter().map(|t| t * 7.0 % (0.11 * f64::from(count))).collect();
        times.extend(&ascending);
        times.extend(ascending.iter().rev());
        times.extend([-1.0, f64::NAN, f64::INFINITY, 0.0, 1e300]);
        let mut impulses = vec![f64::NAN; times.len()];
        assert!(load.fill_impulses(&times, &mut impulses));
        for (&t, &found) in times.iter().zip(&impulses) {
            assert_eq!(found.to_bits(), load.impulse(t).to_bits(), "{count} knots, {t}");
        }
    }
    assert!(!Constant(100.0).fill_impulses(&[1.0], &mut [0.0]));
}
