//! A change of units changes the numbers, not the result. Powers of two do not even change the last bit, except for
//! these cases with other units of length, in which results stay within their bounds:
//!
//! - Radii of constant geometries in single precision where the load integral moves beyond the rows of the table for
//!   single precision: they are then iterated, and up to 5 % of them differ in the last bit.
//! - Radii of geometries with fields whose coefficients move beyond 1e±60, in single precision 1e±11, where a table
//!   with fields ends.
//! - The `max_radius()` of a geometry with fields and terms of both signs: it is searched for in ln r, and up to 60 ε
//!   too small; larger radii are refused.
//!
//! Other units of force and time change no result.
//!
//! Lengths are multiplied by L, forces by Q and times by T: a coefficient of rⁿ by L^(1−n), m by Q/L⁵, χ by 1/T,
//! pressures by Q/L².

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, ContactError, GapProfile, Medium, gap_profile};
use proptest::prelude::*;
use tests::budget;
use tests::random::{self, magnitude, sum};

/// Two powers of any size.
#[gap_profile(square * r^2 + cube * r^3)]
struct SquareAndCube {
    square: f64,
    cube: f64,
}

/// One power of any size.
#[gap_profile(fourth * r^4)]
struct Fourth {
    fourth: f64,
}

/// The factors of lengths, forces and times.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: f64,
    force: f64,
    time: f64,
}

/// Coefficients of r², r³ and r⁴, m, χ and the knots of a load.
#[derive(Clone, Debug)]
struct Problem {
    coefficients: [f64; 3],
    m: f64,
    chi: f64,
    knots: [(f64, f64); 3],
}

impl Problem {
    fn new([square, cube, fourth]: [f64; 3]) -> Self {
        let knots = [(0.0, 30.0), (20.0, 90.0), (60.0, 80.0)];
        Self { coefficients: [square, cube, fourth], m: 0.375, chi: 0.02, knots }
    }

    fn in_units(&self, units: Units) -> Self {
        let Units { length, force, time } = units;
        let [square, cube, fourth] = self.coefficients;
        Self {
            coefficients: [square / length, cube / (length * length), fourth / (length * length * length)],
            m: self.m * force / (length * length * length * length * length),
            chi: self.chi / time,
            knots: self.knots.map(|(t, f)| (t * time, f * force)),
        }
    }

    /// Radius, approach, and pressures on the axis and at some radii, at four times.
    fn results(&self, profile: &dyn GapProfile<f64>, units: Units) -> Result<Vec<f64>, ContactError> {
        let medium = Medium::from_constants(self.m, self.chi)?;
        let load = PiecewiseLinear::new(self.knots)?;
        let contact = Contact::new(profile, medium, load)?;
        let pressure = units.force / (units.length * units.length);
        let mut results = Vec::new();
        for t in [0.0, 15.0, 50.0, 500.0] {
            let now = contact.at(t * units.time)?;
            results.extend([now.radius() / units.length, now.approach() / units.length]);
            results.extend([0.0, 0.5, 3.0, 7.0].map(|r| now.pressure(r * units.length) / pressure));
        }
        Ok(results)
    }

    fn all_results(&self, units: Units) -> Result<Vec<Vec<f64>>, ContactError> {
        let here = self.in_units(units);
        let [square, cube, fourth] = here.coefficients;
        let polynomial = sum(vec![(square, 2.0), (cube, 3.0), (fourth, 4.0)]);
        let profiles: [&dyn GapProfile<f64>; 3] =
            [&polynomial, &SquareAndCube { square, cube }, &Fourth { fourth }];
        profiles.into_iter().map(|profile| here.results(profile, units)).collect()
    }
}

/// In ε: the coefficients, m, the load and times are rounded one to six times in the conversion to other units, and
/// results up to three times in the conversion back; results depend on them with powers not above 1.
const CONVERSION: f64 = 5.0;

const SAME: Units = Units { length: 1.0, force: 1.0, time: 1.0 };

fn problems() -> impl Strategy<Value = Problem> {
    [magnitude(-3.0..0.0), magnitude(-4.0..-1.0), magnitude(-5.0..-2.0)].prop_map(Problem::new)
}

fn power_of_two() -> impl Strategy<Value = f64> {
    (-20..20).prop_map(|k| 2_f64.powi(k))
}

proptest! {
    #![proptest_config(random::cases(40))]

    #[test]
    fn powers_of_two_change_no_bit(
        problem in problems(),
        (length, force, time) in (power_of_two(), power_of_two(), power_of_two()),
    ) {
        let results = problem.all_results(Units { length, force, time }).ok();
        prop_assert!(results.is_some());
        prop_assert_eq!(results, problem.all_results(SAME).ok());
    }

    #[test]
    fn other_factors_change_only_the_last_digits(
        problem in problems(),
        (length, force, time) in (magnitude(-6.0..6.0), magnitude(-6.0..6.0), magnitude(-6.0..6.0)),
    ) {
        let results = problem.all_results(Units { length, force, time });
        let [results, expected] = [results, problem.all_results(SAME)]
            .map(|results| results.map(|results| results.concat()).unwrap_or_default());
        prop_assert_eq!(results.len(), 72);
        for (found, expected) in results.chunks(6).zip(expected.chunks(6)) {
            // The approach has a degree of at most 4. Pressures are compared in units of the one on the axis: next to
            // the edge they are small differences.
            let [radius, approach] = [budget::CONTACT_RADIUS.double, 5.0 * budget::CONTACT_APPROACH.double];
            let scales = [(expected[0], radius), (expected[1], approach)].into_iter();
            let scales = scales.chain([(expected[2], budget::PEAK_PRESSURE.double); 4]);
            for ((found, expected), (scale, allowed)) in found.iter().zip(expected).zip(scales) {
                let allowed = (2.0 * allowed + CONVERSION) * f64::EPSILON * scale;
                prop_assert!((found - expected).abs() <= allowed, "{} {}", found, expected);
            }
        }
    }
}
