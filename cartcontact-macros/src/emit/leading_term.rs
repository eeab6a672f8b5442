//! The contact radius from the leading term of J, where no table leads to it.

use num_traits::One;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::coefficients::Coefficients;
use super::power_sum::{WholeExponents, nested, paired, power, terms};
use super::{Names, local, steepness};
use crate::closed_forms::{ClosedForms, Stepped};
use crate::number::{Rational, integer};

/// Beyond this power, 2^p leaves single precision in the products of a step.
const HIGHEST_POWER: u32 = 80;

/// The radius from the leading term, if that term leads to it.
pub(super) fn radius(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let (Names { load_integral, limit, .. }, kind) = (names, names.generated("WholePowers"));
    match whole_powers(&forms.stepped, coefficients) {
        Some(powers) => quote!(#kind::radius(&#powers, #load_integral, #limit)),
        None => radius_of_real_powers(forms, coefficients),
    }
}

/// The same for powers of any kind; needs no item beside it.
pub(super) fn radius_of_real_powers(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let (Names { load_integral, limit, .. }, [a, scale]) = (names, ["a", "scale"].map(local));
    let radius = names.generated("radius_of_real_powers");
    let quick = names.generated("plain_power_sum_steepness");
    let precise = names.generated("scaled_power_sum_steepness");
    let terms = terms(&forms.load_integral, coefficients);
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

/// The radii of a slice from the leading term, or else by `radius_within`; for whole powers only, as others do not
/// vectorise.
pub(super) fn radii(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let names = coefficients.names;
    let solve = solve(forms, coefficients)?;
    let (general, radii_of_whole_powers) =
        (names.by_radius_within(), names.generated("radii_of_whole_powers"));
    let Names { load_integrals, limit, radii, .. } = names;
    Some(quote! {
        #radii_of_whole_powers((#load_integrals, #radii), #limit, #solve, #general,)
    })
}

/// The function that solves for one of many radii, if powers are whole.
pub(super) fn solve(forms: &ClosedForms, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let names = coefficients.names;
    let powers = whole_powers(&forms.stepped, coefficients)?;
    let (load_integral, more, kind) = (&names.load_integral, local("more"), names.generated("WholePowers"));
    Some(quote! {
        // Without the attribute, wide vectors would end at the call.
        #[inline(always)]
        |#load_integral, #more| #kind::solve(&#powers, #load_integral, #more)
    })
}

/// J as `WholePowers`, if it has them.
fn whole_powers(stepped: &Stepped, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let names = coefficients.names;
    let whole = whole(stepped)?;
    let Stepped { load_integral: sum, denominator, root } = stepped;
    let denominator = names.number(denominator);
    let (all, root) = (names.generated("WholePowers"), Literal::u32_unsuffixed(*root));
    let [steepness, last_steepness] = functions(stepped);
    let values = sum.summands.iter().map(|summand| coefficients.factor(summand));
    let (powers, count) = (whole.exponents.iter().map(|&power| Literal::u32_unsuffixed(power)), values.len());
    Some(quote! {
        #all::<_, _, _, #count, #root> {
            coefficients: [#(#values),*],
            powers: [#(#powers),*],
            steepness: #steepness,
            last_steepness: #last_steepness,
            denominator: #denominator,
        }
    })
}

/// The names of the functions that compute J and its derivatives: quickly for all steps but the last, and with fewer
/// roundings for that. Two terms are quickest with the fewest.
fn functions(stepped: &Stepped) -> [Ident; 2] {
    let are_equal = stepped.root == 1 && stepped.load_integral.summands.len() == 2;
    ["quick_steepness", if are_equal { "quick_steepness" } else { "last_steepness" }].map(local)
}

/// Whether the steps from the leading term have whole powers.
pub(super) fn has_whole_powers(forms: &ClosedForms) -> bool {
    whole(&forms.stepped).is_some()
}

/// The powers of J, if they are whole and not too high.
fn whole(stepped: &Stepped) -> Option<WholeExponents> {
    WholeExponents::up_to(HIGHEST_POWER, &stepped.load_integral)
}

/// The functions that compute J and its derivatives, with any coefficients.
pub(super) fn items(forms: &ClosedForms, names: &Names) -> Option<TokenStream> {
    let (whole, a) = (whole(&forms.stepped)?, local("a"));
    let count = whole.exponents.len();
    let variables: Vec<Ident> = (0..count).map(|index| local(&format!("j{index}"))).collect();
    let (_, variable) = whole.variable(&a);
    let weighted = |weight: fn(u32) -> u32| {
        let factors = whole.exponents.iter().zip(&variables).map(|(&p, j)| product(weight(p), j, names));
        factors.collect::<Vec<_>>()
    };
    let between = |steps| power(&variable, steps, names);
    let nested = |weight| nested((&whole, false), weighted(weight), between);
    let with_value = |value: TokenStream| {
        let sums = [value, nested(|p| p), nested(|p| p * (p - 1) / 2)];
        steepness::value((&whole, false), &a, &sums, &Rational::one(), names)
    };
    let function = |name: &Ident, body: &TokenStream| {
        steepness::function(name, &a, (quote!([#(#variables),*]), count), body, names)
    };
    let [quick_name, last_name] = functions(&forms.stepped);
    let quick = function(&quick_name, &with_value(paired(&whole, &variable, weighted(|_| 1), names)));
    if last_name == quick_name {
        return Some(quick);
    }
    let last = match forms.stepped.root {
        1 => with_value(nested(|_| 1)),
        2 => {
            let lowest = Literal::u32_unsuffixed(whole.lowest());
            quote!(#quick_name(#a, [#(#variables),*]).with_exact_power::<#lowest>(#a))
        }
        _ => {
            let factors = variables.iter().map(ToTokens::to_token_stream);
            steepness::of_nested_powers(&whole, factors, &a, names)
        }
    };
    let last = function(&last_name, &last);
    Some(quote!(#quick #last))
}

fn product(weight: u32, coefficient: &Ident, names: &Names) -> TokenStream {
    if weight == 1 {
        return coefficient.into_token_stream();
    }
    let weight = names.number(&integer(weight));
    quote!(#weight * #coefficient)
}
