//! The option `positive`: fields whose values are greater than 0.
//!
//! The declaration decides signs when the program is compiled, and the generated code refuses values that violate it.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::call::arguments;
use crate::reading::item::{Item, Meaning};
use crate::reading::name::{is_same, unraw};
use crate::reading::similar::closest;
use crate::reading::ungrouped;

/// The option as written, at `place`.
pub(crate) struct Positive {
    pub(crate) place: Span,
    /// What follows `=`; nothing if `positive` stands alone, for all fields.
    pub(crate) names: Option<TokenStream>,
}

impl Positive {
    /// Marks the declared fields. Every fault is reported.
    pub(crate) fn declare(&self, item: &mut Item, diagnostics: &mut Diagnostics) {
        let Some(names) = &self.names else {
            item.fields.iter_mut().for_each(|field| field.is_positive = true);
            return;
        };
        let names = match listed(names.clone(), self.place) {
            Ok(names) => names,
            Err(place) => return diagnostics.report(place, syntax(item)),
        };
        for name in names {
            let fault = match item.fields.iter_mut().find(|field| is_same(&field.ident, &name)) {
                Some(field) if field.is_positive => Some(format!("`{name}` is named twice; keep one")),
                Some(field) => {
                    field.is_positive = true;
                    None
                }
                None => no_number(&name, item),
            };
            if let Some(message) = fault {
                diagnostics.report(name.span(), message);
            }
        }
    }

    /// The fields that are named, and those of other tokens, each once; nothing if something else stands there.
    pub(super) fn listed_with(&self, others: &[TokenTree]) -> Option<String> {
        let mut names: Vec<Ident> = Vec::new();
        for tokens in [self.names.clone()?, others.iter().cloned().collect()] {
            for name in listed(tokens, self.place).ok()? {
                if !names.iter().any(|known| is_same(known, &name)) {
                    names.push(name);
                }
            }
        }
        Some(names.iter().map(Ident::to_string).collect::<Vec<_>>().join(", "))
    }

    /// Reports what was declared in vain, once it is known which fields the geometry uses.
    pub(crate) fn check_used(&self, item: &Item, diagnostics: &mut Diagnostics) {
        let Some(names) = &self.names else {
            if !item.fields.iter().any(|field| field.used) {
                diagnostics.report(self.place, "the geometry depends on no field; remove `positive`");
            }
            return;
        };
        for name in listed(names.clone(), self.place).unwrap_or_default() {
            if item.fields.iter().any(|field| is_same(&field.ident, &name) && !field.used) {
                let message = format!("the geometry does not depend on `{name}`; remove it from `positive`");
                diagnostics.report(name.span(), message);
            }
        }
    }
}

/// `c`, or `(c, d)`; otherwise the place of what is written instead.
fn listed(tokens: TokenStream, place: Span) -> Result<Vec<Ident>, Extent> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Group(list)]
            if matches!(list.delimiter(), Delimiter::Parenthesis | Delimiter::None)
                && !list.stream().is_empty() =>
        {
            let names: Vec<TokenTree> = list.stream().into_iter().collect();
            arguments(&names).into_iter().map(|part| name(part, list.span())).collect()
        }
        single => name(single, place).map(|name| vec![name]),
    }
}

fn name(tokens: &[TokenTree], place: Span) -> Result<Ident, Extent> {
    match ungrouped(tokens.iter().cloned().collect()).as_slice() {
        [TokenTree::Ident(name)] if name != "true" && name != "false" => Ok(name.clone()),
        _ => Err(Extent::of(tokens, place)),
    }
}

fn syntax(item: &Item) -> String {
    let example = match item.field_names().as_slice() {
        [] => "(c, d)".to_owned(),
        [only] => only.clone(),
        [first, second, ..] => format!("({first}, {second})"),
    };
    format!("`positive` names fields, or stands alone for all of them; write `positive = {example}`")
}

/// Why a name cannot be declared, unless what is wrong with its field is reported elsewhere.
fn no_number(name: &Ident, item: &Item) -> Option<String> {
    if name == "r" {
        return Some("`r` is the distance from the axis and positive anyway; name fields only".to_owned());
    }
    match item.meaning(name) {
        Meaning::WrongType(_) => {
            let message =
                format!("only real numbers can be positive; remove the field `{name}`, or make it an `f64`");
            return Some(message);
        }
        Meaning::Undecided => return None,
        Meaning::Symbol(_) | Meaning::Unknown => {}
    }
    let remedy = match closest(&name.to_string(), item.field_names()) {
        Some(field) => format!("did you mean `{field}`?"),
        None if item.fields.is_empty() => {
            format!("a field declares a symbol, as in `struct {} {{ {}: f64 }}`", item.ident, unraw(name))
        }
        None => format!("its symbols are `{}`", item.field_names().join("`, `")),
    };
    Some(format!("`{name}` is not a field of `{}`; {remedy}", item.ident))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use proc_macro2::Group;
    use quote::quote;

    use super::*;

    fn declared(names: Option<&str>) -> (Vec<String>, Vec<String>) {
        declared_as(names.map(|names| names.parse().unwrap()))
    }

    fn declared_as(names: Option<TokenStream>) -> (Vec<String>, Vec<String>) {
        let mut diagnostics = Diagnostics::default();
        let input = quote!(
            struct Ball {
                radius: f64,
                k: f64,
                name: String,
            }
        );
        let mut item = crate::reading::item::parse(input, &mut diagnostics).unwrap();
        let positive = Positive { place: Span::call_site(), names };
        positive.declare(&mut item, &mut diagnostics);
        let positive = item.fields.iter().filter(|field| field.is_positive);
        (positive.map(|field| field.ident.to_string()).collect(), diagnostics.messages())
    }

    #[test]
    fn fields_are_declared_by_name_or_all_at_once() {
        for (names, expected) in [
            (None, ["radius", "k"].as_slice()),
            (Some("k"), &["k"]),
            (Some("(k)"), &["k"]),
            (Some("(k, radius,)"), &["radius", "k"]),
        ] {
            let (positive, messages) = declared(names);
            assert_eq!(
                (positive, messages),
                (expected.iter().map(|&name| name.to_owned()).collect(), vec![])
            );
        }
    }

    /// Each field arrives in invisible parentheses.
    #[test]
    fn a_macro_may_list_expressions() {
        let [radius, k] = [quote!(radius), quote!(k)].map(|name| Group::new(Delimiter::None, name));
        assert_eq!(declared_as(Some(quote!((#radius, #k)))).0, ["radius", "k"]);
        assert_eq!(declared_as(Some(quote!(#k))).0, ["k"]);
    }

    #[test]
    fn each_fault_is_named() {
        for (names, rule) in [
            ("(k, k)", "named twice"),
            ("raduis", "did you mean `radius`?"),
            ("(k, curvature)", "its symbols are `radius`, `k`"),
            ("name", "only real numbers"),
            ("r", "distance from the axis"),
            ("true", "write `positive = (radius, k)`"),
            ("", "write `positive = (radius, k)`"),
            ("()", "write `positive = (radius, k)`"),
            ("[k]", "write `positive = (radius, k)`"),
            ("(k,, radius)", "write `positive = (radius, k)`"),
            ("2 * k", "write `positive = (radius, k)`"),
            ("\"k\"", "write `positive = (radius, k)`"),
        ] {
            let (_, messages) = declared(Some(names));
            assert!(messages.len() == 1 && messages[0].contains(rule), "{names}: {messages:?}");
        }
    }
}
