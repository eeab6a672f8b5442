//! A user-defined load that falls faster than the contact can follow is detected, and no other is refused.

use core::f64::consts::PI;

use cartcontact::load::Load;
use cartcontact::{ContactError, Scalar};
use tests::joint::joint;
use tests::loads::{Rise, Swing, Unannounced, through};
use tests::profiles::Paraboloid;

const CHI: f64 = 0.02;

/// The share of itself by which a time since which a load falls may be off: the worst is 9e-12, far into a history.
const TURN: f64 = 4e-11;

/// The time since which the edge recedes, as the error at the time `t` reports it.
fn since(load: &dyn Load<f64>, chi: f64, t: f64) -> Option<f64> {
    match joint(Paraboloid, chi, load).at(t) {
        Ok(_) => None,
        Err(ContactError::Receding { time, since }) => {
            assert!(time == t && since < t, "{time}, {since}");
            Some(since)
        }
        Err(error) => unreachable!("{error}"),
    }
}

fn assert_near(found: Option<f64>, expected: f64, tolerance: f64) {
    assert!(found.is_some_and(|found| (found - expected).abs() <= tolerance), "{found:?}, {expected}");
}

/// A load that begins at zero and swings: 50 (1 − cos ωt).
struct Gait {
    frequency: f64,
}

impl Load<f64> for Gait {
    fn force(&self, t: f64) -> f64 {
        let half = (self.frequency * t / 2.0).sin();
        100.0 * half * half
    }

    fn impulse(&self, t: f64) -> f64 {
        50.0 * (t - (self.frequency * t).sin() / self.frequency)
    }
}

#[test]
fn gait_recedes_in_its_first_cycle_however_late_it_is_asked_for() {
    for frequency in [1e-4, 0.005, 0.02, 0.3, 7.0] {
        // ω sin ωt + χ (1 − cos ωt) = 0.
        let turn = 2.0 * (PI - f64::atan2(frequency, CHI)) / frequency;
        for after in [1.01, 1.3, 2.0, 10.0, 1e3, 1e5_f64] {
            // The search takes no steps below 2^−17 of the time.
            if frequency * turn * after < 1e5 {
                assert_near(since(&Gait { frequency }, CHI, turn * after), turn, TURN * turn);
            }
        }
        assert_eq!(since(&Gait { frequency }, CHI, turn * 0.999_999), None);
    }
    assert!(since(&Gait { frequency: 0.005 }, CHI, 1000.0 / CHI).is_some());
}

/// A ramp with a ripple: F₀ + s t − A sin ωt falls within every wave where A ω > s.
struct Ripple {
    start: f64,
    slope: f64,
    amplitude: f64,
    frequency: f64,
}

impl Load<f64> for Ripple {
    fn force(&self, t: f64) -> f64 {
        self.start + self.slope * t - self.amplitude * (self.frequency * t).sin()
    }

    fn impulse(&self, t: f64) -> f64 {
        let half = (self.frequency * t / 2.0).sin();
        (self.start + self.slope * t / 2.0) * t - 2.0 * self.amplitude * half * half / self.frequency
    }
}

/// Late in a history the ripple is a small share of the load, and many of its waves lie between two nodes.
#[test]
fn a_ripple_recedes_in_its_first_wave_however_late_it_is_asked_for() {
    for (start, slope) in [(100.0, 1.0), (100.0, 0.1), (10.0, 10.0)] {
        for frequency in [1.0, 3.0, 20.0, 100.0] {
            for amplitude in [0.3, 1.0, 3.0, 10.0] {
                let load = Ripple { start, slope, amplitude, frequency };
                for chi in [0.0, 1e-5, 1.5e-3] {
                    // At the start the load falls at A ω − s, and Y by χ F less.
                    if amplitude * frequency - slope <= 1.1 * chi * start {
                        continue;
                    }
                    for t in [10.0, 100.0, 1e3, 1e4, 1e5] {
                        let found = since(&load, chi, t);
                        assert_eq!(
                            found,
                            Some(0.0),
                            "{start} + {slope} t, {amplitude} sin {frequency} t, {chi}, {t}"
                        );
                    }
                }
            }
        }
    }
}

/// 100 + A sin ωt recedes where A √(ω² + χ²) > 100 χ.
fn swing(frequency: f64, excess: f64) -> Swing {
    let amplitude = 100.0 * CHI / frequency.hypot(CHI) * (1.0 + excess);
    Swing { mean: 100.0, amplitude, frequency }
}

