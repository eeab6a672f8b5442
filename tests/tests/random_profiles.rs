//! Random geometries and histories against the oracle; they are the same in every run.

use cartcontact::{Contact, GapProfile, Medium, gap_profile};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use tests::budget;
use tests::condition::{self, of_sizes};
use tests::kernel;
use tests::loads::{Knots, through};
use tests::measure::{Errors, Exact};
use tests::oracle::{Oracle, Profile, double, rounded};
use tests::planted;
use tests::profiles::{DECIMALS, Decimals, Hertzian52};
use tests::random::{magnitude, sum};
use tests::reference::number;

type Terms = Vec<(f64, f64)>;

/// Multiples of 1/4 from 1/4 to 12 and whole numbers up to 64, small ones more often.
fn quarters() -> impl Strategy<Value = f64> {
    let quarters = |range: core::ops::RangeInclusive<u32>| range.prop_map(|count| f64::from(count) / 4.0);
    prop_oneof![3 => quarters(1..=16), 2 => quarters(4..=48), 1 => (12..=64).prop_map(f64::from)]
}

/// A geometry of up to `most` terms, each between 1e-3 and 1e3 at the radius 2, every third one negative if the
/// geometry stays admissible; and the largest contact radius of interest.
fn geometries(exponents: impl Strategy<Value = f64>, most: usize) -> impl Strategy<Value = (Terms, f64)> {
    let term = (magnitude(-3.0..3.0), exponents, 0..3_u8);
    proptest::collection::vec(term, 1..=most).prop_map(|terms| {
        let positive: Terms = terms.iter().map(|&(size, n, _)| (size / 2_f64.powf(n), n)).collect();
        let mixed =
            terms.iter().zip(&positive).map(|(&(_, _, sign), &(c, n))| (if sign == 0 { -c } else { c }, n));
        let mixed: Terms = mixed.collect();
        match cartcontact::Polynomial::new(mixed.clone()) {
            Ok(profile) if profile.max_radius() > 0.1 => (mixed, (0.9 * profile.max_radius()).min(8.0)),
            _ => (positive, 8.0),
        }
    })
}

/// The values of a strategy, the same in every run.
fn samples<S: Strategy>(strategy: &S, count: usize) -> Vec<S::Value> {
    let mut runner = TestRunner::deterministic();
    let sample = |_| strategy.new_tree(&mut runner).map(|tree| tree.current());
    (0..count).map(sample).collect::<Result<_, _>>().unwrap_or_else(|error| unreachable!("{error}"))
}

/// Compares all kernels at a few places of a geometry.
fn compare_kernels(
    errors: &mut [Errors; 6],
    profile: &dyn GapProfile<f64>,
    sizes: &dyn GapProfile<f64>,
    oracle: &Profile,
    places: &[(f64, f64)],
    name: &dyn core::fmt::Debug,
) {
    for &(a, depth) in places {
        let r = a * (1.0 - depth);
        for (kernel, errors) in kernel::ALL.into_iter().zip(errors.iter_mut()) {
            let expected = Exact::from(&(kernel.oracle)(oracle, &double(a), &double(r)));
            if expected.nearest != 0.0 {
                let condition = kernel.condition(sizes, (a, r), expected.nearest);
                errors.add((kernel.double)(profile, a, r), expected, condition, &(name, a, r));
            }
        }
    }
}

/// A contact radius up to `largest` and 1 − r/a from 1 to 1e-12.
fn places(largest: f64) -> impl Strategy<Value = Vec<(f64, f64)>> {
    let share = (magnitude(-2.0..0.0), prop_oneof![1 => Just(1.0), 6 => magnitude(-12.0..0.0)]);
    proptest::collection::vec(share, 4)
        .prop_map(move |places| places.into_iter().map(|(share, depth)| (largest * share, depth)).collect())
}

fn check_kernels(geometries: &[(Terms, f64)]) {
    let mut errors = kernel::errors();
    let all_places = samples(&places(1.0), geometries.len());
    for ((terms, largest), places) in geometries.iter().zip(all_places) {
        let oracle = Profile::of(terms);
        let places: Vec<(f64, f64)> =
            places.into_iter().map(|(share, depth)| (largest * share, depth)).collect();
        compare_kernels(&mut errors, &sum(terms.clone()), &of_sizes(terms), &oracle, &places, terms);
    }
    errors.iter().for_each(Errors::check);
}

#[test]
fn kernels_of_random_profiles_are_those_of_the_oracle() {
    check_kernels(&samples(&geometries(quarters(), 6), 60));
}

#[test]
fn kernels_of_powers_without_roots_are_those_of_the_oracle() {
    check_kernels(&samples(&geometries(0.25..16.0, 2), 12));
}

/// Forms of generated code that the reference geometries do not have.
mod shapes {
    use super::gap_profile;

