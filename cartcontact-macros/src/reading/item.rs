//! The annotated struct -> [`Item`]: what its fields may stand for in a profile.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::declaration::Declaration;
use crate::reading::field::{Field, FieldKind, condition, kind, named};
use crate::reading::generics::Generics;
use crate::reading::lints;
use crate::reading::name::{is_keyword, is_same, unraw};
use crate::reading::similar::{closest, collect_names, known_number};
use crate::reading::slips::is_times;
use crate::reading::{between_commas, is_punct, ungrouped, unit};

/// The struct that a profile is attached to.
pub(crate) struct Item {
    pub(crate) ident: Ident,
    pub(crate) generics: Generics,
    /// Its own `#[allow(...)]`.
    pub(crate) allowed: TokenStream,
    /// The fields that can be symbols, in order of declaration.
    pub(crate) fields: Vec<Field>,
    /// The other fields: naming one in a profile is a fault of its type.
    pub(super) others: Vec<(Ident, Extent)>,
    /// If it is not a struct, or the compiler reports a field, names in a profile cannot be judged.
    has_known_fields: bool,
}

/// What a name in an expression stands for, other than `r`.
pub(crate) enum Meaning<'a> {
    Symbol(&'a Field),
    /// The field has a type that cannot stand in a gap, which is written here.
    WrongType(Extent),
    Unknown,
    /// It may be a field of something that is no sound struct, which is reported.
    Undecided,
}

/// The item without further gap profiles, which are reported: each would implement the same trait again.
pub(crate) fn with_one_profile(input: TokenStream, diagnostics: &mut Diagnostics) -> TokenStream {
    let mut tokens: Vec<TokenTree> = input.into_iter().collect();
    while let Some(position) = tokens.windows(2).position(is_gap_profile) {
        let attribute: Vec<TokenTree> = tokens.drain(position..position + 2).collect();
        let place = Extent::of(&attribute, Span::call_site());
        diagnostics
            .report(place, "a struct has one gap profile; remove this one, or write another struct for it");
    }
    tokens.into_iter().collect()
}

/// Whether `#` and `[...]` are this attribute, under any path.
fn is_gap_profile(pair: &[TokenTree]) -> bool {
    let [TokenTree::Punct(hash), TokenTree::Group(attribute)] = pair else { return false };
    let content = ungrouped(attribute.stream()).into_iter();
    let path = content.take_while(|token| !matches!(token, TokenTree::Group(_)));
    let names = path.filter(|token| matches!(token, TokenTree::Ident(_)));
    hash.as_char() == '#' && names.last().is_some_and(|name| name.to_string() == "gap_profile")
}

/// Reads the annotated item. If a profile cannot be attached, the fault is reported; an item that still has a name and
/// generics is returned nonetheless, for its stub.
pub(crate) fn parse(input: TokenStream, diagnostics: &mut Diagnostics) -> Option<Item> {
    let tokens = ungrouped(input);
    let Some(Declaration { keyword, ident, generics, content }) = Declaration::of(&tokens) else {
        let place = Extent::of(&tokens, Span::call_site());
        diagnostics
            .report(place, "a gap profile belongs on a struct; write `#[gap_profile(...)] struct Name;`");
        return None;
    };
    if let Some(place) = generics.condition() {
        diagnostics.report(
            place,
            "whether a struct has a parameter must not depend on a `#[cfg]`, as an implementation repeats it; write one \
             struct for each case, with the `#[cfg]` on the struct",
        );
        return None;
    }
    if generics.has_type(&ident) {
        let message = format!(
            "the type parameter `{ident}` has the name of the struct, which an implementation could not name beside \
             it; rename one of them"
        );
        diagnostics.report(ident.span(), message);
        return None;
    }
    let (has_known_fields, allowed) = (keyword == "struct", lints::allowed(&tokens));
    let mut item =
        Item { ident, generics, allowed, fields: Vec::new(), others: Vec::new(), has_known_fields };
    if keyword == "enum" {
        diagnostics.report(
            keyword.span(),
            "a gap profile belongs on a struct, not an enum; use one struct for each geometry",
        );
    } else if keyword == "union" {
        diagnostics.report(keyword.span(), "a gap profile belongs on a struct, not a union; use a struct");
    } else if let Some(fields) = content.filter(|content| content.delimiter() == Delimiter::Brace) {
        let fields: Vec<TokenTree> = fields.stream().into_iter().collect();
        // The compiler reports a semicolon between two fields, and goes on.
        let parts = fields.split(|token| is_punct(token, ';'));
        for field in parts.flat_map(between_commas) {
            item.declare(field, diagnostics);
        }
    }
    Some(item)
}

