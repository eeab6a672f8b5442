//! The option `crate`: the path of the run-time crate.

use proc_macro2::{Literal, Span, TokenStream, TokenTree};
use quote::quote;

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::name::last_of_path;
use crate::reading::{literal, ungrouped};

/// The path that stands behind `equals`. Any other value is reported; a string may hold the path that is meant, with
/// which nothing else is wrong.
pub(super) fn read(value: &[TokenTree], equals: Span, diagnostics: &mut Diagnostics) -> Option<TokenStream> {
    let value = ungrouped(value.iter().cloned().collect());
    if last_of_path(&value).is_some() {
        return Some(quote!(#(#value)*));
    }
    let quoted = match value.as_slice() {
        [TokenTree::Literal(literal)] => path_in_quotes(literal),
        _ => None,
    };
    let (written, path) = quoted.unzip();
    let path_or_example = written.unwrap_or_else(|| "::cartcontact".to_owned());
    let message = format!("`crate` takes a path without quotes; write `crate = {path_or_example}`");
    diagnostics.report(Extent::of(&value, equals), message);
    path
}

/// The path that a string consists of, as written and as tokens.
fn path_in_quotes(literal: &Literal) -> Option<(String, TokenStream)> {
    let text = literal.to_string();
    let text = literal::quoted(&text)?;
    // The compiler would report text that does not even consist of tokens.
    let is_of_names = text.chars().all(|letter| letter.is_alphanumeric() || "_:".contains(letter));
    let tokens: TokenStream = is_of_names.then(|| text.parse().ok())??;
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    last_of_path(&tokens)?;
    tokens.iter_mut().for_each(|token| token.set_span(literal.span()));
    Some((text.to_owned(), quote!(#(#tokens)*)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_in_quotes_is_the_one_that_is_meant() -> Result<(), proc_macro2::LexError> {
        for (text, path, remedy) in [
            ("\"foo\"", Some("foo"), "write `crate = foo`"),
            ("r#\"a::b\"#", Some("a :: b"), "write `crate = a::b`"),
            ("\"(\"", None, "write `crate = ::cartcontact`"),
            ("\"2\"", None, "write `crate = ::cartcontact`"),
            ("2", None, "write `crate = ::cartcontact`"),
        ] {
            let mut diagnostics = Diagnostics::default();
            let value: Vec<TokenTree> = text.parse::<TokenStream>()?.into_iter().collect();
            let found = read(&value, Span::call_site(), &mut diagnostics);
            assert_eq!(found.map(|path| path.to_string()).as_deref(), path);
            assert!(diagnostics.messages()[0].ends_with(remedy), "{text}");
        }
        Ok(())
    }
}
