//! δ₀′ and drops of the load integral at many radii, for long sums of whole powers.
//!
//! Horner's rule in x = r, or r² for even powers, for some radii at a time, one coefficient after the other: with so
//! many coefficients compilers would leave it out of vectors otherwise. A place is a − depth, which r and the depth lead
//! to but for rounding.
//!
//! **Slopes.** The rule repeats the rounding of r² with every power. So the derivative by x is taken along, for what
//! both r² and r lack.
//!
//! **Drops.** J(a) − J(r) is a − r times a quotient, by synthetic division, less J′ = r⁴ δ₀′/2 times what r lacks. Of
//! that, the 68th power would make 17 ε next to the edge; the rounding of r² is left, 8 ε if all powers are alike, and up
//! to 15 ε with terms of both signs or next to a power of two.

use super::slopes_and_drops::{Places, SlopesAndDrops};
use crate::Scalar;
use crate::dispatch::half_wide;
use crate::numbers::double_word::DoubleWord;

/// How many radii are taken at a time: two vectors of four, so that there are sums to go on with while others wait.
const LANES: usize = 8;

type Lanes<T> = [T; LANES];

/// δ₀′ and drops from the coefficients of both: with `EVEN`, δ₀′ = Σ `slope`\[k\] r^(2k+1) and J = Σ `integral`\[k\] r^(2k),
/// otherwise δ₀′ = Σ `slope`\[k\] r^k and J = Σ `integral`\[k\] r^k.
#[inline(always)]
pub fn fill_long_sums<T: Scalar, const EVEN: bool, const N: usize, const M: usize>(
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
                fill_slopes::<T, EVEN>(a, places, &slope, &mut slopes_there);
                fill_drops::<T, EVEN>(a, places, &slopes_there, &integral, &mut drops_there);
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
fn fill_slopes<T: Scalar, const EVEN: bool>(
    a: T,
    (radii, depths): (&Lanes<T>, &Lanes<T>),
    coefficients: &[T],
    slopes: &mut Lanes<T>,
) {
    let (zero, one) = (T::zero(), T::one());
    let (mut variables, mut derivatives) = ([DoubleWord::of(zero); LANES], [zero; LANES]);
    for (x, &r) in variables.iter_mut().zip(radii) {
        *x = if EVEN { <DoubleWord<T>>::product(r, r) } else { DoubleWord::of(r) };
    }
    *slopes = [zero; LANES];
    for &coefficient in coefficients.iter().rev() {
        for ((value, derivative), x) in slopes.iter_mut().zip(&mut derivatives).zip(&variables) {
            *derivative = *derivative * x.high() + *value;
            *value = *value * x.high() + coefficient;
        }
    }
    let places = radii.iter().zip(depths).zip(&variables);
    for ((slope, &derivative), ((&r, &depth), x)) in slopes.iter_mut().zip(&derivatives).zip(places) {
        let (value, rounding) = (*slope, (a - r) - depth);
        let lacking = x.low() + if EVEN { r + r } else { one } * rounding;
        let corrected = value + derivative * lacking;
        *slope = if EVEN { corrected * r + value * rounding } else { corrected };
    }
}

/// J(a) less J at these places, with δ₀′ there.
#[inline(always)]
fn fill_drops<T: Scalar, const EVEN: bool>(
    a: T,
    (radii, depths): (&Lanes<T>, &Lanes<T>),
    slopes: &Lanes<T>,
    coefficients: &[T],
    drops: &mut Lanes<T>,
) {
    let variable = |r: T| if EVEN { r * r } else { r };
    let mut at_edge = T::zero();
    *drops = [T::zero(); LANES];
    for &coefficient in coefficients.iter().rev() {
        for (quotient, &r) in drops.iter_mut().zip(radii) {
            *quotient = *quotient * variable(r) + at_edge;
        }
        at_edge = at_edge * variable(a) + coefficient;
    }
    for ((drop, &slope), (&r, &depth)) in drops.iter_mut().zip(slopes).zip(radii.iter().zip(depths)) {
        let quotient = if EVEN { (a + r) * *drop } else { *drop };
        let (square, rounding) = (r * r, (a - r) - depth);
        *drop = (a - r) * quotient - T::constant(0.5) * (square * square) * slope * rounding;
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
        let (mut slope_by_r, mut integral_by_r) = ([T::zero(); 64], [T::zero(); 69]);
        let terms: Vec<(T, T)> = (0..12)
            .map(|index| {
                let (k, c) = (lowest / 2 + 2 * index, ratio.powi(index as i32));
                let n = 2.0 * k as f64;
                slope[k - 1] = T::constant(2.0 * c * n / (n + 2.0));
                integral[k + 2] = T::constant(c * n / ((n + 2.0) * (n + 4.0)));
                (slope_by_r[2 * k - 1], integral_by_r[2 * k + 4]) = (slope[k - 1], integral[k + 2]);
                (T::constant(c), T::constant(n))
            })
            .collect();
        let profile = Polynomial::new(terms).ok()?;
        let shares = (0..301).map(|k| if k < 150 { f64::from(k) / 151.0 } else { 0.9_f64.powi(k - 149) });
        // Not all of them are the last of a block.
        let depths: Vec<T> = shares.map(|share| a * T::constant(share)).collect();
        let radii: Vec<T> = depths.iter().map(|&depth| a - depth).collect();
        let filled = |fill: &dyn Fn(Places<'_, T>, SlopesAndDrops<'_, T>)| {
            let (mut slopes, mut drops) = (vec![T::zero(); 301], vec![T::zero(); 301]);
            fill((&radii, &depths), (&mut slopes, &mut drops));
            slopes.into_iter().zip(drops)
        };
        let by_square = filled(&|places, values| {
            fill_long_sums::<_, true, _, _>(a, places, values, (slope, integral));
        });
        let by_radius = filled(&|places, values| {
            fill_long_sums::<_, false, _, _>(a, places, values, (slope_by_r, integral_by_r));
        });
        let [mut of_slopes, mut of_drops] = [0.0; 2];
        let places = radii.iter().zip(&depths);
        for ((&radius, &depth), (slope, drop)) in places.clone().zip(by_square).chain(places.zip(by_radius)) {
            let rounding = (a - radius) - depth;
            let step = radius * T::constant(1.0 / 4096.0);
            let [here, inwards] = [radius, radius - step].map(|s| profile.approach_slope(s));
            let exact = here + (here - inwards) * (rounding / step);
            let weight = (radius * exact / (a * profile.approach_slope(a))).value();
            let error = |value: T, exact: T| ((value - exact) / (exact * T::default_epsilon())).value().abs();
            of_slopes = worse(of_slopes, error(slope, exact) * weight);
            if !depth.is_zero() {
                of_drops = worse(of_drops, error(drop, profile.load_integral_drop(a, depth)));
            }
        }
        Some([of_slopes, of_drops])
    }

    #[test]
    fn slopes_and_drops_are_those_of_single_radii() {
        for (lowest, ratio, a) in [(2, 1.0, 0.9), (2, 0.02, 1.5), (20, 1.0, 1.1), (4, 3.0, 0.7)] {
            for errors in [largest_errors::<f64>(lowest, ratio, a), largest_errors::<f32>(lowest, ratio, a)] {
                assert!(
                    errors.is_some_and(|[slope, drop]| slope < 6.0 && drop < 9.0),
                    "{lowest}, {ratio}, {a}: {errors:?}"
                );
            }
        }
    }
}
