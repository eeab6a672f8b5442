//! What the README says that its programs print.

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, ContactError, GapProfile, Layer, Medium, gap_profile};
use tests::profiles::Patellofemoral;

const README: &str = include_str!("../../README.md");

#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3), max_radius = 6)]
struct Ball {
    radius: f64,
}

/// The contact in the layers of all programs.
fn contact<P: GapProfile<f64>, L: Load<f64>>(
    profile: P,
    load: L,
) -> Result<Contact<f64, P, L>, ContactError> {
    let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    Contact::new(profile, Medium::between(layer, layer)?, load)
}

/// Asserts that the README has a text, wherever its lines end.
fn assert_said(text: &str) {
    let words = README.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains(text), "the README does not say: {text}");
}

#[test]
fn the_first_program_prints_what_is_said() -> Result<(), ContactError> {
    let contact = contact(Patellofemoral, Constant(100.0))?;
    let now = contact.at(200.0)?;
    let [a, delta, peak] = [now.radius(), now.approach(), now.peak_pressure()];
    assert_said(&format!("prints `{a:.3} mm, {delta:.4} mm, {peak:.4} MPa`"));
    Ok(())
}

#[test]
fn the_program_with_a_record_prints_what_is_said() -> Result<(), ContactError> {
    let load = PiecewiseLinear::new([(0.0, 20.0), (0.5, 100.0), (200.0, 95.0)])?;
    let contact = contact(Patellofemoral, load)?;
    let (times, mut radii, mut pressures) = ([0.0, 10.0, 200.0], [0.0; 3], [0.0; 9]);
    contact.radii(&times, &mut radii)?;
    contact.pressure_field(&times, &[0.0, 2.5, 5.0], &mut pressures)?;
    assert_said(&format!("prints `{radii:.3?} mm, {:.3?} MPa at the end`", &pressures[6..]));
    Ok(())
}

#[test]
fn a_contact_beyond_its_range_is_refused_as_said() -> Result<(), ContactError> {
    let contact = contact(Ball { radius: 20.0 }, Constant(20.0))?;
    let Err(error) = contact.at(1e5) else { unreachable!("the range is not left") };
    assert_said(&format!("```text {error} ```"));
    Ok(())
}
