//! Sums of powers as code: precise, rounded once, for results; and quick for values that are only integrated.
//!
//! | exponents | precise | quick |
//! |---|---|---|
//! | low: whole, up to 8, or of both parities, up to 16 | Horner's rule in double words | Horner's rule, written out |
//! | low in r²: all even or all odd, up to 68 | the same in r² | Horner's rule in r², corrected for its rounding |
//! | a sum of both | as all others | the two sums |
//! | low multiples of 1/4 | as all others | Horner's rule for the whole powers beside each fraction, by square roots |
//! | all others | every power in double words | the same, rounded before they are added |
//!
//! Beyond the 8th power, no two consecutive powers of those that a rule in double words goes through may be missing, nor
//! of those that the one in r² goes through beyond the 24th: where there are any, they are zeros, which round nothing
//! and cost less than a power of its own.
//!
//! Horner's rule in x rounds twice per step, at random. In r² it also repeats the rounding of r² in every step, with
//! the same sign, which still costs at most 2 ε at r⁸, and is corrected for beyond: expansions of spheres and sums of two
//! powers were off by up to 2.7, 3.7 and 4.8 ε at r⁸, r²⁴ and r⁴⁴, among 6000 radii each in exact arithmetic, and up to
//! r⁶⁸ by 4 ε; 6.7 ε if r⁶⁸ outweighs thirty lower powers, and 9.5 ε next to a power of two, where all products may round
//! in the same direction. In x a gap in the exponents is bridged by as many products. All other quick values are within
//! 5 ε.

use num_traits::{One, ToPrimitive};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::coefficients::{Coefficients, MOST_WRITTEN_OUT};
use super::operations::Operations;
use super::{Names, local};
use crate::closed_forms::{PowerSum, Summand};
use crate::number::{Rational, code, nearest_and_rest, rounded};

/// The highest whole power beside a root, whose product stays below 5 ε.
const HIGHEST_BESIDE_ROOT: u32 = 8;

/// The highest power of a sum of even and odd powers that is quick by Horner's rule in r.
const HIGHEST_OF_BOTH_PARITIES: u32 = 16;

/// The highest power of a sum in r² that is quick by Horner's rule: of the load integral of a surface up to r⁶⁴.
const HIGHEST_IN_SQUARE: u32 = 68;

/// The highest one if most powers are missing: beyond it, powers one by one take less time.
const HIGHEST_OF_FEW: u32 = 24;

/// The most products with a power of x, one after the other, that stay below 7 ε: next to a power of two, or a root of
/// one, none of them changes the digits much, so that all may round in the same direction.
const MOST_PRODUCTS: u32 = 24;

/// The highest power that is written out as a product.
const LONGEST_PRODUCT: u32 = 3;

/// The whole exponents of a sum of powers.
pub(super) struct WholeExponents {
    pub(super) exponents: Vec<u32>,
}

impl WholeExponents {
    /// None if an exponent is fractional or negative.
    pub(super) fn of(sum: &PowerSum) -> Option<Self> {
        let exponents = sum.summands.iter().map(|summand| whole_number(&summand.exponent));
        Some(Self { exponents: exponents.collect::<Option<_>>()? })
    }

    /// None also if an exponent is above `highest`.
    pub(super) fn up_to(highest: u32, sum: &PowerSum) -> Option<Self> {
        Self::of(sum).filter(|whole| whole.highest() <= highest)
    }

    pub(super) fn lowest(&self) -> u32 {
        self.exponents.first().copied().unwrap_or(0)
    }

    pub(super) fn highest(&self) -> u32 {
        self.exponents.last().copied().unwrap_or(0)
    }

    /// 2 if all exponents are even or all are odd, so that the sum is a polynomial in r²; otherwise 1.
    pub(super) fn stride(&self) -> u32 {
        if self.exponents.iter().all(|exponent| exponent % 2 == self.lowest() % 2) { 2 } else { 1 }
    }

