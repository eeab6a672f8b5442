//! The kernel of one term of a gap: C/(2 (n+2)²) a^(n+2) K(q), with the double zero of K at the edge as a factor.
//!
//! **Exponents that are multiples of 1/4.** Put q = p^d with d = 1/2, 1, 2 or 4, so that every power is whole,
//! and α = n d, β = 2 d. Then d K = α − (α+β) p^β + β p^(α+β); dividing by (1 − p) twice sums its coefficients
//! twice, which gives
//!
//! ```text
//! d K = (1 − p)² Σ_{j=0}^{α+β−2} min(α (j+1), β (α+β−1−j)) p^j
//! ```
//!
//! a polynomial whose coefficients rise along one line and fall along another: a tent, all positive.
//!
//! **Other exponents.** Through logarithms: see [`real_exponent_kernel`](super::real_exponent_kernel).

use super::arithmetic::Arithmetic;
use super::coefficient::{Coefficient, number};
use crate::Scalar;
use crate::numbers::exponent::Exponent;
use crate::scalar::{floor, has_no_derivatives, smallest_normal};

/// The longest tent. The time for a tent grows with its length, that for logarithms does not.
const LONGEST_TENT: u32 = 72;

/// The order in which a coefficient is multiplied by the power of a radius and by K, which has the zero at the edge.
#[derive(Clone, Copy)]
pub(super) enum Order {
    /// Small coefficients keep their digits.
    PowerFirst,
    /// No power is larger than the result, or half of it comes first where the product with K would lose digits.
    ZeroFirst,
}

/// Where a radius lies in the contact of radius a: 1 − q from a − r, and q = r/a.
pub(super) struct Position<T, A> {
    a: T,
    pub(super) inset: A,
    pub(super) ratio: A,
}

impl<T: Scalar, A: Arithmetic<T>> Position<T, A> {
    #[inline(always)]
    pub(super) fn between(a: T, r: T) -> Self {
        let whole = A::of(a);
        Self { a, inset: A::sum(a, -r).over(whole), ratio: A::of(r).over(whole) }
    }

    /// C/(2 (n+2)²) a^(n+2) K(q) for a term (C, n).
    #[inline(always)]
    pub(super) fn kernel_of_term<C: Coefficient<T>>(&self, (c, n): (C, Exponent<T>), order: Order) -> A {
        let (next, two) = (A::exponent(n.plus(2)), T::constant(2.0));
        let weight = number::<T, A>(c).over(next.times(next).times_word(two));
        match order {
            Order::PowerFirst => self.times_power(weight, n).times(self.kernel(n)),
            Order::ZeroFirst => self.zero_first(weight, n),
        }
    }

    /// `weight` K(q) a^(n+2), where a^(n+2) may be too large for the format, and K small.
    ///
    /// A weight may be so small that its product with K loses digits. Then half of the power comes before K: in digits,
    /// that leads about half-way from the weight to its product with all of the power, which leaves room for K.
    fn zero_first(&self, weight: A, n: Exponent<T>) -> A {
        let kernel = self.kernel(n);
        let factor = weight.times(kernel);
        if factor.rounded().abs() >= smallest_normal() {
            return self.times_power(factor, n);
        }
        let half = n.whole / 2;
        let factor = A::term(weight, self.a, n.plus(-half)).times_word(self.a).times(kernel);
        A::term(factor, self.a, Exponent::whole(half)).times_word(self.a)
    }

    /// `factor` a^(n+2), in two steps: quick powers above the third take double words, too, and the exponents of most
    /// gaps are lower.
    #[inline(always)]
    fn times_power(&self, factor: A, n: Exponent<T>) -> A {
        A::term(factor, self.a, n).times_word(self.a).times_word(self.a)
    }

    /// K(q) for the exponent n.
    #[inline(always)]
    pub(super) fn kernel(&self, n: Exponent<T>) -> A {
        let tent = if n.rest.is_zero() { self.tent(n.value()) } else { None };
        tent.unwrap_or_else(|| A::kernel_of_real_exponent(self.inset, self.ratio, n))
    }

    /// K(q) for a multiple n of 1/4, if its tent is not too long.
    #[inline(always)]
    fn tent(&self, n: T) -> Option<A> {
        let quarters = n * T::constant(4.0);
        let count = floor(quarters);
        // An exponent that carries a derivative must not be taken for a number.
        if T::constant(f64::from(count)) != quarters || !has_no_derivatives::<T>() {
            return None;
        }
        let count = count.unsigned_abs();
        let (alpha, beta, inverse_degree) = match count % 8 {
            0 => (count / 8, 1, T::constant(2.0)),
            4 => (count / 4, 2, T::one()),
            2 | 6 => (count / 2, 4, T::constant(0.5)),
            _ => (count, 8, T::constant(0.25)),
        };
        if alpha + beta > LONGEST_TENT {
            return None;
        }
        let (root, inset) = self.root(beta);
        Some(tent(alpha, beta, root).times(inset).times(inset).times_word(inverse_degree))
    }

    /// p = q^(2/β) and 1 − p.
    #[inline(always)]
    fn root(&self, beta: u32) -> (A, A) {
        let (one, inset, ratio) = (T::one(), self.inset, self.ratio);
        match beta {
            1 => (ratio.times(ratio), inset.times(ratio.plus_word(one))),
            2 => (ratio, inset),
            _ if ratio.rounded().is_zero() => (ratio, A::of(one)),
            4 => {
                let root = ratio.sqrt();
                (root, inset.over(root.plus_word(one)))
            }
            _ => {
                let root = ratio.sqrt();
                let fourth_root = root.sqrt();
                (fourth_root, inset.over(root.plus_word(one).times(fourth_root.plus_word(one))))
            }
        }
    }
}

/// Σ_{j=0}^{α+β−2} min(α (j+1), β (α+β−1−j)) p^j by Horner's rule.
#[inline(always)]
fn tent<T: Scalar, A: Arithmetic<T>>(alpha: u32, beta: u32, p: A) -> A {
    let mut sum = A::of(T::zero());
    for j in (0..alpha + beta - 1).rev() {
        let coefficient = (alpha * (j + 1)).min(beta * (alpha + beta - 1 - j));
        sum = sum.times(p).plus_word(T::constant(f64::from(coefficient)));
    }
    sum
}
