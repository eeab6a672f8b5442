//! e^(−x) and 1 − e^(−x) without branches and tables, for loops over many values that compile to vector code.
//!
//! They cost less than the exponential of a library, which cannot be compiled into the loop.
//!
//! e^(−x) = 2^(−n) e^g with n the integer nearest to x/ln 2 and g = n ln 2 − x, |g| ≤ ln 2/2. The high part of ln 2 has
//! so few digits that its multiples are exact and cancel x without rounding. The Taylor series of e^g leaves out less
//! than 7e-18 after g¹³, and less than 2e-11 after g⁹ in single precision.

use super::bits::{nearest_integer, power_of_two};
use super::series::{four_terms, inverse_factorials};
use crate::Scalar;
use crate::scalar::{derivatives, has_no_derivatives, is_same, of_values};

/// e^(−x) for x above −700, or −80 in single precision, within ε. Beyond 700, or 80, the result is 0.
#[inline(always)]
pub(crate) fn decay<T: Scalar>(x: T) -> T {
    if !has_no_derivatives::<T>() {
        return value_of_decay(x) * (T::one() - loss_of_derivatives(x));
    }
    let (gain, power) = reduced(x);
    if x > T::constant(longest::<T>()) { T::zero() } else { power + gain }
}

/// 1 − e^(−x) for x ≥ 0 within 1.5 ε, also where x is small.
#[inline(always)]
pub(crate) fn loss<T: Scalar>(x: T) -> T {
    if !has_no_derivatives::<T>() {
        return of_values([x], |[x]| loss(x), |[x]| loss(x)) + value_of_decay(x) * loss_of_derivatives(x);
    }
    let (gain, power) = reduced(x);
    // For n = 0 the difference is exact; for n ≥ 1 the result is at least 1 − 1/√2 = 0.29, so that nothing cancels.
    if x > T::constant(longest::<T>()) { T::one() } else { (T::one() - power) - gain }
}

/// The value of [`decay`], without derivatives.
#[inline(always)]
fn value_of_decay<T: Scalar>(x: T) -> T {
    of_values([x], |[x]| decay(x), |[x]| decay(x))
}

/// 1 − e^(−d) of what x has beside its value: derivatives, of which the fourth power vanishes. A library's exponential is
/// not only slower, but is slowed down itself by the vectors around it.
#[inline(always)]
fn loss_of_derivatives<T: Scalar>(x: T) -> T {
    let (d, one) = (derivatives(x), T::one());
    let (half, third) = (T::constant(0.5), T::constant(1.0 / 3.0));
    d * (one - half * d * (one - third * d))
}

/// 2^(−n) (e^g − 1) and 2^(−n).
#[inline(always)]
fn reduced<T: Scalar>(x: T) -> (T, T) {
    let is_single = is_same::<T, f32>();
    let Reduction { ln_2_high, ln_2_low, .. } = if is_single { SINGLE } else { DOUBLE };
    let (n, octaves) = nearest_integer(x * T::constant(core::f64::consts::LOG2_E));
    let g = (n * T::constant(ln_2_high) - x) + n * T::constant(ln_2_low);
    let square = g * g;
    let row = |k: usize| four_terms(&TAYLOR[k], g, square);
    let fourth = square * square;
    let mut sum = row(0) + fourth * row(1);
    if !is_single {
        sum += (fourth * fourth) * row(2);
    }
    // The largest terms come last, and only they round. The power multiplies each of them early, which rounds none and
    // leaves one product less to wait for.
    let power: T = power_of_two(-octaves);
    (power * g + (power * square) * sum, power)
}

/// The largest x for which anything is left: what is added to a power of two may be subnormal from there on.
#[inline(always)]
fn longest<T: Scalar>() -> f64 {
    if is_same::<T, f32>() { SINGLE.longest } else { DOUBLE.longest }
}

/// The largest x, and ln 2 in two parts.
struct Reduction {
    longest: f64,
    ln_2_high: f64,
    ln_2_low: f64,
}

/// The high part has 21 digits fewer than f64, and its multiples go up to 1022.
const DOUBLE: Reduction =
    Reduction { longest: 700.0, ln_2_high: 0.693_147_180_369_123_8, ln_2_low: 1.908_214_929_270_587_7e-10 };
/// The high part has 9 digits fewer than f32, and its multiples go up to 126.
const SINGLE: Reduction =
    Reduction { longest: 80.0, ln_2_high: 0.693_145_751_953_125, ln_2_low: 1.428_606_820_309_417_3e-6 };

/// 1/k! from k = 2 on.
const TAYLOR: [[f64; 4]; 3] = inverse_factorials(2);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_is_the_exponential() {
        for k in -10_000..=200_000 {
            let (x, single) = (700.0 / 2e5 * f64::from(k), 80.0 / 2e5 * k as f32);
            let error = (decay(x) - (-x).exp()) / (-x).exp();
            assert!(error.abs() <= f64::EPSILON, "{x}: {error}");
            let exact = (-f64::from(single)).exp();
            let error = (f64::from(decay(single)) - exact) / exact;
            assert!(error.abs() <= 0.75 * f64::from(f32::EPSILON), "{single}: {error}");
        }
    }

    #[test]
    fn nothing_is_left_of_what_is_too_old() {
        assert_eq!((decay(0.0_f64), decay(0.0_f32)), (1.0, 1.0));
        assert_eq!((decay(1e300_f64), decay(1e30_f32)), (0.0, 0.0));
        assert_eq!((decay(f64::INFINITY), decay(f32::INFINITY)), (0.0, 0.0));
        assert!(decay(f64::NAN).is_nan() && decay(f32::NAN).is_nan());
        assert!(decay(700.0_f64) > 0.0 && decay(80.0_f32) > 0.0);
    }

    #[test]
    fn what_is_lost_is_what_is_not_left() {
        for k in 0..=200_000 {
            // Over all sizes from 1e-18 to 1e3.
            let x = 10f64.powf(f64::from(k) * 21.0 / 2e5 - 18.0);
            let error = (loss(x) + (-x).exp_m1()) / (-x).exp_m1();
            assert!(error.abs() <= 1.5 * f64::EPSILON, "{x}: {error}");
            let exact = -(-f64::from(x as f32)).exp_m1();
            let error = (f64::from(loss(x as f32)) - exact) / exact;
            assert!(error.abs() <= 1.5 * f64::from(f32::EPSILON), "{x}: {error}");
        }
        assert_eq!((loss(0.0_f64), loss(f64::INFINITY), loss(f32::INFINITY)), (0.0, 1.0, 1.0));
    }
}
