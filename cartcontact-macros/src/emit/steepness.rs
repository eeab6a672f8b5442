//! J with its derivatives as code, as a step to the contact radius needs them.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::power_sum::WholeExponents;
use super::{Names, local};
use crate::number::{Rational, integer, literal};

/// The function with this `name` that computes them at the radius `a` with some coefficients.
pub(super) fn function(
    name: &Ident,
    a: &Ident,
    (coefficients, count): (impl ToTokens, usize),
    body: &TokenStream,
    names: &Names,
) -> TokenStream {
    let (Names { krate, scalar, .. }, steepness) = (names, names.generated("Steepness"));
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

/// The value at `a` for whole powers, from J and its derivatives as sums in the [`variable`](WholeExponents::variable),
/// divided by its lowest power; a J′ was divided by `unit`, and a² J″/2 by its square. The power may come with its
/// excess.
pub(super) fn value(
    (whole, has_excess): (&WholeExponents, bool),
    a: &Ident,
    [value, first, half_second]: &[TokenStream; 3],
    unit: &Rational,
    names: &Names,
) -> TokenStream {
    let (square, variable) = whole.variable(a);
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let (constant, per_unit) = (names.constant(), literal(&unit.recip()));
    let [power, sum, lost] = ["power", "value", "lost"].map(local);
    let (binding, power, excess) = if has_excess {
        let (function, exponent) = (names.generated("power_of_half_digits"), Literal::u32_unsuffixed(lowest));
        let binding = quote!(let (#power, #lost) = #function(#a, #exponent););
        (binding, quote!(#power), quote!(#lost * #sum))
    } else {
        let (function, exponent) =
            (names.generated("integer_power"), Literal::u32_unsuffixed(lowest / stride));
        let odd = (lowest % stride == 1).then(|| quote!(* #a));
        // Not a product: compilers would not know that it is zero.
        (TokenStream::new(), quote!(#function(#variable, #exponent) #odd), quote!(#constant(0.0f64)))
    };
    let steepness = names.generated("Steepness");
    quote! {
        #square
        #binding
        let #sum = #value;
        #steepness {
            power: #power,
            value: #sum,
            excess: #excess,
            first: #first,
            half_second: #half_second,
            per_unit: #constant(#per_unit),
        }
    }
}

/// The same by Horner's rule with powers that are not rounded: those of a root are so high that they would round often.
pub(super) fn of_nested_powers(
    whole: &WholeExponents,
    factors: impl DoubleEndedIterator<Item = TokenStream> + ExactSizeIterator,
    a: &Ident,
    names: &Names,
) -> TokenStream {
    let mut above = None;
    let terms = factors.zip(whole.exponents.iter().copied()).rev().map(|(c, exponent)| {
        let down_to = above.replace(exponent).map(|above: u32| {
            let difference = Literal::u32_unsuffixed(above - exponent);
            quote!(.times_power::<#difference>())
        });
        let p = names.number(&integer(exponent));
        quote!(#down_to.plus(#c, #p))
    });
    let terms: Vec<TokenStream> = terms.collect();
    let (nested, lowest) = (names.generated("NestedPowers"), Literal::u32_unsuffixed(whole.lowest()));
    quote!(#nested::of(#a) #(#terms)* .of_lowest_power::<#lowest>())
}
