//! A table by octaves of the load integral as code.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::{Names, local};
use crate::start::table::{Bytes, Table};

pub(super) fn name() -> Ident {
    local("TABLE")
}

/// The table as a constant of the program.
pub(super) fn item(table: &Table, names: &Names) -> TokenStream {
    let (name, kind, value) = (name(), names.generated("Table"), value(table, names));
    quote!(static #name: #kind = #value;)
}

pub(super) fn value<R: Bytes>(table: &Table<R>, names: &Names) -> TokenStream {
    let (kind, rows) = (names.generated("Table"), names.generated("Rows"));
    let quarters = |(first, count): (i32, usize)| {
        let (kind, first) = (names.generated("Quarters"), Literal::i32_unsuffixed(first));
        let count = Literal::usize_unsuffixed(count);
        quote!(#kind { first: #first, count: #count })
    };
    let (quarters, single) = (quarters((table.first, table.rows.len())), quarters(table.single));
    let bytes = Literal::byte_string(&table.in_places());
    quote!(#kind { quarters: #quarters, single: #single, rows: #rows(*#bytes) })
}
