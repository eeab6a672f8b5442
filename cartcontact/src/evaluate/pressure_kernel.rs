//! The pressure kernel G(a, r) of a sum of powers, exact to the edge of the contact.
//!
//! Per term of the gap, G = C/(2 (n+2)²) a^(n+2) K(q) with q = r/a and K(q) = n − (n+2) q² + 2 q^(n+2).
//! K has a double zero at q = 1, where this form loses every digit. The forms below have the zero as a
//! factor, taken from a − r, and a positive rest.
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
//! **Other exponents.** Away from the edge K = n (1 − q²) + 2 q² expm1(n ln q). Near it, with ε = −ln q,
//! K = 2 (n+2) ε (ψ(u) − ψ(v)), u = (n+2) ε, v = 2 ε, ψ(x) = 1 + expm1(−x)/x = x/2! − x²/3! + …, whose
//! difference for small u is taken term by term.
//!
//! Source of K: I. Argatov, Mech. Res. Commun. 38 (2011), Eqs. (26), (28), doi 10.1016/j.mechrescom.2010.11.006.

use super::power::raised_term;
use crate::Scalar;
use crate::scalar::{floor, is_plain};

/// Longest tent: the rounding of p is multiplied by up to a third of its length.
const LONGEST_TENT: u32 = 72;

/// G(a, r) of the gap Σ C r^n over the terms (C, n); zero for r ≥ a.
#[inline]
pub fn pressure_kernel<T: Scalar>(a: T, r: T, terms: impl IntoIterator<Item = (T, T)>) -> T {
    if r >= a {
        return T::zero();
    }
    let edge = Edge { inset: (a - r) / a, ratio: r / a };
    terms.into_iter().fold(T::zero(), |sum, (c, n)| {
        let two = T::constant(2.0);
        let weight = raised_term(c / (two * (n + two) * (n + two)), a, n, 2);
        sum + weight * edge.kernel(n)
    })
}

/// Where a radius lies in the contact: 1 − q from a − r, and q = r/a.
struct Edge<T> {
    inset: T,
    ratio: T,
}

impl<T: Scalar> Edge<T> {
    /// K(q) for the exponent n.
    fn kernel(&self, n: T) -> T {
        let quarters = n * T::constant(4.0);
        let count = floor(quarters);
        // An exponent that carries a derivative must not be taken for a number.
        if T::constant(f64::from(count)) != quarters || !is_plain::<T>() {
            return self.real_exponent(n);
        }
        let count = count.unsigned_abs();
        let (alpha, beta, inverse_degree) = match count % 8 {
            0 => (count / 8, 1, T::constant(2.0)),
            4 => (count / 4, 2, T::one()),
            2 | 6 => (count / 2, 4, T::constant(0.5)),
            _ => (count, 8, T::constant(0.25)),
        };
        if alpha + beta > LONGEST_TENT {
            return self.real_exponent(n);
        }
        let inset = self.inset_of_root(beta);
        tent(alpha, beta, T::one() - inset) * inset * inset * inverse_degree
    }

    /// 1 − p for p = q^(2/β).
    fn inset_of_root(&self, beta: u32) -> T {
        let one = T::one();
        match beta {
            1 => self.inset * (one + self.ratio),
            2 => self.inset,
            _ if self.ratio.is_zero() => one,
            4 => self.inset / (one + self.ratio.sqrt()),
            _ => {
                let root = self.ratio.sqrt();
                self.inset / ((one + root) * (one + root.sqrt()))
            }
        }
    }

    fn real_exponent(&self, n: T) -> T {
        if self.ratio.is_zero() {
            return n;
        }
        let two = T::constant(2.0);
        let depth = -(-self.inset).ln_1p();
        if self.inset > T::constant(0.3) {
            let rise = (-(n * depth)).exp_m1();
            return n * self.inset * (T::one() + self.ratio) + two * self.ratio * self.ratio * rise;
        }
        let (u, v) = ((n + two) * depth, two * depth);
        let difference = if u <= T::constant(3.0) {
            n * depth * psi_divided_difference(u, v)
        } else {
            T::one() + (-u).exp_m1() / u - v * psi_divided_difference(v, T::zero())
        };
        two * (n + two) * depth * difference
    }
}

/// Σ_{j=0}^{α+β−2} min(α (j+1), β (α+β−1−j)) p^j by Horner's rule.
fn tent<T: Scalar>(alpha: u32, beta: u32, p: T) -> T {
    (0..alpha + beta - 1).rev().fold(T::zero(), |sum, j| {
        let coefficient = (alpha * (j + 1)).min(beta * (alpha + beta - 1 - j));
        sum * p + T::constant(f64::from(coefficient))
    })
}

/// (ψ(u) − ψ(v))/(u − v) = Σ_{k≥1} (−1)^(k+1) h_k/(k+1)! with h_k = Σ_{i<k} u^i v^(k−1−i), for 0 ≤ v < u ≤ 3.
///
/// The terms fall faster than 3^k/k!; the loop ends when they no longer count, after 30 at the most.
fn psi_divided_difference<T: Scalar>(u: T, v: T) -> T {
    let (mut homogeneous, mut power) = (T::one(), T::one());
    let mut inverse_factorial = T::constant(0.5);
    let mut sum = inverse_factorial;
    for k in 2..34 {
        power *= v;
        homogeneous = homogeneous * u + power;
        inverse_factorial = -inverse_factorial / T::constant(f64::from(k + 1));
        let addend = homogeneous * inverse_factorial;
        sum += addend;
        if addend.abs() <= T::default_epsilon() * T::constant(0.0625) * sum {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K(q) in exact integers for whole n: q = x/y gives K y^(n+2) = n y^(n+2) − (n+2) x² y^n + 2 x^(n+2).
    fn exact(n: u32, x: i128, y: i128) -> f64 {
        let k = i128::from(n);
        let numerator = k * y.pow(n + 2) - (k + 2) * x * x * y.pow(n) + 2 * x.pow(n + 2);
        numerator as f64 / y.pow(n + 2) as f64
    }

    #[test]
    fn tents_and_logarithms_agree_with_exact_integers() {
        for n in 1..=12 {
            for x in 0..100 {
                let expected = exact(n, x, 100);
                let edge = Edge { inset: (100 - x) as f64 / 100.0, ratio: x as f64 / 100.0 };
                let tent = edge.kernel(f64::from(n));
                let logarithm = edge.real_exponent(f64::from(n));
                assert!((tent / expected - 1.0).abs() < 8.0 * f64::EPSILON, "tent n = {n}, q = {x} %");
                assert!((logarithm / expected - 1.0).abs() < 24.0 * f64::EPSILON, "log n = {n}, q = {x} %");
            }
        }
    }

    #[test]
    fn fractional_tents_agree_with_logarithms() {
        for quarters in 1..=48 {
            let n = f64::from(quarters) / 4.0;
            for i in 1..400 {
                let inset = f64::from(i) / 400.0;
                let edge = Edge { inset, ratio: 1.0 - inset };
                let (tent, logarithm) = (edge.kernel(n), edge.real_exponent(n));
                assert!((tent / logarithm - 1.0).abs() < 64.0 * f64::EPSILON, "n = {n}, 1 - q = {inset}");
            }
        }
    }
}
