//! Ranges and signs as mathematics writes them, where an option is meant: `0 < r < 5`, `r in 0..5`, `c > 0`.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

use crate::reading::entry::is_of_r;
use crate::reading::is_punct;
use crate::reading::parse::is_expression;

/// What to say about an entry that states a range or a sign.
pub(super) fn option_for(tokens: &[TokenTree]) -> Option<String> {
    if let [TokenTree::Ident(name), TokenTree::Ident(word), range @ ..] = tokens
        && name == "r"
        && word == "in"
    {
        return end_of_range(range).map(|end| option_for_range(&end));
    }
    let Compared { name, least, greatest } = Compared::of(tokens)?;
    if let ("r", Some(end)) = (name.to_string().as_str(), greatest) {
        // Between expressions of r it is no range.
        return (!is_of_r(end)).then(|| option_for_range(end));
    }
    let least = least?;
    let wanted = match name.to_string().as_str() {
        "r" => return Some("`r` is the distance from the axis and positive anyway; remove this".to_owned()),
        "positive" => "write `positive`".to_owned(),
        // As in `c > 0 && d > 0`, which declares more than the first field.
        _ if !is_expression(least, 0) => "write it as in `positive = (c, d)`".to_owned(),
        field => format!("write `positive = {field}`"),
    };
    Some(format!("an option declares that fields are above 0; {wanted}"))
}

/// What to say about a range with this end.
fn option_for_range(end: &[TokenTree]) -> String {
    format!("a range is an option; {}", remedy(end))
}

/// What to say about a range with this end as the value of `max_radius`.
pub(super) fn end_for_range(end: &[TokenTree]) -> String {
    format!("max_radius is the end of the range, which begins at r = 0; {}", remedy(end))
}

fn remedy(end: &[TokenTree]) -> String {
    if end.is_empty() {
        return "leave it out if the gap has no end".to_owned();
    }
    if is_of_r(end) || !is_expression(end, 0) {
        return "write it as in `max_radius = 6.0`".to_owned();
    }
    format!("write `max_radius = {}`", end.iter().cloned().collect::<TokenStream>())
}

/// The end of `0..5`, `0..=5`, `(0, 5)` or `[0, 5]`; nothing if this is no range.
pub(super) fn end_of_range(tokens: &[TokenTree]) -> Option<Vec<TokenTree>> {
    if let [TokenTree::Group(group)] = tokens {
        let inside: Vec<TokenTree> = group.stream().into_iter().collect();
        let ends: Vec<&[TokenTree]> = inside.split(|token| is_punct(token, ',')).collect();
        return match ends.as_slice() {
            [_, end] if group.delimiter() != Delimiter::Brace => Some(end.to_vec()),
            _ => end_of_range(&inside),
        };
    }
    let dots = tokens.windows(2).position(|pair| pair.iter().all(|token| is_punct(token, '.')))?;
    Some(without_equals(&tokens[dots + 2..]).to_vec())
}

/// What a name is compared with, as `r` is in `0 <= r < 5`.
struct Compared<'a> {
    name: &'a Ident,
    least: Option<&'a [TokenTree]>,
    greatest: Option<&'a [TokenTree]>,
}

impl<'a> Compared<'a> {
    fn of(tokens: &'a [TokenTree]) -> Option<Self> {
        let is_sign = |token: &TokenTree| is_punct(token, '<') || is_punct(token, '>');
        let signs: Vec<&TokenTree> = tokens.iter().filter(|token| is_sign(token)).collect();
        let sides: Vec<&[TokenTree]> = tokens.split(is_sign).map(without_equals).collect();
        // Nothing is compared by `<<`.
        if sides.iter().any(|side| side.is_empty()) {
            return None;
        }
        let names = sides.iter().enumerate().filter_map(|(place, side)| match side {
            [TokenTree::Ident(name)] => Some((place, name)),
            _ => None,
        });
        let (place, name) = names.clone().find(|(_, name)| *name == "r").or_else(|| names.clone().next())?;
        let side = |sign_before: char, sign_behind: char| {
            let before = place.checked_sub(1).filter(|before| is_punct(signs[*before], sign_before));
            let behind = signs.get(place).filter(|sign| is_punct(sign, sign_behind));
            before.or(behind.map(|_| place + 1)).map(|place| sides[place])
        };
        Some(Compared { name, least: side('<', '>'), greatest: side('>', '<') })
    }
}

/// The tokens without the second sign of `<=`, `>=`, `..=` or `==`.
pub(super) fn without_equals(tokens: &[TokenTree]) -> &[TokenTree] {
    match tokens {
        [equals, rest @ ..] if is_punct(equals, '=') => rest,
        _ => tokens,
    }
}
