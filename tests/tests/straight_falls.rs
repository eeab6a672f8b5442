//! Loads that are straight between their knots are refused if they fall faster than the contact can follow, in however
//! many pieces, and no others are.

use cartcontact::ContactError;
use cartcontact::load::Load;
use tests::budget;
use tests::joint::joint;
use tests::loads::{Announced, CountingForces, Knots, through};
use tests::profiles::Paraboloid;
use tests::random::Stream;

const CHI: f64 = 0.02;

/// The share of itself by which a time since which a load falls may be off if another path finds it. Within a piece the
/// rounding ε of its forces moves that time by ε/χ over the e-foldings of the piece; the worst is 1.4e-9, in a piece of
/// 3e-4 e-foldings.
const TIME: f64 = 3e-9;
/// The same where all pieces are long: a few roundings; the worst is 7.4e-16.
const TIME_OF_LONG_PIECES: f64 = 2e-15;

#[test]
fn straight_loads_are_judged_as_they_judge_themselves() {
    let histories = [
        through(&[(0.0, 100.0), (12.5, 80.0), (100.0, 80.0)]),
        through(&[(0.0, 100.0), (12.4, 80.0), (100.0, 80.0)]),
        through(&[(0.0, 0.0), (50.0, 100.0), (100.0, 0.0)]),
        through(&[(0.0, 100.0), (5.0, 100.0), (5.0, 99.0), (5.1, 200.0)]),
        through(&[(0.0, 100.0), (60.0, 40.0), (70.0, 40.0), (70.0, 70.0), (75.0, 60.0)]),
    ];
    for load in &histories {
        for t in [1.0, 5.0, 12.45, 20.0, 66.0, 99.0, 1e4] {
            let (own, found) = (load.recession(CHI, t), Announced::curved(load).recession(CHI, t));
            assert_eq!(own.is_some(), found.is_some(), "{load:?}, {t}: {own:?}, {found:?}");
            assert!(
                own.zip(found).is_none_or(|(own, found)| (own - found).abs() <= TIME_OF_LONG_PIECES * own),
                "{own:?}, {found:?}"
            );
        }
    }
}

/// Falls along lines that are as steep at their ends as allowed, F₁ = F₀/(1 + χ Δt), with rounded forces.
#[test]
fn rounded_falls_as_fast_as_the_memory_are_none_too_fast() {
    for folds in [1e-4, 0.01, 0.02, 0.06, 0.5, 3.0] {
        let duration = folds / CHI;
        for k in 0..200 {
            let first = 100.0 + f64::from(k) * 0.37;
            let load = through(&[(0.0, first), (duration, first / (1.0 + folds))]);
            assert_eq!(load.recession(CHI, 2.0 * duration), None, "{first} in {folds}");
        }
        let forces = (0..100).map(|k| (f64::from(k) * duration, 102.0 * (1.0 + folds).powi(-k)));
        let load = through(&forces.collect::<Vec<_>>());
        assert_eq!(load.recession(CHI, 99.0 * duration), None, "{folds}");
        let too_fast = through(&[(0.0, 100.0), (duration, 100.0 * (1.0 - 1e-13) / (1.0 + folds))]);
        assert!(too_fast.recession(CHI, 2.0 * duration).is_some(), "{folds}");
    }
}

/// A line from one force to another and a jump back, as a user may write it: the rounding of its last force is relative
/// to the first.
struct Dip {
    first: f64,
    last: f64,
    duration: f64,
}

impl Dip {
    fn force_on_the_way(&self, t: f64) -> f64 {
        self.first + (self.last - self.first) * (t / self.duration)
    }
}

impl Load<f64> for Dip {
    fn force(&self, t: f64) -> f64 {
        if t < self.duration { self.force_on_the_way(t) } else { self.first }
    }

    fn impulse(&self, t: f64) -> f64 {
        let fallen = t.min(self.duration);
        let held = (t - self.duration).max(0.0);
        0.5 * (self.first + self.force_on_the_way(fallen)) * fallen + self.first * held
    }

    fn force_before(&self, t: f64) -> f64 {
        if t <= self.duration { self.force_on_the_way(t) } else { self.first }
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        (t < self.duration).then_some(self.duration)
    }

    fn is_linear_between_knots(&self) -> bool {
        true
    }
}

