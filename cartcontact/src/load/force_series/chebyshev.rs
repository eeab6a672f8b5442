//! Sums of Chebyshev polynomials Σ cₖ Tₖ(ξ) of one degree: interpolation, truncation, derivatives and means.
//!
//! Source: J. C. Mason, D. C. Handscomb, Chebyshev Polynomials (2003), chapters 2.4, 6.3.

use crate::Scalar;
use crate::numbers::cosines::cosine_of_sixteenths;
use crate::numbers::tabled::Tabled;
use crate::scalar::{derivatives, has_no_derivatives};

/// The degree N: the abscissas are [cosines of sixteenths](cosine_of_sixteenths) of π.
pub(super) const DEGREE: usize = 16;

/// The coefficients of Chebyshev polynomials.
pub(super) type Coefficients<T> = [T; DEGREE + 1];

/// The abscissas cos(π j/N), from 1 to −1.
const ABSCISSAS: Coefficients<Tabled> = {
    let mut abscissas = [Tabled::of(0.0); DEGREE + 1];
    let mut j = 0;
    while j <= DEGREE {
        abscissas[j] = Tabled::of(cosine_of_sixteenths(j));
        j += 1;
    }
    abscissas
};

/// What the coefficient k takes of the values at the abscissas j and N − j, j = 0 to N/2: 2/N cos(π j k/N), half of it
/// for the first and the last of either, and half where j and N − j are the same.
const SHARES: [Coefficients<Tabled>; DEGREE / 2 + 1] = {
    let mut shares = [[Tabled::of(0.0); DEGREE + 1]; DEGREE / 2 + 1];
    let mut j = 0;
    while j <= DEGREE / 2 {
        let mut k = 0;
        while k <= DEGREE {
            let of_value = if j == 0 || j == DEGREE / 2 { 0.5 } else { 1.0 };
            let of_coefficient = if k == 0 || k == DEGREE { 0.5 } else { 1.0 };
            shares[j][k] =
                Tabled::of(2.0 / DEGREE as f64 * of_value * of_coefficient * cosine_of_sixteenths(j * k));
            k += 1;
        }
        j += 1;
    }
    shares
};

/// The abscissa cos(π j/N), j from 0 to N.
pub(super) fn abscissa<T: Scalar>(j: usize) -> T {
    ABSCISSAS[j].get()
}

/// The coefficients of the polynomial through values at the [abscissas](abscissa).
pub(super) fn interpolate<T: Scalar>(values: &Coefficients<T>) -> Coefficients<T> {
    let mut coefficients = [T::zero(); DEGREE + 1];
    for (j, shares) in SHARES.iter().enumerate() {
        // cos(π (N − j) k/N) = (−1)ᵏ cos(π j k/N).
        let (sum, difference) = (values[j] + values[DEGREE - j], values[j] - values[DEGREE - j]);
        for (k, (coefficient, share)) in coefficients.iter_mut().zip(shares).enumerate() {
            *coefficient += if k.is_multiple_of(2) { sum } else { difference } * share.get();
        }
    }
    coefficients
}

/// Σ|cₖ| over the last three: if coefficients fall, more than all that they leave out.
pub(super) fn left_out<T: Scalar>(coefficients: &Coefficients<T>) -> T {
    coefficients[DEGREE - 2..].iter().fold(T::zero(), |sum, c| sum + c.abs())
}

/// How many coefficients there are up to the last one that is not negligible.
pub(super) fn length_above<T: Scalar>(coefficients: &[T], negligible: T) -> usize {
    coefficients.iter().rposition(|c| c.abs() > negligible).map_or(1, |last| last + 1)
}

/// Leaves out the values of all coefficients from `length` on, and returns how many are left. Derivatives with respect
/// to a parameter stay: they may count where the force itself hardly varies.
pub(super) fn leave_out<T: Scalar>(coefficients: &mut [T], length: usize) -> usize {
    for c in &mut coefficients[length..] {
        *c = derivatives(*c);
    }
    if has_no_derivatives::<T>() { length } else { coefficients.len() }
}

/// Sums of one length at ξ, in one loop.
pub(super) fn sums_at<T: Scalar, const N: usize>(sums: [&[T]; N], x: T) -> [T; N] {
    let (mut before, mut value) = (T::one(), x);
    let mut totals = sums.map(|sum| sum[0]);
    for degree in 1..sums[0].len() {
        for (total, sum) in totals.iter_mut().zip(sums) {
            *total += sum[degree] * value;
        }
        (before, value) = (value, (x + x) * value - before);
    }
    totals
}

/// The derivative of a sum: d₍ₖ₋₁₎ = d₍ₖ₊₁₎ + 2 k cₖ, with the first one halved.
pub(super) fn derivative<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let mut slope = [T::zero(); DEGREE + 1];
    for k in (1..sum.len()).rev() {
        let above = if k < DEGREE { slope[k + 1] } else { T::zero() };
        slope[k - 1] = above + sum[k] * T::constant(2.0) * T::constant(k as f64);
    }
    slope[0] *= T::constant(0.5);
    slope
}

/// The mean of a sum from ξ to 1.
///
/// With the coefficients aₖ of the integral, let βₖ = 2 β₍ₖ₊₁₎ − β₍ₖ₊₂₎ + aₖ. Then the integral over ξ − 1 is
/// β₁ + 2 Σ β₍ₖ₊₁₎ Tₖ.
pub(super) fn mean_to_the_end<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let at = |k: usize| sum.get(k).copied().unwrap_or(T::zero());
    let two = T::constant(2.0);
    let mut mean = [T::zero(); DEGREE + 1];
    let (mut above, mut next) = (T::zero(), T::zero());
    for k in (1..=sum.len()).rev() {
        let first = if k == 1 { two * at(0) } else { at(k - 1) };
        let of_integral = (first - at(k + 1)) * T::constant(0.5) / T::constant(k as f64);
        (above, next) = (next, two * next - above + of_integral);
        mean[k - 1] = if k == 1 { next } else { two * next };
    }
    mean
}
