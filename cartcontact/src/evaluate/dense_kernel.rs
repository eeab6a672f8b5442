//! The pressure kernel of whole powers by Horner's rule, with all powers up to the highest: of even ones in the squares of
//! both radii, and of others in the radii. Powers that are missing have the weight zero.

use super::arithmetic::{Arithmetic, Word};
use super::coefficient::{Coefficient, added, multiplied, number};
use super::pressure_kernel::pressure_kernel_zero_first;
use crate::Scalar;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::scalar::{from_single, has_no_derivatives};

/// G(a, r) of a gap of even powers, zero for r ≥ a, rounded once: `weights[k − 1]` is C/(n+2)² for n = 2 k.
#[inline(always)]
pub fn even_pressure_kernel<T: Scalar, C: Coefficient<T>, const FUSED: bool, const N: usize>(
    a: T,
    r: T,
    weights: [C; N],
) -> T {
    let sum: DoubleWord<T, FUSED> = sum_of_even_kernels(a, r, &weights);
    sum.rounded_or(|| kernel_term_by_term(a, r, weights, 2))
}

/// [`even_pressure_kernel`] in plain arithmetic, within 8 ε.
#[inline(always)]
pub fn quick_even_pressure_kernel<T: Scalar, const N: usize>(a: T, r: T, weights: [T; N]) -> T {
    let sum: Word<T> = sum_of_even_kernels(a, r, &weights);
    sum.rounded()
}

/// [`quick_even_pressure_kernel`] for high powers: each step multiplies by a and r, which are exact, twice, because
/// Horner's rule would repeat the rounding of their squares with every power. Within 8 ε; where the highest powers prevail,
/// 12 ε next to a power of two.
#[inline(always)]
pub fn quick_high_even_pressure_kernel<T: Scalar, const N: usize>(a: T, r: T, weights: [T; N]) -> T {
    let inset = (a - r) * (a + r);
    match nested_sums::<_, Word<T>>(Unformed::<_, 2>(a), Unformed::<_, 2>(r), &weights) {
        Some((_, sum)) if r < a => inset * sum.rounded() * inset,
        _ => T::zero(),
    }
}

/// G(a, r) of a gap of whole powers, zero for r ≥ a, rounded once: `weights[n − 1]` is C/(2 (n+2)²).
#[inline(always)]
pub fn whole_pressure_kernel<T: Scalar, C: Coefficient<T>, const FUSED: bool, const N: usize>(
    a: T,
    r: T,
    weights: [C; N],
) -> T {
    if !has_no_derivatives::<T>() {
        return kernel_term_by_term(a, r, weights, 1);
    }
    let sum: DoubleWord<T, FUSED> = sum_of_whole_kernels(a, r, &weights);
    sum.rounded_or(|| kernel_term_by_term(a, r, weights, 1))
}

/// G(a, r) of a gap of whole powers in plain arithmetic, zero for r ≥ a, within 8 ε: `weights[n − 1]` is
/// C/(2 (n+2)²).
#[inline(always)]
pub fn quick_whole_pressure_kernel<T: Scalar, const N: usize>(a: T, r: T, weights: [T; N]) -> T {
    if !has_no_derivatives::<T>() {
        return kernel_term_by_term(a, r, weights, 1);
    }
    let sum: Word<T> = sum_of_whole_kernels(a, r, &weights);
    sum.rounded()
}

/// G(a, r) where the weights, C `step`/(2 (n+2)²) of all multiples n of `step`, cannot be summed first: next to the edge
/// their sum may overflow although G does not, and next to the axis the derivatives of the sum of whole powers and of
/// its double zero cancel.
fn kernel_term_by_term<T: Scalar, C: Coefficient<T>, const N: usize>(
    a: T,
    r: T,
    weights: [C; N],
    step: usize,
) -> T {
    let terms = weights.into_iter().enumerate().map(|(index, weight)| {
        let n = (index + 1) * step;
        let per_weight = from_single((2 * (n + 2) * (n + 2) / step) as f32);
        (number::<T, DoubleWord<T>>(weight).times_word(per_weight), Exponent::whole(n as i32))
    });
    pressure_kernel_zero_first(a, r, terms)
}

/// (a² − r²)² Σ_k w_k Σ_{j<k} (k−j) R^j A^(k−1−j) without a division, with A = a² and R = r². The sum over the
/// power of R is
///
/// ```text
/// Σ_j R^j D_j,    D_j = E_j + A D_{j+1},    E_j = w_{j+1} + A E_{j+1},
/// ```
///
/// all of it by Horner's rule, so that nothing on the way is larger than the weights or the result.
#[inline(always)]
fn sum_of_even_kernels<T: Scalar, A: Arithmetic<T>>(a: T, r: T, weights: &[impl Coefficient<T>]) -> A {
    let (a_squared, r_squared) = (A::product(a, a), A::product(r, r));
    let inset = A::sum(a, -r).times(A::sum(a, r));
    match nested_sums(Value(a_squared), Value(r_squared), weights) {
        Some((_, sum)) if r < a => inset.times(sum).times(inset),
        _ => A::of(T::zero()),
    }
}

