//! Contact radii of geometries whose fields only set their units, and of some that look alike: all have more than two
//! terms, and the former have one table for all values.

use cartcontact::gap_profile;
use tests::budget;
use tests::measure::Errors;
use tests::random::Stream;

use super::checks::{assert_same_in_other_units, assert_slices_are_right, exact_radius};
use super::two_fields::{OfTwoFields, of_two_fields};

#[gap_profile(sphere(radius), order = 6)]
struct Ball<T> {
    radius: T,
}

#[gap_profile(conic(radius, -0.4), order = 8)]
struct Ellipsoid<T> {
    radius: T,
}

#[gap_profile(stiffness * (0.02 * r^2 + 1e-4 * r^4 + 2e-6 * r^6))]
struct Scaled<T> {
    stiffness: T,
}

#[gap_profile(k * (r^2 + r^3 / radius + r^4 / radius^2), positive)]
struct Odd<T> {
    k: T,
    radius: T,
}

#[gap_profile(k * (r^2 + r^2.5 / radius + r^3 / radius^2), positive)]
struct Halves<T> {
    k: T,
    radius: T,
}

/// The second term changes its sign with the radius.
#[gap_profile(k * (r^2 + r^3 / radius + r^4 / radius^2))]
struct Turned<T> {
    k: T,
    radius: T,
}

const KINDS: [OfTwoFields; 6] = [
    of_two_fields!(|_k, radius| Ball { radius }),
    of_two_fields!(|_k, radius| Ellipsoid { radius }),
    of_two_fields!(|stiffness, _radius| Scaled { stiffness }),
    of_two_fields!(|k, radius| Odd { k, radius }),
    of_two_fields!(|k, radius| Halves { k, radius }),
    of_two_fields!(|k, radius| Turned { k, radius: -radius }),
];

#[test]
fn radii_are_exact_for_fields_of_any_size() {
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(1, index);
        for _ in 0..300 {
            // The sizes reach both ends of the table and beyond.
            let (k, radius) = (stream.magnitude(-4.0, 4.0), stream.magnitude(-2.0, 2.0));
            let size = radius * stream.magnitude(-3.5, 1.0);
            let (terms, profile) = (kind.double)(k, radius);
            let load_integral = profile.load_integral(size);
            let found = profile.radius(load_integral).unwrap_or(f64::NAN);
            let place = format!("{index}: {k:e}, {radius:e}, {load_integral:e}");
            errors.add(found, exact_radius(&terms, load_integral), 1.0, &place);

            let (k, radius, size) = (k.sqrt() as f32, radius.sqrt() as f32, (size / radius.sqrt()) as f32);
            let (terms, profile) = (kind.single)(k, radius);
            let load_integral = profile.load_integral(size);
            let found = profile.radius(load_integral).unwrap_or(f32::NAN);
            let place = format!("{index}: {k:e}, {radius:e}, {load_integral:e}");
            errors_of_single.add(f64::from(found), exact_radius(&terms, load_integral.into()), 1.0, &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn other_units_change_no_digit() {
    let mut stream = Stream::of_case(2, 0);
    for _ in 0..2000 {
        let (k, radius) = (stream.magnitude(-4.0, 4.0), stream.magnitude(-2.0, 2.0));
        let load_integral = k * radius.powi(6) * stream.magnitude(-15.0, 2.0);
        let length = stream.power_of_two(20);
        let (_, ball) = (KINDS[0].double)(k, radius);
        let (_, larger) = (KINDS[0].double)(k, radius * length);
        // The coefficients are C/lengthⁿ⁻¹, and so those of another unit of r times `length`.
        assert_same_in_other_units([&*ball, &*larger], load_integral, [length, length], &(k, radius));
    }
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(&KINDS) {
        let mut stream = Stream::of_case(3, index);
        let (_, profile) = (kind.double)(0.3, 20.0);
        let sizes = (0..500).map(|_| 20.0 * stream.magnitude(-3.5, 1.0));
        let load_integrals: Vec<f64> = sizes.map(|size| profile.load_integral(size)).collect();
        let (_, single) = (kind.single)(0.3, 20.0);
        assert_slices_are_right((&*profile, &*single), &load_integrals, &index);
    }
}
