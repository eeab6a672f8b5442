//! The ratios that are asked of this crate, from what `cargo bench` has measured: a table at its end.
//!
//! `cargo bench --bench summary` prints it again; `cargo bench --bench summary -- --write [FILE]` also writes it
//! into the README, or another file, between `<!-- ratios:begin -->` and `<!-- ratios:end -->`.

mod items;
mod measurements;
mod table;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

use measurements::Measurements;

fn main() -> Result<(), Box<dyn Error>> {
    let measurements = Measurements::read(&measurements::folder()?)?;
    let table = table::of(&items::items(&measurements));
    println!("{table}");
    if let Some(age) = measurements.spread_in_minutes().filter(|&minutes| minutes > 60) {
        println!(
            "The oldest of these measurements is {age} minutes older than the newest: run `cargo bench`."
        );
    }
    if let Some(file) = file_to_write() {
        let text = fs::read_to_string(&file)?;
        fs::write(&file, table::inserted(&text, &table)?)?;
        println!("Written to {}.", file.display());
    }
    Ok(())
}

/// What follows `--write`, if anything; cargo adds options of its own.
fn file_to_write() -> Option<PathBuf> {
    let mut arguments = env::args().skip_while(|argument| argument != "--write").skip(1);
    let readme = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    env::args().any(|argument| argument == "--write").then(|| {
        arguments.next().filter(|argument| !argument.starts_with('-')).map_or_else(readme, PathBuf::from)
    })
}
