//! The pressure kernel G(a, r) as code.
//!
//! Even and low whole exponents have kernels of their own, without a division; so have, where a kernel is one of many
//! that are summed, low multiples of 1/4, with roots. All others take terms one by one, each with a division and with as
//! many steps as its exponent has. All kernels are part of the run-time crate: those that are asked for themselves carry
//! the rounding error of every operation along, which is too long to be written out.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::local;
use super::operations::Operations;
use super::power_sum::{self, WholeExponents, whole_number};
use crate::closed_forms::{ClosedForms, PowerSum};
use crate::gap::{Gap, Term};
use crate::number::{fraction, integer};

/// The highest exponents of kernels that go through all even powers, all whole ones, or all multiples of 1/4, quickly.
const HIGHEST_EVEN: u32 = 64;
const HIGHEST_WHOLE: u32 = 24;
const HIGHEST_QUICK_QUARTER: u32 = 6;
/// The highest even one of a quick kernel in r²: Horner's rule repeats the rounding of a² with each power.
const HIGHEST_QUICK_EVEN: u32 = 6;

/// The kernel for callers, and the quick one that pressures are summed from.
pub(super) fn methods(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> [TokenStream; 2] {
    let names = coefficients.names;
    let (scalar, [a, r]) = (&names.scalar, ["a", "r"].map(local));
    let (kernel, precise) = precise_kernel(forms, coefficients);
    let quick_kernel = quick_kernel(forms, coefficients);
    let method = |name, kernel, inline| {
        let name = Ident::new(name, Span::call_site());
        quote! {
            #inline
            fn #name(&self, #a: #scalar, #r: #scalar) -> #scalar { #kernel }
        }
    };
    let (preamble, quick_preamble) = (precise.preamble(), coefficients.preamble());
    [
        method("pressure_kernel", names.in_double_words(&quote!(#preamble #kernel)), quote!(#[inline])),
        // Loops over many radii use the quick kernel with wide vectors, which would end at a call.
        method("quick_pressure_kernel", quote!(#quick_preamble #quick_kernel), quote!(#[inline(always)])),
    ]
}

/// A call of a kernel with a, r and what else it takes.
fn call(function: &TokenStream, terms: &TokenStream) -> TokenStream {
    let [a, r] = ["a", "r"].map(local);
    quote!(#function(#a, #r, #terms))
}

fn quick_kernel(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let gap = coefficients.gap();
    let names = coefficients.names;
    let has_long_gaps = WholeExponents::of(&forms.gap).is_some_and(|whole| whole.has_long_gaps());
    if let Some(dense) = Dense::of(gap).filter(|_| !has_long_gaps) {
        let kernel = match dense {
            Dense::Even(half) if 2 * half <= HIGHEST_QUICK_EVEN => "quick_even_pressure_kernel",
            Dense::Even(_) => "quick_high_even_pressure_kernel",
            Dense::Whole(_) => "quick_whole_pressure_kernel",
        };
        return call(&names.generated(kernel), &weights(dense.step(), &forms.log_kernel, coefficients));
    }
    let in_root = [2, 4].into_iter().find_map(|index| kernel_in_root(index, forms, coefficients));
    in_root.unwrap_or_else(|| {
        let terms = power_sum::terms(&forms.gap, coefficients);
        call(&names.generated("quick_pressure_kernel"), &terms)
    })
}

/// The kernel that is rounded once, and its coefficients.
fn precise_kernel<'a>(
    forms: &ClosedForms,
    coefficients: &Coefficients<'a>,
) -> (TokenStream, Coefficients<'a>) {
    let gap = coefficients.gap();
    let names = coefficients.names;
    let fused = &names.fused;
    if let Some(dense) = Dense::of(gap) {
        let precise = coefficients.for_rounding_once([&forms.log_kernel]);
        let function = names.generated(match dense {
            Dense::Even(_) => "even_pressure_kernel",
            Dense::Whole(_) => "whole_pressure_kernel",
        });
        let weights = weights(dense.step(), &forms.log_kernel, &precise);
        return (call(&quote!(#function::<_, _, #fused, _>), &weights), precise);
    }
    let precise = coefficients.for_rounding_once([&forms.gap]);
    let (function, terms) = (names.generated("pressure_kernel"), power_sum::terms(&forms.gap, &precise));
    (call(&quote!(#function::<_, _, _, #fused>), &terms), precise)
}

/// The operations of the kernel for callers.
pub(super) fn operations(gap: &Gap) -> Operations {
    // Three products and three sums for every weight; besides, for even powers, a², r² and (a² − r²)², and for whole
    // ones twice a − r and two products with D_0 and the sum. The first weights take fewer.
    let (multiplications, additions) = match Dense::of(gap) {
        Some(Dense::Even(1)) => (5, 2),
        Some(Dense::Even(half)) => (3 * half + 1, 3 * half - 1),
        Some(Dense::Whole(1)) => (4, 3),
        Some(Dense::Whole(highest)) => (3 * highest, 3 * highest),
        None => return Operations::InLibrary,
    };
    Operations::Counted { multiplications, additions }
}

/// A kernel that goes through all powers of a kind, up to the highest.
#[derive(Clone, Copy)]
enum Dense {
    /// All even ones: half the highest exponent.
    Even(u32),
    /// All whole ones: the highest exponent.
    Whole(u32),
}

impl Dense {
    /// None if an exponent is too high or not whole.
    fn of(gap: &Gap) -> Option<Self> {
        let even = highest_multiple(gap, 2, HIGHEST_EVEN).map(Self::Even);
        even.or_else(|| highest_multiple(gap, 1, HIGHEST_WHOLE).map(Self::Whole))
    }

    /// From one exponent to the next.
    fn step(self) -> u32 {
        match self {
            Self::Even(_) => 2,
            Self::Whole(_) => 1,
        }
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
    let dense = |whole: WholeExponents| whole.dense((step + 2, step), &halved, coefficients);
    WholeExponents::of(&halved).map(dense).unwrap_or_default()
}

/// The kernel in the root of the radius with this index, if all powers are whole there, and low.
fn kernel_in_root(index: u32, forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    // The exponents n + 2, multiplied by the index.
    let weights = forms.log_kernel.in_root(index).weighted(|_| fraction(1, 2 * index));
    let whole = WholeExponents::up_to((HIGHEST_QUICK_QUARTER + 2) * index, &weights)?;
    let number = |number: u32| Literal::u32_unsuffixed(number);
    let pairs = whole.exponents.iter().zip(&weights.summands).map(|(power, summand)| {
        let (factor, k) = (coefficients.factor(summand), number(power - 2 * index));
        quote!((#factor, #k))
    });
    let pairs = quote!([#(#pairs),*]);
    let (highest, index) = (number(whole.highest() - 2 * index), number(index));
    let (function, terms) = (
        coefficients.names.generated("quick_pressure_kernel_in_root"),
        power_sum::terms(&forms.gap, coefficients),
    );
    Some(call(&quote!(#function::<_, #index, #highest, _>), &quote!(#pairs, #terms)))
}
