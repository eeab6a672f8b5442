//! The contact radius from the load integral.

use num_traits::Zero;
use proc_macro2::TokenStream;
use quote::quote;

use super::coefficients::Coefficients;
use super::power_sum::{self, WholeExponents, terms};
use super::{Names, curves, leading_term, local, roots, seeds};
use crate::closed_forms::ClosedForms;
use crate::gap::Gap;
use crate::gap::range::Range;
use crate::geometry::Geometry;
use crate::number::{Rational, integer, literal};
use crate::proof::Proof;
use crate::start::{Start, has_leading_term_beside_table, may_have_leading_term};

/// The highest power of a dense polynomial; beyond it, powers are formed term by term. Two sums of eighty constants are
/// 1300 bytes.
const HIGHEST_DENSE_POWER: u32 = 80;

/// The methods that invert J.
pub(super) fn methods(
    forms: &ClosedForms,
    start: Option<&Start>,
    coefficients: &Coefficients<'_>,
) -> TokenStream {
    let (names, gap, preamble) = (coefficients.names, coefficients.gap(), coefficients.preamble());
    let Names { krate, scalar, load_integral, limit, .. } = names;
    let general = outside_table(forms, start, coefficients);
    let (found, radii) = start.map(|start| from_start(forms, start, coefficients)).unzip();
    let unlimited = found.as_ref().filter(|_| is_admissible_in_table(coefficients.geometry, start));
    let unlimited = unlimited.map(|found| unlimited_radius(found, forms, coefficients));
    let radius = match found {
        Some(found) => found_or_general(&found, &general, names),
        None => general,
    };
    let radii_within = radii.flatten().map(|radii| radii_within(&radii, coefficients));
    let quick_radii = quick_radii(gap, forms, start, names);
    let inline = inlining(gap, forms, start);
    quote! {
        #inline
        fn radius_within(
            &self,
            #load_integral: #scalar,
            #limit: #scalar,
        ) -> ::core::result::Result<#scalar, #krate::RadiusError> {
            #preamble
            #radius
        }

        #unlimited

        #radii_within

        #quick_radii
    }
}

