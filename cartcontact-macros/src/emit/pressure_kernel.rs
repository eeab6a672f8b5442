//! The pressure kernel G(a, r) as code.
//!
//! Even exponents up to 8 have a kernel of their own, without a division; higher and other exponents go through one
//! whose time grows with the exponent less quickly. Both belong to the run-time crate: they carry every operation's
//! rounding error along, which is too long to be written out.

use num_traits::ToPrimitive;
use proc_macro2::TokenStream;
use quote::quote;

use super::Names;
use super::coefficients::Coefficients;
use crate::gap::Gap;
use crate::number::integer;

const HIGHEST_EVEN: u32 = 8;

pub(super) fn method(gap: &Gap, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let scalar = &names.scalar;
    let preamble = coefficients.preamble();
    let body = match half_exponents(gap) {
        Some(halves) => {
            let (kernel, weights) =
                (names.generated("even_pressure_kernel"), weights(&halves, coefficients, names));
            quote!(#kernel(a, r, [#(#weights),*]))
        }
        None => {
            let (kernel, terms) = (names.generated("pressure_kernel"), coefficients.terms());
            quote!(#kernel(a, r, [#(#terms),*]))
        }
    };
    quote! {
        #[inline]
        fn pressure_kernel(&self, a: #scalar, r: #scalar) -> #scalar { #preamble #body }
    }
}

/// n/2 for every term, if all n are even and low.
fn half_exponents(gap: &Gap) -> Option<Vec<u32>> {
    let half = |term: &crate::gap::Term| {
        let half = &term.exponent / integer(2);
        half.is_integer().then(|| half.to_u32()).flatten().filter(|half| 2 * half <= HIGHEST_EVEN)
    };
    gap.terms.iter().map(half).collect()
}

/// C/(n+2)² for n = 2, 4, … up to the highest, zero where there is no term.
fn weights(halves: &[u32], coefficients: &Coefficients<'_>, names: &Names<'_>) -> Vec<TokenStream> {
    let constant = names.constant();
    let weight = |half: u32| match halves.iter().position(|&own| own == half) {
        Some(index) => {
            let shifted = integer(2) * integer(half) + integer(2);
            coefficients.times(index, &(&shifted * &shifted).recip())
        }
        None => quote!(#constant(0.0f64)),
    };
    (1..=halves.last().copied().unwrap_or(1)).map(weight).collect()
}
