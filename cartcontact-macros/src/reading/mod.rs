//! Tokens -> what is written in them, with its places; nothing is evaluated.

pub(crate) mod attribute;
mod call;
mod entry;
pub(crate) mod item;
pub(crate) mod literal;
pub(crate) mod parse;
pub(crate) mod positive;
pub(crate) mod syntax;
pub(crate) mod unit;
