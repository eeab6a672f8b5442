//! What a program may ask the type itself: terms, range and truncation as constants, or the terms as a method if they
//! depend on fields.
//!
//! None of this is part of the trait, so that `dyn GapProfile` stays possible.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::coefficients::Coefficients;
use super::{Names, bounded_generics, local};
use crate::gap::range::Range;
use crate::geometry::Geometry;
use crate::number::literal;
use crate::reading::generics::Generics;
use crate::reading::item::Item;

pub(super) fn block(coefficients: &Coefficients<'_>) -> TokenStream {
    let Coefficients { item, geometry, names, .. } = *coefficients;
    if geometry.gap.is_constant() {
        return implementation(item, &item.generics, &constants(geometry));
    }
    let (pairs, preamble) = (coefficients.terms(), coefficients.preamble());
    of_fields(item, names, &geometry.gap.terms.len(), &quote!(#preamble [#(#pairs),*]))
}

/// The stand-in for a faulty profile: that of a gap that depends on fields if any field is marked as used.
///
/// The number of terms and the value of a number depend on a constant that consists of the errors. The compiler then
/// reports only these errors, and none about a pattern for some terms or an assertion on a radius. There are none if the
/// compiler has reported the struct itself.
pub(super) fn stub(item: &Item, errors: &TokenStream, names: &Names) -> TokenStream {
    let faults = local("FAULTS");
    let value = if errors.is_empty() { quote!(0) } else { quote!({ #errors }) };
    let constant = quote!(const #faults: ::core::primitive::usize = #value;);
    if item.fields.iter().any(|field| field.used) {
        let terms = of_fields(item, names, &faults, &quote!(loop {}));
        return quote!(#constant #terms);
    }
    let number = quote!(::core::primitive::f64);
    let constants = quote! {
        #[doc(hidden)]
        pub const TERMS: [(#number, #number); #faults] = [(0.0, 0.0); #faults];
        #[doc(hidden)]
        pub const MAX_RADIUS: #number = #faults as #number;
        #[doc(hidden)]
        pub const TRUNCATION_ERROR: #number = #faults as #number;
    };
    let constants = implementation(item, &item.generics, &constants);
    quote!(#constant #constants)
}

fn implementation(item: &Item, generics: &Generics, content: &TokenStream) -> TokenStream {
    let (parameters, bounds) = (generics.declared(), generics.bounds());
    let (ident, arguments) = (&item.ident, item.generics.arguments());
    quote! {
        #[allow(unreachable_pub, reason = "a program need not ask for them")]
        impl #parameters #ident #arguments #bounds { #content }
    }
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
            /// How much of the exact gap the expansion of its surfaces neglects, at most, up to `MAX_RADIUS`.
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

/// The method `terms`, over the scalar type of the fields, or over any scalar type if they have none.
fn of_fields(item: &Item, names: &Names, count: &impl ToTokens, body: &TokenStream) -> TokenStream {
    let Names { krate, scalar, .. } = names;
    let (generics, parameter) = if item.generics.has_type(scalar) {
        (bounded_generics(item, names), None)
    } else {
        (item.generics.clone(), Some(quote!(<#scalar: #krate::Scalar>)))
    };
    let terms = quote! {
        /// The terms of the gap Σ C rⁿ as pairs (C, n), in ascending order of their exponents.
        pub fn terms #parameter (&self) -> [(#scalar, #scalar); #count] {
            #body
        }
    };
    implementation(item, &generics, &terms)
}
