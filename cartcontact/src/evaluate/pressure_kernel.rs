//! The pressure kernel G(a, r) of a sum of powers, exact to the edge of the contact.
//!
//! Per term of the gap, G = C/(2 (n+2)²) a^(n+2) K(q) with q = r/a and K(q) = n − (n+2) q² + 2 q^(n+2). K has a double
//! zero at q = 1, where this form loses every digit. The forms below, and those of
//! [`kernel_of_term`](super::kernel_of_term) for a term alone, have the zero as a factor, which follows from a − r, times
//! a positive rest.
//!
//! Source of K: I. Argatov, Mech. Res. Commun. 38 (2011), Eqs. (26), (28), doi 10.1016/j.mechrescom.2010.11.006.

use super::arithmetic::{Arithmetic, Word};
use super::coefficient::Coefficient;
use super::kernel_of_term::{Order, Position};
use super::power::{plain_whole_term, quarter_root};
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::scalar::has_no_derivatives;

/// G(a, r) of the gap Σ C r^n over the terms (C, n), zero for r ≥ a, rounded once.
#[inline(always)]
pub fn pressure_kernel<T, C, I, const FUSED: bool>(a: T, r: T, terms: I) -> T
where
    T: Scalar,
    C: Coefficient<T>,
    I: IntoIterator<Item = (C, Exponent<T>)> + Clone,
{
    let sum: DoubleWord<T, FUSED> = sum_of_kernels(a, r, terms.clone(), Order::PowerFirst);
    sum.rounded_or(|| pressure_kernel_zero_first(a, r, terms))
}

/// [`pressure_kernel`] with the zero at the edge as the first factor, where powers alone would leave the format.
#[inline]
pub(super) fn pressure_kernel_zero_first<T: Scalar, C: Coefficient<T>>(
    a: T,
    r: T,
    terms: impl IntoIterator<Item = (C, Exponent<T>)> + Clone,
) -> T {
    let sum: DoubleWord<T> = sum_of_kernels(a, r, terms.clone(), Order::ZeroFirst);
    sum.rounded_or(|| sum_of_kernels::<_, Word<T>, _>(a, r, terms, Order::ZeroFirst).rounded())
}

/// [`pressure_kernel`] in plain arithmetic: on the axis within 8 ε. Elsewhere a long tent multiplies the rounding of q;
/// up to 15 ε was seen with quarters, and 16 ε at the power 100.
#[inline]
pub fn quick_pressure_kernel<T: Scalar>(
    a: T,
    r: T,
    terms: impl IntoIterator<Item = (T, Exponent<T>)> + Clone,
) -> T {
    let sum = |terms, order| -> T { sum_of_kernels::<_, Word<T>, _>(a, r, terms, order).rounded() };
    let quick = sum(terms.clone(), Order::PowerFirst);
    // C a^(n+2) of a tiny exponent n may leave the format where n C a^(n+2) does not.
    if quick.is_finite() { quick } else { out_of_line(move || sum(terms, Order::ZeroFirst)) }
}

/// G(a, r) of a gap of low multiples of 1/`D`, for 2 or 4, in plain arithmetic, zero for r ≥ a, within 10 ε. A weight is
/// C/(2 `D` (n+2)²), beside n `D`, which is at most `N`. With derivatives, which roots lose at r = 0, as
/// [`quick_pressure_kernel`] of the terms.
#[inline(always)]
pub fn quick_pressure_kernel_in_root<T: Scalar, const D: usize, const N: usize, const COUNT: usize>(
    a: T,
    r: T,
    weights: [(T, usize); COUNT],
    terms: impl IntoIterator<Item = (T, Exponent<T>)> + Clone,
) -> T {
    if has_no_derivatives::<T>() {
        sum_in_root::<T, D, N>(a, r, &weights)
    } else {
        quick_pressure_kernel(a, r, terms)
    }
}

#[inline(always)]
fn sum_of_kernels<T: Scalar, A: Arithmetic<T>, C: Coefficient<T>>(
    a: T,
    r: T,
    terms: impl IntoIterator<Item = (C, Exponent<T>)>,
    order: Order,
) -> A {
    let mut sum = A::of(T::zero());
    if r < a {
        let position = Position::between(a, r);
        // No `fold`, which need not be inlined.
        for term in terms {
            sum = sum.plus(position.kernel_of_term(term, order));
        }
    }
    sum
}

