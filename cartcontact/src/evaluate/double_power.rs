//! Terms c · x^n and their sums in double words, for any real exponent: what is rounded once.

use super::coefficient::{Coefficient, number};
use super::power::{plain_term, quarter_power, quarters, quick_power_sum, real_fractional_power};
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::numbers::double_functions;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::scalar::{has_no_derivatives, is_normal_and_positive};

/// Σ c x^n over the terms (c, n), rounded once.
#[inline(always)]
pub fn power_sum<T, C, I, const FUSED: bool>(x: T, terms: I) -> T
where
    T: Scalar,
    C: Coefficient<T>,
    I: IntoIterator<Item = (C, Exponent<T>), IntoIter: Clone>,
{
    weighted_power_sum::<T, FUSED>(x, terms.into_iter().map(|(c, n)| (number(c), n)))
}

/// Σ c x^n with coefficients that are not rounded, rounded once.
#[inline(always)]
pub(crate) fn weighted_power_sum<T: Scalar, const FUSED: bool>(
    x: T,
    terms: impl Iterator<Item = (DoubleWord<T, FUSED>, Exponent<T>)> + Clone,
) -> T {
    // No `fold`, which need not be inlined.
    let mut sum = DoubleWord::of(T::zero());
    for (c, n) in terms.clone() {
        sum = sum.plus(double_term(c, x, n));
    }
    sum.rounded_or(|| quick_power_sum(x, terms.map(|(c, n)| (c.rounded(), n))))
}

/// c x^n in twice the working precision; to a few digits more than a word has, if the exponent is no multiple of 1/4.
#[inline(always)]
pub(super) fn double_term<T: Scalar, const FUSED: bool>(
    c: DoubleWord<T, FUSED>,
    x: T,
    n: Exponent<T>,
) -> DoubleWord<T, FUSED> {
    if !x.is_zero() {
        let term = double_product(c, x, n, T::one());
        if term.rounded().is_finite() {
            return term;
        }
    }
    out_of_line(|| double_term_out_of_range(c, x, n))
}

/// A term that is zero, or near the end of the range: the exact products overflow a little before their results do.
fn double_term_out_of_range<T: Scalar, const FUSED: bool>(
    c: DoubleWord<T, FUSED>,
    x: T,
    n: Exponent<T>,
) -> DoubleWord<T, FUSED> {
    if !x.is_zero() {
        let (down, up) = (T::constant(1.0 / 4_294_967_296.0), T::constant(4_294_967_296.0));
        let term = double_product(c, x, n, down).scaled(up);
        if term.rounded().is_finite() {
            return term;
        }
    }
    DoubleWord::of(plain_term(c.rounded(), x, n))
}

/// The term times a power of two. It multiplies the middle value, as c may have no digits to spare.
#[inline(always)]
fn double_product<T: Scalar, const FUSED: bool>(
    c: DoubleWord<T, FUSED>,
    x: T,
    n: Exponent<T>,
    power_of_two: T,
) -> DoubleWord<T, FUSED> {
    let degree = n.whole.max(0) as u32;
    let even = if degree < 2 {
        c.scaled(power_of_two)
    } else {
        let half = DoubleWord::of(x).power(degree / 2);
        half.times(c).scaled(power_of_two).times(half)
    };
    let power = if degree & 1 == 1 { even.times_word(x) } else { even };
    let mut term = power.times(double_fractional_power(x, n));
    // Only slopes of gaps with an exponent below 1.
    for _ in n.whole..0 {
        term = term.over(DoubleWord::of(x));
    }
    term
}

/// [`fractional_power`](super::power::fractional_power) in twice the working precision, or to a few digits more than a
/// word has.
#[inline(always)]
fn double_fractional_power<T: Scalar, const FUSED: bool>(x: T, n: Exponent<T>) -> DoubleWord<T, FUSED> {
    match quarters(x, n.fraction).filter(|_| n.rest.is_zero()) {
        Some(0) => DoubleWord::of(T::one()),
        Some(quarters) => quarter_power(DoubleWord::of(x), quarters, DoubleWord::sqrt, DoubleWord::times),
        None if has_no_derivatives::<T>() && is_normal_and_positive(x) => {
            double_functions::fractional_power(x, DoubleWord::sum(n.fraction, n.rest))
        }
        None => DoubleWord::of(real_fractional_power(x, n.fraction)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_raised_sum_is_rounded_once_up_to_the_end_of_the_range() {
        raised_sums_are_rounded_once::<true>();
        raised_sums_are_rounded_once::<false>();
    }

    fn raised_sums_are_rounded_once<const FUSED: bool>() {
        let raised = |c, x, n| {
            weighted_power_sum::<f32, FUSED>(x, [(DoubleWord::of(c), Exponent::of(n).plus(4))].into_iter())
        };
        for k in 1500..1700 {
            let x = k as f32 * 0.1;
            let sum = raised(1.5, x, 12.0);
            let exact = 1.5 * f64::from(x).powi(16);
            let error = (f64::from(sum) / exact - 1.0).abs() / f64::from(f32::EPSILON);
            assert!(error < 0.51, "{x}: {error} ε");
        }
        // The product with the coefficient is small, where that has no digits to spare.
        for k in 1150..1200 {
            let x = k as f32 * 0.01;
            let c = 1e-34_f32;
            let sum = raised(c, x, 60.0);
            let exact = f64::from(c) * f64::from(x).powi(64);
            let error = (f64::from(sum) / exact - 1.0).abs() / f64::from(f32::EPSILON);
            assert!(error < 0.51, "{x}: {error} ε");
        }
    }

    #[test]
    fn nothing_times_a_power_out_of_range_is_nothing() {
        let terms = [(2.0, Exponent::of(1.0)), (0.0, Exponent::of(48.0))];
        assert_eq!(power_sum::<_, _, _, true>(1e20, terms), 2e20);
        assert_eq!(power_sum::<_, _, _, false>(1e20, terms), 2e20);
    }
}
