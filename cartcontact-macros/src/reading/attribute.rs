//! The tokens in `#[gap_profile(...)]` -> [`Attribute`]: the gap and its options, as written.
//!
//! A gap is one expression or two bodies, `upper = ...` and `lower = ...`: each the height by which a surface falls
//! away from the common tangent plane toward its own bone, so that the gap is their sum.

use proc_macro2::{Ident, TokenStream, TokenTree};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::bodies;
use crate::reading::comparison;
use crate::reading::crate_path;
use crate::reading::entry::{Assignment, Entry, LastDigits, all_options, entries, likely_option, mentions};
use crate::reading::is_punct;
use crate::reading::literal;
use crate::reading::parse;
use crate::reading::positive::Positive;
use crate::reading::syntax::{Expression, Kind};

#[derive(Default)]
pub(crate) struct Attribute {
    /// The sum of the bodies, if there are two.
    pub(crate) gap: Option<Expression>,
    pub(crate) is_of_bodies: bool,
    pub(crate) max_radius: Option<Expression>,
    pub(crate) order: Option<Expression>,
    pub(crate) tolerance: Option<Expression>,
    pub(crate) positive: Option<Positive>,
    pub(crate) crate_path: Option<TokenStream>,
    /// Whether an option could not be read: that it is missing is then no further fault.
    pub(crate) lacks_option: bool,
    /// The tokens that may be meant as the gap.
    pub(crate) written_gap: TokenStream,
}

/// Reads the gap and the options after it, which are separated by commas.
pub(crate) fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Attribute {
    let mut attribute = Attribute::default();
    let mut bodies: Vec<(&Ident, Expression)> = Vec::new();
    let mut names: Vec<&Ident> = Vec::new();
    let mut digits_before_comma = None;
    let entries = entries(tokens, diagnostics);
    let of_other_names = bodies::of_other_names(&entries);
    let is_body = |option: &Assignment<'_>| bodies::names_body(option.name, &of_other_names);
    let has_bodies = entries.iter().filter_map(Entry::assignment).any(|option| is_body(&option));
    for entry in &entries {
        let before = core::mem::replace(&mut digits_before_comma, entry.last_digits());
        if entry.may_be_gap() {
            attribute.written_gap.extend(entry.tokens.iter().cloned());
        }
        if let Some(message) = entry.without_comma() {
            diagnostics.report(entry.extent(), message);
            attribute.mark_option_faulty(entry);
            attribute.mark_gap_before_option_faulty(entry, is_body, diagnostics);
        } else if let Some(option) = entry.assignment() {
            let name = option.name;
            if names.contains(&name) {
                diagnostics.report(name.span(), option.given_twice(attribute.positive.as_ref()));
                attribute.mark_gap_faulty_if_body(entry);
            } else if is_body(&option) {
                bodies.push((name, bodies::read(&option, &of_other_names, diagnostics)));
            } else {
                attribute.set(&option, entry, diagnostics);
            }
            names.push(name);
        } else if let Some(message) = attribute.mistake(entry, before, has_bodies) {
            diagnostics.report(entry.extent(), message);
        } else {
            attribute.gap = Some(parse::expression(&entry.tokens, entry.place, diagnostics));
        }
    }
    attribute.is_of_bodies = !bodies.is_empty();
    attribute.gap = bodies::whole(attribute.gap.take(), bodies, diagnostics);
    attribute
}

impl Attribute {
    /// Whether the gap names the distance r.
    pub(crate) fn names_r(&self) -> bool {
        mentions(&["r"], self.written_gap.clone())
    }

    fn slot(&mut self, name: &Ident) -> Option<&mut Option<Expression>> {
        match name.to_string().as_str() {
            "max_radius" => Some(&mut self.max_radius),
            "order" => Some(&mut self.order),
            "tolerance" => Some(&mut self.tolerance),
            _ => None,
        }
    }

