//! The memory integrals over time, along a straight falling load.
//!
//! With z = end − τ the hereditary load is below its final value by Y′ z − χ F′ z²/2, and
//! δ₀′ ds = 2 dY/((π m/4) s⁴) turns the integrals over s into
//!
//! ```text
//! (8/(π m)) ∫ (Y′ − χ F′ z) e^(−χ z) {s² − low², 1} / s⁴ · dz
//! ```
//!
//! with s from the inverse of J. The integrand stays smooth where the load falls as fast as e^(−χ t), Y′ = 0;
//! over the radius it would have the square root of a zero. Its only singularity is where Y, continued
//! backwards, reaches zero, and panels keep their distance from it.

use super::Increment;
use super::quadrature::{Continuation, Rule, digits};
use super::stretch::Stretch;
use crate::load::Load;
use crate::{GapProfile, Scalar};

pub(super) fn increment<T, P, L>(stretch: &Stretch<'_, T, P, L>, rate: T, load_rate: T) -> Increment<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let (contact, chi, low) = (stretch.contact, stretch.contact.medium().chi(), stretch.low);
    let (half, two) = (T::constant(0.5), T::constant(2.0));
    let stiffness = contact.stiffness();
    let final_integral = contact.profile().load_integral(stretch.high) + stretch.surplus / stiffness;
    let rise = -(chi * load_rate);
    let longest = stretch.age_at(stretch.high - low);
    // Where Y′ z + χ |F′| z²/2 = Y.
    let singular = {
        let hereditary = stiffness * final_integral;
        let zero = two * hereditary / (rate + (rate * rate + two * rise * hereditary).sqrt());
        // Y > 0 throughout the stretch; rounding must not turn that round, or panels would shrink to nothing.
        zero.max(longest * (T::one() + T::default_epsilon().sqrt()))
    };
    let digits = digits::<T>();

    let mut sum = Increment::zero();
    // The age of the rounded radius, at which the stretch ends.
    let mut start = stretch.age_at(T::zero());
    // What is older than `digits` counts for nothing. A panel spans 22 e-foldings, or half of the way to the
    // singularity, of which √ε lies beyond the stretch: two, or ½ log₂(1/ε), are the most there can be.
    while start < longest && chi * start < digits {
        let growth = digits * T::constant(1.0 / 3.0);
        // An ellipse of this height around the first half of the way to a point on the axis leaves it outside.
        let clearance = (singular - start) * T::constant(0.38);
        let continuation = Continuation { extension: growth / chi, growth, clearance };
        let wanted = digits - chi * start;
        let (end, rule) = match continuation.rule(longest - start, wanted) {
            Some(rule) => (longest, rule),
            None => (longest.min(start + continuation.longest(wanted)), Rule::FINEST),
        };
        for (z, weight) in rule.nodes(start, end) {
            let deficit = z * (rate + half * rise * z) / stiffness;
            let s = contact.radius_of(final_integral - deficit).unwrap_or(low).max(low);
            let square = s * s;
            let growth = two * (rate + rise * z) / (stiffness * square * square);
            sum.add(weight * growth * (-(chi * z)).exp(), s, low);
        }
        start = end;
    }
    sum
}
