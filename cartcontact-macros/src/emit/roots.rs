//! The contact radius of a single term from its table of roots.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::{Names, local, table};
use crate::closed_forms::PowerSum;
use crate::number::code;
use crate::start::roots::{Power, Roots};

/// The table and its series.
pub(super) fn item(roots: &Roots, names: &Names) -> TokenStream {
    let (name, kind) = (table::name(), names.generated("Roots"));
    let (table, series) = (table::value(&roots.table, names), code(roots.series));
    quote!(static #name: #kind = #kind { table: #table, series: #series };)
}

/// The radius from the table, if it is there.
pub(super) fn radius(
    roots: &Roots,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> TokenStream {
    let (table, term) = (table::name(), term(roots, load_integral, coefficients, names));
    let [load_integral, limit] = ["load_integral", "limit"].map(local);
    quote!(#table.radius(#load_integral, #limit, #term))
}

/// The radii of a slice from the table, and elsewhere by `radius_within`.
pub(super) fn radii(
    roots: &Roots,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> TokenStream {
    let general = names.by_radius_within();
    let (table, term) = (table::name(), term(roots, load_integral, coefficients, names));
    let [load_integrals, limit, radii] = ["load_integrals", "limit", "radii"].map(local);
    quote! {
        #table.radii(
            (#load_integrals, #radii),
            #limit,
            #term,
            #general,
        )
    }
}

/// The term of J: what the table has, or its coefficient for a table of any.
fn term(
    roots: &Roots,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
    names: &Names,
) -> TokenStream {
    let (Some(Power { k, q }), Some(only)) = (roots.periods_of, load_integral.summands.first()) else {
        return names.generated("OwnTerm");
    };
    let single_term = names.generated("SingleTerm");
    let (k, q) = (Literal::u32_unsuffixed(k), Literal::u32_unsuffixed(q));
    let c = coefficients.unweighted(only);
    quote!(#single_term::<_, #k, #q>::of(#c))
}
