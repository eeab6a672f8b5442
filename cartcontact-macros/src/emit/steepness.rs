//! J with its derivatives as code: what a step to the contact radius is taken from.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::power_sum::Whole;
use super::{Names, local};
use crate::number::{Rational, literal};

/// The name of the function that gives it.
pub(super) fn name() -> Ident {
    local("steepness")
}

/// The function that gives it at the radius `a` with some coefficients.
pub(super) fn function(
    a: &Ident,
    (coefficients, count): (impl ToTokens, usize),
    body: &TokenStream,
    names: &Names<'_>,
) -> TokenStream {
    let (Names { krate, scalar }, steepness) = (names, names.generated("Steepness"));
    let name = name();
    quote! {
        #[inline(always)]
        fn #name<#scalar: #krate::Scalar>(
            #a: #scalar,
            #coefficients: [#scalar; #count],
        ) -> #steepness<#scalar> {
            #body
        }
    }
}

/// The value at the radius `a` of powers that are whole, or all are but for a half, from J and its derivatives as sums in the
/// [`variable`](Whole::variable), divided by its lowest power; `unit` is what a J′ was divided by, and a² J″/2 by its square.
pub(super) fn value(
    (whole, has_half): (&Whole, bool),
    a: &Ident,
    sums: impl FnOnce(&Ident) -> [TokenStream; 3],
    unit: &Rational,
    names: &Names<'_>,
) -> TokenStream {
    let (square, variable) = whole.variable(a);
    let [value, first, half_second] = sums(&variable);
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let exponent = Literal::u32_unsuffixed(lowest / stride);
    let odd = (lowest % stride == 1).then(|| quote!(* #a));
    let root = has_half.then(|| {
        let square_root = names.generated("square_root");
        quote!(* #square_root(#a))
    });
    let [power, steepness] = ["integer_power", "Steepness"].map(|name| names.generated(name));
    let (constant, per_unit) = (names.constant(), literal(&unit.recip()));
    quote! {
        #square
        #steepness {
            power: #power(#variable, #exponent) #odd #root,
            value: #value,
            excess: #constant(0.0f64),
            first: #first,
            half_second: #half_second,
            per_unit: #constant(#per_unit),
        }
    }
}
