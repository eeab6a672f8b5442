//! Loads that break the contract of a load are refused where they enter, or when they are used.

use std::f64::consts::PI;

use cartcontact::load::{Constant, Load, LoadError, PiecewiseLinear};
use cartcontact::{Contact, ContactError};
use tests::joint::joint;
use tests::profiles::Paraboloid;

use super::{NOT_AN_AMOUNT, contact, paraboloid, refused};

#[test]
fn forces_are_finite_and_not_negative() {
    for value in NOT_AN_AMOUNT {
        let is_force = |e: &LoadError| matches!(e, LoadError::InvalidForce { .. });
        refused(Constant(value).check(), is_force, value);
        refused(PiecewiseLinear::new([(0.0, 1.0), (1.0, value)]), is_force, value);
        let contact = Contact::new(Paraboloid, *paraboloid().medium(), Constant(value));
        let is_load = |e: &ContactError| matches!(e, ContactError::Load(LoadError::InvalidForce { .. }));
        refused(contact, is_load, value);
    }
}

#[test]
fn knots_are_in_the_order_of_time_from_zero() {
    let through = |knots: &[(f64, f64)]| PiecewiseLinear::new(knots.to_vec());
    refused(through(&[]), |e| matches!(e, LoadError::Empty), "no knots");
    for value in [f64::NAN, f64::INFINITY] {
        let result = through(&[(0.0, 1.0), (value, 1.0)]);
        refused(result, |e| matches!(e, LoadError::InvalidTime { knot: 1, .. }), value);
    }
    for (start, remedy) in [(0.5, "or add a knot at 0"), (-0.5, "or leave out the knots before 0")] {
        let is_late_start = |e: &LoadError| matches!(e, LoadError::LateStart { .. });
        refused(through(&[(start, 1.0)]), is_late_start, start);
        refused(through(&[(start, 1.0)]), is_late_start, remedy);
    }
    let unsorted = through(&[(0.0, 1.0), (3.0, 1.0), (2.5, 1.0)]);
    refused(unsorted, |e| matches!(e, LoadError::Unsorted { knot: 2, .. }), "2.5");
    let triple = through(&[(0.0, 1.0), (1.5, 1.0), (1.5, 2.0), (1.5, 3.0)]);
    refused(triple, |e| matches!(e, LoadError::RepeatedTime { knot: 3, .. }), "1.5");
}

#[test]
fn a_load_that_falls_too_fast_says_since_when() -> Result<(), LoadError> {
    let falling = PiecewiseLinear::new([(0.0, 100.0), (50.0, 100.0), (60.0, 0.0)])?;
    let contact = contact(Paraboloid, falling);
    assert!(contact.at(50.0).is_ok());
    let is_receding = |e: &ContactError| matches!(e, ContactError::Receding { .. });
    refused(contact.at(55.0), is_receding, "at time 50");
    refused(contact.at(1000.0), is_receding, "at time 50");
    let mut radii = [0.0; 2];
    refused(contact.radii(&[10.0, 70.0], &mut radii), is_receding, "at time 70");
    let remedies =
        "ask for earlier times, check whether the chi of the layers should be larger, or clamp falls that";
    refused(contact.at(55.0), is_receding, remedies);
    Ok(())
}

/// A noisy record that falls from the start: no time is early enough.
#[test]
fn a_load_that_falls_from_the_start_is_to_be_smoothed() -> Result<(), LoadError> {
    let contact = contact(Paraboloid, PiecewiseLinear::new([(0.0, 80.3), (0.01, 79.9), (0.02, 80.1)])?);
    let is_receding = |e: &ContactError| matches!(e, ContactError::Receding { since: 0.0, .. });
    refused(contact.at(0.02), is_receding, "does not cover; check whether the chi of the layers should");
    Ok(())
}

/// A user-defined load with any constants as force and impulse.
struct Wrong {
    force: f64,
    impulse: f64,
}

impl Load<f64> for Wrong {
    fn force(&self, _t: f64) -> f64 {
        self.force
    }

    fn impulse(&self, _t: f64) -> f64 {
        self.impulse
    }
}

#[test]
fn loads_of_a_users_own_are_checked_when_they_are_used() {
    for value in NOT_AN_AMOUNT {
        let at = |load| {
            let contact = Contact::new(Paraboloid, *paraboloid().medium(), load);
            contact.and_then(|contact| contact.at(1.0).map(|now| now.peak_pressure()))
        };
        let is_force = |e: &ContactError| matches!(e, ContactError::Load(LoadError::InvalidForce { .. }));
        refused(at(Wrong { force: value, impulse: 1.0 }), is_force, value);
        let is_impulse = |e: &ContactError| matches!(e, ContactError::Load(LoadError::InvalidImpulse { .. }));
        refused(at(Wrong { force: 1.0, impulse: value }), is_impulse, value);
    }
}

