//! The pressure kernel G(a, r) as code.
//!
//! Even exponents up to 8 have a kernel of their own, without a division; higher and other exponents go through one
//! whose time grows with the exponent less quickly. Both belong to the run-time crate: they carry every operation's
//! rounding error along, which is too long to be written out.

use num_traits::ToPrimitive;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::operations::Operations;
use super::{Names, local};
use crate::gap::Gap;
use crate::number::integer;

const HIGHEST_EVEN: u32 = 8;

/// The kernel as it is asked for, and as pressures are made of it.
pub(super) fn methods(gap: &Gap, coefficients: &Coefficients<'_>, names: &Names<'_>) -> [TokenStream; 2] {
    let (scalar, preamble) = (&names.scalar, coefficients.preamble());
    let (kernel, arguments) = match half_exponents(gap) {
        Some(halves) => ("even_pressure_kernel", weights(&halves, coefficients, names)),
        None => ("pressure_kernel", coefficients.terms()),
    };
    let (a, r) = (local("a"), local("r"));
    let quick_kernel = format!("quick_{kernel}");
    // Loops over many radii take the quick one with wide vectors, which would end at a call.
    let (precise, quick) = (quote!(#[inline]), quote!(#[inline(always)]));
    [("pressure_kernel", kernel, precise), ("quick_pressure_kernel", quick_kernel.as_str(), quick)].map(
        |(method, function, inline)| {
            let (method, function) = (Ident::new(method, Span::call_site()), names.generated(function));
            quote! {
                #inline
                fn #method(&self, #a: #scalar, #r: #scalar) -> #scalar {
                    #preamble
                    #function(#a, #r, [#(#arguments),*])
                }
            }
        },
    )
}

/// Those of the kernel as it is asked for.
pub(super) fn operations(gap: &Gap) -> Operations {
    let Some(halves) = half_exponents(gap) else {
        return Operations::in_library();
    };
    // a², r² and (a² − r²)²; the second weight and its sum; the powers and sums of every further one.
    match halves.last().copied().unwrap_or(1) {
        1 => Operations::in_double_words(5, 2),
        highest => Operations::in_double_words(6 + 4 * (highest - 2), 5 + 3 * (highest - 2)),
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
