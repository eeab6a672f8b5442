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
use super::quadrature::Rule;
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
    let most = Rule::FINEST.folds::<T>();

    let mut sum = Increment::zero();
    // The age of the rounded radius, at which the stretch ends.
    let mut start = stretch.age_at(T::zero());
    // Beyond two panels' worth of e-foldings nothing counts any more.
    while start < longest && chi * start < most + most {
        // The finest rule reaches full accuracy on panels of 0.85 of the distance to a singularity.
        let folds_per_time = chi + most / ((singular - start) * T::constant(0.85));
        let end = (start + most / folds_per_time).min(longest);
        for (z, weight) in Rule::for_folds(folds_per_time * (end - start)).nodes(start, end) {
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
