//! Terms c · x^n and their sums, for any real exponent.

use crate::Scalar;
use crate::numbers::bits::{rough_ln, with_half_its_digits};
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::scalar::{has_no_derivatives, is_plain_zero, of_values, smallest_normal};

/// x^k by binary powering.
#[inline]
pub fn integer_power<T: Scalar>(x: T, k: u32) -> T {
    let (mut power, mut square, mut rest) = (T::one(), x, k);
    while rest > 1 {
        if rest & 1 == 1 {
            power *= square;
        }
        square *= square;
        rest >>= 1;
    }
    if rest == 1 { power * square } else { power }
}

/// x^k, k ≥ 4, of a number with half its digits, and its excess, which comes from the rounding of the fourth power.
/// No more products are rounded than in the power k/2 of a number.
#[inline(always)]
pub fn power_of_half_digits<T: Scalar>(x: T, k: u32) -> (T, T) {
    let square = x * x;
    let (head, fourth) = (with_half_its_digits(square), square * square);
    let rest = square - head;
    let lost = ((head * head - fourth) + T::constant(2.0) * head * rest) + rest * rest;
    let beside = integer_power(x, k % 4);
    let slope = integer_power(fourth, k / 4 - 1) * beside;
    (slope * fourth, -(T::constant(f64::from(k / 4)) * slope * lost))
}

/// x^n for a parameter x of the geometry, to first order in what a word of n lacks: that puts b^5.8 off by 22 ε in single
/// precision where b is 1e6, and all radii of a geometry alike.
#[inline]
pub fn real_power<T: Scalar>(x: T, n: Exponent<T>) -> T {
    let power = x.powf(n.value());
    // An infinite one stays so.
    if power.is_finite() { with_rest(power, x, n.lacking()) } else { power }
}

/// Σ c x^n over the terms (c, n), each term within 4 ε of its value: for sums that are only integrated.
#[inline]
pub fn quick_power_sum<T: Scalar>(x: T, terms: impl IntoIterator<Item = (T, Exponent<T>)>) -> T {
    terms.into_iter().fold(T::zero(), |sum, (c, n)| sum + term(c, x, n))
}

/// Σ c x^n and Σ n c x^n, quicker but only within n ε, which is enough for a Newton step.
#[inline]
pub fn power_sum_and_log_slope<T: Scalar>(x: T, terms: impl IntoIterator<Item = (T, Exponent<T>)>) -> (T, T) {
    terms.into_iter().fold((T::zero(), T::zero()), |(sum, slope), (c, n)| {
        let value = plain_term(c, x, n);
        (sum + value, slope + n.value() * value)
    })
}

/// Σ c (a^p − (a − depth)^p) for 0 ≤ depth ≤ a without cancellation, as −Σ c a^p expm1(p ln(1 − depth/a)).
#[inline]
pub fn power_sum_drop<T: Scalar>(a: T, depth: T, terms: impl IntoIterator<Item = (T, Exponent<T>)>) -> T {
    if is_plain_zero(depth) {
        return T::zero();
    }
    // Nothing is left of any term. The derivative of ln 0 times 0 would be NaN.
    if depth >= a {
        return terms.into_iter().fold(T::zero(), |sum, (c, p)| sum + term_of_drop(c, a, p));
    }
    let log_ratio = (-depth / a).ln_1p();
    terms
        .into_iter()
        .fold(T::zero(), |sum, (c, p)| sum - term_of_drop(c, a, p) * (p.value() * log_ratio).exp_m1())
}

/// c x^n within 14 ε at the most, which is enough for a drop: powers up to the 24th have every product rounded.
#[inline]
pub(super) fn term_of_drop<T: Scalar>(c: T, x: T, n: Exponent<T>) -> T {
    if n.value() <= T::constant(24.0) { plain_term(c, x, n) } else { term(c, x, n) }
}

/// c x^n within 4 ε, and mostly 2: whole powers above the third in twice the working precision, all others rounded. The
/// most is that of x^3.75, four products and three quarters, whose roots and product are off by 1.75 ε.
///
/// With n = k + φ the power is formed in halves, (c · x^⌊k/2⌋) · x^⌈k/2⌉: the middle value is the geometric mean of c
/// and the result, so it is in range whenever both of them are.
#[inline]
pub(crate) fn term<T: Scalar>(c: T, x: T, n: Exponent<T>) -> T {
    if n.whole < 0 || x.is_zero() {
        return plain_term(c, x, n);
    }
    let degree = n.whole as u32;
    let power = if degree < 4 {
        integer_power(x, degree) * c
    } else {
        let half = <DoubleWord<T>>::of(x).power(degree / 2);
        let even = half.times_word(c).times(half);
        if degree & 1 == 1 { even.times_word(x).rounded() } else { even.rounded() }
    };
    // The exact products overflow a little before their results do.
    if power.is_finite() { power * power_below_one(x, n) } else { plain_term(c, x, n) }
}

