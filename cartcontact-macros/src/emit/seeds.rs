//! The step from the table of seeds to the contact radius.

use num_traits::{One, ToPrimitive};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::power_sum::{Whole, nested, pairs};
use super::{Names, local, steepness};
use crate::closed_forms::{PowerSum, Scaled, Summand};
use crate::number::{Rational, integer, literal};
use crate::seeds::Seeds;

/// The widest gap between powers that is written out as a product.
const WIDEST_GAP: u32 = 8;

fn table() -> Ident {
    local("SEEDS")
}

/// The table, and the function that the step from it evaluates.
pub(super) fn items(
    seeds: &Seeds,
    load_integral: &PowerSum,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let (table, kind) = (table(), names.generated("Seeds"));
    let (first, single) = (Literal::i32_unsuffixed(seeds.first), seeds.single);
    let count = Literal::usize_unsuffixed(seeds.rows.len());
    // One text for the compiler to read is quicker than three thousand tokens, and shortest literals are what `Debug`
    // writes.
    let rows: TokenStream = format!("{:?}", seeds.in_places()).parse().unwrap_or_default();
    let a = local("a");
    let body = body(load_integral, &a, coefficients, names);
    let function = steepness::function(&a, coefficients.variables(), &body, names);
    quote! {
        static #table: #kind = #kind { first: #first, count: #count, single: #single, rows: #rows };

        #function
    }
}

/// The radius from the table, if it is there.
pub(super) fn radius(scaled: &Scaled, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let (variables, _) = coefficients.variables();
    let units = units(scaled, coefficients, names);
    let [a, load_integral, limit] = ["a", "load_integral", "limit"].map(local);
    let (table, steepness) = (table(), steepness::name());
    quote!(#table.radius(#load_integral, #limit, #units, |#a| #steepness(#a, #variables)))
}

/// The radii of a slice from the table, and elsewhere by `radius_within`.
pub(super) fn radii(scaled: &Scaled, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let (krate, (variables, _)) = (names.krate, coefficients.variables());
    let units = units(scaled, coefficients, names);
    let [a, load_integral, limit] = ["a", "load_integral", "limit"].map(local);
    let [load_integrals, radii] = ["load_integrals", "radii"].map(local);
    let (table, steepness) = (table(), steepness::name());
    quote! {
        #table.radii(
            (#load_integrals, #radii),
            #limit,
            #units,
            // Without it, wide vectors would end at the call.
            #[inline(always)]
            move |#a| #steepness(#a, #variables),
            |#load_integral| #krate::GapProfile::radius_within(self, #load_integral, #limit),
        )
    }
}

/// The units of the table: those of its own geometry, or of the two terms that it stands for.
fn units(scaled: &Scaled, coefficients: &Coefficients<'_>, names: &Names<'_>) -> TokenStream {
    let summands = scaled.load_integral.summands.as_slice();
    let (constant, per_unit) = (names.constant(), literal(&scaled.per_unit));
    let coefficient = |summand: &Summand| coefficients.times(summand.term, &summand.weight);
    let term = |summand| {
        let (coefficient, exponent) = (coefficient(summand), literal(&summand.exponent));
        quote!((#coefficient, #constant(#exponent)))
    };
    match summands {
        _ if summands.iter().all(|summand| coefficients.constant(summand).is_some()) => {
            names.generated("OwnUnits")
        }
        [only] => {
            let (single_term, coefficient) = (names.generated("SingleTerm"), coefficient(only));
            let [k, q] = [only.exponent.numer(), only.exponent.denom()]
                .map(|part| Literal::u32_unsuffixed(part.to_u32().unwrap_or(1)));
            quote!(#single_term::<_, #k, #q>::of(#coefficient, #constant(#per_unit)))
        }
        [low, high, ..] => {
            let (equal_terms, low, high) = (names.generated("EqualTerms"), term(low), term(high));
            quote!(#equal_terms::of(#low, #high, #constant(#per_unit)))
        }
        [] => TokenStream::new(),
    }
}

/// A `Steepness` at the radius `a`: J, and a J′ and a² J″/2 in units of that of the highest power and of its square.
///
/// Its coefficient is then 1 in a J′, which spares a multiplication; in J it would be one that rounds, as the load
/// integral were to be divided by it, too. Where it is a symbol, the unit is 1.
fn body(
    load_integral: &PowerSum,
    a: &Ident,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let whole = Whole::and_half(load_integral).filter(|(whole, _)| whole.largest_gap() <= WIDEST_GAP);
    let (Some((whole, has_half)), Some(last)) = (whole, load_integral.summands.last()) else {
        let (function, pairs) =
            (names.generated("power_sum_steepness"), pairs(load_integral, coefficients, names));
        return quote!(#function(#a, [#(#pairs),*]));
    };
    let unit = match coefficients.constant(last) {
        Some(leading) => leading * &last.exponent,
        None => Rational::one(),
    };
    let first = load_integral.weighted(|p| p / &unit);
    let half_second = first.weighted(|p| (p - Rational::one()) / (integer(2) * &unit));
    let sums = |variable: &Ident| {
        let [value, first] = [load_integral, &first].map(|sum| nested(sum, &whole, variable, coefficients));
        [value, first, paired(&half_second, &whole, variable, coefficients)]
    };
    steepness::value((&whole, has_half), a, sums, &unit, names)
}

/// The sum divided by its lowest power, by pairs of summands: Estrin's scheme, of which a processor does more at a time
/// than of Horner's rule.
///
/// Where both derivatives had the same form, compilers would put them side by side into one vector, and its halves had
/// to wait for each other.
fn paired(sum: &PowerSum, whole: &Whole, variable: &Ident, coefficients: &Coefficients<'_>) -> TokenStream {
    // The variable's power from one exponent to another.
    let power = |from: u32, to: u32| {
        let further = (1..(to - from) / whole.stride()).map(|_| variable);
        quote!(#variable #(* #further)*)
    };
    let own = |summand: &Summand| coefficients.times(summand.term, &summand.weight);
    let mut summands = sum.summands.iter().map(own).zip(whole.exponents.iter().copied()).rev();
    let mut paired = if sum.summands.len() % 2 == 1 { summands.next() } else { None };
    while let (Some((high, upper)), Some((low, lower))) = (summands.next(), summands.next()) {
        let step = power(lower, upper);
        let pair = quote!(#low + (#high) * #step);
        let pair = match paired {
            None => pair,
            Some((above, exponent)) => {
                let step = power(lower, exponent);
                quote!((#pair) + (#above) * (#step))
            }
        };
        paired = Some((pair, lower));
    }
    paired.map(|(sum, _)| sum).unwrap_or_default()
}
