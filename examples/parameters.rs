//! A geometry with parameters: the solver is compiled once, and the radii of curvature are data.
//!
//! ```text
//! cargo run --release --example parameters
//! ```
//!
//! A ball of radius 10 mm lies in sockets from closely fitting to flat. The closer the fit, the wider the
//! contact and the lower the pressure, and the more of the gap is lost by truncating the spheres after the
//! fourth order. The last column is the share lost at the edge of the contact, where it is largest.

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use cartcontact::{Contact, GapProfile, Layer, Medium, gap_profile, load};

/// A ball in a socket, to fourth order in the distance from the axis; the fields are radii in mm.
#[gap_profile((1/ball - 1/socket) * r^2 / 2 + (1/ball^3 - 1/socket^3) * r^4 / 8)]
struct BallInSocket {
    ball: f64,
    socket: f64,
}

impl BallInSocket {
    /// The share of the spheres' gap at the distance `r` from the axis that the fourth order neglects.
    fn neglected(&self, r: f64) -> f64 {
        let sag = |radius: f64| r * r / (radius + (radius * radius - r * r).sqrt());
        1.0 - self.gap(r) / (sag(self.ball) - sag(self.socket))
    }
}

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    let medium = Medium::between(layer, layer)?;
    let mut out = io::stdout().lock();
    writeln!(out, "Ball of radius 10 mm under 100 N, after 200 s\n")?;
    writeln!(out, "socket (mm)  radius (mm)  approach (mm)  peak pressure (MPa)  neglected (%)")?;
    for socket in [15.0, 20.0, 30.0, 50.0, 100.0, f64::INFINITY] {
        let contact = Contact::new(BallInSocket { ball: 10.0, socket }, medium, load::Constant(100.0))?;
        let now = contact.at(200.0)?;
        let (radius, approach, peak_pressure) = (now.radius(), now.approach(), now.peak_pressure());
        let neglected = 100.0 * contact.profile().neglected(radius);
        writeln!(
            out,
            "{socket:>11} {radius:>12.3} {approach:>14.4} {peak_pressure:>20.4} {neglected:>14.1}"
        )?;
    }
    Ok(())
}
