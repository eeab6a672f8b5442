//! Options of the command line: `--name N` or `--name=N`, with whole numbers such as 7 or 1e6.

use std::env;
use std::error::Error;
use std::fmt;
use std::io::{self, Write};

/// An option.
#[derive(Clone, Copy, Debug)]
pub struct Flag {
    /// The name with its dashes.
    pub name: &'static str,
    /// The text in the help.
    pub about: &'static str,
    /// Its default value.
    pub default: u64,
    /// Its smallest value.
    pub least: u64,
    /// Its largest value.
    pub most: u64,
}

/// The values of the options; none if the arguments ask for help, which is then written to the standard output.
///
/// # Errors
///
/// [`OptionError`] for an unknown option, and for a value that is missing, no number or out of range; an
/// [`io::Error`] if the help cannot be written.
pub fn read<const N: usize>(example: &str, flags: [Flag; N]) -> Result<Option<[u64; N]>, Box<dyn Error>> {
    let arguments = env::args_os().skip(1).map(|argument| argument.to_string_lossy().into_owned());
    let values = parse(flags, arguments)?;
    if values.is_none() {
        write_help(&mut io::stdout().lock(), example, &flags)?;
    }
    Ok(values)
}

/// Whether an argument asks for help.
#[must_use]
pub fn is_help(argument: &str) -> bool {
    argument == "--help" || argument == "-h"
}

fn write_help(out: &mut impl Write, example: &str, flags: &[Flag]) -> io::Result<()> {
    writeln!(out, "Usage: cargo run --release --example {example} -- [options]\n")?;
    for Flag { name, about, default, .. } in flags {
        writeln!(out, "  {:16} {about}; {default} if not given", format!("{name} N"))?;
    }
    writeln!(out, "  {:16} shows this", "--help")
}

fn parse<const N: usize>(
    flags: [Flag; N],
    mut arguments: impl Iterator<Item = String>,
) -> Result<Option<[u64; N]>, OptionError> {
    let mut values = flags.map(|flag| flag.default);
    while let Some(argument) = arguments.next() {
        if is_help(&argument) {
            return Ok(None);
        }
        let (name, joined) = match argument.split_once('=') {
            Some((name, value)) => (name, Some(value.to_owned())),
            None => (argument.as_str(), None),
        };
        let Some(index) = flags.iter().position(|flag| flag.name == name) else {
            return Err(OptionError::Unknown(argument));
        };
        let value = joined.or_else(|| arguments.next());
        values[index] = number(flags[index], value)?;
    }
    Ok(Some(values))
}

fn number(flag: Flag, value: Option<String>) -> Result<u64, OptionError> {
    let number = value.as_ref().and_then(|value| whole(value));
    match number {
        Some(number) if (flag.least..=flag.most).contains(&number) => Ok(number),
        _ => Err(OptionError::Value(flag, value)),
    }
}

/// A whole number in digits, or in digits and an exponent.
fn whole(text: &str) -> Option<u64> {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    digits.parse::<u64>().ok()?.checked_mul(10_u64.checked_pow(exponent.parse().ok()?)?)
}

/// What is wrong with the command line.
#[derive(Debug)]
pub enum OptionError {
    /// An argument that is not an option.
    Unknown(String),
    /// An option with no value, or with one that is no number or out of range.
    Value(Flag, Option<String>),
}

impl fmt::Display for OptionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(argument) => {
                write!(f, "there is no option `{argument}`; `--help` shows what there is")
            }
            Self::Value(Flag { name, least, most, .. }, value) => {
                write!(f, "`{name}` needs a whole number from {least} to {most}, but ")?;
                match value {
                    Some(value) => write!(f, "it is `{value}`"),
                    None => write!(f, "nothing follows it"),
                }
            }
        }
    }
}

impl Error for OptionError {}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values of a command line, or the message of its error.
    fn values(line: &str) -> Result<Option<[u64; 2]>, String> {
        let scenes = Flag { name: "--scenes", about: "", default: 10, least: 1, most: 99 };
        let seed = Flag { name: "--seed", about: "", default: 0, least: 0, most: u64::MAX };
        let arguments = line.split_whitespace().map(str::to_owned);
        parse([scenes, seed], arguments).map_err(|error| error.to_string())
    }

    #[test]
    fn both_spellings_are_read() {
        assert_eq!(values(""), Ok(Some([10, 0])));
        assert_eq!(values("--seed 7 --scenes=12"), Ok(Some([12, 7])));
        assert_eq!(values("--seed 25e17 --scenes 1e1"), Ok(Some([10, 2_500_000_000_000_000_000])));
        assert_eq!(values("--seed 7 --help"), Ok(None));
    }

    #[test]
    fn faults_are_named() {
        let range = "`--scenes` needs a whole number from 1 to 99, but ";
        let faults = [
            ("--scene 7", "there is no option `--scene`; `--help` shows what there is".to_owned()),
            ("--scenes", format!("{range}nothing follows it")),
            ("--scenes many", format!("{range}it is `many`")),
            ("--scenes=0", format!("{range}it is `0`")),
            ("--scenes -1", format!("{range}it is `-1`")),
            ("--scenes 1e6", format!("{range}it is `1e6`")),
            ("--scenes 1e-1", format!("{range}it is `1e-1`")),
            ("--scenes 1e20", format!("{range}it is `1e20`")),
        ];
        for (line, message) in faults {
            assert_eq!(values(line), Err(message), "{line}");
        }
    }
}
