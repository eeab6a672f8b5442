//! User-defined loads that are zero, or the rounding of something, for a while before they rise: next to zero neither
//! forces nor impulses have digits, and nothing is covered. The pressures are compared with 25-digit integrals of
//! Eq. (28) from `reference/loads_from_nothing.py`.

use core::cell::Cell;
use core::f64::consts::PI;

use cartcontact::load::Load;
use cartcontact::{ContactError, Scalar};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::{Announced, CountingForces, Unannounced, through};
use tests::measure::Errors;
use tests::profiles::Patellofemoral;

const CHI: f64 = 0.02;

/// The share by which a peak pressure may be off.
const PEAK_PRESSURE: f64 = budget::PEAK_PRESSURE.double * f64::EPSILON;

/// The most forces that one pressure may take.
const MOST_FORCES: usize = 500_000;

/// A function of time. As a type of its own each would have the solver compiled again.
type Curve<'a> = &'a dyn Fn(f64) -> f64;

/// A force and its impulse, rounded once, with a knot and a count of the forces asked for.
struct Formula<'a> {
    force: Curve<'a>,
    impulse: Curve<'a>,
    knot: f64,
    forces: Cell<usize>,
}

impl<'a> Formula<'a> {
    fn new(force: Curve<'a>, impulse: Curve<'a>, knot: f64) -> Self {
        Self { force, impulse, knot, forces: Cell::new(0) }
    }
}

impl<T: Scalar> Load<T> for Formula<'_> {
    fn force(&self, t: T) -> T {
        self.forces.set(self.forces.get() + 1);
        assert!(self.forces.get() <= MOST_FORCES, "the solver does not end");
        T::constant((self.force)(t.value()))
    }

    fn impulse(&self, t: T) -> T {
        T::constant((self.impulse)(t.value()))
    }

    fn next_knot(&self, t: T) -> Option<T> {
        (t.value() < self.knot).then_some(T::constant(self.knot))
    }
}

/// The peak pressure at a time.
fn peak(t: f64, chi: f64, (force, impulse): (Curve<'_>, Curve<'_>), knot: f64) -> Result<f64, ContactError> {
    Ok(joint(Patellofemoral, chi, Formula::new(force, impulse, knot)).at(t)?.peak_pressure())
}

fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() <= tolerance, "{found:e} instead of {expected:e}");
}

/// ln(1 + eˣ), the integral of a logistic rise.
fn softplus(x: f64) -> f64 {
    x.max(0.0) + (-x.abs()).exp().ln_1p()
}

/// Half a cosine from nothing to 100 N in a second, then held: at first 1 − cos is zero or its rounding.
#[test]
fn half_a_cosine_may_be_written_as_such() -> Result<(), ContactError> {
    let rise = |t: f64| if t < 1.0 { 50.0 * (1.0 - (PI * t).cos()) } else { 100.0 };
    let exact_rise = |t: f64| if t < 1.0 { 100.0 * (PI * t / 2.0).sin().powi(2) } else { 100.0 };
    let impulse = |t: f64| if t < 1.0 { 50.0 * (t - (PI * t).sin() / PI) } else { 50.0 + 100.0 * (t - 1.0) };
    for chi in [1e-3, 3e-3, CHI, 0.1, 1.0] {
        for t in [1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0, 3.0] {
            let found = peak(t, chi, (&rise, &impulse), 1.0)?;
            // An error of a share x of the present force, made in the past, is a share x^(2/3) of the present pressure.
            let rounding = 50.0 * f64::EPSILON / exact_rise(t);
            assert_near(found, peak(t, chi, (&exact_rise, &impulse), 1.0)?, rounding.cbrt().powi(2));
        }
    }
    for (t, expected) in
        [(0.5, 1.141_572_984_809_986_2), (1.0, 1.823_234_156_791_787_4), (3.0, 1.800_168_597_193_021_5)]
    {
        assert_near(peak(t, CHI, (&rise, &impulse), 1.0)?, expected, PEAK_PRESSURE);
    }
    Ok(())
}