impl Item {
    /// Adds the field `name: type`, which may follow attributes and a visibility.
    fn declare(&mut self, field: &[TokenTree], diagnostics: &mut Diagnostics) {
        let Some((ident, ty, place)) = named(field) else {
            self.has_known_fields = false;
            return;
        };
        if unraw(ident) == "r" {
            diagnostics.report(
                ident.span(),
                "a field named `r` cannot be told from the distance r from the axis; give it another name",
            );
        }
        let (ident, condition) = (ident.clone(), condition(field));
        match kind(ty, &self.generics) {
            Some(kind) => self.fields.push(Field { ident, kind, is_positive: false, used: false, condition }),
            None => self.others.push((ident, Extent::of(ty, place))),
        }
    }

    pub(crate) fn meaning(&self, name: &Ident) -> Meaning<'_> {
        if let Some(field) = self.fields.iter().find(|field| is_same(&field.ident, name)) {
            return Meaning::Symbol(field);
        }
        match self.others.iter().find(|(ident, _)| is_same(ident, name)) {
            Some((_, ty)) => Meaning::WrongType(*ty),
            None if !self.has_known_fields => Meaning::Undecided,
            None => Meaning::Unknown,
        }
    }

    pub(crate) fn field_names(&self) -> Vec<String> {
        self.fields.iter().map(|field| field.ident.to_string()).collect()
    }

    /// Marks the fields that a faulty gap names, or may mean: it would depend on them. A symbol that resembles none of
    /// them may mean any.
    pub(crate) fn mark_named(&mut self, written_gap: TokenStream) {
        let mut names = Vec::new();
        collect_names(written_gap, &mut names);
        for (name, may_be_symbol) in names {
            let meant = closest(&name.to_string(), self.field_names());
            let may_mean_any = meant.is_none() && may_be_symbol && !has_other_meaning(&name);
            for field in &mut self.fields {
                field.used |= may_mean_any || meant.as_ref().is_some_and(|meant| field.ident == meant);
            }
        }
    }

    /// Marks the fields that a geometry depends on. They share one scalar type, so they may name at most one type
    /// parameter.
    pub(crate) fn mark_used(&mut self, used: impl Fn(&Ident) -> bool, diagnostics: &mut Diagnostics) {
        let mut parameter: Option<Ident> = None;
        for field in self.fields.iter_mut().filter(|field| used(&field.ident)) {
            field.used = true;
            if let Some(place) = field.condition {
                diagnostics.report(
                    place,
                    "whether there is such a field must not depend on a `#[cfg]`, as the gap names it; write one \
                     struct for each case, with the `#[cfg]` on the struct, or use a type parameter",
                );
            }
            let FieldKind::TypeParameter(own) = &field.kind else { continue };
            match &parameter {
                Some(first) if first != own => diagnostics.report(
                    own.span(),
                    format!(
                        "the fields of one profile share one type; write `{first}` here, or `f64` for all"
                    ),
                ),
                _ => parameter = Some(own.clone()),
            }
        }
    }
}

