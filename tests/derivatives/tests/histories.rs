//! Derivatives of pressures with respect to forces of a load, where the value of a slope or of a step is zero.

use cartcontact::load::{Constant, Load};
use cartcontact::{ContactError, GapProfile, Polynomial, Scalar};
use derivatives::{curvature, slope};
use num_dual::{Dual2_64, Dual32, Dual64};
use tests::budget;
use tests::joint::{joint, pressures_each_way};
use tests::loads::{Announced, Knots, Unannounced, through};
use tests::measure::relative_error;
use tests::profiles::{Blunt, Patellofemoral};

type Failure = Box<dyn core::error::Error>;

const CHI: f64 = 0.0015;

/// How far a derivative with respect to a force near 100 N may be from a difference over 0.1 N, as a share of P(0)/100:
/// the difference magnifies the rounding of pressures by some thousand; the worst is 1.4e-11.
const DIFFERENCES: f64 = 3e-11;
/// The same for second derivatives and differences over 0.02 N, as a share of P(0)/100²: here the factor is some
/// hundred million; the worst is 1.5e-7.
const SECOND_DIFFERENCES: f64 = 3e-7;
/// How far a derivative in single precision may be from that in double, as a share of P/100 + 1e-3: where nearly all
/// the pressure has faded, its derivative is a difference; the worst is 1.6e-6, which is 13 ε.
const SINGLE: f64 = 3e-6;

/// Knots, the indices of those with the derivative 1, and times.
struct History {
    knots: Vec<(f64, f64)>,
    varied: &'static [usize],
    times: &'static [f64],
    chi: f64,
}

impl History {
    fn new(knots: &[(f64, f64)], varied: &'static [usize], times: &'static [f64]) -> Self {
        Self { knots: knots.to_vec(), varied, times, chi: CHI }
    }

    /// The load with the force `more` added at the knots that vary.
    fn load<T: Scalar>(&self, more: T) -> Knots<T> {
        let knots = self.knots.iter().enumerate().map(|(index, &(time, force))| {
            let force = T::constant(force);
            (T::constant(time), if self.varied.contains(&index) { force + more } else { force })
        });
        through(&knots.collect::<Vec<_>>())
    }
}

/// Histories in which a force is equal to the one before it, or lower.
fn histories() -> Vec<(&'static str, History)> {
    let record: Vec<_> = (0..=40).map(|k| (f64::from(k) * 5.0, 100.0 + f64::from(k))).collect();
    let with_step = [&record[..=20], &record[20..]].concat();
    let at_bound = [(0.0, 100.0), (200.0, 100.0 / (1.0 + 200.0 * CHI))];
    let held = [(0.0, 100.0), (200.0, 100.0)];
    vec![
        ("a hold", History::new(&held, &[1], &[10.0, 150.0, 200.0, 300.0])),
        (
            "a hold behind a ramp",
            History::new(&[(0.0, 0.0), (20.0, 100.0), (200.0, 100.0)], &[2], &[150.0, 200.0, 600.0]),
        ),
        (
            "a hold that has faded",
            History {
                chi: 0.15,
                ..History::new(&[(0.0, 100.0), (2000.0, 100.0), (2100.0, 100.0)], &[1], &[1999.0, 2100.0])
            },
        ),
        (
            "a step of no height",
            History::new(
                &[(0.0, 50.0), (100.0, 100.0), (100.0, 100.0), (200.0, 150.0)],
                &[2, 3],
                &[100.0, 101.0, 150.0, 300.0],
            ),
        ),
        (
            "a step of no height within a hold",
            History::new(&[(0.0, 100.0), (100.0, 100.0), (100.0, 100.0)], &[2], &[100.0, 150.0]),
        ),
        ("such a step within a record", History::new(&with_step, &[21], &[102.0, 104.0, 200.0])),
        ("a fall as fast as it may be", History::new(&at_bound, &[1], &[100.0, 200.0, 300.0])),
        ("a hold without drainage", History { chi: 0.0, ..History::new(&held, &[1], &[100.0, 200.0]) }),
    ]
}

const RADII: [f64; 4] = [0.0, 3.0, 6.0, 7.3];

