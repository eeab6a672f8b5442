//! K(q) = n − (n+2) q² + 2 q^(n+2) of the pressure kernel for exponents that do not lead to whole powers.
//!
//! **In plain arithmetic.** Away from the edge K = n (1 − q²) + 2 q² expm1(n ln q). Near it, with λ = −ln q,
//! K = 2 (n+2) λ (ψ(u) − ψ(v)), u = (n+2) λ, v = 2 λ, ψ(x) = 1 + expm1(−x)/x = x/2! − x²/3! + …, whose
//! difference for small u is taken term by term.
//!
//! **Rounded once.** The first form, with a few more digits in logarithm and exponential, from the centre to
//! u = (n+2)(1 − q) = 1/4, where K is a ninth of what cancels. Nearer to the edge the binomial series of q^(n+2) in
//! δ = 1 − q, whose terms up to δ cancel; the next is n (n+2) δ²:
//!
//! ```text
//! K = n (n+2) δ² (1 − (n+1)/3 δ (1 − (n−1)/4 δ (1 − (n−2)/5 δ (1 − …))))
//! ```

use crate::Scalar;
use crate::in_double_words;
use crate::numbers::double_functions::{double_log_of_ratio, negative_exp_m1};
use crate::numbers::double_word::DoubleWord;
use crate::scalar::{has_no_derivatives, smallest_normal};

/// K(q) from 1 − q and q, with the error of about ten roundings.
pub(super) fn quick_kernel<T: Scalar>(inset: T, ratio: T, n: T) -> T {
    let two = T::constant(2.0);
    let square = ratio * ratio;
    // 1/q², which the second derivative of ln q is, must not leave the format.
    if square < smallest_normal::<T>() * T::constant(4.0) {
        return n - (n + two) * square;
    }
    let is_near_axis = ratio < T::constant(0.25);
    // −ln q from q or from 1 − q, whichever has more digits.
    let depth = if is_near_axis { -ratio.ln() } else { -(-inset).ln_1p() };
    // From here to the axis the two parts of K add up to less than six times their difference, for any n.
    if inset > T::constant(0.3) {
        let rise = (-(n * depth)).exp_m1();
        // n (1 − q²) in the form whose derivative does not cancel.
        let fall = if is_near_axis { n - n * square } else { n * inset * (T::one() + ratio) };
        return fall + two * square * rise;
    }
    let (u, v) = ((n + two) * depth, two * depth);
    let difference = if u <= T::constant(3.0) {
        n * depth * psi_divided_difference(u, v)
    } else {
        T::one() + (-u).exp_m1() / u - v * psi_divided_difference(v, T::zero())
    };
    two * (n + two) * depth * difference
}

/// (ψ(u) − ψ(v))/(u − v) = Σ_{k≥1} (−1)^(k+1) h_k/(k+1)! with h_k = Σ_{i<k} u^i v^(k−1−i), for 0 ≤ v < u ≤ 3.
///
/// The terms fall faster than 3^k/k!; the loop ends when they no longer count, after at most 30.
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

/// K(q) from 1 − q and q, to a few digits more than a word has. A function of its own, too long to be part of others: it
/// chooses its instructions again.
pub(super) fn kernel<T: Scalar, const FUSED: bool>(
    inset: DoubleWord<T, FUSED>,
    ratio: DoubleWord<T, FUSED>,
    n: DoubleWord<T, FUSED>,
) -> DoubleWord<T, FUSED> {
    if !has_no_derivatives::<T>() {
        return DoubleWord::of(quick_kernel(inset.rounded(), ratio.rounded(), n.rounded()));
    }
    in_double_words!(FUSED => {
        let [inset, ratio, n] = [inset, ratio, n].map(DoubleWord::converted);
        kernel_without_derivatives::<T, FUSED>(inset, ratio, n).converted()
    })
}

/// [`kernel`] of numbers without derivatives, and without that choice.
#[inline(always)]
fn kernel_without_derivatives<T: Scalar, const FUSED: bool>(
    inset: DoubleWord<T, FUSED>,
    ratio: DoubleWord<T, FUSED>,
    n: DoubleWord<T, FUSED>,
) -> DoubleWord<T, FUSED> {
    let epsilon = T::default_epsilon();
    if ratio.high() <= epsilon * epsilon {
        // This leaves out at most 2 q² (1 − ln q), for any n.
        return n;
    }
    let next = n.plus_word(T::constant(2.0));
    if next.high() * inset.high() < T::constant(0.25) {
        return kernel_near_edge(inset, next, n);
    }
    let rise = negative_exp_m1(double_log_of_ratio(ratio, inset).times(n));
    let square = ratio.times(ratio);
    let fall = inset.times(ratio.plus_word(T::one())).times(n);
    fall.plus(square.times(rise).scaled(T::constant(2.0)))
}

/// The binomial series for u = (n+2) δ < 1/4, in which no term is above 0.11 of the one before.
#[inline(always)]
fn kernel_near_edge<T: Scalar, const FUSED: bool>(
    inset: DoubleWord<T, FUSED>,
    next: DoubleWord<T, FUSED>,
    n: DoubleWord<T, FUSED>,
) -> DoubleWord<T, FUSED> {
    let (one, third) = (T::one(), DoubleWord::of(T::one()).over(DoubleWord::of(T::constant(3.0))));
    // The terms left out are 1e-18 of the factor of (n+1)/3 δ, and that product is at most 1/12.
    let rest = (1..=16).rev().fold(one, |rest, j| {
        let share = T::constant(1.0 / f64::from(j + 3)) * inset.high();
        one - (n.high() - T::constant(f64::from(j))) * share * rest
    });
    let slope = n.plus_word(one).times(inset).times(third).times_word(rest);
    let leading = next.times(n).times(inset).times(inset);
    leading.times((-slope).plus_word(one))
}
