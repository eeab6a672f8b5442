//! The tokens of a field -> its name, its type, and whether it is always there.

use proc_macro2::{Delimiter, Ident, Span, TokenTree};

use crate::diagnostics::Extent;
use crate::reading::generics::Generics;
use crate::reading::name::last_of_path;
use crate::reading::{between_commas, is_punct, length_before, ungrouped};

/// A field that can be a symbol.
pub(crate) struct Field {
    pub(crate) ident: Ident,
    pub(crate) kind: FieldKind,
    /// Whether it is declared greater than 0.
    pub(crate) is_positive: bool,
    /// Whether the gap or its range depends on it.
    pub(crate) used: bool,
    /// Its `#[cfg(...)]`: the compiler removes fields only after it has expanded the attributes of their struct.
    pub(super) condition: Option<Extent>,
}

#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) enum FieldKind {
    F64,
    F32,
    TypeParameter(Ident),
}

/// The `#[cfg(...)]` among the attributes before a field, which may be inside a `#[cfg_attr(...)]`.
pub(super) fn condition(field: &[TokenTree]) -> Option<Extent> {
    let attribute = field.windows(2).find(|pair| {
        let [hash, TokenTree::Group(attribute)] = pair else { return false };
        is_punct(hash, '#') && is_condition(&ungrouped(attribute.stream()))
    });
    attribute.map(|attribute| Extent::of(attribute, Span::call_site()))
}

/// Whether an attribute with this content, or one that it stands for, is a `cfg`.
fn is_condition(content: &[TokenTree]) -> bool {
    match content {
        [TokenTree::Ident(name), ..] if name == "cfg" => true,
        [TokenTree::Ident(name), TokenTree::Group(group)] if name == "cfg_attr" => {
            let parts: Vec<TokenTree> = group.stream().into_iter().collect();
            between_commas(&parts).into_iter().skip(1).any(is_condition)
        }
        _ => false,
    }
}

/// The name and the type of a field without its default, and the place between them; nothing if it is none, which the
/// compiler reports.
pub(super) fn named(field: &[TokenTree]) -> Option<(&Ident, &[TokenTree], Span)> {
    let colon = length_before(field, |token| is_punct(token, ':'));
    let ([.., TokenTree::Ident(ident)], [colon, ty @ ..]) = field.split_at(colon) else { return None };
    let ty = &ty[..length_before(ty, |token| is_punct(token, '='))];
    is_type(ty).then_some((ident, ty, colon.span()))
}

/// Whether tokens may be one type, unlike those where a comma is missing before the next field.
fn is_type(ty: &[TokenTree]) -> bool {
    match ty {
        [] => false,
        [TokenTree::Ident(first), TokenTree::Ident(_) | TokenTree::Literal(_), ..] => {
            ["dyn", "extern", "impl", "unsafe"].iter().any(|word| first == word)
        }
        _ => true,
    }
}

/// `f64` and `f32`, alone or under the path of the primitive types, or one of the struct's own type parameters: under
/// another path these are names of something else.
pub(super) fn kind(ty: &[TokenTree], generics: &Generics) -> Option<FieldKind> {
    match ty {
        [TokenTree::Group(group)]
            if matches!(group.delimiter(), Delimiter::None | Delimiter::Parenthesis) =>
        {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            return kind(&inner, generics);
        }
        [TokenTree::Ident(name)] if generics.has_type(name) => {
            return Some(FieldKind::TypeParameter(name.clone()));
        }
        _ => {}
    }
    let name = last_of_path(ty)?;
    let is_primitive = match ty {
        [_] => true,
        [.., TokenTree::Ident(module), _, _, _] => module == "primitive",
        _ => false,
    };
    match name.to_string().as_str() {
        _ if !is_primitive => None,
        "f64" => Some(FieldKind::F64),
        "f32" => Some(FieldKind::F32),
        _ => None,
    }
}
