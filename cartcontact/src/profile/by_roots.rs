//! δ₀′ and drops of the load integral where exponents are multiples of 1/2: from the roots of radii.
//!
//! J(a) = W(a) + √a H(a) with polynomials W and H. At a radius s that is less by a depth, J has dropped by
//!
//! ```text
//! depth · (W[a, s] + √s H[a, s] + H(a)/(√a + √s)),    W[a, s] = (W(a) − W(s))/(a − s),
//! ```
//!
//! without cancellation for coefficients of one sign.

use super::slopes_and_drops::{Places, SlopesAndDrops, fill_one_by_one};
use crate::evaluate::exponent::Exponent;
use crate::evaluate::horner::{divided_difference, value_and_quotient};
use crate::evaluate::power::power_sum_drop;
use crate::scalar::is_plain;
use crate::{GapProfile, Scalar};

/// J(a) − J(a − depth) for 0 ≤ depth ≤ a, from the coefficients of W and H or, where roots would lose a derivative or
/// have no sum, from the terms (c, p) of J.
#[inline]
pub fn drop_by_roots<T: Scalar, const N: usize, const M: usize>(
    a: T,
    depth: T,
    (whole, halves): ([T; N], [T; M]),
    terms: impl IntoIterator<Item = (T, Exponent<T>)>,
) -> T {
    if !is_plain::<T>() || a.is_zero() {
        return power_sum_drop(a, depth, terms);
    }
    depth * quotient(a, a - depth, (whole, halves))
}

/// The slopes and drops at many radii, from the slope as a function of the radius, and the coefficients of W and H.
///
/// A rounded radius changes a drop by less than p ε/2 times itself.
#[inline(always)]
pub fn fill_by_roots<T: Scalar, P: GapProfile<T> + ?Sized, const N: usize, const M: usize>(
    profile: &P,
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    slope: impl Fn(T) -> T,
    (whole, halves): ([T; N], [T; M]),
) {
    if !is_plain::<T>() {
        return fill_one_by_one(profile, a, (radii, depths), (slopes, drops));
    }
    let values = slopes.iter_mut().zip(drops);
    for ((slope_there, drop_there), (&radius, &depth)) in values.zip(radii.iter().zip(depths)) {
        *slope_there = slope(radius);
        *drop_there = depth * quotient(a, radius, (whole, halves));
    }
}

/// The drop over the depth.
#[inline(always)]
fn quotient<T: Scalar, const N: usize, const M: usize>(a: T, s: T, (whole, halves): ([T; N], [T; M])) -> T {
    let (root_of_a, root) = (a.sqrt(), s.sqrt());
    let (value, of_halves) = value_and_quotient(a, s, &halves);
    divided_difference(a, s, whole) + (root * of_halves + value / (root_of_a + root))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Polynomial;

    /// J = 2 a⁵ + 3 a^5.5 + 0.1 a^8.5
    fn parts<T: Scalar>() -> ([T; 6], [T; 9]) {
        let mut parts = ([T::zero(); 6], [T::zero(); 9]);
        [parts.0[5], parts.1[5], parts.1[8]] = [2.0, 3.0, 0.1].map(T::constant);
        parts
    }

    fn terms<T: Scalar>() -> [(T, Exponent<T>); 3] {
        [(2.0, 5.0), (3.0, 5.5), (0.1, 8.5)].map(|(c, p)| (T::constant(c), Exponent::of(T::constant(p))))
    }

    #[test]
    fn squares_drop_exactly() {
        let expected = 2.0 * (9f64.powi(5) - 4f64.powi(5)) + 3.0 * (3f64.powi(11) - 2f64.powi(11));
        let (whole, mut halves) = parts();
        halves[8] = 0.0;
        assert_eq!(drop_by_roots(9.0, 5.0, (whole, halves), []), expected);
    }

    #[test]
    fn drops_are_those_of_powers() {
        for k in 0..400 {
            let (a, depth) = (6.25, 6.25 * 0.9_f64.powi(k));
            let expected = power_sum_drop(a, depth, terms());
            let found = drop_by_roots(a, depth, parts(), terms());
            // The other form rounds a logarithm, which p multiplies, and an expm1.
            assert!((found / expected - 1.0).abs() < 5.0 * f64::EPSILON, "{depth:e}: {found:e}");
            let (single, exact) = (depth as f32, power_sum_drop(a, f64::from(depth as f32), terms()));
            let found = f64::from(drop_by_roots(6.25, single, parts(), terms()));
            assert!((found / exact - 1.0).abs() < 4.0 * f64::from(f32::EPSILON), "{depth:e}: {found:e}");
        }
        for (a, depth) in [(0.0, 0.0), (6.25, 0.0), (6.25, 6.25)] {
            let expected = power_sum_drop(a, depth, terms::<f64>());
            let found = drop_by_roots(a, depth, parts(), terms());
            assert!((found - expected).abs() <= 2.0 * f64::EPSILON * expected, "{a}, {depth}: {found}");
        }
    }

    #[test]
    fn many_drops_are_each_alone() {
        let (profile, a) = (Polynomial::new([(0.02_f64, 1.5)]), 6.25);
        let Ok(profile) = profile else { unreachable!("one positive term") };
        let depths: Vec<f64> = (0..300).map(|k| a * 0.95 * 0.9_f64.powi(k)).collect();
        let radii: Vec<f64> = depths.iter().map(|depth| a - depth).collect();
        let (mut slopes, mut drops) = (vec![0.0; 300], vec![0.0; 300]);
        fill_by_roots(&profile, a, (&radii, &depths), (&mut slopes, &mut drops), |s| s.sqrt(), parts());
        for (((&drop, &depth), &slope), &radius) in drops.iter().zip(&depths).zip(&slopes).zip(&radii) {
            assert_eq!(slope, radius.sqrt());
            let alone = drop_by_roots(a, depth, parts(), terms());
            // Here the radius is rounded.
            assert!((drop / alone - 1.0).abs() < 4.0 * f64::EPSILON, "{depth:e}");
        }
    }
}
