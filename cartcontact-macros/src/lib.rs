//! The attribute `#[gap_profile(...)]` of the crate `cartcontact`, which documents its language.
//!
//! A gap between joint surfaces is read, proved and turned into a solver when the program is compiled. Each stage takes
//! what the stage before it produced:
//!
//! | stage | takes | gives |
//! |---|---|---|
//! | `reading::attribute`, `entry`, `bodies` | the attribute's tokens | expressions and options, as written (`comparison`: what is written for an option) |
//! | `reading::item` | the struct's tokens | its `name`, `generics` (`declaration`), and each `field` that can be a symbol (`positive`: of known sign; `unknown`: what other names are meant as) |
//! | `reading::parse`, `call`, `literal` | tokens of an expression | `syntax`: a tree with places and exact numbers (`slips`, `unit`, `divisor`, `wrong_arguments`: what is no part of the language) |
//! | `gap::evaluate` | syntax and item | `shape`: a sum of powers of r (`polynomial`) and of surfaces (`surface`) with exact coefficients (`coefficient`) |
//! | `gap::expansion` | a shape and the `options` for surfaces | powers of r alone, and a bound of what that neglects (`truncation`, `series`) |
//! | `gap` | powers of r | the same, checked to be a gap, which has no `constant` |
//! | `first_zero` | a sum of powers of r with exact coefficients | its first zero (`search`, `first_root`, `end`) |
//! | `proof` | a gap with constant coefficients | the proof that its contact radius is determined |
//! | `geometry` | attribute and item | gap, range and proof together |
//! | `closed_forms` | a gap | approach, load integral and log kernel as sums of powers |
//! | `start` | geometry and closed forms | what leads the solver to the contact radius: a `table` of `seeds` (in `own_units` where coefficients are symbols), of `curves` (fractional powers, or many terms) or of `roots` (one term), or the leading term |
//! | `emit` | item and geometry | the solver |
//!
//! All stages compute with exact numbers (`number`). Faults are collected on the way (`diagnostics`) and reported
//! together; a fault of a whole geometry comes with a way out that works (`fault`).

// Every user of the crate compiles this one, and deriving `Debug` costs time: only types that a test prints derive it,
// and only for tests.

mod closed_forms;
mod diagnostics;
mod emit;
mod fault;
mod first_zero;
mod gap;
mod geometry;
mod number;
mod proof;
mod reading;
mod start;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;
use quote::quote;

use crate::diagnostics::Diagnostics;
use crate::reading::{attribute, item};

#[expect(
    missing_docs,
    reason = "they would be appended to the description where the crate `cartcontact` exports it"
)]
#[proc_macro_attribute]
pub fn gap_profile(
    attribute: proc_macro::TokenStream,
    item: proc_macro::TokenStream,
) -> proc_macro::TokenStream {
    expand(attribute.into(), item.into()).into()
}

/// The item as it was, and beside it its solver; or every fault, and a stub so that the rest still compiles.
fn expand(attribute: TokenStream, input: TokenStream) -> TokenStream {
    let mut diagnostics = Diagnostics::default();
    let attribute = attribute::parse(attribute, &mut diagnostics);
    let input = item::with_one_profile(input, &mut diagnostics);
    let item = item::parse(input.clone(), &mut diagnostics);
    let crate_path = attribute.crate_path.clone().unwrap_or_else(|| quote!(::cartcontact));
    let Some(mut item) = item else {
        let errors = diagnostics.into_compile_errors();
        return quote!(#input #errors);
    };
    let geometry = geometry::geometry(&attribute, &mut item, &mut diagnostics);
    match geometry.filter(|_| diagnostics.is_empty()) {
        Some(geometry) => emit::solver(&input, &item, &geometry, &crate_path),
        None => {
            item.mark_named(attribute.written_gap);
            emit::fallback(&input, &item, &diagnostics.into_compile_errors(), &crate_path)
        }
    }
}
