//! [`Gap`] -> the terms of J in units of its own: if fields set only these units, one table holds all radii.
//!
//! Let ℓ be the radius at which the first two terms of J = Σ j a^p have the same size. With x = a/ℓ and J in units of
//! j₁ ℓ^p₁,
//!
//! ```text
//! J = x^p₁ ± x^p₂ + Σ κ x^p,    κ = (j/j₁) |j₂/j₁|^(−(p − p₁)/(p₂ − p₁))
//! ```
//!
//! Two terms have no κ at all. With more terms, κ is a number for gaps such as that of a ball, whatever its radius is,
//! and for a gap that is multiplied by a field.
//!
//! **Signs.** A table is for one sign of each term. If the sign of the second of two terms is not certain, the table
//! takes the one for positive fields: `c * r^2 - d * r^4` has a table for an oblate gap. Other values have no table.

use crate::closed_forms::{PowerSum, Summand};
use crate::gap::Gap;
use crate::gap::coefficient::{Coefficient, Sign};
use crate::number::integer;

/// 1, ±1 and every κ; none if one of them depends on fields, or may have another sign.
pub(crate) fn factors(gap: &Gap, load_integral: &PowerSum) -> Option<Vec<f64>> {
    let [first, second, others @ ..] = load_integral.summands.as_slice() else { return None };
    if others.is_empty() {
        let [first, second] = [first, second].map(|summand| summand.coefficient(gap).usual_sign());
        let is_oblate = first == Some(Sign::NotNegative) && second == Some(Sign::NotPositive);
        return Some(vec![1.0, if is_oblate { -1.0 } else { 1.0 }]);
    }
    let per_first = first.coefficient(gap).power(&integer(-1)).ok()?;
    let over_first = |summand: &Summand| with_sign(summand.coefficient(gap).multiply(&per_first));
    let (sign, of_second) = over_first(second)?;
    let mut factors = vec![1.0, sign];
    for summand in others {
        let order = (&summand.exponent - &first.exponent) / (&second.exponent - &first.exponent);
        let (above, below) = (integer(order.numer().clone()), integer(order.denom().clone()));
        let (sign, ratio) = over_first(summand)?;
        let power = ratio.power(&below).ok()?.multiply(&of_second.power(&-above).ok()?);
        factors.push(sign * power.as_constant()?.to_f64().powf(below.recip().to_f64()));
    }
    Some(factors)
}

/// The certain sign of a coefficient, and its size.
fn with_sign(value: Coefficient) -> Option<(f64, Coefficient)> {
    Some(match value.certain_sign()? {
        Sign::NotNegative => (1.0, value),
        Sign::NotPositive => (-1.0, value.negated()),
    })
}
