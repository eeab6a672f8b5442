//! δ₀′ and drops of the load integral where exponents are multiples of 1/4: from the roots of radii.
//!
//! With α = a^(1/4), J(a) = W(a) + α Q(a) + α² H(a) + α³ R(a). The polynomial W has the terms with whole exponents; Q,
//! H and R are what those with a quarter, a half and three quarters more than a whole number have beside a power of α.
//! At a radius s = σ⁴ that is less by a depth, J has dropped by depth times
//!
//! ```text
//! W[a, s] + σ Q[a, s] + σ² H[a, s] + σ³ R[a, s] + (H(a) + (Q(a) + (α² + α σ + σ²) R(a))/(α + σ))/(√a + √s)
//! ```
//!
//! with W[a, s] = (W(a) − W(s))/(a − s), without cancellation for coefficients of one sign: a difference of products is
//!
//! ```text
//! α Q(a) − σ Q(s) = σ (Q(a) − Q(s)) + (α − σ) Q(a),    a − s = (α − σ) (α + σ) (√a + √s)
//! ```
//!
//! so that α − σ cancels; for H the factor is α² − σ², and for R α³ − σ³ = (α − σ) (α² + α σ + σ²).

use super::horner::{divided_difference, value_and_quotient};
use super::power::power_sum_drop;
use super::slopes_and_drops::{Places, SlopesAndDrops, fill_one_by_one};
use crate::numbers::exponent::Exponent;
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};

/// The coefficients of W, Q, H and R: of the whole powers, the quarters, the halves and the three quarters.
type Parts<T, const W: usize, const Q: usize, const H: usize, const R: usize> =
    ([T; W], [T; Q], [T; H], [T; R]);

/// J(a) − J(a − depth) for 0 ≤ depth ≤ a, from its parts or, where roots would lose a derivative or have no sum, from
/// its terms (c, p).
#[inline]
pub fn drop_by_roots<T: Scalar, const W: usize, const Q: usize, const H: usize, const R: usize>(
    a: T,
    depth: T,
    parts: Parts<T, W, Q, H, R>,
    terms: impl IntoIterator<Item = (T, Exponent<T>)>,
) -> T {
    if !has_no_derivatives::<T>() || a.is_zero() {
        return power_sum_drop(a, depth, terms);
    }
    depth * quotient(a, a - depth, parts)
}

/// The slopes and drops at many radii, from the slope as a function of the radius, and the parts of J.
///
/// A rounded radius changes a drop by less than p ε/2 times itself.
#[inline(always)]
pub fn fill_by_roots<
    T: Scalar,
    P: GapProfile<T> + ?Sized,
    const W: usize,
    const Q: usize,
    const H: usize,
    const R: usize,
>(
    profile: &P,
    a: T,
    (radii, depths): Places<'_, T>,
    (slopes, drops): SlopesAndDrops<'_, T>,
    slope: impl Fn(T) -> T,
    parts: Parts<T, W, Q, H, R>,
) {
    if !has_no_derivatives::<T>() {
        return fill_one_by_one(profile, a, (radii, depths), (slopes, drops));
    }
    let values = slopes.iter_mut().zip(drops);
    for ((slope_there, drop_there), (&radius, &depth)) in values.zip(radii.iter().zip(depths)) {
        *slope_there = slope(radius);
        *drop_there = depth * quotient(a, radius, parts);
    }
}

/// The drop over the depth.
#[inline(always)]
fn quotient<T: Scalar, const W: usize, const Q: usize, const H: usize, const R: usize>(
    a: T,
    s: T,
    (whole, quarters, halves, three_quarters): Parts<T, W, Q, H, R>,
) -> T {
    let (root_of_a, root) = (a.sqrt(), s.sqrt());
    let (mut beside, mut quotient) = value_and_quotient(a, s, &halves);
    quotient *= root;
    if Q + R > 0 {
        let (alpha, sigma) = (root_of_a.sqrt(), root.sqrt());
        let [of_quarters, of_three_quarters] =
            [value_and_quotient(a, s, &quarters), value_and_quotient(a, s, &three_quarters)];
        let squares = root_of_a + alpha * sigma + root;
        beside += (of_quarters.0 + squares * of_three_quarters.0) / (alpha + sigma);
        quotient += sigma * (of_quarters.1 + root * of_three_quarters.1);
    }
    divided_difference(a, s, whole) + (quotient + beside / (root_of_a + root))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Polynomial;

    /// J = 2 a⁵ + 3 a^5.5 + 0.1 a^8.5 + 4 a^6.25 + a^5.75
    fn parts<T: Scalar>() -> Parts<T, 6, 7, 9, 6> {
        let mut parts = ([T::zero(); 6], [T::zero(); 7], [T::zero(); 9], [T::zero(); 6]);
        [parts.0[5], parts.2[5], parts.2[8], parts.1[6], parts.3[5]] =
            [2.0, 3.0, 0.1, 4.0, 1.0].map(T::constant);
        parts
    }

    fn terms<T: Scalar>() -> [(T, Exponent<T>); 5] {
        [(2.0, 5.0), (3.0, 5.5), (0.1, 8.5), (4.0, 6.25), (1.0, 5.75)]
            .map(|(c, p)| (T::constant(c), Exponent::of(T::constant(p))))
    }

    #[test]
    fn fourth_powers_drop_exactly() {
        let drop = |c: f64, k: i32| c * (3f64.powi(k) - 2f64.powi(k));
        let (whole, quarters, mut halves, three_quarters) = parts();
        halves[8] = 0.0;
        let found = drop_by_roots(81.0, 65.0, (whole, [], halves, []), []);
        assert_eq!(found, drop(2.0, 20) + drop(3.0, 22));
        let found = drop_by_roots(81.0, 65.0, (whole, quarters, halves, three_quarters), []);
        assert_eq!(found, drop(2.0, 20) + drop(3.0, 22) + drop(4.0, 25) + drop(1.0, 23));
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
