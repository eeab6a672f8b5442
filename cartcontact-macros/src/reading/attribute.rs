//! The tokens in `#[gap_profile(...)]` -> [`Attribute`]: the gap and its options, as written.
//!
//! A gap is one expression or two bodies, `upper = ...` and `lower = ...`: each the height by which a surface falls
//! away from the common tangent plane toward its own bone, so that the gap is their sum.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Path;
use syn::parse::Parser;

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::item::closest;
use crate::reading::parse;
use crate::reading::positive::Positive;
use crate::reading::syntax::{Expression, Kind, Summand};

#[derive(Default)]
pub(crate) struct Attribute {
    /// Where there are two bodies, their sum.
    pub(crate) gap: Option<Expression>,
    pub(crate) max_radius: Option<Expression>,
    pub(crate) order: Option<Expression>,
    pub(crate) tolerance: Option<Expression>,
    pub(crate) positive: Option<Positive>,
    pub(crate) crate_path: Option<TokenStream>,
    /// Whether an option could not be read: what is missing then is no further fault.
    pub(crate) lacks_option: bool,
}

/// Reads the gap and the options behind it, which stand between commas.
pub(crate) fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Attribute {
    let mut attribute = Attribute::default();
    let mut bodies: Vec<(Ident, Expression)> = Vec::new();
    let mut names: Vec<Ident> = Vec::new();
    let mut digits_before_comma = None;
    for entry in entries(tokens, diagnostics) {
        let before = core::mem::replace(&mut digits_before_comma, entry.last_digits());
        match entry.option() {
            Some((name, _, _)) if names.contains(&name) => {
                diagnostics.report(name.span(), format!("`{name}` is given twice; keep one"));
            }
            Some((name, equals, value)) if name == "positive" => {
                let names_of_fields = equals.is_some().then_some(value);
                attribute.positive = Some(Positive { place: name.span(), names: names_of_fields });
                names.push(name);
            }
            Some((name, equals, value)) if name == "upper" || name == "lower" => {
                names.push(name.clone());
                let place = equals.unwrap_or(name.span());
                bodies.push((name, parse::expression(value, place, diagnostics)));
            }
            Some((name, equals, value)) => {
                attribute.set(&name, equals.unwrap_or(name.span()), value, diagnostics);
                names.push(name);
            }
            None => match entry
                .without_equals()
                .inspect(|_| attribute.lacks_option = true)
                .or_else(|| attribute.decimals(&entry, before))
                .or_else(|| {
                    entry.without_comma().or_else(|| entry.named()).inspect(|_| attribute.fail_at(&entry))
                })
                .or_else(|| attribute.no_room_for(&entry))
            {
                Some(message) => diagnostics.report(entry.extent(), message),
                None => attribute.gap = Some(parse::expression(entry.stream(), entry.place, diagnostics)),
            },
        }
    }
    attribute.gap = whole(attribute.gap.take(), bodies, diagnostics);
    attribute
}

/// The gap, from one expression or two bodies in the order in which they were written.
fn whole(
    gap: Option<Expression>,
    bodies: Vec<(Ident, Expression)>,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    match (gap, bodies.as_slice()) {
        (gap @ Some(_), []) => gap,
        (Some(_), [(name, _), ..]) => {
            let message = format!("a gap is one expression or two bodies; remove `{name}` or the expression");
            diagnostics.report(name.span(), message);
            None
        }
        (None, []) => {
            let message = "the gap is missing; write it first, as in `#[gap_profile(0.025 * r^2)]`";
            diagnostics.report(Span::call_site(), message);
            None
        }
        (None, [(name, _)]) => {
            let other = if name == "upper" { "lower" } else { "upper" };
            let message = format!(
                "a gap lies between two bodies, and `{other}` is missing; a flat one is written `{other} = 0`"
            );
            diagnostics.report(name.span(), message);
            None
        }
        (None, [(_, first), .., (_, last)]) => {
            let extent = Extent::between(first.extent, last.extent);
            let summand = |(_, expression)| Summand { subtracted: false, expression };
            Some(Expression { kind: Kind::Sum(bodies.into_iter().map(summand).collect()), extent })
        }
    }
}

