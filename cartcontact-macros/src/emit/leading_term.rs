//! The contact radius from the leading term of J, for coefficients that are symbols and that no table covers.

use num_traits::One;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::coefficients::Coefficients;
use super::power_sum::{Whole, nested, paired, terms};
use super::{Names, local, steepness};
use crate::closed_forms::{ClosedForms, PowerSum, Scaled};
use crate::number::{Rational, integer};

/// Beyond this power, 2^p leaves single precision in the products of a step.
const HIGHEST_POWER: u32 = 80;

/// The radius from the leading term, if that term leads to it.
pub(super) fn radius(forms: &ClosedForms, coefficients: &Coefficients<'_>, names: &Names) -> TokenStream {
    let Names { load_integral, limit, .. } = names;
    match whole_powers(&forms.stepped, coefficients, names) {
        Some(powers) => quote!((#powers).radius(#load_integral, #limit)),
        None => radius_of_real_powers(forms, coefficients, names),
    }
}

/// The same for powers of any kind; needs no item beside it.
pub(super) fn radius_of_real_powers(
    forms: &ClosedForms,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> TokenStream {
    let (Names { load_integral, limit, .. }, [a, scale]) = (names, ["a", "scale"].map(local));
    let radius = names.generated("radius_of_real_powers");
    let quick = names.generated("quick_power_sum_steepness");
    let precise = names.generated("scaled_power_sum_steepness");
    let terms = terms(&forms.load_integral, coefficients, names);
    quote! {
        #radius(
            #load_integral,
            #limit,
            ::core::iter::IntoIterator::into_iter(#terms),
            |#a, #scale| #quick(#a, #scale, #terms),
            |#a, #scale| #precise(#a, #scale, #terms),
        )
    }
}

/// The radii of a slice from the leading term, or else by `radius_within`; for whole powers only, as other powers do
/// not vectorise.
pub(super) fn radii(
    forms: &ClosedForms,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> Option<TokenStream> {
    let powers = whole_powers(&forms.stepped, coefficients, names)?;
    let (general, radii_of_whole_powers) =
        (names.by_radius_within(), names.generated("radii_of_whole_powers"));
    let (Names { load_integral, load_integrals, limit, radii, .. }, more) = (names, local("more"));
    Some(quote! {
        #radii_of_whole_powers(
            (#load_integrals, #radii),
            #limit,
            // Without the attribute, wide vectors would end at the call.
            #[inline(always)]
            |#load_integral, #more| (#powers).solve(#load_integral, #more),
            #general,
        )
    })
}

/// J as `WholePowers`, if all its powers are whole.
fn whole_powers(scaled: &Scaled, coefficients: &Coefficients<'_>, names: &Names) -> Option<TokenStream> {
    let Scaled { load_integral: sum, per_unit } = scaled;
    let whole = whole(sum)?;
    let per_unit = names.number(per_unit);
    let (all, steepness) = (names.generated("WholePowers"), steepness::name());
    let values = sum.summands.iter().map(|summand| coefficients.factor(summand));
    let powers = whole.exponents.iter().map(|&power| Literal::u32_unsuffixed(power));
    Some(quote! {
        #all {
            coefficients: [#(#values),*],
            powers: [#(#powers),*],
            steepness: #steepness,
            per_unit: #per_unit,
        }
    })
}

/// Whether the steps from the leading term have whole powers.
pub(super) fn has_whole_powers(forms: &ClosedForms) -> bool {
    whole(&forms.stepped.load_integral).is_some()
}

fn whole(sum: &PowerSum) -> Option<Whole> {
    Whole::of(sum).filter(|whole| whole.highest() <= HIGHEST_POWER)
}

/// The function that computes J and its derivatives, with any coefficients.
pub(super) fn items(sum: &PowerSum, names: &Names) -> Option<TokenStream> {
    let whole = whole(sum)?;
    let (count, a) = (whole.exponents.len(), local("a"));
    let variables: Vec<Ident> = (0..count).map(|index| local(&format!("j{index}"))).collect();
    let (_, variable) = whole.variable(&a);
    let weighted = |weight: fn(u32) -> u32| {
        let factors = whole.exponents.iter().zip(&variables).map(|(&p, j)| product(weight(p), j, names));
        factors.collect::<Vec<_>>()
    };
    let sums = [
        paired(&whole, &variable, weighted(|_| 1), names),
        nested((&whole, false), &variable, weighted(|p| p), names),
        nested((&whole, false), &variable, weighted(|p| p * (p - 1) / 2), names),
    ];
    let body = steepness::value((&whole, false), &a, &sums, &Rational::one(), names);
    Some(steepness::function(&a, (quote!([#(#variables),*]), count), &body, names))
}

fn product(weight: u32, coefficient: &Ident, names: &Names) -> TokenStream {
    if weight == 1 {
        return coefficient.into_token_stream();
    }
    let weight = names.number(&integer(weight));
    quote!(#weight * #coefficient)
}
