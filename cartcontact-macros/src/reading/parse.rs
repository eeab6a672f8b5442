//! Tokens -> [`Expression`], by recursive descent along the grammar in [`crate::reading::syntax`].
//!
//! A fault costs one operand: it is reported, the rest of the operand is skipped, and reading goes on at the next
//! operator, so one compilation reports the faults of all factors and terms. Every call consumes a token or ends its
//! loop, and the recursion is as deep as parentheses, signs and exponents are nested, which [`MAXIMUM_DEPTH`] limits.

use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenTree};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::is_punct;
use crate::reading::literal;
use crate::reading::similar::known_number;
use crate::reading::slips::is_case;
use crate::reading::syntax::{Expression, Factor, Kind, Summand};

pub(super) const NO_CONSTANTS: &str = "constants of a program are not known here";
pub(super) const NO_OPERATOR: &str = "an operator is missing here; for a product write `*`, as in `2 * r`";
/// Every level takes a few hundred bytes of the compiler's stack, of which a thread of an editor may have little.
const MAXIMUM_DEPTH: usize = 64;

/// Reads all of `tokens`; `place` stands for them in messages if there are none.
pub(crate) fn expression(tokens: &[TokenTree], place: Span, diagnostics: &mut Diagnostics) -> Expression {
    Parser { rest: tokens, previous: place.into(), depth: 0, diagnostics }.everything()
}

/// Whether some tokens can be read as they are, inside of as many parentheses and powers as `depth` says.
pub(super) fn is_expression(tokens: &[TokenTree], depth: usize) -> bool {
    let (mut faults, place) = (Diagnostics::default(), Span::call_site());
    drop(Parser { rest: &[], previous: place.into(), depth, diagnostics: &mut faults }.inside(tokens, place));
    faults.is_empty()
}

pub(super) struct Parser<'a> {
    pub(super) rest: &'a [TokenTree],
    /// The token that was read last: the place of "something is missing here".
    pub(super) previous: Extent,
    depth: usize,
    pub(super) diagnostics: &'a mut Diagnostics,
}

impl<'a> Parser<'a> {
    fn everything(mut self) -> Expression {
        let mut sum = self.sum();
        while let Some(stray) = self.rest.first() {
            self.stray(stray);
            self.skip_term();
            sum.kind = Kind::Faulty;
            if !self.rest.is_empty() {
                self.sum();
            }
        }
        sum
    }

    fn sum(&mut self) -> Expression {
        let mut summands = vec![Summand { subtracted: false, expression: self.product() }];
        while let Some(sign) = self.next_sign() {
            let expression = self.product();
            summands.push(Summand { subtracted: sign == '-', expression });
        }
        let [first, .., last] = summands.as_slice() else { return summands.swap_remove(0).expression };
        let extent = Extent::between(first.expression.extent, last.expression.extent);
        Expression { kind: Kind::Sum(summands), extent }
    }

    fn product(&mut self) -> Expression {
        let mut factors = vec![Factor { divides: false, expression: self.factor() }];
        while let Some(divides) = self.next_product_operator() {
            let unclear = if divides { self.unclear_divisor() } else { None };
            let expression = unclear.unwrap_or_else(|| self.factor());
            factors.push(Factor { divides, expression });
        }
        let [first, .., last] = factors.as_slice() else { return factors.swap_remove(0).expression };
        let extent = Extent::between(first.expression.extent, last.expression.extent);
        Expression { kind: Kind::Product(factors), extent }
    }

    pub(super) fn factor(&mut self) -> Expression {
        let Some(sign) = self.next_sign() else { return self.power() };
        let start = self.previous;
        let operand = self.deeper(Self::factor);
        let extent = Extent::between(start, operand.extent);
        let kind = if sign == '-' { Kind::Negative(Box::new(operand)) } else { operand.kind };
        Expression { kind, extent }
    }

    fn power(&mut self) -> Expression {
        let base = self.atom();
        self.reads_point();
        if self.take_punct('^').is_none() && !self.reads_double_star() {
            return base;
        }
        let exponent = self.deeper(Self::factor);
        if let Some((place, message)) = self.halved_exponent(&base, &exponent) {
            return self.fault(place, message);
        }
        let extent = Extent::between(base.extent, exponent.extent);
        Expression { kind: Kind::Power(Box::new(base), Box::new(exponent)), extent }
    }

