//! The ratios and targets of this crate, as a table at the end of `cargo bench`.
//!
//! `cargo bench --bench summary` prints it again; `cargo bench --bench summary -- --write` also writes it into
//! `benches/RESULTS.md`, and what has a target into the README, between `<!-- ratios:begin -->` and `<!-- ratios:end
//! -->`, beside the measurements there of processors with other vectors, unless some measurements are more than an hour
//! older than others, perhaps because their benchmark no longer exists, or some are missing, perhaps because their names
//! have changed: the whole column is renewed.

mod items;
mod measurements;
mod table;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use measurements::Measurements;
use table::Table;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = measurements::folder()?;
    let measurements = Measurements::read(&folder)?;
    let items = items::items(&measurements);
    println!("{}", Table::of(&items).markdown());
    let outdated = measurements.spread_in_minutes().filter(|&minutes| minutes > 60).map(|age| {
        format!(
            "The oldest of these measurements is {age} minutes older than the newest, so that their ratios mean \
             little: remove {} and run `cargo bench`.",
            folder.display()
        )
    });
    if env::args().any(|argument| argument == "--write") {
        outdated.map_or(Ok(()), Err)?;
        let missing = items::missing(&measurements);
        if !missing.is_empty() {
            return Err(format!("Not measured: {}; run all of `cargo bench`.", missing.join("; ")).into());
        }
        write("benches/RESULTS.md", &Table::of(&items))?;
        write("../README.md", &Table::of(items.iter().filter(|item| item.asked.is_some())))?;
    } else if let Some(warning) = outdated {
        println!("{warning}");
    }
    Ok(())
}

/// Writes a table to its place in a file of the package.
fn write(name: &str, table: &Table) -> Result<(), Box<dyn Error>> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let text = fs::read_to_string(&file)?;
    fs::write(&file, table.inserted(&text)?)?;
    println!("Written to {}.", file.display());
    Ok(())
}