/// (1 − p)² Σ_k v_k U_k for whole k = n d, where p is the root of q with the index d, 2 or 4, v_k = w_k a^(n+2) and
/// (1 − p)² U_k = d K. With β = 2 d the differences are
///
/// ```text
/// U_k − U_{k−1} = Σ_{i<β} p^i H_{k+β−2−i},    H_k = Σ_{j≤k} p^j,
/// ```
///
/// in which H_{k+j} = p^(j+1) H_{k−1} + H_j, so that the sum is D_0 Σ_{i≤β−2} (i+1) p^i + β p^(β−1) Σ_j p^j D_j with sums
/// of sums of weights, D_j = E_j + D_{j+1} and E_j = v_{j+1} + E_{j+1}.
#[inline(always)]
fn sum_in_root<T: Scalar, const D: usize, const N: usize>(a: T, r: T, weights: &[(T, usize)]) -> T {
    let mut scaled = [T::zero(); N];
    let quarters = [T::one(), quarter_root::<T, 1>(a), quarter_root::<T, 2>(a), quarter_root::<T, 3>(a)];
    for &(weight, k) in weights {
        scaled[k - 1] = plain_whole_term(weight, a, 2 + (k / D) as u32) * quarters[k % D * (4 / D)];
    }
    let (one, ratio) = (T::one(), r / a);
    let root = ratio.sqrt();
    let (p, divisor, last) = if D == 2 {
        (root, one, root * ratio)
    } else {
        let p = root.sqrt();
        (p, root + one, p * root * ratio)
    };
    let inset = (a - r) / (a * divisor * (p + one));
    // Horner's rule in p², so that only every other step waits for the one before.
    let ([mut e, mut d], [mut sum, mut before]) = ([T::zero(); 2], [T::zero(); 2]);
    for v in scaled.into_iter().rev() {
        e += v;
        d += e;
        (sum, before) = (before * (p * p) + d, sum);
    }
    let sum = sum + p * before;
    let rising = (1..2 * D).rev().fold(T::zero(), |sum, j| sum * p + T::constant(j as f64));
    let rest = rising * d + T::constant((2 * D) as f64) * last * sum;
    if r < a { inset * rest * inset } else { T::zero() }
}

#[cfg(test)]
mod tests {
    use super::super::dense_kernel::{
        even_pressure_kernel, quick_even_pressure_kernel, quick_high_even_pressure_kernel,
        quick_whole_pressure_kernel, whole_pressure_kernel,
    };
    use super::super::real_exponent_kernel;
    use super::*;
    use crate::worse::worse;

    /// K(q) in exact integers for whole n: q = x/y gives K y^(n+2) = n y^(n+2) − (n+2) x² y^n + 2 x^(n+2).
    fn exact(n: u32, x: i128, y: i128) -> f64 {
        let k = i128::from(n);
        let numerator = k * y.pow(n + 2) - (k + 2) * x * x * y.pow(n) + 2 * x.pow(n + 2);
        numerator as f64 / y.pow(n + 2) as f64
    }

    #[test]
    fn tents_agree_with_exact_integers() {
        for n in 1..=12 {
            for x in 0..100 {
                let expected = exact(n, x, 100);
                let position = Position::<f64, DoubleWord<f64>>::between(100.0, x as f64);
                let tent = position.kernel(Exponent::of(f64::from(n))).rounded();
                // The expected value rounds three times.
                assert!((tent / expected - 1.0).abs() < 2.0 * f64::EPSILON, "n = {n}, q = {x} %");
            }
        }
    }

    #[test]
    fn quick_kernels_agree_with_exact_integers() {
        for n in 1..=12 {
            let mut weights = [0.0; 12];
            weights[n as usize - 1] = 1.0;
            let mut even_weights = [0.0; 6];
            even_weights[(n as usize - 1) / 2] = 2.0;
            for x in 0..100 {
                let expected = exact(n, x, 100);
                let whole = quick_whole_pressure_kernel(1.0, x as f64 / 100.0, weights);
                let half_weights = [(0.5, 2 * n as usize)];
                let half =
                    quick_pressure_kernel_in_root::<_, 2, 24, 1>(1.0, x as f64 / 100.0, half_weights, []);
                // x/100 is rounded, and K changes by 2/(1 − q) of that.
                let bound = (8.0 + 200.0 / (100 - x) as f64) * f64::EPSILON;
                assert!((whole / expected - 1.0).abs() < bound, "n = {n}, q = {x} %: {whole}");
                assert!((half / expected - 1.0).abs() < bound, "half n = {n}, q = {x} %: {half}");
                if n % 2 == 0 {
                    let forms = [quick_even_pressure_kernel, quick_high_even_pressure_kernel];
                    for even in forms.map(|form| form(1.0, x as f64 / 100.0, even_weights)) {
                        assert!((even / expected - 1.0).abs() < bound, "even n = {n}, q = {x} %: {even}");
                    }
                }
            }
        }
    }

