//! A user-defined load is refused if and only if its impulse is not the integral of its force; where this cannot be
//! decided, it does not take long either.

use core::f64::consts::LN_2;

use cartcontact::load::{Load, LoadError};
use cartcontact::{Contact, ContactError, Polynomial};
use tests::joint::joint;
use tests::loads::CountingForces;
use tests::random::Stream;

const CHI: f64 = 0.02;

type Curve = Box<dyn Fn(f64) -> f64>;

/// A force and its alleged impulse.
struct Told {
    force: Curve,
    impulse: Curve,
}

impl Load<f64> for Told {
    fn force(&self, t: f64) -> f64 {
        (self.force)(t)
    }

    fn impulse(&self, t: f64) -> f64 {
        (self.impulse)(t)
    }
}

fn told(force: impl Fn(f64) -> f64 + 'static, impulse: impl Fn(f64) -> f64 + 'static) -> Told {
    Told { force: Box::new(force), impulse: Box::new(impulse) }
}

type Gap = Polynomial<f64, [(f64, f64); 2]>;

fn contact<L: Load<f64>>(chi: f64, load: L) -> Contact<f64, Gap, L> {
    let gap = Polynomial::new([(0.025, 2.0), (1e-4, 4.0)]).unwrap_or_else(|error| unreachable!("{error}"));
    joint(gap, chi, load)
}

/// ∫F of a rise from zero to 100.
fn rise_impulse(t: f64) -> f64 {
    100.0 * (t + (-0.05 * t).exp_m1() / 0.05)
}

fn rise(t: f64) -> f64 {
    -100.0 * (-0.05 * t).exp_m1()
}

/// Loads with the impulse of another load, up to a time.
fn contradictions(t: f64) -> Vec<(&'static str, Told)> {
    let held = |_| 100.0;
    let swing = |t: f64| 100.0 + 5.0 * (0.3 * t).sin();
    vec![
        ("twice", told(held, |t| 200.0 * t)),
        ("half", told(held, |t| 50.0 * t)),
        ("a hundredth more", told(held, |t| 101.0 * t)),
        ("none", told(held, |_| 0.0)),
        ("the force itself", told(held, held)),
        ("in another unit", told(held, |t| 0.1 * t)),
        ("twice that of a rise", told(rise, |t| 2.0 * rise_impulse(t))),
        ("of another load", told(rise, |t| 100.0 * t)),
        ("of a slower load", told(held, rise_impulse)),
        ("without the swing", told(swing, |t| 100.0 * t)),
        ("not from 0 on", told(held, move |s| 100.0 * (s + 0.3 * t))),
        ("with a jump", told(held, move |s| 100.0 * s + if s > 0.7 * t { t } else { 0.0 })),
        (
            "that shrinks",
            told(held, move |s| 100.0 * s - if s > 0.7 * t { 50.0 * (s - 0.7 * t) } else { 0.0 }),
        ),
    ]
}

#[test]
fn an_impulse_of_another_force_is_refused() {
    for folds in [0.1, 1.0, 30.0, 1e3] {
        let t = folds / CHI;
        for (name, load) in contradictions(t) {
            let found = contact(CHI, &load).at(t).err();
            let Some(ContactError::Load(LoadError::ContradictoryImpulse { from, to, impulse, integral })) =
                found
            else {
                unreachable!("{name}, {folds}: {found:?}")
            };
            // An impulse must begin at zero.
            let start = (load.impulse)(0.0);
            if start.abs() > 1e-3 * (load.impulse)(t) {
                assert_eq!((from, to, impulse, integral), (0.0, 0.0, start, 0.0), "{name}, {folds}");
                continue;
            }
            assert!(0.0 <= from && from < to && to <= t, "{name}, {folds}: {from}, {to}");
            let gain = (load.impulse)(to) - if from > 0.0 { (load.impulse)(from) } else { 0.0 };
            assert_eq!(impulse, gain, "{name}, {folds}");
            let mean = (load.force)((from + to) / 2.0);
            assert!((integral / (mean * (to - from)) - 1.0).abs() < 0.1, "{name}, {folds}: {integral}");
            assert_ne!(impulse, integral, "{name}, {folds}");
        }
    }
}