    fn set(&mut self, option: &Assignment<'_>, entry: &Entry, diagnostics: &mut Diagnostics) {
        let Assignment { name, equals, value } = *option;
        if name == "max_radius"
            && let Some(end) = comparison::end_of_range(value)
        {
            let extent = Extent::of(value, option.place());
            diagnostics.report(extent, comparison::end_for_range(&end));
            self.max_radius = Some(Expression { kind: Kind::Faulty, extent });
        } else if let Some(slot) = self.slot(name) {
            *slot = Some(option.expression(diagnostics));
        } else if name == "positive" {
            let names = equals.is_some().then(|| value.iter().cloned().collect());
            self.positive = Some(Positive { place: name.span(), names });
        } else if name == "crate" {
            self.crate_path = crate_path::read(value, option.place(), diagnostics);
        } else if self.gap.is_none()
            && let Some(message) = surface_without_parentheses(&name.to_string())
        {
            self.mark_gap_faulty(entry);
            diagnostics.report(entry.extent(), message);
        } else if self.gap.is_none() && likely_option(name).is_none() && option.is_named_gap() {
            self.name_gap(name, entry, diagnostics);
        } else {
            self.mark_option_faulty(entry);
            let remedy = match likely_option(name) {
                Some(option) => format!("did you mean `{option}`?"),
                None => format!("there are {}", all_options()),
            };
            diagnostics.report(name.span(), format!("`{name}` is not an option; {remedy}"));
        }
    }

