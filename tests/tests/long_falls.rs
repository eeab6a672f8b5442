//! Loads of a user's own, in single precision, that fall by many e-foldings: what is left of the pressures is small
//! beside the rounding of those that were.

use cartcontact::load::Load;
use cartcontact::{ContactError, GapProfile};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::measure::ulps;
use tests::profiles::{Cone, Paraboloid, Patellofemoral, Quartic};
use tests::random::Stream;

/// A load that falls exponentially and is held from some time on: in double precision, and rounded to single
/// precision, so that no exponent is rounded in the force.
#[derive(Clone, Copy, Debug)]
struct FallAndHold {
    force: f64,
    rate: f64,
    end_of_fall: f32,
}

impl Load<f64> for FallAndHold {
    fn force(&self, t: f64) -> f64 {
        self.force * (-self.rate * t.min(self.end_of_fall.into())).exp()
    }

    fn impulse(&self, t: f64) -> f64 {
        let falling = t.min(self.end_of_fall.into());
        -self.force * (-self.rate * falling).exp_m1() / self.rate + (t - falling) * self.force(t)
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        Some(f64::from(self.end_of_fall)).filter(|&knot| t < knot)
    }
}

impl Load<f32> for FallAndHold {
    fn force(&self, t: f32) -> f32 {
        Load::<f64>::force(self, t.into()) as f32
    }

    fn impulse(&self, t: f32) -> f32 {
        Load::<f64>::impulse(self, t.into()) as f32
    }

    fn next_knot(&self, t: f32) -> Option<f32> {
        Some(self.end_of_fall).filter(|&knot| t < knot)
    }
}

/// Compares pressures in single precision with those in double precision, at radii covered from the start and later.
fn compare<P>(profile: P, load: FallAndHold, chi: f32, t: f32) -> Result<(), ContactError>
where
    P: GapProfile<f32> + GapProfile<f64> + Copy,
{
    let single = joint::<f32, _, _>(profile, chi.into(), load);
    let double = joint::<f64, _, _>(profile, chi.into(), load);
    let (start, now, exact) = (single.at(0.0)?.radius(), single.at(t)?, double.at(t.into())?);
    let a = now.radius();
    for r in [0.0, 0.5 * a, 0.9 * a, 0.99 * start, start + 0.3 * (a - start), start + 0.7 * (a - start)] {
        let allowed = if r > 0.0 {
            budget::PRESSURE.single * edge(exact.radius(), r.into())
        } else {
            budget::PEAK_PRESSURE.single
        };
        let expected = exact.pressure(r.into());
        let error = ulps(now.pressure(r).into(), expected.into(), f64::from(f32::EPSILON));
        assert!(
            error <= allowed || r >= a,
            "{load:?}, χ = {chi}, t = {t}, r = {r}: {error} of {allowed} ulp"
        );
    }
    Ok(())
}

/// A few hundred scenes that end after 8 to 40 e-foldings, of which the load falls for a share.
fn compare_falls(seed: u64, lasting: core::ops::Range<f64>) -> Result<(), ContactError> {
    for case in 0..400 {
        let mut stream = Stream::of_case(seed, case);
        let chi = stream.magnitude(-4.0, 1.0) as f32;
        let folds = stream.between(8.0, 40.0);
        // From half as fast as e^(−χ t) to a rounding less than it.
        let slowness = stream.magnitude(-7.0, -0.3);
        let load = FallAndHold {
            force: stream.magnitude(0.0, 3.0),
            rate: f64::from(chi) * (1.0 - slowness),
            end_of_fall: (stream.between(lasting.start, lasting.end) * folds / f64::from(chi)) as f32,
        };
        let t = (folds / f64::from(chi)) as f32;
        match case % 4 {
            0 => compare(Paraboloid, load, chi, t),
            1 => compare(Patellofemoral, load, chi, t),
            2 => compare(Cone, load, chi, t),
            _ => compare(Quartic, load, chi, t),
        }?;
    }
    Ok(())
}

#[test]
fn pressures_after_long_falls_keep_their_digits() -> Result<(), ContactError> {
    compare_falls(1, 1.0..1.1)
}

#[test]
fn pressures_under_what_a_long_fall_leaves_keep_their_digits() -> Result<(), ContactError> {
    compare_falls(2, 0.3..1.0)
}