impl Attribute {
    fn set(&mut self, name: &Ident, equals: Span, value: TokenStream, diagnostics: &mut Diagnostics) {
        let slot = match name.to_string().as_str() {
            "max_radius" => Some(&mut self.max_radius),
            "order" => Some(&mut self.order),
            "tolerance" => Some(&mut self.tolerance),
            _ => None,
        };
        if let Some(slot) = slot {
            *slot = Some(parse::expression(value, equals, diagnostics));
        } else if name == "crate" {
            let place = Extent::of(value.clone().into_iter().map(|token| token.span()), equals);
            match Path::parse_mod_style.parse2(value) {
                Ok(path) => self.crate_path = Some(path.into_token_stream()),
                Err(_) => diagnostics
                    .report(place, "`crate` takes a path without quotes; write `crate = ::cartcontact`"),
            }
        } else {
            let of_r = value.into_iter().any(|token| matches!(token, TokenTree::Ident(r) if r == "r"));
            if self.gap.is_none() && (of_r || name == "gap") {
                self.gap = Some(Expression { kind: Kind::Faulty, extent: name.span().into() });
                let message = format!("the gap is written first and without a name; remove `{name} =`");
                return diagnostics.report(name.span(), message);
            }
            self.lacks_option = true;
            let remedy = match closest(&name.to_string(), OPTIONS.iter().map(ToString::to_string).collect()) {
                Some(option) => format!("did you mean `{option}`?"),
                None => {
                    "there are `upper`, `lower`, `max_radius`, `order`, `tolerance`, `positive` and `crate`"
                        .to_owned()
                }
            };
            diagnostics.report(name.span(), format!("`{name}` is not an option; {remedy}"));
        }
    }

    /// What to say about the digits behind a comma that is meant as a decimal point. Where they belong to the gap, it
    /// cannot be read.
    fn decimals(&mut self, entry: &Entry, before: Option<Whole>) -> Option<String> {
        let Whole { digits: whole, of_gap } = before?;
        let decimals = entry.first_digits()?;
        if let Some(gap) = self.gap.as_mut().filter(|_| of_gap) {
            gap.kind = Kind::Faulty;
        }
        Some(format!("a decimal is written with a point, not a comma; write `{whole}.{decimals}`"))
    }

    /// Notes that the gap is there, but cannot be read.
    fn fail_at(&mut self, entry: &Entry) {
        self.gap.get_or_insert(Expression { kind: Kind::Faulty, extent: entry.extent() });
    }

    /// What to say about an entry that could only be a second gap.
    fn no_room_for(&self, entry: &Entry) -> Option<String> {
        self.gap.as_ref()?;
        let fields = self.positive.as_ref().and_then(|positive| positive.names.as_ref());
        Some(match (fields, entry.tokens.as_slice()) {
            (Some(fields), [TokenTree::Ident(another)]) => {
                format!("several fields stand in parentheses; write `positive = ({fields}, {another})`")
            }
            _ => {
                "a profile has one gap, of one expression or of two bodies, `upper = ..., lower = ...`; options such as \
                 `max_radius = 6.0` follow it after a comma"
                    .to_owned()
            }
        })
    }
}

const OPTIONS: [&str; 7] = ["upper", "lower", "max_radius", "order", "tolerance", "positive", "crate"];

/// Digits before a comma that may be meant as a decimal point.
struct Whole {
    digits: String,
    of_gap: bool,
}

/// What stands between two commas.
struct Entry {
    tokens: Vec<TokenTree>,
    /// The comma before it.
    place: Span,
}

impl Entry {
    /// `name = value`, or `positive` alone; `==` is left to the expression, which says what is wrong with it.
    fn option(&self) -> Option<(Ident, Option<Span>, TokenStream)> {
        let (name, equals, value) = match self.tokens.as_slice() {
            [TokenTree::Ident(name)] if name == "positive" => {
                return Some((name.clone(), None, TokenStream::new()));
            }
            [TokenTree::Ident(name), TokenTree::Punct(equals), value @ ..] => (name, equals, value),
            _ => return None,
        };
        let comparison = matches!(value.first(), Some(TokenTree::Punct(next)) if next.as_char() == '=');
        let assigns = equals.as_char() == '=' && !comparison;
        assigns.then(|| (name.clone(), Some(equals.span()), value.iter().cloned().collect()))
    }

