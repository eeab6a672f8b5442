//! A table by octaves of the load integral as code.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::{Names, local};
use crate::table::Table;

pub(super) fn name() -> Ident {
    local("TABLE")
}

/// The table as a constant of the program.
pub(super) fn item(table: &Table, names: &Names<'_>) -> TokenStream {
    let (name, kind, value) = (name(), names.generated("Table"), value(table, names));
    quote!(static #name: #kind = #value;)
}

pub(super) fn value(table: &Table, names: &Names<'_>) -> TokenStream {
    let [kind, rows] = ["Table", "Rows"].map(|name| names.generated(name));
    let (first, single) = (Literal::i32_unsuffixed(table.first), table.single);
    let count = Literal::usize_unsuffixed(table.rows.len());
    let bytes = Literal::byte_string(&table.in_places());
    quote!(#kind { first: #first, count: #count, single: #single, rows: #rows(*#bytes) })
}
