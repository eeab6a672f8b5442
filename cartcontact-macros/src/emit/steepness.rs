//! J with its derivatives as code, as a step to the contact radius needs them.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::power_sum::Whole;
use super::{Names, local};
use crate::number::{Rational, literal};

/// The name of the function that computes them.
pub(super) fn name() -> Ident {
    local("steepness")
}

/// The function that computes them at the radius `a` with some coefficients.
pub(super) fn function(
    a: &Ident,
    (coefficients, count): (impl ToTokens, usize),
    body: &TokenStream,
    names: &Names,
) -> TokenStream {
    let (Names { krate, scalar, .. }, steepness) = (names, names.generated("Steepness"));
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

/// The value at `a` for whole powers, from J and its derivatives as sums in the [`variable`](Whole::variable), divided
/// by its lowest power; a J′ was divided by `unit`, and a² J″/2 by its square. For a square root the power comes with
/// its rounding error: it is twice as high as that of a radius, and would round twice as often.
pub(super) fn value(
    (whole, is_of_square_root): (&Whole, bool),
    a: &Ident,
    [value, first, half_second]: &[TokenStream; 3],
    unit: &Rational,
    names: &Names,
) -> TokenStream {
    let (square, variable) = whole.variable(a);
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let (constant, per_unit) = (names.constant(), literal(&unit.recip()));
    let [power, sum, lost] = ["power", "value", "lost"].map(local);
    let (binding, power, excess) = if is_of_square_root {
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
