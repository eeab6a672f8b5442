//! The step from the table of seeds to the contact radius.

use num_traits::One;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::power_sum::{WholeExponents, is_monic, nested, paired, power, terms};
use super::{Names, local, steepness, table};
use crate::closed_forms::{PowerSum, Stepped};
use crate::number::{Rational, integer};
use crate::start::seeds::Seeds;

/// The table, and the function that the step from it evaluates.
pub(super) fn items(seeds: &Seeds, stepped: &Stepped, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let (table, a) = (table::item(&seeds.table, names), local("a"));
    let body = body(stepped, &seeds.unit, &a, coefficients);
    let function = steepness::function(&name(), &a, coefficients.variables(), &body, names);
    quote!(#table #function)
}

/// The name of that function.
fn name() -> Ident {
    local("steepness")
}

/// The radius from the table if it is there, and the radii of a slice. Outside the table they come from `solve`, or
/// from `radius_within`.
pub(super) fn radius_and_radii(
    seeds: &Seeds,
    stepped: &Stepped,
    solve: &TokenStream,
    coefficients: &Coefficients<'_>,
) -> [TokenStream; 2] {
    let names = coefficients.names;
    let (variables, _) = coefficients.variables();
    let units = units(seeds, stepped, coefficients);
    let (table, steepness, general) = (table::name(), name(), names.by_radius_within());
    let kind = names.generated("Table");
    let (Names { load_integral, load_integrals, limit, radii, .. }, a) = (names, local("a"));
    let step = quote!(|#a| #steepness(#a, #variables));
    [
        quote!(#kind::radius(&#table, #load_integral, #limit, #units, #step)),
        quote! {
            #kind::radii(
                &#table,
                (#load_integrals, #radii),
                #limit,
                #units,
                // Without the attribute, wide vectors would end at the call.
                #[inline(always)]
                move #step,
                #solve,
                #general,
            )
        },
    ]
}

/// The units of the table: those of its own geometry, or those in which the first two terms have the same size.
fn units(seeds: &Seeds, stepped: &Stepped, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let Stepped { load_integral, denominator, root } = stepped;
    let own = if load_integral.summands.iter().all(|summand| summand.constant().is_some()) {
        names.generated("OwnUnits")
    } else {
        equal_terms(seeds, load_integral, denominator, coefficients)
    };
    if *root == 1 {
        return own;
    }
    let (root_of, index) = (names.generated("RootOf"), Literal::u32_unsuffixed(*root));
    quote!(#root_of::<_, #index>(#own))
}

/// The units in which the first two terms have the same size, from the sizes of all terms: a coefficient whose sign
/// differs from the one in the table is negative there.
fn equal_terms(
    seeds: &Seeds,
    load_integral: &PowerSum,
    denominator: &Rational,
    coefficients: &Coefficients<'_>,
) -> TokenStream {
    let names = coefficients.names;
    let sizes = load_integral.summands.iter().zip(&seeds.factors).map(|(summand, &factor)| {
        let coefficient = coefficients.factor(summand);
        if factor < 0.0 { quote!(-(#coefficient)) } else { coefficient }
    });
    let sizes: Vec<TokenStream> = sizes.collect();
    let exponents = load_integral.summands.iter().map(|summand| names.number(&summand.exponent));
    let first_two = sizes.iter().zip(exponents).take(2).map(|(size, exponent)| quote!((#size, #exponent)));
    let others = sizes.iter().skip(2);
    let (equal_terms, denominator) = (names.generated("EqualTerms"), names.number(denominator));
    quote!(#equal_terms::of(#(#first_two,)* [#(#others),*], #denominator))
}

/// A `Steepness` at the radius `a`: J, a J′ divided by a [unit](Seeds::unit), and a² J″/2 divided by its square. In J
/// a unit would cost a rounding, as the load integral would have to be divided by it, too.
fn body(stepped: &Stepped, unit: &Rational, a: &Ident, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    let Stepped { load_integral, root, .. } = stepped;
    let Some(whole) = WholeExponents::of(load_integral) else {
        let (function, terms) = (names.generated("power_sum_steepness"), terms(load_integral, coefficients));
        return quote!(#function(#a, #terms));
    };
    if *root > 2 {
        let factors = load_integral.summands.iter().map(|summand| coefficients.factor(summand));
        return steepness::of_nested_powers(&whole, factors, a, names);
    }
    let first = load_integral.weighted(|p| p / unit);
    let half_second = first.weighted(|p| (p - Rational::one()) / (integer(2) * unit));
    let (values, of_value) = coefficients.bound("value", load_integral);
    let (firsts, of_first) = coefficients.bound("first", &first);
    let (half_seconds, of_half_second) = coefficients.bound("half_second", &half_second);
    let (_, variable) = whole.variable(a);
    let between = |steps| power(&variable, steps, names);
    let sums = [
        nested((&whole, is_monic(load_integral)), of_value, between),
        nested((&whole, is_monic(&first)), of_first, between),
        paired(&whole, &variable, of_half_second, names),
    ];
    // The degree of J divides its roundings. Where a gap begins with r or less, that is by five at most; and powers of a
    // square root are twice as high as those of a radius, and round twice as often. Either is made up for by what the
    // lowest power loses, both by what its product with the sum loses.
    let (is_low, is_of_root) = (whole.lowest() <= 5 * root, *root == 2);
    let steepness = steepness::value((&whole, is_low != is_of_root), a, &sums, unit, names);
    let body = quote!(#values #firsts #half_seconds #steepness);
    let lowest = Literal::u32_unsuffixed(whole.lowest());
    if is_low && is_of_root { quote!({ #body }.with_exact_power::<#lowest>(#a)) } else { body }
}
