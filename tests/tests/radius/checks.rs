//! What tests of radii share: the exact radius, geometries in both formats with the decades of their radii, and a
//! comparison of many radii at once with radii one by one.

use core::fmt::Debug;

use cartcontact::{RadiusError, Scalar};
use tests::budget;
use tests::inversion::Inversion;
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::random::Stream;

/// The radius at which J of the terms (C, n) is `load_integral`.
pub(super) fn exact_radius(terms: &[(f64, f64)], load_integral: f64) -> Exact {
    Exact::from(&Profile::of(terms).radius(&double(load_integral)))
}

/// Asserts that the radii of a slice are those of its load integrals one by one, to the last bit: in the given order, in
/// ascending order, and of six hundred close to the first.
pub(super) fn assert_same_one_by_one<T: Scalar>(
    profile: &dyn Inversion<T>,
    load_integrals: &[T],
    place: &dyn Debug,
) {
    let nan = T::constant(f64::NAN);
    let mut ascending = load_integrals.to_vec();
    ascending.sort_by(|x, y| x.value().total_cmp(&y.value()));
    let close = load_integrals.first().map_or(T::zero(), |&first| first);
    let close: Vec<T> = (0..600).map(|k| close * T::constant(0.999_f64.powi(k))).collect();
    for load_integrals in [load_integrals, &ascending, &close] {
        let mut radii = vec![nan; load_integrals.len()];
        assert_eq!(profile.radii(load_integrals, &mut radii), Ok(()), "{place:?}");
        let single = |&load_integral| profile.radius(load_integral).unwrap_or(nan);
        assert!(load_integrals.iter().map(single).eq(radii), "{place:?}");
    }
}

/// Random load integrals within 10^±`decades`, among them zero, a subnormal number and the largest one.
pub(super) fn load_integrals_of_any_size(stream: &mut Stream, decades: f64) -> Vec<f64> {
    let mut load_integrals: Vec<f64> = (0..600).map(|_| stream.magnitude(-decades, decades)).collect();
    load_integrals[70..73].copy_from_slice(&[0.0, f64::MIN_POSITIVE / 4.0, f64::MAX]);
    load_integrals
}

/// Asserts that slices have the radii that their load integrals have one by one, in both formats, and are refused for
/// one fault.
pub(super) fn assert_slices_are_right(
    (profile, single): (&dyn Inversion<f64>, &dyn Inversion<f32>),
    load_integrals: &[f64],
    place: &dyn Debug,
) {
    assert_same_one_by_one(profile, load_integrals, place);
    assert_same_one_by_one(single, &in_single(single, load_integrals), place);
    assert_one_fault_is_named(profile, load_integrals, place);
}

/// The load integrals in single precision that have a radius there.
pub(super) fn in_single(profile: &dyn Inversion<f32>, load_integrals: &[f64]) -> Vec<f32> {
    let single = load_integrals.iter().map(|&load_integral| load_integral as f32);
    single.filter(|&load_integral| profile.radius(load_integral).is_ok()).collect()
}

/// Asserts that a slice is refused for the one load integral in it that is negative or infinite, and with its value.
fn assert_one_fault_is_named(profile: &dyn Inversion<f64>, load_integrals: &[f64], place: &dyn Debug) {
    for bad in [-1.0, f64::INFINITY] {
        let mut load_integrals = load_integrals.to_vec();
        let middle = load_integrals.len() / 2;
        load_integrals[middle] = bad;
        let refused = profile.radii(&load_integrals, &mut vec![f64::NAN; load_integrals.len()]);
        assert_eq!(refused, Err(RadiusError::InvalidLoadIntegral { load_integral: bad }), "{place:?}");
    }
}

/// Asserts that a geometry in other units has the same radius, to the last bit: `other` has a unit of length `length`
/// times as small, so that a coefficient C is C/lengthⁿ, and coefficients that are also `size` times as large.
pub(super) fn assert_same_in_other_units(
    [profile, other]: [&dyn Inversion<f64>; 2],
    load_integral: f64,
    [length, size]: [f64; 2],
    place: &dyn Debug,
) {
    let radius = profile.radius(load_integral).unwrap_or(f64::NAN);
    let found = other.radius(load_integral * size * length.powi(4));
    assert_eq!(found, Ok(radius * length), "{place:?}, {load_integral:e}, {length:e}, {size:e}");
}

/// A geometry in both formats, with its terms (C, n) as written.
pub(super) struct Kind {
    /// In `f64`.
    pub(super) double: &'static dyn Inversion<f64>,
    /// In `f32`.
    pub(super) single: &'static dyn Inversion<f32>,
    /// The terms.
    pub(super) terms: &'static [(&'static str, &'static str)],
    /// The decades in which radii are drawn.
    pub(super) decades: [f64; 2],
}

impl Kind {
    /// The load integral of a random radius.
    fn load_integral(&self, stream: &mut Stream) -> f64 {
        let [from, to] = self.decades;
        self.double.load_integral(stream.magnitude(from, to))
    }
}

/// Asserts that random radii are within [`budget::RADIUS_OF_SUMS`] times the condition number at the radius.
pub(super) fn assert_exact(kinds: &[Kind], condition: impl Fn(&Kind, f64) -> f64) {
    let mut errors = Errors::of(budget::RADIUS_OF_SUMS);
    let mut errors_of_single = Errors::of_single(budget::RADIUS_OF_SUMS);
    for (index, kind) in (0..).zip(kinds) {
        let (oracle, mut stream) = (Profile::of_decimals(kind.terms), Stream::of_case(1, index));
        for _ in 0..200 {
            let load_integral = kind.load_integral(&mut stream);
            let place = (kind.terms, load_integral);
            let expected = Exact::from(&oracle.radius(&double(load_integral)));
            let found = kind.double.radius(load_integral).unwrap_or(f64::NAN);
            let condition = condition(kind, found);
            errors.add(found, expected, condition, &place);

            let single = load_integral as f32;
            if single.is_normal() {
                let expected = Exact::from(&oracle.radius(&double(single.into())));
                let found = kind.single.radius(single).unwrap_or(f32::NAN);
                errors_of_single.add(found.into(), expected, condition, &place);
            }
        }
    }
    errors.check();
    errors_of_single.check();
}

/// [`assert_slices_are_right`] for random load integrals.
pub(super) fn assert_random_slices_are_right(kinds: &[Kind]) {
    for (index, kind) in (0..).zip(kinds) {
        let mut stream = Stream::of_case(2, index);
        let load_integrals: Vec<f64> = (0..500).map(|_| kind.load_integral(&mut stream)).collect();
        assert_slices_are_right((kind.double, kind.single), &load_integrals, &kind.terms);
    }
}
