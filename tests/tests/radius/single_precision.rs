//! Contact radii in single precision, where the products in a step may leave the format long before the radius does.

use core::fmt::Debug;

use cartcontact::{RadiusError, gap_profile};
use tests::budget;
use tests::inversion::Inversion;
use tests::measure::Errors;
use tests::random::Stream;

use super::checks::exact_radius;

/// The square of the ratio of the coefficients leaves the format.
#[gap_profile(r^2 + 1e-20 * r^4)]
struct Parabolic;

#[gap_profile(0.025 * r^2 + 1e-4 * r^4 + 1e-12 * r^8 + 1e-18 * r^10)]
struct Deep;

/// Powers that are formed one by one; the squares of some load integrals leave the format.
#[gap_profile(0.025 * r + 1.25e-3 * r^1.5 + 2e-5 * r^2)]
struct Fractional;

#[gap_profile(c * r^(49/3))]
struct Third {
    c: f32,
}

#[gap_profile(b * r^1.25 + c * r^2.25)]
struct Quarters {
    b: f32,
    c: f32,
}

#[gap_profile(b * r^0.5 + c * r)]
struct Mixed {
    b: f32,
    c: f32,
}

/// A constant beside a field, with no bound on their ratio.
#[gap_profile(b * r + 1e-10 * r^7)]
struct Steepening {
    b: f32,
}

/// In plain arithmetic eight roundings, which are the same in all radii of a geometry.
#[gap_profile(c * b^3 / (7 * d^3) * r)]
struct LongProduct {
    b: f32,
    c: f32,
    d: f32,
}

/// No format has the exponent of the field, which may be far from 1.
#[gap_profile(c * b^5.8 * r^3)]
struct RoundedExponent {
    b: f32,
    c: f32,
}

/// A geometry, its terms (C, n), and the powers of ten between which its load integrals lie.
struct Case {
    profile: Box<dyn Inversion<f32>>,
    terms: Vec<(f64, f64)>,
    range: [f64; 2],
}

fn case(profile: impl Inversion<f32> + 'static, terms: &[(f64, f64)], range: [f64; 2]) -> Case {
    Case { profile: Box::new(profile), terms: terms.to_vec(), range }
}

fn cases() -> Vec<Case> {
    let fractional = [(0.025, 1.0), (1.25e-3, 1.5), (2e-5, 2.0)];
    let deep = [(0.025, 2.0), (1e-4, 4.0), (1e-12, 8.0), (1e-18, 10.0)];
    let mut cases = vec![
        case(Parabolic, &[(1.0, 2.0), (1e-20, 4.0)], [-10.0, 10.0]),
        case(Deep, &deep, [-10.0, 20.0]),
        case(Fractional, &fractional, [-12.0, 23.0]),
    ];
    for b in [1e-8_f32, 1e-4, 1.0, 10.0, 1e4] {
        cases.push(case(Third { c: b }, &[(b.into(), 49.0 / 3.0)], [-10.0, 20.0]));
        cases.push(case(Steepening { b }, &[(b.into(), 1.0), (1e-10, 7.0)], [-10.0, 20.0]));
        for c in [0.25 * b, b, 3.0 * b] {
            cases.push(case(Quarters { b, c }, &[(b.into(), 1.25), (c.into(), 2.25)], [-24.0, 20.0]));
            cases.push(case(Mixed { b, c }, &[(b.into(), 0.5), (c.into(), 1.0)], [-24.0, 20.0]));
        }
    }
    cases
}

impl Case {
    /// Adds the errors of the radii of `count` random load integrals.
    fn add_errors(&self, errors: &mut Errors, stream: &mut Stream, count: u32, place: &dyn Debug) {
        let [low, high] = self.range;
        for _ in 0..count {
            let load_integral = stream.magnitude(low, high) as f32;
            let found = self.profile.radius(load_integral).unwrap_or(f32::NAN);
            let expected = exact_radius(&self.terms, load_integral.into());
            errors.add(found.into(), expected, 1.0, &(place, load_integral));
        }
    }
}

#[test]
fn radii_are_exact_for_load_integrals_of_any_size() {
    let mut errors = Errors::of_single(budget::RADIUS);
    for (index, case) in (0..).zip(cases()) {
        case.add_errors(&mut errors, &mut Stream::of_case(1, index), 100, &case.terms);
    }
    errors.check();
}

#[test]
fn radii_are_exact_where_coefficients_are_long_products() {
    let mut errors = Errors::of_single(budget::RADIUS);
    for index in 0..100 {
        let mut stream = Stream::of_case(2, index);
        let fields = [(); 3].map(|()| stream.magnitude(-1.0, 1.0) as f32);
        let ([b, c, d], exact) = (fields, fields.map(f64::from));
        let coefficient = exact[1] * exact[0].powi(3) / (7.0 * exact[2].powi(3));
        let case = case(LongProduct { b, c, d }, &[(coefficient, 1.0)], [-3.0, 3.0]);
        case.add_errors(&mut errors, &mut stream, 20, &fields);
    }
    errors.check();
}

#[test]
fn radii_are_exact_where_exponents_of_fields_are_not_in_the_format() {
    let mut errors = Errors::of_single(budget::RADIUS);
    for index in 0..100 {
        let mut stream = Stream::of_case(3, index);
        let b = stream.magnitude(-6.0, 6.0) as f32;
        let c = (stream.magnitude(-1.0, 1.0) * f64::from(b).powf(-5.8)) as f32;
        let coefficient = f64::from(c) * f64::from(b).powf(5.8);
        let case = case(RoundedExponent { b, c }, &[(coefficient, 3.0)], [-3.0, 3.0]);
        case.add_errors(&mut errors, &mut stream, 20, &(b, c));
    }
    errors.check();
}

/// A NaN with all bits set is what erased memory holds.
#[test]
fn no_bits_of_a_field_lead_to_a_panic() {
    let erased = f32::from_bits(u32::MAX);
    for (b, c) in [(erased, 1.0), (1.0, erased), (erased, erased)] {
        for profile in [&Quarters { b, c } as &dyn Inversion<f32>, &Mixed { b, c }] {
            let radius = profile.radius(1.0);
            assert!(matches!(radius, Err(RadiusError::BeyondRange { .. })), "{b}, {c}: {radius:?}");
        }
    }
}