/// The method that tells whether the radii of a slice are found in vector code, if they may be.
fn quick_radii(gap: &Gap, forms: &ClosedForms, start: Option<&Start>, names: &Names) -> Option<TokenStream> {
    let Names { krate, scalar, .. } = names;
    let of_positive_terms = quote!(#krate::GapProfile::<#scalar>::has_only_positive_terms(self));
    let truth = match start? {
        Start::Curves(_) | Start::Roots(_) => quote!(true),
        Start::Seeds(_) if WholeExponents::of(&forms.stepped.load_integral).is_none() => return None,
        // Values of other signs than those of the table are rare.
        Start::Seeds(seeds) if gap.is_constant() || seeds.factors.iter().any(|&factor| factor < 0.0) => {
            quote!(true)
        }
        Start::LeadingTerm if !leading_term::has_whole_powers(forms) => return None,
        Start::Seeds(_) | Start::LeadingTerm => of_positive_terms,
    };
    Some(quote! {
        #[inline]
        fn has_quick_radii(&self) -> ::core::primitive::bool { #truth }
    })
}

/// The radius from its start, and the radii of a slice if they are found in a way of their own.
fn from_start(
    forms: &ClosedForms,
    start: &Start,
    coefficients: &Coefficients<'_>,
) -> (TokenStream, Option<TokenStream>) {
    let is_beside = has_leading_term_beside_table(coefficients.gap());
    let solve = || {
        let beside = is_beside.then(|| leading_term::solve(forms, coefficients)).flatten();
        beside.unwrap_or_else(|| coefficients.names.generated("nowhere"))
    };
    let [radius, radii] = match start {
        Start::Curves(_) => curves::radius_and_radii(&solve(), coefficients.names),
        Start::Roots(table) => roots::radius_and_radii(table, &forms.load_integral, coefficients),
        Start::Seeds(found) => seeds::radius_and_radii(found, &forms.stepped, &solve(), coefficients),
        Start::LeadingTerm => {
            let radii = leading_term::radii(forms, coefficients);
            return (leading_term::radius(forms, coefficients), radii);
        }
    };
    (radius, Some(radii))
}

/// How a radius is compiled into its callers. A radius from a table, or from a leading term with whole powers, is just
/// long enough for compilers to hesitate: left to them, it is a call with its result in memory in one program and not
/// in the next, which makes up to half of its time.
fn inlining(gap: &Gap, forms: &ClosedForms, start: Option<&Start>) -> TokenStream {
    match start {
        Some(Start::Curves(_) | Start::Roots(_)) => quote!(#[inline(always)]),
        Some(Start::LeadingTerm) if leading_term::has_whole_powers(forms) => quote!(#[inline(always)]),
        Some(Start::Seeds(_)) if !gap.is_constant() => quote!(#[inline(always)]),
        _ => quote!(#[inline]),
    }
}

/// Whether the values of fields end the range, but not where the table has rows: in units of its own, all radii of the
/// table are admissible.
fn is_admissible_in_table(geometry: &Geometry, start: Option<&Start>) -> bool {
    matches!(geometry.range, Range::Unbounded)
        && matches!(geometry.proof, Proof::AtRunTime)
        && geometry.truncation.is_none()
        && matches!(start, Some(Start::Seeds(_) | Start::Roots(_)))
}

/// The radius without a requested limit, from the table before the end of the range is searched for.
fn unlimited_radius(
    found: &TokenStream,
    forms: &ClosedForms,
    coefficients: &Coefficients<'_>,
) -> TokenStream {
    let names = coefficients.names;
    let (Names { krate, scalar, load_integral, limit, .. }, preamble) = (names, coefficients.preamble());
    let within = quote!(#krate::GapProfile::radius_within(self, #load_integral, #limit));
    let (anew, within) = if has_leading_term_beside_table(coefficients.gap()) {
        // Before the table is tried again. The coefficients are computed anew: what the cold call sees is kept in memory,
        // and all that the table needs would be computed again for each of many radii.
        let found = leading_term::radius(forms, coefficients);
        (Some(&preamble), found_or_general(&found, &within, names))
    } else {
        (None, within)
    };
    let general = quote! {
        #anew
        let #limit = #krate::GapProfile::max_radius(self);
        #within
    };
    let radius = found_or_general(found, &general, names);
    quote! {
        #[inline(always)]
        fn radius(&self, #load_integral: #scalar) -> ::core::result::Result<#scalar, #krate::RadiusError> {
            #preamble
            let #limit = <#scalar as #krate::Scalar>::infinity();
            #radius
        }
    }
}

/// The radius where the start does not lead to it: outside the rows of a table, from the leading term if there may be
/// one.
fn outside_table(forms: &ClosedForms, start: Option<&Start>, coefficients: &Coefficients<'_>) -> TokenStream {
    let general = general(forms, coefficients);
    if !(matches!(start, Some(Start::Curves(_) | Start::Seeds(_)))
        && may_have_leading_term(coefficients.gap()))
    {
        return general;
    }
    let found = if has_leading_term_beside_table(coefficients.gap()) {
        leading_term::radius(forms, coefficients)
    } else {
        leading_term::radius_of_real_powers(forms, coefficients)
    };
    found_or_general(&found, &general, coefficients.names)
}

/// The radius of any load integral, whatever the geometry.
fn general(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    match coefficients.gap().terms.as_slice() {
        [only] if (&only.exponent * integer(4)).is_integer() => {
            let Names { load_integral, limit, .. } = names;
            let (invert, terms) = (names.generated("invert_one_term"), coefficients.terms());
            quote!(#invert(#load_integral, #(#terms)*, #limit))
        }
        _ => newton(forms, coefficients),
    }
}

/// The radius that may have been found, otherwise the one by `general`, out of line.
fn found_or_general(found: &TokenStream, general: &TokenStream, names: &Names) -> TokenStream {
    let found_or = names.generated("found_or");
    quote!(#found_or(#found, move || { #general }))
}

/// The method for slices; `radii` is its result.
fn radii_within(radii: &TokenStream, coefficients: &Coefficients<'_>) -> TokenStream {
    let Names { krate, scalar, load_integrals, limit, radii: slice, .. } = coefficients.names;
    let preamble = coefficients.preamble();
    quote! {
        fn radii_within(
            &self,
            #load_integrals: &[#scalar],
            #limit: #scalar,
            #slice: &mut [#scalar],
        ) -> ::core::result::Result<(), #krate::RadiusError> {
            #preamble
            #radii
        }
    }
}

fn newton(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let (invert, zero) = (names.generated("invert"), names.number(&Rational::zero()));
    let evaluate = value_and_log_slope(forms, coefficients);
    let terms = coefficients.terms();
    let has_negative = match coefficients.of_uncertain_sign() {
        None => quote!(true),
        Some(none) if none.is_empty() => quote!(false),
        Some(uncertain) => quote!(#(#uncertain < #zero)||*),
    };
    let (Names { load_integral, limit, .. }, a) = (names, local("a"));
    // Not the method of that name: its receiver would be one more argument of the general solution.
    let (rounded_once, _) = power_sum::value(&forms.load_integral, &a, coefficients);
    let rounded_once = names.in_double_words(&rounded_once);
    quote! {
        #invert(
            #load_integral,
            #limit,
            [#(#terms),*],
            #has_negative,
            |#a| { #evaluate },
            |#a| #rounded_once,
        )
    }
}

/// J(a) and a J′(a), in the cheapest form: Newton's method divides their error by the degree of J.
fn value_and_log_slope(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let sum = &forms.load_integral;
    let [a, x, value, slope, log_slope] = ["a", "x", "value", "slope", "log_slope"].map(local);
    let Some(whole) = WholeExponents::up_to(HIGHEST_DENSE_POWER, sum) else {
        let (function, terms) = (names.generated("power_sum_and_log_slope"), terms(sum, coefficients));
        return quote!(#function(#a, #terms));
    };
    let constant = names.constant();
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let (function, dense) =
        (names.generated("value_and_slope"), whole.dense((lowest, stride), sum, coefficients));
    // J = x^k a^odd Q(x) with x = a² or a, hence a J′ = x^k a^odd (lowest Q + stride x Q′).
    let argument = if stride == 2 { quote!(#a * #a) } else { quote!(#a) };
    let scale = whole.lowest_power(&x, &a);
    let (lowest, stride) = (literal(&integer(lowest)), literal(&integer(stride)));
    quote! {
        let #x = #argument;
        let (#value, #slope) = #function(#x, #dense);
        let #log_slope = #constant(#lowest) * #value + #constant(#stride) * #x * #slope;
        (#value #scale, #log_slope #scale)
    }
}
