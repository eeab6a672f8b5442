//! The ratios and targets of this crate, as a table at the end of `cargo bench`.
//!
//! `cargo bench --bench summary` prints it again; `cargo bench --bench summary -- --write [FILE]` also writes it
//! into the README, or another file, between `<!-- ratios:begin -->` and `<!-- ratios:end -->`, beside the measurements
//! there of processors with other vectors, unless some measurements are more than an hour older than others, perhaps
//! because their benchmark no longer exists, or some of a group are missing, perhaps because their names have changed.

mod items;
mod measurements;
mod table;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

use measurements::Measurements;
use table::Table;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = measurements::folder()?;
    let measurements = Measurements::read(&folder)?;
    let table = Table::of(&items::items(&measurements));
    println!("{}", table.markdown());
    let outdated = measurements.spread_in_minutes().filter(|&minutes| minutes > 60).map(|age| {
        format!(
            "The oldest of these measurements is {age} minutes older than the newest, so that their ratios mean \
             little: remove {} and run `cargo bench`.",
            folder.display()
        )
    });
    if let Some(file) = file_to_write() {
        outdated.map_or(Ok(()), Err)?;
        let missing = items::missing(&measurements);
        if !missing.is_empty() {
            return Err(
                format!("Not measured, unlike others of their groups: {}.", missing.join("; ")).into()
            );
        }
        let text = fs::read_to_string(&file)?;
        fs::write(&file, table.inserted(&text)?)?;
        println!("Written to {}.", file.display());
    } else if let Some(warning) = outdated {
        println!("{warning}");
    }
    Ok(())
}

/// The file after `--write`, or the README; cargo adds options of its own.
fn file_to_write() -> Option<PathBuf> {
    let mut arguments = env::args().skip_while(|argument| argument != "--write").skip(1);
    let readme = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    env::args().any(|argument| argument == "--write").then(|| {
        arguments.next().filter(|argument| !argument.starts_with('-')).map_or_else(readme, PathBuf::from)
    })
}
