//! The exponentials of many numbers at once.
//!
//! e^y = 2^k e^x with k the whole number nearest to y/ln 2, so that |x| ≤ (ln 2)/2 = 0.347, and e^x by its Taylor
//! polynomial of degree 13. A quadrature takes its exponentials together; a call for each would keep
//! everything around it from being done two or more at a time.
//!
//! Error: the series leaves 0.347^14/14! = 4e-18 of e^x; k ln 2 is subtracted in two parts, of which the first
//! has 32 bits and its product with k no error, so that x is off by ε/16 at most. With the rounding of the last sum
//! and of the terms below it the result is within 0.8 ε.

use core::any::Any;

use crate::Scalar;

/// The exponentials of some numbers up to 700; in f64 that of a number below −700 is e^(−700).
#[inline(always)]
pub(crate) fn exponentials<T: Scalar, const N: usize>(mut values: [T; N]) -> [T; N] {
    let any: &mut dyn Any = &mut values;
    if let Some(values) = any.downcast_mut::<[f64; N]>() {
        exponentials_of_doubles(values);
    } else {
        for value in &mut values {
            *value = value.exp();
        }
    }
    values
}

/// Apart, so that nothing around it keeps the loop from becoming vector instructions.
#[inline(never)]
fn exponentials_of_doubles(values: &mut [f64]) {
    for value in values {
        *value = exponential(*value);
    }
}

/// The first 32 bits of ln 2, and what they lack.
const LN_2: (f64, f64) = (0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10);

/// 1.5 · 2^52: added to a number below 2^51 it leaves its nearest whole number in the last bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// 1/k! for k = 2 to 13, in fours.
const INVERSE_FACTORIALS: [[f64; 4]; 3] = [
    [1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0],
    [1.0 / 720.0, 1.0 / 5_040.0, 1.0 / 40_320.0, 1.0 / 362_880.0],
    [1.0 / 3_628_800.0, 1.0 / 39_916_800.0, 1.0 / 479_001_600.0, 1.0 / 6_227_020_800.0],
];

#[inline(always)]
fn exponential(y: f64) -> f64 {
    let y = if y > -700.0 { y } else { -700.0 };
    let shifted = y * core::f64::consts::LOG2_E + ROUNDER;
    let k = shifted - ROUNDER;
    let x = (y - k * LN_2.0) - k * LN_2.1;
    let series = series(x);
    // The last bits of `shifted` are k; the exponent of a number is biased by 1023.
    let power_of_two = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    (1.0 + (x + x * x * series)) * power_of_two
}

/// (e^x − 1 − x)/x², its powers taken apart by Estrin's scheme so that no sum waits for twelve others.
#[inline(always)]
fn series(x: f64) -> f64 {
    let square = x * x;
    let fourth = square * square;
    let four_terms = |[a, b, c, d]: [f64; 4]| (a + b * x) + (c + d * x) * square;
    let [low, middle, high] = INVERSE_FACTORIALS;
    four_terms(low) + (four_terms(middle) + four_terms(high) * fourth) * fourth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_are_those_of_the_library() {
        for k in 0..7000 {
            let y = -0.1 * f64::from(k) + 0.3;
            let (found, expected) = (exponential(y), y.exp());
            // Both round.
            assert!((found / expected - 1.0).abs() < 1.3 * f64::EPSILON, "{y}: {found:e}");
        }
        assert_eq!(exponential(0.0), 1.0);
    }

    #[test]
    fn whatever_has_faded_stays_finite() {
        for y in [-701.0, -1e300, -f64::INFINITY] {
            assert!(exponential(y) < 1e-300);
        }
    }
}
