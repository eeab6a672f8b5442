//! Numbers of 31 digits and any size, with which the results of the library are compared.
//!
//! A number is (high + low) · 2^exponent with 1 ≤ |high| < 2 and |low| ≤ ulp(high)/2. The two words give a relative
//! error of some 2^-102 per operation; the separate exponent keeps the reference from over- or underflowing where the
//! library might.
//!
//! Sources: M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic", ACM TOMS 44 (2017), doi 10.1145/3121432; exact products by fused multiply-add.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number of 31 digits with a separate exponent; zero has the words 0 and 0.
#[derive(Clone, Copy, Debug)]
pub struct Wide {
    high: f64,
    low: f64,
    exponent: i64,
}

/// ln 2; the second word is the rounded difference of the first from ln 2 in 40 digits.
const LN_2: Wide =
    Wide { high: core::f64::consts::LN_2 * 2.0, low: 2.319_046_813_846_299_6e-17 * 2.0, exponent: -1 };

impl Wide {
    /// Zero.
    pub const ZERO: Self = Self { high: 0.0, low: 0.0, exponent: 0 };
    /// One.
    pub const ONE: Self = Self { high: 1.0, low: 0.0, exponent: 0 };
    /// π/4; the second word is that of π in the usual tables, divided by 4.
    pub const FRAC_PI_4: Self = Self {
        high: core::f64::consts::FRAC_PI_4 * 2.0,
        low: 1.224_646_799_147_353_2e-16 / 2.0,
        exponent: -1,
    };

    /// Exactly `x`, which must be finite.
    #[must_use]
    pub fn of(x: f64) -> Self {
        Self { high: x, low: 0.0, exponent: 0 }.normalised()
    }

    /// The decimal that a literal means: 0.025 is 1/40.
    #[must_use]
    pub fn of_decimal(literal: f64) -> Self {
        let text = format!("{literal:e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let decimals = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let whole: f64 = digits.replace('.', "").parse().unwrap_or(f64::NAN);
        let exponent = exponent.parse().unwrap_or(0) - decimals as i64;
        Self::of(whole) * Self::of(10.0).whole_power(exponent)
    }

    /// The nearest `f64`, rounded twice where it is subnormal.
    #[must_use]
    pub fn value(self) -> f64 {
        let sum = self.high + self.low;
        let exponent = self.exponent.clamp(-2200, 2200) as i32;
        let half = exponent / 2;
        sum * 2_f64.powi(half) * 2_f64.powi(exponent - half)
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.high == 0.0
    }

    /// Whether it is above 0.
    #[must_use]
    pub fn is_positive(self) -> bool {
        self.high > 0.0
    }

    /// |x|.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    /// Whether it is less than another.
    #[must_use]
    pub fn is_below(self, other: Self) -> bool {
        (other - self).is_positive()
    }

    /// The smaller of two.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other.is_below(self) { other } else { self }
    }

    /// The larger of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self.is_below(other) { other } else { self }
    }

    /// x · 2^k.
    #[must_use]
    pub fn scaled(self, k: i64) -> Self {
        Self { exponent: self.exponent + if self.is_zero() { 0 } else { k }, ..self }
    }

    /// The square root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return self;
        }
        let odd = self.exponent & 1;
        let reduced = Self { exponent: odd, ..self };
        // One step of Heron's rule doubles the digits of the root in `f64`.
        let estimate = Self::of(reduced.value().sqrt());
        (estimate + reduced / estimate).scaled(-1 + (self.exponent - odd) / 2)
    }

    /// ln x of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        let mantissa = Self { exponent: 0, ..self };
        let estimate = Self::of(mantissa.high.ln());
        // Halley's step for e^y = x: the error of the estimate is cubed.
        let image = estimate.exp();
        let step = (mantissa - image) / (mantissa + image);
        estimate + step.scaled(1) + Self::of(self.exponent as f64) * LN_2
    }

    /// e^x for |x| below 2^40.
    #[must_use]
    pub fn exp(self) -> Self {
        let folds = (self.value() / core::f64::consts::LN_2).round();
        // Ten halvings leave |x| < 4e-4, for which nine terms are more than enough.
        let reduced = (self - Self::of(folds) * LN_2).scaled(-10);
        let mut series = Self::ZERO;
        for k in (1..=9).rev() {
            series = (series + Self::ONE) * reduced / Self::of(f64::from(k));
        }
        // (1 + s)² − 1 = s (2 + s): the ten squarings do not magnify the rounding of 1 + s.
        for _ in 0..10 {
            series = series * (series + Self::of(2.0));
        }
        (series + Self::ONE).scaled(folds as i64)
    }

    /// x^n of a positive number, or of zero if n > 0; the whole part of n by binary powering.
    #[must_use]
    pub fn power(self, n: f64) -> Self {
        let whole = n.floor();
        let fraction = n - whole;
        let power = self.whole_power(whole as i64);
        match fraction {
            0.0 => power,
            _ if self.is_zero() => Self::ZERO,
            0.5 => power * self.sqrt(),
            0.25 => power * self.sqrt().sqrt(),
            _ => power * (Self::of(fraction) * self.ln()).exp(),
        }
    }

    fn whole_power(self, k: i64) -> Self {
        let (mut power, mut square, mut rest) = (Self::ONE, self, k.unsigned_abs());
        while rest > 0 {
            if rest & 1 == 1 {
                power = power * square;
            }
            square = square * square;
            rest >>= 1;
        }
        if k < 0 { Self::ONE / power } else { power }
    }

    /// The number with its words back in their ranges.
    fn normalised(self) -> Self {
        let high = self.high + self.low;
        let low = self.low - (high - self.high);
        if high == 0.0 {
            return Self::ZERO;
        }
        let (high, low, shift) =
            if high.abs() < f64::MIN_POSITIVE { (high * SHIFT, low * SHIFT, 200) } else { (high, low, 0) };
        let exponent = (high.abs().to_bits() >> 52) as i64 - 1023;
        if exponent == 0 {
            return Self { high, low, exponent: self.exponent - shift };
        }
        // In two factors, because 2^-1023 is not a normal number.
        let (half, rest) = (exponent / 2, exponent - exponent / 2);
        let scale = |x: f64| x * two_to(-half) * two_to(-rest);
        Self { high: scale(high), low: scale(low), exponent: self.exponent + exponent - shift }
    }
}