/// [`term`] with every product rounded.
pub(super) fn plain_term<T: Scalar>(c: T, x: T, n: Exponent<T>) -> T {
    // The power may be out of range; a zero that carries a derivative does not count as zero.
    if is_plain_zero(c) {
        return c;
    }
    if n.whole < 0 && x.is_zero() {
        return c / x;
    }
    if n.whole < 0 {
        // Only slopes of gaps with an exponent below 1. Changing the sign of the exponent would round its fraction.
        return plain_term(c, x, n.plus(1)) / x;
    }
    let term = plain_whole_term(c, x, n.whole as u32) * power_below_one(x, n);
    // A zero with a derivative times an infinite power is NaN. Its derivative becomes one that the format just holds.
    if c.is_zero() && !term.is_finite() { c / smallest_normal() } else { term }
}

/// c x^k with every product rounded, in halves.
#[inline(always)]
pub(crate) fn plain_whole_term<T: Scalar>(c: T, x: T, degree: u32) -> T {
    let half = integer_power(x, degree / 2);
    let even = c * half * half;
    if degree & 1 == 1 { even * x } else { even }
}

/// x^(n − ⌊n⌋): what the fraction of n lacks, up to ε/4, moves a power of 1e-50 by 29 ε.
#[inline]
fn power_below_one<T: Scalar>(x: T, n: Exponent<T>) -> T {
    with_rest(fractional_power(x, n.fraction), x, n.rest)
}

/// A power of x with a `rest` added to its exponent, to first order.
#[inline(always)]
fn with_rest<T: Scalar>(power: T, x: T, rest: T) -> T {
    if rest.is_zero() { power } else { power + power * (rest * rough_ln(x)) }
}

/// x^φ for 0 ≤ φ < 1: multiples of 1/4 by square roots, which round better than `powf` and cost less.
pub(crate) fn fractional_power<T: Scalar>(x: T, fraction: T) -> T {
    match quarters(x, fraction) {
        Some(0) => T::one(),
        Some(quarters) => plain_quarter_power(x, quarters),
        None => real_fractional_power(x, fraction),
    }
}

/// x^(`QUARTERS`/4) for 1, 2 and 3, with the derivatives that a power has.
#[inline(always)]
pub fn quarter_root<T: Scalar, const QUARTERS: u8>(x: T) -> T {
    if has_no_derivatives::<T>() {
        plain_quarter_power(x, QUARTERS)
    } else {
        real_fractional_power(x, T::constant(0.25 * f64::from(QUARTERS)))
    }
}

/// [`quarter_power`] with every operation rounded.
#[inline(always)]
fn plain_quarter_power<T: Scalar>(x: T, quarters: u8) -> T {
    quarter_power(x, quarters, |x| x.sqrt(), |x, y| x * y)
}

/// x^(k/4) for k = 1, 2 and 3 by square roots, in any arithmetic.
#[inline(always)]
pub(super) fn quarter_power<X: Copy>(
    x: X,
    quarters: u8,
    sqrt: impl Fn(X) -> X,
    times: impl Fn(X, X) -> X,
) -> X {
    let root = sqrt(x);
    match quarters {
        1 => sqrt(root),
        2 => root,
        _ => times(root, sqrt(root)),
    }
}

/// 4 φ, if that is whole and neither number can carry a derivative that a root would lose.
#[inline]
pub(super) fn quarters<T: Scalar>(x: T, fraction: T) -> Option<u8> {
    quarters_of_value(x, fraction).filter(|_| has_no_derivatives::<T>())
}

/// 4 φ, if that is whole and x is not zero.
#[inline]
pub(super) fn quarters_of_value<T: Scalar>(x: T, fraction: T) -> Option<u8> {
    // Not a loop: small code would convert its constants one by one.
    let whole = if fraction.is_zero() {
        0
    } else if fraction == T::constant(0.25) {
        1
    } else if fraction == T::constant(0.5) {
        2
    } else if fraction == T::constant(0.75) {
        3
    } else {
        return None;
    };
    (!x.is_zero()).then_some(whole)
}

/// x^φ for 0 ≤ φ < 1 by a library's power, with derivatives with respect to both; 0 to a power above 0 has none.
pub(super) fn real_fractional_power<T: Scalar>(x: T, fraction: T) -> T {
    // Zero has no finite slope here; dual numbers would turn it into NaN.
    if x.is_zero() {
        return if fraction.is_zero() { T::one() } else { T::zero() };
    }
    // The exponent may carry a derivative, even where its fraction is zero.
    if has_no_derivatives::<T>() { x.powf(fraction) } else { (fraction * x.ln()).exp() }
}

