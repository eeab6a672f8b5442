//! What stands between two commas of `#[gap_profile(...)]`, and what is meant by it if it is not written correctly.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::positive::Positive;
use crate::reading::similar::closest;
use crate::reading::syntax::Expression;
use crate::reading::unknown::DISTANCES;
use crate::reading::{is_punct, is_sign, literal, parse};

const OPTIONS: [&str; 7] = ["upper", "lower", "max_radius", "order", "tolerance", "positive", "crate"];

/// The option that a name is likely to stand for, misspelt or cut short.
pub(super) fn likely_option(name: &Ident) -> Option<String> {
    let name = name.to_string();
    let cut_short = || OPTIONS.iter().find(|option| name.len() > 2 && option.starts_with(&name));
    closest(&name, OPTIONS.iter().map(ToString::to_string).collect())
        .or_else(|| cut_short().map(ToString::to_string))
}

/// All options, for a message.
pub(super) fn all_options() -> String {
    let names = OPTIONS.map(|option| format!("`{option}`"));
    let [before @ .., last] = &names;
    format!("{} and {last}", before.join(", "))
}

/// Digits before a comma that may be meant as a decimal point.
pub(super) struct LastDigits<'a> {
    pub(super) digits: String,
    pub(super) is_exponent: bool,
    /// The option whose value they are; nothing for the gap.
    pub(super) option: Option<&'a Ident>,
}

/// What stands between two commas.
pub(super) struct Entry {
    pub(super) tokens: Vec<TokenTree>,
    /// The comma before it.
    pub(super) place: Span,
}

/// `name = value`, or `positive` alone.
pub(super) struct Assignment<'a> {
    pub(super) name: &'a Ident,
    pub(super) equals: Option<Span>,
    pub(super) value: &'a [TokenTree],
}

impl Assignment<'_> {
    /// Where the value stands, or should stand.
    pub(super) fn place(&self) -> Span {
        self.equals.unwrap_or(self.name.span())
    }

    /// Whether the value of something that is no option is the gap, perhaps with another name for r, as in `y = x^2/40`.
    pub(super) fn is_named_gap(&self) -> bool {
        let has_power = self.value.iter().any(|token| is_punct(token, '^'));
        self.name == "gap"
            || is_of_r(self.value)
            || has_power && mentions(&DISTANCES, self.value.iter().cloned())
    }

    /// What to say about an option that is given again, after this `positive` if that is the one.
    pub(super) fn given_twice(&self, positive: Option<&Positive>) -> String {
        let name = self.name;
        let positive = positive.filter(|_| name == "positive");
        match positive.and_then(|positive| positive.listed_with(self.value)) {
            Some(fields) => format!("`{name}` is given twice; write `{name} = ({fields})`"),
            None => format!("`{name}` is given twice; keep one"),
        }
    }

    pub(super) fn expression(&self, diagnostics: &mut Diagnostics) -> Expression {
        parse::expression(self.value, self.place(), diagnostics)
    }
}