    /// What to say about an option that is not written as one: `max_radius: 6`, `order 4`, `positive(c)`,
    /// `max-radius = 6`. In an expression none of these has a meaning.
    fn without_equals(&self) -> Option<String> {
        let equals = self.tokens.iter().position(|token| is_punct(token, '='));
        let name = match (self.tokens.as_slice(), equals) {
            ([TokenTree::Ident(name)], None) => name.to_string(),
            ([TokenTree::Ident(name), next, ..], None)
                if is_punct(next, ':') || !matches!(next, TokenTree::Punct(_)) =>
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

    /// What to say about an option right behind a gap, `r^2 max_radius = 6`.
    fn without_comma(&self) -> Option<String> {
        let option = self.tokens.windows(2).skip(1).find_map(|pair| match pair {
            [TokenTree::Ident(name), equals] if is_punct(equals, '=') => {
                OPTIONS.into_iter().find(|option| name == option)
            }
            _ => None,
        })?;
        Some(format!("a comma is missing before `{option}`; options follow the gap after commas"))
    }

    /// What to say about a gap with a name, `gap(r) = r^2`.
    fn named(&self) -> Option<String> {
        match self.tokens.as_slice() {
            [TokenTree::Ident(name), TokenTree::Group(variable), equals, ..] if is_punct(equals, '=') => {
                Some(format!("the gap is written first and without a name; remove `{name}{variable} =`"))
            }
            _ => None,
        }
    }

    /// The digits in front of the comma behind this entry, unless they are an exponent.
    fn last_digits(&self) -> Option<Whole> {
        let (TokenTree::Literal(digits), before) = self.tokens.split_last()? else { return None };
        if before.last().is_some_and(|token| is_punct(token, '^')) {
            return None;
        }
        let digits = digits.to_string();
        let is_whole = digits.chars().all(|digit| digit.is_ascii_digit());
        is_whole.then(|| Whole { digits, of_gap: self.option().is_none() })
    }

    /// The number, with its suffix, that this entry begins with.
    fn first_digits(&self) -> Option<String> {
        let [TokenTree::Literal(digits), ..] = self.tokens.as_slice() else { return None };
        Some(digits.to_string()).filter(|digits| digits.starts_with(|first: char| first.is_ascii_digit()))
    }

    fn stream(&self) -> TokenStream {
        self.tokens.iter().cloned().collect()
    }

    fn extent(&self) -> Extent {
        Extent::of(self.tokens.iter().map(TokenTree::span), self.place)
    }
}

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

fn entries(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut current = Entry { tokens: Vec::new(), place: Span::call_site() };
    for token in tokens {
        match token {
            TokenTree::Punct(comma) if comma.as_char() == ',' => {
                if current.tokens.is_empty() {
                    diagnostics.report(comma.span(), "nothing stands before this comma; remove it");
                }
                let next = Entry { tokens: Vec::new(), place: comma.span() };
                entries.push(core::mem::replace(&mut current, next));
            }
            token => current.tokens.push(token),
        }
    }
    entries.push(current);
    entries.retain(|entry| !entry.tokens.is_empty());
    entries
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        let mut diagnostics = Diagnostics::default();
        parse(text.parse().unwrap(), &mut diagnostics);
        diagnostics.messages()
    }

    #[test]
    fn options_follow_the_gap() {
        let mut diagnostics = Diagnostics::default();
        let attribute =
            parse("r^2, max_radius = 6.0, crate = some::path,".parse().unwrap(), &mut diagnostics);
        assert!(diagnostics.is_empty());
        assert!(attribute.gap.is_some() && attribute.max_radius.is_some());
        assert_eq!(attribute.crate_path.unwrap().to_string(), "some :: path");
    }

    #[test]
    fn every_fault_is_reported() {
        let reported = messages("r^2, r^4, max_radius = 1, max_radius = 2, depth = 3,, crate = \"here\"");
        for rule in ["one gap", "given twice", "not an option", "before this comma", "without quotes"] {
            assert!(reported.iter().any(|message| message.contains(rule)), "{rule}");
        }
        assert_eq!(reported.len(), 5);
    }

    #[test]
    fn two_bodies_are_a_gap() {
        let mut diagnostics = Diagnostics::default();
        let attribute = parse("lower = -r^2, order = 4, upper = 2*r^2".parse().unwrap(), &mut diagnostics);
        assert!(diagnostics.is_empty() && attribute.order.is_some());
        assert!(matches!(attribute.gap.unwrap().kind, Kind::Sum(summands) if summands.len() == 2));
        for (text, rule) in [
            ("upper = r^2", "`lower = 0`"),
            ("lower = r^2", "`upper = 0`"),
            ("upper = r^2, upper = r^2, lower = 0", "given twice"),
            ("r^2, upper = r^2, lower = r^2", "remove `upper` or the expression"),
            ("lower = r^2, r^4", "remove `lower` or the expression"),
        ] {
            assert!(messages(text).iter().any(|message| message.contains(rule)), "{text}");
            assert_eq!(messages(text).len(), 1);
        }
    }

    #[test]
    fn the_gap_must_be_there() {
        assert_eq!(messages("").len(), 1);
        assert!(messages("max_radius = 2").iter().any(|message| message.contains("the gap is missing")));
        assert!(
            messages("r^2, max_radius = ").iter().any(|message| message.contains("something is missing"))
        );
    }
}