#[test]
fn all_ways_to_a_contact_refuse_it_alike() {
    let contact = contact(CHI, told(|_| 100.0, |t| 200.0 * t));
    let expected = contact.at(50.0).err();
    assert!(
        matches!(expected, Some(ContactError::Load(LoadError::ContradictoryImpulse { .. }))),
        "{expected:?}"
    );
    assert_eq!(contact.radii(&[50.0], &mut [0.0]).err(), expected);
    assert_eq!(contact.pressure_field(&[50.0], &[0.0], &mut [0.0]).err(), expected);
    let (load, chi) = (contact.load(), contact.medium().chi());
    assert!(load.recession(chi, 50.0).is_some());
    assert_eq!(load.contradiction(chi, 50.0).map(ContactError::Load), expected);
}

/// A constant load that says it is straight, in single precision.
struct Held {
    impulse: f32,
}

impl Load<f32> for Held {
    fn force(&self, _t: f32) -> f32 {
        100.0
    }

    fn impulse(&self, t: f32) -> f32 {
        self.impulse * t
    }

    fn is_linear_between_knots(&self) -> bool {
        true
    }
}

#[test]
fn straight_loads_and_single_precision_are_no_exception() {
    let is_refused = |impulse, t| {
        let found = Held { impulse }.contradiction(0.02, t);
        assert!(matches!(found, Some(LoadError::ContradictoryImpulse { .. })), "{impulse}, {t}: {found:?}");
    };
    for t in [1.0, 1e2, 1e4] {
        assert_eq!(Held { impulse: 100.0 }.recession(0.02, t), None);
        // Sums of plain arithmetic may be off by 1/256.
        assert_eq!(Held { impulse: 100.3 }.recession(0.02, t), None);
        is_refused(200.0, t);
        is_refused(50.0, t);
    }
    // At 1 s this is less than the error of a quadrature.
    is_refused(100.5, 1e2);
    is_refused(100.5, 1e4);
}

/// A quadrature may be off by √ε Y/χ at either end of a gain: the impulse of a held load may be off by nearly twice that
/// in all, in shares that depend on how much of the time has passed.
fn check_limit(folds: f64, share: fn(f64) -> f64) {
    let t = folds / CHI;
    let error = f64::EPSILON.sqrt() * 100.0 * (1.0 + folds) / CHI;
    let refused =
        |off: f64| contact(CHI, told(|_| 100.0, move |s| 100.0 * s + off * share(s / t))).at(t).err();
    assert_eq!(refused(1.9 * error), None, "{folds}");
    let found = refused(3.0 * error);
    assert!(
        matches!(found, Some(ContactError::Load(LoadError::ContradictoryImpulse { .. }))),
        "{folds}: {found:?}"
    );
}

#[test]
fn an_impulse_may_jump_by_twice_the_error_of_a_quadrature() {
    for folds in [0.1, 1.0, 30.0] {
        check_limit(folds, |passed| if passed > 0.7 { 1.0 } else { 0.0 });
    }
}

/// Either half of the time has half of the error, which alone would be allowed.
#[test]
fn an_impulse_may_drift_by_no_more() {
    for folds in [1e-6, 1e-5, 1e-4] {
        check_limit(folds, |passed| passed);
    }
}

#[test]
fn without_drainage_no_impulse_counts() {
    for impulse in [0.0, 50.0, 1e6] {
        assert!(contact(0.0, told(|_| 100.0, move |t| impulse * t)).at(50.0).is_ok());
    }
}

/// Parameters of random loads: a mean force, the rate of the medium, a time, and a place and a width within it.
#[derive(Clone, Copy)]
struct About {
    mean: f64,
    chi: f64,
    t: f64,
    place: f64,
    width: f64,
}

