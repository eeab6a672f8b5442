//! What is meant by `sphere(10,5)`, `sphere(R = 10)` and others that are not written as surfaces are.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::reading::call::arguments;
use crate::reading::is_punct;
use crate::reading::parse::Parser;

impl Parser<'_> {
    /// What to say about a surface with `tokens` behind its name that are not as they should be; nothing if it is none.
    pub(super) fn wrong_arguments(&self, surface: &Ident, tokens: &[TokenTree]) -> Option<String> {
        let given = values(tokens);
        let are_readable = given.iter().all(|value| self.is_expression(value.tokens));
        let (takes, remedy) = if surface == "sphere" {
            let remedy = match given.as_slice() {
                [radius, conic_constant] if are_readable && !is_decimal([radius, conic_constant]) => {
                    format!("write `conic({}, {})`", radius.text, conic_constant.text)
                }
                given => one_of("sphere", readings(given, 1), are_readable, "sphere(20)"),
            };
            ("`sphere` takes the radius of the sphere", remedy)
        } else if surface == "conic" {
            let remedy = match given.as_slice() {
                [only] => with_constant(only, are_readable),
                given => one_of("conic", readings(given, 2), are_readable, "conic(20, -0.5)"),
            };
            ("`conic` takes the radius at the vertex and the conic constant", remedy)
        } else {
            return None;
        };
        Some(format!("{takes}; {remedy}"))
    }
}

/// An argument without its name.
struct Value<'a> {
    tokens: &'a [TokenTree],
    text: String,
    /// Whether it is a whole number, with a sign or without.
    is_whole: bool,
    is_signed: bool,
    /// Whether what separates it from the one before it may be meant as a decimal point.
    follows_comma: bool,
}

/// The arguments in the order of a surface's. A semicolon separates them where a comma is a decimal point.
fn values(tokens: &[TokenTree]) -> Vec<Value<'_>> {
    let mut begins_with_constant = false;
    let mut values = Vec::new();
    let parts = tokens.split(|token| is_punct(token, ';')).map(arguments);
    for (index, argument) in parts.flat_map(|part| part.into_iter().enumerate()) {
        let value = match argument {
            [TokenTree::Ident(name), equals, again, value @ ..]
                if is_punct(equals, '=') && is_punct(again, '=') =>
            {
                Some((name, value))
            }
            [TokenTree::Ident(name), equals, value @ ..]
                if is_punct(equals, '=') || is_punct(equals, ':') =>
            {
                Some((name, value))
            }
            _ => None,
        };
        begins_with_constant |= values.is_empty()
            && value.is_some_and(|(name, _)| name.to_string().to_lowercase().starts_with('k'));
        values.push(Value::new(value.map_or(argument, |(_, value)| value), index > 0));
    }
    values.retain(|value| !value.tokens.is_empty());
    if begins_with_constant {
        values.reverse();
    }
    values
}

impl<'a> Value<'a> {
    fn new(tokens: &'a [TokenTree], follows_comma: bool) -> Self {
        let text = tokens.iter().cloned().collect::<TokenStream>().to_string();
        let text = text.strip_prefix("- ").map_or(text.clone(), |size| format!("-{size}"));
        let size = text.strip_prefix('-');
        let is_whole = size.unwrap_or(&text).chars().all(|digit| digit.is_ascii_digit());
        Value { tokens, is_whole, is_signed: size.is_some(), text, follows_comma }
    }
}

/// What to do about a conic with nothing but this. A sign may be that of a conic constant without its comma.
fn with_constant(only: &Value<'_>, is_readable: bool) -> String {
    match only.tokens {
        [radius @ TokenTree::Literal(_), sign, size @ TokenTree::Literal(_)]
            if is_readable && is_sign(sign) =>
        {
            let sign = if is_punct(sign, '-') { "-" } else { "" };
            format!("write `conic({radius}, {sign}{size})`")
        }
        [_, rest @ ..] if is_readable && !rest.iter().any(is_sign) => {
            format!("write `conic({}, -0.5)`", only.text)
        }
        _ => "add the conic constant after a comma".to_owned(),
    }
}

fn is_sign(token: &TokenTree) -> bool {
    is_punct(token, '-') || is_punct(token, '+')
}

/// Whether a comma between two values may be meant as a decimal point.
fn is_decimal([whole, decimals]: [&Value<'_>; 2]) -> bool {
    whole.is_whole && decimals.is_whole && !decimals.is_signed && decimals.follows_comma
}

/// All ways to read some values as so many as are `wanted`.
fn readings(values: &[Value<'_>], wanted: usize) -> Vec<Vec<String>> {
    let [first, rest @ ..] = values else {
        return if wanted == 0 { vec![Vec::new()] } else { Vec::new() };
    };
    // More are not worth the many ways.
    if wanted == 0 || values.len() > 2 * wanted {
        return Vec::new();
    }
    let behind = |first: String, rest: &[Value<'_>]| {
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
fn one_of(surface: &str, readings: Vec<Vec<String>>, are_readable: bool, example: &str) -> String {
    let written = readings.iter().map(|arguments| format!("`{surface}({})`", arguments.join(", ")));
    let written: Vec<String> = written.filter(|_| are_readable).collect();
    if written.is_empty() { format!("as in `{example}`") } else { format!("write {}", written.join(" or ")) }
}
