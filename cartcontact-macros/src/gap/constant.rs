//! The constant that a gap must not have, and what to do about it.

use crate::gap::coefficient::Coefficient;
use crate::gap::evaluate::Evaluator;
use crate::number::{Rational, decimal};
use crate::reading::literal;
use crate::reading::name::unraw;
use crate::reading::syntax::{Expression, Kind, Summand};

/// A term of the outermost sum without r.
pub(crate) struct Standing {
    value: Coefficient,
    /// Whether it is written as a number or a name, and so as it is shown.
    is_plain: bool,
    is_first: bool,
}

/// The only term without r of an expression that has been evaluated; nothing if there is none, or several.
pub(crate) fn standing(
    written: &Expression,
    is_of_bodies: bool,
    evaluator: &mut Evaluator<'_>,
) -> Option<Standing> {
    let mut terms = Vec::new();
    match &written.kind {
        // Of a body that is nothing but a constant, nothing would be left.
        Kind::Sum(bodies) if is_of_bodies => {
            let sums = bodies.iter().filter(|body| matches!(body.expression.kind, Kind::Sum(_)));
            sums.for_each(|body| collect(Term::whole(&body.expression), &mut terms));
        }
        _ => collect(Term::whole(written), &mut terms),
    }
    let &[Term { subtracted, is_first, expression }] = terms.as_slice() else { return None };
    let value = evaluator.known_coefficient(expression)?;
    let value = if subtracted { value.negated() } else { value };
    let is_plain = matches!(expression.kind, Kind::Number(_) | Kind::Name(_));
    Some(Standing { value, is_plain, is_first })
}

/// A term of a sum, or all that is written.
struct Term<'a> {
    subtracted: bool,
    is_first: bool,
    expression: &'a Expression,
}

impl<'a> Term<'a> {
    fn whole(expression: &'a Expression) -> Self {
        Term { subtracted: false, is_first: true, expression }
    }
}

/// The terms without r, also of sums that stand in parentheses as if without.
fn collect<'a>(term: Term<'a>, terms: &mut Vec<Term<'a>>) {
    match &term.expression.kind {
        Kind::Sum(summands) if !term.subtracted => {
            for (index, Summand { subtracted, expression }) in summands.iter().enumerate() {
                let is_first = term.is_first && index == 0;
                collect(Term { subtracted: *subtracted, is_first, expression }, terms);
            }
        }
        _ if !mentions_r(term.expression) => terms.push(term),
        _ => {}
    }
}

fn mentions_r(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Number(_) | Kind::Faulty => false,
        Kind::Name(name) => unraw(name) == "r",
        Kind::Surface(_) => true,
        Kind::Negative(inner) => mentions_r(inner),
        Kind::Sum(summands) => summands.iter().any(|summand| mentions_r(&summand.expression)),
        Kind::Product(factors) => factors.iter().any(|factor| mentions_r(&factor.expression)),
        Kind::Power(base, exponent) => mentions_r(base) || mentions_r(exponent),
    }
}

/// What to say about the constant `value` of a gap, of which `standing` may be all.
pub(super) fn message(value: &Coefficient, standing: Option<&Standing>) -> String {
    let (sign, size) = signed(value);
    let remedy = match standing.filter(|standing| standing.value == *value) {
        Some(Standing { is_plain: false, .. }) => "remove this term".to_owned(),
        Some(Standing { is_first: true, .. }) if sign == '+' => format!("remove `{size}`"),
        Some(_) => format!("remove `{sign} {size}`"),
        None => {
            let opposite = if sign == '+' { '-' } else { '+' };
            format!("write `{opposite} {size}` behind the gap to take it away")
        }
    };
    format!("the gap must vanish at r = 0; a constant only shifts the approach: {remedy}")
}

/// A sign, and what to write behind it.
fn signed(value: &Coefficient) -> (char, String) {
    match value.as_constant() {
        Some(number) => (if number.is_negative() { '-' } else { '+' }, exactly(&number.abs())),
        None => {
            let text = value.to_string().replace('·', " * ");
            let is_term = !text.starts_with('-') && !text.contains(" + ") && !text.contains(" - ");
            ('+', if is_term { text } else { format!("({text})") })
        }
    }
}

fn exactly(number: &Rational) -> String {
    let text = decimal(number);
    let is_exact = text.contains('/') || literal::number(&text).is_ok_and(|read| read == *number);
    if is_exact { text } else { format!("{}/{}", number.numer(), number.denom()) }
}