/// A random load that recedes nowhere in a medium with the rate χ, for times up to about `t`.
fn honest(stream: &mut Stream, chi: f64, t: f64) -> (&'static str, Told) {
    let mean = stream.magnitude(-2.0, 4.0);
    let (place, width) = (stream.between(0.0, 1.0) * t, stream.magnitude(-9.0, 0.0) * t);
    let about = About { mean, chi, t, place, width };
    match stream.below(6) {
        0 => ("a steep rise", steep_rise(about, stream)),
        1 => ("a swing", swing(about, stream)),
        2 => ("a dip", dip(about)),
        3 => ("a kink", kink(about, stream)),
        4 => ("a decay", decay(about, stream)),
        _ => ("a staircase", staircase(about, stream)),
    }
}

fn steep_rise(About { mean, place, width, .. }: About, stream: &mut Stream) -> Told {
    let height = mean * stream.magnitude(-6.0, 6.0);
    let ln_cosh = |x: f64| x.abs() + (-2.0 * x.abs()).exp().ln_1p() - LN_2;
    let force = move |t: f64| mean + height * (0.5 + 0.5 * ((t - place) / width).tanh());
    let gained = move |t: f64| ln_cosh((t - place) / width) - ln_cosh(place / width);
    told(force, move |t| mean * t + 0.5 * height * (t + width * gained(t)))
}

fn swing(About { mean, chi, t, .. }: About, stream: &mut Stream) -> Told {
    let frequency = stream.magnitude(0.0, 5.0) / t;
    // A swing recedes where A √(ω² + χ²) > F χ.
    let amplitude = 0.99 * mean * chi / frequency.hypot(chi);
    let half = move |t: f64| (frequency * t / 2.0).sin();
    let impulse = move |t: f64| mean * t + 2.0 * amplitude * half(t) * half(t) / frequency;
    told(move |t| mean + amplitude * (frequency * t).sin(), impulse)
}

fn dip(About { mean, chi, place, width, .. }: About) -> Told {
    // F′ is at most 0.77 D over the width.
    let depth = mean * chi * width / (1.0 + chi * width);
    let force = move |t: f64| mean - depth / ((t - place) / width).cosh().powi(2);
    let lost = move |t: f64| depth * width * (((t - place) / width).tanh() + (place / width).tanh());
    told(force, move |t| mean * t - lost(t))
}

fn kink(About { mean, t, place, .. }: About, stream: &mut Stream) -> Told {
    let slope = mean * stream.magnitude(-3.0, 3.0) / t;
    let since = move |t: f64| (t - place).max(0.0);
    let impulse = move |t: f64| mean * t + 0.5 * slope * since(t) * since(t);
    told(move |t| mean + slope * since(t), impulse)
}

fn decay(About { mean, chi, .. }: About, stream: &mut Stream) -> Told {
    let rate = chi * (1.0 - stream.magnitude(-9.0, 0.0));
    let impulse = move |t: f64| if rate > 0.0 { -mean * (-rate * t).exp_m1() / rate } else { mean * t };
    told(move |t| mean * (-rate * t).exp(), impulse)
}

/// A force that steps up at times that no method reports.
struct Staircase {
    /// The time, the force from there on and the impulse up to there.
    steps: Vec<(f64, f64, f64)>,
}

impl Staircase {
    fn step(&self, t: f64) -> (f64, f64, f64) {
        self.steps[self.steps.partition_point(|step| step.0 <= t).saturating_sub(1)]
    }
}

fn staircase(About { mean, t, .. }: About, stream: &mut Stream) -> Told {
    let (mut time, mut force, mut impulse) = (0.0, mean, 0.0);
    let mut steps = vec![(time, force, impulse)];
    for _ in 0..stream.below(300) {
        let duration = t * stream.magnitude(-7.0, -1.0);
        impulse += force * duration;
        time += duration;
        force *= 1.0 + stream.magnitude(-9.0, 0.0);
        steps.push((time, force, impulse));
    }
    let (one, other) = (Staircase { steps: steps.clone() }, Staircase { steps });
    let impulse = move |t: f64| {
        let (time, force, impulse) = other.step(t);
        impulse + force * (t - time)
    };
    told(move |t| one.step(t).1, impulse)
}