    fn atom(&mut self) -> Expression {
        let Some((token, rest)) = self.rest.split_first() else {
            let place = self.previous;
            return self.fault(place, "something is missing here; a number, `r`, a field or `(` must follow");
        };
        if !matches!(token, TokenTree::Punct(_)) {
            self.take_token();
        }
        match token {
            TokenTree::Literal(literal) => self.literal(literal),
            TokenTree::Ident(name) => self.name(name),
            TokenTree::Group(group) => self.group(group),
            TokenTree::Punct(_) => {
                self.no_operand(token, rest);
                self.skip_term();
                Expression { kind: Kind::Faulty, extent: token.span().into() }
            }
        }
    }

    /// Reports a sign in place of an operand; it may be the point of a decimal.
    fn no_operand(&mut self, sign: &TokenTree, behind: &[TokenTree]) {
        let [TokenTree::Literal(literal), ..] = behind else { return self.stray(sign) };
        let digits = literal.to_string();
        if !is_punct(sign, '.') || !literal::may_follow_point(&digits) {
            return self.stray(sign);
        }
        let meant = literal::as_product(&format!("0.{digits}"));
        let place = Extent::between(sign.span().into(), literal.span().into());
        self.diagnostics.report(place, format!("a decimal begins with a digit; write `{meant}`"));
    }

    fn literal(&mut self, literal: &Literal) -> Expression {
        if let Some(message) = self.exponent_apart(literal) {
            return self.fault(Extent::between(literal.span().into(), self.previous), message);
        }
        match literal::number(&literal.to_string()) {
            Ok(_) if self.is_number_next() => self.spaced_number(literal),
            Ok(value) if self.is_percent_next() => self.percent(&value),
            Ok(_) if self.is_times_ten_next() => self.times_ten(literal),
            Ok(value) => self.unless_method(Expression { kind: Kind::Number(value), extent: self.previous }),
            Err(message) => self.fault(literal.span(), message),
        }
    }

    fn name(&mut self, name: &Ident) -> Expression {
        if let Some(arguments) = self.arguments()
            && name != "r"
        {
            return self.surface(name, arguments);
        }
        if let [next @ (TokenTree::Group(_) | TokenTree::Literal(_)), behind @ ..] = self.rest
            && let Some(message) = self.wrong_arguments(name, &without_parentheses(next, behind))
        {
            let place = Extent::between(name.span().into(), next.span().into());
            return self.fault(place, message);
        }
        if is_case(name) {
            return self.case(name);
        }
        if let Some(message) = self.reads_index(name) {
            return self.fault(Extent::between(name.span().into(), self.previous), message);
        }
        if let Some(last) = self.end_of_path() {
            if let Some(arguments) = self.arguments() {
                return self.function(name.span(), &last, arguments);
            }
            let place = Extent::between(name.span().into(), last.span().into());
            let remedy = known_number(&last).unwrap_or("write the number, or a field of the struct");
            return self.fault(place, format!("{NO_CONSTANTS}; {remedy}"));
        }
        self.unless_method(Expression { kind: Kind::Name(name.clone()), extent: self.previous })
    }

