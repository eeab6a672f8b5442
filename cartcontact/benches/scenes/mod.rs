//! The scenes that the benchmarks share, and the rivals: solvers by hand, and the paper's formulas as printed.
#![allow(dead_code, reason = "every benchmark uses a part of it")]

pub(crate) mod by_hand;
pub(crate) mod printed;

use std::hint::black_box;

use cartcontact::load::{Load, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, Medium, Polynomial, Scalar, gap_profile, load};

#[gap_profile(0.025 * r^2)]
pub(crate) struct Paraboloid;

#[gap_profile(0.1 * r)]
pub(crate) struct Cone;

#[gap_profile(0.015 * r^2.3)]
pub(crate) struct BluntBall;

#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
pub(crate) struct Patellofemoral;

#[gap_profile(0.02 * r^2 + 1e-4 * r^4 + 2e-6 * r^6)]
pub(crate) struct ThreeTerm;

#[gap_profile(0.02 * r^2 + 1e-4 * r^4 + 2e-6 * r^6 + 3e-8 * r^8)]
pub(crate) struct FourTerm;

/// A ball on a plane, to second order.
#[gap_profile(r^2 / (2 * radius))]
pub(crate) struct FlatBall<T> {
    pub(crate) radius: T,
}

/// A ball on a plane, in powers of r up to the fourth.
#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3))]
pub(crate) struct Ball<T> {
    pub(crate) radius: T,
}

/// A ball on a plane, in powers of r up to the sixth.
#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3) + r^6 / (16 * radius^5))]
pub(crate) struct RoundBall<T> {
    pub(crate) radius: T,
}

/// Three terms, each with a field of its own.
#[gap_profile(b * r^2 + c * r^4 + d * r^6)]
pub(crate) struct ThreeFields<T> {
    pub(crate) b: T,
    pub(crate) c: T,
    pub(crate) d: T,
}

/// Three terms, each with a field of its own, whose powers are multiples of 1/2.
#[gap_profile(b * r^2.5 + c * r^4 + d * r^5)]
pub(crate) struct ThreeFieldsOfHalves<T> {
    pub(crate) b: T,
    pub(crate) c: T,
    pub(crate) d: T,
}

/// Powers that are not whole.
#[gap_profile(0.02 * r^1.5 + 1e-4 * r^3.25)]
pub(crate) struct Blunt;

/// Powers that are no small fractions.
#[gap_profile(0.02 * r^2.37 + 1e-4 * r^4.11)]
pub(crate) struct Fitted;

/// The profile of [`Patellofemoral`], known at run time only.
pub(crate) type RunTime = Polynomial<f64, [(f64, f64); 2]>;

/// Why benchmarks check the results that they measure.
pub(crate) const NO_RESULT: &str = "the time that an error takes is no result";

pub(crate) const FORCE: f64 = 100.0;
pub(crate) const RATE: f64 = 0.0015;
pub(crate) const STIFFNESS: f64 = 0.375;

/// # Panics
///
/// Never: the constants are valid.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
pub(crate) fn run_time() -> RunTime {
    Polynomial::new([(0.025, 2.0), (1.09375e-4, 4.0)]).expect("a valid profile")
}

/// The paper's scene: 100 N on the patellofemoral joint.
pub(crate) fn contact<P: GapProfile<f64>>(profile: P) -> Contact<f64, P, load::Constant<f64>> {
    loaded(profile, RATE, load::Constant(FORCE))
}

/// A contact of the paper's layers with another rate of drainage.
///
/// # Panics
///
/// If one of the three is not valid.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
pub(crate) fn loaded<P: GapProfile<f64>, L: Load<f64>>(profile: P, rate: f64, load: L) -> Contact<f64, P, L> {
    let medium = Medium::from_constants(STIFFNESS, rate).expect("a valid medium");
    Contact::new(profile, medium, load).expect("a valid contact")
}

/// The paper's joint under a load with knots.
pub(crate) type Knotted = Contact<f64, Patellofemoral, PiecewiseLinear<f64, Vec<(f64, f64)>>>;

#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
fn knotted(rate: f64, knots: impl Iterator<Item = (f64, f64)>) -> Knotted {
    loaded(Patellofemoral, rate, PiecewiseLinear::new(knots.collect()).expect("a valid load"))
}

/// A load that rises through 100 knots, every second piece of which is level, in a medium with a rate of drainage.
pub(crate) fn hundred_knots(rate: f64) -> Knotted {
    knotted(rate, (0..100).map(|k| (2.0 * f64::from(k), FORCE * (0.2 + f64::from(k + k % 2) / 100.0))))
}

/// The same rise in fifty steps.
pub(crate) fn fifty_steps(rate: f64) -> Knotted {
    knotted(
        rate,
        (0..100).map(|k| (2.0 * f64::from(k + k % 2), FORCE * (0.2 + f64::from(k - k % 2) / 100.0))),
    )
}

/// A user-defined load that settles: 100 N − 80 N/(1 + t/40 s)².
pub(crate) struct Settling;

impl Load<f64> for Settling {
    fn force(&self, t: f64) -> f64 {
        let growth = 1.0 + t / 40.0;
        if t < 0.0 { 0.0 } else { 100.0 - 80.0 / (growth * growth) }
    }

    fn impulse(&self, t: f64) -> f64 {
        if t < 0.0 { 0.0 } else { 100.0 * t - 80.0 * t / (1.0 + t / 40.0) }
    }
}

/// One cold pressure: nothing is kept from an earlier call.
///
/// # Panics
///
/// If the scene has no solution at that time.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
pub(crate) fn pressure_at<P: GapProfile<f64>, L: Load<f64>>(
    contact: &Contact<f64, P, L>,
    t: f64,
    r: f64,
) -> f64 {
    contact.at(black_box(t)).expect("a solution").pressure(black_box(r))
}

/// Pressures of the paper's scene by the formulas as printed, with a rule of `nodes` nodes.
///
/// # Panics
///
/// If there are no nodes.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
pub(crate) fn as_printed(nodes: usize) -> printed::Pressure {
    printed::Pressure::with_order(nodes).expect("a rule with nodes")
}

/// 1024 load integrals spread over a load range of 1 : 1000, so that no branch is predicted from memory; they and
/// their radii fit into the nearest cache.
pub(crate) fn load_integrals<T: Scalar>() -> Vec<T> {
    (0..1024).map(|k| T::constant(10.0 * 1000f64.powf(f64::from(k * 389 % 1024) / 1023.0))).collect()
}

/// `count` values from 0 to `end`.
pub(crate) fn steps(count: usize, end: f64) -> Vec<f64> {
    (0..count).map(|k| end * k as f64 / (count - 1) as f64).collect()
}

/// 1024 times, in s.
pub(crate) fn times() -> Vec<f64> {
    (0..1024).map(f64::from).collect()
}

/// The contact radius by the general root finder of the crate `roots`, from the one-term radius.
///
/// # Panics
///
/// Never for a positive load integral.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
pub(crate) fn radius_by_roots(target: f64) -> f64 {
    printed::radius_of(target, printed::FULL).expect("convergence")
}