/// A search through 10⁸ waves may find nothing, but the edge does not recede from one result to the next, either.
#[test]
fn results_that_show_a_fall_are_refused_whatever_is_asked_for_last() {
    let load = Swing { mean: 100.0, amplitude: 8.0, frequency: 2.0 * PI };
    let contact = joint(Paraboloid, 0.1, &load as &dyn Load<f64>);
    // Where F′ = −χ F.
    let crest = 0.284_404_266_400_135;
    let is_expected = |result: Result<(), ContactError>| match result {
        Err(ContactError::Receding { since, .. }) => (since - crest).abs() < TURN * crest,
        _ => false,
    };
    for times in [[0.0, 0.2, 0.3, 0.5, 0.7, 1e8], [0.0, 0.1, 0.2, 0.25, 0.3, 0.4]] {
        let (mut radii, mut reversed) = ([0.0; 6], times);
        reversed.reverse();
        let refused = contact.radii(&times, &mut radii);
        assert_eq!(contact.pressure_field(&times, &[0.0], &mut radii), refused);
        assert!(is_expected(refused));
        assert!(contact.radii(&reversed, &mut radii).is_err());
    }
    // In no order, and the two times that show the fall descend.
    assert!(is_expected(contact.radii(&[0.7, 0.3, 0.1, 1e8], &mut [0.0; 4])));
}

#[test]
fn swings_are_told_apart_by_their_amplitude() {
    for share in [0.01, 0.3, 1.0, 2.5, 17.0, 60.0] {
        let frequency = share * CHI;
        // The first time at which F′ + χ F is least.
        let steepest = (PI + f64::atan2(CHI, frequency)) / frequency;
        for folds in [1.0, 10.0, 123.0, 1e3, 1e4] {
            let t = folds / CHI;
            assert_eq!(since(&swing(frequency, -1e-6), CHI, t), None, "{share}, {folds}");
            assert_eq!(since(&swing(frequency, -0.5), CHI, t), None, "{share}, {folds}");
            for excess in [1e-3, 0.1] {
                if swing(frequency, excess).amplitude > 100.0 {
                    continue;
                }
                let turn = steepest - f64::acos(1.0 / (1.0 + excess)) / frequency;
                let end = steepest + (steepest - turn);
                let found = since(&swing(frequency, excess), CHI, t);
                if t > end {
                    // Y hardly falls, so that its rounding moves the time; the worst is 2.1e-8.
                    assert_near(found, turn, 1e-7 / frequency);
                } else if t < turn {
                    assert_eq!(found, None, "{share}, {folds}");
                }
            }
        }
    }
}

/// A load of 100 with a short dip: 100 − D cos² within half a width of a time.
struct Dip {
    depth: f64,
    time: f64,
    width: f64,
}

impl Dip {
    /// The phase from the middle of the dip, at most π/2.
    fn phase(&self, t: f64) -> f64 {
        (PI * ((t - self.time) / self.width)).clamp(-PI / 2.0, PI / 2.0)
    }
}

impl Load<f64> for Dip {
    fn force(&self, t: f64) -> f64 {
        100.0 - self.depth * self.phase(t).cos().powi(2)
    }

    fn impulse(&self, t: f64) -> f64 {
        let lost = |phase: f64| self.depth * self.width / PI * (phase / 2.0 + (2.0 * phase).sin() / 4.0);
        100.0 * t - (lost(self.phase(t)) - lost(self.phase(0.0)))
    }
}

#[test]
fn a_dip_between_samples_is_noticed_by_its_impulse() {
    for share in [1e-1, 1e-2, 1e-3, 1e-4] {
        for folds in [1.0, 30.0, 1e3] {
            let t = folds / CHI;
            for place in [0.123_456, 0.517, 0.9] {
                let (time, width) = (place * t, share * t);
                let dip = |depth| Dip { depth, time, width };
                // F′ is at most D π over the width.
                let harmless = 0.9 * CHI * (100.0 - 50.0) * width / PI;
                assert_eq!(since(&dip(harmless.min(50.0)), CHI, t), None, "{share}, {folds}, {place}");
                if harmless < 10.0 {
                    let found = since(&dip(50.0), CHI, t);
                    let early = time - width / 2.0;
                    assert!(found.is_some_and(|s| s >= early - 1e-6 * t && s < time), "{found:?}, {early}");
                }
            }
        }
    }
}

#[test]
fn a_decay_may_be_as_fast_as_the_memory() {
    let decay = |rate: f64| Rise { start: 100.0, rise: -100.0, rate };
    for folds in [1e-6, 0.1, 1.0, 30.0, 300.0] {
        let t = folds / CHI;
        for admissible in [1.0, 1.0 - 1e-15, 1.0 - 1e-9, 0.999, 0.5] {
            assert_eq!(since(&decay(CHI * admissible), CHI, t), None, "{folds}, {admissible}");
        }
        for excess in [1e-8, 1e-3, 1.0, 30.0] {
            // Rounding hides a fall of 8 ε.
            if excess * folds.min(1.0) > 1e-14 {
                assert_near(since(&decay(CHI * (1.0 + excess)), CHI, t), 0.0, 0.0);
            }
        }
    }
}

/// F = 100 (t/1000)^p: early in a history it is nearly all rounding, and next to t = 0 it is below the normal numbers.
struct PowerOfTime(i32);

impl<T: Scalar> Load<T> for PowerOfTime {
    fn force(&self, t: T) -> T {
        T::constant(100.0) * (t * T::constant(1e-3)).powi(self.0)
    }

