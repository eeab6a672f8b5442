//! Syntax -> [`Shape`]: gives names their meaning and numbers their values.

use num_traits::One;
use proc_macro2::Ident;

use crate::diagnostics::{Diagnostics, Extent};
use crate::gap::coefficient::Coefficient;
use crate::gap::polynomial::Polynomial;
use crate::gap::shape::Shape;
use crate::gap::surface::Surface;
use crate::number::Rational;
use crate::reading::field::Field;
use crate::reading::item::{Item, Meaning};
use crate::reading::name::unraw;
use crate::reading::syntax::{self, Expression, Factor, Kind, Summand};
use crate::reading::unknown::Context;

/// Reports what it cannot evaluate, and goes on with the rest.
pub(crate) struct Evaluator<'a> {
    item: &'a Item,
    diagnostics: &'a mut Diagnostics,
    /// Where names stand, which decides what may be meant by them.
    context: Context,
    /// Fields whose type has been reported.
    mistyped: Vec<Ident>,
}

impl<'a> Evaluator<'a> {
    /// An evaluator that begins with the gap, in which r may be named.
    pub(crate) fn new(item: &'a Item, names_r: bool, diagnostics: &'a mut Diagnostics) -> Self {
        Evaluator { item, diagnostics, context: Context::Gap { names_r }, mistyped: Vec::new() }
    }

    /// The value of a gap as far as it can be evaluated, and whether that is all of it.
    pub(crate) fn gap(&mut self, expression: &Expression) -> (Shape, bool) {
        match &expression.kind {
            Kind::Sum(summands) => self.summed(summands),
            _ => self.shape(expression).map_or((Shape::default(), false), |all| (all, true)),
        }
    }

    /// The value of an expression that has been evaluated before and does not depend on r.
    pub(crate) fn known_coefficient(&mut self, expression: &Expression) -> Option<Coefficient> {
        self.shape(expression)?.as_coefficient()
    }

    /// An expression without r, such as a radius.
    pub(crate) fn coefficient(&mut self, expression: &Expression, subject: &str) -> Option<Coefficient> {
        let shape = self.shape_at(Context::Coefficient, expression)?;
        let coefficient = shape.as_coefficient();
        if coefficient.is_none() {
            let rule =
                if shape.surfaces.is_empty() { "must not depend on r" } else { "must not be a surface" };
            let message = format!("{subject} {rule}; write a number, or an expression in the fields");
            self.diagnostics.report(expression.extent, message);
        }
        coefficient
    }

    /// The value of a number; `rule` is reported if it is none.
    pub(crate) fn number(&mut self, expression: &Expression, rule: &str) -> Option<Rational> {
        let shape = self.shape_at(Context::Number, expression)?;
        let number = shape.as_coefficient().and_then(|value| value.as_constant());
        if number.is_none() {
            self.diagnostics.report(expression.extent, rule);
        }
        number
    }

    fn shape_at(&mut self, context: Context, expression: &Expression) -> Option<Shape> {
        let outside = core::mem::replace(&mut self.context, context);
        let value = self.shape(expression);
        self.context = outside;
        value
    }

    fn shape(&mut self, expression: &Expression) -> Option<Shape> {
        let extent = expression.extent;
        let value = match &expression.kind {
            Kind::Faulty => None,
            Kind::Number(value) => Some(constant(Coefficient::constant(value.clone()), extent)),
            Kind::Name(name) => self.name(name),
            Kind::Negative(inner) => self.shape(inner).map(Shape::negated),
            Kind::Sum(summands) => match self.summed(summands) {
                (sum, true) => Some(sum),
                (_, false) => None,
            },
            Kind::Product(factors) => self.product(factors, extent),
            Kind::Power(base, exponent) => self.power(base, exponent).map(|power| power.spread(extent)),
            Kind::Surface(surface) => self.surface(surface, extent),
        };
        value.map(|value| value.located(extent))
    }

