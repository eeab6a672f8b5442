//! Contact radii of geometries with symbolic coefficients, mostly three: they are exact for coefficients of any size,
//! the same in all units, and the same one by one and in a slice.

use cartcontact::gap_profile;
use tests::budget;
use tests::condition::{degree, of_sizes};
use tests::inversion::Inversion;
use tests::measure::{Errors, Exact, ulps};
use tests::oracle::number::{Real, whole};
use tests::oracle::{Profile, double};
use tests::random::Stream;

use super::checks::{
    assert_same_in_other_units, assert_same_one_by_one, assert_slices_are_right, exact_radius,
};

/// Structs of three fields and the kinds that they are.
macro_rules! kinds {
    ($($(#[$attribute:meta])* $name:ident: $exponents:expr, $gap:expr;)*) => {
        $(
            $(#[$attribute])*
            #[gap_profile($gap)]
            struct $name<T> {
                b: T,
                c: T,
                d: T,
            }
        )*

        const KINDS: &[Kind] = &[$(Kind {
            exponents: $exponents,
            double: |[b, c, d]| Box::new($name { b, c, d }),
            single: |[b, c, d]| Box::new($name { b, c, d }),
        }),*];
    };
}

kinds! {
    Dense: [2.0, 3.0, 4.0], b * r^2 + c * r^3 + d * r^4;
    Even: [2.0, 4.0, 6.0], b * r^2 + c * r^4 + d * r^6;
    /// Powers so far apart that the steps may not come near the root.
    Wide: [1.0, 4.0, 40.0], b * r + c * r^4 + d * r^40;
    Quarters: [1.5, 2.25, 4.0], b * r^1.5 + c * r^2.25 + d * r^4;
    Halves: [2.5, 4.0, 5.0], b * r^2.5 + c * r^4 + d * r^5;
    Eighths: [0.375, 2.125, 4.0], b * r^0.375 + c * r^2.125 + d * r^4;
    /// The common fraction is too small for a root.
    SixtyFourths: [99.0 / 64.0, 2.25, 4.0], b * r^(99/64) + c * r^2.25 + d * r^4;
}

#[gap_profile(c * r + d * r^30 + k * r^60, positive)]
struct Steep {
    c: f64,
    d: f64,
    k: f64,
}

/// A joint of two spheres with nearly the same radius.
#[gap_profile((1/head - 1/socket) * r^2 / 2 + (head^-3 - socket^-3) * r^4 / 8)]
struct Hip<T> {
    head: T,
    socket: T,
}

/// The same with radii of opposite signs, as curvatures are added in the literature.
#[gap_profile((1/head + 1/socket) * r^2 / 2 + (head^-3 + socket^-3) * r^4 / 8)]
struct Signed {
    head: f64,
    socket: f64,
}

/// The same with a liner in a shell.
#[gap_profile((1/head - 1/(shell - liner)) * r^2 / 2 + (head^-3 - (shell - liner)^-3) * r^4 / 8)]
struct Lined {
    head: f64,
    shell: f64,
    liner: f64,
}

/// A kind of geometry: its exponents, and its constructors from coefficients.
struct Kind {
    exponents: [f64; 3],
    double: fn([f64; 3]) -> Box<dyn Inversion<f64>>,
    single: fn([f32; 3]) -> Box<dyn Inversion<f32>>,
}

impl Kind {
    /// Coefficients with which all terms contribute to J within some decades of the radius `unit`.
    fn coefficients(&self, stream: &mut Stream, unit: f64) -> [f64; 3] {
        self.exponents.map(|n| stream.magnitude(-2.0, 2.0) / unit.powf(n - 1.0))
    }

    fn exact(&self, coefficients: [f64; 3], load_integral: f64) -> Exact {
        let terms: Vec<(f64, f64)> = coefficients.into_iter().zip(self.exponents).collect();
        exact_radius(&terms, load_integral)
    }
}

#[test]
fn radii_are_exact_for_coefficients_of_any_size() {
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(1, index);
        for _ in 0..200 {
            // Powers up to the 44th leave f64 where units are much larger or smaller, and f32 beyond those below.
            let unit = stream.magnitude(-3.0, 3.0);
            let coefficients = kind.coefficients(&mut stream, unit);
            let load_integral = stream.magnitude(-6.0, 6.0) * unit.powi(5);
            let found = (kind.double)(coefficients).radius(load_integral).unwrap_or(f64::NAN);
            let place = format!("{:?} {coefficients:?}, {load_integral:e}", kind.exponents);
            errors.add(found, kind.exact(coefficients, load_integral), 1.0, &place);

            let unit = stream.magnitude(-0.3, 0.3);
            let coefficients = kind.coefficients(&mut stream, unit).map(|c| c as f32);
            let load_integral = (stream.magnitude(-6.0, 6.0) * unit.powi(5)) as f32;
            let found = (kind.single)(coefficients).radius(load_integral).unwrap_or(f32::NAN);
            let exact = kind.exact(coefficients.map(f64::from), f64::from(load_integral));
            let place = format!("{:?} {coefficients:?}, {load_integral:e}", kind.exponents);
            errors_of_single.add(f64::from(found), exact, 1.0, &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

/// The radius of two spheres whose gap is expanded to the fourth order.
fn exact_radius_of_spheres(head: &Real, socket: &Real, load_integral: f64) -> Exact {
    let curvature = (whole(1) / head - whole(1) / socket) / whole(2);
    let fourth = (whole(1) / (head * head * head) - whole(1) / (socket * socket * socket)) / whole(8);
    let profile = Profile::of_numbers(vec![(curvature, whole(2)), (fourth, whole(4))]);
    Exact::from(&profile.radius(&double(load_integral)))
}

#[test]
fn differences_of_quotients_lose_no_digit() {
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    let mut stream = Stream::of_case(4, 0);
    for _ in 0..200 {
        let head = stream.between(10.0, 30.0);
        let load_integral = stream.magnitude(-2.0, 4.0);
        let mut add = |profile: &dyn Inversion<f64>, socket: Real, place: [f64; 3]| {
            let found = profile.radius(load_integral).unwrap_or(f64::NAN);
            errors.add(found, exact_radius_of_spheres(&double(head), &socket, load_integral), 1.0, &place);
        };
        let socket = head * (1.0 + stream.magnitude(-10.0, 0.0));
        add(&Hip { head, socket }, double(socket), [head, socket, load_integral]);
        add(&Signed { head, socket: -socket }, double(socket), [head, -socket, load_integral]);
        let other = head * stream.magnitude(-0.5, 0.5);
        add(&Signed { head, socket: other }, double(-other), [head, other, load_integral]);
        // The inner radius of a liner is a difference, and the sum over it cannot be factored.
        let liner = stream.between(3.0, 9.0);
        let shell = socket + liner;
        add(&Lined { head, shell, liner }, double(shell) - double(liner), [head, shell, liner]);

        let (head, load_integral) = (head as f32, load_integral as f32);
        let socket = head * (1.0 + stream.magnitude(-4.0, 0.0) as f32);
        let exact =
            exact_radius_of_spheres(&double(head.into()), &double(socket.into()), load_integral.into());
        let found = Hip { head, socket }.radius(load_integral).unwrap_or(f32::NAN);
        errors_of_single.add(found.into(), exact, 1.0, &(head, socket, load_integral));
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn a_plane_is_a_sphere_of_infinite_radius() {
    for head in [1e-3, 10.0, 2.5e3] {
        for load_integral in [1e-3, 1.0, 1e3].map(|share| share * head * head * head * head) {
            let found = Hip { head, socket: f64::INFINITY }.radius(load_integral);
            let terms = [(0.5 / head, 2.0), (0.125 / (head * head * head), 4.0)];
            let error = ulps(found.unwrap_or(f64::NAN), exact_radius(&terms, load_integral), f64::EPSILON);
            // The coefficients are rounded by up to 3 ε in all, of which the radius takes a sixth at most.
            assert!(error <= 2.0, "{head}, {load_integral}: {error} ulp");
        }
    }
}

#[test]
fn other_units_change_no_digit() {
    let is_of_eighths = |kind: &Kind| kind.exponents.iter().all(|n| (8.0 * n).fract() == 0.0);
    let is_low = |kind: &Kind| kind.exponents[2] <= 6.0;
    for (index, kind) in (0..).zip(KINDS).filter(|(_, kind)| is_low(kind) && is_of_eighths(kind)) {
        let mut stream = Stream::of_case(2, index);
        for _ in 0..2000 {
            let coefficients = kind.coefficients(&mut stream, 1.0);
            let load_integral = stream.magnitude(-6.0, 6.0);
            // Powers of 256, so that their powers with eighths in the exponent are powers of two as well.
            let length = 256f64.powi(stream.below(15) as i32 - 7);
            let size = stream.power_of_two(300);
            let mut scaled = coefficients;
            for (c, n) in scaled.iter_mut().zip(kind.exponents) {
                *c *= size * length.powf(-n);
            }
            let profiles = [&*(kind.double)(coefficients), &*(kind.double)(scaled)];
            let place = (kind.exponents, coefficients);
            assert_same_in_other_units(profiles, load_integral, [length, size], &place);
        }
    }
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(3, index);
        let coefficients = kind.coefficients(&mut stream, 1.0);
        let profile = (kind.double)(coefficients);
        let single = (kind.single)(coefficients.map(|c| c as f32));
        let mut load_integrals: Vec<f64> = (0..200).map(|_| stream.magnitude(-9.0, 9.0)).collect();
        // Load integrals to which the leading term does not lead.
        load_integrals[70] = 0.0;
        load_integrals[71] = f64::MIN_POSITIVE / 4.0;
        assert_slices_are_right((&*profile, &*single), &load_integrals, &kind.exponents);
    }
}

/// Some of these need more steps than others.
#[test]
fn radii_do_not_depend_on_their_neighbours() {
    for (index, (c, d, k)) in (0..).zip([(1.0, 1.0, 1.0), (0.3, 0.2, 1.0), (1.0, 1e-3, 1e-9)]) {
        let mut stream = Stream::of_case(4, index);
        let load_integrals: Vec<f64> = (0..10_000).map(|_| stream.magnitude(-6.0, 6.0)).collect();
        assert_same_one_by_one(&Steep { c, d, k }, &load_integrals, &(c, d, k));
    }
}

/// Such coefficients must be refused, or give the same radius as any other way.
#[test]
fn what_is_no_positive_coefficient_is_noticed() {
    let radius = |b, c, d, load_integral| Even { b, c, d }.radius_within(load_integral, 2.0);
    let positive = Even { b: 1.0, c: 0.0, d: 0.0 }.radius(1.0).unwrap_or(f64::NAN);
    let of_two_radii = 2.0 * budget::RADIUS.double * f64::EPSILON;
    assert!((positive / 12f64.powf(1.0 / 6.0) - 1.0).abs() <= of_two_radii, "{positive}");
    for tiny in [1e-300, 1e-30, 1e-10] {
        // J = a⁶/12 − …, where the negative term hardly counts.
        let negative = radius(1.0, -tiny, tiny, 1.0).unwrap_or(f64::NAN);
        // The two tiny terms are together 2.4 `tiny` of J, whose degree is 6.
        assert!((negative / positive - 1.0).abs() <= of_two_radii + 0.5 * tiny, "{tiny:e}: {negative}");
    }
    let oblate = radius(1.0, -0.1, 0.0, 1.0).unwrap_or(f64::NAN);
    let profile = Even { b: 1.0, c: -0.1, d: 0.0 };
    let (value, sizes) = (profile.load_integral(oblate), of_sizes(&[(1.0, 2.0), (-0.1, 4.0)]));
    let of_radius = budget::RADIUS.double * budget::RADIUS_OF_DIFFERENCES * degree(&profile, oblate);
    let allowed = budget::LOAD_INTEGRAL.double * sizes.load_integral(oblate) + of_radius;
    assert!((value - 1.0).abs() <= allowed * f64::EPSILON, "{oblate}: {value}");
    for load_integral in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(radius(1.0, 1.0, 1.0, load_integral).is_err(), "{load_integral}");
    }
    assert_eq!(radius(1.0, 1.0, 1.0, 0.0), Ok(0.0));
}