impl Entry {
    /// None for `==` and `=>`: other methods say what is wrong with them.
    pub(super) fn assignment(&self) -> Option<Assignment<'_>> {
        match self.tokens.as_slice() {
            [TokenTree::Ident(name)] if name == "positive" => {
                Some(Assignment { name, equals: None, value: &[] })
            }
            [_, _, next, ..] if is_punct(next, '=') || is_punct(next, '>') => None,
            [TokenTree::Ident(name), equals, value @ ..] if is_punct(equals, '=') => {
                Some(Assignment { name, equals: Some(equals.span()), value })
            }
            _ => None,
        }
    }

    /// Whether it begins as an option does.
    fn is_option(&self) -> bool {
        self.assignment().is_some() && is_name_of_option(self.tokens.first())
    }

    /// Whether its first name is that of an option, but not of a body.
    fn is_meant_as_option(&self) -> bool {
        is_name_of_option(self.tokens.first()) && !self.is_body()
    }

    /// An option and the gap that follows it without a comma, which is reported: `max_radius = 6 r^2`, `positive r^2`.
    fn apart_from_gap(mut self, diagnostics: &mut Diagnostics) -> Vec<Entry> {
        let follows = |index: &usize| match &self.tokens[index - 1..] {
            [TokenTree::Punct(_), ..] | [_, TokenTree::Punct(_), ..] => false,
            // It may be a call.
            [TokenTree::Ident(_), TokenTree::Group(_), ..] => false,
            [TokenTree::Ident(name), ..] if *index == 1 && name != "positive" => false,
            _ => true,
        };
        let last_of_r = self.tokens.iter().rposition(|token| is_of_r(core::slice::from_ref(token)));
        let Some(start) = last_of_r.and_then(|last| (1..=last).find(follows)) else { return vec![self] };
        let gap = self.tokens.split_off(start);
        let place = self.tokens.last().map_or(self.place, TokenTree::span);
        let between = Extent::between(place.into(), Extent::of(&gap[..1], place));
        diagnostics
            .report(between, "a comma is missing here; all parts of the attribute are separated by commas");
        vec![self, Entry { tokens: gap, place }]
    }

    /// What to say about an option that is not written as one: `max_radius: 6`, `max_radius < 6`, `order 4`,
    /// `positive(c)`, `max-radius = 6`. None of these has a meaning in an expression.
    pub(super) fn without_equals(&self) -> Option<String> {
        let equals = self.tokens.iter().position(|token| is_punct(token, '='));
        let name = match (self.tokens.as_slice(), equals) {
            ([TokenTree::Ident(name)], None) => name.to_string(),
            // This is the first name of a path.
            ([TokenTree::Ident(_), colon, next, ..], None) if is_punct(colon, ':') && is_punct(next, ':') => {
                return None;
            }
            ([TokenTree::Ident(name), next, ..], None)
                if is_punct(next, ':') || is_punct(next, '<') || !matches!(next, TokenTree::Punct(_)) =>
            {
                name.to_string()
            }
            (tokens, Some(equals)) => {
                let words = tokens.iter().take(equals).filter(|token| matches!(token, TokenTree::Ident(_)));
                words.map(TokenTree::to_string).collect::<Vec<String>>().join("_")
            }
            _ => return None,
        };
        let option = OPTIONS.into_iter().find(|option| *option == name)?;
        let value = match option {
            "upper" | "lower" => "sphere(20)",
            "positive" => "(c, d)",
            "order" => "4",
            "tolerance" => "1e-6",
            "crate" => "::cartcontact",
            _ => "6.0",
        };
        Some(format!("an option has a name, `=` and a value; write it as in `{option} = {value}`"))
    }

    /// What to say about an option right after a gap or another option: `r^2 max_radius = 6`, `r^2 max_radius: 6`,
    /// `r^2 max_radius 6`, `order = 4 positive`.
    pub(super) fn without_comma(&self) -> Option<String> {
        let without_equals = self.tokens.windows(3).find_map(|three| match three {
            [
                TokenTree::Group(_) | TokenTree::Ident(_) | TokenTree::Literal(_),
                TokenTree::Ident(name),
                TokenTree::Literal(value),
            ] => OPTIONS.into_iter().find(|option| name == option).map(|option| (option, value)),
            _ => None,
        });
        if let Some((option, value)) = without_equals
            && literal::number(&value.to_string()).is_ok()
            && option != "positive"
        {
            return Some(format!("a comma is missing before `{option}`; write `, {option} = {value}`"));
        }
        let assigned = self.tokens.windows(2).skip(1).find_map(|pair| match pair {
            // In `crate::path` it is no mistake.
            [TokenTree::Ident(name), next]
                if is_punct(next, '=') || is_punct(next, ':') && name != "crate" =>
            {
                OPTIONS.into_iter().find(|option| name == option)
            }
            _ => None,
        });
        let assigned = assigned.or(without_equals.map(|(option, _)| option));
        let option = assigned.or_else(|| match self.tokens.as_slice() {
            [
                ..,
                TokenTree::Group(_) | TokenTree::Ident(_) | TokenTree::Literal(_),
                TokenTree::Ident(last),
            ] => (last == "positive").then_some("positive"),
            _ => None,
        })?;
        Some(format!(
            "a comma is missing before `{option}`; all parts of the attribute are separated by commas"
        ))
    }

    /// Whether this is meant as one of the two bodies.
    pub(super) fn is_body(&self) -> bool {
        let name = self.tokens.first().and_then(|first| match first {
            TokenTree::Ident(name) => likely_option(name),
            _ => None,
        });
        name.is_some_and(|name| name == "upper" || name == "lower")
    }

    /// The name of an entry that is likely to be one of the two bodies, but is not called so.
    pub(super) fn body_of_other_name(&self) -> Option<&Ident> {
        let Assignment { name, equals, value } = self.assignment()?;
        let is_no_option = equals.is_some() && likely_option(name).is_none() && name != "gap";
        let is_body = is_of_r(value) || name == "top" || name == "bottom";
        (is_no_option && is_body).then_some(name)
    }

    /// Whether this may be meant as the gap, or as a part of it.
    pub(super) fn may_be_gap(&self) -> bool {
        self.is_body() || self.assignment().is_none_or(|option| likely_option(option.name).is_none())
    }

    /// The digits before the comma that follows this entry.
    pub(super) fn last_digits(&self) -> Option<LastDigits<'_>> {
        let (TokenTree::Literal(digits), before) = self.tokens.split_last()? else { return None };
        let is_exponent = before.last().is_some_and(|token| is_punct(token, '^'));
        let written = digits.to_string();
        let digits = literal::without_points(&written).unwrap_or(written);
        literal::is_whole(&digits).then(|| LastDigits {
            digits,
            is_exponent,
            option: self.assignment().map(|option| option.name),
        })
    }

    /// Whether it goes on, if at all, with a sign behind its first token: the end of an expression does.
    pub(super) fn goes_on_with_sign(&self) -> bool {
        self.tokens.get(1).is_none_or(is_sign)
    }

    /// The number without a point, but with its suffix, that this entry begins with.
    pub(super) fn first_digits(&self) -> Option<String> {
        let [TokenTree::Literal(digits), ..] = self.tokens.as_slice() else { return None };
        Some(digits.to_string()).filter(|digits| literal::may_follow_point(digits))
    }

    pub(super) fn extent(&self) -> Extent {
        Extent::of(&self.tokens, self.place)
    }
}

