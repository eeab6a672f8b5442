//! What the examples share.

pub mod figure;
pub mod histogram;
pub mod load_record;
pub mod log_log;
pub mod page;

use std::error::Error;
use std::io;
use std::process::ExitCode;

use clap::Parser;

/// The command line of an example that has no options, so that it refuses others.
#[derive(Debug, Parser)]
#[command(about = None)]
struct NoOptions;

/// Runs an example that has no options.
pub fn run(body: impl FnOnce() -> Result<(), Box<dyn Error>>) -> ExitCode {
    NoOptions::parse();
    finish(body())
}

/// Ends a program: an error is written to the standard error, and the exit code is 1.
///
/// A reader that closes the pipe early, such as `head`, is no error.
pub fn finish(outcome: Result<(), Box<dyn Error>>) -> ExitCode {
    let Err(error) = outcome else {
        return ExitCode::SUCCESS;
    };
    let is_closed_pipe =
        error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == io::ErrorKind::BrokenPipe);
    if is_closed_pipe {
        return ExitCode::SUCCESS;
    }
    eprintln!("error: {error}");
    ExitCode::FAILURE
}