/// In its first hundredth the impulse of half a slow cosine is all rounding, while the force has every digit.
#[test]
fn impulses_that_cancel_early_take_few_forces() -> Result<(), ContactError> {
    let rise = |t: f64| if t < 1e3 { 100.0 * (PI * t / 2e3).sin().powi(2) } else { 100.0 };
    let impulse = |t: f64| {
        if t < 1e3 { 50.0 * (t - (PI * t / 1e3).sin() * 1e3 / PI) } else { 5e4 + 100.0 * (t - 1e3) }
    };
    let load = Formula::new(&rise, &impulse, 1e3);
    let contact = joint(Patellofemoral, CHI, load);
    for (t, expected) in [
        (50.0, 4.957_965_873_345_463e-2),
        (300.0, 3.363_193_255_298_72e-1),
        (1000.0, 6.140_821_180_954_884e-1),
        (1100.0, 5.810_584_031_458_677e-1),
    ] {
        let now = contact.at(t)?;
        contact.load().forces.set(0);
        assert_near(now.peak_pressure(), expected, PEAK_PRESSURE);
        // The limit is twice the number that it takes.
        let forces = contact.load().forces.get();
        assert!(forces < 50_000, "{t}: {forces}");
    }
    Ok(())
}

#[test]
fn a_load_may_begin_late() -> Result<(), ContactError> {
    // a = 0 up to 100 s.
    let since = |t: f64| (t - 100.0).max(0.0);
    let root: (Curve<'_>, Curve<'_>) = (&|t| 90.0 * since(t).powf(0.1), &|t| 90.0 / 1.1 * since(t).powf(1.1));
    // The times are rounded by 1e-16 of 101 s, which is at first a large share of the time since the knot.
    assert_near(peak(101.0, CHI, root, 100.0)?, 1.694_338_650_692_070_5, 1e-12);
    assert_eq!(peak(99.0, CHI, root, 100.0)?, 0.0);
    Ok(())
}

/// The peaks under a ramp of 10 s that begins late, followed step by step and as the straight load that it is.
fn peaks_of_late_ramp<T: Scalar>(start: f64, later: f64) -> Result<[f64; 2], ContactError> {
    let knots = [(0.0, 0.0), (start, 0.0), (start + 10.0, 100.0)];
    let straight = through(&knots.map(|(t, force)| (T::constant(t), T::constant(force))));
    let in_steps = Announced { load: &straight, is_linear: false };
    let peak = |load: &dyn Load<T>| -> Result<f64, ContactError> {
        let contact = joint(Patellofemoral, 0.0015, load);
        Ok(contact.at(T::constant(start + later))?.peak_pressure().value())
    };
    Ok([peak(&in_steps)?, peak(&straight)?])
}

/// After so long a time the nodes of a step lie beside the times at which forces are taken.
#[test]
fn late_ramps_are_as_exact_as_straight_loads() -> Result<(), ContactError> {
    for later in [1e-3, 0.03125, 0.125, 1.0, 10.0, 100.0, 500.0] {
        let [found, expected] = peaks_of_late_ramp::<f64>(1e8, later)?;
        assert_near(found, expected, 2.0 * PEAK_PRESSURE);
    }
    // Here a second has 128 numbers.
    for later in [0.03125, 0.125, 1.0, 5.0, 10.0, 100.0, 500.0] {
        let [found, expected] = peaks_of_late_ramp::<f32>(1e5, later)?;
        assert_near(found, expected, 2.0 * budget::PEAK_PRESSURE.single * f64::from(f32::EPSILON));
    }
    Ok(())
}

/// A step of so few numbers drains for as long as these are apart, and not as the nodes are.
#[test]
fn late_falls_may_be_followed_from_number_to_number() {
    let start = 4e10_f64;
    let fallen = 100.0 / (1.0 + 0.9 * 0.0015 * 100.0);
    let load = through(&[(0.0, 0.0), (start, 0.0), (start, 100.0), (start + 100.0, fallen)]);
    let contact = joint(Patellofemoral, 0.0015, Announced { load, is_linear: false });
    let mut t = start;
    for _ in 0..300 {
        t = t.next_up();
        assert!(contact.at(t).is_ok(), "{t}");
    }
}

