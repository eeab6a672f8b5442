//! What a program may ask of the type itself: terms, range and truncation as constants, or the terms as a method where
//! they depend on fields.
//!
//! None of it is part of the trait, so that `dyn GapProfile` stays possible.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::coefficients::Coefficients;
use super::{Names, arguments, bounded_generics};
use crate::geometry::{Geometry, Range};
use crate::number::literal;
use crate::reading::item::{FieldKind, Item};

pub(super) fn block(
    item: &Item,
    geometry: &Geometry,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let ident = &item.ident;
    let quiet = quiet();
    let is_own = |parameter: &syn::TypeParam| parameter.ident == names.scalar;
    let declares_scalar = item.generics.type_params().any(is_own);
    let (generics, content) = match geometry.gap.is_constant() {
        true => (item.generics.clone(), constants(geometry)),
        false if declares_scalar => (bounded_generics(item, names), terms(coefficients, names, None)),
        false => (item.generics.clone(), terms(coefficients, names, Some(own_parameter(names)))),
    };
    let (impl_generics, _, where_clause) = generics.split_for_impl();
    let type_generics = arguments(&item.generics);
    quote! {
        #quiet
        impl #impl_generics #ident #type_generics #where_clause { #content }
    }
}

/// What stands in for them where the profile is faulty, so that whoever asks for them gets no further errors.
pub(super) fn stub(item: &Item, names: &Names<'_>) -> TokenStream {
    let (ident, number, quiet) = (&item.ident, quote!(::core::primitive::f64), quiet());
    let (impl_generics, _, where_clause) = item.generics.split_for_impl();
    let type_generics = arguments(&item.generics);
    let terms = item.fields.first().map(|field| {
        let (parameter, scalar) = match &field.kind {
            FieldKind::TypeParameter(own) => (None, own),
            _ => (Some(own_parameter(names)), &names.scalar),
        };
        quote! {
            #[doc(hidden)]
            pub fn terms #parameter (&self) -> [(#scalar, #scalar); 0] { [] }
        }
    });
    quote! {
        #quiet
        impl #impl_generics #ident #type_generics #where_clause {
            #[doc(hidden)]
            pub const TERMS: [(#number, #number); 0] = [];
            #[doc(hidden)]
            pub const MAX_RADIUS: #number = 0.0;
            #[doc(hidden)]
            pub const TRUNCATION_ERROR: #number = 0.0;
            #terms
        }
    }
}

fn quiet() -> TokenStream {
    quote!(#[allow(dead_code, unreachable_pub, reason = "a program need not ask for them")])
}

fn constants(geometry: &Geometry) -> TokenStream {
    let number = quote!(::core::primitive::f64);
    let terms = &geometry.gap.terms;
    let count = terms.len();
    let pairs = terms.iter().filter_map(|term| {
        let (coefficient, exponent) = (literal(&term.coefficient.as_constant()?), literal(&term.exponent));
        Some(quote!((#coefficient, #exponent)))
    });
    let max_radius = match &geometry.range {
        Range::Limited(end) => Some(literal(end).into_token_stream()),
        Range::Unbounded => Some(quote!(#number::INFINITY)),
        Range::Symbolic(_) => None,
    };
    let max_radius = max_radius.map(|end| {
        quote! {
            /// The largest contact radius that the geometry is proved for, in mm; infinity if there is no limit.
            pub const MAX_RADIUS: #number = #end;
        }
    });
    let error = geometry.truncation.as_ref().and_then(|truncation| truncation.error.as_ref());
    let error = error.map(literal).map(|error| {
        quote! {
            /// How much of the gap the expansion of its surfaces changes, at most, up to `MAX_RADIUS`.
            pub const TRUNCATION_ERROR: #number = #error;
        }
    });
    quote! {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub const TERMS: [(#number, #number); #count] = [#(#pairs),*];
        #max_radius
        #error
    }
}

fn own_parameter(names: &Names<'_>) -> TokenStream {
    let Names { krate, scalar } = names;
    quote!(<#scalar: #krate::Scalar>)
}

fn terms(coefficients: &Coefficients<'_>, names: &Names<'_>, parameter: Option<TokenStream>) -> TokenStream {
    let (scalar, preamble, pairs) = (&names.scalar, coefficients.preamble(), coefficients.terms());
    let count = pairs.len();
    quote! {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms #parameter (&self) -> [(#scalar, #scalar); #count] {
            #preamble
            [#(#pairs),*]
        }
    }
}
