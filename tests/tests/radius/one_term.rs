//! Contact radii of a single term whose coefficient is a field of the struct, of any size.

use cartcontact::{RadiusError, gap_profile};
use tests::budget;
use tests::inversion::Inversion;
use tests::measure::{Errors, Exact, ulps};
use tests::random::Stream;

use super::checks::{
    assert_same_in_other_units, assert_slices_are_right, exact_radius, load_integrals_of_any_size,
};

macro_rules! terms {
    ($($name:ident: $exponent:literal, $gap:expr;)*) => {
        $(
            #[gap_profile($gap)]
            struct $name<T> {
                c: T,
            }
        )*

        const KINDS: &[Kind] = &[$(Kind {
            exponent: $exponent,
            double: |c| Box::new($name { c }),
            single: |c| Box::new($name { c }),
        }),*];
    };
}

// The cases are a root, tables by whole periods of 5 to 64 octaves, and one whose period is longer than a table.
terms! {
    Root: 0.5, c * r^0.5;
    Cone: 1.0, c * r;
    Third: 1.5, c * r^1.5;
    Paraboloid: 2.0, c * r^2;
    Eighth: 2.375, c * r^2.375;
    Quarter: 2.75, c * r^2.75;
    Cubic: 3.0, c * r^3;
    Longest: 60.0, c * r^60;
    TooLong: 61.0, c * r^61;
}

struct Kind {
    exponent: f64,
    double: fn(f64) -> Box<dyn Inversion<f64>>,
    single: fn(f32) -> Box<dyn Inversion<f32>>,
}

impl Kind {
    fn exact(&self, c: f64, load_integral: f64) -> Exact {
        exact_radius(&[(c, self.exponent)], load_integral)
    }

    /// A coefficient and a load integral of any size that leaves the radius within 10^±`decades`.
    fn scene(&self, stream: &mut Stream, decades: f64, largest: f64) -> (f64, f64) {
        let radius = stream.magnitude(-decades, decades).log10();
        let most = largest - (self.exponent + 4.0) * decades;
        let c = stream.magnitude(-most, most);
        (c, c * 10f64.powf((self.exponent + 4.0) * radius))
    }
}

#[test]
fn radii_are_exact_for_a_coefficient_of_any_size() {
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(1, index);
        for _ in 0..100 {
            let (c, load_integral) = kind.scene(&mut stream, 4.0, 290.0);
            let found = (kind.double)(c).radius(load_integral).unwrap_or(f64::NAN);
            let place = (kind.exponent, c, load_integral);
            errors.add(found, kind.exact(c, load_integral), 1.0, &place);

            let (c, load_integral) = kind.scene(&mut stream, 0.4, 32.0);
            let (c, load_integral) = (c as f32, load_integral as f32);
            let found = (kind.single)(c).radius(load_integral).unwrap_or(f32::NAN);
            let place = (kind.exponent, c, load_integral);
            errors_of_single.add(found.into(), kind.exact(c.into(), load_integral.into()), 1.0, &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn other_units_change_no_digit() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(2, index);
        for _ in 0..1000 {
            let (c, load_integral) = kind.scene(&mut stream, 1.0, 100.0);
            let profile = (kind.double)(c);
            let place = (kind.exponent, c);
            let size = stream.power_of_two(500);
            let larger = (kind.double)(c * size);
            assert_same_in_other_units([&*profile, &*larger], load_integral, [1.0, size], &place);
            // A power of 16, so that its powers with quarters in the exponent are powers of two; eighths are not.
            let length = 16f64.powi(stream.below(3) as i32 - 1);
            if (4.0 * kind.exponent).fract() == 0.0 {
                let longer = (kind.double)(c * length.powf(-kind.exponent));
                assert_same_in_other_units([&*profile, &*longer], load_integral, [length, 1.0], &place);
            }
        }
    }
}

#[test]
fn no_digit_is_lost_next_to_the_ends_of_a_format() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(4, index);
        for _ in 0..1000 {
            let [c, load_integral] = [(); 2].map(|()| stream.between(1.0, 2.0));
            let radius = (kind.double)(c).radius_within(load_integral, f64::INFINITY);
            for size in [2f64.powi(-1021), 2f64.powi(1022)] {
                let found = (kind.double)(c * size).radius_within(load_integral * size, f64::INFINITY);
                assert_eq!(found, radius, "{}, {c:e}, {load_integral:e}, {size:e}", kind.exponent);
            }
            let [c, load_integral] = [c, load_integral].map(|number| number as f32);
            let radius = (kind.single)(c).radius_within(load_integral, f32::INFINITY);
            for size in [2f32.powi(-125), 2f32.powi(126)] {
                let found = (kind.single)(c * size).radius_within(load_integral * size, f32::INFINITY);
                assert_eq!(found, radius, "{}, {c:e}, {load_integral:e}, {size:e}", kind.exponent);
            }
        }
    }
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(3, index);
        let c = stream.magnitude(-3.0, 3.0);
        let (profile, single) = ((kind.double)(c), (kind.single)(c as f32));
        let load_integrals = load_integrals_of_any_size(&mut stream, 90.0);
        assert_slices_are_right((&*profile, &*single), &load_integrals, &kind.exponent);
    }
}

#[test]
fn the_end_of_the_range_is_inside() {
    for kind in KINDS {
        let profile = (kind.double)(0.03);
        let end = profile.load_integral(5.0);
        let found = profile.radius_within(end, 5.0).unwrap_or(f64::NAN);
        // J is rounded too, and its degree divides that error.
        let allowed = budget::RADIUS.double + budget::LOAD_INTEGRAL.double / 4.0;
        assert!(ulps(found, 5.0.into(), f64::EPSILON) <= allowed, "{}: {found:e}", kind.exponent);
        let beyond = profile.radius_within(end * 1.000_001, 5.0);
        assert!(matches!(beyond, Err(RadiusError::BeyondRange { max_radius: 5.0, .. })), "{beyond:?}");
    }
}