/// (a − r)² Σ_n w_n U_n for whole n from 1 on, where (a − r)² U_n = a^(n+2) K. From K follow the differences
///
/// ```text
/// U_n − a U_{n−1} = H_n + r H_{n−1},    H_n = Σ_{j≤n} a^(n−j) r^j,
/// ```
///
/// so that with the D and Σ r^j D_j of [`nested_sums`] the sum is a D + 2 r Σ r^j D_j.
#[inline(always)]
fn sum_of_whole_kernels<T: Scalar, A: Arithmetic<T>>(a: T, r: T, weights: &[impl Coefficient<T>]) -> A {
    let inset = A::sum(a, -r);
    match nested_sums::<_, A>(Unformed::<_, 1>(a), Unformed::<_, 1>(r), weights) {
        Some((d, sum)) if r < a => {
            let sum = d.times_word(a).plus(sum.times_word(r + r));
            inset.times(sum).times(inset)
        }
        _ => A::of(T::zero()),
    }
}

/// A variable that Horner's rule multiplies by.
trait Variable<T, A>: Copy {
    fn times(self, number: A) -> A;
    fn times_coefficient(self, coefficient: impl Coefficient<T>) -> A;
}

/// A variable as a number.
#[derive(Clone, Copy)]
struct Value<A>(A);

impl<T: Scalar, A: Arithmetic<T>> Variable<T, A> for Value<A> {
    #[inline(always)]
    fn times(self, number: A) -> A {
        number.times(self.0)
    }
    #[inline(always)]
    fn times_coefficient(self, coefficient: impl Coefficient<T>) -> A {
        multiplied(self.0, coefficient)
    }
}

/// A power of a word, which is not formed: a product with it is `TIMES` products with the word.
#[derive(Clone, Copy)]
struct Unformed<T, const TIMES: usize>(T);

impl<T: Scalar, A: Arithmetic<T>, const TIMES: usize> Variable<T, A> for Unformed<T, TIMES> {
    #[inline(always)]
    fn times(self, number: A) -> A {
        (0..TIMES).fold(number, |product, _| product.times_word(self.0))
    }
    #[inline(always)]
    fn times_coefficient(self, coefficient: impl Coefficient<T>) -> A {
        self.times(number(coefficient))
    }
}

/// D_0 and Σ_j r^j D_j, with D_j = E_j + a D_{j+1} and E_j = w_{j+1} + a E_{j+1}.
#[inline(always)]
fn nested_sums<T: Scalar, A: Arithmetic<T>>(
    a: impl Variable<T, A>,
    r: impl Variable<T, A>,
    weights: &[impl Coefficient<T>],
) -> Option<(A, A)> {
    let (&highest, lower) = weights.split_last()?;
    let Some((&second, lower)) = lower.split_last() else {
        return Some((number(highest), number(highest)));
    };
    let product = a.times_coefficient(highest);
    let mut e = added(product, second);
    let mut d = e.plus(product);
    let mut sum = r.times_coefficient(highest).plus(d);
    for &weight in lower.iter().rev() {
        e = added(a.times(e), weight);
        d = a.times(d).plus(e);
        sum = r.times(sum).plus(d);
    }
    Some((d, sum))
}

#[cfg(test)]
mod tests {
    use super::super::pressure_kernel::pressure_kernel;
    use super::*;

    /// (a − r)² (w₁ (a + 2 r) + w₃ (3 a³ + 6 a² r + 4 a r² + 2 r³)) in small integers.
    #[test]
    fn kernels_of_whole_powers_are_rounded_once() {
        for a in 1..=24 {
            for r in 0..=a {
                let [w1, w3] = [7, 3];
                let sum =
                    w1 * (a + 2 * r) + w3 * (3 * a * a * a + 6 * a * a * r + 4 * a * r * r + 2 * r * r * r);
                let exact = f64::from((a - r) * (a - r) * sum);
                let [a, r, w1, w3] = [a, r, w1, w3].map(f64::from);
                let found = [
                    whole_pressure_kernel::<_, _, true, 3>(a, r, [w1, 0.0, w3]),
                    whole_pressure_kernel::<_, _, false, 3>(a, r, [w1, -0.0, w3]),
                ];
                assert_eq!(found, [exact; 2], "{a}, {r}");
            }
        }
    }

    /// The sum of the weights alone overflows there.
    #[test]
    fn kernels_next_to_the_edge_are_in_range() {
        let (mut weights, coefficient) = ([-0.0_f32; 17], 26_198.0);
        weights[16] = coefficient / 722.0;
        let (a, r) = (121.053_54, 121.053_53);
        let term = [(coefficient, Exponent::whole(17))];
        let (whole, alone) = (
            whole_pressure_kernel::<_, _, false, 17>(a, r, weights),
            pressure_kernel::<_, _, _, false>(a, r, term),
        );
        assert!(whole > 1e29 && (whole / alone - 1.0).abs() < 2.0 * f32::EPSILON, "{whole:e}, {alone:e}");
    }
}
