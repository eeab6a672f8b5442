//! Records and fields of many thousands of steps, in single precision: their roundings must not add up.

use cartcontact::load::{Constant, PiecewiseLinear};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::measure::{Errors, ulps};
use tests::profiles::Patellofemoral;

/// One sample per millisecond, for ten seconds.
const SAMPLES: u16 = 10_000;

const CHI: f64 = 1e-4;

fn times(count: u32) -> Vec<f32> {
    (0..=count).map(|k| (f64::from(k) / 1000.0) as f32).collect()
}

#[test]
fn a_record_of_a_held_load_is_a_held_load() -> Result<(), Box<dyn core::error::Error>> {
    let record: Vec<(f32, f32)> = times(SAMPLES.into()).into_iter().map(|t| (t, 100.0)).collect();
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
