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
//! over the radius it would have the square root of a zero. Panels keep their distance from where Y, continued
//! backwards, reaches zero.
//!
//! The other singularities are where δ₀′ vanishes in the plane of complex radii. Where one is near, s changes so fast
//! that its values at the nodes show it; the finest rule and shorter panels follow. Next to it, panels of √ε/16 of the
//! stretch are short enough: over one of them s changes like a cube root at worst, by 1e-3 in f64, of which 24 nodes
//! miss 2e-4, and all that times the length is ε. Nothing shorter can be told from the rounding of s.

use super::Increment;
use super::quadrature::Rule;
use super::stretch::Stretch;
use crate::load::Load;
use crate::{GapProfile, Scalar};

/// How often panels are halved at most. A geometry of a user's own may have radii that no panel resolves.
const MOST_HALVINGS: u32 = 256;

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

    // The radius at an age, and the integrand without {s² − low², 1}.
    let at = |x: T| {
        let deficit = x * (rate + half * rise * x) / stiffness;
        let s = contact.radius_of(final_integral - deficit).unwrap_or(low).max(low);
        let square = s * s;
        (s, two * (rate + rise * x) / (stiffness * square * square) * (-x).exp())
    };

    let mut sum = Increment::zero();
    // The age of the rounded radius, at which the stretch ends.
    let mut start = chi * stretch.age_at(T::zero());
    let mut length = longest - start;
    let shortest = length * T::default_epsilon().sqrt() * T::constant(1.0 / 16.0);
    let (mut is_simple, mut halvings) = (true, 0);
    // Beyond two panels' worth of e-foldings nothing counts any more.
    while start < longest && start < most + most {
        // The finest rule reaches full accuracy on panels of 0.85 of the distance to a singularity.
        let density = T::one() + most / ((singular - start) * T::constant(0.85));
        length = length.min(most / density);
        let end = if start + length < longest { start + length } else { longest };
        let rule = if is_simple { Rule::for_folds(density * (end - start)) } else { Rule::FINEST };
        let (increment, is_resolved) = increment_of_panel(rule, (start, end), low, at);
        if is_resolved || length <= shortest || halvings >= MOST_HALVINGS {
            sum = sum.plus(increment);
            start = end;
            length += length;
        } else if is_simple {
            is_simple = false;
        } else {
            length *= half;
            halvings += 1;
        }
    }
    sum
}

/// The increment by a rule between two ages, and whether the rule resolves the radius.
fn increment_of_panel<T: Scalar>(
    rule: Rule,
    (start, end): (T, T),
    low: T,
    at: impl Fn(T) -> (T, T),
) -> (Increment<T>, bool) {
    let mut sum = Increment::zero();
    let mut coefficients = (T::zero(), T::zero());
    let mut size = T::zero();
    for ((ages, weight), (first, highest)) in rule.pairs(start, end).zip(rule.coefficients()) {
        let [later, earlier] = ages.map(|age| {
            let (s, density) = at(age);
            sum.add(weight * density, s, low);
            s
        });
        let difference = earlier - later;
        size = earlier;
        coefficients.0 += T::constant(first) * difference;
        coefficients.1 += T::constant(highest) * difference;
    }
    let is_resolved = rule.resolves(coefficients.0 / size, coefficients.1 / size, (-start).exp());
    (sum, is_resolved)
}
