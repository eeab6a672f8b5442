//! The constant that a gap must not have, and what to do about it.

use crate::gap::coefficient::Coefficient;
use crate::gap::evaluate::Evaluator;
use crate::number::{Rational, decimal, is_written};
use crate::reading::name::unraw;
use crate::reading::syntax::{Expression, Kind, Summand};

/// Nobody copies a longer remedy; `f64` has 17 digits, and the product of three such numbers 51.
const LONGEST_REMEDY: usize = 80;

/// The constant of a gap as it is written: what stands there without r.
pub(crate) struct WrittenConstant {
    is_of_bodies: bool,
    /// Nothing if there is no such term, or several.
    only: Option<OnlyTerm>,
}

/// The only term without r of the outermost sum.
struct OnlyTerm {
    value: Coefficient,
    place: PlaceInSum,
    /// Whether it is written as a number or a name, and so just as it is shown.
    is_plain: bool,
}

/// Where a term stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PlaceInSum {
    First,
    Behind,
    /// It is a whole body, of which nothing would be left without it.
    Alone,
}

impl WrittenConstant {
    /// The terms without r of an expression that has been evaluated.
    pub(crate) fn of(written: &Expression, is_of_bodies: bool, evaluator: &mut Evaluator<'_>) -> Self {
        let mut terms = Vec::new();
        match &written.kind {
            Kind::Sum(bodies) if is_of_bodies => {
                for Summand { expression, .. } in bodies {
                    let is_sum = matches!(expression.kind, Kind::Sum(_));
                    let place = if is_sum { PlaceInSum::First } else { PlaceInSum::Alone };
                    collect(WrittenTerm { subtracted: false, place, expression }, &mut terms);
                }
            }
            _ => {
                let place = PlaceInSum::First;
                collect(WrittenTerm { subtracted: false, place, expression: written }, &mut terms);
            }
        }
        let mut terms = terms.into_iter().filter_map(|term| term.evaluated(evaluator));
        let only = terms.next().filter(|_| terms.next().is_none());
        WrittenConstant { is_of_bodies, only }
    }
}

/// A term of a sum, or the whole expression.
struct WrittenTerm<'a> {
    subtracted: bool,
    place: PlaceInSum,
    expression: &'a Expression,
}

impl WrittenTerm<'_> {
    /// Nothing if the term is zero.
    fn evaluated(&self, evaluator: &mut Evaluator<'_>) -> Option<OnlyTerm> {
        let value = evaluator.known_coefficient(self.expression).filter(|value| !value.is_zero())?;
        let value = if self.subtracted { value.negated() } else { value };
        let is_plain = match &self.expression.kind {
            Kind::Number(number) => is_written(number),
            Kind::Name(_) => true,
            _ => false,
        };
        Some(OnlyTerm { value, place: self.place, is_plain })
    }
}

/// The terms without r, including those of sums in parentheses that could as well be left out.
fn collect<'a>(term: WrittenTerm<'a>, terms: &mut Vec<WrittenTerm<'a>>) {
    match &term.expression.kind {
        Kind::Sum(summands) if !term.subtracted => {
            for (index, Summand { subtracted, expression }) in summands.iter().enumerate() {
                let place = if index == 0 { term.place } else { PlaceInSum::Behind };
                collect(WrittenTerm { subtracted: *subtracted, place, expression }, terms);
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

/// What to say about the constant `value` of a gap; the only term in the `constant` as written may be all of it.
pub(super) fn message(value: &Coefficient, constant: Option<&WrittenConstant>) -> String {
    let (sign, size) = signed(value);
    let only = constant.and_then(|constant| constant.only.as_ref()).filter(|only| only.value == *value);
    let remedy = match only {
        Some(OnlyTerm { place: PlaceInSum::Alone, .. }) => "a flat body is `0`, as in `lower = 0`".to_owned(),
        Some(OnlyTerm { is_plain: false, .. }) => "remove this term".to_owned(),
        Some(OnlyTerm { place: PlaceInSum::First, .. }) if sign == '+' => format!("remove `{size}`"),
        Some(_) => format!("remove `{sign} {size}`"),
        None => {
            let opposite = if sign == '+' { '-' } else { '+' };
            let whole =
                if constant.is_some_and(|constant| constant.is_of_bodies) { "a body" } else { "the gap" };
            if size.len() > LONGEST_REMEDY {
                format!("write behind {whole} what takes it away")
            } else {
                format!("write `{opposite} {size}` behind {whole} to take it away")
            }
        }
    };
    format!("the gap must vanish at r = 0; a constant only shifts the approach: {remedy}")
}

/// A sign, and what to write after it.
fn signed(value: &Coefficient) -> (char, String) {
    match value.as_constant() {
        Some(number) => (if number.is_negative() { '-' } else { '+' }, exactly(&number.abs())),
        None => {
            let text = value.to_string().replace('·', " * ");
            match text.strip_prefix('-') {
                _ if value.is_sum() => ('+', format!("({text})")),
                Some(size) => ('-', size.to_owned()),
                None => ('+', text),
            }
        }
    }
}

fn exactly(number: &Rational) -> String {
    let text = decimal(number);
    let is_exact = text.contains('/') || is_written(number);
    if is_exact { text } else { format!("{}/{}", number.numer(), number.denom()) }
}