    #[gap_profile(0.3 * r^0.25 + 0.01 * r^2)]
    pub(super) struct Needle;
    #[gap_profile(0.02 * r^7 + 1e-3 * r^9)]
    pub(super) struct OddPowers;
    #[gap_profile(0.1*r^2 + 1e-3*r^3 + 1e-4*r^4 + 1e-5*r^5 + 1e-6*r^6)]
    pub(super) struct Dense;
    #[gap_profile(0.01*r^2 + 1e-5*r^6 + 1e-9*r^10)]
    pub(super) struct Sparse;
    #[gap_profile(0.04*r^2 - 1e-3*r^3 + 5e-5*r^4 - 4e-7*r^5 + 1e-8*r^6)]
    pub(super) struct Alternating;
    #[gap_profile(0.02*r + 1e-30 * r^40)]
    pub(super) struct FarApart;
    // Neither these exponents nor those of J are exact in f64.
    #[gap_profile(0.03 * r^2.3)]
    pub(super) struct Decimal;
    #[gap_profile(1e-7 * r^17.3)]
    pub(super) struct HighDecimal;
    // Multiples of 1/2: beside whole powers, with a negative term, and with a slope that is no polynomial.
    #[gap_profile(0.02 * r^2.5 + 1e-4 * r^4)]
    pub(super) struct Half;
    #[gap_profile(0.02 * r^1.5 + 1e-3 * r^2 + 2e-5 * r^5.5)]
    pub(super) struct Halves;
    #[gap_profile(0.02 * r^2 - 1e-3 * r^2.5 + 2e-5 * r^4)]
    pub(super) struct NegativeHalf;
    #[gap_profile(0.2 * r^0.5 + 0.01 * r^2)]
    pub(super) struct Root;
    // Multiples of 1/4: of every fraction, and without any that is a multiple of 1/2.
    #[gap_profile(0.02 * r^1.25 + 1e-3 * r^1.5 + 2e-3 * r^1.75 + 1e-4 * r^3)]
    pub(super) struct Quarters;
    #[gap_profile(0.01 * r^2.75 + 1e-4 * r^5.25)]
    pub(super) struct OddQuarters;
}

/// A generated solver and the terms of its geometry as decimals.
type Shape = (&'static dyn GapProfile<f64>, &'static [(&'static str, &'static str)]);

const SHAPES: [Shape; 16] = [
    (&shapes::Needle, &[("0.3", "0.25"), ("0.01", "2")]),
    (&shapes::OddPowers, &[("0.02", "7"), ("1e-3", "9")]),
    (&shapes::Dense, &[("0.1", "2"), ("1e-3", "3"), ("1e-4", "4"), ("1e-5", "5"), ("1e-6", "6")]),
    (&shapes::Sparse, &[("0.01", "2"), ("1e-5", "6"), ("1e-9", "10")]),
    (&shapes::Alternating, &[("0.04", "2"), ("-1e-3", "3"), ("5e-5", "4"), ("-4e-7", "5"), ("1e-8", "6")]),
    (&shapes::FarApart, &[("0.02", "1"), ("1e-30", "40")]),
    (&shapes::Decimal, &[("0.03", "2.3")]),
    (&Decimals, &DECIMALS),
    (&shapes::HighDecimal, &[("1e-7", "17.3")]),
    (&Hertzian52, &[("0.03", "2.5")]),
    (&shapes::Half, &[("0.02", "2.5"), ("1e-4", "4")]),
    (&shapes::Halves, &[("0.02", "1.5"), ("1e-3", "2"), ("2e-5", "5.5")]),
    (&shapes::NegativeHalf, &[("0.02", "2"), ("-1e-3", "2.5"), ("2e-5", "4")]),
    (&shapes::Root, &[("0.2", "0.5"), ("0.01", "2")]),
    (&shapes::Quarters, &[("0.02", "1.25"), ("1e-3", "1.5"), ("2e-3", "1.75"), ("1e-4", "3")]),
    (&shapes::OddQuarters, &[("0.01", "2.75"), ("1e-4", "5.25")]),
];

#[test]
fn kernels_of_generated_solvers_are_those_of_the_oracle() {
    let mut errors = kernel::errors();
    for (solver, terms) in SHAPES {
        let oracle = Profile::of_decimals(terms);
        let numbers: Terms = terms.iter().map(|(c, n)| (number(c), number(n))).collect();
        let sizes = of_sizes(&numbers);
        let places: Vec<(f64, f64)> = samples(&places(8.0), 40).concat();
        compare_kernels(&mut errors, solver, &sizes, &oracle, &places, &terms);
    }
    errors.iter().for_each(Errors::check);
}

/// A history with a given contact radius at the time of interest.
#[derive(Clone, Debug)]
struct Scene {
    terms: Terms,
    radius: f64,
    depth: f64,
    chi: f64,
    knots: Vec<(f64, f64)>,
    time: f64,
}

