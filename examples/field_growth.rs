//! How the time for a pressure field grows with its size: with the number of times plus that of radii plus that of
//! values.
//!
//! ```text
//! cargo run --release --example field_growth
//! ```
//!
//! The figure compares computing a field with filling the same memory with a constant. Every point is the shortest of
//! several runs, in which the two take turns. Both take longer per value where the memory no longer fits into the
//! cache.

use std::error::Error;
use std::hint::black_box;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use cartcontact::{Contact, Layer, Medium, gap_profile, load};
use examples::figure::{Curve, Dash};
use examples::log_log::{self, Mark, Panel};
use examples::page::Ink;

/// Patella on the patellar groove, in mm.
#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct Patellofemoral;

const LAYER: Layer<f64> = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
/// Applied from t = 0 on, in N.
const FORCE: f64 = 100.0;
/// The last time, in s, at which the contact has a radius of 7.7 mm, and the last radius, in mm.
const LAST: (f64, f64) = (400.0, 9.0);

/// The numbers of times, of radii, or of both; a matrix with the largest number of both would fill 0.8 GB.
const COUNTS: [usize; 9] = [100, 500, 1000, 2000, 3000, 4000, 6000, 8000, 10_000];
const LARGEST_SQUARE: usize = 3000;
const FIXED: usize = 100;
const RUNS: usize = 40;

/// The path of the figure, relative to the folder in which the program runs.
const FIGURE: &str = "target/cartcontact/field_growth.svg";

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    let contact = Contact::new(Patellofemoral, Medium::between(LAYER, LAYER)?, load::Constant(FORCE))?;
    let mut out = io::stdout().lock();
    writeln!(out, " times × radii   field, ms   filling, ms   ratio")?;
    let mut panels = Vec::new();
    for series in all_series() {
        let times = series.measure(&contact, &mut out)?;
        panels.push(series.panel(&times));
    }
    log_log::write(Path::new(FIGURE), 70.0, &panels)?;
    writeln!(out, "\nFigure\n  {FIGURE}")?;
    Ok(())
}

type Joint = Contact<f64, Patellofemoral, load::Constant<f64>>;

/// Fields that grow in one way, shown in one panel of the figure.
struct Series {
    title: &'static str,
    /// Times and radii of every field.
    sizes: Vec<(usize, usize)>,
}

fn all_series() -> [Series; 3] {
    let squares = COUNTS.into_iter().filter(|&count| count <= LARGEST_SQUARE);
    [
        Series { title: "N times × 100 radii", sizes: COUNTS.map(|count| (count, FIXED)).to_vec() },
        Series { title: "100 times × N radii", sizes: COUNTS.map(|count| (FIXED, count)).to_vec() },
        Series { title: "N times × N radii", sizes: squares.map(|count| (count, count)).collect() },
    ]
}

impl Series {
    /// Writes a line for every size, and returns the times for the field and for filling its memory, in ms.
    fn measure(&self, contact: &Joint, out: &mut impl Write) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
        let mut all = Vec::new();
        for &(times, radii) in &self.sizes {
            let [field, filling] = milliseconds(contact, times, radii)?;
            writeln!(out, "{times:6} × {radii:<5} {field:11.4} {filling:13.4} {:7.2}", field / filling)?;
            all.push([field, filling]);
        }
        Ok(all)
    }

    fn panel(&self, milliseconds: &[[f64; 2]]) -> Panel {
        let series = |name: &str, ink, dash, mark, which: usize| {
            let values = self.sizes.iter().map(|&(times, radii)| (times * radii) as f64);
            let points = values.zip(milliseconds.iter().map(|time| time[which])).collect();
            log_log::Series { curve: Curve { name: name.to_owned(), ink, dash, points }, mark }
        };
        Panel {
            title: self.title.to_owned(),
            x: "number of values",
            y: "time (ms)",
            series: vec![
                series("pressure field", Ink::Blue, Dash::Solid, Mark::Disc, 0),
                series("filling the same memory", Ink::Vermilion, Dash::Dashed, Mark::Triangle, 1),
            ],
        }
    }
}

/// The times for a field and for filling its memory, in ms.
fn milliseconds(contact: &Joint, times: usize, radii: usize) -> Result<[f64; 2], Box<dyn Error>> {
    let (times, radii) = (steps(times, LAST.0), steps(radii, LAST.1));
    let mut values = vec![0.0; times.len() * radii.len()];
    let mut shortest = [f64::INFINITY; 2];
    for _ in 0..RUNS {
        let start = Instant::now();
        contact.pressure_field(black_box(&times), black_box(&radii), &mut values)?;
        shortest[0] = shortest[0].min(start.elapsed().as_secs_f64() * 1e3);
        let start = Instant::now();
        black_box(&mut values[..]).fill(black_box(1.5));
        shortest[1] = shortest[1].min(start.elapsed().as_secs_f64() * 1e3);
    }
    Ok(shortest)
}

/// `count` values from 0 to `end`.
fn steps(count: usize, end: f64) -> Vec<f64> {
    (0..count).map(|k| end * k as f64 / (count - 1) as f64).collect()
}