    /// Marks the gap as unreadable if it may stand before an option whose comma is missing.
    fn mark_gap_before_option_faulty(
        &mut self,
        entry: &Entry,
        is_body: impl Fn(&Assignment<'_>) -> bool,
        diagnostics: &mut Diagnostics,
    ) {
        match entry.assignment() {
            Some(option) if likely_option(option.name).is_some() => {}
            Some(option) if self.gap.is_none() && !is_body(&option) => {
                self.name_gap(option.name, entry, diagnostics);
            }
            _ => self.mark_gap_faulty(entry),
        }
    }

    /// Reports the name that the gap has been given.
    fn name_gap(&mut self, name: &Ident, entry: &Entry, diagnostics: &mut Diagnostics) {
        self.mark_gap_faulty(entry);
        diagnostics.report(name.span(), written_first(&format!("{name} =")));
    }

    /// What to say about an entry that is not an option, unless it is the gap. What can no longer be read is marked.
    fn mistake(&mut self, entry: &Entry, before: Option<LastDigits<'_>>, has_bodies: bool) -> Option<String> {
        if let Some(message) = entry.without_equals() {
            self.mark_option_faulty(entry);
            return Some(message);
        }
        if let Some(message) = self.decimals(entry, before) {
            return Some(message);
        }
        if let Some(message) = self.named(entry) {
            self.mark_gap_faulty(entry);
            return Some(message);
        }
        if let Some(message) = comparison::option_for(&entry.tokens) {
            self.mark_option_faulty(entry);
            return Some(message);
        }
        self.no_room_for(entry, has_bodies)
    }

    /// What to say about the digits after a comma that is meant as a decimal point. The number that they belong to
    /// cannot be read.
    fn decimals(&mut self, entry: &Entry, before: Option<LastDigits<'_>>) -> Option<String> {
        let LastDigits { digits: whole, is_exponent, option } = before?;
        let decimals = entry.first_digits()?;
        // Behind an exponent, a number with a factor is rather the next term.
        if is_exponent && !entry.goes_on_with_sign() {
            return None;
        }
        let number = match option {
            None => self.gap.as_mut(),
            Some(name) if name == "upper" || name == "lower" => {
                self.mark_gap_faulty(entry);
                None
            }
            // The gap may follow its options.
            Some(_) if self.gap.is_none() && entry.tokens.len() > 1 => return None,
            Some(name) => self.slot(name).and_then(Option::as_mut),
        };
        if let Some(number) = number {
            number.kind = Kind::Faulty;
        }
        let meant = literal::across_comma(&whole, &decimals);
        let meant: Vec<String> = meant.iter().map(|text| literal::as_product(text)).collect();
        let mut message =
            format!("a decimal is written with a point, not a comma; write `{}`", meant.join("` or `"));
        // `r^2, 6` may be meant as a range; as a decimal it is another gap, which compiles.
        if option.is_none() && is_exponent && entry.tokens.len() == 1 {
            message += "; a largest contact radius has a name, as in `max_radius = 6.0`";
        }
        Some(message)
    }

    /// What to say about a gap with a name: `gap(r) = r^2`, `gap: r^2`, `r => r^2`, `r -> r^2`, `|r| r^2`.
    fn named(&self, entry: &Entry) -> Option<String> {
        if self.gap.is_some() {
            return None;
        }
        let (name, signs) = match entry.tokens.as_slice() {
            [TokenTree::Ident(name), TokenTree::Group(variable), signs @ ..] => {
                (format!("{name}{variable}"), signs)
            }
            [TokenTree::Ident(name), signs @ ..] => (name.to_string(), signs),
            // Unlike `|r|^3`.
            [bar, TokenTree::Ident(name), last, first, ..]
                if is_punct(bar, '|') && is_punct(last, '|') && !matches!(first, TokenTree::Punct(_)) =>
            {
                return Some(written_first(&format!("|{name}|")));
            }
            _ => return None,
        };
        let [TokenTree::Punct(sign), next, ..] = signs else { return None };
        let is_call = name.ends_with(')');
        Some(written_first(&match sign.as_char() {
            sign @ ('=' | '-') if is_punct(next, '>') => format!("{name} {sign}>"),
            '=' if is_call => format!("{name} ="),
            ':' if is_punct(next, '=') => format!("{name} :="),
            ':' if !is_punct(next, ':') => match surface_without_parentheses(&name) {
                Some(message) => return Some(message),
                None => format!("{name}:"),
            },
            _ => return None,
        }))
    }

    /// Marks the gap as present but unreadable.
    fn mark_gap_faulty(&mut self, entry: &Entry) {
        self.gap.get_or_insert(Expression { kind: Kind::Faulty, extent: entry.extent() });
    }

    fn mark_gap_faulty_if_body(&mut self, entry: &Entry) {
        if entry.is_body() {
            self.mark_gap_faulty(entry);
        }
    }

    /// Marks an option, which may be a body, as present but unreadable.
    fn mark_option_faulty(&mut self, entry: &Entry) {
        self.lacks_option = true;
        self.mark_gap_faulty_if_body(entry);
    }

    /// What to say about an entry that could only be a second gap. Without a gap so far, only a single name beside two
    /// bodies counts as one.
    fn no_room_for(&mut self, entry: &Entry, has_bodies: bool) -> Option<String> {
        let is_name = matches!(entry.tokens.as_slice(), [TokenTree::Ident(_)]);
        if self.gap.is_none() && !(has_bodies && is_name) {
            return None;
        }
        if let [TokenTree::Ident(name)] = entry.tokens.as_slice() {
            let fields = self.positive.as_ref().and_then(|positive| positive.listed_with(&entry.tokens));
            if let Some(fields) = fields {
                return Some(format!("several fields stand in parentheses; write `positive = ({fields})`"));
            }
            if let Some(option) = likely_option(name) {
                self.mark_option_faulty(entry);
                return Some(format!("`{name}` is not an option; did you mean `{option}`?"));
            }
        }
        if let Some(gap) = self.gap.as_mut().filter(|_| !has_bodies)
            && mentions(&["r"], entry.tokens.iter().cloned())
        {
            // What it lacks without this term is no further fault.
            gap.kind = Kind::Faulty;
            return Some(
                "a profile has one gap, and its terms are joined by `+` or `-`, not by commas".to_owned(),
            );
        }
        Some(
            "a profile has one gap, of one expression or of two bodies, `upper = ..., lower = ...`; options such as \
             `max_radius = 6.0` follow it after a comma"
                .to_owned(),
        )
    }
}

/// What to say about `sphere = 20` and `conic: 20`, which are meant as the gap.
fn surface_without_parentheses(name: &str) -> Option<String> {
    let example = match name {
        "sphere" => "sphere(20)",
        "conic" => "conic(20, -0.5)",
        _ => return None,
    };
    Some(format!("a surface has its numbers in parentheses; write it as in `{example}`"))
}

fn written_first(name: &str) -> String {
    format!("the gap is written first and without a name; remove `{name}`")
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
            ("r^2, upper = r^2, lower = r^2", "remove `upper` and `lower` or the expression"),
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