/// Whether the distance r or a surface is mentioned.
pub(super) fn is_of_r(tokens: &[TokenTree]) -> bool {
    mentions(&["r", "sphere", "conic"], tokens.iter().cloned())
}

/// Whether one of some names is mentioned, perhaps right after a number.
pub(super) fn mentions(names: &[&str], tokens: impl IntoIterator<Item = TokenTree>) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(name) => names.iter().any(|known| name == known),
        TokenTree::Group(group) => mentions(names, group.stream()),
        TokenTree::Literal(literal) => {
            literal::with_name(&literal.to_string()).is_some_and(|(_, name)| names.contains(&name))
        }
        TokenTree::Punct(_) => false,
    })
}

pub(super) fn entries(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut current = Entry { tokens: Vec::new(), place: Span::call_site() };
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        if let Some(comment) = documentation(&token, tokens.peek()) {
            diagnostics.report(
                comment,
                "a comment between the parts of a gap documents nothing; write it after `//`",
            );
            tokens.next();
            continue;
        }
        let is_meant_as_comma =
            is_punct(&token, ';') && (current.is_option() || is_name_of_option(tokens.peek()));
        if is_meant_as_comma {
            diagnostics
                .report(token.span(), "a gap and its options are separated by commas; write `,` for `;`");
        } else if !is_punct(&token, ',') {
            current.tokens.push(token);
            continue;
        } else if current.tokens.is_empty() {
            diagnostics.report(token.span(), "nothing stands before this comma; remove it");
        }
        let next = Entry { tokens: Vec::new(), place: token.span() };
        entries.push(core::mem::replace(&mut current, next));
    }
    entries.push(current);
    entries.retain(|entry| !entry.tokens.is_empty());
    // Beside a gap or a body, `max_radius = 6 r` is rather a product.
    if entries.iter().all(Entry::is_meant_as_option) {
        entries = entries.into_iter().flat_map(|entry| entry.apart_from_gap(diagnostics)).collect();
    }
    entries
}

/// The place of a comment after `///`, which arrives as `#[doc = "..."]`.
fn documentation(hash: &TokenTree, next: Option<&TokenTree>) -> Option<Extent> {
    let Some(TokenTree::Group(brackets)) = next.filter(|_| is_punct(hash, '#')) else { return None };
    let is_doc =
        matches!(brackets.stream().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc");
    is_doc.then(|| Extent::between(hash.span().into(), brackets.span().into()))
}

fn is_name_of_option(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Ident(name)) if OPTIONS.iter().any(|option| name == option))
}