/// A number in [−1, 1] that varies erratically with time.
fn noise(t: f64) -> f64 {
    Stream::of_case(t.to_bits(), 1).between(-1.0, 1.0)
}

/// Adds an error that an honest impulse may have.
fn inexact(stream: &mut Stream, Told { force, impulse }: Told, t: f64) -> Told {
    let last = impulse(t);
    let impulse: Curve = match stream.below(5) {
        0 => impulse,
        1 => Box::new(move |t| impulse(t) * (1.0 + 64.0 * f64::EPSILON * noise(t))),
        2 => Box::new(move |t| impulse(t) * (1.0 + 1e-10 * noise(t))),
        // The error of a table, of the same size at all times.
        3 => Box::new(move |t| impulse(t) + last * 1e-10 * noise(t)),
        _ => Box::new(move |t| impulse(t) + last * 1e-10 * (t / last * 3e3).sin()),
    };
    Told { force, impulse }
}

#[test]
fn no_impulse_that_is_meant_well_is_refused() {
    let mut solved = 0;
    for case in 0..2000 {
        let mut stream = Stream::of_case(2011, case);
        let chi = stream.magnitude(-6.0, 3.0);
        let t = stream.magnitude(-4.0, 4.0) / chi;
        let (name, load) = honest(&mut stream, chi, t);
        let found = contact(chi, inexact(&mut stream, load, t)).at(t).err();
        // A decay may leave the format.
        let is_good = matches!(found, None | Some(ContactError::Unrepresentable { .. }));
        assert!(is_good, "case {case}, {name}: {found:?}");
        solved += u32::from(found.is_none());
    }
    assert!(solved > 1800, "{solved} of 2000 have a radius");
}

/// A load that is not searched.
struct Unsearched(CountingForces<Told>);

impl Load<f64> for Unsearched {
    fn force(&self, t: f64) -> f64 {
        self.0.force(t)
    }

    fn impulse(&self, t: f64) -> f64 {
        self.0.impulse(t)
    }

    fn recession(&self, _chi: f64, _t: f64) -> Option<f64> {
        None
    }
}

/// The pressure on the axis under a load that is not searched, and how many forces it took.
fn unsearched_pressure(load: Told, t: f64) -> (f64, usize) {
    let contact = contact(CHI, Unsearched(CountingForces::new(load)));
    let pressure = contact.at(t).map_or(f64::NAN, |now| now.peak_pressure());
    (pressure, contact.load().0.forces())
}

/// Without a limit there would be a hundred million forces.
#[test]
fn a_pressure_takes_no_long_time_whatever_the_impulse() {
    let mut most = 0;
    for folds in [0.1, 1.0, 30.0, 1e3] {
        let t = folds / CHI;
        let few = [1e-3, 1e-5, 1e-7]
            .map(|share| ("a little more", told(|_| 100.0, move |s| 100.0 * s * (1.0 + share))));
        let right_at_the_end = ("right at the end only", told(|_| 100.0, move |s| 100.0 * s * (s / t)));
        for (name, load) in contradictions(t).into_iter().chain(few).chain([right_at_the_end]) {
            let (pressure, asked) = unsearched_pressure(load, t);
            assert!(pressure.is_finite() && pressure > 0.0, "{name}, {folds}: {pressure}");
            most = most.max(asked);
        }
    }
    assert!(most < 300_000, "{most}");
}

#[test]
fn a_quadrature_of_few_digits_costs_no_more_digits() {
    for folds in [0.1, 1.0, 30.0] {
        let t = folds / CHI;
        let (exact, _) = unsearched_pressure(told(|_| 100.0, |t| 100.0 * t), t);
        for error in [1e-6, 1e-8, 1e-10] {
            let (found, _) =
                unsearched_pressure(told(|_| 100.0, move |s| 100.0 * s * (1.0 + error * noise(s))), t);
            // The error counts with χ t through the impulse.
            assert!(
                (found / exact - 1.0).abs() < error * (1.0 + folds),
                "{folds}, {error}: {found}, {exact}"
            );
        }
    }
}