    /// The largest differences between a tent and the forms for any exponent, in units of ε: of the quick form, and of
    /// the precise one.
    fn largest_differences<T: Scalar>() -> [f64; 2] {
        let [mut quick, mut precise] = [0.0_f64; 2];
        for quarters in 1..=48 {
            let n = T::constant(f64::from(quarters) / 4.0);
            for i in 1..800 {
                let inset = f64::from(i) / 400.0;
                let inset = T::constant(if inset <= 1.0 { inset } else { (-4.0 * inset).exp() });
                let position = Position::<T, DoubleWord<T>>::between(T::one(), T::one() - inset);
                let tent = position.kernel(Exponent::of(n));
                let difference = |found: DoubleWord<T>| {
                    let share = found.plus(-tent).high() / tent.high();
                    share.abs().value() / T::default_epsilon().value()
                };
                let word =
                    real_exponent_kernel::quick_kernel(position.inset.rounded(), position.ratio.rounded(), n);
                quick = worse(quick, difference(DoubleWord::of(word)));
                let mut add = |sum: T| quick = worse(quick, difference(DoubleWord::of(sum)));
                let (one, k) = (T::one(), quarters as usize);
                if k <= 24 {
                    let weights = [(T::constant(0.25), k)];
                    add(quick_pressure_kernel_in_root::<T, 4, 24, 1>(one, one - inset, weights, []));
                }
                if k <= 24 && k % 2 == 0 {
                    let weights = [(T::constant(0.5), k / 2)];
                    add(quick_pressure_kernel_in_root::<T, 2, 12, 1>(one, one - inset, weights, []));
                }
                let kernel = real_exponent_kernel::kernel(position.inset, position.ratio, DoubleWord::of(n));
                precise = worse(precise, difference(kernel));
            }
        }
        [quick, precise]
    }

    /// The kernel of two terms by every form that is rounded once.
    fn kernels_rounded_once<T: Scalar, const FUSED: bool>() -> impl Iterator<Item = [T; 3]> {
        (1..400).flat_map(|k| {
            let (a, r) = (T::constant(7.3 + f64::from(k) / 97.0), T::constant(f64::from(k) / 55.0));
            let [b, c] = [0.025, 1.1e-4].map(T::constant);
            let even = even_pressure_kernel::<T, T, FUSED, 2>(a, r, [b, c]);
            let half = T::constant(0.5);
            let whole =
                whole_pressure_kernel::<T, T, FUSED, 4>(a, r, [T::zero(), b * half, T::zero(), c * half]);
            // Fractions 0, 1/4, 1/2, and others.
            [(2.0, 4.0), (1.25, 3.5), (2.3, 4.1), (0.7, 30.0)].map(|(n, p)| {
                let terms = [(b, Exponent::of(T::constant(n))), (c, Exponent::of(T::constant(p)))];
                [even, whole, pressure_kernel::<_, _, _, FUSED>(a, r, terms)]
            })
        })
    }

    #[test]
    fn fused_and_split_double_words_lead_to_the_same_bits() {
        assert!(kernels_rounded_once::<f64, true>().eq(kernels_rounded_once::<f64, false>()));
        assert!(kernels_rounded_once::<f32, true>().eq(kernels_rounded_once::<f32, false>()));
    }

    #[test]
    fn kernels_of_even_and_of_whole_powers_are_the_same() {
        assert!(kernels_rounded_once::<f64, true>().all(|[even, whole, _]| even == whole));
        assert!(kernels_rounded_once::<f32, true>().all(|[even, whole, _]| even == whole));
    }

    #[test]
    fn tents_agree_with_the_forms_of_any_exponent() {
        for [quick, precise] in [largest_differences::<f64>(), largest_differences::<f32>()] {
            assert!(quick < 8.0, "{quick}");
            assert!(precise < 0.05, "{precise}");
        }
    }
}