/// 2^200.
const SHIFT: f64 = f64::from_bits((1023 + 200) << 52);

/// 2^k for |k| ≤ 1022.
fn two_to(k: i64) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low, ..self }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (large, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let gap = large.exponent - small.exponent;
        if gap > 120 {
            return large;
        }
        let scale = two_to(-gap);
        let (high, error) = two_sum(large.high, small.high * scale);
        let (low, rest) = two_sum(large.low, small.low * scale);
        let (high, error) = quick_two_sum(high, error + low);
        let (high, low) = quick_two_sum(high, error + rest);
        Self { high, low, exponent: large.exponent }.normalised()
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        let low = error + (self.high * other.low + self.low * other.high);
        Self { high, low, exponent: self.exponent + other.exponent }.normalised()
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let first = Self { high: quotient, low: 0.0, exponent: self.exponent - other.exponent };
        let rest = self - other * first;
        let second =
            Self { high: rest.high / other.high, low: 0.0, exponent: rest.exponent - other.exponent };
        first.normalised() + second.normalised()
    }
}

/// x + y rounded, and its rounding error (Knuth).
fn two_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    let share = sum - x;
    (sum, (x - (sum - share)) + (y - share))
}

/// x + y rounded, and its rounding error, for |x| ≥ |y| (Dekker).
fn quick_two_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    (sum, y - (sum - x))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(x: Wide, y: Wide) -> f64 {
        ((x - y) / y).value().abs()
    }

    #[test]
    fn arithmetic_has_thirty_digits() {
        for (x, y) in [(3.0, 7.0), (1e-300, 1e300), (5e-324, 0.1), (-0.3, 0.300_000_000_000_000_04)] {
            let (x, y) = (Wide::of(x), Wide::of(y));
            assert!(distance(x / y * y, x) < 1e-30);
            assert!(distance((x + y) * (x - y), x * x - y * y) < 1e-29);
        }
        let third = Wide::ONE / Wide::of(3.0);
        assert!((third + third + third - Wide::ONE).value().abs() < 1e-31);
    }

    #[test]
    fn values_are_those_that_went_in() {
        for x in [0.0, 1.0, -3.7, 5e-324, f64::MIN_POSITIVE, f64::MAX, 2.5e-310] {
            assert_eq!(Wide::of(x).value(), x);
        }
        assert_eq!((Wide::of(1e300) * Wide::of(1e300)).value(), f64::INFINITY);
    }

    #[test]
    fn functions_satisfy_their_equations() {
        let two = Wide::of(2.0);
        for x in [1e-200, 1e-7, 0.3, 1.0 + 1e-15, 2.0, 1e200] {
            let x = Wide::of(x);
            assert!(distance(x.sqrt() * x.sqrt(), x) < 1e-30);
            assert!(distance(x.ln().exp(), x) < 1e-27);
            assert!(distance(x.power(0.375) * x.power(0.625), x) < 1e-27);
            assert!(distance(x.power(64.0), x.power(63.5) * x.sqrt()) < 1e-27);
        }
        assert!(distance(two.ln(), LN_2) < 1e-30);
        // The digits of e, as two words.
        let e = Wide::of(core::f64::consts::E) + Wide::of(1.445_646_891_729_250_2e-16);
        assert!(distance(Wide::ONE.exp(), e) < 1e-30);
    }
}
