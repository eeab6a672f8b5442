//! [`Gap`] -> the terms of J in units of its own: where fields set no more than those, one table holds all radii.
//!
//! Let ℓ be the radius at which the first two terms of J = Σ j a^p are equal. With x = a/ℓ and J in units of j₁ ℓ^p₁,
//!
//! ```text
//! J = x^p₁ + x^p₂ + Σ κ x^p,    κ = (j/j₁) (j₂/j₁)^(−(p − p₁)/(p₂ − p₁))
//! ```
//!
//! Two terms have no κ at all. Of more, it is a number for gaps such as that of a ball, whatever its radius is, and of one
//! that is multiplied by a field.

use num_traits::ToPrimitive;

use crate::closed_forms::{Factor, PowerSum, Summand};
use crate::gap::Gap;
use crate::gap::coefficient::{Coefficient, Sign};
use crate::number::integer;

/// 1, 1 and every κ; none if one of them depends on fields, or is perhaps not positive.
pub(crate) fn factors(gap: &Gap, load_integral: &PowerSum) -> Option<Vec<f64>> {
    let [first, second, others @ ..] = load_integral.summands.as_slice() else { return None };
    let mut factors = vec![1.0, 1.0];
    if others.is_empty() {
        return Some(factors);
    }
    let per_first = coefficient(gap, first).power(&integer(-1)).ok()?;
    let over_first = |summand: &Summand| {
        let ratio = coefficient(gap, summand).multiply(&per_first);
        (ratio.certain_sign() == Some(Sign::NotNegative)).then_some(ratio)
    };
    let of_second = over_first(second)?;
    for summand in others {
        let order = (&summand.exponent - &first.exponent) / (&second.exponent - &first.exponent);
        let (above, below) = (integer(order.numer().clone()), integer(order.denom().clone()));
        let power = over_first(summand)?.power(&below).ok()?.multiply(&of_second.power(&-above).ok()?);
        factors.push(power.as_constant()?.to_f64()?.powf(below.recip().to_f64()?));
    }
    Some(factors)
}

/// j.
fn coefficient(gap: &Gap, summand: &Summand) -> Coefficient {
    match &summand.factor {
        Factor::Constant(value) => Coefficient::constant(value.clone()),
        Factor::Weight(weight) => gap.terms[summand.term].coefficient.scaled(weight),
    }
}
