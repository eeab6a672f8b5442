//! The table in Markdown, and its place in a text.

use std::fmt::Write;

use crate::items::{Asked, Item};

const BEGIN: &str = "<!-- ratios:begin -->\n";
const END: &str = "<!-- ratios:end -->";

/// A row for every item; ratios that miss their target are bold.
pub(crate) fn of(items: &[Item]) -> String {
    let rows: Vec<[String; 3]> = items.iter().map(row).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0).max(8);
    let [result, asked, measured] = [0, 1, 2].map(width);
    let mut table = String::new();
    let head = ["result", "target", "measured"].map(str::to_owned);
    let rule = [result, asked, measured].map(|width| "-".repeat(width));
    for [first, second, third] in [head, rule].iter().chain(&rows) {
        // Writing to a string does not fail.
        let _ = writeln!(table, "| {first:result$} | {second:asked$} | {third:measured$} |");
    }
    table
}

fn row(item: &Item) -> [String; 3] {
    let asked = match item.asked {
        Some(Asked::AtMost(bound)) => format!("≤ {bound}"),
        Some(Asked::AtLeast(bound)) => format!("≥ {bound}"),
        None => "–".to_owned(),
    };
    let measured = match item.ratio {
        None => "not measured".to_owned(),
        Some(ratio) => {
            let missed = item.asked.is_some_and(|asked| !asked.holds(ratio));
            if missed { format!("**{}**", shown(ratio)) } else { shown(ratio) }
        }
    };
    [item.result.clone(), asked, measured]
}

/// Two or three digits, as many as such measurements reproduce.
fn shown(ratio: f64) -> String {
    match ratio {
        100.0.. => format!("{ratio:.0}"),
        10.0.. => format!("{ratio:.1}"),
        _ => format!("{ratio:.2}"),
    }
}

/// The text with the table between the two marks.
pub(crate) fn inserted(text: &str, table: &str) -> Result<String, String> {
    let missing =
        || format!("there is no place for the table: it needs lines {} and {END}", BEGIN.trim_end());
    let (before, rest) = text.split_once(BEGIN).ok_or_else(missing)?;
    let (_, after) = rest.split_once(END).ok_or_else(missing)?;
    Ok(format!("{before}{BEGIN}\n{table}\n{END}{after}"))
}
