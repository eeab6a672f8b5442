//! The pressure carries the load: 2π ∫₀ᵃ P r dr = F, at every time, for every geometry and every load.

use core::f64::consts::{FRAC_PI_4, TAU};

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{ContactError, GapProfile, Polynomial, Snapshot};
use tests::budget;
use tests::joint::joint;
use tests::loads::{Fall, Rise, Swing, histories, through};
use tests::measure::Errors;
use tests::planted;
use tests::profiles::{Case, cases};
use tests::quadrature::Graded;

const CHI: f64 = 0.02;
/// In units of 1/χ.
const TIMES: [f64; 7] = [0.0, 1e-3, 0.1, 0.7, 2.5, 30.0, 1000.0];
/// Within the range of every geometry.
const LAST_RADIUS: f64 = 5.0;

#[test]
fn pressure_carries_a_constant_load() {
    check_load("constant", &Constant(70.0), &TIMES);
}

#[test]
fn pressure_carries_piecewise_linear_loads() {
    for (name, load) in histories(CHI) {
        check_load(name, &load, &TIMES);
    }
}

#[test]
fn pressure_carries_a_slow_load_of_a_users_own() {
    check_load("slow rise", &Rise { start: 0.0, rise: 90.0, rate: 0.01 }, &TIMES);
}

#[test]
fn pressure_carries_a_quick_load_of_a_users_own() {
    check_load("quick rise", &Rise { start: 10.0, rise: 90.0, rate: 0.1 }, &TIMES);
}

#[test]
fn pressure_carries_a_swinging_load_of_a_users_own() {
    // F′ ≥ −30 · 0.03, while χ F ≥ 0.02 · 70.
    let load = Swing { mean: 100.0, amplitude: 30.0, frequency: 0.03 };
    check_load("swing", &load, &[0.0, 0.1, 0.7, 2.5]);
    errors_on(cases().into_iter().step_by(6), "long swing", &load, &[30.0, 1000.0]).check();
}

/// F′ + χ F, divided by χ times the mean, is 1 + (A/mean) √(1 + (ω/χ)²) sin(ω t + φ): the edge nearly stands still
/// where this is least, and after a long history the rounding of the forces within a step exceeds the load that the
/// step adds.
#[test]
fn pressure_carries_loads_that_swing_as_much_as_they_may() {
    let mut errors = Errors::of(budget::BALANCE_OF_OTHER_LOADS);
    let rule = Graded::new(16, 5);
    for (ratio, excess) in [(0.5, 1e-4), (1.0, 1e-9), (2.0, 1e-4)] {
        let amplitude = 100.0 / f64::hypot(1.0, ratio) * (1.0 - excess);
        let load = Swing { mean: 100.0, amplitude, frequency: ratio * CHI };
        for case in cases().into_iter().step_by(4) {
            for time in [2.5, 30.0, 299.5, 1003.0] {
                let t = time / CHI;
                let times = load.slowest_growths(CHI, t - 42.0 / CHI..t);
                let carried = carried(case, &load, t, times, &rule);
                errors.add(carried, load.force(t), 1.0, &(ratio, case, time));
            }
        }
    }
    errors.check();
}

#[test]
fn pressure_carries_a_falling_load_of_a_users_own() {
    check_load("slow fall", &Rise { start: 100.0, rise: -90.0, rate: 0.01 }, &TIMES);
    let fall = Rise { start: 100.0, rise: -100.0, rate: 0.99 * CHI };
    errors_under("nearly the fastest fall", &fall, &TIMES[..5]).check_worst();
}

/// The load once was many times what it is now: the rounding of the hereditary load may exceed the load.
#[test]
fn pressure_carries_loads_that_have_fallen_for_long() {
    let errors = |share: f64| {
        let load = Fall { force: 100.0, rate: share * CHI };
        errors_under("exponential", &load, &[0.7, 2.5, 10.0, 30.0, 41.0])
    };
    [1.0, 0.999, 0.9, 0.5].into_iter().for_each(|share| errors(share).check());
    // The fall is as steep as possible at every knot: F₁ = F₀/(1 + χ Δt).
    let falls: Vec<(f64, f64)> = (0..=14).map(|k| (3.0 * f64::from(k) / CHI, 4f64.powi(10 - k))).collect();
    check_load("straight", &through(&falls), &[2.0, 3.0, 7.5, 9.0, 30.0, 41.0, 42.0]);
}

/// After a long history the rounding of the hereditary load, and so of radii, is a noticeable share of what a step
/// adds.
#[test]
fn pressure_carries_a_step_after_a_long_history() -> Result<(), Box<dyn core::error::Error>> {
    let mut errors = Errors::of(budget::BALANCE);
    let rule = Graded::new(16, 30);
    for held in [1e6, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15] {
        for duration in [0.0, 4e-16, 1e-12, 1e-9] {
            let end = held * (1.0 + duration);
            let load = PiecewiseLinear::new([(0.0, 30.0), (held, 30.0), (end, 100.0)])?;
            let contact = joint(Polynomial::new([(0.025, 2.0), (1e-4, 4.0)])?, 1.0, load);
            let now = contact.at(end)?;
            let start = contact.at(0.0)?.radius();
            let carried = force_between(&now, &[0.0, start, now.radius()], &rule);
            errors.add(carried, now.force(), 1.0, &(held, duration));
        }
    }
    errors.check_worst();
    Ok(())
}

