//! The lints that the annotated item allows, for generated code, which repeats its names and types.

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

use crate::reading::{between_commas, is_punct, ungrouped};

/// The attributes before an item that allow something, or expect something that generated code need not repeat.
pub(super) fn allowed(mut tokens: &[TokenTree]) -> TokenStream {
    let mut allowed = TokenStream::new();
    while let [hash, TokenTree::Group(attribute), rest @ ..] = tokens
        && is_punct(hash, '#')
    {
        if let [TokenTree::Ident(name), TokenTree::Group(lints)] = ungrouped(attribute.stream()).as_slice()
            && (name == "allow" || name == "expect")
        {
            let lints: Vec<TokenTree> = lints.stream().into_iter().collect();
            let lints = between_commas(&lints).into_iter().filter(|lint| !is_of_use(lint));
            let lints = lints.map(|lint| quote!(#(#lint)*));
            allowed.extend(quote!(#[allow(#(#lints),*)]));
        }
        tokens = rest;
    }
    allowed
}

/// Whether a lint asks if a program uses something. Generated code that allows it counts as use: the struct would never
/// be found unused.
fn is_of_use(lint: &[TokenTree]) -> bool {
    matches!(lint, [TokenTree::Ident(name)] if name == "dead_code" || name == "unused")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_struct_allows_is_repeated() {
        let item = quote! {
            #[doc = "A ball."]
            #[allow(non_snake_case, reason = "as printed")]
            #[expect(dead_code, deprecated)]
            #[must_use]
            struct Ball { R: f64 }
        };
        let tokens: Vec<TokenTree> = item.into_iter().collect();
        let expected = quote!(#[allow(non_snake_case, reason = "as printed")] #[allow(deprecated)]);
        assert_eq!(allowed(&tokens).to_string(), expected.to_string());
    }
}
