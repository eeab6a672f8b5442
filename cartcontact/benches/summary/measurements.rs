//! Criterion's measurements: for each benchmark the least time per element.
//!
//! It is the least, not the mean, because disturbances only add to a time: the least of a hundred samples repeats best,
//! and ratios of such times repeat better than ratios of means. Where others use the processor, which can slow a
//! benchmark down as long as it runs, `cargo bench -p cartcontact -- --save-baseline second` keeps another run: the least
//! of all counts.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{env, fs};

use serde_json::Value;

/// Nanoseconds per element, by the full name of a benchmark.
pub(crate) struct Measurements {
    times: BTreeMap<String, f64>,
    /// When the first and the last measurement were taken.
    taken: Option<(SystemTime, SystemTime)>,
}

impl Measurements {
    /// All measurements below a folder, of all runs that were kept; files that are not criterion's are skipped.
    pub(crate) fn read(folder: &Path) -> Result<Self, Box<dyn Error>> {
        let mut measurements = Measurements { times: BTreeMap::new(), taken: None };
        measurements.add(folder)?;
        Ok(measurements)
    }

    pub(crate) fn time(&self, name: &str) -> Option<f64> {
        self.times.get(name).copied()
    }

    /// How much older the oldest measurement is than the newest.
    pub(crate) fn spread_in_minutes(&self) -> Option<u64> {
        let (first, last) = self.taken?;
        Some(last.duration_since(first).ok()?.as_secs() / 60)
    }

    fn add(&mut self, folder: &Path) -> Result<(), Box<dyn Error>> {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if !path.is_dir() {
                continue;
            }
            let Some((name, time)) = measurement(&path) else {
                self.add(&path)?;
                continue;
            };
            let least = self.times.entry(name).or_insert(time);
            *least = least.min(time);
            let taken = fs::metadata(path.join("sample.json"))?.modified()?;
            let (first, last) = self.taken.unwrap_or((taken, taken));
            self.taken = Some((first.min(taken), last.max(taken)));
        }
        Ok(())
    }
}

/// The name of a benchmark and the least time of its samples, per element if it states their number.
fn measurement(folder: &Path) -> Option<(String, f64)> {
    let json = |file: &str| -> Option<Value> {
        serde_json::from_str(&fs::read_to_string(folder.join(file)).ok()?).ok()
    };
    let (benchmark, sample) = (json("benchmark.json")?, json("sample.json")?);
    let elements = benchmark["throughput"]["Elements"].as_f64().unwrap_or(1.0);
    let numbers = |key: &str| Some(sample[key].as_array()?.iter().filter_map(Value::as_f64));
    let times = numbers("times")?.zip(numbers("iters")?).map(|(time, count)| time / count);
    let least = times.reduce(f64::min)?;
    Some((benchmark["full_id"].as_str()?.to_owned(), least / elements))
}

/// Criterion's folder: the one in the environment, or the one beside the folder of this program.
pub(crate) fn folder() -> Result<PathBuf, Box<dyn Error>> {
    if let Some(folder) = env::var_os("CRITERION_HOME") {
        return Ok(folder.into());
    }
    let program = env::current_exe()?;
    let beside = program.ancestors().map(|folder| folder.join("criterion")).find(|folder| folder.is_dir());
    beside.ok_or_else(|| "there are no measurements yet: run `cargo bench`".into())
}
