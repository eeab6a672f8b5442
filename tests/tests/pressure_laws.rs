//! Laws of the pressure: it is not negative, falls outwards, is zero outside, and fades at the rate χ.

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, ContactError, GapProfile, Medium};
use proptest::prelude::*;
use tests::budget;
use tests::condition::edge;
use tests::loads::{Announced, Fall, Rise, Swing, Unannounced, histories, through};
use tests::measure::{Errors, relative_error};
use tests::planted;
use tests::profiles::{Case, cases};
use tests::random::{self, failure};

const CHI: f64 = 0.02;

/// A contact whose radius is `a` at `t`.
fn contact<L: Load<f64>>(
    case: Case,
    load: L,
    a: f64,
    t: f64,
) -> Result<Contact<f64, &'static dyn GapProfile<f64>, L>, ContactError> {
    planted::contact(case.double, load, CHI, a, t)
}

proptest! {
    #![proptest_config(random::cases(300))]

    #[test]
    fn pressure_falls_outwards_to_zero(
        (index, history) in (0..cases().len(), 0..histories(CHI).len()),
        time in 1e-3..10.0,
        (inner, outer) in (0.0..1.0, 0.0..1.0),
    ) {
        let (name, load) = histories(CHI).swap_remove(history);
        let contact = contact(cases()[index], load, 5.0, time / CHI).map_err(failure)?;
        let now = contact.at(time / CHI).map_err(failure)?;
        let (inner, outer) = (f64::min(inner, outer) * now.radius(), f64::max(inner, outer) * now.radius());
        let (high, low) = (now.pressure(inner), now.pressure(outer));
        let rounding = 1.0 + budget::PRESSURE.double * f64::EPSILON;
        prop_assert!(high.is_finite() && low >= 0.0 && low <= high * rounding, "{name}: {high} {low}");
        prop_assert!(high <= now.peak_pressure() * rounding, "{name}");
        prop_assert_eq!(now.pressure(now.radius() * (1.0 + f64::EPSILON)), 0.0);
        prop_assert_eq!(now.pressure(-inner), high);
    }
}

#[test]
fn pressure_relaxes_like_the_load_at_a_constant_approach() -> Result<(), ContactError> {
    for case in cases() {
        let contact = contact(case, Fall { force: 100.0, rate: CHI }, 5.0, 0.0)?;
        let first = contact.at(0.0)?;
        for folds in [0.02, 0.6, 1.5, 4.0, 10.0, 17.3, 30.0, 36.0, 41.0, 60.0, 105.0, 400.0] {
            let t = folds / CHI;
            let now = contact.at(t)?;
            let error = relative_error(now.radius(), first.radius(), f64::EPSILON);
            assert!(error <= 2.0 * budget::CONTACT_RADIUS.double, "{case:?}: {error}");
            for r in [0.0, 2.0, 4.0] {
                let expected = first.pressure(r) * (-CHI * t).exp();
                let allowed = budget::PRESSURE.double * edge(first.radius(), r) + budget::FOLD * folds;
                let error = relative_error(now.pressure(r), expected, f64::EPSILON);
                assert!(error <= allowed, "{case:?}, {t}, {r}: {error:.1} of {allowed:.1} ε");
            }
        }
    }
    Ok(())
}

#[test]
fn jumps_and_kinks_are_found_where_no_knot_tells_of_them() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for (name, load) in histories(CHI) {
        for case in cases() {
            for t in [0.05, 0.2, 0.9, 1.1, 3.0, 15.0].map(|folds| folds / CHI) {
                let (told, found) =
                    (contact(case, &load, 5.0, t)?, contact(case, Unannounced(&load), 5.0, t)?);
                let (told, found) = (told.at(t)?, found.at(t)?);
                for r in [0.0, 2.0, 4.0] {
                    let edge = edge(told.radius(), r);
                    errors.add(found.pressure(r), told.pressure(r), edge, &(name, case, t, r));
                }
            }
        }
    }
    errors.check();
    Ok(())
}

