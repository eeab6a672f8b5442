//! What is meant by `sphere(10,5)`, `sphere(R = 10)` and others that are not written as surfaces are.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::reading::call::arguments;
use crate::reading::is_punct;

/// What to say about a surface with `tokens` behind its name that are not as they should be; nothing if it is none.
pub(super) fn wrong_arguments(surface: &Ident, tokens: &[TokenTree]) -> Option<String> {
    let given = values(tokens);
    let (takes, remedy) = if surface == "sphere" {
        let remedy = match given.as_slice() {
            [radius, conic_constant] if !is_decimal([radius, conic_constant]) => {
                format!("conic({}, {})", radius.text, conic_constant.text)
            }
            given => one_of("sphere", readings(given, 1), "sphere(20)"),
        };
        ("`sphere` takes the radius of the sphere", remedy)
    } else if surface == "conic" {
        let remedy = match given.as_slice() {
            [radius] => format!("conic({}, -0.5)", radius.text),
            given => one_of("conic", readings(given, 2), "conic(20, -0.5)"),
        };
        ("`conic` takes the radius at the vertex and the conic constant", remedy)
    } else {
        return None;
    };
    Some(format!("{takes}; write `{remedy}`"))
}

/// An argument without its name.
struct Value {
    text: String,
    /// Whether it is a whole number, with a sign or without.
    is_whole: bool,
    is_signed: bool,
}

/// The arguments in the order of a surface's.
fn values(tokens: &[TokenTree]) -> Vec<Value> {
    let mut begins_with_constant = false;
    let mut values = Vec::new();
    for argument in arguments(tokens) {
        let value = match argument {
            [TokenTree::Ident(name), equals, value @ ..]
                if is_punct(equals, '=') || is_punct(equals, ':') =>
            {
                begins_with_constant |= values.is_empty() && name.to_string().to_lowercase().starts_with('k');
                value
            }
            value => value,
        };
        let text = value.iter().cloned().collect::<TokenStream>().to_string();
        let text = text.strip_prefix("- ").map_or(text.clone(), |size| format!("-{size}"));
        let size = text.strip_prefix('-');
        let is_whole = size.unwrap_or(&text).chars().all(|digit| digit.is_ascii_digit());
        values.push(Value { is_whole, is_signed: size.is_some(), text });
    }
    values.retain(|value| !value.text.is_empty());
    if begins_with_constant {
        values.reverse();
    }
    values
}

/// Whether a comma between two values may be meant as a decimal point.
fn is_decimal([whole, decimals]: [&Value; 2]) -> bool {
    whole.is_whole && decimals.is_whole && !decimals.is_signed
}

/// All ways to read some values as so many as are `wanted`.
fn readings(values: &[Value], wanted: usize) -> Vec<Vec<String>> {
    let [first, rest @ ..] = values else {
        return if wanted == 0 { vec![Vec::new()] } else { Vec::new() };
    };
    // More are not worth the many ways.
    if wanted == 0 || values.len() > 2 * wanted {
        return Vec::new();
    }
    let behind = |first: String, rest: &[Value]| {
        let readings = readings(rest, wanted - 1).into_iter();
        readings.map(move |rest| [vec![first.clone()], rest].concat()).collect::<Vec<_>>()
    };
    let mut all = behind(first.text.clone(), rest);
    if let [second, rest @ ..] = rest
        && is_decimal([first, second])
    {
        all.extend(behind(format!("{}.{}", first.text, second.text), rest));
    }
    all
}

/// The surface as it may be meant, or an example.
fn one_of(surface: &str, readings: Vec<Vec<String>>, example: &str) -> String {
    let written = readings.iter().map(|arguments| format!("{surface}({})", arguments.join(", ")));
    let written: Vec<String> = written.collect();
    if written.is_empty() { example.to_owned() } else { written.join("` or `") }
}