/// A gap with a power near 0 is nearly constant: its values at two radii may differ by less than their rounding.
#[test]
fn pressure_of_powers_near_the_zeroth_carries_the_load() -> Result<(), Box<dyn core::error::Error>> {
    let mut errors = Errors::of(budget::BALANCE);
    let rule = Graded::new(16, 12);
    let ramp = PiecewiseLinear::new([(0.0, 0.0), (1.0, 100.0)])?;
    for n in [1e-233, 1e-20, 1e-10, 1e-3, 0.02] {
        let contact = joint(Polynomial::new([(0.3, n)])?, 1.0, &ramp);
        for t in [0.3_f64, 0.9, 5.0, 300.0] {
            let now = contact.at(t)?;
            let a = now.radius();
            let start = contact.at(t.min(1.0))?.radius() / a;
            let carried = |from, to| rule.integrate(from, to, |q| now.pressure(q * a) * (q * a) * a);
            let load = TAU * (carried(0.0, start) + carried(start, 1.0));
            errors.add(load, now.force(), 1.0, &(n, t));
        }
    }
    errors.check();
    Ok(())
}

/// Once a held load has reached where the high power begins, ages grow hundreds of times as fast there as before.
#[test]
fn pressure_of_very_high_powers_carries_the_load() -> Result<(), Box<dyn core::error::Error>> {
    let mut errors = Errors::of(budget::BALANCE);
    let rule = Graded::new(16, 12);
    for n in [64.0, 200.0, 400.0, 720.0, 1000.0] {
        for terms in [&[(6e-7, n), (4e-6, 2.0)][..], &[(6e-7, n), (4e-6, 0.5), (-1.5e-7, 9.5)]] {
            let contact = joint(Polynomial::new(terms)?, 0.13, Constant(2.5e-9));
            let start = contact.at(0.0)?.radius();
            for t in [20.0_f64, 100.0, 300.0, 500.0] {
                let now = contact.at(t)?;
                let carried = force_between(&now, &[0.0, start, now.radius()], &rule);
                errors.add(carried, now.force(), 1.0, &(n, terms, t));
            }
        }
    }
    errors.check();
    Ok(())
}

fn check_load(name: &str, load: &dyn Load<f64>, times: &[f64]) {
    errors_under(name, load, times).check();
}

fn errors_under(name: &str, load: &dyn Load<f64>, times: &[f64]) -> Errors {
    errors_on(cases(), name, load, times)
}

fn errors_on(
    cases: impl IntoIterator<Item = Case>,
    name: &str,
    load: &dyn Load<f64>,
    times: &[f64],
) -> Errors {
    let is_known = load.is_linear_between_knots();
    let mut errors = Errors::of(if is_known { budget::BALANCE } else { budget::BALANCE_OF_OTHER_LOADS });
    let rule = Graded::new(16, 7);
    for case in cases {
        for &time in times {
            let t = time / CHI;
            if load.force(t) > 0.0 {
                let carried = carried(case, load, t, times_of_kinks(load, t), &rule);
                errors.add(carried, load.force(t), 1.0, &(name, case, time));
            }
        }
    }
    errors
}

/// 2π ∫₀ᵃ P r dr, in a medium in which the contact radius at `t` is [`LAST_RADIUS`]; P is smooth between the contact
/// radii at `times`.
fn carried(case: Case, load: &dyn Load<f64>, t: f64, times: Vec<f64>, rule: &Graded) -> f64 {
    let solve = || {
        let contact = planted::contact(case.double, load, CHI, LAST_RADIUS, t)?;
        let now = contact.at(t)?;
        let mut borders = vec![0.0];
        borders.extend(radii_at(times, case.double, load, contact.medium().m() * FRAC_PI_4));
        borders.push(now.radius());
        Ok(force_between(&now, &borders, rule))
    };
    solve().unwrap_or_else(|error: ContactError| unreachable!("{case:?}, {t}: {error}"))
}

/// 2π ∫ P r dr over radii between the first and the last of `borders`, between which P is smooth.
fn force_between<P: GapProfile<f64>, L: Load<f64>>(
    now: &Snapshot<'_, f64, P, L>,
    borders: &[f64],
    rule: &Graded,
) -> f64 {
    let shares = borders.windows(2).map(|ends| rule.integrate(ends[0], ends[1], |r| now.pressure(r) * r));
    TAU * shares.sum::<f64>()
}

/// The times between which the pressure is smooth.
fn times_of_kinks(load: &dyn Load<f64>, t: f64) -> Vec<f64> {
    if load.is_linear_between_knots() {
        let knots = core::iter::successors(load.next_knot(0.0), |&knot| load.next_knot(knot));
        knots.take_while(|&knot| knot <= t).collect()
    } else {
        (1..12).map(|part| t * f64::from(part) / 12.0).collect()
    }
}

/// The contact radii at the start and at `times`, on both sides of jumps.
fn radii_at(
    times: Vec<f64>,
    profile: &dyn GapProfile<f64>,
    load: &dyn Load<f64>,
    stiffness: f64,
) -> Vec<f64> {
    let forces = |time: f64| [load.force_before(time), load.force(time)].map(|force| (time, force));
    let radius = |(time, force)| profile.radius((force + CHI * load.impulse(time)) / stiffness).ok();
    let times = core::iter::once(0.0).chain(times);
    let mut radii: Vec<f64> = times.flat_map(forces).filter_map(radius).collect();
    radii.retain(|&radius| radius > 0.0);
    radii.dedup();
    radii
}