/// Whether a name that resembles no field is known as something else: r, a number, a unit or a word of Rust.
fn has_other_meaning(name: &Ident) -> bool {
    let written = unraw(name);
    let is_word =
        is_keyword(name) || is_times(name) || ["f32", "f64", "sphere", "conic"].contains(&&*written);
    is_word || known_number(name).is_some() || unit::is_unit(&written)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use proc_macro2::Group;
    use quote::{format_ident, quote};

    use super::*;

    fn item(input: TokenStream) -> (Option<Item>, Vec<String>) {
        let mut diagnostics = Diagnostics::default();
        let item = parse(input, &mut diagnostics);
        (item, diagnostics.messages())
    }

    #[test]
    fn fields_are_symbols_by_their_type() {
        let (item, messages) = item(quote! {
            struct Ball<T> { a: f64; b: core::primitive::f32, c: T, name: String, d: Vec<[f64; 3]> }
        });
        let item = item.unwrap();
        assert!(messages.is_empty());
        let kinds: Vec<&FieldKind> = item.fields.iter().map(|field| &field.kind).collect();
        assert_eq!(kinds, [&FieldKind::F64, &FieldKind::F32, &FieldKind::TypeParameter(format_ident!("T"))]);
        assert!(matches!(item.meaning(&format_ident!("name")), Meaning::WrongType(_)));
        assert!(matches!(item.meaning(&format_ident!("d")), Meaning::WrongType(_)));
    }

    #[test]
    fn fields_that_the_compiler_reports_are_no_faults_of_the_gap() {
        for fields in
            ["c: f64 pub d: f64", "c f64", "f64", "c = f64, d: f64", "d: f64, c:", "c: mut f64", "c: f 64"]
        {
            let fields: TokenStream = fields.parse().unwrap();
            let (item, messages) = item(quote!(struct Ball { #fields }));
            assert!(messages.is_empty());
            assert!(matches!(item.unwrap().meaning(&format_ident!("c")), Meaning::Undecided), "{fields}");
        }
        for ty in ["dyn Debug", "unsafe fn(f64)", "Vec<dyn Debug>", "crate::Units", "units::f64", "[f64; 3]"]
        {
            let ty: TokenStream = ty.parse().unwrap();
            let (item, _) = item(quote!(struct Ball { c: #ty }));
            assert!(matches!(item.unwrap().meaning(&format_ident!("c")), Meaning::WrongType(_)), "{ty}");
        }
    }

    #[test]
    fn only_structs_carry_a_profile() {
        for input in [
            quote!(
                enum E {}
            ),
            quote!(union U { a: f64 }),
        ] {
            let (item, messages) = item(input);
            assert!(item.is_some());
            assert_eq!(messages.len(), 1);
        }
        let (item, messages) = item(quote!(
            fn f() {}
        ));
        assert!(item.is_none());
        assert_eq!(messages.len(), 1);
    }

    #[test]
    fn fields_without_names_are_no_symbols() {
        let (item, messages) = item(quote!(
            struct S<'a, T>(pub PhantomData<&'a T>, core::primitive::f64)
            where
                T: Clone;
        ));
        let item = item.unwrap();
        assert!(messages.is_empty() && item.fields.is_empty() && item.others.is_empty());
        assert!(matches!(item.meaning(&format_ident!("core")), Meaning::Unknown));
    }

    #[test]
    fn fields_that_a_faulty_gap_may_mean_are_marked() {
        for (gap, expected) in [
            ("raduis * r^2", ["radius"].as_slice()),
            ("2radius * r^2", &["radius"]),
            ("curvature * r^2", &["radius", "kappa"]),
            ("2c * r^2", &["radius", "kappa"]),
            ("2r + sin(r) + 2 mm x pi * r^2", &[]),
            ("upper = f64::powi(r, 2), lower = r.abs()", &[]),
        ] {
            let (item, _) = item(quote!(
                struct Ball {
                    radius: f64,
                    kappa: f64,
                }
            ));
            let mut item = item.unwrap();
            item.mark_named(gap.parse().unwrap());
            let marked = item.fields.iter().filter(|field| field.used);
            assert_eq!(marked.map(|field| field.ident.to_string()).collect::<Vec<_>>(), expected, "{gap}");
        }
    }

    #[test]
    fn fields_of_a_gap_depend_on_no_configuration() {
        let (item, _) = item(quote!(
            struct Two {
                #[cfg(feature = "double")]
                a: f64,
                #[cfg(not(feature = "double"))]
                a: f32,
                #[doc = "Always there."]
                #[cfg_attr(feature = "double", allow(dead_code))]
                b: f64,
                #[cfg_attr(feature = "double", doc = "Sometimes there.", cfg(feature = "single"))]
                c: f64,
            }
        ));
        let mut item = item.unwrap();
        for (named, faults) in [("b", 0), ("a", 2), ("c", 1)] {
            let mut diagnostics = Diagnostics::default();
            item.mark_used(|name| name == named, &mut diagnostics);
            assert_eq!(diagnostics.messages().len(), faults, "{named}");
        }
    }

    /// The content of each attribute arrives in invisible parentheses.
    #[test]
    fn attributes_of_a_macro_are_seen() {
        let content =
            [quote!(gap_profile(r ^ 4)), quote!(allow(deprecated)), quote!(cfg(feature = "single"))];
        let [profile, lint, condition] = content.map(|content| Group::new(Delimiter::None, content));
        let mut diagnostics = Diagnostics::default();
        let input = with_one_profile(
            quote!(#[#profile] #[#lint] struct Ball { #[#condition] c: f64 }),
            &mut diagnostics,
        );
        assert_eq!(diagnostics.messages().len(), 1);
        let item = item(input).0.unwrap();
        assert_eq!(item.allowed.to_string(), quote!(#[allow(deprecated)]).to_string());
        assert!(item.fields[0].condition.is_some());
    }

    #[test]
    fn one_profile_has_one_scalar_type() {
        let (item, _) = item(quote!(
            struct Two<T, U> {
                a: T,
                b: U,
            }
        ));
        let mut item = item.unwrap();
        let mut diagnostics = Diagnostics::default();
        item.mark_used(|name| name == "a", &mut diagnostics);
        assert!(diagnostics.is_empty());
        item.mark_used(|_| true, &mut diagnostics);
        assert_eq!(diagnostics.messages().len(), 1);
    }
}