/// The pressures at a time, at all radii [each way](pressures_each_way).
fn pressures<T: Scalar>(
    profile: &impl GapProfile<T>,
    chi: f64,
    load: &dyn Load<T>,
    time: f64,
) -> Result<Vec<T>, ContactError> {
    pressures_each_way(&joint(profile, chi, load), time, &RADII.map(T::constant))
}

/// Compares derivatives with forward differences of fourth order: with lower forces some loads would fall too fast.
fn compare(
    name: &str,
    history: &History,
    dual: impl Fn(f64) -> Result<Vec<Dual64>, ContactError>,
    plain: impl Fn(f64, f64) -> Result<Vec<f64>, ContactError>,
) -> Result<(), Failure> {
    for &time in history.times {
        let h = 0.1;
        let at = |steps: f64| plain(steps * h, time);
        let (dual, values) = (dual(time)?, [at(0.0)?, at(1.0)?, at(2.0)?, at(3.0)?, at(4.0)?]);
        for (place, dual) in dual.into_iter().enumerate() {
            let expected = slope(values.each_ref().map(|values| values[place]), h);
            let scale = values[0][0] / 100.0;
            let is_near = (dual.eps - expected).abs() <= DIFFERENCES * scale;
            assert!(is_near, "{name}, {time} s, {place}: {dual} instead of {expected}");
        }
    }
    Ok(())
}

fn check<P: GapProfile<Dual64> + GapProfile<f64>>(profile: &P) -> Result<(), Failure> {
    for (name, history) in histories() {
        let load = history.load(Dual64::from(0.0).derivative());
        let dual = |time| pressures(profile, history.chi, &load, time);
        compare(name, &history, dual, |more, time| {
            pressures(profile, history.chi, &history.load(more), time)
        })?;
    }
    Ok(())
}

#[test]
fn slopes_are_right_where_a_load_is_held_or_falls_as_fast_as_it_may() -> Result<(), Failure> {
    check(&Patellofemoral)?;
    check(&Blunt)
}

#[test]
fn slopes_under_loads_of_a_users_own_are_those_under_knots() -> Result<(), Failure> {
    for (name, history) in histories() {
        for is_linear in [true, false] {
            let dual = |time| {
                let load = history.load(Dual64::from(0.0).derivative());
                pressures(&Patellofemoral, history.chi, &Announced { load, is_linear }, time)
            };
            let plain = |more, time| {
                let load: Knots = history.load(more);
                pressures(&Patellofemoral, history.chi, &load, time)
            };
            compare(name, &history, dual, plain)?;
        }
    }
    Ok(())
}

/// P = (m C/16) (a² − r²)² of a paraboloid from which nothing drains, with a⁶ proportional to F.
#[test]
fn slopes_without_drainage_are_those_of_the_closed_form() -> Result<(), Failure> {
    let gap = Polynomial::new([(Dual64::from(0.025), Dual64::from(2.0))])?;
    let history = History::new(&[(0.0, 100.0), (200.0, 100.0)], &[1], &[]);
    let load = history.load(Dual64::from(0.0).derivative());
    let contact = joint(&gap, 0.0, &load as &dyn Load<_>);
    let a = contact.at(Dual64::from(200.0))?.radius().re;
    for found in pressures(&gap, 0.0, &load, 200.0)?.chunks(RADII.len()) {
        for (found, r) in found.iter().zip(RADII) {
            let slope = |r: f64| 0.375 * 0.025 / 4.0 * (a * a - r * r) * a * a / 600.0;
            let expected = slope(r);
            // The rounding of a⁴ counts with the slope on the axis; the worst is 2 ε.
            let allowed = budget::PRESSURE.double * f64::EPSILON * slope(0.0);
            assert!((found.eps - expected).abs() <= allowed, "{r}: {found} instead of {expected}");
        }
    }
    Ok(())
}

