//! The contact radius of a single term from its table of roots.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::{Names, local, table};
use crate::closed_forms::PowerSum;
use crate::number::code;
use crate::start::roots::{Parts, Reach, Roots};

/// The table with its series, and the spans beyond it.
pub(super) fn item(roots: &Roots, names: &Names) -> TokenStream {
    let (name, kind) = (table::name(), names.generated("Roots"));
    let (table, series) = (table::value(&roots.table, names), code(&roots.series));
    let terms = Literal::usize_unsuffixed(roots.series.len());
    let spans = if let Reach::Spans(spans) = &roots.reach {
        let (name, kind) = (local("SPANS"), names.generated("Spans"));
        let bytes = Literal::byte_string(&spans.in_places());
        quote!(static #name: #kind = #kind(*#bytes);)
    } else {
        TokenStream::new()
    };
    quote!(static #name: #kind<#terms> = #kind { table: #table, series: #series }; #spans)
}

/// The radius from the table if it is there, and the radii of a slice, which come from `radius_within` outside the
/// table.
pub(super) fn radius_and_radii(
    roots: &Roots,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
) -> [TokenStream; 2] {
    let names = coefficients.names;
    let (table, term) = (table::name(), term(roots, load_integral, coefficients));
    let (general, kind) = (names.by_radius_within(), names.generated("Roots"));
    let Names { load_integral, load_integrals, limit, radii, .. } = names;
    [
        quote!(#kind::radius(&#table, #load_integral, #limit, #term)),
        quote!(#kind::radii(&#table, (#load_integrals, #radii), #limit, #term, #general,)),
    ]
}

/// The term of J: the one of the table, or its coefficient if the table is for any coefficient.
fn term(roots: &Roots, load_integral: &PowerSum, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let only = load_integral.summands.first();
    let c = only.map(|only| coefficients.unweighted(only));
    match &roots.reach {
        Reach::Window => names.generated("OwnTerm"),
        Reach::Periods { k, q, parts: Parts { digits, .. } } => {
            let single_term = names.generated("SingleTerm");
            let [k, q, digits] = [k, q, digits].map(|number| Literal::u32_unsuffixed(*number));
            let single_term = quote!(#single_term::<_, #k, #q, #digits>);
            match only.and_then(|only| coefficients.inverse(only)) {
                Some(inverse) => quote!(#single_term::of_inverse(#inverse)),
                None => quote!(#single_term::of(#c)),
            }
        }
        Reach::Spans(_) => {
            let (any_power, spans) = (names.generated("AnyPower"), local("SPANS"));
            quote!(#any_power::of(#c, &#spans))
        }
    }
}