/// Logistic rises, of which the forces underflow at first.
#[test]
fn a_load_may_come_out_of_an_underflow() -> Result<(), ContactError> {
    let steep = |t: f64| 90.0 / (1.0 + (8.0 * (100.0 - t)).exp());
    let impulse = |t: f64| 90.0 / 8.0 * (8.0 * (t - 100.0)).exp().ln_1p();
    for (t, expected) in [(100.0, 1.062_452_624_442_345_3), (110.0, 1.597_507_805_446_538)] {
        assert_near(peak(t, CHI, (&steep, &impulse), f64::INFINITY)?, expected, PEAK_PRESSURE);
    }
    // The impulse is a difference of terms of 4500 N s.
    let logarithm_of_cosh = |x: f64| x.abs() + (-2.0 * x.abs()).exp().ln_1p() - 2f64.ln();
    let impulse = |t: f64| 45.0 * (t + logarithm_of_cosh(t - 100.0) - logarithm_of_cosh(100.0));
    let rounded = |t: f64| 45.0 * (1.0 + (t - 100.0).tanh());
    let exact = |t: f64| 90.0 / (1.0 + (200.0 - 2.0 * t).exp());
    let expected = 1.542_541_210_605_384_5;
    assert_near(peak(101.0, CHI, (&exact, &impulse), f64::INFINITY)?, expected, 1e-11);
    assert_near(peak(101.0, CHI, (&rounded, &impulse), f64::INFINITY)?, expected, 1e-11);
    Ok(())
}

/// High powers, of which most of the history is negligible against the end.
#[test]
fn a_load_may_be_a_high_power_of_time() -> Result<(), ContactError> {
    for (power, expected) in [(20, 8.198_943_914_133_43e-2), (30, 8.200_873_070_774_43e-2)] {
        let load: (Curve<'_>, Curve<'_>) =
            (&|t| t.powi(power), &|t| t.powi(power + 1) / f64::from(power + 1));
        assert_near(peak(1.0, CHI, load, f64::INFINITY)?, expected, PEAK_PRESSURE);
    }
    Ok(())
}

/// This holds in single precision too, where rounding is a larger share.
#[test]
fn smooth_rises_from_nothing_take_few_forces() {
    struct Rise;
    impl Load<f32> for Rise {
        fn force(&self, t: f32) -> f32 {
            100.0 * (1.0 - (-t / 10.0).exp())
        }
        fn impulse(&self, t: f32) -> f32 {
            100.0 * (t - 10.0 * (1.0 - (-t / 10.0).exp()))
        }
    }
    let contact = joint(Patellofemoral, 0.0015, CountingForces::new(Rise));
    for step in 0..300 {
        let t = 1e-4 * 1.06_f32.powi(step);
        contact.load().forces();
        assert!(contact.at(t).is_ok(), "{t}");
        let forces = contact.load().forces();
        // The limit is twice the worst of these times.
        assert!(forces < 200_000, "{t}: {forces}");
    }
}

/// Where a load rises from zero, or has a kink that no knot tells of, two computations of a step are off by nearly as
/// much as they differ.
#[test]
fn peaks_in_single_precision_are_as_exact_as_in_double() -> Result<(), ContactError> {
    let mut errors = Errors::of_single(budget::PEAK_PRESSURE);
    for power in [0.5, 1.5, 1.8, 2.0, 3.0] {
        compare_peaks(&|t| t.powf(power), &|t| t.powf(power + 1.0) / (power + 1.0), &mut errors)?;
    }
    compare_peaks(&|t| 2.0 * (0.5 * t).sin().powi(2), &|t| t - t.sin(), &mut errors)?;
    // 5 N up and down again within 2 s, beside 100 N.
    let since_low = |t: f64| t.rem_euclid(2.0);
    let triangle = |t: f64| 105.0 - 5.0 * (1.0 - since_low(t)).abs();
    let impulse = |t: f64| {
        let (time, since) = (t - since_low(t), since_low(t) - 1.0);
        102.5 * time + 105.0 * (since + 1.0) - 2.5 * (since * since.abs() + 1.0)
    };
    compare_peaks(&triangle, &impulse, &mut errors)?;
    errors.check();
    Ok(())
}

