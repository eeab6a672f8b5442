//! Many radii below a known one, from how much less the load integral is there.
//!
//! Some profiles have no vector code for radii, but all have it for slopes and drops, or nearly. Newton's method solves
//! for the depths below the known radius, many at once. On logarithms, in which J is nearly linear, its step is
//!
//! ```text
//! depth ← depth + (J/J′) ln(J/y),    ln(J/y) = 2 (J − y)/(J + y) + O((J − y)³)
//! ```
//!
//! It leaves (v/p − 1)/2 times the square of the error, which is a share of the radius, and about p²/12 times its cube; v
//! is the variance of the powers of J about their mean p. They are between 4 and the highest power q, so that v is below
//! p q, and that factor smaller than q/2. The start takes J for the power that it is at the known radius; two steps
//! usually suffice.

use super::degree::degree_of_load_integral;
use crate::dispatch::wide;
use crate::numbers::exponential::loss;
use crate::numbers::logarithm::log_of_ratio;
use crate::{GapProfile, Scalar};

/// How many radii are solved for at once.
const BLOCK: usize = 32;

/// Where δ₀′ nearly vanishes, more steps than these would be needed.
const MOST_STEPS: usize = 8;

/// Replaces every drop by the radius at which J is less than at `edge` by so much. False if the steps have not come near
/// all of them; what is in the places then means nothing.
pub(super) fn replace_drops_by_radii<T: Scalar, P: GapProfile<T>>(
    profile: &P,
    edge: T,
    drops: &mut [T],
) -> bool {
    let load_integral = profile.quick_load_integral(edge);
    let power = degree_of_load_integral(profile, edge, load_integral);
    drops.chunks_mut(BLOCK).all(|drops| {
        wide(
            #[inline(always)]
            || Depths::near(edge, (load_integral, power), drops).solve(profile, drops),
        )
    })
}

/// A number for every radius of a block.
type PerRadius<T> = [T; BLOCK];

/// Radii on the way to where J is less than at the edge by given drops.
struct Depths<T> {
    edge: T,
    /// J(edge).
    load_integral: T,
    radii: PerRadius<T>,
    depths: PerRadius<T>,
}

impl<T: Scalar> Depths<T> {
    /// The start, as if J were a power.
    #[inline(always)]
    fn near(edge: T, (load_integral, power): (T, T), drops: &[T]) -> Self {
        let (one, none) = (T::one(), [T::zero(); BLOCK]);
        let mut start = Self { edge, load_integral, radii: none, depths: none };
        for ((radius, depth), &drop) in start.radii.iter_mut().zip(&mut start.depths).zip(drops) {
            // Rounding can make a drop negative.
            let share = (drop / load_integral).max(T::zero());
            *depth = edge * loss(-log_of_ratio(one - share, share) / power);
            *radius = edge - *depth;
        }
        start
    }

    /// Replaces the drops by their radii; false if the steps have not come near them.
    #[inline(always)]
    fn solve<P: GapProfile<T>>(mut self, profile: &P, drops: &mut [T]) -> bool {
        // q/2 times the square of this share is ε/2.
        let near =
            self.edge * (T::default_epsilon() / (profile.highest_exponent() + T::constant(4.0))).sqrt();
        for _ in 0..MOST_STEPS {
            if self.step(profile, drops) <= near {
                drops.copy_from_slice(&self.radii[..drops.len()]);
                return true;
            }
        }
        false
    }

    /// Takes one step, and returns the length of the longest, or infinity if one of them is not a number.
    #[inline(always)]
    fn step<P: GapProfile<T>>(&mut self, profile: &P, drops: &[T]) -> T {
        let (half, none) = (T::constant(0.5), [T::zero(); BLOCK]);
        let (mut slopes, mut drops_there) = (none, none);
        let count = ..drops.len();
        profile.fill_slopes_and_drops(
            self.edge,
            (&self.radii[count], &self.depths[count]),
            (&mut slopes[count], &mut drops_there[count]),
        );
        let mut longest = T::zero();
        let places = self.radii.iter_mut().zip(&mut self.depths).zip(drops);
        for (((radius, depth), &drop), (&slope, &drop_there)) in places.zip(slopes.iter().zip(&drops_there)) {
            let (target, there) = (self.load_integral - drop, self.load_integral - drop_there);
            let square = *radius * *radius;
            let steepness = square * square * slope * half;
            let step = (there / steepness) * ((drop_there - drop) / (half * (target + there)));
            *depth -= step;
            *radius = self.edge - *depth;
            // `max` would leave out NaN.
            longest = if step.abs() <= longest { longest } else { step.abs() };
        }
        longest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worse::worse;
    use crate::{Polynomial, ProfileError};

    /// The largest error of radii in units of ε, from the edge down to the share `lowest` of J.
    fn largest_error<T: Scalar>(terms: &[(f64, f64)], lowest: f64) -> Result<f64, ProfileError> {
        let terms: Vec<(T, T)> = terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))).collect();
        let (profile, edge) = (Polynomial::new(terms.as_slice())?, T::constant(6.5));
        let planted = (0..200).map(|k| edge * T::constant(lowest.powf(f64::from(k) / 199.0 / 6.0)));
        let planted: Vec<T> = planted.collect();
        let mut radii: Vec<T> = planted.iter().map(|&a| profile.load_integral_drop(edge, edge - a)).collect();
        assert!(replace_drops_by_radii(&profile, edge, &mut radii), "{terms:?}");
        let errors = planted.iter().zip(&radii).map(|(&a, &found)| ((found - a) / a).value().abs());
        Ok(errors.fold(0.0, worse) / T::default_epsilon().value())
    }

    #[test]
    fn radii_are_found() -> Result<(), ProfileError> {
        let gaps: [&[(f64, f64)]; 4] = [
            &[(0.025, 2.0), (1e-4, 4.0)],
            &[(0.02, 2.37), (0.001, 4.11), (1e-6, 7.3)],
            &[(0.025, 2.0), (-1e-4, 4.0), (1e-6, 6.0)],
            &[(0.3, 0.25), (1e-20, 24.0)],
        ];
        for terms in gaps {
            // A drop rounds a logarithm and an exponential.
            let (double, single) = (largest_error::<f64>(terms, 0.1)?, largest_error::<f32>(terms, 0.1)?);
            assert!(double < 2.0 && single < 2.0, "{terms:?}: {double}, {single}");
        }
        Ok(())
    }

    #[test]
    fn a_slope_that_vanishes_is_given_up() -> Result<(), ProfileError> {
        let end = 187.5_f64.sqrt();
        let oblate = Polynomial::new([(0.025, 2.0), (-1e-4, 4.0)])?;
        let load_integral = oblate.load_integral(end);
        assert!(!replace_drops_by_radii(&oblate, end, &mut [load_integral * 2.0]));
        assert!(!replace_drops_by_radii(&oblate, end, &mut [0.1 * load_integral, f64::NAN]));
        Ok(())
    }
}
