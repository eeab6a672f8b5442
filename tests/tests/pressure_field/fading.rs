//! Fields under loads that fall about as fast as what they press out drains: the pressures that are left hide no
//! rounding of those that were.

use cartcontact::load::{Load, PiecewiseLinear};
use cartcontact::{Contact, Medium, Scalar};
use tests::budget;
use tests::loads::{Announced, Fall};
use tests::measure::ulps;
use tests::profiles::Paraboloid;
use tests::random::Stream;
use tests::stress::precision::Precision;

use super::{Value, joint, values};

type Failure = Box<dyn core::error::Error>;

/// Compares every 16th row, and the last, with what the time has alone.
fn compare<T: Precision>(chi: f64, load: &dyn Load<T>, times: &[T]) -> Result<(), Failure> {
    let contact = joint(Paraboloid, chi, load);
    let radii = [T::zero(), contact.at(T::zero())?.radius() * T::constant(0.5)];
    for Value { row, r, found, expected, edge, .. } in values(&contact, times, &radii, 16)? {
        let error = ulps(found.value(), expected.value().into(), T::EPSILON);
        assert!(error <= T::allowed(budget::FIELD) * edge, "row {row}, r = {r}: {error} ulp");
    }
    Ok(())
}

fn equal_times<T: Scalar>(count: u32, step: f64) -> Vec<T> {
    (0..=count).map(|k| T::constant(f64::from(k) * step)).collect()
}

/// A record of equal steps, each of which leaves a share of the force.
fn steps<T: Scalar>(times: &[T], share: f64) -> Result<PiecewiseLinear<T, Vec<(T, T)>>, Failure> {
    let forces = (0..).map(|k| T::constant(100.0 * share.powi(k)));
    Ok(PiecewiseLinear::new(times.iter().copied().zip(forces).collect())?)
}

#[test]
fn rows_after_a_long_fall_are_those_of_single_times() -> Result<(), Failure> {
    let times = equal_times::<f64>(200, 0.5);
    for share in [1.0 / 1.25, 1.0 / 1.4, 0.95] {
        compare(1.0, &steps(&times, share)?, &times)?;
    }
    let times = equal_times::<f32>(100, 0.3);
    compare(1.0, &steps(&times, 1.0 / 1.24)?, &times)
}

#[test]
fn rows_fade_with_a_load_at_the_bound() -> Result<(), Failure> {
    // Forces are rounded, and so is the share that pressures fade by: both add up to less than the bound per e-folding.
    for rate in [0.5, 0.9, 1.0] {
        compare(1.0, &Fall { force: 100.0, rate }, &equal_times(250, 0.3))?;
    }
    Ok(())
}

/// A record that is clamped to the steepest falls, as the documentation of `PiecewiseLinear` shows.
fn clamped<T: Scalar>(times: &[T], chi: T, mut wanted: impl FnMut() -> T) -> Vec<(T, T)> {
    let mut record = vec![(T::zero(), T::constant(80.0))];
    for pair in times.windows(2) {
        let (_, force) = record[record.len() - 1];
        record.push((pair[1], wanted().max(force / (T::one() + chi * (pair[1] - pair[0])))));
    }
    record
}

/// A record that falls as fast as it may, as the format has it.
fn at_the_bound<T: Scalar>(times: &[T], chi: T) -> Vec<(T, T)> {
    clamped(times, chi, T::zero)
}

#[test]
fn rows_at_the_knots_of_a_record_at_the_bound_do_not_drift() -> Result<(), Failure> {
    let times = equal_times::<f64>(3000, 0.01);
    let load = PiecewiseLinear::new(at_the_bound(&times, 1.5e-3))?;
    compare(1.5e-3, &load, &times)?;
    compare(1.5e-3, &load, &equal_times(9000, 0.01 / 3.0))
}

#[test]
fn rates_may_be_smaller_than_any_number() -> Result<(), Failure> {
    let (force, second) = (1e-56, 1e300);
    let load = PiecewiseLinear::new([(0.0, 10.0 * force), (4.0 * second, 20.0 * force)])?;
    let medium = Medium::from_constants(0.375 * force, 0.0)?;
    let contact = Contact::new(Paraboloid, medium, &load as &dyn Load<f64>)?;
    let mut field = [0.0; 4];
    contact.pressure_field(&[0.0, 1.0, 2.0, 3.0].map(|k| k * second), &[0.0], &mut field)?;
    let error = ulps(field[3], contact.at(3.0 * second)?.peak_pressure().into(), f64::EPSILON);
    assert!(error <= budget::FIELD.double * 3.0, "{error} ulp");
    Ok(())
}

#[test]
fn rows_may_be_closer_than_anything_drains() -> Result<(), Failure> {
    for rate in [0.5e-3, 0.9e-3, 1e-3_f32] {
        compare(1e-3, &Fall { force: 100.0, rate }, &equal_times(4000, 1e-3))?;
    }
    compare(1e-3, &Fall { force: 100.0, rate: 1e-3 }, &equal_times(3000, 1e-7))
}

fn noise(stream: &mut Stream) -> f32 {
    stream.between(80.0, 81.0) as f32
}

#[test]
fn a_clamped_record_may_have_more_rows_than_knots() -> Result<(), Failure> {
    let mut stream = Stream::of_case(7, 0);
    let record = clamped(&equal_times(999, 0.01), 1.5e-3, || noise(&mut stream));
    compare(1.5e-3, &PiecewiseLinear::new(record)?, &equal_times(10_000, 1e-3))
}

#[test]
fn a_clamped_record_is_none_too_fast_behind_a_load_of_a_users_own() -> Result<(), Failure> {
    let mut stream = Stream::of_case(7, 1);
    for (step, chi) in [(1e-3, 1e-2), (1e-3, 1.5e-3), (0.01, 1.5e-3)] {
        for count in [30; 40].into_iter().chain([2000]) {
            let times = equal_times(count - 1, step);
            let record = PiecewiseLinear::new(clamped(&times, chi, || noise(&mut stream)))?;
            let end = times[times.len() - 1];
            assert_eq!(record.recession(chi, end), None, "{step}, {chi}, {count}");
            assert_eq!(Announced::curved(&record).recession(chi, end), None, "{step}, {chi}, {count}");
        }
    }
    // The bound is rounded the same way at all of its knots: in truth it falls too fast.
    let record = PiecewiseLinear::new(at_the_bound(&equal_times(10_000, 1e-3), 1.5e-3_f32))?;
    assert_eq!(Announced::curved(&record).recession(1.5e-3, 10.0), None);
    Ok(())
}
