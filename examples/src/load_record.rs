//! A load as a force sensor records it: a CSV file with the header `time_s,force_n`.

use std::error::Error;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use cartcontact::ContactError;
use cartcontact::load::{LoadError, PiecewiseLinear};

/// A time in s and the force in N at that time.
pub type Knot = (f64, f64);

const HEADER: &str = "time_s,force_n";

/// The letters of a first line that a message shows: a file without line breaks is one line.
const SHOWN: usize = 60;

/// The rows of a record, with their lines in the file.
#[derive(Debug)]
pub struct LoadRecord {
    path: PathBuf,
    knots: Vec<Knot>,
    lines: Vec<usize>,
}

impl LoadRecord {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, and as [`parse`](Self::parse).
    pub fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let text = fs::read_to_string(path).map_err(|error| {
            let is_other_text = error.kind() == io::ErrorKind::InvalidData;
            let remedy = if is_other_text { "; save the table as CSV in UTF-8" } else { "" };
            format!("cannot read `{}`: {error}{remedy}", path.display())
        })?;
        Ok(Self::parse(path, &text)?)
    }

    /// Reads the text of a file; the path is for error messages.
    ///
    /// # Errors
    ///
    /// [`RecordError`] at the first line that is not two numbers.
    pub fn parse(path: &Path, text: &str) -> Result<Self, RecordError> {
        let mut record = Self { path: path.to_owned(), knots: Vec::new(), lines: Vec::new() };
        // Spreadsheets begin a file with a byte order mark, and end lines with `\r\n` or, "for Macintosh", with `\r`.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n").replace('\r', "\n");
        let first = text.lines().next().unwrap_or_default().trim();
        if first != HEADER {
            return Err(record.error(1, Problem::Header(first.chars().take(SHOWN).collect())));
        }
        for (number, row) in (1..).zip(text.lines()).skip(1) {
            if row.trim().is_empty() {
                continue;
            }
            record.knots.push(knot(row).map_err(|problem| record.error(number, problem))?);
            record.lines.push(number);
        }
        Ok(record)
    }

    /// The rows in the order of the file.
    pub fn knots(&self) -> &[Knot] {
        &self.knots
    }

    /// Raises each force that falls faster than the contact can follow, with the rate χ of its layers, to the lowest that
    /// it can, and returns how many these are, and the largest rise.
    pub fn clamp(&mut self, chi: f64) -> (usize, f64) {
        let (mut count, mut largest) = (0, 0.0);
        for row in 1..self.knots.len() {
            let ((before, former), (time, force)) = (self.knots[row - 1], self.knots[row]);
            let lowest = former / (1.0 + chi * (time - before));
            // Not `max`, which would hide a force that is not a number.
            if force < lowest {
                self.knots[row].1 = lowest;
                count += 1;
                largest = f64::max(largest, lowest - force);
            }
        }
        (count, largest)
    }

    /// The load through the rows, linear between them.
    ///
    /// # Errors
    ///
    /// [`RecordError`] with the line of the row that cannot be a knot of a load.
    pub fn load(&self) -> Result<PiecewiseLinear<f64, &[Knot]>, RecordError> {
        PiecewiseLinear::new(self.knots()).map_err(|error| {
            let row = match error {
                LoadError::InvalidTime { knot, .. }
                | LoadError::Unsorted { knot, .. }
                | LoadError::RepeatedTime { knot, .. }
                | LoadError::TooSteep { knot, .. } => Some(knot),
                LoadError::InvalidForce { .. } => {
                    self.knots.iter().position(|&(_, force)| !(force.is_finite() && force >= 0.0))
                }
                _ => self.knots.first().map(|_| 0),
            };
            self.error(self.line(row), Problem::Load(error))
        })
    }

    /// An error of the contact, with the line of the record in which it begins.
    pub fn locate(&self, error: ContactError) -> RecordError {
        let since = match error {
            ContactError::Receding { since, .. } => since,
            ContactError::BeyondRange { leaves_at, .. } => leaves_at,
            ContactError::Unrepresentable { time, .. } | ContactError::Radius { time, .. } => time,
            _ => 0.0,
        };
        let row = self.knots.iter().rposition(|&(time, _)| time <= since);
        self.error(self.line(row), Problem::Contact(error))
    }

    /// The line of a row, or of the header if there is none.
    fn line(&self, row: Option<usize>) -> usize {
        row.and_then(|row| self.lines.get(row)).copied().unwrap_or(1)
    }

    fn error(&self, line: usize, problem: Problem) -> RecordError {
        RecordError { path: self.path.clone(), line, problem }
    }
}

fn knot(row: &str) -> Result<Knot, Problem> {
    let cells: Vec<&str> = row.split(',').map(str::trim).collect();
    let &[time, force] = cells.as_slice() else {
        return Err(Problem::Columns(cells.len()));
    };
    let number = |cell: &str| cell.parse().map_err(|_| Problem::Number(cell.to_owned()));
    Ok((number(time)?, number(force)?))
}

/// What is wrong with a record, and where.
#[derive(Debug)]
pub struct RecordError {
    path: PathBuf,
    line: usize,
    problem: Problem,
}