/// Integration steps begin at a knot, not a rounding before it, where the force is still that of the ramp.
#[test]
fn short_ramps_end_at_their_knots() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for duration in [1e-7, 1e-6, 1e-5, 7e-4, 1e-2] {
        for share in [0.0, 0.1, 0.4, 0.9] {
            let start = 33.0 + share;
            let load = through(&[(0.0, 50.0), (start, 50.0), (start + duration, 100.0)]);
            for t in [35.1, 100.3, 550.1] {
                let straight = contact(cases()[0], &load, 5.0, t)?;
                let curved = contact(cases()[0], Announced::curved(&load), 5.0, t)?;
                let (straight, curved) = (straight.at(t)?, curved.at(t)?);
                for r in [0.0, 2.0, 4.0, 4.95] {
                    let edge = edge(straight.radius(), r);
                    let place = (start, duration, t, r);
                    errors.add(curved.pressure(r), straight.pressure(r), edge, &place);
                }
            }
        }
    }
    errors.check();
    Ok(())
}

/// This holds even for loads that are not straight, whose steps are then shorter than any normal number.
#[test]
fn nothing_has_drained_in_the_first_moments() -> Result<(), ContactError> {
    for case in cases() {
        let contact = contact(case, Fall { force: 100.0, rate: CHI / 2.0 }, 5.0, 0.0)?;
        let first = contact.at(0.0)?;
        for t in [5e-324, 1e-318, 1e-310, f64::MIN_POSITIVE] {
            let now = contact.at(t)?;
            for r in [0.0, 2.0, 4.0] {
                let error = relative_error(now.pressure(r), first.pressure(r), f64::EPSILON);
                let allowed = 2.0 * budget::PRESSURE.double * edge(first.radius(), r);
                assert!(error <= allowed, "{case:?}, {t:e}, {r}: {error:.1} of {allowed:.1} ε");
            }
        }
    }
    Ok(())
}

#[test]
fn there_is_no_memory_without_drainage() -> Result<(), ContactError> {
    let load = through(&[(0.0, 10.0), (5.0, 100.0)]);
    for case in cases() {
        let contact = Contact::new(case.double, Medium::from_constants(1e3, 0.0)?, &load)?;
        let (now, later) = (contact.at(5.0)?, contact.at(1e9)?);
        assert_eq!((now.radius(), now.pressure(0.3)), (later.radius(), later.pressure(0.3)), "{case:?}");
        let undrained = 1e3 * case.double.pressure_kernel(now.radius(), 0.3);
        let error = relative_error(now.pressure(0.3), undrained, f64::EPSILON);
        assert!(error <= 2.0 * budget::PRESSURE.double, "{case:?}: {error}");
    }
    Ok(())
}

#[test]
fn knots_where_nothing_happens_change_nothing() -> Result<(), ContactError> {
    let plain = [(0.0, 100.0)];
    for last in [0.5, 10.0, 200.0, 1000.0].map(|time| time / CHI) {
        let split: Vec<(f64, f64)> = (0..=20).map(|part| (last * f64::from(part) / 20.0, 100.0)).collect();
        let mut errors = Errors::of(budget::PRESSURE);
        for case in cases() {
            for (split, t) in [(&split[..], last), (&split[..], last + 1.0), (&split[..20], last)] {
                let (plain, split) = (PiecewiseLinear::new(&plain[..]), PiecewiseLinear::new(split));
                let (plain, split) = (plain?, split?);
                let (plain, split) = (contact(case, plain, 5.0, t)?, contact(case, split, 5.0, t)?);
                let (plain, split) = (plain.at(t)?, split.at(t)?);
                for r in [0.0, 2.0, 4.0, 4.9] {
                    let edge = edge(plain.radius(), r);
                    errors.add(split.pressure(r), plain.pressure(r), edge, &(case, t, r));
                }
            }
        }
        errors.check();
    }
    Ok(())
}

