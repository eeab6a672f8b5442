//! The load integral Σ c x^p with its derivatives, from which a step to the contact radius is taken.
//!
//! Only the error of J itself matters, and the step divides it by the degree p = a J′/J > 4. In plain arithmetic it is
//! three or four ε, so that a radius is now and then off by more than 1 ulp. In the last step the powers are [`Halved`]
//! numbers, and what their sum loses is carried along.
//!
//! **What is left.** k roundings of J, each of ε/2, move a radius by at most k/p ulp, to which its own 1/2 ulp is
//! added.
//!
//! ```text
//! coefficients   0  for a polynomial known at run time if its exponents have half the digits of a word, otherwise 1.3,
//!                   1  for constants,
//!                   2  for a field and its weight, and one for each operation that makes a coefficient of r^n of
//!                      fields, n + 3 = p − 1 at the most: those of more are computed in double words and rounded
//! powers         0  for exponents that are multiples of 1/4, otherwise 1.1 for a `powf`
//! ```
//!
//! Anything else is below ε/100. So 1/2 ulp is left for sums known at run time with common exponents. For constants and
//! for fields alone, with k ≤ 3.1 and with p > 4 for fields, 1.3 ulp would be the most. What is made of fields could be
//! off by another ulp, but of millions of such radii the worst was off by 1.09. Constants with whole powers take plain
//! arithmetic instead, and are now and then off by 1.07 ulp.

use super::power::{
    fractional_power, plain_whole_term, quarter_power, quarters_of_value, real_fractional_power,
    value_of_fractional_power,
};
use crate::Scalar;
use crate::numbers::bits::{exponent, power_of_two, rough_ln};
use crate::numbers::double_word::DoubleWord;
use crate::numbers::exponent::Exponent;
use crate::numbers::halved::Halved;
use crate::scalar::{derivatives, has_no_derivatives, is_plain_zero};

/// J and its first two derivatives at a radius a, as a step of Halley's method takes them.
///
/// a^k is the lowest power of J, or 1. u is a number, mostly the one that makes the coefficient of the highest power in
/// a J′/u equal to 1.
#[derive(Clone, Copy, Debug)]
pub struct Steepness<T> {
    /// a^k.
    pub power: T,
    /// J/a^k.
    pub value: T,
    /// By how much the product of both exceeds J, where that is known; otherwise 0.
    pub excess: T,
    /// a J′/(u a^k).
    pub first: T,
    /// a² J″/(2 u² a^k).
    pub half_second: T,
    /// 1/u.
    pub per_unit: T,
}

impl<T: Scalar> Steepness<T> {
    /// The steepness of no terms at all, in units of 1.
    #[inline(always)]
    pub(crate) fn of_nothing() -> Self {
        let (zero, one) = (T::zero(), T::one());
        Self { power: one, value: zero, excess: zero, first: zero, half_second: zero, per_unit: one }
    }

    /// Adds the derivatives of a term of the power p.
    #[inline(always)]
    pub(crate) fn add_derivatives(&mut self, term: T, p: T) {
        let (first, half) = (p * term, T::constant(0.5));
        self.first += first;
        self.half_second += half * (p - T::one()) * first;
    }

    /// With the lowest power x^`K` exact, and the excess that its product with the value then has.
    #[inline(always)]
    pub fn with_exact_power<const K: u32>(self, x: T) -> Self {
        let x = Halved::of(x);
        let power = x.whole_power::<K>(x.square());
        let word = power.word();
        let excess = power.excess_of_product(word * self.value, Halved::of(self.value));
        Self { power: word, excess, ..self }
    }

    /// With derivatives in units of the power of two just below a J′, whose square may not fit single precision.
    #[inline(always)]
    fn in_units_of_its_slope(self) -> Self {
        let per_unit = power_of_two(-exponent(self.first));
        let (first, half_second) = (self.first * per_unit, self.half_second * per_unit * per_unit);
        Self { first, half_second, per_unit, ..self }
    }
}

/// Σ c x^p with its derivatives and its excess, for any size whose square fits double precision.
#[inline]
pub fn power_sum_steepness<T: Scalar>(
    x: T,
    terms: impl IntoIterator<Item = (T, Exponent<T>)>,
) -> Steepness<T> {
    scaled_power_sum_steepness(x, T::one(), terms).in_units_of_its_slope()
}

