//! δ₀′ and drops of the load integral at many radii, which a memory integral asks for at its nodes.
//!
//! **Sums of any real powers.** At the share ρ of the radius the load integral J(a) = Σ j, where the term j has the
//! power p, becomes Σ j ρ^p. With x = −ln ρ the drop is Σ j (1 − e^(−p x)), without cancellation, and, because
//! J′ = a⁴ δ₀′/2, δ₀′(ρ a) = Σ (2 p j/a⁵) e^(−(p−5) x). A relative error of x counts p x e^(−p x) times in a slope,
//! which is at most 0.37, and at most once in a drop. The powers at a are formed once for all radii; for each radius
//! one logarithm is left, and two exponentials for each term, in vector code.

use super::power::term_of_drop;
use crate::dispatch::half_wide;
use crate::numbers::exponent::Exponent;
use crate::numbers::exponential::{decay, loss};
use crate::numbers::logarithm::log_of_ratio;
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};

/// Above this power of the gap δ₀′ is corrected for the rounding of a radius, which r⁶⁴ multiplies by 64.
const HIGH_POWER: f64 = 24.0;

/// How many radii are taken at a time.
const BLOCK: usize = 32;

/// Radii below a, and their depths below it: one of each pair is rounded. Slices of the same length.
pub(super) type Places<'a, T> = (&'a [T], &'a [T]);

/// δ₀′ at these places, and J(a) less J there. Slices of the same length.
pub(super) type SlopesAndDrops<'a, T> = (&'a mut [T], &'a mut [T]);

/// The slopes and drops of any profile, by its functions of one radius.
#[inline(always)]
pub(crate) fn fill_one_by_one<T: Scalar, P: GapProfile<T> + ?Sized>(
    profile: &P,
    a: T,
    places: Places<'_, T>,
    values: SlopesAndDrops<'_, T>,
) {
    let slope = |s: T| profile.quick_approach_slope(s);
    fill_by_functions(profile, a, places, values, slope, |depth| profile.load_integral_drop(a, depth));
}

/// The slopes and drops of a profile, the slopes by a function of the radius and the drops by one of the depth.
#[inline(always)]
pub fn fill_by_functions<T: Scalar, P: GapProfile<T> + ?Sized>(
    profile: &P,
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    slope: impl Fn(T) -> T,
    drop: impl Fn(T) -> T,
) {
    let values = slopes.iter_mut().zip(&mut *drops);
    for ((slope_there, drop_there), (&radius, &depth)) in values.zip(radii.iter().zip(depths)) {
        *slope_there = slope(radius);
        *drop_there = drop(depth);
    }
    if profile.highest_exponent() > T::constant(HIGH_POWER) {
        for ((slope_there, &radius), &depth) in slopes.iter_mut().zip(radii).zip(depths) {
            // The difference over a short step inwards stands for the derivative: the share of the correction by which
            // it is off, up to 64/4096, is far from counting.
            let (rounding, step) = ((a - radius) - depth, radius * T::constant(1.0 / 4096.0));
            *slope_there += (*slope_there - slope(radius - step)) * (rounding / step);
        }
    }
}

/// The slopes and drops of a profile whose load integral is Σ c aᵖ over the terms (c, p).
#[inline(always)]
pub fn fill_slopes_and_drops<T: Scalar, P: GapProfile<T> + ?Sized>(
    profile: &P,
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    terms: impl IntoIterator<Item = (T, Exponent<T>), IntoIter: Clone>,
) {
    // The bits of a number with derivatives do not give its logarithm.
    if !has_no_derivatives::<T>() {
        return fill_one_by_one(profile, a, (radii, depths), (slopes, drops));
    }
    let terms = terms.into_iter().map(|(c, p)| (term_of_drop(c, a, p), p.value()));
    let places = radii.chunks(BLOCK).zip(depths.chunks(BLOCK));
    let values = slopes.chunks_mut(BLOCK).zip(drops.chunks_mut(BLOCK));
    for ((radii, depths), (slopes, drops)) in places.zip(values) {
        half_wide(
            #[inline(always)]
            || fill_block(a, (radii, depths), (slopes, drops), terms.clone()),
        );
    }
}

#[inline(always)]
fn fill_block<T: Scalar>(
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    terms: impl Iterator<Item = (T, T)>,
) {
    let mut shrinkings = [T::zero(); BLOCK];
    for ((x, &radius), &depth) in shrinkings.iter_mut().zip(radii).zip(depths) {
        *x = -log_of_ratio(radius / a, depth / a);
    }
    slopes.fill(T::zero());
    drops.fill(T::zero());
    let (two, five, square) = (T::constant(2.0), T::constant(5.0), a * a);
    for (j, p) in terms {
        // a⁵ need not be in range.
        let slope = two * p * (j / square / square) / a;
        for ((&x, slopes), drops) in shrinkings.iter().zip(&mut *slopes).zip(&mut *drops) {
            *slopes += slope * decay((p - five) * x);
            *drops += j * loss(p * x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Polynomial;
    use crate::worse::worse;

    /// The largest errors of slopes and drops, in units of ε, relative to the functions of one radius.
    fn largest_errors<T: Scalar>(terms: &[(f64, f64)], a: f64) -> Option<[f64; 2]> {
        let terms: Vec<(T, T)> = terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))).collect();
        let (profile, a) = (Polynomial::new(terms).ok()?, T::constant(a));
        let depths: Vec<T> = (0..300).map(|k| a * T::constant(0.95 * 0.9_f64.powi(k))).collect();
        let radii: Vec<T> = depths.iter().map(|&depth| a - depth).collect();
        let (mut slopes, mut drops) = (vec![T::zero(); 300], vec![T::zero(); 300]);
        profile.fill_slopes_and_drops(a, (&radii, &depths), (&mut slopes, &mut drops));
        let error = |value: T, exact: T| ((value - exact) / (exact * T::default_epsilon())).value().abs();
        let of_slopes = slopes.iter().zip(&radii).map(|(&slope, &s)| {
            // What counts is an integral over s, to which s δ₀′ is the contribution.
            error(slope, profile.approach_slope(s)) * (s * slope / (a * slopes[299])).value()
        });
        let of_drops = drops
            .iter()
            .zip(&depths)
            .map(|(&drop, &depth)| error(drop, profile.load_integral_drop(a, depth)));
        Some([of_slopes.fold(0.0, worse), of_drops.fold(0.0, worse)])
    }

    #[test]
    fn many_radii_at_once_are_each_alone() {
        for terms in
            [&[(0.02, 2.2)][..], &[(0.02, 1.5), (1e-4, 3.25)], &[(0.1, 0.3), (0.02, 2.0), (1e-6, 16.0)]]
        {
            for a in [0.07, 1.0, 6.3] {
                for errors in [largest_errors::<f64>(terms, a), largest_errors::<f32>(terms, a)] {
                    assert!(
                        errors.is_some_and(|[slope, drop]| slope < 6.0 && drop < 4.0),
                        "{terms:?}: {errors:?}"
                    );
                }
            }
        }
    }
}
