//! The coefficients of the gap in generated code: literals if they are constants, otherwise computed once per call from
//! the fields, in words or in double words.

use num_traits::{One, Zero};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::operations::Operations;
use super::{Names, bounded_generics, local, power_sum};
use crate::closed_forms::{PowerSum, Prefactor, Summand};
use crate::gap::coefficient::{Coefficient, Sign};
use crate::gap::{Gap, Term};
use crate::geometry::Geometry;
use crate::number::{self, Rational};
use crate::reading::field::{Field, FieldKind};
use crate::reading::item::Item;
use crate::reading::name::unraw;

/// At most this many constants are written out one by one, which lets compilers fold them into the code around them.
/// More of them stand in a table, which takes much less time to compile.
pub(super) const MOST_WRITTEN_OUT: usize = 8;

/// The digits of the coefficients.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Digits {
    OfAWord,
    /// Twice those of a word, for sums that are rounded once.
    OfTwo,
}

#[derive(Clone, Copy)]
pub(super) struct Coefficients<'a> {
    pub(super) item: &'a Item,
    pub(super) geometry: &'a Geometry,
    pub(super) names: &'a Names,
    pub(super) digits: Digits,
}

impl<'a> Coefficients<'a> {
    pub(super) fn new(item: &'a Item, geometry: &'a Geometry, names: &'a Names) -> Self {
        Self { item, geometry, names, digits: Digits::OfAWord }
    }