/// `scale` Σ c x^p with its derivatives and its excess; without a scale they may leave the format.
#[inline]
pub fn scaled_power_sum_steepness<T: Scalar>(
    x: T,
    scale: T,
    terms: impl IntoIterator<Item = (T, Exponent<T>)>,
) -> Steepness<T> {
    halved_power_sum_steepness(x, scale, terms.into_iter().map(|(c, p)| (Halved::of(c), p)))
}

/// [`scaled_power_sum_steepness`] with coefficients that are not rounded; powers are above 4.
#[inline(always)]
pub(crate) fn halved_power_sum_steepness<T: Scalar>(
    x: T,
    scale: T,
    terms: impl IntoIterator<Item = (Halved<T>, Exponent<T>)>,
) -> Steepness<T> {
    let x = Halved::of(x);
    let square = x.square();
    let mut sum = Steepness::of_nothing();
    // A loop, which compilers inline into the caller; a fold they do not.
    for (c, p) in terms {
        let term = halved_term(c, x, square, p).scaled(scale);
        let value = <DoubleWord<T>>::sum(sum.value, term.head());
        sum.value = value.high();
        sum.excess -= value.low() + term.rest();
        sum.add_derivatives(term.word(), p.value());
    }
    sum
}

/// Σ c x^p of whole powers with its derivatives and its excess, by Horner's rule from the highest power down.
///
/// Every power is a halved number: powers of a root x of the radius are high, and would round often.
#[derive(Clone, Copy, Debug)]
pub struct NestedPowers<T> {
    x: Halved<T>,
    square: Halved<T>,
    sum: Steepness<T>,
}

impl<T: Scalar> NestedPowers<T> {
    /// No terms.
    #[inline(always)]
    pub fn of(x: T) -> Self {
        let x = Halved::of(x);
        Self { x, square: x.square(), sum: Steepness::of_nothing() }
    }

    /// With one more coefficient c, of the power p in the whole sum.
    #[inline(always)]
    pub fn plus(mut self, c: T, p: T) -> Self {
        self.sum.add_derivatives(c, p);
        self.sum.value += c;
        self
    }

    /// Multiplied by x^`K`.
    #[inline(always)]
    pub fn times_power<const K: u32>(mut self) -> Self {
        let (power, excess) = self.power_and_excess::<K>();
        let Steepness { value, first, half_second, .. } = &mut self.sum;
        for sum in [value, first, half_second] {
            *sum *= power;
        }
        self.sum.excess = excess;
        self
    }

    /// The whole sum, if its lowest power is `K`.
    #[inline(always)]
    pub fn of_lowest_power<const K: u32>(self) -> Steepness<T> {
        let (power, excess) = self.power_and_excess::<K>();
        Steepness { power, excess, ..self.sum }.in_units_of_its_slope()
    }

    /// x^`K`, and by how much its rounded product with the value exceeds its product with the sum.
    #[inline(always)]
    fn power_and_excess<const K: u32>(&self) -> (T, T) {
        let Steepness { value, excess, .. } = self.sum;
        let power = self.x.whole_power::<K>(self.square);
        let word = power.word();
        (word, word * excess + power.excess_of_product(word * value, Halved::of(value)))
    }
}

/// (n+2)(n+4) in a form in which only the sum rounds much where n is small and J least steep.
#[inline(always)]
pub(crate) fn load_integral_divisor<T: Scalar>(n: T) -> T {
    n * (n + T::constant(6.0)) + T::constant(8.0)
}

/// c n/((n+2)(n+4)). The divisor is rounded if n has more than half the digits of a word.
#[inline(always)]
pub(crate) fn load_integral_coefficient<T: Scalar>(c: T, n: T) -> Halved<T> {
    let divisor = load_integral_divisor(n);
    let inverse = divisor.recip();
    let quotient = Halved::of(c * (n * inverse));
    let (high, low) = Halved::of(c).parts_of_product(Halved::of(n));
    let (back_high, back_low) = quotient.parts_of_product(Halved::of(divisor));
    let left = (high - back_high) + (low - back_low);
    quotient.plus_little(left * inverse)
}

/// `scale` Σ c x^p with its derivatives, with every product rounded, which is enough for all steps but the last.
#[inline(always)]
pub fn plain_power_sum_steepness<T: Scalar>(
    x: T,
    scale: T,
    terms: impl IntoIterator<Item = (T, Exponent<T>)>,
) -> Steepness<T> {
    let mut sum = Steepness::of_nothing();
    for (c, p) in terms {
        let value = plain_high_term(c, x, p) * scale;
        sum.value += value;
        sum.add_derivatives(value, p.value());
    }
    sum
}

