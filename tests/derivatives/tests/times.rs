//! Derivatives of pressures with respect to time, and of fields whose times have derivatives.

use core::f64::consts::PI;

use cartcontact::Snapshot;
use cartcontact::load::{Constant, Load};
use derivatives::{SLOPE, assert_close};
use num_dual::Dual2_64;
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::{Announced, Knots, through};
use tests::profiles::Blunt;

type Failure = Box<dyn core::error::Error>;

const CHI: f64 = 0.0015;

/// In ε of the terms that cancel: so many for a second one; the worst here is 6.3 ε off.
const CURVATURE: f64 = 2.0 * SLOPE;

/// x with the derivative 1.
fn variable(x: f64) -> Dual2_64 {
    Dual2_64::from(x).derivative()
}

/// A rise, a slower one, a hold, a step and a fall.
fn record() -> Knots<Dual2_64> {
    let knots = [(0.0, 50.0), (10.0, 100.0), (30.0, 140.0), (50.0, 140.0), (50.0, 160.0), (90.0, 156.0)];
    through(&knots.map(|(t, force)| (Dual2_64::from(t), Dual2_64::from(force))))
}

/// P_t + χ P = (m/4) δ₀′(t) (a² − r²) with m = 0.375 and χ = 0.0015, and its derivative with respect to time, for a
/// snapshot at a time with the derivative 1.
fn assert_pressure_follows_edge<L: Load<Dual2_64>>(now: &Snapshot<'_, Dual2_64, Blunt, L>) {
    let (a, approach, r) = (now.radius(), now.approach(), 2.0);
    let (squares, change_of_squares) = (a.re * a.re - r * r, 2.0 * a.re * a.v1);
    let pressure = now.pressure(Dual2_64::from(r));
    let slope = 0.375 / 4.0 * approach.v1 * squares - CHI * pressure.re;
    assert_close(pressure.v1, slope, SLOPE);
    let terms =
        [0.375 / 4.0 * approach.v2 * squares, 0.375 / 4.0 * approach.v1 * change_of_squares, -CHI * slope];
    // They cancel.
    let size = terms.map(f64::abs).iter().sum::<f64>();
    let error = (pressure.v2 - terms.iter().sum::<f64>()).abs() / size / f64::EPSILON;
    assert!(error <= CURVATURE, "{pressure}: {error:.2} of {CURVATURE} ε");
}

/// The derivatives of a snapshot with respect to time satisfy the equations of the model.
#[test]
fn slope_of_the_approach_in_time_obeys_the_equation_of_the_edge() -> Result<(), Failure> {
    let contact = joint(Blunt, CHI, Constant(Dual2_64::from(100.0)));
    let now = contact.at(variable(200.0))?;
    let a = now.radius();
    // F′ + χ F = (π m/8) a⁴ δ₀′(t).
    let fluid = PI * 0.375 / 8.0 * a.re.powi(4) * now.approach().v1;
    assert_close(fluid, CHI * 100.0, SLOPE);
    assert_pressure_follows_edge(&now);
    Ok(())
}

/// At the start nothing has drained, but P_t + χ P = (m/4) δ₀′(t) (a² − r²) all the same.
#[test]
fn a_pressure_begins_to_change_at_once() -> Result<(), Failure> {
    let contact = joint(Blunt, CHI, Constant(Dual2_64::from(100.0)));
    let now = contact.at(variable(0.0))?;
    assert_pressure_follows_edge(&now);
    Ok(())
}

/// The rows of a field have the derivatives of single pressures, also at the start and where a time without a
/// derivative comes before the same with one.
#[test]
fn rows_have_the_slopes_of_single_pressures() -> Result<(), Failure> {
    let plain = Dual2_64::from;
    let (held, record) = (Constant(Dual2_64::from(100.0)), record());
    let rise = through(&[(plain(0.0), plain(0.0)), (plain(10.0), plain(100.0))]);
    let radii = [0.0, 2.0, 4.0].map(plain);
    for (load, times) in [
        (&held as &dyn Load<Dual2_64>, &[variable(0.0)][..]),
        (&held, &[plain(0.0), variable(0.0), variable(0.0), plain(7.0)]),
        (&held, &[plain(200.0), variable(200.0)]),
        (&held, &[plain(0.0), plain(100.0), variable(100.0), variable(200.0), plain(200.0), variable(300.0)]),
        (&held, &[plain(9.0), variable(9.0), variable(90_000.0), plain(90_000.0), variable(90_001.0)]),
        (&rise, &[variable(0.0), plain(7.0), variable(10.0), variable(40.0)]),
        (&record, &[variable(10.0), variable(50.0), plain(50.0), variable(70.0), variable(120.0)]),
    ] {
        let contact = joint(Blunt, CHI, load);
        let mut values = vec![plain(f64::NAN); times.len() * radii.len()];
        contact.pressure_field(times, &radii, &mut values)?;
        for (&t, row) in times.iter().zip(values.chunks(radii.len())) {
            let now = contact.at(t)?;
            for (&r, &found) in radii.iter().zip(row) {
                let expected = now.pressure(r);
                let allowed = 2.0 * budget::PRESSURE.double * edge(now.radius().re, r.re);
                assert_close(found.re, expected.re, allowed);
                // Where only an earlier row has derivatives, those of the size of χ P cancel. The polynomials of short
                // rows multiply what second ones round, and so do long histories; the worst is 0.4 of this.
                for (order, factor, found, expected) in
                    [(1, 4.0, found.v1, expected.v1), (2, 32.0, found.v2, expected.v2)]
                {
                    let size = expected.abs().max(CHI.powi(order) * now.pressure(r).re);
                    let error = (found - expected).abs();
                    let largest = factor * allowed * f64::EPSILON * size;
                    assert!(error <= largest, "{found} instead of {expected} at {t}: {error:e}");
                }
            }
        }
    }
    Ok(())
}

/// At a knot edge and pressures move with the slope of the load after the knot: F′ + χ F = (π m/8) a⁴ δ₀′(t).
#[test]
fn at_a_knot_edge_and_pressures_move_as_behind_it() -> Result<(), Failure> {
    let load = record();
    for is_linear in [true, false] {
        let contact = joint(Blunt, CHI, Announced { load: &load, is_linear });
        for (time, force, slope) in [
            (0.0, 50.0, 5.0),
            (10.0, 100.0, 2.0),
            (30.0, 140.0, 0.0),
            (50.0, 160.0, -0.1),
            (90.0, 156.0, 0.0),
        ] {
            let now = contact.at(variable(time))?;
            let fluid = PI * 0.375 / 8.0 * now.radius().re.powi(4) * now.approach().v1;
            assert_close(fluid, slope + CHI * force, SLOPE);
            assert_pressure_follows_edge(&now);
        }
    }
    Ok(())
}