    /// The arguments in parentheses after a name.
    fn arguments(&self) -> Option<&'a Group> {
        match self.rest.first()? {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => Some(group),
            _ => None,
        }
    }

    fn group(&mut self, group: &Group) -> Expression {
        let extent = self.previous;
        match group.delimiter() {
            Delimiter::Parenthesis if group.stream().is_empty() => {
                self.fault(extent, "these parentheses are empty; write an expression between them")
            }
            // A macro_rules fragment such as `$e:expr` arrives in invisible parentheses.
            Delimiter::Parenthesis | Delimiter::None => {
                let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
                let inside = self.inside(&tokens, group.span_open());
                let extent = if group.delimiter() == Delimiter::None { inside.extent } else { extent };
                self.unless_method(Expression { kind: inside.kind, extent })
            }
            Delimiter::Brace => {
                self.fault(extent, "only parentheses group terms; write `( )` in place of `{ }`")
            }
            Delimiter::Bracket => {
                self.fault(extent, "only parentheses group terms; write `( )` in place of `[ ]`")
            }
        }
    }

    /// Reads all of `tokens`, which stand in parentheses behind `place`.
    pub(super) fn inside(&mut self, tokens: &[TokenTree], place: Span) -> Expression {
        self.deeper(|outer| {
            let (previous, depth) = (place.into(), outer.depth);
            Parser { rest: tokens, previous, depth, diagnostics: outer.diagnostics }.everything()
        })
    }

    /// Whether some tokens can be read as they are. Only for a message, after which they are skipped: where they are read
    /// again, every level of nested calls doubles the time.
    pub(super) fn is_expression(&self, tokens: &[TokenTree]) -> bool {
        is_expression(tokens, self.depth)
    }

    pub(super) fn deeper(&mut self, read: impl FnOnce(&mut Self) -> Expression) -> Expression {
        if self.depth == MAXIMUM_DEPTH {
            let place = self.rest.first().map_or(self.previous, |next| next.span().into());
            let nested = self.fault(
                place,
                format!(
                    "the expression is nested too deeply; remove parentheses, signs or powers, as at most \
                     {MAXIMUM_DEPTH} levels are read"
                ),
            );
            while self.next_sign().is_some() {}
            self.skip_term();
            return nested;
        }
        self.depth += 1;
        let expression = read(self);
        self.depth -= 1;
        expression
    }

    fn next_sign(&mut self) -> Option<char> {
        self.take_punct('+').or_else(|| self.take_punct('-'))
    }

    /// Whether the next factor divides. Two operands side by side, and what others write for an operator or after a
    /// number, are reported and read as intended.
    fn next_product_operator(&mut self) -> Option<bool> {
        if self.take_punct('*').is_some() {
            return Some(false);
        }
        if self.take_punct('/').is_some() {
            return Some(true);
        }
        let next = self.rest.first()?;
        if matches!(next, TokenTree::Punct(_)) {
            return None;
        }
        if self.reads_unit() || self.reads_conversion() || self.reads_exponent() {
            return self.next_product_operator();
        }
        match next {
            // The group itself reports which parentheses are read.
            TokenTree::Group(group) if matches!(group.delimiter(), Delimiter::Brace | Delimiter::Bracket) => {
            }
            TokenTree::Ident(word) if is_case(word) => {
                self.case(word);
                return None;
            }
            _ if self.reads_times() => {}
            _ => {
                let place = Extent::between(self.previous, next.span().into());
                self.diagnostics.report(place, NO_OPERATOR);
            }
        }
        Some(false)
    }

    pub(super) fn take_punct(&mut self, wanted: char) -> Option<char> {
        match self.rest {
            [TokenTree::Punct(next), rest @ ..] if next.as_char() == wanted => {
                self.rest = rest;
                self.previous = next.span().into();
                Some(wanted)
            }
            _ => None,
        }
    }

    fn stray(&mut self, token: &TokenTree) {
        let message = match token {
            TokenTree::Punct(operator) if "+-*/^".contains(operator.as_char()) => {
                format!(
                    "something is missing before `{operator}`; a number, `r`, a field or `(` must stand there"
                )
            }
            _ => format!(
                "`{token}` has no meaning in a gap; use numbers, `r`, fields, `+ - * / ^` and parentheses"
            ),
        };
        self.diagnostics.report(token.span(), message);
    }

    pub(super) fn fault(&mut self, place: impl Into<Extent>, message: impl Into<String>) -> Expression {
        let extent = place.into();
        self.diagnostics.report(extent, message);
        self.skip_before("+-*/^");
        Expression { kind: Kind::Faulty, extent }
    }

    fn skip_term(&mut self) {
        self.skip_before("+-");
    }

    /// Skips the tokens before the next of some operators.
    fn skip_before(&mut self, operators: &str) {
        let is_operator = |token: &TokenTree| operators.chars().any(|operator| is_punct(token, operator));
        while self.rest.first().is_some_and(|next| !is_operator(next)) {
            self.take_token();
        }
    }

    pub(super) fn take_token(&mut self) {
        if let Some((token, rest)) = self.rest.split_first() {
            self.previous = token.span().into();
            self.rest = rest;
        }
    }
}

/// The arguments in other brackets, or without brackets if they are a single token.
fn without_parentheses(token: &TokenTree, behind: &[TokenTree]) -> Vec<TokenTree> {
    let goes_on = |next: &TokenTree| match next {
        TokenTree::Punct(operator) => "*/^".contains(operator.as_char()),
        _ => true,
    };
    match token {
        TokenTree::Group(group) => group.stream().into_iter().collect(),
        _ if behind.first().is_some_and(goes_on) => Vec::new(),
        single => vec![single.clone()],
    }
}
