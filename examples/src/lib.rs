//! What the examples share.

pub mod figure;
pub mod histogram;
pub mod load_record;
pub mod log_log;
pub mod options;

use std::error::Error;
use std::io;
use std::process::ExitCode;

use options::Flag;

/// Runs an example with the values of its options, or shows its help.
pub fn run<const N: usize>(
    example: &str,
    flags: [Flag; N],
    body: impl FnOnce([u64; N]) -> Result<(), Box<dyn Error>>,
) -> ExitCode {
    finish(options::read(example, flags).and_then(|values| values.map_or(Ok(()), body)))
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
