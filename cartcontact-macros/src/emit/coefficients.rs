//! The coefficients of the gap in generated code: literals where they are constants, otherwise computed once per
//! call from the fields.

use num_traits::One;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

use super::{Names, arguments, bounded_generics, local, power_sum};
use crate::closed_forms::Summand;
use crate::gap::coefficient::{Coefficient, Sign};
use crate::geometry::Geometry;
use crate::number::{self, Rational};
use crate::reading::item::{Field, FieldKind, Item};

pub(super) struct Coefficients<'a> {
    item: &'a Item,
    geometry: &'a Geometry,
    names: &'a Names<'a>,
}

impl<'a> Coefficients<'a> {
    pub(super) fn new(item: &'a Item, geometry: &'a Geometry, names: &'a Names<'a>) -> Self {
        Self { item, geometry, names }
    }

    /// `weight` times the coefficient of the term with the index `term`.
    pub(super) fn times(&self, term: usize, weight: &Rational) -> TokenStream {
        let constant = self.names.constant();
        let Some(own) = self.geometry.gap.terms.get(term) else { return TokenStream::new() };
        if let Some(value) = own.coefficient.as_constant() {
            let literal = number::literal(&(value * weight));
            return quote!(#constant(#literal));
        }
        let variable = variable(term);
        if weight.is_one() {
            return quote!(#variable);
        }
        let literal = number::literal(weight);
        quote!(#variable * #constant(#literal))
    }

    /// The factor of a power in a sum, if it is a constant.
    pub(super) fn constant(&self, summand: &Summand) -> Option<Rational> {
        summand.constant(&self.geometry.gap)
    }

    /// All terms of the gap as pairs (coefficient, exponent).
    pub(super) fn terms(&self) -> Vec<TokenStream> {
        let constant = self.names.constant();
        let pair = |(index, term): (usize, &crate::gap::Term)| {
            let (coefficient, exponent) =
                (self.times(index, &Rational::one()), number::literal(&term.exponent));
            quote!((#coefficient, #constant(#exponent)))
        };
        self.geometry.gap.terms.iter().enumerate().map(pair).collect()
    }

    /// All terms of the gap as pairs (coefficient, exponent in parts).
    pub(super) fn powers(&self) -> Vec<TokenStream> {
        let pair = |(index, term): (usize, &crate::gap::Term)| {
            let coefficient = self.times(index, &Rational::one());
            let exponent = power_sum::exponent(&term.exponent, self.names);
            quote!((#coefficient, #exponent))
        };
        self.geometry.gap.terms.iter().enumerate().map(pair).collect()
    }

    /// The coefficients whose sign only the values of the fields tell; none if a constant is negative.
    pub(super) fn of_uncertain_sign(&self) -> Option<Vec<TokenStream>> {
        let terms = &self.geometry.gap.terms;
        let constants = || terms.iter().filter_map(|term| term.coefficient.as_constant());
        let uncertain = self.symbolic().filter(|(_, value)| value.certain_sign() != Some(Sign::NotNegative));
        (!constants().any(|value| value.is_negative()))
            .then(|| uncertain.map(|(index, _)| self.times(index, &Rational::one())).collect())
    }

    /// An array of the coefficients that are not constants, and how many there are.
    pub(super) fn variables(&self) -> (TokenStream, usize) {
        let variables: Vec<Ident> = self.symbolic().map(|(index, _)| variable(index)).collect();
        (quote!([#(#variables),*]), variables.len())
    }

    /// Binds the coefficients that are not constants; empty if all are.
    pub(super) fn preamble(&self) -> TokenStream {
        let (scalar, (variables, count)) = (&self.names.scalar, self.variables());
        if count == 0 {
            return TokenStream::new();
        }
        let coefficients = name();
        quote!(let #variables: [#scalar; #count] = #coefficients(self);)
    }

    /// The function that computes the coefficients that are not constants; empty if all are.
    pub(super) fn function(&self) -> TokenStream {
        let values: Vec<TokenStream> =
            self.symbolic().map(|(_, coefficient)| self.expression(coefficient)).collect();
        if values.is_empty() {
            return TokenStream::new();
        }
        let (scalar, ident, count) = (&self.names.scalar, &self.item.ident, values.len());
        let type_generics = arguments(&self.item.generics);
        let generics = bounded_generics(self.item, self.names);
        let (impl_generics, _, where_clause) = generics.split_for_impl();
        let (coefficients, profile) = (name(), local("profile"));
        let fields = self.fields(&quote!(#profile), &|field| {
            self.symbolic().any(|(_, coefficient)| coefficient.depends_on(&field.ident))
        });
        quote! {
            #[allow(clippy::multiple_bound_locations, reason = "the struct may bound its parameter in place")]
            #[allow(clippy::possible_missing_comma, reason = "generated operators seem to span an attribute's lines")]
            #[inline]
            fn #coefficients #impl_generics (#profile: &#ident #type_generics) -> [#scalar; #count] #where_clause {
                #fields
                [#(#values),*]
            }
        }
    }

    /// An expression in the fields, over the variables that [`fields`](Self::fields) binds.
    pub(super) fn expression(&self, coefficient: &Coefficient) -> TokenStream {
        coefficient.expression(field_variable, &self.names.constant(), &self.names.generated("real_power"))
    }

    /// Binds the needed fields of `profile`, an expression, as scalars ([`field_variable`]).
    pub(super) fn fields(&self, profile: &TokenStream, needed: &dyn Fn(&Field) -> bool) -> TokenStream {
        let constant = self.names.constant();
        let bindings = self.item.fields.iter().filter(|field| needed(field)).map(|field| {
            let (ident, variable) = (&field.ident, field_variable(&field.ident));
            match field.kind {
                FieldKind::TypeParameter(_) => quote!(let #variable = #profile.#ident;),
                FieldKind::F64 => quote!(let #variable = #constant(#profile.#ident);),
                FieldKind::F32 => quote!(let #variable = #constant(<f64 as ::core::convert::From<f32>>::from(#profile.#ident));),
            }
        });
        quote!(#(#bindings)*)
    }

    fn symbolic(&self) -> impl Iterator<Item = (usize, &Coefficient)> {
        let terms = self.geometry.gap.terms.iter().map(|term| &term.coefficient).enumerate();
        terms.filter(|(_, coefficient)| coefficient.as_constant().is_none())
    }
}

/// The name of the function that computes them.
fn name() -> Ident {
    local("coefficients")
}

fn variable(term: usize) -> Ident {
    local(&format!("c{term}"))
}

/// The variable that holds the value of a field.
pub(super) fn field_variable(field: &Ident) -> Ident {
    local(&format!("field_{}", field.unraw()))
}
