//! The step from the table of seeds to the contact radius.

use num_traits::One;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::Names;
use super::coefficients::Coefficients;
use super::power_sum::{Whole, nested, pairs};
use crate::closed_forms::PowerSum;
use crate::number::{Rational, integer, literal};
use crate::seeds::Seeds;

/// The widest gap between powers that is written out as a product.
const WIDEST_GAP: u32 = 8;

/// The table and the function that the step from it evaluates.
pub(super) fn items(
    seeds: &Seeds,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let Names { krate, scalar } = names;
    let [table, steepness] = ["Seeds", "Steepness"].map(|name| names.generated(name));
    let count = Literal::usize_unsuffixed(seeds.rows.len());
    let (first, single) = (Literal::i32_unsuffixed(seeds.first), seeds.single);
    let rows = seeds.rows.iter().map(|row| {
        let [c0, c1, c2, c3] = row.map(Literal::f32_unsuffixed);
        quote!([#c0, #c1, #c2, #c3])
    });
    let body = body(load_integral, coefficients, names);
    quote! {
        static SEEDS: #table<#count> = #table { first: #first, single: #single, rows: [#(#rows),*] };

        #[inline(always)]
        fn steepness<#scalar: #krate::Scalar>(a: #scalar) -> #steepness<#scalar> { #body }
    }
}

/// `radius_within` and `radii_within` from the table, and elsewhere by `general`.
pub(super) fn methods(names: &Names<'_>, general: &TokenStream) -> TokenStream {
    let Names { krate, scalar } = names;
    let elsewhere = names.generated("elsewhere");
    quote! {
        #[inline]
        fn radius_within(
            &self,
            load_integral: #scalar,
            limit: #scalar,
        ) -> ::core::result::Result<#scalar, #krate::RadiusError> {
            match SEEDS.radius(load_integral, limit, steepness) {
                ::core::option::Option::Some(radius) => ::core::result::Result::Ok(radius),
                ::core::option::Option::None => #elsewhere(move || { #general }),
            }
        }

        fn radii_within(
            &self,
            load_integrals: &[#scalar],
            limit: #scalar,
            radii: &mut [#scalar],
        ) -> ::core::result::Result<(), #krate::RadiusError> {
            let general = |load_integral| #krate::GapProfile::radius_within(self, load_integral, limit);
            SEEDS.radii(load_integrals, limit, radii, steepness, general)
        }
    }
}

/// A `Steepness` at the radius `a`: J, a J′/p and a² J″/(2 p²) with the highest power a^p of J for unit.
///
/// Its coefficient is then 1 in the first two, which spares their multiplication.
fn body(load_integral: &PowerSum, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let whole = Whole::of(load_integral).filter(|whole| whole.largest_gap() <= WIDEST_GAP);
    let leading =
        load_integral.summands.last().and_then(|last| Some((coefficients.constant(last)?, &last.exponent)));
    let (Some(whole), Some((leading, degree))) = (whole, leading) else {
        let (function, pairs) =
            (names.generated("power_sum_steepness"), pairs(load_integral, coefficients, names));
        return quote!(#function(a, [#(#pairs),*]));
    };
    let (unit, two) = (leading.recip(), integer(2));
    let value = load_integral.weighted(|_| unit.clone());
    let first = value.weighted(|p| p / degree);
    let half_second = first.weighted(|p| (p - Rational::one()) / (&two * degree));
    let a = Ident::new("a", Span::call_site());
    let (square, variable) = whole.variable(&a);
    let [value, first, half_second] =
        [&value, &first, &half_second].map(|sum| nested(sum, &whole, &variable, coefficients));
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let exponent = Literal::u32_unsuffixed(lowest / stride);
    let odd = (lowest % stride == 1).then(|| quote!(* #a));
    let [power, steepness] = ["integer_power", "Steepness"].map(|name| names.generated(name));
    let (constant, per_unit, per_degree) = (names.constant(), literal(&unit), literal(&degree.recip()));
    quote! {
        #square
        #steepness {
            power: #power(#variable, #exponent) #odd,
            value: #value,
            first: #first,
            half_second: #half_second,
            per_unit: #constant(#per_unit),
            per_degree: #constant(#per_degree),
        }
    }
}
