//! Faults, collected so that one compilation reports all of them.
//!
//! Style of a message: lowercase, the rule first, the remedy after `;`, in the words of the field.

use core::fmt::Display;

use proc_macro2::{Punct, Spacing, Span, TokenStream};
use quote::ToTokens;

/// A stretch of source: the first and the last token of what a message points at.
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
    pub(crate) fn of(tokens: impl IntoIterator<Item = impl Into<Span>>, otherwise: Span) -> Self {
        let mut spans = tokens.into_iter().map(Into::into);
        let first = spans.next().unwrap_or(otherwise);
        Extent { first, last: spans.last().unwrap_or(first) }
    }
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Extent { first: span, last: span }
    }
}

impl ToTokens for Extent {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        for span in [self.first, self.last] {
            let mut mark = Punct::new('.', Spacing::Alone);
            mark.set_span(span);
            mark.to_tokens(tokens);
        }
    }
}

/// The faults found so far.
#[derive(Default)]
pub(crate) struct Diagnostics {
    errors: Option<syn::Error>,
}

impl Diagnostics {
    pub(crate) fn report(&mut self, extent: impl Into<Extent>, message: impl Display) {
        self.add(syn::Error::new_spanned(extent.into(), message));
    }

    pub(crate) fn add(&mut self, error: syn::Error) {
        match &mut self.errors {
            Some(errors) => errors.combine(error),
            None => self.errors = Some(error),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.errors.is_none()
    }

    /// One `compile_error!` for each fault.
    pub(crate) fn into_compile_errors(self) -> TokenStream {
        self.errors.map(syn::Error::into_compile_error).unwrap_or_default()
    }

    #[cfg(test)]
    pub(crate) fn messages(self) -> Vec<String> {
        self.errors.into_iter().flatten().map(|error| error.to_string()).collect()
    }
}
