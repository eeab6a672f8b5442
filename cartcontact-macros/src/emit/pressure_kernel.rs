//! The pressure kernel G(a, r) as code.
//!
//! Low even exponents and, where a kernel is one of many that are summed, low whole exponents have kernels of their own,
//! without a division; all others go through one whose time grows with the exponent less quickly. All belong to the
//! run-time crate: those that are asked for themselves carry every operation's rounding error along, which is too long
//! to be written out.

use num_traits::ToPrimitive;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::operations::Operations;
use super::{Names, local};
use crate::gap::Gap;
use crate::number::{fraction, integer};

/// The highest even exponent of a kernel that is rounded once, and of a quick one; the highest of a quick one for all
/// whole exponents.
const HIGHEST_EVEN: u32 = 8;
const HIGHEST_QUICK_EVEN: u32 = 24;
const HIGHEST_QUICK_WHOLE: u32 = 12;

/// The kernel as it is asked for, and as pressures are made of it.
pub(super) fn methods(gap: &Gap, coefficients: &Coefficients<'_>, names: &Names<'_>) -> [TokenStream; 2] {
    let weights = |indices: &[u32], step| weights(indices, step, coefficients, names);
    let (kernel, arguments) = match multiples(gap, 2, HIGHEST_EVEN) {
        Some(halves) => ("even_pressure_kernel", weights(&halves, 2)),
        None => ("pressure_kernel", coefficients.powers()),
    };
    let (quick_kernel, quick_arguments) = if let Some(halves) = multiples(gap, 2, HIGHEST_QUICK_EVEN) {
        ("quick_even_pressure_kernel", weights(&halves, 2))
    } else if let Some(powers) = multiples(gap, 1, HIGHEST_QUICK_WHOLE) {
        ("quick_whole_pressure_kernel", weights(&powers, 1))
    } else {
        ("quick_pressure_kernel", coefficients.powers())
    };
    let (scalar, preamble) = (&names.scalar, coefficients.preamble());
    let (a, r) = (local("a"), local("r"));
    let method = |method, function, arguments: Vec<TokenStream>, inline| {
        let (method, function) = (Ident::new(method, Span::call_site()), names.generated(function));
        quote! {
            #inline
            fn #method(&self, #a: #scalar, #r: #scalar) -> #scalar {
                #preamble
                #function(#a, #r, [#(#arguments),*])
            }
        }
    };
    [
        method("pressure_kernel", kernel, arguments, quote!(#[inline])),
        // Loops over many radii take the quick one with wide vectors, which would end at a call.
        method("quick_pressure_kernel", quick_kernel, quick_arguments, quote!(#[inline(always)])),
    ]
}

/// Those of the kernel as it is asked for.
pub(super) fn operations(gap: &Gap) -> Operations {
    let Some(halves) = multiples(gap, 2, HIGHEST_EVEN) else {
        return Operations::in_library();
    };
    // a², r² and (a² − r²)²; two products for the second weight, and three sums; three of each for every further one.
    match halves.last().copied().unwrap_or(1) {
        1 => Operations::in_double_words(5, 2),
        highest => Operations::in_double_words(7 + 3 * (highest - 2), 5 + 3 * (highest - 2)),
    }
}

/// n/`step` for every term, if that is whole and no n is above `highest`.
fn multiples(gap: &Gap, step: u32, highest: u32) -> Option<Vec<u32>> {
    let multiple = |term: &crate::gap::Term| {
        let index = &term.exponent / integer(step);
        index.is_integer().then(|| index.to_u32()).flatten().filter(|index| step * index <= highest)
    };
    gap.terms.iter().map(multiple).collect()
}

/// C step/(2 (n+2)²) for all multiples n of `step` up to the highest index, zero where there is no term.
fn weights(
    indices: &[u32],
    step: u32,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> Vec<TokenStream> {
    let constant = names.constant();
    let weight = |index: u32| match indices.iter().position(|&own| own == index) {
        Some(term) => {
            let shifted = integer(step) * integer(index) + integer(2);
            coefficients.times(term, &(fraction(step, 2) / (&shifted * &shifted)))
        }
        None => quote!(#constant(0.0f64)),
    };
    (1..=indices.last().copied().unwrap_or(1)).map(weight).collect()
}