#[test]
fn long_falls_as_fast_as_the_memory_are_none_too_fast() {
    for folds in [30.0, 100.0, 1e4, 1e8] {
        let duration = folds / CHI;
        for k in 0..1000 {
            let first = 50.0 + f64::from(k) * 0.37;
            let dip = |last| Dip { first, last, duration };
            let least = first / (1.0 + folds);
            assert_eq!(dip(least).recession(CHI, 2.0 * duration), None, "{first} in {folds}");
            let load = through(&[(0.0, first), (duration, least), (duration, first)]);
            assert_eq!(load.recession(CHI, 2.0 * duration), None, "{first} in {folds}");
            // The fall exceeds the least force by more than the rounding of the first one.
            let less = least - 32.0 * f64::EPSILON * first;
            let load = through(&[(0.0, first), (duration, less), (duration, first)]);
            for since in [dip(less).recession(CHI, 2.0 * duration), load.recession(CHI, 2.0 * duration)] {
                assert!(since.is_some_and(|since| since > 0.9 * duration), "{first} in {folds}: {since:?}");
            }
        }
    }
}

/// A load in single precision at 1 kHz; `next` makes each force from the one before and their distance in e-foldings.
fn sampled(chi: f32, count: usize, next: impl Fn(f32, f32) -> f32) -> Knots<f32> {
    let mut knots = vec![(0.0_f32, 80.0_f32)];
    for k in 1..count {
        let ((before, force), t) = (knots[k - 1], k as f32 * 1e-3);
        knots.push((t, next(force, chi * (t - before))));
    }
    through(&knots)
}

/// Each step falls too fast only by rounding, but all of them together do not.
#[test]
fn falls_in_small_steps_add_up() {
    for chi in [1.5e-2, 1.5e-3, 1.5e-4_f32] {
        for ratio in [1.1, 1.5, 3.0, 5.0] {
            // Rounded to `f32` at the end, not recursively, which would change steps this short.
            let force = |k: usize| (80.0 * (-f64::from(ratio * chi) * 1e-3 * k as f64).exp()) as f32;
            let knots: Vec<(f32, f32)> = (0..100_000).map(|k| (k as f32 * 1e-3, force(k))).collect();
            let load = through(&knots);
            let contact = joint(Paraboloid, chi.into(), &load);
            // The excess of the fall is found when it is √ε of the force.
            let found_at = f32::EPSILON.sqrt() / ((ratio - 1.0) * chi);
            if found_at < 50.0 {
                let late = 1.5 * found_at + 1.0;
                let expected = contact.at(late).err();
                assert!(
                    matches!(expected, Some(ContactError::Receding { since, .. }) if since < 0.3),
                    "{chi}, {ratio}: {expected:?}"
                );
                let mut values = [0.0; 2];
                assert_eq!(contact.radii(&[0.0, late], &mut values).err(), expected);
                assert_eq!(contact.pressure_field(&[0.0, late], &[0.0], &mut values).err(), expected);
            }
            // In a single step, an excess of 8 ε is too much.
            if (ratio - 1.0) * chi * 1e-3 < 4.0 * f32::EPSILON {
                let early = (found_at / 1.5).min(99.0);
                assert_eq!(contact.radii(&[early], &mut [0.0]), Ok(()), "{chi}, {ratio}");
            }
        }
    }
}

/// They do so however the load is followed, but not with what was before a rise.
#[test]
fn falls_in_small_steps_begin_behind_a_rise() {
    let chi = 1.5e-4_f32;
    let force = |k: u32| (80.0 * (-f64::from(3.0 * chi) * 1e-3 * f64::from(k)).exp()) as f32;
    let falls = (0..10_000).map(|k| (10.0 + k as f32 * 1e-3, force(k)));
    let knots: Vec<(f32, f32)> = core::iter::once((0.0, 20.0)).chain(falls).collect();
    let load = through(&knots);
    for since in [load.recession(chi, 15.0), Announced::curved(&load).recession(chi, 15.0)] {
        assert!(since.is_some_and(|since| (10.0..10.01).contains(&since)), "{since:?}");
    }
}

/// Where a load is held, nearly nothing drains that could make up for a jump down.
#[test]
fn falls_in_small_jumps_add_up() {
    let chi = 1e-6_f32;
    let staircase = |roundings: f32, count: u16| {
        let fall = roundings * f32::EPSILON;
        let step = |k: u16| [k, k + 1].map(|end| (f32::from(end) * 1e-3, 80.0 * (1.0 - fall * f32::from(k))));
        let knots: Vec<(f32, f32)> = (0..count).flat_map(step).collect();
        through(&knots)
    };
    let recession =
        |load: &Knots<f32>, t| [load.recession(chi, t), Announced::curved(load).recession(chi, t)];
    // Falls that add up to less than √ε of the force may be rounding.
    assert_eq!(recession(&staircase(5.0, 400), 0.4), [None; 2]);
    let found = recession(&staircase(5.0, 2000), 2.0);
    assert!(found.into_iter().all(|since| since.is_some_and(|since| since < 0.01)), "{found:?}");
    let found = recession(&staircase(12.0, 2), 0.0015);
    assert!(found.into_iter().all(|since| since.is_some_and(|since| since <= 0.001)), "{found:?}");
}

