//! Derivatives of pressures under records, whose short pieces are integrated many at once.

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, GapProfile, Medium, Polynomial, Scalar, gap_profile};
use num_dual::{Dual2_64, Dual32, Dual64};
use tests::loads::{Announced, Knots, through};
use tests::measure::relative_error;

/// Two even powers.
#[gap_profile(b * r^2 + 1.09375e-4 * r^4)]
#[derive(Clone, Copy)]
struct Even<T> {
    b: T,
}

/// A number that derivatives are taken with respect to.
struct Parameter {
    name: &'static str,
    value: f64,
    /// By what derivatives are multiplied to be shares of a pressure.
    size: f64,
    /// How far second derivatives may be off in double precision, and first ones in single precision, in ε.
    allowed: [f64; 2],
}

const fn parameter(name: &'static str, value: f64, size: f64, allowed: [f64; 2]) -> Parameter {
    Parameter { name, value, size, allowed }
}

/// In ε: with respect to most parameters second derivatives are off by up to 5, and in single precision first ones by up
/// to 0.4.
const MOST: [f64; 2] = [20.0, 2.0];

/// Steps are relative to a force of 100 N.
const PARAMETERS: [Parameter; 7] = [
    parameter("χ", 1.5e-3, 1.5e-3, MOST),
    parameter("m", 0.375, 0.375, MOST),
    parameter("b", 0.025, 0.025, MOST),
    parameter("the forces", 100.0, 100.0, MOST),
    // The slopes of pieces of 2 s multiply the rounding of their forces by 163/2. The worst are 172 and 27.
    parameter("the time", 163.0, 163.0, [500.0, 60.0]),
    // The worst second derivative is off by 721.
    parameter("a step of no height", 0.0, 100.0, [2000.0, MOST[1]]),
    parameter("the time of a knot", 60.0, 163.0, MOST),
];

/// All of them in a kind of dual numbers, of which one is the variable.
fn numbers<T: Scalar>(which: usize, variable: fn(T) -> T) -> [T; 7] {
    let mut numbers = PARAMETERS.each_ref().map(|parameter| T::constant(parameter.value));
    numbers[which] = variable(numbers[which]);
    numbers
}

/// A rise with ripples through a hundred knots, with pairs of equal knots after every ninth, of which the second moves
/// with a parameter.
fn record<T: Scalar>(force: T, step: T, time_of_knot: T) -> Knots<T> {
    let mut knots = vec![];
    for k in 0..=100 {
        let t = 2.0 * f64::from(k);
        let time = if k == 30 { time_of_knot } else { T::constant(t) };
        let ripple = force * T::constant(0.5 + t / 400.0 + 0.006 * (t * 0.3).sin());
        knots.push((time, ripple));
        if k % 9 == 8 {
            knots.push((time, ripple + step));
        }
    }
    through(&knots)
}

/// Pressures at some radii, by pieces many at once and by steps through each.
fn pressures<T: Scalar>(parameters: [T; 7], polynomial: bool) -> Result<[Vec<T>; 2], ContactError> {
    let [chi, m, b, force, time, step, time_of_knot] = parameters;
    let load = record(force, step, time_of_knot);
    let medium = Medium::from_constants(m, chi)?;
    let terms = [(b, T::constant(2.0)), (T::constant(1.09375e-4), T::constant(4.0))];
    if polynomial {
        each_way(&Polynomial::new(terms)?, medium, &load, time)
    } else {
        each_way(&Even { b }, medium, &load, time)
    }
}

fn each_way<T: Scalar>(
    profile: &dyn GapProfile<T>,
    medium: Medium<T>,
    load: &Knots<T>,
    time: T,
) -> Result<[Vec<T>; 2], ContactError> {
    let pressures = |load: &dyn Load<T>| -> Result<Vec<T>, ContactError> {
        let contact = Contact::new(profile, medium, load)?;
        let now = contact.at(time)?;
        Ok([0.0, 3.0, 5.0, 6.5].map(|r| now.pressure(T::constant(r))).to_vec())
    };
    Ok([pressures(load)?, pressures(&Announced { load, is_linear: false })?])
}

/// How far values and first derivatives, times the parameter, may be off in double precision, in ε of the peak pressure;
/// the worst here are 0.7 and 2.
const ALLOWED: [f64; 2] = [4.0, 8.0];

#[test]
fn derivatives_under_records_are_those_of_one_piece_after_the_other() -> Result<(), ContactError> {
    for polynomial in [false, true] {
        for (which, &Parameter { name, size, allowed, .. }) in PARAMETERS.iter().enumerate() {
            let [at_once, in_steps] = pressures(numbers(which, Dual2_64::derivative), polynomial)?;
            let [first, _] = pressures(numbers(which, Dual64::derivative), polynomial)?;
            let peak = in_steps[0].re;
            for ((found, expected), first) in at_once.iter().zip(&in_steps).zip(first) {
                let error = |difference: f64| (difference / peak).abs() / f64::EPSILON;
                let of_first = error((found.v1 - first.eps) * size);
                assert!(of_first <= 20.0, "{name}: {found}, {first}");
                for (error, allowed) in [
                    (error(found.re - expected.re), ALLOWED[0]),
                    (error((found.v1 - expected.v1) * size), ALLOWED[1]),
                    (error((found.v2 - expected.v2) * size * size), allowed[0]),
                ] {
                    assert!(error <= allowed, "{name}: {found} instead of {expected}, {error} ε");
                }
            }
        }
    }
    Ok(())
}

/// Single precision has its own rules.
#[test]
fn derivatives_in_single_precision_are_those_in_double() -> Result<(), ContactError> {
    for (which, &Parameter { name, size, allowed, .. }) in PARAMETERS.iter().enumerate() {
        let [double, _] = pressures(numbers(which, Dual64::derivative), false)?;
        let [single, _] = pressures(numbers(which, Dual32::derivative), false)?;
        for (found, expected) in single.iter().zip(&double) {
            let error = (f64::from(found.eps) - expected.eps).abs() * size / double[0].re;
            let error = error / f64::from(f32::EPSILON);
            assert!(error <= allowed[1], "{name}: {found} instead of {expected}, {error} ε");
        }
    }
    Ok(())
}

/// By rounding, a time may be at a knot although it is after it: then, too, the force depends on it as on the piece that
/// begins there.
#[test]
fn forces_next_to_a_knot_have_the_derivatives_of_the_next_piece() {
    let after = 13.915185_f32.next_up();
    for last in [5.0, 12.34, 13.2, 20.0] {
        let of = |in_time: f32, in_knot: f32| {
            let knots = [(0.0, 13.5), (13.915185, 13.1), (27.83037, last)].map(|(t, f)| (t.into(), f.into()));
            let mut knots: [(Dual32, Dual32); 3] = knots;
            knots[1].0.eps = in_knot;
            through(&knots).force(Dual32::new(after, in_time)).eps
        };
        let slope = (last - 13.1) / (27.83037 - 13.915185);
        for (found, expected) in [(of(1.0, 0.0), slope), (of(0.0, 1.0), -slope)] {
            let error = relative_error(found.into(), expected.into(), f32::EPSILON.into());
            assert!(error <= 4.0, "{last}: {found} instead of {expected}");
        }
    }
}
