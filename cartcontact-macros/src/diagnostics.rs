//! Faults, collected so that one compilation reports all of them.
//!
//! Style of a message: lowercase, the rule first, the remedy after `;`, in the words of contact mechanics.

use proc_macro2::{Delimiter, Group, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote, quote_spanned};

/// A stretch of source: the first and the last token that a message points at.
///
/// Stable Rust cannot join two spans into one, but a diagnostic may start at one and end at another.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    first: Span,
    last: Span,
}

impl Extent {
    pub(crate) fn between(first: Extent, last: Extent) -> Self {
        Extent { first: first.first, last: last.last }
    }

    /// The extent of some tokens, or `otherwise` if there are none.
    pub(crate) fn of(tokens: &[TokenTree], otherwise: Span) -> Self {
        match tokens {
            [] => otherwise.into(),
            [only] => only.span().into(),
            [first, .., last] => Extent { first: first.span(), last: last.span() },
        }
    }
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Extent { first: span, last: span }
    }
}

/// The faults found so far.
#[derive(Default)]
pub(crate) struct Diagnostics {
    faults: Vec<(Extent, String)>,
}

impl Diagnostics {
    pub(crate) fn report(&mut self, extent: impl Into<Extent>, message: impl Into<String>) {
        self.faults.push((extent.into(), message.into()));
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    /// One `compile_error!` for each fault.
    pub(crate) fn into_compile_errors(self) -> TokenStream {
        self.faults.iter().map(|(extent, message)| compile_error(*extent, message)).collect()
    }

    #[cfg(test)]
    pub(crate) fn messages(self) -> Vec<String> {
        self.faults.into_iter().map(|(_, message)| message).collect()
    }
}

/// A call of `compile_error!` from the first to the last token of an extent.
fn compile_error(Extent { first, last }: Extent, message: &str) -> TokenStream {
    let mut message = Literal::string(message);
    message.set_span(last);
    let mut argument = Group::new(Delimiter::Brace, message.into_token_stream());
    argument.set_span(last);
    let name = quote_spanned!(first=> ::core::compile_error!);
    quote!(#name #argument)
}