#[derive(Debug)]
enum Problem {
    Header(String),
    Columns(usize),
    Number(String),
    Load(LoadError),
    Contact(ContactError),
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: ", self.path.display(), self.line)?;
        match &self.problem {
            Problem::Header(found) => {
                write!(f, "the first line is `{found}`, but it must be the header `{HEADER}`")
            }
            Problem::Columns(count) => {
                write!(
                    f,
                    "a row has 2 columns, {HEADER}, but this one has {count}; separate them by a comma, and write \
                     decimals with a point"
                )
            }
            Problem::Number(cell) if cell.is_empty() => {
                f.write_str("a cell is empty; write a number such as 20.5, or leave out the row")
            }
            Problem::Number(cell) => write!(f, "`{cell}` is not a number; write one such as 20.5"),
            Problem::Load(error) => error.fmt(f),
            Problem::Contact(error @ ContactError::Receding { .. }) => {
                write!(f, "{error}; the option `--clamp` does so")
            }
            Problem::Contact(error) => error.fmt(f),
        }
    }
}

impl Error for RecordError {}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows of a text, or the message of the error from reading it or making a load of it.
    fn knots(text: &str) -> Result<Vec<Knot>, String> {
        let record = LoadRecord::parse(Path::new("a.csv"), text).map_err(|error| error.to_string())?;
        record.load().map_err(|error| error.to_string())?;
        Ok(record.knots)
    }

    #[test]
    fn rows_are_knots() {
        assert_eq!(knots("time_s,force_n\n0,0\n1.5, 2e1\n"), Ok(vec![(0.0, 0.0), (1.5, 20.0)]));
    }

    #[test]
    fn spreadsheet_habits_are_tolerated() {
        for text in ["\u{feff}time_s,force_n\r\n0,1\r\n\r\n", "time_s,force_n\r0,1\r\r"] {
            assert_eq!(knots(text), Ok(vec![(0.0, 1.0)]), "{text:?}");
        }
        let fault = knots("time_s,force_n\r\n0,1\r\nend\r\n").err().unwrap_or_default();
        assert!(fault.starts_with("a.csv:3: a row has 2 columns"), "{fault}");
    }

    #[test]
    fn faults_have_their_line() {
        let faults = [
            ("", "a.csv:1: the first line is ``, but it must be the header `time_s,force_n`"),
            ("0,1\n", "a.csv:1: the first line is `0,1`, but it must be the header"),
            ("time_s;force_n\n0;1\n", "a.csv:1: the first line is `time_s;force_n`"),
            ("time_s,force_n\n", "a.csv:1: the load has no knots"),
            (
                "time_s,force_n\n0,1\n1,2,3\n",
                "a.csv:3: a row has 2 columns, time_s,force_n, but this one has 3; separate them",
            ),
            ("time_s,force_n\n0,1\n\n1,two\n", "a.csv:4: `two` is not a number; write one such as 20.5"),
            ("time_s,force_n\n0,1\n1, \n", "a.csv:3: a cell is empty; write a number such as 20.5, or leave"),
            ("time_s,force_n\n0,1\n1,-2\n", "a.csv:3: the force at time 1 is -2"),
            ("time_s,force_n\n0,1\n1,NaN\n", "a.csv:3: the force at time 1 is NaN"),
            ("time_s,force_n\n0,1\n2,1\n1,1\n", "a.csv:4: knot 2 is at time 1"),
            ("time_s,force_n\n5,1\n", "a.csv:2: the first knot is at time 5"),
        ];
        for (text, message) in faults {
            let found = knots(text).err().unwrap_or_default();
            assert!(found.starts_with(message), "{text:?} gave {found:?}");
        }
    }

    #[test]
    fn a_file_of_one_line_is_not_shown_in_full() {
        let found = knots(&"[0, 1], ".repeat(1000)).err().unwrap_or_default();
        assert!(
            found.starts_with("a.csv:1: the first line is `[0, 1], [0, 1]") && found.len() < 200,
            "{found}"
        );
    }

    #[test]
    fn clamped_falls_are_as_fast_as_allowed() -> Result<(), RecordError> {
        let text = "time_s,force_n\n0,9\n10,8\n20,-1\n30,NaN\n";
        let mut record = LoadRecord::parse(Path::new("a.csv"), text)?;
        assert_eq!(record.clamp(0.1), (1, 5.0));
        assert_eq!(record.knots()[..3], [(0.0, 9.0), (10.0, 8.0), (20.0, 4.0)]);
        assert!(record.load().is_err());
        Ok(())
    }

    #[test]
    fn a_fall_that_is_too_fast_has_the_line_in_which_it_begins() -> Result<(), RecordError> {
        let record = LoadRecord::parse(Path::new("a.csv"), "time_s,force_n\n0,9\n10,9\n20,1\n")?;
        let error = record.locate(ContactError::Receding { time: 20.0, since: 10.0 });
        assert!(error.to_string().starts_with("a.csv:3: the load falls faster"), "{error}");
        Ok(())
    }
}
