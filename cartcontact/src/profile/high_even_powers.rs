//! δ₀′ and drops of the load integral at many radii, for many even powers.
//!
//! Horner's rule in r² for some radii at a time, one coefficient after the other: with so many coefficients compilers
//! would leave it out of vectors otherwise. A place is a − depth, which r and the depth lead to but for rounding.
//!
//! **Slopes.** The rule repeats the rounding of r² with every power. So the derivative by r² is taken along, for what
//! both r² and r lack.
//!
//! **Drops.** J(a) − J(r) is a − r times a quotient, by synthetic division, less J′ = r⁴ δ₀′/2 times what r lacks. Of
//! that, the 68th power would make 17 ε next to the edge; the rounding of r² is left, 8 ε if all powers are alike.

use super::slopes_and_drops::{Places, SlopesAndDrops};
use crate::Scalar;
use crate::dispatch::half_wide;
use crate::numbers::double_word::DoubleWord;

/// How many radii are taken at a time: two vectors of four, so that there are sums to go on with while others wait.
const LANES: usize = 8;

type Lanes<T> = [T; LANES];

/// The slopes δ₀′ = Σ `slope`\[k\] r^(2k+1), and the drops of J = Σ `integral`\[k\] r^(2k).
#[inline(always)]
pub fn fill_high_even_powers<T: Scalar, const N: usize, const M: usize>(
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    (slope, integral): ([T; N], [T; M]),
) {
    let places = radii.chunks(LANES).zip(depths.chunks(LANES));
    let values = slopes.chunks_mut(LANES).zip(drops.chunks_mut(LANES));
    half_wide(
        #[inline(always)]
        || {
            let (mut slopes_there, mut drops_there) = ([T::zero(); LANES], [T::zero(); LANES]);
            for ((radii, depths), (slopes, drops)) in places.zip(values) {
                let places = (&lanes(radii), &lanes(depths));
                fill_slopes(a, places, &slope, &mut slopes_there);
                fill_drops(a, places, &slopes_there, &integral, &mut drops_there);
                slopes.copy_from_slice(&slopes_there[..slopes.len()]);
                drops.copy_from_slice(&drops_there[..drops.len()]);
            }
        },
    );
}

/// Up to [`LANES`] values, and zeros after them.
#[inline(always)]
fn lanes<T: Scalar>(values: &[T]) -> Lanes<T> {
    let mut lanes = [T::zero(); LANES];
    lanes[..values.len()].copy_from_slice(values);
    lanes
}

/// δ₀′ at these places.
#[inline(always)]
fn fill_slopes<T: Scalar>(
    a: T,
    (radii, depths): (&Lanes<T>, &Lanes<T>),
    coefficients: &[T],
    slopes: &mut Lanes<T>,
) {
    let zeros = [T::zero(); LANES];
    let (mut squares, mut derivatives) = ([DoubleWord::of(T::zero()); LANES], zeros);
    for (square, &r) in squares.iter_mut().zip(radii) {
        *square = <DoubleWord<T>>::product(r, r);
    }
    *slopes = zeros;
    for &coefficient in coefficients.iter().rev() {
        for ((value, derivative), square) in slopes.iter_mut().zip(&mut derivatives).zip(&squares) {
            *derivative = *derivative * square.high() + *value;
            *value = *value * square.high() + coefficient;
        }
    }
    let places = radii.iter().zip(depths).zip(&squares);
    for ((slope, &derivative), ((&r, &depth), square)) in slopes.iter_mut().zip(&derivatives).zip(places) {
        let (value, rounding) = (*slope, (a - r) - depth);
        let correction = derivative * (square.low() + (r + r) * rounding);
        *slope = (value + correction) * r + value * rounding;
    }
}

/// J(a) less J at these places, with δ₀′ there.
#[inline(always)]
fn fill_drops<T: Scalar>(
    a: T,
    (radii, depths): (&Lanes<T>, &Lanes<T>),
    slopes: &Lanes<T>,
    coefficients: &[T],
    drops: &mut Lanes<T>,
) {
    let mut at_edge = T::zero();
    *drops = [T::zero(); LANES];
    for &coefficient in coefficients.iter().rev() {
        for (quotient, &r) in drops.iter_mut().zip(radii) {
            *quotient = *quotient * (r * r) + at_edge;
        }
        at_edge = at_edge * (a * a) + coefficient;
    }
    for ((drop, &slope), (&r, &depth)) in drops.iter_mut().zip(slopes).zip(radii.iter().zip(depths)) {
        let (square, rounding) = (r * r, (a - r) - depth);
        *drop = (a - r) * ((a + r) * *drop) - T::constant(0.5) * (square * square) * slope * rounding;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worse::worse;
    use crate::{GapProfile, Polynomial};

    /// The largest errors, in units of ε, of slopes of gaps of 12 even powers from the lowest on, which count as much as
    /// s δ₀′ does, and of drops.
    fn largest_errors<T: Scalar>(lowest: usize, ratio: f64, a: f64) -> Option<[f64; 2]> {
        let a = T::constant(a);
        let (mut slope, mut integral) = ([T::zero(); 32], [T::zero(); 35]);
        let terms: Vec<(T, T)> = (0..12)
            .map(|index| {
                let (k, c) = (lowest / 2 + 2 * index, ratio.powi(index as i32));
                let n = 2.0 * k as f64;
                slope[k - 1] = T::constant(2.0 * c * n / (n + 2.0));
                integral[k + 2] = T::constant(c * n / ((n + 2.0) * (n + 4.0)));
                (T::constant(c), T::constant(n))
            })
            .collect();
        let profile = Polynomial::new(terms).ok()?;
        let shares = (0..301).map(|k| if k < 150 { f64::from(k) / 151.0 } else { 0.9_f64.powi(k - 149) });
        // Not all of them are the last of a block.
        let depths: Vec<T> = shares.map(|share| a * T::constant(share)).collect();
        let radii: Vec<T> = depths.iter().map(|&depth| a - depth).collect();
        let (mut slopes, mut drops) = (vec![T::zero(); 301], vec![T::zero(); 301]);
        fill_high_even_powers(a, (&radii, &depths), (&mut slopes, &mut drops), (slope, integral));
        let [mut of_slopes, mut of_drops] = [0.0; 2];
        for k in 0..301 {
            let (radius, depth) = (radii[k], depths[k]);
            let rounding = (a - radius) - depth;
            let step = radius * T::constant(1.0 / 4096.0);
            let [here, inwards] = [radius, radius - step].map(|s| profile.approach_slope(s));
            let exact = here + (here - inwards) * (rounding / step);
            let weight = (radius * exact / (a * profile.approach_slope(a))).value();
            let error = |value: T, exact: T| ((value - exact) / (exact * T::default_epsilon())).value().abs();
            of_slopes = worse(of_slopes, error(slopes[k], exact) * weight);
            if !depth.is_zero() {
                of_drops = worse(of_drops, error(drops[k], profile.load_integral_drop(a, depth)));
            }
        }
        Some([of_slopes, of_drops])
    }

    #[test]
    fn slopes_and_drops_are_those_of_single_radii() {
        for (lowest, ratio, a) in [(2, 1.0, 0.9), (2, 0.02, 1.5), (20, 1.0, 1.1), (4, 3.0, 0.7)] {
            for errors in [largest_errors::<f64>(lowest, ratio, a), largest_errors::<f32>(lowest, ratio, a)] {
                assert!(
                    errors.is_some_and(|[slope, drop]| slope < 4.0 && drop < 9.0),
                    "{lowest}, {ratio}, {a}: {errors:?}"
                );
            }
        }
    }
}