/// Impulses of equal pieces have equal roundings, which would add up.
#[test]
fn ten_thousand_knots_where_nothing_happens_change_nothing() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for t in [1.0, 20.0].map(|time| time / CHI) {
        let knots: Vec<(f64, f64)> = (0..=10_000).map(|part| (t * f64::from(part) / 1e4, 70.0)).collect();
        let split = PiecewiseLinear::new(knots)?;
        let (plain, split) =
            (contact(cases()[0], Constant(70.0), 5.0, t)?, contact(cases()[0], split, 5.0, t)?);
        let (plain, split) = (plain.at(t)?, split.at(t)?);
        for r in [0.0, 4.0] {
            let edge = edge(plain.radius(), r);
            errors.add(split.pressure(r), plain.pressure(r), edge, &(t, r));
        }
    }
    errors.check();
    Ok(())
}

/// A load that reports equidistant knots up to the time `last`, at which nothing happens.
struct WithKnots<'a> {
    load: &'a dyn Load<f64>,
    last: f64,
    count: u32,
}

impl Load<f64> for WithKnots<'_> {
    fn force(&self, t: f64) -> f64 {
        self.load.force(t)
    }

    fn impulse(&self, t: f64) -> f64 {
        self.load.impulse(t)
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        let time = |knot: u32| self.last * f64::from(knot) / f64::from(self.count);
        (1..=self.count).map(time).find(|&knot| knot > t)
    }
}

/// Every stretch between knots is rounded by itself: a load left out of one stretch must be added in the next.
#[test]
fn knots_in_a_load_of_a_users_own_change_nothing() -> Result<(), ContactError> {
    let slowly = Rise { start: 0.0, rise: 90.0, rate: 0.5 * CHI };
    let quickly = Rise { start: 10.0, rise: 90.0, rate: 5.0 * CHI };
    let falling = Rise { start: 100.0, rise: -90.0, rate: 0.5 * CHI };
    let swing = Swing { mean: 100.0, amplitude: 70.7, frequency: CHI };
    let mut errors = Errors::of(budget::PRESSURE);
    for (index, load) in [&slowly as &dyn Load<f64>, &quickly, &falling, &swing].into_iter().enumerate() {
        for t in [1e-3, 0.1, 3.0, 40.0, 300.0].map(|time| time / CHI) {
            for case in cases() {
                let with_knots = |count| contact(case, WithKnots { load, last: t, count }, 5.0, t);
                let (few, many) = (with_knots(3)?, with_knots(64)?);
                let (few, many) = (few.at(t)?, many.at(t)?);
                for r in [0.0, 2.0, 4.0, 4.9] {
                    let edge = edge(few.radius(), r);
                    errors.add(many.pressure(r), few.pressure(r), edge, &(index, case, t * CHI, r));
                }
            }
        }
    }
    errors.check();
    Ok(())
}

/// The same history of the load, slower, in a medium that drains as much slower.
#[test]
fn time_is_measured_in_units_of_the_memory() -> Result<(), ContactError> {
    let mut errors = Errors::of(budget::PRESSURE);
    for case in cases() {
        for ((name, quick), (_, slow)) in histories(CHI).into_iter().zip(histories(CHI / 8.0)) {
            let quick = Contact::new(case.double, Medium::from_constants(1e3, CHI)?, quick)?;
            let slow = Contact::new(case.double, Medium::from_constants(1e3, CHI / 8.0)?, slow)?;
            for time in [0.01, 0.1, 2.0, 5.0].map(|time| time / CHI) {
                let (quick, slow) = (quick.at(time)?, slow.at(8.0 * time)?);
                let error = relative_error(slow.radius(), quick.radius(), f64::EPSILON);
                assert!(error <= 2.0 * budget::CONTACT_RADIUS.double, "{case:?}, {name}: {error}");
                errors.add(
                    slow.pressure(0.2),
                    quick.pressure(0.2),
                    edge(quick.radius(), 0.2),
                    &(case, name, time),
                );
            }
        }
    }
    errors.check();
    Ok(())
}

#[test]
fn a_snapshot_is_copied_whatever_load_it_belongs_to() -> Result<(), ContactError> {
    let load = PiecewiseLinear::new(vec![(0.0, 100.0), (10.0, 120.0)])?;
    let contact = contact(cases()[0], load, 5.0, 20.0)?;
    let now = contact.at(20.0)?;
    let copy = now;
    assert_eq!(copy.peak_pressure(), now.peak_pressure());
    Ok(())
}
