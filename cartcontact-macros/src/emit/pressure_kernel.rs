//! The pressure kernel G(a, r) as code.
//!
//! Low even exponents have kernels of their own, without a division; so have low whole exponents, and low multiples of
//! 1/2, where a kernel is one of many that are summed. All others go through one whose time grows more slowly with the exponent. All kernels are
//! part of the run-time crate: those that are asked for themselves carry the rounding error of every operation along,
//! which is too long to be written out.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::operations::Operations;
use super::power_sum::{self, Whole, whole_number};
use super::{Names, local};
use crate::closed_forms::{ClosedForms, PowerSum};
use crate::gap::{Gap, Term};
use crate::number::{fraction, integer};

/// The highest even exponent of a kernel that is rounded once, and of a quick kernel; the highest of a quick kernel for
/// all whole exponents, and for multiples of 1/2. For a single higher power the general kernel rounds less.
const HIGHEST_EVEN: u32 = 8;
const HIGHEST_QUICK_EVEN: u32 = 24;
const HIGHEST_QUICK_WHOLE: u32 = 12;
const HIGHEST_QUICK_HALF: u32 = 6;
const HIGHEST_ALONE: u32 = 8;

/// The kernel for callers, and the quick one that pressures are summed from.
pub(super) fn methods(
    gap: &Gap,
    forms: &ClosedForms,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> [TokenStream; 2] {
    let weights = |step| weights(step, &forms.log_kernel, coefficients);
    let terms = || power_sum::terms(&forms.gap, coefficients, names);
    let (kernel, precise) = precise_kernel(gap, forms, coefficients, names);
    let limit = |highest: u32| if gap.terms.len() == 1 { highest.min(HIGHEST_ALONE) } else { highest };
    let quick_kernel = if highest_multiple(gap, 2, limit(HIGHEST_QUICK_EVEN)).is_some() {
        ("quick_even_pressure_kernel", weights(2))
    } else if highest_multiple(gap, 1, limit(HIGHEST_QUICK_WHOLE)).is_some() {
        ("quick_whole_pressure_kernel", weights(1))
    } else if let Some(weights) = half_weights(forms, coefficients) {
        let terms = terms();
        ("quick_half_pressure_kernel", quote!(#weights, #terms))
    } else {
        ("quick_pressure_kernel", terms())
    };
    let scalar = &names.scalar;
    let (a, r) = (local("a"), local("r"));
    let method = |method, (function, terms), preamble: TokenStream, inline| {
        let (method, function) = (Ident::new(method, Span::call_site()), names.generated(function));
        quote! {
            #inline
            fn #method(&self, #a: #scalar, #r: #scalar) -> #scalar {
                #preamble
                #function(#a, #r, #terms)
            }
        }
    };
    [
        method("pressure_kernel", kernel, precise.preamble(), quote!(#[inline])),
        // Loops over many radii use the quick kernel with wide vectors, which would end at a call.
        method("quick_pressure_kernel", quick_kernel, coefficients.preamble(), quote!(#[inline(always)])),
    ]
}

/// The function and the terms of the kernel that is rounded once, and its coefficients.
fn precise_kernel<'a>(
    gap: &Gap,
    forms: &ClosedForms,
    coefficients: &Coefficients<'a>,
    names: &Names,
) -> ((&'static str, TokenStream), Coefficients<'a>) {
    if highest_multiple(gap, 2, HIGHEST_EVEN).is_some() {
        let precise = coefficients.for_rounding_once(&forms.log_kernel);
        return (("even_pressure_kernel", weights(2, &forms.log_kernel, &precise)), precise);
    }
    let precise = coefficients.for_rounding_once(&forms.gap);
    (("pressure_kernel", power_sum::terms(&forms.gap, &precise, names)), precise)
}

/// The operations of the kernel for callers.
pub(super) fn operations(gap: &Gap) -> Operations {
    let Some(highest) = highest_multiple(gap, 2, HIGHEST_EVEN) else {
        return Operations::in_library();
    };
    // a², r² and (a² − r²)²; two products for the second weight, and three sums; three of each for every further one.
    match highest {
        1 => Operations::in_double_words(5, 2),
        _ => Operations::in_double_words(7 + 3 * (highest - 2), 5 + 3 * (highest - 2)),
    }
}

/// The largest n/`step`, if all quotients are whole and no n is above `highest`.
fn highest_multiple(gap: &Gap, step: u32, highest: u32) -> Option<u32> {
    let multiple =
        |term: &Term| whole_number(&(&term.exponent / integer(step))).filter(|index| step * index <= highest);
    gap.terms.iter().map(multiple).try_fold(1, |largest, index| Some(largest.max(index?)))
}

/// C step/(2 (n+2)²) for all multiples n of `step` up to the highest, zero where there is no term.
fn weights(step: u32, log_kernel: &PowerSum, coefficients: &Coefficients<'_>) -> TokenStream {
    let halved = log_kernel.weighted(|_| fraction(step, 2));
    let dense = |whole: Whole| whole.dense((step + 2, step), &halved, coefficients);
    Whole::of(&halved).map(dense).unwrap_or_default()
}

/// C/(4 (n+2)²) for all multiples n of 1/2 up to the highest, zero where there is no term.
fn half_weights(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    // The power n + 2 of the radius is 2 n + 4 in its root.
    let quartered = forms.log_kernel.in_root(2).weighted(|_| fraction(1, 4));
    let whole = Whole::of(&quartered).filter(|whole| whole.highest() <= 2 * HIGHEST_QUICK_HALF + 4)?;
    Some(whole.dense((5, 1), &quartered, coefficients))
}