/// The value of [`real_fractional_power`], without derivatives.
pub(super) fn value_of_fractional_power<T: Scalar>(x: T, fraction: T) -> T {
    of_values([x, fraction], |[x, p]| real_fractional_power(x, p), |[x, p]| real_fractional_power(x, p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::double_power::double_term;

    fn term(c: f64, x: f64, n: f64) -> f64 {
        super::term(c, x, Exponent::of(n))
    }

    #[test]
    fn whole_powers_of_small_integers_are_exact() {
        for k in 0..33 {
            let expected = 3u64.pow(k) as f64;
            assert_eq!(integer_power(3.0, k), expected);
            assert_eq!(term(1.0, 3.0, f64::from(k)), expected);
        }
    }

    /// Against double words: every product after the fourth power leaves half an ε.
    #[test]
    fn powers_of_half_the_digits_know_what_they_lost() {
        for (k, products) in [(5, 1.0), (8, 1.0), (9, 2.0), (10, 2.0), (11, 3.0), (12, 2.0), (19, 5.0)] {
            for step in 0..2000 {
                let x = with_half_its_digits(1.0 + f64::from(step) / 2001.0);
                let (power, excess) = power_of_half_digits(x, k);
                let error = <DoubleWord<f64>>::of(x).power(k).plus_word(-power).plus_word(excess).high();
                assert!(error.abs() < 0.501 * products * f64::EPSILON * power, "{x}^{k}: {error}");
            }
        }
    }

    #[test]
    fn fractions_are_roots() {
        assert_eq!(term(2.0, 16.0, 0.25), 4.0);
        assert_eq!(term(2.0, 16.0, 2.75), 2.0 * 256.0 * 8.0);
        assert_eq!(term(2.0, 16.0, -0.5), 0.5);
        assert_eq!(term(2.0, 0.0, 2.5), 0.0);
    }

    /// r^2.37 and r^6.1, exponents that no number of the format is.
    #[test]
    fn tiny_and_huge_powers_have_an_exponent_with_all_its_digits() {
        let exponents = [
            Exponent::in_parts(2, 0.37, 4.440892098500626e-18),
            Exponent::in_parts(6, 0.1, -5.551115123125783e-18),
        ];
        for n in exponents {
            for x in [1e-45, 1e-20, 1e-3, 7.0, 1e20, 1e45] {
                let exact = double_term(<DoubleWord<f64>>::of(3.0), x, n);
                for found in [super::term(3.0, x, n), super::plain_term(3.0, x, n)] {
                    let error = exact.plus_word(-found).high() / found;
                    assert!(error.abs() < 4.0 * f64::EPSILON, "{x:e}^{}: {error:e}", n.value());
                }
            }
        }
    }

    #[test]
    fn powers_of_parameters_have_an_exponent_with_all_its_digits() {
        let n = Exponent::<f32>::in_parts(-4, 0.3, -1.110_223_024_625_156_6e-17);
        for x in [f32::MIN_POSITIVE, 1.3e-6, 0.7, 1.0, 9.1e8] {
            let (found, expected) = (real_power(x, n), f64::from(x).powf(-3.7));
            let error = (f64::from(found) / expected - 1.0) / f64::from(f32::EPSILON);
            assert!(found.is_infinite() || error.abs() < 1.0, "{x:e}: {error} ε");
        }
        let n = Exponent::<f64>::in_parts(2, 0.3, 1.110_223_024_625_156_6e-17);
        assert_eq!([0.0, f64::INFINITY].map(|x| real_power(x, n)), [0.0, f64::INFINITY]);
    }

    #[test]
    fn nothing_overflows_on_the_way_to_a_representable_result() {
        let value: f64 = term(1e-300, 1e60, 10.0);
        assert!((value / 1e300 - 1.0).abs() < 1e-15, "{value:e}");
        let value: f64 = term(1e300, 1e-60, 10.0);
        assert!((value / 1e-300 - 1.0).abs() < 1e-15, "{value:e}");
    }

    #[test]
    fn nothing_times_a_power_out_of_range_is_nothing() {
        assert_eq!((term(0.0, 1e20, 48.0), plain_term(0.0, 1e20, Exponent::whole(52))), (0.0, 0.0));
    }

    #[test]
    fn a_small_drop_does_not_cancel() {
        let (a, depth): (f64, f64) = (7.0, 2f64.powi(-40));
        let drop = power_sum_drop(a, depth, [(1.0, Exponent::of(2.0))]);
        // The logarithm, the expm1 and three products round once each.
        assert!((drop / (depth * (a + a - depth)) - 1.0).abs() < 3.0 * f64::EPSILON, "{drop:e}");
        assert_eq!(power_sum_drop(7.0, 7.0, [(2.0, Exponent::of(3.0))]), 686.0);
        assert_eq!(power_sum_drop(7.0, 0.0, [(2.0, Exponent::of(3.0))]), 0.0);
    }
}
