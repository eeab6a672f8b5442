//! `max_radius`, and `check` if the values of fields decide.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Names;
use super::coefficients::{Coefficients, field_variable};
use crate::gap::Term;
use crate::gap::coefficient::Coefficient;
use crate::gap::range::Range;
use crate::gap::surface::Surface;
use crate::geometry::Geometry;
use crate::number::{Rational, integer, literal};
use crate::proof::Proof;
use crate::reading::field::{Field, FieldKind};
use crate::reading::name::unraw;

pub(super) fn methods(coefficients: &Coefficients<'_>) -> TokenStream {
    let (geometry, names) = (coefficients.geometry, coefficients.names);
    let is_constant = geometry.gap.is_constant() && !matches!(geometry.range, Range::Symbolic(_));
    let checked = (!is_constant).then_some(Checked(coefficients));
    let scalar = &names.scalar;
    let end = known(coefficients);
    let max_radius = match (&end, &checked) {
        (Some(end), _) => quote! {
            #[inline]
            fn max_radius(&self) -> #scalar { #end }
        },
        (None, checked) => checked.as_ref().map(Checked::max_radius).unwrap_or_default(),
    };
    let check = match &checked {
        Some(checked) => Some(checked.check(end.is_some())),
        None if geometry.gap.terms.iter().all(fits_every_format) => None,
        None => Some(check_of_constants(names)),
    };
    quote!(#max_radius #check)
}

/// Whether single precision certainly holds a coefficient with all its digits, and its multiples in the kernels.
fn fits_every_format(term: &Term) -> bool {
    let size = term.coefficient.as_constant().map(|value| value.abs().to_f64() as f32);
    // For n from 1/1024 to 1024 the multiples range from 4e-7 C, as C/(2 (n+2)²) is for the highest n, to 2 C.
    size.is_some_and(|size| (1e-30..1e38).contains(&size))
}

/// `check` for constants that not every format holds.
fn check_of_constants(names: &Names) -> TokenStream {
    let (Names { krate, scalar, .. }, check) = (names, names.generated("check_constants"));
    quote! {
        fn check(&self) -> ::core::result::Result<(), #krate::ProfileError> {
            #check::<#scalar>(&Self::TERMS)
        }
    }
}

