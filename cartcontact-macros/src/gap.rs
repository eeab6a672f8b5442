//! Syntax -> [`Gap`]: evaluates what was written and checks that it is a gap.

use std::collections::BTreeSet;

use num_traits::{One, Signed, Zero};
use proc_macro2::Ident;

use crate::coefficient::Coefficient;
use crate::diagnostics::{Diagnostics, Extent};
use crate::item::{Item, Meaning};
use crate::number::{self, Rational};
use crate::polynomial::{Monomial, Polynomial};
use crate::syntax::{Expression, Factor, Kind, Summand};

const MAXIMUM_EXPONENT: u32 = 1024;
const MAXIMUM_TERMS: usize = 256;

/// The gap between the undeformed surfaces, a sum of terms `coefficient * r^exponent`.
#[derive(Clone, Debug)]
pub(crate) struct Gap {
    /// In ascending order of their exponents; there is one at least.
    pub(crate) terms: Vec<Term>,
}

#[derive(Clone, Debug)]
pub(crate) struct Term {
    /// Greater than 0, at most 1024.
    pub(crate) exponent: Rational,
    /// Not zero.
    pub(crate) coefficient: Coefficient,
    /// Where the first contribution to it was written.
    pub(crate) extent: Extent,
}

impl Gap {
    /// Whether no coefficient depends on a field.
    pub(crate) fn is_constant(&self) -> bool {
        self.terms.iter().all(|term| term.coefficient.as_constant().is_some())
    }
}

/// Gives names their meaning and numbers their values. What it cannot evaluate it reports, and goes on beside it.
pub(crate) struct Evaluator<'a> {
    item: &'a Item,
    diagnostics: &'a mut Diagnostics,
    /// Fields whose type has been reported.
    mistyped: BTreeSet<Ident>,
}

impl<'a> Evaluator<'a> {
    pub(crate) fn new(item: &'a Item, diagnostics: &'a mut Diagnostics) -> Self {
        Evaluator { item, diagnostics, mistyped: BTreeSet::new() }
    }

    pub(crate) fn gap(&mut self, expression: &Expression) -> Option<Gap> {
        let (polynomial, complete) = match &expression.kind {
            Kind::Sum(summands) => self.summed(summands),
            _ => self.polynomial(expression).map_or((Polynomial::default(), false), |all| (all, true)),
        };
        let mut terms = Vec::new();
        let mut faulty = !complete;
        for (exponent, monomial) in polynomial.into_terms() {
            match term(exponent, monomial) {
                Ok(term) => terms.push(term),
                Err((extent, message)) => {
                    self.diagnostics.report(extent, message);
                    faulty = true;
                }
            }
        }
        if faulty {
            return None;
        }
        if terms.is_empty() {
            return self.fault(
                expression.extent,
                "the gap is zero everywhere: its terms cancel; write one that opens with r",
            );
        }
        if terms.len() > MAXIMUM_TERMS {
            return self.fault(expression.extent, "a gap may have at most 256 terms");
        }
        Some(Gap { terms })
    }

    /// An expression without r, such as a radius.
    pub(crate) fn coefficient(&mut self, expression: &Expression, subject: &str) -> Option<Coefficient> {
        let coefficient = self.polynomial(expression)?.as_coefficient();
        if coefficient.is_none() {
            self.diagnostics.report(expression.extent, format!("{subject} must not depend on r"));
        }
        coefficient
    }

    fn polynomial(&mut self, expression: &Expression) -> Option<Polynomial> {
        let extent = expression.extent;
        let value = match &expression.kind {
            Kind::Faulty => None,
            Kind::Number(value) => Some(Polynomial::constant(Coefficient::constant(value.clone()), extent)),
            Kind::Name(name) => self.name(name),
            Kind::Negative(inner) => self.polynomial(inner).map(Polynomial::negated),
            Kind::Sum(summands) => {
                Some(self.summed(summands)).filter(|(_, complete)| *complete).map(|(sum, _)| sum)
            }
            Kind::Product(factors) => self.product(factors),
            Kind::Power(base, exponent) => self.power(base, exponent),
        };
        value.map(|value| value.located(extent))
    }