/// A step of no height acts at once, but with a derivative it does not act at a single radius.
#[test]
fn second_derivatives_with_respect_to_a_step_are_those_of_differences() -> Result<(), Failure> {
    let (_, history) = histories().swap_remove(3);
    for &time in &history.times[1..] {
        let h = 0.02;
        let at = |steps: f64| pressures(&Patellofemoral, CHI, &history.load(steps * h), time);
        let values = [at(0.0)?, at(1.0)?, at(2.0)?, at(3.0)?, at(4.0)?, at(5.0)?];
        let load = history.load(Dual2_64::from(0.0).derivative());
        for (place, dual) in pressures(&Patellofemoral, CHI, &load, time)?.into_iter().enumerate() {
            let expected = curvature(values.each_ref().map(|values| values[place]), h);
            let scale = values[0][0] / 1e4;
            assert!(
                (dual.v2 - expected).abs() <= SECOND_DIFFERENCES * scale,
                "{time}, {place}: {dual}, {expected}"
            );
        }
    }
    Ok(())
}

#[test]
fn slopes_in_single_precision_are_those_in_double() -> Result<(), Failure> {
    for (name, history) in histories() {
        for &time in history.times {
            let load = history.load(Dual64::from(0.0).derivative());
            let double = pressures(&Patellofemoral, history.chi, &load, time)?;
            let load = history.load(Dual32::from(0.0).derivative());
            let single = pressures(&Patellofemoral, history.chi, &load, time)?;
            for (single, expected) in single.into_iter().zip(double) {
                let error = (f64::from(single.eps) - expected.eps).abs() / (expected.re / 100.0 + 1e-3);
                assert!(error <= SINGLE, "{name}, {time} s: {single} instead of {expected}");
            }
        }
    }
    Ok(())
}

/// At a radius where the edge once was, a pressure has the derivatives that it has next to it.
#[test]
fn slopes_are_continuous_where_the_edge_was() -> Result<(), Failure> {
    // So much drains from row to row that each is marched to.
    let contact = joint(Blunt, 0.02, Constant(Dual64::from(100.0).derivative()));
    for first in [0.0, 10.0].map(Dual64::from) {
        let (edge, last) = (contact.at(first)?.radius().re, Dual64::from(20.0));
        let radii = [edge, edge.next_up()].map(Dual64::from);
        let mut rows = [Dual64::from(f64::NAN); 4];
        contact.pressure_field(&[first, last], &radii, &mut rows)?;
        let now = contact.at(last)?;
        let [.., there, beside] = rows;
        for (there, beside) in [(there, beside), (now.pressure(radii[0]), now.pressure(radii[1]))] {
            let error = relative_error(there.eps, beside.eps, f64::EPSILON);
            // Where the edge was is near the edge, which magnifies the rounding of radii; the worst is 22 ε.
            assert!(error <= 90.0, "{there} and {beside} differ by {error:.2} ε from {first} on");
        }
    }
    Ok(())
}

/// Steps that follow a load do not move with the time asked for, so that none moves across a kink.
#[test]
fn slopes_in_time_do_not_depend_on_which_kinks_are_told() -> Result<(), ContactError> {
    let knots = [(0.0, 50.0), (137.0, 50.0), (141.0, 90.0), (150.0, 95.0)];
    for t in [170.0, 300.0, 1000.0] {
        let knots = knots.map(|(t, force)| (Dual2_64::from(t), Dual2_64::from(force)));
        let load = through(&knots);
        let told = joint(Patellofemoral, CHI, &load);
        let untold = joint(Patellofemoral, CHI, Unannounced(&load));
        let time = Dual2_64::from(t).derivative();
        let (told, untold) = (told.at(time)?, untold.at(time)?);
        for r in [0.0, 3.0, 6.0].map(Dual2_64::from) {
            let (expected, found) = (told.pressure(r), untold.pressure(r));
            // As shares of what a pressure loses by drainage; the worst are 3e-15 and 9e-10.
            for (allowed, order, found, expected) in
                [(1e-13, 1, found.v1, expected.v1), (1e-8, 2, found.v2, expected.v2)]
            {
                let error = (found - expected).abs() / (CHI.powi(order) * told.pressure(r).re);
                assert!(error <= allowed, "{error:e} at {t} and {r}: {found:e} instead of {expected:e}");
            }
        }
    }
    Ok(())
}