#[test]
fn an_impulse_beyond_the_format_is_infinite() -> Result<(), LoadError> {
    let load = PiecewiseLinear::new([0.0, 1e10, 2e10].map(|time| (time, 1e308)))?;
    let is_impulse = |e: &ContactError| matches!(e, ContactError::Load(LoadError::InvalidImpulse { .. }));
    refused(contact(Paraboloid, load).at(3e10), is_impulse, "inf");
    Ok(())
}

/// Its impulse is a difference that early on is negative by rounding.
struct HalfCosine;

impl Load<f64> for HalfCosine {
    fn force(&self, t: f64) -> f64 {
        50.0 * (1.0 - (PI * t).cos())
    }

    fn impulse(&self, t: f64) -> f64 {
        50.0 * (t - (PI * t).sin() / PI)
    }
}

#[test]
fn an_impulse_may_be_negative_by_rounding() -> Result<(), ContactError> {
    let time = 6.265493684408876e-9;
    assert!(HalfCosine.impulse(time) < 0.0 && HalfCosine.force(time) > 0.0);
    let at = |chi, time| -> Result<f64, ContactError> {
        Ok(joint(Paraboloid, chi, HalfCosine).at(time)?.peak_pressure())
    };
    assert!(at(1e-3, time)? > 0.0);
    // Without drainage impulses do not count, not even if there is no force yet.
    assert!(at(0.0, time)? > 0.0);
    assert_eq!(at(0.0, 4.0056140261889765e-10)?, 0.0);
    Ok(())
}

#[test]
fn an_impulse_belongs_to_its_force() {
    let is_expected =
        |e: &ContactError| matches!(e, ContactError::Load(LoadError::ContradictoryImpulse { .. }));
    let doubled = contact(Paraboloid, Offset { start: 0.0, rate: 200.0 });
    refused(doubled.at(10.0), is_expected, "the impulse grows by");
    // An antiderivative that is not the one from 0.
    let late = contact(Paraboloid, Offset { start: 512.0, rate: 100.0 });
    for time in [0.0, 10.0] {
        refused(late.at(time), is_expected, "the impulse at time 0 is 512, but it must be 0 there");
        let mut radii = [0.0; 2];
        refused(late.radii(&[time; 2], &mut radii), is_expected, "must be 0 there");
    }
}

/// A force of 100 N, and an impulse that begins with a number and grows at a rate.
struct Offset {
    start: f64,
    rate: f64,
}

impl Load<f64> for Offset {
    fn force(&self, _t: f64) -> f64 {
        100.0
    }

    fn impulse(&self, t: f64) -> f64 {
        self.start + self.rate * t
    }
}

#[test]
fn hereditary_loads_beyond_the_format_are_refused() {
    let contact = contact(Paraboloid, Constant(f64::MAX));
    assert!(matches!(contact.at(1e10), Err(ContactError::Load(_))));
    assert!(matches!(contact.at(0.0), Err(ContactError::Unrepresentable { .. })));
}

/// 100 N, and 150 N from 10 s on, with a function that gives the next knot.
struct Stepped(fn(f64) -> Option<f64>);

impl Load<f64> for Stepped {
    fn force(&self, t: f64) -> f64 {
        if t < 10.0 { 100.0 } else { 150.0 }
    }
    fn impulse(&self, t: f64) -> f64 {
        100.0 * t + 50.0 * (t - 10.0).max(0.0)
    }
    fn force_before(&self, t: f64) -> f64 {
        if t <= 10.0 { 100.0 } else { 150.0 }
    }
    fn next_knot(&self, t: f64) -> Option<f64> {
        self.0(t)
    }
}

/// The pressure under a load with one step.
fn pressure<L: Load<f64>>(load: L) -> Result<f64, ContactError> {
    contact(Paraboloid, load).at(20.0).map(|now| now.pressure(3.0))
}

#[test]
fn a_knot_that_is_not_ahead_is_none() -> Result<(), ContactError> {
    let expected = pressure(Stepped(|t| (t < 10.0).then_some(10.0)))?;
    let wrong: [fn(f64) -> Option<f64>; 4] =
        [|_| Some(10.0), |t| (t <= 10.0).then_some(10.0), Some, |_| Some(f64::NAN)];
    for (which, next_knot) in wrong.into_iter().enumerate() {
        let found = pressure(Stepped(next_knot))?;
        // A step that no knot reports is found within 2^−20 of the time.
        assert!((found / expected - 1.0).abs() < 1e-6, "{which}: {found} instead of {expected}");
    }
    Ok(())
}

/// 100 N, with another force and impulse between 5 s and 8 s.
struct Disturbed {
    force: f64,
    impulse: f64,
}

impl Load<f64> for Disturbed {
    fn force(&self, t: f64) -> f64 {
        if (5.0..8.0).contains(&t) { self.force } else { 100.0 }
    }
    fn impulse(&self, t: f64) -> f64 {
        if (5.0..8.0).contains(&t) { self.impulse } else { 100.0 * t }
    }
}

