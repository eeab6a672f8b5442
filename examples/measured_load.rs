//! A contact under a measured load: a CSV file goes in, a CSV table comes out.
//!
//! ```text
//! cargo run --release --example measured_load
//! cargo run --release --example measured_load -- --clamp my_record.csv > my_contact.csv
//! ```
//!
//! Without an argument it reads `data/stair_loading.csv`: a made-up record, like that of a force sensor with a
//! resolution of 0.1 N on a joint that is loaded in three steps and relaxes a little in each hold. The load may fall,
//! as long as the contact does not become smaller. Noise falls faster; `--clamp` raises the forces that fall too fast.

use std::error::Error;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, Layer, Medium, gap_profile};
use clap::Parser;
use examples::load_record::{Knot, LoadRecord};

const DEFAULT_RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/stair_loading.csv");

/// Contact radii, approaches and peak pressures under a measured load.
#[derive(Debug, Parser)]
struct Options {
    /// A CSV file of time_s,force_n; data/stair_loading.csv if not given
    record: Option<PathBuf>,
    /// Raise forces that fall too fast, as noise does, as far as needed
    #[arg(long)]
    clamp: bool,
}

#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct Patellofemoral;

fn main() -> ExitCode {
    examples::finish(run(&Options::parse()))
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let mut record = LoadRecord::read(options.record.as_deref().unwrap_or(Path::new(DEFAULT_RECORD)))?;
    let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    let medium = Medium::between(layer, layer)?;
    if options.clamp {
        let (count, largest) = record.clamp(medium.chi());
        eprintln!("{count} of {} forces raised, by up to {largest:.3} N", record.knots().len());
    }
    let contact = Contact::new(Patellofemoral, medium, record.load()?)?;
    // All of them before the first is written, so that a load that falls too fast leaves no part of a table.
    let states = states(&contact, record.knots()).map_err(|error| record.locate(error))?;

    let mut out = io::stdout().lock();
    writeln!(out, "time_s,force_n,radius_mm,approach_mm,peak_pressure_mpa")?;
    for (&(time, _), [force, radius, approach, peak_pressure]) in record.knots().iter().zip(states) {
        writeln!(out, "{time},{force},{radius:.5},{approach:.6},{peak_pressure:.6}")?;
    }
    Ok(())
}

/// Force, contact radius, approach and peak pressure at every knot; at both knots of a step those after the step.
fn states<L: Load<f64>>(
    contact: &Contact<f64, Patellofemoral, L>,
    knots: &[Knot],
) -> Result<Vec<[f64; 4]>, ContactError> {
    let times: Vec<f64> = knots.iter().map(|&(time, _)| time).collect();
    let mut peak_pressures = vec![0.0; times.len()];
    // Each time begins where the last one ended, instead of with the first knot.
    contact.pressure_field(&times, &[0.0], &mut peak_pressures)?;
    let states = times.iter().zip(peak_pressures).map(|(&time, peak_pressure)| {
        let now = contact.at(time)?;
        Ok([now.force(), now.radius(), now.approach(), peak_pressure])
    });
    states.collect()
}
