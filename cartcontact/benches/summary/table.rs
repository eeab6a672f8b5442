//! The table in Markdown, and its place in a text.
//!
//! It has a column of measurements for every kind of processor that it was written on. Writing it again renews the
//! column of the present one and keeps the others.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::items::{Asked, Item};

const BEGIN: &str = "<!-- ratios:begin -->\n";
const END: &str = "<!-- ratios:end -->";

/// What stands where nothing is asked for or was measured.
const NONE: &str = "–";

/// The columns before the measurements.
const HEAD: [&str; 2] = ["result", "target"];

/// The kind of this processor: how wide its vectors are.
fn processor() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("avx512f") {
        return "512 bits";
    } else if std::is_x86_feature_detected!("avx2") {
        return "256 bits";
    }
    "128 bits"
}

/// A table as rows of cells, the first of which is the head.
pub(crate) struct Table(Vec<Vec<String>>);

impl Table {
    /// A row for every item; ratios that miss their target are bold.
    pub(crate) fn of<'a>(items: impl IntoIterator<Item = &'a Item>) -> Self {
        let head = HEAD.iter().chain(&[processor()]).map(|&cell| cell.to_owned()).collect();
        Self([head].into_iter().chain(items.into_iter().map(row)).collect())
    }

    /// The table in a text between the two marks.
    fn read(text: &str) -> Self {
        let cells = |line: &str| -> Vec<String> {
            line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
        };
        let is_row =
            |line: &&str| line.starts_with('|') && !line.starts_with("|-") && !line.starts_with("| -");
        Self(text.lines().filter(is_row).map(cells).collect())
    }

    /// The cell of a row and a column, both by name.
    fn cell(&self, row: &str, column: &str) -> Option<&str> {
        let place = self.0.first()?.iter().position(|name| name == column)?;
        self.0
            .iter()
            .find(|cells| cells.first().is_some_and(|name| name == row))?
            .get(place)
            .map(String::as_str)
    }

    /// This table with the columns that only `other` has.
    fn beside(&self, other: &Self) -> Self {
        let tables = [self, other];
        let columns: BTreeSet<&String> = tables
            .iter()
            .flat_map(|table| table.0.first())
            .flat_map(|head| head.iter().skip(HEAD.len()))
            .collect();
        let measured = |row: &str, column: &str| tables.iter().find_map(|table| table.cell(row, column));
        let row = |cells: &Vec<String>| {
            let (name, cells) = (&cells[0], cells.iter().take(HEAD.len()).cloned());
            cells
                .chain(columns.iter().map(|column| measured(name, column).unwrap_or(NONE).to_owned()))
                .collect()
        };
        Self(self.0.iter().map(row).collect())
    }

    pub(crate) fn markdown(&self) -> String {
        let count = self.0.iter().map(Vec::len).min().unwrap_or(0);
        let width =
            |column: usize| self.0.iter().map(|row| row[column].chars().count()).max().unwrap_or(0).max(8);
        let widths: Vec<usize> = (0..count).map(width).collect();
        let rule = widths.iter().map(|&width| "-".repeat(width)).collect();
        let mut text = String::new();
        for row in self.0.iter().take(1).chain([&rule]).chain(self.0.iter().skip(1)) {
            for (cell, &width) in row.iter().zip(&widths) {
                // Writing to a string does not fail.
                let _ = write!(text, "| {cell:width$} ");
            }
            text.push_str("|\n");
        }
        text
    }

    /// The text with this table between the two marks, and the measurements there of other processors.
    pub(crate) fn inserted(&self, text: &str) -> Result<String, String> {
        let missing =
            || format!("there is no place for the table: it needs lines {} and {END}", BEGIN.trim_end());
        let (before, rest) = text.split_once(BEGIN).ok_or_else(missing)?;
        let (former, after) = rest.split_once(END).ok_or_else(missing)?;
        let table = self.beside(&Self::read(former)).markdown();
        Ok(format!("{before}{BEGIN}\n{table}\n{END}{after}"))
    }
}

fn row(item: &Item) -> Vec<String> {
    let asked = match item.asked {
        Some(Asked::AtMost(bound)) => format!("≤ {bound}"),
        Some(Asked::AtLeast(bound)) => format!("≥ {bound}"),
        None => NONE.to_owned(),
    };
    let measured = match item.ratio {
        None => "not measured".to_owned(),
        Some(ratio) => {
            let missed = item.asked.is_some_and(|asked| !asked.holds(ratio));
            if missed { format!("**{}**", shown(ratio)) } else { shown(ratio) }
        }
    };
    vec![item.result.to_owned(), asked, measured]
}

/// Two or three digits, as many as such measurements reproduce.
fn shown(ratio: f64) -> String {
    match ratio {
        100.0.. => format!("{ratio:.0}"),
        10.0.. => format!("{ratio:.1}"),
        _ => format!("{ratio:.2}"),
    }
}
