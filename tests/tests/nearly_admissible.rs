//! Gaps whose δ₀′ nearly vanishes, where the contact spreads fast.
//!
//! On one that is admissible only by a millionth, the rounding of a load integral moves the radius by a hundred thousand
//! of its own roundings, and this must not shorten the steps of a user-defined load.

use core::error::Error;

use cartcontact::load::Constant;
use cartcontact::{Contact, ContactError, GapProfile, Medium, Polynomial, gap_profile};
use tests::budget;
use tests::condition::{edge, of_radius, of_sizes};
use tests::loads::{CountingForces, Unannounced, along, through};
use tests::measure::{Errors, relative_error};
use tests::planted;

/// δ₀′ = a (1 − 2 (a/7) + 1.000001 (a/7)²).
#[gap_profile(r^2 - 5/21 * r^3 + 0.75 * 1.000001 / 49 * r^4)]
struct NearlyFlat;

/// Where δ₀′/a is least.
const FLATTEST: f64 = 7.0;

const CHI: f64 = 0.0015;

/// The time at which the last force is reached and the pressure is taken.
const END: f64 = 200.0;

#[test]
fn pressures_are_those_of_a_straight_load_and_take_few_forces() -> Result<(), ContactError> {
    let load = through(&[(0.0, 50.0), (END, 100.0)]);
    let mut errors = Errors::of(budget::PRESSURE);
    for end in [6.5, 6.9, 6.99, 6.998, 6.999, 7.0, 7.001, 7.01, 7.5] {
        let straight = planted::contact(NearlyFlat, &load, CHI, end, END)?;
        // Followed like a load that is not straight.
        let curved = CountingForces::new(Unannounced(&load));
        let curved = planted::contact(NearlyFlat, curved, CHI, end, END)?;
        let (expected, found) = (straight.at(END)?, curved.at(END)?);
        let a = expected.radius();
        // Radii that the contact has passed count too: the condition is that at the flattest of them.
        let condition = of_radius(&NearlyFlat, &of_sizes(&NearlyFlat::TERMS), a.min(FLATTEST));
        for share in [0.0, 0.5, 0.9, 0.99, 0.999, 0.99999] {
            curved.load().forces();
            let r = share * a;
            errors.add(found.pressure(r), expected.pressure(r), condition * edge(a, r), &(end, share));
            let forces = curved.load().forces();
            assert!(forces < 5000, "{end}, {share}: {forces} forces");
        }
    }
    errors.check();
    Ok(())
}

/// δ₀′ ∝ a² (1 − 1.996 a² + a⁴). Along one piece s δ₀′ falls outwards between some of the outer nodes, and between none
/// of the inner ones.
#[test]
fn a_rise_from_nothing_is_the_sum_of_its_parts() -> Result<(), Box<dyn Error>> {
    let terms = [(5.0 / 6.0, 3.0), (-1.3972, 5.0), (9.0 / 14.0, 7.0)];
    let gap = Polynomial::new(terms)?;
    for end in [0.98, 0.99, 1.0, 1.01, 1.02] {
        for folds in [0.2, 0.3, 0.4, 0.5] {
            let peak = |parts: u32| -> Result<f64, ContactError> {
                let load = through(&along([(0.0, 0.0), (folds, 1.0)], parts).collect::<Vec<_>>());
                Ok(planted::contact(&gap, load, 1.0, end, folds)?.at(folds)?.peak_pressure())
            };
            let error = relative_error(peak(1)?, peak(64)?, f64::EPSILON);
            let condition = of_radius(&gap, &of_sizes(&terms), end.min(1.0));
            let allowed = 2.0 * budget::PEAK_PRESSURE.double * condition;
            assert!(error <= allowed, "{end}, {folds}: {error} of {allowed} ε");
        }
    }
    Ok(())
}

/// The last coefficient of the radii at the nodes of a piece is next to nothing, and only the one before it shows that
/// the rule is too short.
#[test]
fn knots_of_a_held_load_change_nothing() -> Result<(), Box<dyn Error>> {
    let terms = [(0.05, 2.0), (-0.08303262, 3.0), (0.0375, 4.0)];
    let (gap, force, end) = (Polynomial::new(terms)?, 4.1668348667e-5, 0.135763956);
    let medium = Medium::from_constants(0.375, 1.0)?;
    let knots = [0.0, 0.009762355860, 0.017406099543].map(|t| (t, force));
    let constant = Contact::new(&gap, medium, Constant(force))?;
    let record = Contact::new(&gap, medium, through(&knots))?;
    let (expected, found) = (constant.at(end)?, record.at(end)?);
    let a = expected.radius();
    let condition = of_radius(&gap, &of_sizes(&terms), a);
    for share in [0.0, 0.5, 0.9] {
        let r = share * a;
        let error = relative_error(found.pressure(r), expected.pressure(r), f64::EPSILON);
        let allowed = 2.0 * budget::PRESSURE.double * condition * edge(a, r);
        assert!(error <= allowed, "{share}: {error} of {allowed} ε");
    }
    Ok(())
}

/// Next to the edge the terms of the kernel cancel down to their rounding.
#[test]
fn no_pressure_is_negative() -> Result<(), Box<dyn Error>> {
    for k in 0..40 {
        let b = 1.0 - 10_f64.powf(-4.0 - 0.05 * f64::from(k));
        let gap = Polynomial::new([(0.05, 2.0), (-b / 12.0, 3.0), (0.0375, 4.0)])?;
        for end in [0.999, 1.0, 1.01] {
            let contact = planted::contact(&gap, Constant(1.0), 0.0, end, 0.0)?;
            let now = contact.at(0.0)?;
            for depth in [1e-12, 1e-13, 1e-14, 1e-15] {
                let pressure = now.pressure(now.radius() * (1.0 - depth));
                assert!(pressure >= 0.0, "{b}, {end}, {depth}: {pressure:e}");
            }
        }
    }
    Ok(())
}

/// That the first term outweighs the other at a radius is known nearer to the zero of δ₀′ than the zero itself.
#[test]
fn a_range_may_end_next_to_a_zero() {
    let zero = 0.75_f64.sqrt();
    for unit in [1e-300, 1.0, 1e300] {
        let ends_at = |end| Polynomial::with_max_radius([(unit, 2.0), (-unit, 4.0)], end).is_ok();
        assert!(ends_at(zero * (1.0 - 1e-14)) && !ends_at(zero * (1.0 + 1e-15)), "{unit:e}");
    }
}

/// Where the last term first exceeds either of two negative ones, the first term still hides that both together exceed
/// it.
#[test]
fn the_last_term_has_to_outweigh_all_negative_ones() {
    // 2 C n/(n+2) is 3/2, −1, −1 and 1: δ₀′ vanishes near 1.08.
    let negative = (-11.9 / 19.8, 9.9);
    let terms = [(1.5, 2.0), negative, negative, (0.6, 10.0)];
    let end = Polynomial::new(terms).map_or(f64::NAN, |gap| gap.max_radius());
    assert!(1.0 < end && end < 1.3, "{end}");
}
