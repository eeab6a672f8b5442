//! Derivatives of pressures under records, whose short pieces are integrated many at once.

use cartcontact::{Contact, ContactError, GapProfile, Medium, Polynomial, Scalar, gap_profile};
use num_dual::{Dual2_64, Dual32, Dual64};
use tests::loads::{Announced, Knots, through};

/// Two even powers.
#[gap_profile(b * r^2 + 1.09375e-4 * r^4)]
#[derive(Clone, Copy)]
struct Even<T> {
    b: T,
}

/// What derivatives are taken with respect to.
const PARAMETERS: [&str; 7] =
    ["χ", "m", "b", "the forces", "the time", "a step of no height", "the time of a knot"];

/// Values of the parameters, of which steps are relative to a force of 100 N.
const VALUES: [f64; 7] = [1.5e-3, 0.375, 0.025, 100.0, 163.0, 0.0, 60.0];

/// By what derivatives are multiplied to be shares of a pressure.
const SIZES: [f64; 7] = [1.5e-3, 0.375, 0.025, 100.0, 163.0, 100.0, 163.0];

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
        each_way(&Polynomial::new(terms)?, medium, load, time)
    } else {
        each_way(&Even { b }, medium, load, time)
    }
}

fn each_way<T: Scalar>(
    profile: &impl GapProfile<T>,
    medium: Medium<T>,
    load: Knots<T>,
    time: T,
) -> Result<[Vec<T>; 2], ContactError> {
    let radii = [0.0, 3.0, 5.0, 6.5].map(T::constant);
    let at_once = Contact::new(profile, medium, &load)?;
    let at_once = radii.map(|r| at_once.at(time).map(|now| now.pressure(r)));
    let in_steps = Contact::new(profile, medium, Announced { load: &load, is_linear: false })?;
    let in_steps = radii.map(|r| in_steps.at(time).map(|now| now.pressure(r)));
    Ok([at_once.into_iter().collect::<Result<_, _>>()?, in_steps.into_iter().collect::<Result<_, _>>()?])
}

#[test]
fn derivatives_under_records_are_those_of_one_piece_after_the_other() -> Result<(), ContactError> {
    for polynomial in [false, true] {
        for (which, name) in PARAMETERS.into_iter().enumerate() {
            let mut parameters = VALUES.map(Dual2_64::from);
            parameters[which] = parameters[which].derivative();
            let [at_once, in_steps] = pressures(parameters, polynomial)?;
            let mut parameters = VALUES.map(Dual64::from);
            parameters[which] = parameters[which].derivative();
            let [first, _] = pressures(parameters, polynomial)?;
            let (size, peak) = (SIZES[which], in_steps[0].re);
            for ((found, expected), first) in at_once.iter().zip(&in_steps).zip(first) {
                let errors = [
                    (found.re - expected.re) / peak,
                    (found.v1 - expected.v1) * size / peak,
                    (found.v2 - expected.v2) * size * size / peak,
                    (found.v1 - first.eps) * size / peak,
                ]
                .map(|error| error.abs() / f64::EPSILON);
                assert!(errors[3] <= 20.0, "{name}: {found}, {first}");
                for (error, allowed) in errors.into_iter().zip(ALLOWED) {
                    assert!(error <= allowed, "{name}: {found} instead of {expected}, {error} ε");
                }
            }
        }
    }
    Ok(())
}

/// In ε of the peak pressure: a value, and first and second derivatives times powers of the parameter; the worst here are
/// 0.7, 2 and 721, the last with respect to steps of no height, 172 with respect to the time and 5 to others.
const ALLOWED: [f64; 3] = [4.0, 8.0, 2000.0];

/// Single precision has its own rules.
#[test]
fn derivatives_in_single_precision_are_those_in_double() -> Result<(), ContactError> {
    for (which, name) in PARAMETERS.into_iter().enumerate() {
        let mut double = VALUES.map(Dual64::from);
        double[which] = double[which].derivative();
        let mut single = VALUES.map(|x| Dual32::from(x as f32));
        single[which] = single[which].derivative();
        let ([double, _], [single, _]) = (pressures(double, false)?, pressures(single, false)?);
        for (found, expected) in single.iter().zip(&double) {
            let error = (f64::from(found.eps) - expected.eps).abs() * SIZES[which] / double[0].re;
            let error = error / f64::from(f32::EPSILON);
            assert!(error <= SINGLE, "{name}: {found} instead of {expected}, {error} ε");
        }
    }
    Ok(())
}

/// In ε of single precision; the worst is 27, with respect to the time: the slopes of pieces of 2 s multiply the rounding
/// of their forces by 163/2. With respect to others it is 0.4.
const SINGLE: f64 = 60.0;
