//! The contact radius from the leading term where powers are any numbers.
//!
//! The start is that of [`leading_term`](super::leading_term), and terms are multiplied by the power of two that puts y
//! between 1 and 2.

use super::halley::Target;
use super::leading_term::{MORE_STEPS, Spread, Start, logarithm_alone};
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::evaluate::steepness::Steepness;
use crate::numbers::bits::{exponent, fraction, is_normal, log2_digits, power_of_two};
use crate::numbers::exponent::Exponent;
use crate::scalar::{greater, has_no_derivatives, is_same, lesser};

/// The highest power for which single precision has enough digits.
const HIGHEST_SINGLE_POWER: f64 = 110.0;

/// The radius at which Σ j a^p is `load_integral`, for any powers, from the pairs (j, p). Two functions evaluate J
/// times a factor at a, one for the last step and one for those before.
///
/// None beyond `limit`, where the steps have not come near, with negative terms, and for scalars other than f32 and
/// f64.
#[inline(always)]
pub fn radius_of_real_powers<T: Scalar>(
    load_integral: T,
    limit: T,
    terms: impl Iterator<Item = (T, Exponent<T>)>,
    evaluate: impl Fn(T, T) -> Steepness<T>,
    evaluate_at_last: impl Fn(T, T) -> Steepness<T>,
) -> Option<T> {
    if !has_no_derivatives::<T>() {
        return None;
    }
    let logarithm_of_y = log2_digits(load_integral);
    let (mut lowest, mut highest, mut least, mut are_positive) =
        (T::infinity(), T::zero(), T::infinity(), true);
    for (j, p) in terms {
        let p = p.value();
        lowest = lesser(lowest, p);
        highest = greater(highest, p);
        are_positive &= j >= T::zero();
        // The bits of zero would give the logarithm of a positive number.
        if !j.is_zero() {
            least = lesser(least, logarithm_alone(logarithm_of_y, (j, p)));
        }
    }
    let start = Start::of(lowest, least);
    let exponent = exponent(load_integral);
    let fits = is_normal::<T>(exponent) & is_normal::<T>(-exponent) & is_normal::<T>(start.octave);
    let is_within = is_same::<T, f64>() || highest <= T::constant(HIGHEST_SINGLE_POWER);
    if !(are_positive & fits & is_within) {
        return None;
    }
    let (y, scale) = (fraction(load_integral), power_of_two(-exponent));
    let spread = Spread { lowest, highest };
    let attempt = |more: u32| {
        spread.radius(
            more,
            y,
            start.fraction * power_of_two(start.octave),
            #[inline(always)]
            |a| evaluate(a, scale),
            #[inline(always)]
            |a| evaluate_at_last(a, scale).halley(a, Target::of(y)),
        )
    };
    let found = |(radius, is_near): (T, bool)| (is_near & (radius <= limit)).then_some(radius);
    match found(attempt(0)) {
        None => out_of_line(|| found(attempt(MORE_STEPS))),
        first => first,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::steepness::{plain_power_sum_steepness, scaled_power_sum_steepness};

    /// Not only right, which the general solution would be as well, but found here.
    #[test]
    fn radii_of_equal_terms_are_found() {
        for count in 2..=10 {
            let powers = (0..count).map(|k| 5.3 + 0.7 * f64::from(k));
            let terms = || powers.clone().map(|p| (1.0, Exponent::of(p)));
            for k in 0..400 {
                let planted = 0.2 * 1.008_f64.powi(k);
                let target = powers.clone().map(|p| planted.powf(p)).sum::<f64>();
                let found = radius_of_real_powers(
                    target,
                    f64::INFINITY,
                    terms(),
                    |a, scale| plain_power_sum_steepness(a, scale, terms()),
                    |a, scale| scaled_power_sum_steepness(a, scale, terms()),
                );
                // The test rounds the terms, and their sum up to nine times; p divides these errors.
                let is_near = |found: f64| (found / planted - 1.0).abs() < 3.0 * f64::EPSILON;
                assert!(found.is_some_and(is_near), "{count}, {planted}: {found:?}");
            }
        }
    }
}
