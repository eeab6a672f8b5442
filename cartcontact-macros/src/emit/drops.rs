//! Drops of the load integral, J(a) − J(a − depth), and the slopes δ₀′ that memory integrals take with them.
//!
//! | exponents of J | drop |
//! |---|---|
//! | whole, up to 20, or even, up to 68, unless most are missing | a divided difference of J, times the depth |
//! | multiples of 1/4, up to 13¾ | the same, with the roots of both radii |
//! | all others | a logarithm, and an exponential for each term; with whole ones up to 68 only one by one |

use proc_macro2::TokenStream;
use quote::quote;

use super::coefficients::Coefficients;
use super::power_sum::{self, WholeExponents, terms};
use super::{Names, local};
use crate::closed_forms::{ClosedForms, PowerSum};

/// The highest power of a dense polynomial that is written into loops of others, in r and in r²; the error of its drop
/// is at most half the power times ε. Compilers would leave longer ones out of vectors.
const HIGHEST_WRITTEN_OUT: u32 = 20;
const HIGHEST_EVEN_WRITTEN_OUT: u32 = 24;

/// The highest power of all: of the load integral of a surface up to r⁶⁴.
const HIGHEST_POWER: u32 = 68;

/// With more steps for each term an exponential takes less time.
const MOST_STEPS_PER_TERM: u32 = 24;

/// The highest whole power beside a root: with higher ones compilers would leave all radii out of vectors.
const HIGHEST_DROP_BESIDE_ROOT: u32 = 13;

/// The method for one drop, and the one for slices of slopes and drops.
pub(super) fn methods(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let (Names { scalar, .. }, preamble) = (coefficients.names, coefficients.preamble());
    let [a, depth, places, values] = ["a", "depth", "places", "values"].map(local);
    let whole = of_whole_powers(forms, coefficients);
    let ways = whole.or_else(|| of_quarters(forms, coefficients));
    let Ways { inline, drop, fill } = ways.unwrap_or_else(|| of_any_powers(forms, coefficients));
    let fill = fill.map(|fill| {
        quote! {
            #inline
            fn fill_slopes_and_drops(
                &self,
                #a: #scalar,
                #places: (&[#scalar], &[#scalar]),
                #values: (&mut [#scalar], &mut [#scalar]),
            ) {
                #preamble
                #fill
            }
        }
    });
    quote! {
        #[inline]
        fn load_integral_drop(&self, #a: #scalar, #depth: #scalar) -> #scalar { #preamble #drop }

        #fill
    }
}

/// How drops are computed.
struct Ways {
    drop: TokenStream,
    /// Where something is the same for all radii of a slice.
    fill: Option<TokenStream>,
    inline: TokenStream,
}

/// With the depth as a factor. All that a slice shares are coefficients that depend on fields.
fn of_whole_powers(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<Ways> {
    let names = coefficients.names;
    let sum = &forms.load_integral;
    let [a, s, r, depth, places, values] = ["a", "s", "r", "depth", "places", "values"].map(local);
    let whole = WholeExponents::up_to(HIGHEST_POWER, sum)?;
    // Odd powers might take half the steps in r², too, but with its rounding in each.
    let is_even = whole.stride() == 2 && whole.lowest() % 2 == 0;
    let (function, step) = if is_even { ("even_divided_difference", 2) } else { ("divided_difference", 1) };
    let (function, dense) = (names.generated(function), whole.dense((0, step), sum, coefficients));
    let drop = quote!(let #s = #a - #depth; #depth * #function(#a, #s, #dense));
    if whole.highest() > if is_even { HIGHEST_EVEN_WRITTEN_OUT } else { HIGHEST_WRITTEN_OUT } {
        if whole.highest() / step > MOST_STEPS_PER_TERM * sum.summands.len() as u32 {
            return None;
        }
        let fill = Some(of_long_sums(forms, coefficients, is_even, &dense)?);
        let drop = if is_even { drop } else { of_any_powers(forms, coefficients).drop };
        return Some(Ways { drop, fill, inline: quote!(#[inline]) });
    }
    let fill = (!coefficients.preamble().is_empty()).then(|| {
        let slope = power_sum::quick_value(&forms.approach_slope, &r, coefficients);
        let function = names.generated("fill_by_functions");
        quote! {
            #function(
                self,
                #a,
                #places,
                #values,
                #[inline(always)]
                |#r| { #slope },
                #[inline(always)]
                |#depth| { #drop },
            )
        }
    });
    Some(Ways { drop, fill, inline: quote!(#[inline]) })
}

/// The slopes and drops of whole powers at several radii at a time, from the factors of all powers of J.
fn of_long_sums(
    forms: &ClosedForms,
    coefficients: &Coefficients<'_>,
    is_even: bool,
    integral: &TokenStream,
) -> Option<TokenStream> {
    if WholeExponents::of(&forms.gap)?.has_long_gaps() {
        return None;
    }
    let [a, places, values] = ["a", "places", "values"].map(local);
    let (sum, powers) = (&forms.approach_slope, if is_even { (1, 2) } else { (0, 1) });
    let slope = WholeExponents::of(sum)?.dense(powers, sum, coefficients);
    let function = coefficients.names.generated("fill_long_sums");
    Some(quote!(#function::<_, #is_even, _, _>(#a, #places, #values, (#slope, #integral))))
}

/// From the roots of the radii.
fn of_quarters(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<Ways> {
    let sum = &forms.load_integral;
    let [a, r, depth, places, values] = ["a", "r", "depth", "places", "values"].map(local);
    let dense = |part: &PowerSum| {
        if part.summands.is_empty() {
            return Some(quote!([]));
        }
        let whole = WholeExponents::up_to(HIGHEST_DROP_BESIDE_ROOT, part)?;
        Some(whole.dense((0, 1), part, coefficients))
    };
    let parts = sum.in_quarters()?.iter().map(dense).collect::<Option<Vec<_>>>()?;
    let parts = quote!((#(#parts),*));
    let [one, many] = ["drop_by_roots", "fill_by_roots"].map(|name| coefficients.names.generated(name));
    let terms = terms(sum, coefficients);
    let slope = power_sum::quick_value(&forms.approach_slope, &r, coefficients);
    Some(Ways {
        drop: quote!(#one(#a, #depth, #parts, #terms)),
        fill: Some(quote!(#many(self, #a, #places, #values, |#r| { #slope }, #parts))),
        // Wide vectors would end at a call.
        inline: quote!(#[inline(always)]),
    })
}

fn of_any_powers(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Ways {
    let [a, depth, places, values] = ["a", "depth", "places", "values"].map(local);
    let [one, many] =
        ["power_sum_drop", "fill_slopes_and_drops"].map(|name| coefficients.names.generated(name));
    let terms = terms(&forms.load_integral, coefficients);
    Ways {
        drop: quote!(#one(#a, #depth, #terms)),
        fill: Some(quote!(#many(self, #a, #places, #values, #terms))),
        inline: quote!(#[inline]),
    }
}
