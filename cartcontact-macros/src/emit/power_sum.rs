//! Sums of powers as code: precise, rounded once, for what is asked for; and quick for what is only integrated.
//!
//! | exponents | precise | quick, below 4 ε |
//! |---|---|---|
//! | whole, up to 8; or of both parities without gaps, up to 16 | Horner's rule in twice the working precision | Horner's rule, written out |
//! | all even or all odd without gaps, up to 24 | the same in r² | Horner's rule in r², corrected for the rounding of r² |
//! | all others | every power in twice the working precision | the same, rounded before they are added |
//!
//! Horner's rule in x rounds twice per step, at random; in r² it also repeats the rounding of r², in every step
//! with the same sign, which at r⁸ still costs 2 ε at the most. A gap in the exponents is a power by repeated
//! multiplication, with the same effect.

use num_traits::{One, ToPrimitive, Zero};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::coefficients::Coefficients;
use super::operations::{Counted, Operations};
use super::{Names, local};
use crate::closed_forms::{PowerSum, Summand};
use crate::number::{Rational, fraction, literal};

/// How a sum is written.
pub(super) type Form = fn(&PowerSum, &Ident, &Coefficients<'_>, &Names<'_>) -> Counted;

/// The whole exponents of a sum of powers.
pub(super) struct Whole {
    pub(super) exponents: Vec<u32>,
}

impl Whole {
    /// None if an exponent is fractional or negative.
    pub(super) fn of(sum: &PowerSum) -> Option<Self> {
        let exponent =
            |summand: &Summand| summand.exponent.is_integer().then(|| summand.exponent.to_u32()).flatten();
        Some(Self { exponents: sum.summands.iter().map(exponent).collect::<Option<_>>()? })
    }

    /// The whole parts of exponents which all are whole, or all have a half beside, and whether they have.
    pub(super) fn and_half(sum: &PowerSum) -> Option<(Self, bool)> {
        let has_half = !sum.summands.first()?.exponent.is_integer();
        let beside = if has_half { fraction(1, 2) } else { Rational::zero() };
        let whole = |exponent: Rational| exponent.is_integer().then(|| exponent.to_u32()).flatten();
        let exponents = sum.summands.iter().map(|summand| whole(&summand.exponent - &beside));
        Some((Self { exponents: exponents.collect::<Option<_>>()? }, has_half))
    }

    pub(super) fn lowest(&self) -> u32 {
        self.exponents.first().copied().unwrap_or(0)
    }

    pub(super) fn highest(&self) -> u32 {
        self.exponents.last().copied().unwrap_or(0)
    }

    /// 2 if all exponents are even or all are odd, so that the sum is one in r²; otherwise 1.
    pub(super) fn stride(&self) -> u32 {
        if self.exponents.iter().all(|exponent| exponent % 2 == self.lowest() % 2) { 2 } else { 1 }
    }

