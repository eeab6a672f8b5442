//! Tokens -> what they say, with its places; nothing is evaluated.
//!
//! | what | modules |
//! |---|---|
//! | the attribute | `attribute`, `entry` by entry: options, `bodies`, `positive`, `crate_path` |
//! | an expression | `parse` by the grammar in `syntax`; `literal`, `call` |
//! | the annotated struct | `item`: `declaration`, `field`, `generics`, `lints`, `name` |
//! | what was meant by what is wrong | `slips`, `divisor`, `comparison`, `similar`, `unit`, `unknown`, `wrong_arguments` |

pub(crate) mod attribute;
mod bodies;
mod call;
mod comparison;
mod crate_path;
mod declaration;
mod divisor;
mod entry;
pub(crate) mod field;
pub(crate) mod generics;
pub(crate) mod item;
mod lints;
pub(crate) mod literal;
pub(crate) mod name;
pub(crate) mod parse;
pub(crate) mod positive;
mod similar;
mod slips;
pub(crate) mod syntax;
pub(crate) mod unit;
pub(crate) mod unknown;
mod wrong_arguments;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

fn is_sign(token: &TokenTree) -> bool {
    is_punct(token, '+') || is_punct(token, '-')
}

/// The tokens, without the invisible group that a macro may have put them into.
fn ungrouped(tokens: TokenStream) -> Vec<TokenTree> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    match tokens.as_slice() {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::None => ungrouped(group.stream()),
        _ => tokens,
    }
}

/// The number of tokens before the first token outside of angle brackets that ends them; all if none does.
fn length_before(tokens: &[TokenTree], ends: impl Fn(&TokenTree) -> bool) -> usize {
    let (mut depth, mut follows_dash) = (0, false);
    for (index, token) in tokens.iter().enumerate() {
        let is_arrow = follows_dash && is_punct(token, '>');
        if depth == 0 && !is_arrow && ends(token) {
            return index;
        }
        depth += i32::from(is_punct(token, '<')) - i32::from(is_punct(token, '>') && !is_arrow);
        follows_dash = is_punct(token, '-');
    }
    tokens.len()
}

/// The tokens between commas outside of angle brackets.
fn between_commas(mut tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    let mut parts = Vec::new();
    while !tokens.is_empty() {
        let (part, rest) = tokens.split_at(length_before(tokens, |token| is_punct(token, ',')));
        parts.push(part);
        tokens = rest.get(1..).unwrap_or_default();
    }
    parts
}
