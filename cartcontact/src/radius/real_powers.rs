//! The contact radius from the leading term where powers are any numbers.
//!
//! The start is that of [`leading_term`](super::leading_term), and terms are multiplied by the power of two that puts y
//! between 1 and 2.

use super::halley::{Target, radius_from_root};
use super::leading_term::{MORE_STEPS, Spread, Start, logarithm_alone};
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::evaluate::steepness::Steepness;
use crate::numbers::bits::{exponent, fraction, is_normal, log2_digits, power_of_two};
use crate::numbers::exponent::Exponent;
use crate::scalar::{greater, is_single, lesser};

/// The highest powers for which single and double precision hold (p J)². From where the lowest power leads, which is
/// above 4, the first step may go to 1.41 and 1.53 times the radius; there J is 10¹⁵ and 10¹¹¹ times as large. If a step
/// of Halley's overflowed, it would be zero, as it is at the radius.
const HIGHEST_SINGLE_POWER: f64 = 100.0;
const HIGHEST_DOUBLE_POWER: f64 = 600.0;

/// The radius at which Σ j a^p is `load_integral`, for any powers, from the pairs (j, p). Two functions evaluate J
/// times a factor at a, one for the last step and one for those before.
///
/// None beyond `limit`, where the steps have not come near, and with negative terms.
#[inline(always)]
pub fn radius_of_real_powers<T: Scalar>(
    load_integral: T,
    limit: T,
    terms: impl Iterator<Item = (T, Exponent<T>)>,
    evaluate: impl Fn(T, T) -> Steepness<T>,
    evaluate_at_last: impl Fn(T, T) -> Steepness<T>,
) -> Option<T> {
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
    let most = if is_single::<T>() { HIGHEST_SINGLE_POWER } else { HIGHEST_DOUBLE_POWER };
    if !(are_positive & fits & (highest <= T::constant(most))) {
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
            |a| {
                radius_from_root::<_, 1>(
                    a,
                    Target::of(y),
                    #[inline(always)]
                    |a| evaluate_at_last(a, scale),
                )
            },
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

    fn beside<T: Scalar>(powers: [f64; 2], target: f64) -> Option<T> {
        let [low, high] = powers.map(|p| Exponent::of(T::constant(p)));
        let terms = || [(T::constant(0.25), low), (T::constant(2e-4), high)].into_iter();
        radius_of_real_powers(
            T::constant(target),
            T::infinity(),
            terms(),
            |a, scale| plain_power_sum_steepness(a, scale, terms()),
            |a, scale| scaled_power_sum_steepness(a, scale, terms()),
        )
    }

    /// In a band of load integrals the step from the low power goes far beyond the radius.
    #[test]
    fn radii_beside_high_powers_are_right_or_left_to_others() {
        for powers in
            [[4.001, 100.0], [4.001, 109.5], [4.001, 600.0], [5.0, 600.0], [5.0, 850.0], [5.0, 1028.0]]
        {
            for k in 0..4000 {
                let target = 10_f64.powf(0.005 * f64::from(k) - 10.0);
                let is_right = |found: f64, bound: f64| {
                    let value = 0.25 * found.powf(powers[0]) + 2e-4 * found.powf(powers[1]);
                    (value / target - 1.0).abs() < bound
                };
                let (double, single) = (beside::<f64>(powers, target), beside::<f32>(powers, target));
                assert!(
                    double.is_none_or(|found| is_right(found, 1e-11)),
                    "{powers:?}, {target:e}: {double:?}"
                );
                let single = single.map(f64::from);
                assert!(
                    single.is_none_or(|found| is_right(found, 1e-4)),
                    "{powers:?}, {target:e}: {single:?}"
                );
            }
        }
    }

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
