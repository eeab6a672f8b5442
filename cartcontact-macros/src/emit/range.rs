//! `max_radius`, and `check` where the values of fields decide.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::ext::IdentExt;

use super::Names;
use super::coefficients::Coefficients;
use crate::admissible::Proof;
use crate::geometry::{Geometry, Range};
use crate::item::Item;
use crate::number::literal;

pub(super) fn methods(
    item: &Item,
    geometry: &Geometry,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let (Names { krate, scalar }, constant) = (names, names.constant());
    let known = match (&geometry.range, &geometry.proof) {
        (Range::Symbolic(_), _) | (_, Proof::AtRunTime) => None,
        (Range::Limited(end), _) => Some(literal(end)).map(|end| quote!(#constant(#end))),
        (Range::Unbounded, _) => Some(quote!(<#scalar as #krate::Scalar>::infinity())),
    };
    let is_constant = geometry.gap.is_constant() && !matches!(geometry.range, Range::Symbolic(_));
    let checked = (!is_constant).then(|| Checked::new(item, geometry, coefficients, names));
    let max_radius = match (known, &checked) {
        (Some(end), _) => quote! {
            #[inline]
            fn max_radius(&self) -> #scalar { #end }
        },
        (None, checked) => checked.as_ref().map(Checked::max_radius).unwrap_or_default(),
    };
    let check = checked.as_ref().map(Checked::check);
    quote!(#max_radius #check)
}

/// The end of the range as the values of the fields have it, or the error that they cause.
struct Checked<'a> {
    preamble: TokenStream,
    range: TokenStream,
    /// The error, its parameters named.
    named: TokenStream,
    names: &'a Names<'a>,
}

impl<'a> Checked<'a> {
    fn new(item: &Item, geometry: &Geometry, coefficients: &Coefficients<'_>, names: &'a Names<'a>) -> Self {
        let constant = names.constant();
        let requested = match &geometry.range {
            Range::Unbounded => quote!(::core::option::Option::None),
            Range::Limited(end) => {
                let end = literal(end);
                quote!(::core::option::Option::Some(#constant(#end)))
            }
            Range::Symbolic(end) => {
                let fields = coefficients.fields(&quote!(self), &end.fields());
                let end = coefficients.expression(end);
                quote!(::core::option::Option::Some({ #fields #end }))
            }
        };
        let (terms, checked_range) = (coefficients.terms(), names.generated("checked_range"));
        let range = quote!(#checked_range(::core::iter::IntoIterator::into_iter([#(#terms),*]), #requested));
        let used = || item.fields.iter().filter(|field| field.used).map(|field| &field.ident);
        let (bindings, with) =
            (coefficients.fields(&quote!(self), &used().collect()), names.generated("with_parameters"));
        let texts = used().map(|ident| ident.unraw().to_string().into_token_stream());
        let values = used();
        let named = quote!({ #bindings #with(error, &[#(#texts),*], [#(#values),*]) });
        Checked { preamble: coefficients.preamble(), range, named, names }
    }

    /// A geometry that `check` refuses has no admissible radius.
    fn max_radius(&self) -> TokenStream {
        let (Checked { preamble, range, .. }, constant) = (self, self.names.constant());
        let scalar = &self.names.scalar;
        quote! {
            fn max_radius(&self) -> #scalar {
                #preamble
                match #range {
                    ::core::result::Result::Ok(end) => end,
                    ::core::result::Result::Err(_) => #constant(0.0f64),
                }
            }
        }
    }

    fn check(&self) -> TokenStream {
        let Checked { preamble, range, named, names: Names { krate, .. } } = self;
        quote! {
            fn check(&self) -> ::core::result::Result<(), #krate::ProfileError> {
                #preamble
                match #range {
                    ::core::result::Result::Ok(_) => ::core::result::Result::Ok(()),
                    ::core::result::Result::Err(error) => ::core::result::Result::Err(#named),
                }
            }
        }
    }
}
