//! Operands side by side after `/`, as in `r^2/2R`: physicists divide by both, programmers by the first.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::diagnostics::Extent;
use crate::reading::parse::Parser;
use crate::reading::slips::{is_case, is_times};
use crate::reading::syntax::{Expression, Kind};
use crate::reading::unit::is_unit;
use crate::reading::{is_punct, is_sign, literal, ungrouped};

impl Parser<'_> {
    /// Skips a divisor that lacks an operator, if one follows, and reports it: which of its operands divide is for the
    /// author to say, as each reading is another geometry.
    pub(super) fn unclear_divisor(&mut self) -> Option<Expression> {
        let (divisor, rest) = self.rest.split_at(length(self.rest));
        let (factors, fault) = factors(divisor)?;
        let ([first, _, ..], [.., last]) = (factors.as_slice(), divisor) else { return None };
        let product = factors.join(" * ");
        let tokens = product.parse().unwrap_or_else(|_| TokenStream::new());
        let remedy = if self.is_expression(&tokens.into_iter().collect::<Vec<_>>()) {
            format!("write `({product})` if all of it divides, or `{product}` if only `{first}` does")
        } else {
            "write `*`, and parentheses around all that divides".to_owned()
        };
        let extent = Extent::of(divisor, last.span());
        self.diagnostics.report(extent, format!("{fault}; {remedy}"));
        (self.previous, self.rest) = (last.span().into(), rest);
        Some(Expression { kind: Kind::Faulty, extent })
    }
}

/// The number of tokens before the next operator of a sum or a product; signs and `**` are no such operators.
fn length(tokens: &[TokenTree]) -> usize {
    let mut index = 0;
    let mut follows_operand = false;
    while let Some(token) = tokens.get(index) {
        match token {
            star if is_punct(star, '*') => {
                if !tokens.get(index + 1).is_some_and(|next| is_punct(next, '*')) {
                    break;
                }
                index += 1;
                follows_operand = false;
            }
            slash if is_punct(slash, '/') => break,
            sign if is_sign(sign) && follows_operand => break,
            sign if is_sign(sign) => {}
            other => follows_operand = !matches!(other, TokenTree::Punct(_)),
        }
        index += 1;
    }
    index
}

/// The factors that are meant, as they should be written, and what is wrong with how they are written. Nothing if there
/// is something else among them, which has messages of its own, or might not even be tokens side by side.
fn factors(tokens: &[TokenTree]) -> Option<(Vec<String>, String)> {
    let mut factors: Vec<String> = Vec::new();
    let mut fault = None;
    let mut before: Option<&TokenTree> = None;
    for token in tokens {
        let text = text(token);
        let mut operands = vec![text.clone()];
        match token {
            TokenTree::Ident(name) if is_unit(&text) || is_case(name) || is_times(name) || name == "as" => {
                return None;
            }
            TokenTree::Group(group) if matches!(group.delimiter(), Delimiter::Brace | Delimiter::Bracket) => {
                return None;
            }
            TokenTree::Literal(_) if matches!(before, Some(TokenTree::Literal(_))) => return None,
            TokenTree::Literal(_) => match literal::with_name(&text) {
                Some((number, name)) => {
                    fault.get_or_insert_with(|| literal::reads_as_one(&text));
                    operands = vec![number.to_owned(), literal::factor(name)];
                }
                None => drop(literal::number(&text).ok()?),
            },
            // One of `**`, which is a power.
            star if is_punct(star, '*') => {
                let is_second = before.is_some_and(|before| is_punct(before, '*'));
                operands = vec![if is_second { String::new() } else { "^".to_owned() }];
            }
            TokenTree::Punct(sign) if !"+-^".contains(sign.as_char()) => return None,
            _ => {}
        }
        let mut operands = operands.into_iter();
        if let (Some(before), Some(factor)) = (before, factors.last_mut())
            && is_one_factor(before, token)
        {
            factor.extend(operands.next());
        }
        factors.extend(operands);
        before = Some(token);
    }
    Some((factors, fault.unwrap_or_else(|| "an operator is missing here".to_owned())))
}

/// Whether two tokens belong to one factor: an operator and its operand, or a function and its arguments.
fn is_one_factor(before: &TokenTree, token: &TokenTree) -> bool {
    match (before, token) {
        (TokenTree::Punct(_), _) | (_, TokenTree::Punct(_)) => true,
        (TokenTree::Ident(name), TokenTree::Group(group)) => {
            name != "r" && group.delimiter() == Delimiter::Parenthesis
        }
        _ => false,
    }
}

/// Parentheses that a macro has made invisible are shown.
fn text(token: &TokenTree) -> String {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
            match ungrouped(group.stream()).as_slice() {
                [only] => text(only),
                _ => format!("({})", group.stream()),
            }
        }
        token => token.to_string(),
    }
}
