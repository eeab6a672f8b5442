//! The number of operations that an evaluator takes.
//!
//! The operations of coefficients are counted in the generated code. Evaluators call routines of the run-time crate,
//! whose operations follow from the powers of the sum: they are stated.

use core::fmt::{Display, Formatter, Result};

use proc_macro2::{TokenStream, TokenTree};

/// What a call takes.
pub(super) enum Operations {
    /// Not counted: a routine of the run-time crate.
    InLibrary,
    /// Of double words; divisions are among the multiplications, subtractions among the additions.
    Counted { multiplications: u32, additions: u32 },
}

impl Operations {
    /// The binary operators of a piece of code.
    pub(super) fn of(code: TokenStream) -> Self {
        let [multiplications, additions] = counts(code);
        Self::Counted { multiplications, additions }
    }
}

/// An operator follows an operand; a sign or a reference does not.
fn counts(code: TokenStream) -> [u32; 2] {
    let (mut counts_so_far, mut behind_operand) = ([0; 2], false);
    for token in code {
        let [multiplications, additions] = match &token {
            TokenTree::Group(group) => counts(group.stream()),
            TokenTree::Punct(operator) if behind_operand => match operator.as_char() {
                '*' | '/' => [1, 0],
                '+' | '-' => [0, 1],
                _ => [0, 0],
            },
            _ => [0, 0],
        };
        counts_so_far[0] += multiplications;
        counts_so_far[1] += additions;
        behind_operand = !matches!(token, TokenTree::Punct(_));
    }
    counts_so_far
}

impl Display for Operations {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        match self {
            Self::InLibrary => formatter.write_str("a routine of the run-time crate"),
            Self::Counted { multiplications, additions } => {
                write!(formatter, "{multiplications} ×, {additions} + of double words")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;

    #[test]
    fn binary_operators_are_counted_and_signs_are_not() {
        let code = quote! { let s = r * r; (constant(-0.5f64) + (-c1) * s - c2 / s) * s };
        assert_eq!(Operations::of(code).to_string(), "4 ×, 2 + of double words");
    }
}
