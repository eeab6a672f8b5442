//! ln x, e^x − 1 and x^φ with a few digits more than a word has, for results that are rounded once.
//!
//! The functions of a library are off by up to 1 ulp, which grows where powers cancel. Here the first terms of each
//! series are double words, and all others, at least 500 times smaller, are words: relative errors are below ε/200.
//!
//! ln x = k ln 2 + ln f with 1/√2 ≤ f < √2 and ln f = 2 artanh t, t = (f − 1)/(f + 1), |t| ≤ 0.172. e^x = 2^k e^g with
//! k the integer nearest to x/ln 2 and |g| ≤ ln 2/2.

use core::f64::consts::{LN_2, LOG2_E, SQRT_2};

use super::binary::split;
use super::bits::{exponent, nearest_integer, power_of_two};
use super::double_word::DoubleWord;
use super::series::{inverse_factorials, odd_reciprocals};
use crate::Scalar;
use crate::in_double_words;
use crate::numbers::tabled::{Tabled, tabled_rows};
use crate::scalar::is_same;

/// x^φ of a normal number above 0, for 0 ≤ φ < 1. A function of its own, too long to be part of others: it chooses its
/// instructions again.
pub(crate) fn fractional_power<T: Scalar, const FUSED: bool>(
    x: T,
    phi: DoubleWord<T, FUSED>,
) -> DoubleWord<T, FUSED> {
    in_double_words!(FUSED => power_of::<T, FUSED>(x, phi.converted()).converted())
}

/// [`fractional_power`] without that choice.
#[inline(always)]
fn power_of<T: Scalar, const FUSED: bool>(x: T, phi: DoubleWord<T, FUSED>) -> DoubleWord<T, FUSED> {
    let (fraction, octaves) = split(x);
    let (fraction, octaves) = centred(DoubleWord::of(fraction), octaves);
    let beyond = fraction.plus_word(-T::one());
    let (gain, octaves) = reduced_exponential(logarithm(beyond, octaves).times(phi));
    gain.plus_word(T::one()).scaled(power_of_two(octaves))
}

/// ln(1 − depth) from the depth and the `ratio` 1 − depth, which is a normal number below 1; each has all its digits.
#[inline(always)]
pub(crate) fn double_log_of_ratio<T: Scalar, const FUSED: bool>(
    ratio: DoubleWord<T, FUSED>,
    depth: DoubleWord<T, FUSED>,
) -> DoubleWord<T, FUSED> {
    let octaves = exponent(ratio.high());
    let (fraction, octaves) = centred(ratio.scaled(power_of_two(-octaves)), octaves);
    // Where the ratio is near 1, the depth has the digits that the ratio has lost.
    let beyond = if octaves == 0 { -depth } else { fraction.plus_word(-T::one()) };
    logarithm(beyond, octaves)
}

/// e^x − 1 for x ≤ 0.
#[inline(always)]
pub(crate) fn negative_exp_m1<T: Scalar, const FUSED: bool>(x: DoubleWord<T, FUSED>) -> DoubleWord<T, FUSED> {
    // 2⁻¹¹⁵ is a normal number in either format.
    if x.high() < T::constant(-80.0) {
        return DoubleWord::of(-T::one());
    }
    let (gain, octaves) = reduced_exponential(x);
    let power = power_of_two(octaves);
    DoubleWord::sum(power, -T::one()).plus(gain.scaled(power))
}

/// The fraction and the exponent of a number, the fraction from 1/√2 to √2.
#[inline(always)]
fn centred<T: Scalar, const FUSED: bool>(
    fraction: DoubleWord<T, FUSED>,
    octaves: i32,
) -> (DoubleWord<T, FUSED>, i32) {
    if fraction.high() < T::constant(SQRT_2) {
        (fraction, octaves)
    } else {
        (fraction.scaled(T::constant(0.5)), octaves + 1)
    }
}

/// ln of (1 + `beyond`) 2^`octaves` for 1/√2 ≤ 1 + `beyond` < √2.
#[inline(always)]
fn logarithm<T: Scalar, const FUSED: bool>(
    beyond: DoubleWord<T, FUSED>,
    octaves: i32,
) -> DoubleWord<T, FUSED> {
    let (one, two) = (T::one(), T::constant(2.0));
    let t = beyond.over(beyond.plus_word(two));
    let square = t.times(t);
    let s = square.high();
    let rest = polynomial(s, if is_same::<T, f32>() { &ARTANH[..3] } else { &ARTANH });
    let third = DoubleWord::of(one).over(DoubleWord::of(T::constant(3.0)));
    let series = square.times(third).plus_word(s * s * rest).plus_word(one);
    ln_2().times_word(T::constant(f64::from(octaves))).plus(t.times(series).scaled(two))
}

