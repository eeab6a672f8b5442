//! Derivatives of pressures with respect to the rate of drainage where it is zero.
//!
//! Pressures then depend on when the contact reached a radius, which their values do not.

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, GapProfile, Medium, Scalar};
use derivatives::{curvature, slope};
use num_dual::Dual2_64;
use tests::joint::pressures_each_way;
use tests::profiles::{Blunt, Patellofemoral};

type Failure = Box<dyn core::error::Error>;

/// Held, rising at once, rising from nothing, held before a step and before a rise, and a record.
const LOADS: [&[(f64, f64)]; 6] = [
    &[(0.0, 100.0)],
    &[(0.0, 20.0), (100.0, 100.0)],
    &[(0.0, 0.0), (100.0, 100.0)],
    &[(0.0, 50.0), (50.0, 50.0), (50.0, 100.0)],
    &[(0.0, 50.0), (50.0, 50.0), (60.0, 100.0)],
    &[(0.0, 50.0), (10.0, 60.0), (20.0, 65.0), (90.0, 80.0), (300.0, 90.0)],
];

/// Among them times at knots.
const TIMES: [f64; 4] = [40.0, 50.0, 100.0, 150.0];

/// Distances from the axis as shares of the contact radius without drainage.
const SHARES: [f64; 4] = [0.0, 0.3, 0.7, 0.98];

/// The differences of χ t for first and for second derivatives.
const STEPS: [f64; 2] = [1e-3, 5e-3];

/// How far derivatives may be from differences, as a share of P(0, t) t and of P(0, t) t²: differences magnify the
/// rounding of pressures by some thousand and by some million. The worst are 1.9e-12 and 2.5e-8.
const ALLOWED: [f64; 2] = [5e-12, 6e-8];

/// The pressures at a time, at all radii [each way](pressures_each_way).
fn pressures<T: Scalar>(
    profile: &impl GapProfile<T>,
    chi: T,
    knots: &[(f64, f64)],
    time: f64,
) -> Result<Vec<T>, Failure> {
    let knots = knots.iter().map(|&(time, force)| (T::constant(time), T::constant(force)));
    let medium = Medium::from_constants(T::constant(0.375), chi)?;
    let load = PiecewiseLinear::new(knots.collect::<Vec<_>>())?;
    let undrained = Medium::from_constants(medium.m(), T::zero())?;
    let edge = Contact::new(profile, undrained, &load)?.at(T::constant(time))?.radius();
    let radii = SHARES.map(|share| edge * T::constant(share));
    Ok(pressures_each_way(&Contact::new(profile, medium, load)?, time, &radii)?)
}

fn check<P: GapProfile<Dual2_64> + GapProfile<f64>>(profile: &P) -> Result<(), Failure> {
    for knots in LOADS {
        for time in TIMES {
            let dual = pressures(profile, Dual2_64::from_re(0.0).derivative(), knots, time)?;
            let at = |rate: f64| pressures(profile, rate, knots, time);
            let [first, second] = STEPS.map(|folds| folds / time);
            let values = [at(0.0)?, at(first)?, at(2.0 * first)?, at(3.0 * first)?, at(4.0 * first)?];
            let far =
                [at(second)?, at(2.0 * second)?, at(3.0 * second)?, at(4.0 * second)?, at(5.0 * second)?];
            for (place, dual) in dual.into_iter().enumerate() {
                let slope = slope(values.each_ref().map(|values| values[place]), first);
                let [one, two, three, four, five] = far.each_ref().map(|values| values[place]);
                let curvature = curvature([values[0][place], one, two, three, four, five], second);
                let scale = values[0][0] * time;
                let errors = [(dual.v1 - slope).abs() / scale, (dual.v2 - curvature).abs() / (scale * time)];
                let are_near = errors.iter().zip(ALLOWED).all(|(&error, allowed)| error <= allowed);
                assert!(are_near, "{knots:?}, {time} s, {place}: {dual} instead of {slope}, {curvature}");
            }
        }
    }
    Ok(())
}

#[test]
fn derivatives_with_respect_to_a_rate_of_zero_are_those_of_differences() -> Result<(), Failure> {
    check(&Patellofemoral)?;
    check(&Blunt)
}
