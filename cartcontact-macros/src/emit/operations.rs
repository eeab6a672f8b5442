//! The number of operations that an evaluator takes.
//!
//! The operations of coefficients are counted in the generated code. Evaluators call routines of the run-time crate,
//! whose operations follow from the powers of the sum: they are stated, in double words.

use core::fmt::{Display, Formatter, Result};

use proc_macro2::{TokenStream, TokenTree};

/// The binary operators of a piece of code, and whether it also calls the run-time crate.
#[derive(Default)]
pub(super) struct Operations {
    /// Including divisions.
    multiplications: u32,
    /// Including subtractions.
    additions: u32,
    pub(super) calls_library: bool,
    /// Whether the operands are double words.
    pub(super) is_double: bool,
}

/// Code, and the operations that it takes.
pub(super) struct Counted {
    pub(super) code: TokenStream,
    pub(super) operations: Operations,
}

impl Operations {
    /// The operations of a routine that are not counted.
    pub(super) fn in_library() -> Self {
        Self { calls_library: true, ..Self::default() }
    }

    pub(super) fn in_double_words(multiplications: u32, additions: u32) -> Self {
        Self { multiplications, additions, calls_library: false, is_double: true }
    }

    pub(super) fn of(code: &TokenStream) -> Self {
        let mut count = Operations::default();
        count.add(code.clone());
        count
    }

    /// An operator follows an operand; a sign or a reference does not.
    fn add(&mut self, code: TokenStream) {
        let mut behind_operand = false;
        for token in code {
            match &token {
                TokenTree::Group(group) => self.add(group.stream()),
                TokenTree::Punct(operator) if behind_operand => match operator.as_char() {
                    '*' | '/' => self.multiplications += 1,
                    '+' | '-' => self.additions += 1,
                    _ => {}
                },
                TokenTree::Ident(name) => self.calls_library |= name == "generated",
                _ => {}
            }
            behind_operand = !matches!(token, TokenTree::Punct(_));
        }
    }
}

impl Display for Operations {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        if self.calls_library {
            return formatter.write_str("a routine of the run-time crate");
        }
        let (multiplications, additions) = (self.multiplications, self.additions);
        if self.is_double {
            return write!(formatter, "{multiplications} ×, {additions} + of double words");
        }
        write!(formatter, "{multiplications} × or ÷, {additions} + or −")
    }
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;

    #[test]
    fn binary_operators_are_counted_and_signs_are_not() {
        let code = quote! { let s = r * r; (constant(-0.5f64) + (-c1) * s - c2 / s) * s };
        assert_eq!(Operations::of(&code).to_string(), "4 × or ÷, 2 + or −");
        assert_eq!(
            Operations::of(&quote!(1 + krate::generated::sum(r))).to_string(),
            "a routine of the run-time crate"
        );
    }
}
