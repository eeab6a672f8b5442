//! Rows between which so little drains that all of them round the same way.

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{ContactError, Scalar};
use tests::loads::Announced;
use tests::measure::ulps;
use tests::profiles::Patellofemoral;

use super::{Value, joint, values};

type Failure = Box<dyn core::error::Error>;

/// How far a row may be from what its time has alone, in ulp times 1 + 2a/(a − r): a fifth of what both may be off
/// by. The worst is 2.7.
const ALLOWED: f64 = 3.0;

/// How many decades of spans are looked at, from the shortest within which pressures change by some roundings.
const DECADES: i32 = 6;

/// Compares every 37th of equal rows, and the last, with what the time has alone.
fn compare<T: Scalar>(load: &dyn Load<T>, span: f64, rows: u32) -> Result<(), ContactError> {
    let times: Vec<T> = (0..rows).map(|k| T::constant(span * f64::from(k) / f64::from(rows))).collect();
    let contact = joint(Patellofemoral, 0.5, load);
    let last = contact.at(times[times.len() - 1])?.radius();
    let radii = [0.0, 0.3, 0.6, 0.9].map(|share| last * T::constant(share));
    assert_near(&values(&contact, &times, &radii, 37)?, span);
    Ok(())
}

/// Asserts that values of a field are no farther from what their times have alone than [`ALLOWED`].
fn assert_near<T: Scalar>(values: &[Value<T>], place: f64) {
    for &Value { row, r, found, expected, edge, .. } in values {
        let error = ulps(found.value(), expected.value().into(), T::default_epsilon().value());
        assert!(error <= ALLOWED * edge, "{place:e}, row {row}, r = {r}: {error} ulp of {edge}");
    }
}

/// Spans from the shortest within which pressures in a format change by some roundings.
fn spans<T: Scalar>() -> impl Iterator<Item = f64> {
    (0..8 * DECADES).map(|eighth| T::default_epsilon().value() * 10f64.powf(f64::from(eighth) / 8.0 + 1.0))
}

fn check<T: Scalar>() -> Result<(), Failure> {
    for span in spans::<T>() {
        let force = T::constant(50.0);
        compare(&Constant(force), span, 4097)?;
        let rise = PiecewiseLinear::new([(T::zero(), T::zero()), (T::constant(0.01 * span), force)])?;
        compare(&rise, span, 64)?;
        compare(&Announced::curved(rise), span, 64)?;
    }
    Ok(())
}

#[test]
fn roundings_do_not_add_up_where_hardly_anything_drains() -> Result<(), Failure> {
    check::<f64>()?;
    check::<f32>()
}

/// The reciprocal of such an interval is out of range.
#[test]
fn rows_may_be_closer_than_any_normal_number() -> Result<(), ContactError> {
    compare(&Constant(50.0), 2e-309, 20)
}

#[test]
fn roundings_do_not_add_up_over_a_quarter_of_a_million_rows() -> Result<(), ContactError> {
    for span in [1e-12, 1e-11, 1e-10, 2.5e-10, 1e-9] {
        compare(&Constant(50.0), span, 270_000)?;
    }
    Ok(())
}

/// The load rises from one of its forces to three times that between two rows, and is then nearly held.
fn check_behind_a_rise<T: Scalar>() -> Result<(), Failure> {
    for span in [1e-5, 1e-4, 1e-3, 1e-2] {
        let knots = [(0.0, 10.0), (0.08, 10.0), (0.09, 30.0), (1.0, 30.0002)];
        let knots = knots.map(|(share, force)| (T::constant(share * span), T::constant(force)));
        for rows in [90, 200, 1500] {
            compare(&Announced::curved(PiecewiseLinear::new(knots)?), span, rows)?;
        }
    }
    Ok(())
}

#[test]
fn roundings_do_not_add_up_behind_a_steep_rise() -> Result<(), Failure> {
    check_behind_a_rise::<f64>()?;
    check_behind_a_rise::<f32>()
}

/// Between two neighbouring times there is no third that a step could be divided at.
#[test]
fn a_jump_is_passed_once_where_the_next_row_follows_at_once() -> Result<(), Failure> {
    for k in 1..=100 {
        let knot = 0.037 * f64::from(k);
        let load = PiecewiseLinear::new([(0.0, 10.0), (knot, 10.0), (knot, 30.0)])?;
        let curved = Announced::curved(load);
        let contact = joint(Patellofemoral, 0.5, &curved);
        let a = contact.at(knot)?.radius();
        let radii = [1e-1, 1e-3, 1e-5].map(|depth| a * (1.0 - depth));
        for times in [[knot, knot.next_up()], [knot.next_down(), knot]] {
            assert_near(&values(&contact, &times, &radii, 1)?, knot);
        }
    }
    Ok(())
}