    /// What the sum is a polynomial in, and the binding of r² if it is that.
    pub(super) fn variable(&self, x: &Ident) -> (Option<TokenStream>, Ident) {
        if self.stride() == 2 && self.highest() > 1 {
            let square = local("s");
            (Some(quote!(let #square = #x * #x;)), square)
        } else {
            (None, x.clone())
        }
    }

    pub(super) fn largest_gap(&self) -> u32 {
        self.exponents.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(0)
    }

    fn is_low(&self) -> bool {
        let highest = self.highest();
        highest <= 8 || (self.stride() == 1 && self.largest_gap() <= 2 && highest <= 16)
    }

    fn is_low_in_square(&self) -> bool {
        self.stride() == 2 && self.largest_gap() <= 4 && self.highest() <= 24
    }

    /// The coefficients of all powers from `from` in steps of the stride, zero where there is no summand.
    pub(super) fn dense(
        &self,
        from: u32,
        sum: &PowerSum,
        coefficients: &Coefficients<'_>,
        names: &Names<'_>,
    ) -> Vec<TokenStream> {
        let constant = names.constant();
        let step = usize::try_from(self.stride()).unwrap_or(1);
        (from..=self.highest())
            .step_by(step)
            .map(|power| match self.exponents.iter().position(|&exponent| exponent == power) {
                Some(index) => {
                    let summand = &sum.summands[index];
                    coefficients.times(summand.term, &summand.weight)
                }
                None => quote!(#constant(0.0f64)),
            })
            .collect()
    }
}

/// The value of the sum at `x`, with one rounding besides those of the coefficients.
pub(super) fn value(
    sum: &PowerSum,
    x: &Ident,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> Counted {
    let Some(whole) = Whole::of(sum).filter(|whole| whole.is_low() || whole.is_low_in_square()) else {
        return by_powers("power_sum", sum, x, coefficients, names).into();
    };
    let (lowest, stride) = (whole.lowest(), whole.stride());
    let dense = whole.dense(lowest, sum, coefficients, names);
    let steps = (whole.highest() - lowest) / stride;
    // r² and an odd factor, besides the steps and the lowest power.
    let (function, beside) =
        if stride == 2 { ("precise_even_sum", 1 + lowest % 2) } else { ("precise_sum", 0) };
    let function = names.generated(function);
    Counted {
        code: quote!(#function(#x, #lowest, [#(#dense),*])),
        operations: Operations::in_double_words(steps + lowest / stride + beside, steps),
    }
}

/// The value of the sum at `x` in the cheapest form with an error below 4 ε.
pub(super) fn quick_value(
    sum: &PowerSum,
    x: &Ident,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> Counted {
    let code = match Whole::of(sum) {
        Some(whole) if whole.is_low() => horner(sum, &whole, x, coefficients),
        Some(whole) if whole.is_low_in_square() => {
            let odd = whole.lowest() % 2;
            let (even_sum, dense) = (names.generated("even_sum"), whole.dense(odd, sum, coefficients, names));
            let even = quote!(#even_sum(#x, [#(#dense),*]));
            if odd == 1 { quote!(#even * #x) } else { even }
        }
        _ => by_powers("quick_power_sum", sum, x, coefficients, names),
    };
    code.into()
}

/// Horner's rule with every power written as repeated multiplication, so that nothing overflows before the result.
fn horner(sum: &PowerSum, whole: &Whole, x: &Ident, coefficients: &Coefficients<'_>) -> TokenStream {
    let (square, variable) = whole.variable(x);
    let nested = nested(sum, whole, &variable, coefficients);
    let lowest = whole.lowest();
    let factors = (0..lowest / whole.stride()).map(|_| &variable);
    let odd = (lowest % whole.stride() == 1).then(|| quote!(* #x));
    quote!(#square (#nested) #(* #factors)* #odd)
}

/// Horner's rule for the sum divided by its lowest power; a leading coefficient of 1 takes no multiplication.
pub(super) fn nested(
    sum: &PowerSum,
    whole: &Whole,
    variable: &Ident,
    coefficients: &Coefficients<'_>,
) -> TokenStream {
    let mut nested = TokenStream::new();
    let mut above: Option<u32> = None;
    let mut is_one = false;
    for (summand, &exponent) in sum.summands.iter().zip(&whole.exponents).rev() {
        let own = coefficients.times(summand.term, &summand.weight);
        nested = match above {
            None => {
                is_one = coefficients.constant(summand).is_some_and(|value| value.is_one());
                own
            }
            Some(above) => {
                let steps = (above - exponent) / whole.stride();
                let further = (1..steps).map(|_| variable);
                let first = (!core::mem::take(&mut is_one)).then(|| quote!((#nested) *));
                quote!(#own + #first #variable #(* #further)*)
            }
        };
        above = Some(exponent);
    }
    nested
}

fn by_powers(
    function: &str,
    sum: &PowerSum,
    x: &Ident,
    coefficients: &Coefficients<'_>,
    names: &Names<'_>,
) -> TokenStream {
    let (power_sum, pairs) = (names.generated(function), pairs(sum, coefficients, names));
    quote!(#power_sum(#x, [#(#pairs),*]))
}

/// The sum as pairs (coefficient, exponent).
pub(super) fn pairs(sum: &PowerSum, coefficients: &Coefficients<'_>, names: &Names<'_>) -> Vec<TokenStream> {
    let pair = |summand: &Summand| {
        let coefficient = coefficients.times(summand.term, &summand.weight);
        let exponent = exponent(&summand.exponent, names);
        quote!((#coefficient, #exponent))
    };
    sum.summands.iter().map(pair).collect()
}

/// An exponent of which nothing is rounded, in any format.
pub(super) fn exponent(exponent: &Rational, names: &Names<'_>) -> TokenStream {
    let of = names.generated("Exponent");
    let whole = exponent.floor();
    let fraction = exponent - &whole;
    let whole = Literal::i32_unsuffixed(whole.to_i32().unwrap_or(0));
    if fraction.is_zero() {
        return quote!(#of::whole(#whole));
    }
    let nearest = fraction.to_f64().and_then(Rational::from_float).unwrap_or_else(Rational::zero);
    let rest = &fraction - nearest;
    let (size, sign) = (literal(&rest.abs()), rest.is_negative().then(|| quote!(-)));
    let fraction = literal(&fraction);
    quote!(#of::in_parts(#whole, #fraction, #sign #size))
}