    fn name(&mut self, name: &Ident) -> Option<Shape> {
        let extent = name.span().into();
        if unraw(name) == "r" {
            let one = Coefficient::constant(Rational::one());
            return Some(Polynomial::new(one, Rational::one(), extent).into());
        }
        match self.item.meaning(name) {
            Meaning::Symbol(Field { ident, is_positive: true, .. }) => {
                Some(constant(Coefficient::positive_field(ident.clone()), extent))
            }
            Meaning::Symbol(field) => Some(constant(Coefficient::field(field.ident.clone()), extent)),
            Meaning::Undecided => None,
            // With another type it would be no number either.
            Meaning::WrongType(_) if matches!(self.context, Context::Number) => {
                Some(constant(Coefficient::field(name.clone()), extent))
            }
            Meaning::Unknown => {
                let remedy = self.item.remedy(name, self.context);
                self.fault(extent, format!("`{name}` is unknown; {remedy}"))
            }
            Meaning::WrongType(place) => {
                if !self.mistyped.contains(name) {
                    self.mistyped.push(name.clone());
                    let message = format!(
                        "the field `{name}` must be a real number to stand in a gap; give it the type `f64`, `f32` or \
                         a type parameter, by that name, as a macro does not see what another stands for"
                    );
                    self.diagnostics.report(place, message);
                }
                None
            }
        }
    }

    /// The sum of the terms that can be evaluated, and whether these are all.
    fn summed(&mut self, summands: &[Summand]) -> (Shape, bool) {
        let mut sum = Shape::default();
        let mut complete = true;
        for Summand { subtracted, expression } in summands {
            match self.shape(expression) {
                Some(value) if *subtracted => sum.add(value.negated()),
                Some(value) => sum.add(value),
                None => complete = false,
            }
            if self.checked(sum.check_length(), expression.extent).is_none() {
                return (sum, false);
            }
        }
        (sum, complete)
    }

    fn product(&mut self, factors: &[Factor], extent: Extent) -> Option<Shape> {
        let mut product: Option<Shape> = None;
        let (mut faulty, mut sums) = (false, 0);
        for Factor { divides, expression } in factors {
            let value = match self.shape(expression) {
                Some(divisor) if *divides => {
                    self.checked(divisor.power(&-Rational::one()), expression.extent)
                }
                value => value,
            };
            let Some(value) = value else {
                faulty = true;
                continue;
            };
            sums += u32::from(value.powers.terms().len() > 1);
            let next = product.as_ref().map_or(Ok(value.clone()), |product| product.multiply(&value));
            product = self.checked(next, expression.extent);
            faulty |= product.is_none();
        }
        let product = product.filter(|_| !faulty);
        // Each term of a product of sums comes from several places.
        if sums > 1 { product.map(|product| product.spread(extent)) } else { product }
    }

    fn power(&mut self, base: &Expression, exponent: &Expression) -> Option<Shape> {
        let value = self.shape(base);
        let number = self.number(exponent, EXPONENT);
        let power = value?.power(&number?);
        self.checked(power, Extent::between(base.extent, exponent.extent))
    }

    fn surface(&mut self, surface: &syntax::Surface, extent: Extent) -> Option<Shape> {
        let radius = self.coefficient(&surface.radius, "the radius of a surface");
        let conic_constant = match &surface.conic_constant {
            None => Some(None),
            Some(conic_constant) => self.coefficient(conic_constant, "a conic constant").map(Some),
        };
        let (radius, conic_constant) = radius.zip(conic_constant)?;
        if radius.is_zero() {
            let message = "the radius of a surface must not be zero; leave out a surface that is flat";
            return self.fault(surface.radius.extent, message);
        }
        Some(Surface::new(radius, conic_constant, extent).into())
    }

    fn checked<T>(&mut self, result: Result<T, &'static str>, extent: Extent) -> Option<T> {
        result.map_err(|message| self.diagnostics.report(extent, message)).ok()
    }

    /// Reports a fault, and returns no value.
    pub(crate) fn fault<T>(&mut self, extent: Extent, message: impl Into<String>) -> Option<T> {
        self.diagnostics.report(extent, message);
        None
    }
}

const EXPONENT: &str = "an exponent must be a number: which powers a gap has is fixed when it is compiled; \
                        write it out, as in `r^2`";

fn constant(value: Coefficient, extent: Extent) -> Shape {
    Polynomial::constant(value, extent).into()
}