    pub(super) fn gap(&self) -> &'a Gap {
        &self.geometry.gap
    }

    /// The same for sums that are rounded once: with twice the digits if one of their factors depends on fields, unless
    /// all are fields times powers of two or constants of few digits, for which a word is enough.
    pub(super) fn for_rounding_once<const N: usize>(&self, sums: [&PowerSum; N]) -> Self {
        let mut summands = sums.iter().flat_map(|sum| &sum.summands);
        let are_words = self.gap().is_constant() || summands.all(|summand| self.is_word(summand));
        if are_words { *self } else { self.precise() }
    }

    fn precise(&self) -> Self {
        Self { digits: Digits::OfTwo, ..*self }
    }

    fn is_word(&self, summand: &Summand) -> bool {
        match &summand.factor {
            Prefactor::Constant(value) => number::has_few_digits(value),
            Prefactor::Weight(weight) => {
                let multiple = self.geometry.gap.terms[summand.term].coefficient.as_multiple_of_field();
                multiple.is_some_and(number::is_power_of_two) && number::is_power_of_two(weight)
            }
        }
    }

    /// The type of a coefficient.
    fn scalar(&self) -> TokenStream {
        match self.digits {
            Digits::OfAWord => self.names.scalar.to_token_stream(),
            Digits::OfTwo => {
                let (precise, Names { scalar, fused, .. }) = (self.names.generated("Precise"), self.names);
                quote!(#precise<#scalar, #fused>)
            }
        }
    }

    pub(super) fn number(&self, value: &Rational) -> TokenStream {
        match self.digits {
            Digits::OfAWord => self.names.number(value),
            Digits::OfTwo => {
                let (precise, parts) = (self.scalar(), number::code(number::nearest_and_rest(value)));
                quote!(<#precise>::constant #parts)
            }
        }
    }

    /// A power whose exponent is not an integer.
    pub(super) fn power(&self, base: &TokenStream, exponent: &Rational) -> TokenStream {
        let exponent = power_sum::exponent(exponent, self.names);
        match self.digits {
            Digits::OfAWord => {
                let power = self.names.generated("real_power");
                quote!(#power(#base, #exponent))
            }
            Digits::OfTwo => quote!(#base.power(#exponent)),
        }
    }

    /// The coefficient of the term with that index.
    fn own(&self, index: usize, term: &Term) -> TokenStream {
        match term.coefficient.as_constant() {
            Some(value) => self.names.number(&value),
            None => variable(index).into_token_stream(),
        }
    }

    /// The factor of a power in a sum.
    pub(super) fn factor(&self, summand: &Summand) -> TokenStream {
        let variable = variable(summand.term);
        match &summand.factor {
            Prefactor::Constant(value) => self.number(value),
            Prefactor::Weight(weight) if weight.is_one() => quote!(#variable),
            Prefactor::Weight(weight) => self.scaled(weight, &variable).unwrap_or_else(|| {
                let weight = self.number(weight);
                quote!(#variable * #weight)
            }),
        }
    }

    /// A product with a power of two, which only scales both words of a coefficient.
    pub(super) fn scaled(&self, weight: &Rational, product: &impl ToTokens) -> Option<TokenStream> {
        (self.digits == Digits::OfTwo && number::is_power_of_two(weight)).then(|| {
            let (precise, weight) = (self.scalar(), number::literal(weight));
            quote!(<#precise>::scaled(#product, #weight))
        })
    }

    /// The factor without the weight that `summand` has beside a symbol.
    pub(super) fn unweighted(&self, summand: &Summand) -> TokenStream {
        match &summand.factor {
            Prefactor::Constant(value) => self.names.number(value),
            Prefactor::Weight(_) => variable(summand.term).into_token_stream(),
        }
    }

    /// One over that for a symbol, computed from the fields of `self`, if it takes no division and loses no digits.
    pub(super) fn inverse(&self, summand: &Summand) -> Option<TokenStream> {
        let term = &self.geometry.gap.terms[summand.term];
        let inverse = term.coefficient.inverse_of_divisors()?;
        (!inverse.loses_digits(&term.exponent)).then(|| self.in_fields(&inverse))
    }

    /// An array of such factors, zero where there is no summand. The zero is −0, because a sum with that is the other
    /// summand, whatever it is, so that compilers leave it out.
    pub(super) fn factors(&self, summands: &[Option<&Summand>]) -> TokenStream {
        self.table(summands).unwrap_or_else(|| {
            let factors = summands.iter().map(|summand| match summand {
                Some(summand) => self.factor(summand),
                None => self.no_factor(),
            });
            quote!([#(#factors),*])
        })
    }

    fn no_factor(&self) -> TokenStream {
        match self.digits {
            Digits::OfAWord => {
                let constant = self.names.constant();
                quote!(#constant(-0.0f64))
            }
            Digits::OfTwo => self.number(&Rational::zero()),
        }
    }

    /// The factors of a sum one by one. Many constants become variables whose names begin with `name`, bound
    /// beforehand.
    pub(super) fn bound(&self, name: &str, sum: &PowerSum) -> (Option<TokenStream>, Vec<TokenStream>) {
        let summands: Vec<Option<&Summand>> = sum.summands.iter().map(Some).collect();
        let Some(table) = self.table(&summands) else {
            return (None, sum.summands.iter().map(|summand| self.factor(summand)).collect());
        };
        let variables = (0..summands.len()).map(|index| local(&format!("{name}{index}")).into_token_stream());
        let variables: Vec<TokenStream> = variables.collect();
        (Some(quote!(let [#(#variables),*] = #table;)), variables)
    }

    /// The array as a table, if all factors are constants and there are many.
    fn table(&self, summands: &[Option<&Summand>]) -> Option<TokenStream> {
        let constant = |summand: &Option<&Summand>| match summand {
            Some(summand) => summand.constant().map(number::rounded),
            None => Some(-0.0),
        };
        let constants: Vec<f64> = summands.iter().map(constant).collect::<Option<_>>()?;
        let (function, scalar) = (self.names.generated("constants"), &self.names.scalar);
        (constants.len() > MOST_WRITTEN_OUT).then(|| {
            let constants = number::code(constants);
            quote!(#function::<#scalar, _>(#constants))
        })
    }

    /// All terms of the gap as pairs (coefficient, exponent).
    pub(super) fn terms(&self) -> impl Iterator<Item = TokenStream> {
        self.geometry.gap.terms.iter().enumerate().map(|(index, term)| {
            let (coefficient, constant) = (self.own(index, term), self.names.constant());
            let exponent = number::literal(&term.exponent);
            quote!((#coefficient, #constant(#exponent)))
        })
    }

    /// The coefficients whose sign depends on the values of the fields; none if a constant is negative.
    pub(super) fn of_uncertain_sign(&self) -> Option<Vec<TokenStream>> {
        let terms = &self.geometry.gap.terms;
        let mut constants = terms.iter().filter_map(|term| term.coefficient.as_constant());
        if constants.any(|value| value.is_negative()) {
            return None;
        }
        let uncertain = self.symbolic().filter(|(_, value)| value.certain_sign() != Some(Sign::NotNegative));
        Some(uncertain.map(|(index, _)| variable(index).into_token_stream()).collect())
    }

    /// An array of the coefficients that are not constants, and their number.
    pub(super) fn variables(&self) -> (TokenStream, usize) {
        let variables: Vec<Ident> = self.symbolic().map(|(index, _)| variable(index)).collect();
        (quote!([#(#variables),*]), variables.len())
    }

    /// Binds the coefficients that are not constants; empty if all are constants.
    pub(super) fn preamble(&self) -> TokenStream {
        let (scalar, (variables, count)) = (self.scalar(), self.variables());
        if count == 0 {
            return TokenStream::new();
        }
        let coefficients = self.name();
        quote!(let #variables: [#scalar; #count] = #coefficients(self);)
    }

    /// The functions that compute the coefficients that are not constants, in words and in double words; empty if all
    /// are constants.
    pub(super) fn functions(&self) -> [TokenStream; 2] {
        [self.function(), self.precise().function()]
    }

    /// The operations that compute them, in double words.
    pub(super) fn operations(&self) -> Operations {
        let precise = self.precise();
        let (inverses, values) = (precise.inverses(), precise.values());
        if self.symbolic().any(|(_, coefficient)| coefficient.has_root()) {
            Operations::InLibrary
        } else {
            Operations::of(quote!(#inverses [#(#values),*]))
        }
    }

    fn function(&self) -> TokenStream {
        let values = self.values();
        if values.is_empty() {
            return TokenStream::new();
        }
        let (scalar, ident, count) = (self.scalar(), &self.item.ident, values.len());
        let arguments = self.item.generics.arguments();
        let generics = bounded_generics(self.item, self.names);
        let generics = match self.digits {
            Digits::OfAWord => generics,
            Digits::OfTwo => generics.with_constant(&self.names.fused, &quote!(::core::primitive::bool)),
        };
        let (parameters, bounds) = (generics.declared(), generics.bounds());
        let (coefficients, profile) = (self.name(), local("profile"));
        let terms = &self.geometry.gap.terms;
        let lose_digits =
            self.symbolic().any(|(index, coefficient)| coefficient.loses_digits(&terms[index].exponent));
        let body = if self.digits == Digits::OfAWord && lose_digits {
            let (rounded, precise) = (self.names.generated("rounded"), self.precise());
            let (function, scalar) = (precise.name(), precise.scalar());
            self.names.in_double_words(&quote!(#rounded::<_, #scalar, _>(#function(#profile))))
        } else {
            let fields = self.fields(&quote!(#profile), &|field| {
                self.symbolic().any(|(_, coefficient)| coefficient.depends_on(&field.ident))
            });
            let inverses = self.inverses();
            quote!(#fields #inverses [#(#values),*])
        };
        let inline = match self.digits {
            Digits::OfAWord => quote!(#[inline]),
            // An approach takes them twice, and calls would not share them.
            Digits::OfTwo => quote!(#[inline(always)]),
        };
        quote! {
            #inline
            fn #coefficients #parameters (#profile: &#ident #arguments) -> [#scalar; #count] #bounds { #body }
        }
    }

    fn values(&self) -> Vec<TokenStream> {
        self.symbolic().map(|(_, coefficient)| self.expression(coefficient)).collect()
    }

    /// The value of an expression in the fields of `self`.
    pub(super) fn in_fields(&self, value: &Coefficient) -> TokenStream {
        let fields = self.fields(&quote!(self), &|field| value.depends_on(&field.ident));
        let value_of_fields = self.expression(value);
        if fields.is_empty() { value_of_fields } else { quote!({ #fields #value_of_fields }) }
    }

    /// Binds the inverses that several quotients share.
    fn inverses(&self) -> TokenStream {
        let shared =
            self.item.fields.iter().map(|field| &field.ident).filter(|field| self.shares_inverse(field));
        let bindings = shared.map(|field| {
            let (inverse, one, variable) =
                (inverse_variable(field), self.number(&Rational::one()), field_variable(field));
            quote!(let #inverse = #one / #variable;)
        });
        quote!(#(#bindings)*)
    }

    /// Whether the coefficients have several divisions by powers of a field alone. Its inverse replaces them where its
    /// rounding does not count: a division of double words takes as much as two products. That of a subnormal field
    /// may be infinite.
    pub(super) fn shares_inverse(&self, field: &Ident) -> bool {
        let divisors = self.symbolic().flat_map(|(_, coefficient)| coefficient.only_divisors());
        self.digits == Digits::OfTwo && divisors.filter(|divisor| *divisor == field).count() > 1
    }

    /// Binds the needed fields of `profile`, an expression, as scalars ([`field_variable`]).
    pub(super) fn fields(&self, profile: &TokenStream, needed: &dyn Fn(&Field) -> bool) -> TokenStream {
        let bindings = self.item.fields.iter().filter(|field| needed(field)).map(|field| {
            let (ident, variable) = (&field.ident, field_variable(&field.ident));
            let value = self.value_of_field(&field.kind, quote!(#profile.#ident));
            quote!(let #variable = #value;)
        });
        quote!(#(#bindings)*)
    }

    fn value_of_field(&self, kind: &FieldKind, value: TokenStream) -> TokenStream {
        let value = match kind {
            FieldKind::F32 => {
                let (from_single, scalar) = (self.names.generated("from_single"), &self.names.scalar);
                quote!(#from_single::<#scalar>(#value))
            }
            FieldKind::F64 | FieldKind::TypeParameter(_) => value,
        };
        let (constant, precise) = (self.names.constant(), self.scalar());
        match (self.digits, kind) {
            (Digits::OfAWord, FieldKind::F64) => quote!(#constant(#value)),
            (Digits::OfTwo, FieldKind::F64) => quote!(<#precise>::constant(#value, 0.0)),
            (Digits::OfAWord, _) => value,
            (Digits::OfTwo, _) => quote!(<#precise>::of(#value)),
        }
    }

    /// The name of the function that computes the coefficients.
    fn name(&self) -> Ident {
        local(match self.digits {
            Digits::OfAWord => "coefficients",
            Digits::OfTwo => "precise_coefficients",
        })
    }

    fn symbolic(&self) -> impl Iterator<Item = (usize, &Coefficient)> {
        let terms = self.geometry.gap.terms.iter().map(|term| &term.coefficient).enumerate();
        terms.filter(|(_, coefficient)| coefficient.as_constant().is_none())
    }
}

fn variable(term: usize) -> Ident {
    local(&format!("c{term}"))
}

/// The variable that holds the value of a field.
pub(super) fn field_variable(field: &Ident) -> Ident {
    local(&format!("field_{}", unraw(field)))
}

pub(super) fn inverse_variable(field: &Ident) -> Ident {
    local(&format!("inverse_{}", unraw(field)))
}
