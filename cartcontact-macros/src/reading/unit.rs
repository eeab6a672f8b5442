//! What people write after a number as its unit: `mm`, `mm^-1`, `1/mm`, `(1/mm)`, `[mm]`, `in mm`.

use proc_macro2::TokenTree;

use crate::diagnostics::Extent;
use crate::reading::is_punct;
use crate::reading::parse::Parser;

/// Units of length.
const UNITS: [&str; 8] = ["mm", "cm", "m", "um", "µm", "nm", "in", "inch"];

const NO_UNITS: &str = "numbers have no units: all lengths are in one unit, such as mm";

/// The message that there are no units, and how to get rid of this one. A unit other than mm, which the other lengths
/// may not have, must not just be left out.
pub(crate) fn no_units(unit: &str, remedy: &str) -> String {
    let conversion = if unit == "mm" { "" } else { "convert the number to that of the others, and " };
    format!("{NO_UNITS}; {conversion}{remedy}")
}

pub(crate) fn is_unit(name: &str) -> bool {
    UNITS.contains(&name)
}

impl Parser<'_> {
    pub(super) fn is_unit_next(&self) -> bool {
        length(self.rest).is_some()
    }

    /// Skips a unit, if there is one, and reports it.
    pub(super) fn reads_unit(&mut self) -> bool {
        let Some(length) = length(self.rest) else { return false };
        let number = self.previous;
        let written = written(&self.rest[..length]);
        (0..length).for_each(|_| self.take_token());
        let unit = if written.contains("mm") { "mm" } else { &written };
        let message = no_units(
            unit,
            &format!(
                "remove `{written}`; if it is a field, write `*` before it, and parentheses around both behind `/`"
            ),
        );
        self.diagnostics.report(Extent::between(number, self.previous), message);
        true
    }
}

/// A unit as it is written.
fn written(tokens: &[TokenTree]) -> String {
    match tokens {
        [word, unit @ ..] if length(unit).is_some() => format!("{word} {}", written(unit)),
        _ => tokens.iter().map(ToString::to_string).collect(),
    }
}

/// The number of next tokens that form a unit; nothing if there is none.
fn length(tokens: &[TokenTree]) -> Option<usize> {
    match tokens {
        [TokenTree::Ident(name), rest @ ..] if is_unit(&name.to_string()) => {
            // Not inches, if a unit follows.
            let unit = if *name == "in" { length(rest) } else { None };
            Some(1 + unit.unwrap_or_else(|| exponent(rest)))
        }
        [TokenTree::Literal(one), slash, rest @ ..] if one.to_string() == "1" && is_punct(slash, '/') => {
            Some(2 + length(rest)?)
        }
        [TokenTree::Group(group), ..] => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            length(&inner).filter(|length| *length == inner.len()).map(|_| 1)
        }
        _ => None,
    }
}

/// The number of tokens of `^2` and `^-2`, or `**2` and `**-2`.
fn exponent(tokens: &[TokenTree]) -> usize {
    match tokens {
        [first, second, rest @ ..] if is_punct(first, '*') && is_punct(second, '*') => 2 + number(rest),
        [power, rest @ ..] if is_punct(power, '^') => 1 + number(rest),
        _ => 0,
    }
}

/// The number of tokens of `2`, `(-2)` and `-2`.
fn number(tokens: &[TokenTree]) -> usize {
    match tokens {
        [TokenTree::Literal(_) | TokenTree::Group(_), ..] => 1,
        [minus, TokenTree::Literal(_), ..] if is_punct(minus, '-') => 2,
        _ => 0,
    }
}