#[test]
fn what_was_no_force_in_the_past_is_refused() {
    for value in NOT_AN_AMOUNT {
        let is_force = |e: &ContactError| match e {
            ContactError::Load(LoadError::InvalidForce { time, .. }) => (5.0..8.0).contains(time),
            _ => false,
        };
        refused(pressure(Disturbed { force: value, impulse: 600.0 }), is_force, value);
    }
}

/// A sensor's load in single precision, which holds each value for 1/5 s and does not report when it changes.
struct Held;

impl Load<f32> for Held {
    fn force(&self, t: f32) -> f32 {
        100.0 + (5.0 * t).floor()
    }
    fn impulse(&self, t: f32) -> f32 {
        let count = (5.0 * t).floor();
        100.0 * t + count * (t - 0.2 * count) + 0.1 * count * (count - 1.0)
    }
}

#[test]
fn steps_that_no_knot_tells_of_are_passed_in_single_precision() {
    let contact = joint(Paraboloid, 0.02, Held);
    let times: Vec<f32> = (0..60).map(|k| 0.5 * k as f32).collect();
    let mut pressures = vec![0.0_f32; times.len()];
    let filled = contact.pressure_field(&times, &[0.0], &mut pressures);
    assert!(filled.is_ok(), "{filled:?}");
    assert!(pressures.iter().all(|pressure| pressure.is_finite() && *pressure > 0.0), "{pressures:?}");
}

/// 100 N; panics if asked at an invalid time.
struct Strict {
    is_linear: bool,
}

impl Strict {
    fn checked(t: f64) -> f64 {
        assert!(t >= 0.0 && t.is_finite(), "asked for {t}");
        t
    }
}

impl Load<f64> for Strict {
    fn force(&self, t: f64) -> f64 {
        100.0 + 0.0 * Self::checked(t)
    }
    fn impulse(&self, t: f64) -> f64 {
        100.0 * Self::checked(t)
    }
    fn next_knot(&self, t: f64) -> Option<f64> {
        (Self::checked(t) < 5.0).then_some(5.0)
    }
    fn is_linear_between_knots(&self) -> bool {
        self.is_linear
    }
    fn recession(&self, _chi: f64, t: f64) -> Option<f64> {
        (Self::checked(t) < 0.0).then_some(t)
    }
}

/// The load in the documentation, for example, uses the time as an index.
#[test]
fn a_load_is_never_asked_for_a_time_that_is_none() {
    let is_time = |e: &ContactError| matches!(e, ContactError::InvalidTime { .. });
    for is_linear in [true, false] {
        let contact = contact(Paraboloid, Strict { is_linear });
        for value in NOT_AN_AMOUNT {
            refused(contact.at(value), is_time, value);
            for place in [0, 3, 299] {
                let mut times: Vec<f64> = (0..300).map(|k| 0.1 * f64::from(k)).collect();
                times[place] = value;
                refused(contact.radii(&times, &mut [0.0; 300]), is_time, value);
                let is_refused = |e: &ContactError| {
                    matches!(e, ContactError::InvalidTime { .. } | ContactError::Unsorted { .. })
                };
                refused(contact.pressure_field(&times, &[0.0], &mut [0.0; 300]), is_refused, "; ");
            }
            refused(contact.pressure_field(&[1.0, f64::INFINITY], &[0.0], &mut [0.0; 2]), is_time, "inf");
        }
    }
}

/// Where a history is just as long as it counts, rounding may put the time from which it counts below zero.
#[test]
fn a_load_is_never_asked_for_a_time_before_its_start() -> Result<(), ContactError> {
    let folds_that_count = 4.0 - f64::EPSILON.ln();
    for chi in [1.0, 0.7, 0.0015] {
        let contact = joint(Paraboloid, chi, Strict { is_linear: false });
        for count in 1..5 {
            let longest = f64::from(count) * folds_that_count / chi;
            for roundings in 0..12 {
                let time = f64::from_bits(longest.to_bits() + roundings);
                assert!(contact.at(time)?.peak_pressure() > 0.0, "{chi}, {time}");
            }
        }
    }
    Ok(())
}

/// Times of 1e60, beyond the usual sizes.
#[test]
fn times_of_no_common_size_have_the_radius_of_their_load() -> Result<(), ContactError> {
    let contact = joint(Paraboloid, 1e-60, Constant(100.0));
    let times = [0.0, 1e60, 2e60_f64];
    let mut radii = [0.0; 3];
    contact.radii(&times, &mut radii)?;
    for (time, radius) in times.into_iter().zip(radii) {
        let growth = (1.0 + 1e-60 * time).powf(1.0 / 6.0);
        // Two radii of 2 ε each, and the growth.
        assert!((radius / (radii[0] * growth) - 1.0).abs() < 1e-15, "{time}: {radius}");
        assert_eq!(radius, contact.at(time)?.radius());
    }
    Ok(())
}
