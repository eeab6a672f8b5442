//! How strongly the contact depends on each parameter of a joint, by dual numbers instead of differences.
//!
//! ```text
//! cargo run --release --example sensitivities
//! ```
//!
//! A dual number carries its derivative with respect to one variable. The joint is a function of any scalar type. It is
//! solved once for each parameter, with that parameter as the variable, and the derivatives have as many digits as the
//! results. A fit of the parameters to measurements can take its Jacobian from such a function, see the example
//! `creep_fit`.

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use cartcontact::{Contact, Layer, Medium, Scalar, gap_profile, load};
use num_dual::Dual64;

/// A ball on a plane, to fourth order in the distance from the axis; the field is its radius in mm.
#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3))]
struct Ball<T> {
    radius: T,
}

/// The parameters with their values and units.
const PARAMETERS: [(&str, f64, &str); 6] = [
    ("ball radius", 20.0, "mm"),
    ("thickness", 1.0, "mm"),
    ("shear modulus", 0.25, "MPa"),
    ("permeability", 2e-3, "mm⁴/(N s)"),
    ("force", 100.0, "N"),
    ("time", 200.0, "s"),
];

/// Contact radius, approach and peak pressure for such parameters.
fn contact<T: Scalar>(parameters: [T; 6]) -> Result<[T; 3], Box<dyn Error>> {
    let [radius, thickness, shear_modulus, permeability, force, time] = parameters;
    let layer = Layer { thickness, shear_modulus, permeability };
    let contact = Contact::new(Ball { radius }, Medium::between(layer, layer)?, load::Constant(force))?;
    let now = contact.at(time)?;
    Ok([now.radius(), now.approach(), now.peak_pressure()])
}

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    let values = PARAMETERS.map(|(_, value, _)| value);
    let [radius, approach, peak_pressure] = contact(values)?;
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "radius {radius:.3} mm, approach {approach:.4} mm, peak pressure {peak_pressure:.4} MPa\n"
    )?;
    writeln!(out, "1 % more of                      changes by %:  radius  approach  peak pressure")?;
    for (index, (name, value, unit)) in PARAMETERS.into_iter().enumerate() {
        let mut duals = values.map(Dual64::from);
        duals[index] = duals[index].derivative();
        let [radius, approach, peak_pressure] = contact(duals)?.map(|result| value * result.eps / result.re);
        let amount = format!("{value} {unit}");
        writeln!(out, "{name:<14} {amount:<31} {radius:>7.3}  {approach:>8.3}  {peak_pressure:>13.3}")?;
    }
    Ok(())
}
