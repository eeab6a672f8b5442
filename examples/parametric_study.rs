//! A parametric study: how do peak pressures spread with the spread of joints, cartilage and loads?
//!
//! ```text
//! cargo run --release --example parametric_study
//! cargo run --release --example parametric_study -- --scenes 100000 --threads 2 --seed 7
//! ```
//!
//! A scene is a patient: a femoral condyle in the hollow of a tibial plateau, each with its own cartilage, under the
//! patient's own load. The population is made up: its means are of the size of a knee's, and its spreads show the
//! method. Each block of scenes has its own random stream, so that the results depend on the seed alone, not on the
//! number of threads.

use std::collections::BTreeMap;
use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use cartcontact::{Contact, ContactError, Layer, Medium, MediumError, ProfileError, gap_profile, load};
use clap::{Parser, value_parser};
use examples::histogram::Histogram;
use indicatif::{ProgressBar, ProgressStyle};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;
use rand_distr::{Distribution, LogNormal};
use rayon::ThreadPoolBuilder;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Two spheres to fourth order in the distance from the axis; the fields are their radii in mm.
///
/// Up to 3/4 of the condyle's radius the sixth order of either sphere is at most 4 % of its second order. The closer
/// the fit, the larger its share in the difference: at most 8 % where the plateau has twice the condyle's radius.
#[gap_profile(
    (1/condyle - 1/plateau) * r^2 / 2 + (1/condyle^3 - 1/plateau^3) * r^4 / 8,
    max_radius = 3/4 * condyle
)]
struct Knee {
    condyle: f64,
    plateau: f64,
}

/// The time of the states, in s after the load was applied.
const TIME: f64 = 200.0;
/// How many scenes are drawn from one random stream.
const BLOCK: u64 = 4096;
/// The quantiles in the table.
const QUANTILES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];
/// The path of the figure, relative to the folder in which the program runs.
const FIGURE: &str = "target/cartcontact/parametric_study.svg";

/// The spread of peak pressures in a population of joints.
#[derive(Debug, Parser)]
struct Options {
    /// How many scenes; a million takes 40 MB
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    #[arg(value_parser = value_parser!(u64).range(100..=100_000_000))]
    scenes: u64,
    /// How many threads share the scenes
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value_parser!(u16).range(1..=1024))]
    threads: u16,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    examples::finish(run(&Options::parse()))
}

fn run(&Options { scenes, threads, seed }: &Options) -> Result<(), Box<dyn Error>> {
    let population = Population::new()?;
    let threads = usize::from(threads);
    let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
    let start = Instant::now();
    let study = pool.install(|| Study::of(&population, scenes, seed));
    let elapsed = start.elapsed().as_secs_f64();

    let mut out = io::stdout().lock();
    let plural = if threads == 1 { "" } else { "s" };
    let nanoseconds = 1e9 * elapsed / scenes as f64;
    writeln!(out, "{scenes} scenes in {elapsed:.3} s on {threads} thread{plural}: {nanoseconds:.0} ns each")?;
    study.write_faults(&mut out)?;
    if study.states.is_empty() {
        return Err("no scene has a contact that could be summarised; draw more with --scenes".into());
    }
    let peak_pressures = study.write_quantiles(&mut out)?;
    draw(&peak_pressures, scenes)?;
    writeln!(out, "\nFigure\n  {FIGURE}")?;
    Ok(())
}

/// What varies from patient to patient, log-normally, because none of it can be negative.
struct Population {
    /// Radii of curvature, in mm.
    condyle: LogNormal<f64>,
    plateau: LogNormal<f64>,
    /// Of each layer, in mm, MPa and mm⁴/(N s).
    thickness: LogNormal<f64>,
    shear_modulus: LogNormal<f64>,
    permeability: LogNormal<f64>,
    /// In N.
    force: LogNormal<f64>,
}

impl Population {
    /// Means, and standard deviations in units of the means.
    fn new() -> Result<Self, rand_distr::NormalError> {
        Ok(Self {
            condyle: LogNormal::from_mean_cv(30.0, 0.1)?,
            plateau: LogNormal::from_mean_cv(60.0, 0.2)?,
            thickness: LogNormal::from_mean_cv(2.0, 0.2)?,
            shear_modulus: LogNormal::from_mean_cv(0.25, 0.25)?,
            permeability: LogNormal::from_mean_cv(2e-3, 0.3)?,
            force: LogNormal::from_mean_cv(300.0, 0.3)?,
        })
    }

    /// Draws a patient and solves the contact.
    fn scene(&self, random: &mut ChaCha8Rng) -> Result<State, Fault> {
        let knee = Knee { condyle: self.condyle.sample(random), plateau: self.plateau.sample(random) };
        let layers = [self.layer(random), self.layer(random)];
        let force = self.force.sample(random);

        let medium = Medium::between(layers[0], layers[1]).map_err(Fault::Medium)?;
        let contact = Contact::new(knee, medium, load::Constant(force)).map_err(Fault::Contact)?;
        let now = contact.at(TIME).map_err(Fault::Contact)?;
        Ok(State {
            radius: now.radius(),
            approach: now.approach(),
            peak_pressure: now.peak_pressure(),
            thickness: 0.5 * (layers[0].thickness + layers[1].thickness),
        })
    }

