//! What is meant by `sphere(10,5)`, `sphere(R = 10)` and other calls that are not written as surfaces should be.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::reading::call::arguments;
use crate::reading::comparison::without_equals;
use crate::reading::parse::Parser;
use crate::reading::{is_punct, is_sign, literal};

impl Parser<'_> {
    /// What to say about a surface with wrong `tokens` after its name; nothing if the name is not that of a surface.
    pub(super) fn wrong_arguments(&self, surface: &Ident, tokens: &[TokenTree]) -> Option<String> {
        match surface.to_string().as_str() {
            "sphere" => Some(self.wrong_sphere(&values(tokens))),
            "conic" => Some(self.wrong_conic(&values(tokens))),
            _ => None,
        }
    }

    fn wrong_sphere(&self, given: &[Value<'_>]) -> String {
        let spheres = written("sphere", &readings(given, 1));
        let conics = match given {
            [radius, constant] if may_be_apart([radius, constant]) => {
                written("conic", &[vec![radius.text.clone(), constant.text.clone()]])
            }
            _ => Vec::new(),
        };
        let remedy = one_of(&[spheres, conics].concat(), self.are_readable(given), "sphere(20)");
        format!("`sphere` takes the radius of the sphere; {remedy}")
    }

    fn wrong_conic(&self, given: &[Value<'_>]) -> String {
        let are_readable = self.are_readable(given);
        let remedy = match given {
            [only] if only.may_stand_at(0) => with_constant(only, are_readable),
            _ => one_of(&written("conic", &readings(given, 2)), are_readable, "conic(20, -0.5)"),
        };
        format!("`conic` takes the radius at the vertex and the conic constant; {remedy}")
    }

    fn are_readable(&self, given: &[Value<'_>]) -> bool {
        given.iter().enumerate().all(|(index, value)| value.may_stand_at(index))
            && given.iter().all(|value| self.is_expression(value.tokens))
    }
}

struct Value<'a> {
    name: Option<&'a Ident>,
    tokens: &'a [TokenTree],
    text: String,
    /// Whether a separator before it may be meant as a decimal point.
    follows_comma: bool,
}

/// The arguments, a named radius first. Where a comma is a decimal point, a semicolon separates them.
fn values(tokens: &[TokenTree]) -> Vec<Value<'_>> {
    let parts = tokens.split(|token| is_punct(token, ';')).map(arguments);
    let arguments = parts.flat_map(|part| part.into_iter().enumerate());
    let mut values: Vec<Value<'_>> =
        arguments.map(|(index, argument)| Value::new(argument, index > 0)).collect();
    values.retain(|value| !value.tokens.is_empty());
    let radius = values.iter().position(Value::is_named_radius).unwrap_or(0);
    values.rotate_left(radius);
    values
}

impl<'a> Value<'a> {
    fn new(argument: &'a [TokenTree], follows_comma: bool) -> Self {
        let (name, tokens) = match argument {
            [TokenTree::Ident(name), equals, value @ ..]
                if is_punct(equals, '=') || is_punct(equals, ':') =>
            {
                (Some(name), without_equals(value))
            }
            value => (None, value),
        };
        let text = tokens.iter().cloned().collect::<TokenStream>().to_string();
        let text = text.strip_prefix("- ").map_or(text.clone(), |size| format!("-{size}"));
        Value { name, tokens, text, follows_comma: follows_comma && name.is_none() }
    }

    fn is_named_radius(&self) -> bool {
        self.name.is_some_and(|name| ["r", "R", "radius"].iter().any(|known| name == known))
    }

    /// A diameter or an eccentricity is not the number that belongs in its place.
    fn may_stand_at(&self, index: usize) -> bool {
        match self.name {
            None => true,
            Some(_) if index == 0 => self.is_named_radius(),
            Some(name) => name == "k" || name == "K",
        }
    }
}

/// What to do about a conic with only one argument. A sign in it may be that of a conic constant whose comma is
/// missing.
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

/// Whether a comma between two values may be meant as a decimal point.
fn is_decimal([whole, decimals]: [&Value<'_>; 2]) -> bool {
    let size = whole.text.strip_prefix('-').unwrap_or(&whole.text);
    literal::is_whole(size) && literal::is_whole(&decimals.text) && decimals.follows_comma
}

/// Whether two values may be meant as a radius and a conic constant rather than as one decimal: no whole constant but 0
/// begins with a zero.
fn may_be_apart([radius, constant]: [&Value<'_>; 2]) -> bool {
    let is_zero = |value: &Value<'_>| value.text.chars().all(|digit| digit == '0');
    let are_numbers = !is_zero(radius) && (constant.text == "0" || !constant.text.starts_with('0'));
    are_numbers || !is_decimal([radius, constant])
}

/// All ways to read some values as this many.
fn readings(values: &[Value<'_>], wanted: usize) -> Vec<Vec<String>> {
    let [first, rest @ ..] = values else {
        return if wanted == 0 { vec![Vec::new()] } else { Vec::new() };
    };
    // Reading more values is not worth the many ways.
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
        let numbers = literal::across_comma(&first.text, &second.text).into_iter();
        all.extend(numbers.flat_map(|number| behind(number, rest)));
    }
    all
}

/// A surface with each of some arguments.
fn written(surface: &str, arguments: &[Vec<String>]) -> Vec<String> {
    arguments.iter().map(|arguments| format!("`{surface}({})`", arguments.join(", "))).collect()
}

/// The possible readings of the surface, or an example.
fn one_of(meant: &[String], are_readable: bool, example: &str) -> String {
    match meant {
        [_, ..] if are_readable => format!("write {}", meant.join(" or ")),
        _ => format!("write it as in `{example}`"),
    }
}