/// c x^p in halves, so that the middle value is in range whenever c and the result are.
#[inline(always)]
fn halved_term<T: Scalar>(c: Halved<T>, x: Halved<T>, square: Halved<T>, p: Exponent<T>) -> Halved<T> {
    // The power may be out of range; a zero that carries a derivative does not count as zero.
    if is_plain_zero(c.head()) {
        return c;
    }
    let degree = p.whole as u32;
    let half = x.power(square, degree / 2);
    let even = c.times(half).times(half);
    let whole_power = if degree & 1 == 1 { even.times(x) } else { even };
    if is_plain_zero(p.fraction) && p.rest.is_zero() {
        whole_power
    } else {
        whole_power.times(precise_fractional_power(x, p.fraction, p.rest))
    }
}

/// [`halved_term`] with every product rounded. Powers are above 4: it has no branches for negative exponents, as the
/// [`plain_term`](super::power::plain_term) of any power has.
#[inline(always)]
fn plain_high_term<T: Scalar>(c: T, x: T, p: Exponent<T>) -> T {
    if c.is_zero() {
        return c;
    }
    let whole_power = plain_whole_term(c, x, p.whole as u32);
    if p.fraction.is_zero() { whole_power } else { whole_power * plain_fractional_power(x, p.fraction) }
}

/// x^φ for 0 ≤ φ < 1, from a fraction and what it lacks; not inlined, out of the way of whole powers.
#[inline(never)]
fn precise_fractional_power<T: Scalar>(x: Halved<T>, fraction: T, rest: T) -> Halved<T> {
    let power = match quarters_of_value(x.word(), fraction).filter(|_| rest.is_zero()) {
        Some(0) => Halved::of(T::one()),
        Some(quarters) => quarter_power(x.without_derivatives(), quarters, Halved::sqrt, Halved::times),
        None => {
            let power = Halved::of(value_of_fractional_power(x.word(), fraction));
            // The rest is below half a rounding of the fraction, and so little of its logarithm counts.
            power.plus_little(power.head() * (rest * rough_ln(x.word())))
        }
    };
    if has_no_derivatives::<T>() {
        return power;
    }
    power.plus_little(derivatives(real_fractional_power(x.word(), fraction)))
}

/// [`fractional_power`], not inlined either.
#[inline(never)]
fn plain_fractional_power<T: Scalar>(x: T, fraction: T) -> T {
    fractional_power(x, fraction)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worse::worse;

    /// The largest |x/y − 1| in units of ε, over coefficients of exponents in quarters.
    fn largest_difference<T: Scalar>() -> f64 {
        let mut largest = 0.0_f64;
        for k in 1..1000 {
            let (c, n) = (T::constant(1.013_f64.powi(k - 500)), T::constant(f64::from(k) / 4.0));
            let (word, lost) = load_integral_coefficient(c, n).word_and_lost();
            let [of_two, of_four] = [2.0, 4.0].map(|k| DoubleWord::sum(n, T::constant(k)));
            let expected = <DoubleWord<T>>::product(c, n).over(of_two.times(of_four));
            let difference = DoubleWord::sum(word, lost).plus(-expected).high();
            largest = worse(largest, (difference / expected.high()).abs().value());
        }
        largest / T::default_epsilon().value()
    }

    #[test]
    fn coefficients_are_hardly_rounded() {
        for error in [largest_difference::<f64>(), largest_difference::<f32>()] {
            assert!(error < 0.01, "{error} ε");
        }
    }

    /// What a word of the fraction lacks, by which nothing is moved that is near 1.
    #[test]
    fn powers_have_the_rest_of_their_exponents() {
        let (octaves, rest) = (-300, 2_f64.powi(-55));
        let (power, fraction): (f64, f64) = (power_of_two(octaves / 2), 0.5);
        let found = precise_fractional_power(Halved::of(power_of_two(octaves)), fraction, rest);
        let gain = ((found.head() - power) + found.rest()) / power;
        let expected = rest * f64::from(octaves) * core::f64::consts::LN_2;
        assert!((gain / expected - 1.0).abs() < 0.01, "{gain:e} instead of {expected:e}");
    }
}
