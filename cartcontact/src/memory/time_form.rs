//! The memory integrals over time, along a straight falling load.
//!
//! With x = χ (end − τ) the hereditary load is below its final value by R x + G x²/2, where R = Y′/χ at the end and
//! G = −F′/χ are forces, and δ₀′ ds = 2 dY/((π m/4) s⁴) turns the integrals over s into
//!
//! ```text
//! (8/(π m)) ∫ (R + G x) e^(−x) {s² − low², 1} / s⁴ · dx
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
    let (rate, rise) = (rate / chi, -load_rate / chi);
    let final_integral = contact.profile().quick_load_integral(stretch.high) + stretch.surplus / stiffness;
    let longest = chi * stretch.age_at(stretch.high - low);
    // Where R x + G x²/2 = Y, in shares of Y: the squares of forces may be out of range.
    let singular = {
        let hereditary = stiffness * final_integral;
        let (rate, rise) = (rate / hereditary, rise / hereditary);
        let zero = two / (rate + (rate * rate + two * rise).sqrt());
        // Y > 0 throughout the stretch; rounding must not turn that round, or panels would shrink to nothing.
        zero.max(longest * (T::one() + T::default_epsilon().sqrt()))
    };
    let most = Rule::FINEST.folds::<T>();

    let mut sum = Increment::zero();
    // The age of the rounded radius, at which the stretch ends.
    let mut start = chi * stretch.age_at(T::zero());
    // Beyond two panels' worth of e-foldings nothing counts any more.
    while start < longest && start < most + most {
        // The finest rule reaches full accuracy on panels of 0.85 of the distance to a singularity.
        let density = T::one() + most / ((singular - start) * T::constant(0.85));
        let end = (start + most / density).min(longest);
        for (x, weight) in Rule::for_folds(density * (end - start)).nodes(start, end) {
            let deficit = x * (rate + half * rise * x) / stiffness;
            let s = contact.radius_of(final_integral - deficit).unwrap_or(low).max(low);
            let square = s * s;
            let growth = two * (rate + rise * x) / (stiffness * square * square);
            sum.add(weight * growth * (-x).exp(), s, low);
        }
        start = end;
    }
    sum
}
