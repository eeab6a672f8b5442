//! The contact radius as polynomials of the load integral.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Names, local, table};
use crate::start::curves::Curves;

/// The tables of both formats.
pub(super) fn items(curves: &Curves, names: &Names) -> TokenStream {
    let ([double, single], [kind_of_double, kind_of_single]) =
        (tables(), ["DoubleCurves", "SingleCurves"].map(|kind| names.generated(kind)));
    let [rows_of_double, rows_of_single] =
        [table::value(&curves.double, names), table::value(&curves.single, names)];
    quote! {
        static #double: #kind_of_double = #rows_of_double;
        static #single: #kind_of_single = #rows_of_single;
    }
}

fn tables() -> [Ident; 2] {
    ["CURVES", "CURVES_OF_SINGLE"].map(local)
}

/// The radius from the tables if it is there, and the radii of a slice. Outside the tables they come from `solve`, or
/// from `radius_within`.
pub(super) fn radius_and_radii(solve: &TokenStream, names: &Names) -> [TokenStream; 2] {
    let (kind, [double, single], general) = (names.generated("Curves"), tables(), names.by_radius_within());
    let Names { load_integral, load_integrals, limit, radii, .. } = names;
    let curves = quote!(#kind { double: &#double, single: &#single });
    [
        quote!(#kind::radius(#curves, #load_integral, #limit)),
        quote!(#kind::radii(#curves, (#load_integrals, #radii), #limit, #solve, #general,)),
    ]
}