/// χ t from 0 to 200; constant loads, ramps, steps and slow falls.
fn scenes(geometries: impl Strategy<Value = (Terms, f64)>) -> impl Strategy<Value = Scene> {
    let depth = prop_oneof![1 => Just(1.0), 3 => magnitude(-12.0..0.0)];
    let folds = prop_oneof![1 => Just(0.0), 6 => magnitude(-3.0..2.3)];
    let history = (0..5_u8, magnitude(-2.0..2.0), magnitude(-1.0..1.0), 0.1..1.0);
    (geometries, magnitude(-1.3..0.0), depth, magnitude(-4.0..1.0), folds, history).prop_map(
        |((terms, largest), share, depth, chi, folds, (kind, force, factor, when))| {
            let time = folds / chi;
            let knot = when * time.max(0.1 / chi);
            let knots = match kind {
                0 => vec![(0.0, force)],
                1 => vec![(0.0, 0.0), (knot, force)],
                2 => vec![(0.0, force), (knot, force * (1.0 + factor))],
                3 => vec![(0.0, force), (knot, force), (knot, force * (1.0 + factor))],
                // F′ + χ F = F (χ − (1 − s)/knot) with 1 − s below χ knot times s.
                _ => vec![(0.0, force), (knot, force / (1.0 + 0.5 * chi * knot)), (2.0 * knot, force)],
            };
            // Under a load that begins at zero there is no contact at time 0.
            let time = if kind == 1 && time == 0.0 { 0.3 * knot } else { time };
            Scene { terms, radius: largest * share, depth, chi, knots, time }
        },
    )
}

impl Scene {
    fn load(&self) -> Knots {
        through(&self.knots)
    }

    /// The stiffness that gives the contact radius.
    fn m(&self, profile: &dyn GapProfile<f64>) -> f64 {
        planted::stiffness(profile, &self.load(), self.chi, self.radius, self.time)
    }
}

/// Compares the contacts of solvers for the geometries of scenes.
fn check_contacts(scenes: impl IntoIterator<Item = (Scene, Box<dyn GapProfile<f64>>, Profile)>) {
    let mut radius = Errors::of(budget::CONTACT_RADIUS);
    let mut approach = Errors::of(budget::CONTACT_APPROACH);
    let (mut pressure, mut peak) = (Errors::of(budget::PRESSURE), Errors::of(budget::PEAK_PRESSURE));
    for (scene, profile, exact) in scenes {
        let (m, r) = (scene.m(&*profile), scene.radius * (1.0 - scene.depth));
        let oracle = Oracle::new(exact, m, scene.chi, &scene.knots);
        let found = || {
            let contact = Contact::new(&*profile, Medium::from_constants(m, scene.chi)?, scene.load())?;
            let now = contact.at(scene.time)?;
            Ok((now.radius(), now.approach(), now.pressure(r), now.peak_pressure()))
        };
        let found =
            found().unwrap_or_else(|error: Box<dyn core::error::Error>| unreachable!("{scene:?}: {error}"));
        let exact_radius = oracle.radius(scene.time);
        let a = rounded(&exact_radius);
        let condition = condition::of_radius(&*profile, &of_sizes(&scene.terms), a);
        let of_approach = condition::of_approach(&*profile, a);
        radius.add(found.0, &exact_radius, condition, &scene);
        approach.add(found.1, &oracle.approach(scene.time), condition * of_approach, &scene);
        let [exact_pressure, exact_peak] = oracle.pressures([r, 0.0], scene.time);
        let distance = rounded(&(exact_radius - double(r)));
        if distance > 0.0 {
            pressure.add(found.2, &exact_pressure, condition::edge_at(a, distance), &scene);
        }
        peak.add(found.3, &exact_peak, 1.0, &scene);
    }
    radius.check();
    approach.check();
    pressure.check();
    peak.check();
}

#[test]
fn contacts_of_random_profiles_are_those_of_the_oracle() {
    check_contacts(at_run_time(samples(&scenes(geometries(quarters(), 6)), 24)));
}

#[test]
fn contacts_of_powers_without_roots_are_those_of_the_oracle() {
    check_contacts(at_run_time(samples(&scenes(geometries(0.25..8.0, 2)), 2)));
}

/// Scenes with run-time polynomials.
fn at_run_time(scenes: Vec<Scene>) -> impl Iterator<Item = (Scene, Box<dyn GapProfile<f64>>, Profile)> {
    scenes.into_iter().map(|scene| {
        let (solver, exact) = (sum(scene.terms.clone()), Profile::of(&scene.terms));
        (scene, Box::new(solver) as Box<dyn GapProfile<f64>>, exact)
    })
}

#[test]
fn contacts_of_multiples_of_a_quarter_are_those_of_the_oracle() {
    let is_quarter = |n: &str| n.contains('.') && n.ends_with('5');
    let is_fractional = |&&(_, terms): &&Shape| terms.iter().any(|(_, n)| is_quarter(n));
    let all = SHAPES.iter().filter(is_fractional);
    let scenes = all.flat_map(|&(solver, terms)| {
        let numbers: Terms = terms.iter().map(|(c, n)| (number(c), number(n))).collect();
        let scenes = samples(&scenes(Just((numbers, 8.0))), 4);
        scenes.into_iter().map(move |scene| {
            (scene, Box::new(solver) as Box<dyn GapProfile<f64>>, Profile::of_decimals(terms))
        })
    });
    check_contacts(scenes);
}