/// The rounding of F₀/(1 + χ Δt) is the same in many steps; other ways to compute it round differently.
#[test]
fn a_load_at_the_bound_may_have_any_number_of_knots() {
    for chi in [1e-5, 1.5e-4, 4e-4, 1e-3, 1.5e-3, 0.0123, 0.2_f32] {
        let loads = [
            ("clamped", sampled(chi, 100_000, |force, folds| force / (1.0 + folds))),
            ("half as fast", sampled(chi, 100_000, |force, folds| force / (1.0 + 0.5 * folds))),
            ("held", sampled(chi, 100_000, |force, _| force)),
        ];
        for (name, load) in &loads {
            for t in [0.5, 20.0, 99.999, 1e3] {
                assert_eq!(load.recession(chi, t), None, "{name}, {chi}, {t}");
            }
        }
        // Followed in panels, the load at the bound adds up roundings between its knots, too.
        assert_eq!(Announced::curved(&loads[0].1).recession(chi, 10.0), None, "{chi}");
        // Noise above the least force.
        let noisy = |k: usize| 80.0 * (1.0 + 0.01 * (k as f32 * 1.7).sin() * (k as f32 * 0.0137).cos());
        let mut knots = vec![(0.0, noisy(0))];
        for k in 1..100_000 {
            let ((before, force), t) = (knots[k - 1], k as f32 * 1e-3);
            knots.push((t, noisy(k).max(force / (1.0 + chi * (t - before)))));
        }
        let load = through(&knots);
        assert_eq!(load.recession(chi, 1e3), None, "{chi}");
    }
}

#[test]
fn straight_loads_of_a_users_own_are_judged_by_their_pieces() {
    let mut stream = Stream::of_case(14, 1);
    for case in 0..2000 {
        let (mut knots, mut time, mut force) = (vec![(0.0, 100.0)], 0.0, 100.0);
        for _ in 0..stream.below(40) {
            let folds = stream.magnitude(-6.0, 0.5);
            force *= match stream.below(8) {
                0 => 1.0,
                1 => 1.0 + stream.magnitude(-9.0, 1.0),
                2 => (1.0 - stream.magnitude(-9.0, -2.0)) / (1.0 + folds),
                _ => 1.0 / (1.0 + folds),
            };
            // Only knots say from which force a load jumps at the start.
            time += if time > 0.0 && stream.below(10) == 0 { 0.0 } else { folds / CHI };
            if knots.len() < 2 || knots[knots.len() - 2].0 < time {
                knots.push((time, force));
            }
        }
        let load = through(&knots);
        let own = CountingForces::new(&load);
        for t in [0.0, 0.3 * time, 0.77 * time, time, 2.0 * time + 1.0] {
            let (expected, found) = (load.recession(CHI, t), own.recession(CHI, t));
            assert_eq!(expected.is_some(), found.is_some(), "{case}, {t}: {knots:?}");
            let is_near = |(a, b): (f64, f64)| (a - b).abs() <= TIME * a;
            assert!(expected.zip(found).is_none_or(is_near), "{case}, {t}: {expected:?}, {found:?}");
            assert!(load.recession(CHI, t).is_some() || own.contradiction(CHI, t).is_none(), "{case}, {t}");
        }
    }
    let single = sampled(1.5e-3, 20_000, |force, folds| force / (1.0 + 1.5 * folds));
    let own = CountingForces::new(&single);
    assert_eq!(own.recession(1.5e-3, 19.0), single.recession(1.5e-3, 19.0));
    let clamped = sampled(1.5e-3, 20_000, |force, folds| force / (1.0 + folds));
    let own = CountingForces::new(&clamped);
    assert_eq!(own.recession(1.5e-3, 30.0), None);
    let forces = own.forces();
    assert!(forces < 50_000, "{forces}");
}

/// P = P₀ F/F₀ where the edge stands still; the roundings of its place must not add up.
#[test]
fn pressures_fade_with_a_load_at_the_bound() {
    for chi in [1.5e-3, 1.5e-2_f32] {
        let force = |k: i32| (80.0 * (1.0 + f64::from(chi) * 1e-3).powi(-k)) as f32;
        let knots: Vec<(f32, f32)> = (0..20_000).map(|k| (k as f32 * 1e-3, force(k))).collect();
        let load = through(&knots);
        let contact = joint(Paraboloid, chi.into(), load);
        let peak = |t: f32| contact.at(t).map_or(f32::NAN, |now| now.peak_pressure());
        let error = peak(19.999) / peak(0.0) / (force(19_999) / 80.0) - 1.0;
        // Of both peaks, and of both forces.
        let allowed = (2.0 * budget::PEAK_PRESSURE.single + 2.0) as f32 * f32::EPSILON;
        assert!(error.abs() < allowed, "{chi}: {error:e}");
    }
}