    fn name(&mut self, name: &Ident) -> Option<Polynomial> {
        let extent = name.span().into();
        if name == "r" {
            return Some(Polynomial::new(Coefficient::constant(Rational::one()), Rational::one(), extent));
        }
        match self.item.meaning(name) {
            Meaning::Symbol(field) => Some(Polynomial::constant(Coefficient::field(field.clone()), extent)),
            Meaning::Unknown { remedy } => self.fault(extent, format!("`{name}` is unknown; {remedy}")),
            Meaning::WrongType(ty) => {
                if self.mistyped.insert(name.clone()) {
                    self.diagnostics.add(syn::Error::new_spanned(
                        ty,
                        format!("the field `{name}` of a gap must be a number; give it the type `f64`, `f32` or a type parameter"),
                    ));
                }
                None
            }
        }
    }

    /// The sum of what can be evaluated, and whether that is all.
    fn summed(&mut self, summands: &[Summand]) -> (Polynomial, bool) {
        let mut sum = Polynomial::default();
        let mut complete = true;
        for Summand { subtracted, expression } in summands {
            match self.polynomial(expression) {
                Some(value) if *subtracted => sum.add(value.negated()),
                Some(value) => sum.add(value),
                None => complete = false,
            }
        }
        (sum, complete)
    }

    fn product(&mut self, factors: &[Factor]) -> Option<Polynomial> {
        let mut product: Option<Polynomial> = None;
        let mut faulty = false;
        for Factor { divides, expression } in factors {
            let value = self.polynomial(expression);
            let value =
                value.and_then(
                    |value| if *divides { self.inverse(&value, expression.extent) } else { Some(value) },
                );
            let Some(value) = value else {
                faulty = true;
                continue;
            };
            let next = product.as_ref().map_or(Ok(value.clone()), |product| product.multiply(&value));
            product = self.checked(next, expression.extent);
            faulty |= product.is_none();
        }
        product.filter(|_| !faulty)
    }

    fn inverse(&mut self, divisor: &Polynomial, extent: Extent) -> Option<Polynomial> {
        let inverse = divisor.power(&-Rational::one());
        self.checked(inverse, extent)
    }

    fn power(&mut self, base: &Expression, exponent: &Expression) -> Option<Polynomial> {
        let value = self.polynomial(base);
        let number = self.exponent(exponent);
        let power = value?.power(&number?);
        self.checked(power, Extent::between(base.extent, exponent.extent))
    }

    fn exponent(&mut self, expression: &Expression) -> Option<Rational> {
        let number = self.polynomial(expression)?.as_coefficient().and_then(|value| value.as_constant());
        if number.is_none() {
            self.diagnostics.report(
                expression.extent,
                "an exponent must be a number: which powers a gap has is fixed when it is compiled; write it out, as in `r^2`",
            );
        }
        number
    }

    fn checked<T>(&mut self, result: Result<T, &'static str>, extent: Extent) -> Option<T> {
        result.map_err(|message| self.diagnostics.report(extent, message)).ok()
    }

    fn fault<T>(&mut self, extent: Extent, message: impl core::fmt::Display) -> Option<T> {
        self.diagnostics.report(extent, message);
        None
    }
}

fn term(exponent: Rational, monomial: Monomial) -> Result<Term, (Extent, String)> {
    let Monomial { coefficient, extent } = monomial;
    let fault = |message: &str| Err((extent, message.to_owned()));
    if exponent.is_zero() {
        let constant = coefficient.to_string();
        let removal =
            if constant.starts_with('-') { format!("`{constant}`") } else { format!("`+ {constant}`") };
        return Err((
            extent,
            format!("the gap must vanish at r = 0; a constant only shifts the approach: remove {removal}"),
        ));
    }
    if exponent.is_negative() {
        return fault("exponent must be greater than 0; a gap that vanishes at r = 0 needs positive powers");
    }
    if exponent > number::integer(MAXIMUM_EXPONENT) {
        return fault("exponent must be at most 1024; the gap beyond is a step");
    }
    if number::nearest(&exponent).is_none() {
        return fault("exponent is too small for an `f64`; write a larger one");
    }
    if !coefficient.is_representable() {
        return fault(
            "coefficient does not fit into an `f64`; use a unit of length that brings it nearer to 1",
        );
    }
    Ok(Term { exponent, coefficient, extent })
}
