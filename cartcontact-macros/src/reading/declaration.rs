//! The tokens of the annotated item -> its parts.
//!
//! The compiler has parsed them before it expands an attribute, so they only have to be told apart: a parser of Rust
//! would be an eighth of what a program that uses this crate compiles.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use crate::reading::generics::Generics;
use crate::reading::{is_punct, length_before};

/// `struct Name<T> where T: Clone { radius: T }`, an enum or a union.
pub(super) struct Declaration {
    pub(super) keyword: Ident,
    pub(super) ident: Ident,
    pub(super) generics: Generics,
    /// The group in braces or in parentheses.
    pub(super) content: Option<Group>,
}

impl Declaration {
    /// Nothing if the tokens are neither a struct nor anything like it.
    pub(super) fn of(tokens: &[TokenTree]) -> Option<Self> {
        let keyword =
            tokens.iter().position(|token| matches!(token, TokenTree::Ident(word) if word != "pub"))?;
        let [TokenTree::Ident(keyword), TokenTree::Ident(ident), rest @ ..] = &tokens[keyword..] else {
            return None;
        };
        if !["struct", "enum", "union"].iter().any(|known| keyword == known) {
            return None;
        }
        let (mut generics, rest) = Generics::parameters(rest);
        let unnamed = rest.first().filter(|first| is_group(first, Delimiter::Parenthesis));
        let rest = &rest[usize::from(unnamed.is_some())..];
        let is_end = |token: &TokenTree| is_punct(token, ';') || is_group(token, Delimiter::Brace);
        let (bounds, rest) = rest.split_at(length_before(rest, is_end));
        generics.add_predicates(bounds.get(1..).unwrap_or_default());
        let content = match unnamed.or(rest.first()) {
            Some(TokenTree::Group(content)) => Some(content.clone()),
            _ => None,
        };
        let generics = generics.without_self(ident);
        Some(Declaration { keyword: keyword.clone(), ident: ident.clone(), generics, content })
    }
}

fn is_group(token: &TokenTree, delimiter: Delimiter) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == delimiter)
}