    fn layer(&self, random: &mut ChaCha8Rng) -> Layer<f64> {
        Layer {
            thickness: self.thickness.sample(random),
            shear_modulus: self.shear_modulus.sample(random),
            permeability: self.permeability.sample(random),
        }
    }
}

/// The results of a scene.
#[derive(Debug, PartialEq)]
struct State {
    radius: f64,
    approach: f64,
    peak_pressure: f64,
    /// The mean of the two layers.
    thickness: f64,
}

/// Why a scene has no contact.
enum Fault {
    Medium(MediumError),
    Contact(ContactError),
}

impl Fault {
    fn reason(&self) -> String {
        match self {
            Self::Contact(ContactError::Profile(ProfileError::NotOpening { .. })) => {
                "the hollow is no wider than the condyle".into()
            }
            Self::Contact(ContactError::BeyondRange { .. }) => "the contact outgrows the geometry".into(),
            Self::Contact(error) => error.to_string(),
            Self::Medium(error) => error.to_string(),
        }
    }
}

/// The outcomes of the scenes, in the order of the scenes.
#[derive(Default)]
struct Study {
    states: Vec<State>,
    faults: Vec<Fault>,
}

impl Study {
    /// Solves scenes on all threads of the pool, with a progress bar on a terminal.
    fn of(population: &Population, scenes: u64, seed: u64) -> Self {
        let bar = progress_bar(scenes);
        let blocks: Vec<Self> = (0..scenes.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let size = BLOCK.min(scenes - block * BLOCK);
                let study = Self::of_block(population, size, seed, block);
                bar.inc(size);
                study
            })
            .collect();
        bar.finish_and_clear();

        let mut study = Self::default();
        study.states.reserve_exact(blocks.iter().map(|block| block.states.len()).sum());
        for block in blocks {
            study.states.extend(block.states);
            study.faults.extend(block.faults);
        }
        study
    }

    fn of_block(population: &Population, scenes: u64, seed: u64, block: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(block);
        let mut study = Self::default();
        for _ in 0..scenes {
            match population.scene(&mut random) {
                Ok(state) => study.states.push(state),
                Err(fault) => study.faults.push(fault),
            }
        }
        study
    }

    fn write_faults(&self, out: &mut impl Write) -> io::Result<()> {
        let mut reasons = BTreeMap::new();
        for fault in &self.faults {
            *reasons.entry(fault.reason()).or_insert(0_usize) += 1;
        }
        writeln!(out, "{:>9} of them without a contact", self.faults.len())?;
        reasons.iter().try_for_each(|(reason, count)| writeln!(out, "{count:>9} because {reason}"))
    }

    /// Writes the quantiles of all results, and returns the peak pressures in ascending order.
    fn write_quantiles(&self, out: &mut impl Write) -> io::Result<Vec<f64>> {
        write!(out, "\nQuantiles after {TIME} s         ")?;
        QUANTILES.iter().try_for_each(|quantile| write!(out, "{:>6} %", 100.0 * quantile))?;
        writeln!(out)?;
        let mut write_row = |name: &str, quantity: fn(&State) -> f64| {
            let mut values: Vec<f64> = self.states.iter().map(quantity).collect();
            values.sort_unstable_by(f64::total_cmp);
            write!(out, "{name:30}")?;
            QUANTILES.iter().try_for_each(|&quantile| write!(out, "{:>8.3}", at(quantile, &values)))?;
            writeln!(out)?;
            io::Result::Ok(values)
        };
        write_row("contact radius (mm)", |state| state.radius)?;
        write_row("contact radius / thickness", |state| state.radius / state.thickness)?;
        write_row("approach (mm)", |state| state.approach)?;
        write_row("peak pressure (MPa)", |state| state.peak_pressure)
    }
}

/// The quantile of values in ascending order.
fn at(quantile: f64, values: &[f64]) -> f64 {
    values[(quantile * (values.len() - 1) as f64).round() as usize]
}

/// A line on the standard error, at most 67 columns wide; nothing if that is no terminal.
fn progress_bar(scenes: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} left");
    ProgressBar::new(scenes).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn draw(peak_pressures: &[f64], scenes: u64) -> Result<(), Box<dyn Error>> {
    let marks = QUANTILES.map(|quantile| (format!("{} %", 100.0 * quantile), at(quantile, peak_pressures)));
    let histogram = Histogram {
        title: format!("{} of {scenes} scenes have a contact; after {TIME} s", peak_pressures.len()),
        label: "peak pressure (MPa)",
        unit: "MPa",
        bin: 0.025,
        // The end of the tail is a few scenes, too few to be visible.
        end: at(0.9995, peak_pressures),
        marks: marks.to_vec(),
    };
    histogram.write(Path::new(FIGURE), peak_pressures)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_do_not_change_the_study() -> Result<(), Box<dyn Error>> {
        let population = Population::new()?;
        let scenes = 3 * BLOCK + 7;
        let study = |threads, seed| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
            Ok::<_, Box<dyn Error>>(pool.install(|| Study::of(&population, scenes, seed)))
        };
        let (alone, shared, other) = (study(1, 1)?, study(3, 1)?, study(1, 2)?);
        assert_eq!(alone.states, shared.states);
        assert_ne!(alone.states, other.states);
        assert_eq!(alone.states.len() + alone.faults.len(), scenes as usize);
        Ok(())
    }
}