    fn impulse(&self, t: T) -> T {
        T::constant(1e5 / f64::from(self.0 + 1)) * (t * T::constant(1e-3)).powi(self.0 + 1)
    }
}

#[test]
fn rising_powers_of_time_never_recede() {
    for power in 1..=10 {
        for chi in [0.0015, 0.1, 1.0, 10.0] {
            for t in (1..2000_u16).step_by(7) {
                let load = PowerOfTime(power);
                let double: Option<f64> = load.recession(chi, f64::from(t));
                let single: Option<f32> = load.recession(chi as f32, f32::from(t));
                assert!(double.is_none() && single.is_none(), "{power}, {chi}, {t}: {double:?}, {single:?}");
            }
        }
    }
}

#[test]
fn nothing_may_fall_without_drainage() {
    let load = swing(0.3, 0.0);
    assert_eq!(since(&load, 0.0, 0.499 * PI / 0.3), None);
    assert_near(since(&load, 0.0, 0.6 * PI / 0.3), 0.5 * PI / 0.3, TURN);
    let rise = Rise { start: 10.0, rise: 90.0, rate: 0.3 };
    assert_eq!(since(&rise, 0.0, 1e6), None);
}

#[test]
fn many_times_name_the_first_that_is_too_late() {
    let contact = joint(Paraboloid, CHI, Gait { frequency: 0.3 });
    let turn = 2.0 * (PI - f64::atan2(0.3, CHI)) / 0.3;
    let times: Vec<f64> = (1..400).map(|step| f64::from(step) * 0.1).collect();
    let first = times.iter().copied().find(|&time| time > turn);
    let mut values = vec![0.0; times.len()];
    for result in [contact.pressure_field(&times, &[0.0], &mut values), contact.radii(&times, &mut values)] {
        let Err(ContactError::Receding { time, since }) = result else { unreachable!("{result:?}") };
        assert_eq!(Some(time), first);
        assert_near(Some(since), turn, TURN * turn);
    }
}

/// The edge recedes at the very time of the step, of which nothing shows earlier.
#[test]
fn a_step_down_at_the_last_of_many_times_is_refused() {
    struct Step;
    impl Load<f64> for Step {
        fn force(&self, t: f64) -> f64 {
            if t < 5.0 { 100.0 } else { 50.0 }
        }
        fn impulse(&self, t: f64) -> f64 {
            100.0 * t - 50.0 * (t - 5.0).max(0.0)
        }
        fn next_knot(&self, t: f64) -> Option<f64> {
            (t < 5.0).then_some(5.0)
        }
        fn force_before(&self, t: f64) -> f64 {
            if t <= 5.0 { 100.0 } else { 50.0 }
        }
    }
    let knots = through(&[(0.0, 100.0), (5.0, 100.0), (5.0, 50.0)]);
    let loads: [&dyn Load<f64>; 2] = [&knots, &Step];
    for load in loads {
        let contact = joint(Paraboloid, CHI, load);
        let expected = ContactError::Receding { time: 5.0, since: 5.0 };
        assert_eq!(contact.at(5.0).err(), Some(expected));
        let (times, mut values) = ([4.0, 5.0], [0.0; 2]);
        assert_eq!(contact.radii(&times, &mut values), Err(expected));
        assert_eq!(contact.pressure_field(&times, &[0.0], &mut values), Err(expected));
        assert_eq!(contact.radii(&[4.0, 4.999_999], &mut values), Ok(()));
    }
}

/// A load with an invalid force, or with the impulse of another force.
struct Wrong {
    force: f64,
    impulse: f64,
}

impl Load<f64> for Wrong {
    fn force(&self, t: f64) -> f64 {
        if t > 1.0 { self.force } else { 100.0 }
    }

    fn impulse(&self, t: f64) -> f64 {
        self.impulse * t
    }
}

#[test]
fn the_search_ends_for_loads_that_are_none() {
    for value in [f64::NAN, f64::INFINITY, -1.0, 0.0, 100.0, 1e300] {
        let found = Wrong { force: value, impulse: 100.0 }.recession(CHI, 1e4);
        // A larger force has a larger impulse.
        assert_eq!(found.is_some(), value != 100.0, "{value}: {found:?}");
        // The impulse of another force contradicts this force from the start.
        let found = Wrong { force: 100.0, impulse: value }.recession(CHI, 1e4);
        let is_wrong = if value.is_finite() { found == Some(0.0) } else { found.is_some() };
        assert_eq!(is_wrong, value != 100.0, "impulse {value}: {found:?}");
    }
}

#[test]
fn single_precision_notices_as_well() {
    let fall = through(&[(0.0_f32, 100.0), (50.0, 0.0)]);
    assert_eq!(Unannounced(&fall).recession(0.1, 39.9), None);
    // From 40 s on Y = 260 falls by 0.1 (t − 40)², which is within its rounding for so long.
    let hidden = (8.0 * f32::EPSILON * 260.0 / 0.1).sqrt();
    assert!(Unannounced(&fall).recession(0.1, 45.0).is_some_and(|since| (since - 40.0).abs() < hidden));
}