fn compare_peaks(force: Curve<'_>, impulse: Curve<'_>, errors: &mut Errors) -> Result<(), ContactError> {
    let load = Formula::new(force, impulse, f64::INFINITY);
    for chi in [0.25_f32, 0.5, 1.0] {
        let single = joint::<f32, _, _>(Patellofemoral, chi.into(), &load);
        let double = joint::<f64, _, _>(Patellofemoral, chi.into(), &load);
        for t in (1_u16..240).map(|step| f32::from(step) * 0.0131) {
            load.forces.set(0);
            let (found, expected) = (single.at(t)?.peak_pressure(), double.at(t.into())?.peak_pressure());
            errors.add(found.into(), expected, 1.0, &(t, chi));
        }
    }
    Ok(())
}

/// After a rest the first forces suffer from the rounding of the times; away from the axis they do not matter.
#[test]
fn rises_behind_a_rest_take_few_forces_off_the_axis() -> Result<(), ContactError> {
    let since = |t: f64| (t - 1.0).max(0.0);
    let (force, impulse) = (|t: f64| since(t).powf(1.5), |t: f64| since(t).powf(2.5) / 2.5);
    let contact = joint(Patellofemoral, CHI, Formula::new(&force, &impulse, 1.0));
    let now = contact.at(100.0)?;
    for (r, expected) in [(1.0, 6.284_373_000_716_511), (3.0, 5.709_895_899_363_812)] {
        contact.load().forces.set(0);
        let allowed = budget::PRESSURE.double * edge(now.radius(), r) * f64::EPSILON;
        assert_near(now.pressure(r), expected, allowed);
        // The limit is four times the number that it takes.
        assert!(contact.load().forces.get() < 5000, "{r}: {}", contact.load().forces.get());
    }
    Ok(())
}

/// Far from zero, forces of a steep rise are as uncertain as the times at which they are taken.
#[test]
fn late_steep_rises_take_few_forces() -> Result<(), ContactError> {
    for width in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let past = |t: f64| (t - 300.0) / width;
        let force = |t: f64| 100.0 / (1.0 + (-past(t)).exp());
        let impulse = |t: f64| 100.0 * width * softplus(past(t));
        let contact = joint(Patellofemoral, 0.0015, Formula::new(&force, &impulse, f64::INFINITY));
        let now = contact.at(400.0)?;
        contact.load().forces.set(0);
        assert!(now.peak_pressure() > 0.0);
        let forces = contact.load().forces.get();
        // The limit is three times the worst.
        assert!(forces < 12_000, "{width:e} s: {forces} forces");
    }
    Ok(())
}

/// What happens after a load has begun is followed as closely as if it were all: short steps behind the beginning, which
/// only see how times are rounded, do not make later steps longer.
#[test]
fn a_late_beginning_hides_nothing_behind_it() -> Result<(), ContactError> {
    let since = |t: f64| (t - 1.0).max(0.0);
    let force = |t: f64| since(t).powf(1.5) + 50.0 / (1.0 + ((2.0 - t) / 0.005).exp());
    let impulse = |t: f64| since(t).powf(2.5) / 2.5 + 0.25 * softplus((t - 2.0) / 0.005);
    for (t, expected) in [(2.1, 1.160_287_103_504_665_5), (3.0, 1.179_098_243_805_098_6)] {
        assert_near(peak(t, CHI, (&force, &impulse), 1.0)?, expected, PEAK_PRESSURE);
    }
    // Two kinks that no knot reports, the first of them at a force of zero.
    for start in [0.1, 1.0, 33.3] {
        let ramp = through(&[(0.0, 0.0), (start, 0.0), (2.0 * start, 100.0 * start)]);
        for chi in [CHI, 1.5e-3, 0.1, 1.0].map(|chi| chi / start) {
            let (told, untold) =
                (joint(Patellofemoral, chi, &ramp), joint(Patellofemoral, chi, Unannounced(&ramp)));
            for t in [1.5, 2.01, 3.0, 7.0, 30.0].map(|share| share * start) {
                let (told, untold) = (told.at(t)?, untold.at(t)?);
                for share in [0.0, 0.01, 0.5] {
                    let r = share * told.radius();
                    let allowed = 2.0 * budget::PRESSURE.double * edge(1.0, share) * f64::EPSILON;
                    assert_near(untold.pressure(r), told.pressure(r), allowed);
                }
            }
        }
    }
    Ok(())
}