/// The end of the range, if no value of a field can make the geometry inadmissible before it.
fn known(coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let (geometry, names) = (coefficients.geometry, coefficients.names);
    let (Names { krate, scalar, .. }, constant) = (names, names.constant());
    if !unchecked(geometry).is_empty() {
        return None;
    }
    match (&geometry.range, &geometry.proof) {
        // No proof ends at a range that fields determine.
        (_, Proof::AtRunTime) | (Range::Symbolic(_), Proof::OnRange) => None,
        (Range::Limited(end), proof) => {
            let is_end_of_proof = *proof == Proof::OnRange || geometry.truncation.is_some();
            let single = Rational::from_float((end.to_f64() as f32).into());
            let rounds_up = single.is_some_and(|single| single > *end);
            let function = names.generated("not_above");
            let function = if is_end_of_proof && rounds_up { function } else { constant };
            let end = literal(end);
            Some(quote!(#function(#end)))
        }
        (Range::Unbounded, _) => Some(quote!(<#scalar as #krate::Scalar>::infinity())),
        (Range::Symbolic(end), Proof::AllRadii { .. }) => {
            let (end, not_below_zero) = (coefficients.in_fields(end), names.generated("not_below_zero"));
            Some(quote!(#not_below_zero(#end)))
        }
    }
}

/// The surfaces for which the values of fields decide whether the range ends inside.
fn unchecked(geometry: &Geometry) -> &[Surface] {
    geometry.truncation.as_ref().map_or(&[], |truncation| &truncation.unchecked)
}

/// What depends on the values of the fields.
struct Checked<'a>(&'a Coefficients<'a>);

impl Checked<'_> {
    fn names(&self) -> &Names {
        self.0.names
    }

    /// Zero for a geometry that `check` refuses.
    fn max_radius(&self) -> TokenStream {
        let (preamble, range) = (self.0.preamble(), self.range());
        let (constant, scalar) = (self.names().constant(), &self.names().scalar);
        quote! {
            #[inline]
            fn max_radius(&self) -> #scalar {
                #preamble
                ::core::result::Result::unwrap_or(#range, #constant(0.0f64))
            }
        }
    }

    /// `checked_max_radius`, and `check`, which is the same without the end of the range.
    fn check(&self, has_known_end: bool) -> TokenStream {
        let (preamble, range) = (self.0.preamble(), self.range());
        let (in_format, declared) = (self.in_format(), self.declared());
        let Names { krate, scalar, .. } = self.names();
        let mut checks = self.checks_of_terms();
        let range = match checks.next() {
            Some(first) => quote!(#first #(.and(#checks))*.and_then(|()| #range)),
            None => range,
        };
        let end = has_known_end.then(|| quote!(.map(|_| #krate::GapProfile::<#scalar>::max_radius(self))));
        let (fields, names, values) = self.named(|field| field.used);
        let with_parameters = self.names().generated("with_parameters");
        quote! {
            fn check(&self) -> ::core::result::Result<(), #krate::ProfileError> {
                #krate::GapProfile::<#scalar>::checked_max_radius(self).map(|_| ())
            }
            fn checked_max_radius(&self) -> ::core::result::Result<#scalar, #krate::ProfileError> {
                #in_format
                #declared
                #preamble
                #fields
                #with_parameters(#range, &[#(#names),*], [#(#values),*])#end
            }
        }
    }

    /// The end of the range for the values of the fields, or the error that they cause.
    fn range(&self) -> TokenStream {
        let constant = self.names().constant();
        let requested = match &self.0.geometry.range {
            Range::Unbounded => quote!(::core::option::Option::None),
            Range::Limited(end) => {
                let end = literal(end);
                quote!(::core::option::Option::Some(#constant(#end)))
            }
            Range::Symbolic(end) => {
                let end = self.0.in_fields(end);
                quote!(::core::option::Option::Some(#end))
            }
        };
        let (terms, checked_range) = (self.0.terms(), self.names().generated("checked_range"));
        let range = quote!(#checked_range([#(#terms),*], #requested));
        let surfaces = unchecked(self.0.geometry).iter().map(|surface| {
            let radius = self.0.in_fields(&surface.radius);
            let shape = self.0.in_fields(&surface.shape);
            quote!((#radius, #shape))
        });
        let surfaces: Vec<TokenStream> = surfaces.collect();
        if surfaces.is_empty() {
            return range;
        }
        let inside_surfaces = self.names().generated("inside_surfaces");
        quote!(#inside_surfaces(#range, [#(#surfaces),*]))
    }

    /// Checks of constants that not every format holds, and of products of fields: rounded to zero, they would be no
    /// terms.
    fn checks_of_terms(&self) -> impl Iterator<Item = TokenStream> {
        let terms = self.0.geometry.gap.terms.iter().zip(self.0.terms());
        terms.flat_map(|(term, pair)| {
            if term.coefficient.as_constant().is_some() {
                let check = self.names().generated("check_coefficients");
                return if fits_every_format(term) { Vec::new() } else { vec![quote!(#check([#pair]))] };
            }
            let products = term.coefficient.products_of_fields();
            products.iter().filter_map(|product| self.check_of_product(&pair, product)).collect()
        })
    }

    /// The check of one of the products that the coefficient of a term consists of.
    fn check_of_product(&self, pair: &TokenStream, product: &Coefficient) -> Option<TokenStream> {
        // A field itself is zero only if it is given so.
        if product.as_multiple_of_field().is_some_and(|c| c.abs() >= integer(1)) {
            return None;
        }
        let [factors, divisors] = product.factors_and_divisors()?.map(|parts| {
            let values = parts.iter().map(|part| self.0.expression(part));
            quote!([#(#values),*])
        });
        let (check, value) = (self.names().generated("check_product"), self.0.expression(product));
        Some(quote!(#check(#pair, || #value, #factors, #divisors)))
    }

    /// Refuses values of fields in f64 that the format of the contact does not hold.
    fn in_format(&self) -> Option<TokenStream> {
        let is_double = |field: &&Field| field.used && field.kind == FieldKind::F64;
        let fields = self.0.item.fields.iter().filter(is_double).map(|field| &field.ident);
        let names: Vec<String> = fields.clone().map(unraw).collect();
        let (check, scalar) = (self.names().generated("check_range_of_fields"), &self.names().scalar);
        let checked = quote!(#check::<#scalar, _>(&[#(#names),*], [#(self.#fields),*])?;);
        (!names.is_empty()).then_some(checked)
    }

    /// Refuses values of fields that were declared positive and are not.
    fn declared(&self) -> Option<TokenStream> {
        let (bindings, names, values) = self.named(|field| field.used && field.is_positive);
        let check = self.names().generated("check_positive");
        let checked = quote!({ #bindings #check(&[#(#names),*], [#(#values),*])?; });
        (!names.is_empty()).then_some(checked)
    }

    /// The bindings of some fields, and their names and variables.
    fn named(&self, wanted: fn(&Field) -> bool) -> (TokenStream, Vec<String>, Vec<Ident>) {
        let bindings = self.0.fields(&quote!(self), &wanted);
        let fields = self.0.item.fields.iter().filter(|field| wanted(field)).map(|field| &field.ident);
        (bindings, fields.clone().map(unraw).collect(), fields.map(field_variable).collect())
    }
}
