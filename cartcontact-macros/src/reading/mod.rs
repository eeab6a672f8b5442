//! Tokens -> what is written in them, with its places; nothing is evaluated.

pub(crate) mod attribute;
mod call;
mod entry;
pub(crate) mod item;
pub(crate) mod literal;
pub(crate) mod parse;
pub(crate) mod positive;
mod slips;
pub(crate) mod syntax;
pub(crate) mod unit;

use proc_macro2::TokenTree;

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}
