//! Every reference value, against generated solvers and run-time polynomials.

use cartcontact::load::Constant;
use cartcontact::{Contact, GapProfile, Medium, gap_profile};
use tests::budget;
use tests::condition;
use tests::kernel::{self, Kernel};
use tests::measure::Errors;
use tests::profiles::{Case, cases};
use tests::reference::{self, SHIFT_OF_EDGE};

/// The form of a geometry that is compared.
type Form = fn(Case, &mut dyn FnMut(&dyn GapProfile<f64>));

const FORMS: [(&str, Form); 2] = [
    ("generated", |case, visit| visit(case.double)),
    ("polynomial", |case, visit| visit(&case.polynomial())),
];

#[test]
fn kernels_are_those_of_the_reference() {
    let rows = reference::kernels();
    for (form, visit) in FORMS {
        for kernel @ Kernel { allowance, double, reference, .. } in kernel::ALL {
            let mut errors = Errors::of(allowance);
            for row in &rows {
                let expected = reference(row);
                let condition = kernel.condition(&row.case.of_sizes(), (row.a, row.r), expected.nearest);
                visit(row.case, &mut |profile| {
                    let place = (form, row.case, row.a, row.r);
                    errors.add(double(profile, row.a, row.r), expected, condition, &place);
                });
            }
            errors.check_worst();
        }
    }
}

#[test]
fn radii_are_those_of_the_reference() {
    for (form, visit) in FORMS {
        let mut errors = Errors::of(budget::RADIUS);
        for row in reference::radii() {
            let load_integral = row.y / (row.m * core::f64::consts::FRAC_PI_4);
            visit(row.case, &mut |profile| {
                let found = profile.radius(load_integral).unwrap_or(f64::NAN);
                let condition = condition::of_radius(row.case.double, &row.case.of_sizes(), row.a.nearest);
                errors.add(found, row.a, condition, &(form, row.case, row.y));
            });
        }
        errors.check_worst();
    }
}

#[test]
fn contacts_are_those_of_the_reference() {
    let rows = reference::contacts();
    let (mut radius, mut approach) =
        (Errors::of(budget::CONTACT_RADIUS), Errors::of(budget::CONTACT_APPROACH));
    let (mut pressure, mut peak) = (Errors::of(budget::PRESSURE), Errors::of(budget::PEAK_PRESSURE));
    for (form, visit) in FORMS {
        for row in &rows {
            let place = (form, row.case, row.chi, &row.knots, row.t, row.r);
            visit(row.case, &mut |profile| {
                let [a, delta, p, p0] = row.solved(profile, |x| x);
                let exact = row.radius.nearest;
                let condition = condition::of_radius(row.case.double, &row.case.of_sizes(), exact);
                let of_approach = condition::of_approach(row.case.double, exact);
                radius.add(a, row.radius, condition, &place);
                approach.add(delta, row.approach, condition * of_approach, &place);
                pressure.add(p, row.pressure, condition::edge(exact, row.r), &place);
                peak.add(p0, row.peak_pressure, 1.0, &place);
            });
        }
    }
    radius.check();
    approach.check();
    pressure.check();
    peak.check();
}

/// The gap of the finite-element run.
#[gap_profile(r^2 + 0.01 * r^4)]
struct FiniteElement;

/// While the load is held, the model follows the full poroelastic solution as far as a thin-layer model can: approach
/// and peak pressure relative to their first values within 1.1 % and 1.6 %, and the radius less the shift of the edge
/// within 2.1 %.
#[test]
fn creep_is_that_of_finite_elements() -> Result<(), Box<dyn core::error::Error>> {
    let rows = reference::finite_elements();
    let start = rows.first().ok_or("no rows")?;
    let contact = Contact::new(FiniteElement, Medium::from_constants(3.0, 1.0)?, Constant(start.load))?;
    let first = contact.at(0.0)?;
    let held: Vec<_> = rows.iter().filter(|row| row.t <= 0.4).collect();
    assert_eq!(held.len(), 10);
    for row in held {
        let now = contact.at(row.t)?;
        let growth = now.approach() / first.approach() / (row.approach / start.approach);
        let fading = now.peak_pressure() / first.peak_pressure() / (row.peak_pressure / start.peak_pressure);
        let radius = (now.radius() - SHIFT_OF_EDGE) / row.radius;
        assert!((growth - 1.0).abs() < 0.011, "{row:?}: {growth}");
        assert!((fading - 1.0).abs() < 0.016, "{row:?}: {fading}");
        assert!((radius - 1.0).abs() < 0.021, "{row:?}: {radius}");
    }
    Ok(())
}

/// The eleven structs are the eleven geometries of `profiles.json`.
#[test]
fn geometries_are_those_of_the_reference() {
    let json = include_str!("../reference/profiles.json");
    let numbers =
        |text: &str| text.split('"').filter_map(|part| part.trim().parse().ok()).collect::<Vec<f64>>();
    let records: Vec<&str> = json.split("\"name\": ").skip(1).collect();
    assert_eq!(records.len(), cases().len());
    for (record, case) in records.into_iter().zip(cases()) {
        let (name, record) = record.split_once(',').unwrap_or_default();
        let (expression, record) = record.split_once("\"terms\": ").unwrap_or_default();
        let (terms, max_radius) = record.split_once("\"max_radius\": ").unwrap_or_default();
        assert_eq!(name, format!("{:?}", case.name));
        assert!(expression.contains(&format!("{:?}", case.expression)), "{expression}");
        let flat: Vec<f64> = case.terms.iter().flat_map(|&(c, n)| [c, n]).collect();
        assert_eq!(numbers(terms), flat, "{name}");
        let max_radius = max_radius.split_whitespace().next().and_then(|text| text.parse::<f64>().ok());
        assert_eq!(max_radius, case.max_radius, "{name}");
        assert_eq!(case.double.max_radius(), max_radius.unwrap_or(f64::INFINITY), "{name}");
    }
}