/// e^g − 1 and k, e^x = 2^k e^g.
#[inline(always)]
fn reduced_exponential<T: Scalar, const FUSED: bool>(x: DoubleWord<T, FUSED>) -> (DoubleWord<T, FUSED>, i32) {
    let (octaves, count) = nearest_integer(x.high() * T::constant(LOG2_E));
    let g = x.plus(ln_2().times_word(-octaves));
    let rest = polynomial(g.high(), if is_same::<T, f32>() { &TAYLOR[..3] } else { &TAYLOR });
    let sixth = DoubleWord::of(T::one()).over(DoubleWord::of(T::constant(6.0)));
    let series = sixth.plus_word(g.high() * rest);
    let series = series.times(g).plus_word(T::constant(0.5)).times(g).plus_word(T::one());
    (series.times(g), count)
}

/// The polynomial with these coefficients of even and odd powers. The two halves do not wait for each other.
#[inline(always)]
fn polynomial<T: Scalar>(x: T, coefficients: &[[Tabled; 2]]) -> T {
    let square = x * x;
    let halves = coefficients.iter().rev().fold([T::zero(); 2], |[even, odd], &[of_even, of_odd]| {
        [even * square + of_even.get::<T>(), odd * square + of_odd.get::<T>()]
    });
    halves[0] + halves[1] * x
}

/// ln 2 with what its word lacks, in either format.
#[inline(always)]
fn ln_2<T: Scalar, const FUSED: bool>() -> DoubleWord<T, FUSED> {
    let low = if is_same::<T, f32>() { -1.904_654_299_957_768e-9 } else { 2.319_046_813_846_299_6e-17 };
    DoubleWord::sum(T::constant(LN_2), T::constant(low))
}

/// 1/(2k + 1) from k = 2 on. The series leaves out 2e-20 after t²², and 4e-14 after t¹⁴ in single precision.
const ARTANH: [[Tabled; 2]; 5] = tabled_rows(odd_reciprocals(2));

/// 1/k! from k = 4 on. The series leaves out 6e-21 after g¹⁵, and 2e-11 after g⁹ in single precision.
const TAYLOR: [[Tabled; 2]; 6] = tabled_rows(inverse_factorials(4));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worse::worse;

    /// |x/y − 1| in units of ε.
    fn difference<T: Scalar, const FUSED: bool>(x: DoubleWord<T, FUSED>, y: DoubleWord<T, FUSED>) -> f64 {
        (x.plus(-y).high() / y.high()).abs().value() / T::default_epsilon().value()
    }

    /// The largest error of x^φ where it is a root, for x from 2^−`octaves` to 2^`octaves`.
    fn largest_error_of_roots<T: Scalar, const FUSED: bool>(octaves: f64) -> f64 {
        let mut largest = 0.0_f64;
        for k in 0..=10_000 {
            let x = T::constant((octaves * (f64::from(k) / 5000.0 - 1.0)).exp2());
            let root = DoubleWord::<T, FUSED>::of(x).sqrt();
            let powers = [(0.5, root), (0.25, root.sqrt()), (0.75, root.times(root.sqrt()))];
            for (phi, root) in powers {
                let power = power_of(x, DoubleWord::of(T::constant(phi)));
                largest = worse(largest, difference(power, root));
            }
        }
        largest
    }

    #[test]
    fn powers_of_halves_and_quarters_are_roots() {
        let of_doubles = [
            largest_error_of_roots::<f64, true>(1000.0),
            largest_error_of_roots::<f64, false>(1000.0),
            // The numbers nearest to 1.
            largest_error_of_roots::<f64, false>(1e-13),
        ];
        let of_singles =
            [largest_error_of_roots::<f32, true>(100.0), largest_error_of_roots::<f32, false>(100.0)];
        for error in of_doubles.into_iter().chain(of_singles) {
            assert!(error < 0.005, "{error}");
        }
        assert_eq!(fractional_power(1.0, <DoubleWord<f64>>::of(0.3)).rounded(), 1.0);
    }

    /// The largest error of e^x − 1 with x = ln q over q from 1 down to `least`, where it is q − 1.
    fn largest_error_of_decay<T: Scalar, const FUSED: bool>(least: f64) -> f64 {
        let mut largest = 0.0_f64;
        for k in 1..10_000 {
            let q = T::constant(least.powf(f64::from(k) / 1e4));
            let depth = DoubleWord::<T, FUSED>::sum(T::one(), -q);
            if q < T::one() {
                let logarithm = double_log_of_ratio(DoubleWord::of(q), depth);
                largest = worse(largest, difference(negative_exp_m1(logarithm), -depth));
            }
        }
        largest
    }

    #[test]
    fn exponentials_undo_logarithms() {
        let of_doubles = [
            largest_error_of_decay::<f64, true>(1e-12),
            largest_error_of_decay::<f64, false>(1e-12),
            largest_error_of_decay::<f64, false>(1.0 - 1e-9),
        ];
        let of_singles =
            [largest_error_of_decay::<f32, true>(1e-12), largest_error_of_decay::<f32, false>(0.999)];
        for error in of_doubles.into_iter().chain(of_singles) {
            assert!(error < 0.005, "{error}");
        }
        assert_eq!(negative_exp_m1(<DoubleWord<f64>>::of(-1e5)).rounded(), -1.0);
    }
}
