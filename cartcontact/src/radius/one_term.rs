//! The contact radius where the gap is one term, in closed form: Eq. (18).
//!
//! J(a) = j a^p = y has the root a = (y/j)^(1/p) with j = C n/((n+2)(n+4)) and p = n + 4. Powers of two are taken out
//! of y and C, with y/j = f · 2^e,
//!
//! ```text
//! a = 2^(k ⌊e/(k p)⌋) · (f · 2^(e mod k p))^(1/p)
//! ```
//!
//! so that nothing overflows before the result does, and a change of units by a power of two changes no digit; with
//! k = 1, 2 or 4 for p a multiple of 1/4 the reduced number is exact.
//!
//! **Accuracy.** The rounding errors of the quotient and of 1/p are put back into f. The error is that of `powf`, and
//! ε/(2 p) from the rounding of f.

use super::{beyond, needs_search};
use crate::Scalar;
use crate::evaluate::power;
use crate::evaluate::steepness::load_integral_coefficient;
use crate::numbers::binary::{divide, scale, split};
use crate::numbers::exponent::Exponent;
use crate::numbers::halved::product_with_few_digits;
use crate::profile::RadiusError;
use crate::scalar::floor;

/// The most octaves that the reduced number may have, so that it fits single precision.
const LONGEST_PERIOD: f64 = 100.0;

/// Solves J(a) = `target` on (0, `limit`] for the gap C r^n alone, whose exponent has few digits.
///
/// # Errors
///
/// [`RadiusError`] if `target` is negative or not finite, or exceeds J(`limit`).
#[inline]
pub fn invert_one_term<T: Scalar>(target: T, (c, n): (T, T), limit: T) -> Result<T, RadiusError> {
    if !needs_search(target, limit)? {
        return Ok(T::zero());
    }
    let radius = radius(target, c, n);
    if radius <= limit {
        return Ok(radius);
    }
    let p = n + T::constant(4.0);
    let largest = power::term(c * (n / ((n + T::constant(2.0)) * p)), limit, Exponent::of(p));
    // The root may round to just beyond the limit although the load integral does not exceed J(`limit`).
    if target <= largest { Ok(limit) } else { Err(beyond(target, largest, limit)) }
}

#[inline]
fn radius<T: Scalar>(target: T, c: T, n: T) -> T {
    let ((target, exponent_of_target), (c, exponent_of_c)) = (split(target), split(c));
    let (quotient, lost) = load_integral_coefficient(c, n).divide(target);
    let (quotient, exponent) = split(quotient);
    let p = n + T::constant(4.0);
    let multiple = whole_multiple(p);
    let period = p * T::constant(f64::from(multiple));
    let (periods, rest) = divide(exponent + exponent_of_target - exponent_of_c, period, period.recip());
    scale(root((quotient, lost), rest, p), multiple * periods)
}

/// The least k for which k p is whole and at most [`LONGEST_PERIOD`]; 1 if there is none.
#[inline]
fn whole_multiple<T: Scalar>(p: T) -> i32 {
    let is_whole = |k: i32| {
        let period = p * T::constant(f64::from(k));
        period <= T::constant(LONGEST_PERIOD) && period == T::constant(f64::from(floor(period)))
    };
    [1, 2, 4].into_iter().find(|&k| is_whole(k)).unwrap_or(1)
}

/// (f (1 + `lost`) · 2^`rest`)^(1/p) for 1 ≤ f < 2, and 0 ≤ `rest` < p or a whole `rest` up to [`LONGEST_PERIOD`].
#[inline]
fn root<T: Scalar>((f, lost): (T, T), rest: T, p: T) -> T {
    let inverse = p.recip();
    // (f 2^rest)^(1/p − inverse), whose logarithm needs only two digits: log₂ f ≈ f − 1 is off by less than 0.09.
    let (back, back_rest) = product_with_few_digits(inverse, p);
    let logarithm = T::ln_2() * (rest + (f - T::one()));
    let f = f + f * (lost + ((T::one() - back) - back_rest) * logarithm);
    let two = T::constant(2.0);
    if p > T::constant(LONGEST_PERIOD) {
        // 2^rest would not fit every format, so its root is taken separately.
        f.powf(inverse) * two.powf(rest * inverse)
    } else if rest == T::constant(f64::from(floor(rest))) {
        scale(f, floor(rest)).powf(inverse)
    } else {
        // Two roundings; divided by such a p hardly anything is left of them.
        (f * two.powf(rest)).powf(inverse)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_survive_quotients_out_of_range() {
        // J = C a⁶/12; only the exponents of 10 differ from an exact power: 1e600^(1/6) = 1e100.
        let root: f64 = radius(1e300, 12e-300, 2.0);
        assert!((root / 1e100 - 1.0).abs() < 1e-15, "{root:e}");
        let root: f64 = radius(1e-300, 12e300, 2.0);
        assert!((root / 1e-100 - 1.0).abs() < 1e-15, "{root:e}");
    }

    #[test]
    fn roots_scale_exactly_with_powers_of_two() {
        for n in [1.0, 2.0, 2.25, 2.5, 4.0, 5.75, 64.0] {
            let base: f64 = radius(0.7, 0.3, n);
            assert_eq!(radius(scale(0.7, (4.0 * (n + 4.0)) as i32), 0.3, n), 16.0 * base);
        }
    }

    /// Of these, 2^`rest` may leave the format.
    #[test]
    fn roots_of_high_powers_are_found() {
        for n in [71.5, 96.0, 124.0, 150.75, 1024.0] {
            for octave in -120..120 {
                let target = 1.25 * 2f64.powi(octave);
                let exact = (target * ((n + 2.0) * (n + 4.0) / n)).powf(1.0 / (n + 4.0));
                let single = f64::from(radius(target as f32, 1.0, n as f32));
                // Two powers and their product.
                assert!(
                    (single / exact - 1.0).abs() < 2.0 * f64::from(f32::EPSILON),
                    "{n}, {octave}: {single}"
                );
            }
            for octave in -900..900 {
                let logarithm =
                    (f64::from(octave) + (n + 2.0).log2() + (n + 4.0).log2() - n.log2()) / (n + 4.0);
                let found: f64 = radius(2f64.powi(octave), 1.0, n);
                // What rounding the logarithm leaves.
                assert!((found.log2() - logarithm).abs() < 1e-14, "{n}, {octave}: {found}");
            }
        }
    }
}