    /// The variable in which the sum is a polynomial, and the binding of r² if it is that.
    pub(super) fn variable(&self, x: &Ident) -> (Option<TokenStream>, Ident) {
        if self.stride() == 2 && self.highest() > 1 {
            let square = local("s");
            (Some(quote!(let #square = #x * #x;)), square)
        } else {
            (None, x.clone())
        }
    }

    /// The product of the lowest power, as factors of the [`variable`](Self::variable) and of `x` itself if that power is
    /// odd in r²; each with a multiplication sign in front.
    pub(super) fn lowest_power(&self, variable: &Ident, x: &Ident) -> TokenStream {
        let factors = (0..self.lowest() / self.stride()).map(|_| variable);
        let odd = (self.lowest() % self.stride() == 1).then(|| quote!(* #x));
        quote!(#(* #factors)* #odd)
    }

    fn largest_gap(&self) -> u32 {
        self.exponents.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(0)
    }

    /// Whether Horner's rule would go through many powers without a summand, below the lowest one or between two.
    pub(super) fn has_long_gaps(&self) -> bool {
        self.lowest().max(self.largest_gap()) > MOST_PRODUCTS
    }

    fn is_low(&self) -> bool {
        let highest = self.highest();
        highest <= 8 || (self.stride() == 1 && highest <= HIGHEST_OF_BOTH_PARITIES)
    }

    fn is_low_in_square(&self) -> bool {
        let highest = if self.largest_gap() <= 4 { HIGHEST_IN_SQUARE } else { HIGHEST_OF_FEW };
        self.stride() == 2 && self.highest() <= highest && !self.has_long_gaps()
    }

    /// Whether Horner's rule in double words takes less time than the powers one by one.
    fn is_dense(&self) -> bool {
        let (gap, highest) = (self.largest_gap(), self.highest());
        let (widest, most) =
            if self.stride() == 2 { (4, HIGHEST_IN_SQUARE) } else { (2, HIGHEST_OF_BOTH_PARITIES) };
        highest <= 8 || (gap <= widest && highest <= most)
    }

    /// The factors of all powers from `from` on in steps of `step` as an array, zero where there is no summand.
    pub(super) fn dense(
        &self,
        (from, step): (u32, u32),
        sum: &PowerSum,
        coefficients: &Coefficients<'_>,
    ) -> TokenStream {
        let mut summands = self.exponents.iter().zip(&sum.summands).peekable();
        let powers = (from..=self.highest()).step_by(usize::try_from(step).unwrap_or(1));
        let present = powers
            .map(|power| summands.next_if(|(exponent, _)| **exponent == power).map(|(_, summand)| summand));
        coefficients.factors(&present.collect::<Vec<_>>())
    }
}

/// The value of the sum at `x` in double words, with one rounding besides those of the coefficients, which may be
/// precise; and the operations that it takes.
pub(super) fn value(sum: &PowerSum, x: &Ident, coefficients: &Coefficients<'_>) -> (TokenStream, Operations) {
    let names = coefficients.names;
    let Some(whole) = WholeExponents::of(sum).filter(WholeExponents::is_dense) else {
        let (power_sum, terms, fused) =
            (names.generated("power_sum"), terms(sum, coefficients), &names.fused);
        let code = quote!(#power_sum::<_, _, _, #fused>(#x, #terms));
        return (code, Operations::InLibrary);
    };
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let dense = whole.dense((lowest, stride), sum, coefficients);
    let steps = (whole.highest() - lowest) / stride;
    // r² and an odd factor, in addition to the steps and the lowest power.
    let (function, beside) =
        if stride == 2 { ("precise_even_sum", 1 + lowest % 2) } else { ("precise_sum", 0) };
    let (function, fused) = (names.generated(function), &names.fused);
    let operations =
        Operations::Counted { multiplications: steps + lowest / stride + beside, additions: steps };
    (quote!(#function::<_, _, #fused, _>(#x, #lowest, #dense)), operations)
}

/// The value of the sum at `x` in the cheapest form with an error below 7 ε.
pub(super) fn quick_value(sum: &PowerSum, x: &Ident, coefficients: &Coefficients<'_>) -> TokenStream {
    if let Some(whole) = WholeExponents::of(sum).filter(WholeExponents::is_low) {
        return horner(sum, &whole, x, coefficients);
    }
    let of_horner = of_parities(sum, x, coefficients).or_else(|| in_quarters(sum, x, coefficients));
    of_horner.unwrap_or_else(|| {
        let (power_sum, terms) = (coefficients.names.generated("quick_power_sum"), terms(sum, coefficients));
        quote!(#power_sum(#x, #terms))
    })
}

/// The even and the odd powers, as far as there are any, if both are low in r².
fn of_parities(sum: &PowerSum, x: &Ident, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let even_sum = coefficients.names.generated("quick_even_sum");
    let value = |part: PowerSum| {
        let whole = WholeExponents::of(&part).filter(WholeExponents::is_low_in_square)?;
        let lowest = whole.lowest();
        let dense = whole.dense((lowest, 2), &part, coefficients);
        Some(quote!(#even_sum(#x, #lowest, #dense)))
    };
    let parts = sum.by_parity().into_iter().filter(|part| !part.summands.is_empty());
    let values = parts.map(value).collect::<Option<Vec<_>>>()?;
    Some(quote!(#(#values)+*))
}

/// Σ x^(k/4) P(x) over the parts of multiples of 1/4, where all have low powers. A root and the product with it are two
/// more roundings.
fn in_quarters(sum: &PowerSum, x: &Ident, coefficients: &Coefficients<'_>) -> Option<TokenStream> {
    let (mut bindings, mut values) = (TokenStream::new(), Vec::new());
    for (quarters, part) in (0_u8..).zip(sum.in_quarters()?) {
        let whole = WholeExponents::of(&part)?;
        let is_low = if quarters == 0 { whole.is_low() } else { whole.highest() <= HIGHEST_BESIDE_ROOT };
        if !is_low {
            return None;
        }
        if part.summands.is_empty() {
            continue;
        }
        let (value, part) = (local(&format!("of_quarter{quarters}")), horner(&part, &whole, x, coefficients));
        bindings.extend(quote!(let #value = { #part };));
        values.push(if quarters == 0 {
            quote!(#value)
        } else {
            let (root, quarters) =
                (coefficients.names.generated("quarter_root"), Literal::u8_unsuffixed(quarters));
            quote!(#root::<_, #quarters>(#x) * #value)
        });
    }
    Some(quote!(#bindings #(#values)+*))
}

/// Horner's rule with every power written as repeated multiplication, so that nothing overflows before the result.
fn horner(sum: &PowerSum, whole: &WholeExponents, x: &Ident, coefficients: &Coefficients<'_>) -> TokenStream {
    let (square, variable) = whole.variable(x);
    let (bindings, factors) = coefficients.bound("c", sum);
    let nested = nested((whole, is_monic(sum)), factors, |steps| {
        if whole.stride() == 1 {
            product(&variable, steps)
        } else {
            power(&variable, steps, coefficients.names)
        }
    });
    let lowest_power = whole.lowest_power(&variable, x);
    quote!(#bindings #square (#nested) #lowest_power)
}

/// Whether the leading coefficient is 1.
pub(super) fn is_monic(sum: &PowerSum) -> bool {
    sum.summands.last().and_then(Summand::constant).is_some_and(One::is_one)
}

/// Horner's rule for a sum with these `factors` divided by its lowest power, with powers of the variable between them.
/// The leading term of a monic sum takes no multiplication.
pub(super) fn nested(
    (whole, mut is_monic): (&WholeExponents, bool),
    factors: Vec<TokenStream>,
    power: impl Fn(u32) -> TokenStream,
) -> TokenStream {
    let mut nested = TokenStream::new();
    let mut above: Option<u32> = None;
    for (own, &exponent) in factors.into_iter().zip(&whole.exponents).rev() {
        nested = match above {
            None => own,
            Some(above) => {
                let power = power((above - exponent) / whole.stride());
                let first = (!core::mem::take(&mut is_monic)).then(|| quote!((#nested) *));
                quote!(#own + #first #power)
            }
        };
        above = Some(exponent);
    }
    nested
}

/// The sum with these `factors` divided by its lowest power, by pairs of summands: Estrin's scheme, which lets a
/// processor do more at a time than Horner's rule.
///
/// If both derivatives had the same form, compilers would put them side by side into one vector, and its halves would
/// wait for each other.
pub(super) fn paired(
    whole: &WholeExponents,
    variable: &Ident,
    factors: Vec<TokenStream>,
    names: &Names,
) -> TokenStream {
    // The variable's power from one exponent to another.
    let between = |from: u32, to: u32| power(variable, (to - from) / whole.stride(), names);
    let is_odd = factors.len() % 2 == 1;
    let mut summands = factors.into_iter().zip(whole.exponents.iter().copied()).rev();
    let mut paired = if is_odd { summands.next() } else { None };
    while let (Some((high, upper)), Some((low, lower))) = (summands.next(), summands.next()) {
        let step = between(lower, upper);
        let pair = quote!(#low + (#high) * #step);
        let pair = match paired {
            None => pair,
            Some((above, exponent)) => {
                let step = between(lower, exponent);
                quote!((#pair) + (#above) * (#step))
            }
        };
        paired = Some((pair, lower));
    }
    paired.map(|(sum, _)| sum).unwrap_or_default()
}

/// The variable to the power `exponent`, with few products if the exponent is high.
pub(super) fn power(variable: &Ident, exponent: u32, names: &Names) -> TokenStream {
    if exponent > LONGEST_PRODUCT {
        let (integer_power, exponent) = (names.generated("integer_power"), Literal::u32_unsuffixed(exponent));
        return quote!(#integer_power(#variable, #exponent));
    }
    product(variable, exponent)
}

/// The variable to the power `exponent`, of which every product rounds at random.
fn product(variable: &Ident, exponent: u32) -> TokenStream {
    let further = (1..exponent).map(|_| variable);
    quote!(#variable #(* #further)*)
}

/// The sum as terms (coefficient, exponent) to iterate over.
pub(super) fn terms(sum: &PowerSum, coefficients: &Coefficients<'_>) -> TokenStream {
    let names = coefficients.names;
    if let Some(table) = table(sum).filter(|table| table.len() > MOST_WRITTEN_OUT) {
        let (whole_terms, table) = (names.generated("whole_terms"), code(table));
        return quote!(#whole_terms(&#table));
    }
    let factors = sum.summands.iter().map(|summand| coefficients.factor(summand));
    let exponents = sum.summands.iter().map(|summand| exponent(&summand.exponent, names));
    quote!([#((#factors, #exponents)),*])
}

/// The terms as numbers, if all factors are constants and all exponents are whole.
fn table(sum: &PowerSum) -> Option<Vec<(f64, i32)>> {
    let term = |summand: &Summand| {
        let whole = summand.exponent.is_integer().then(|| whole_part(&summand.exponent))?;
        Some((rounded(summand.constant()?), whole))
    };
    sum.summands.iter().map(term).collect()
}

pub(super) fn exponent(exponent: &Rational, names: &Names) -> TokenStream {
    let of = names.generated("Exponent");
    if exponent.is_integer() {
        let whole = Literal::i32_unsuffixed(whole_part(exponent));
        quote!(#of::whole(#whole))
    } else {
        let parts = code(in_parts(exponent));
        quote!(#of::in_parts #parts)
    }
}

/// The number, if it is whole and not negative.
pub(super) fn whole_number(value: &Rational) -> Option<u32> {
    value.is_integer().then(|| value.to_u32()).flatten()
}

fn whole_part(exponent: &Rational) -> i32 {
    exponent.floor().to_i32().unwrap_or(0)
}

/// An exponent that is not rounded in any format: its whole part, the fraction as an `f64`, and what that lacks.
fn in_parts(exponent: &Rational) -> (i32, f64, f64) {
    let (nearest, rest) = nearest_and_rest(&(exponent - exponent.floor()));
    (whole_part(exponent), nearest, rest)
}
