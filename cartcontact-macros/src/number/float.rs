//! Positive numbers of 128 binary digits, for constants with more digits than an f64 has.

use num_traits::{Signed, ToPrimitive};

use super::convergent::convergent;
use super::{Rational, fraction};

/// `mantissa` · 2^`exponent`, where the mantissa has its highest bit set.
#[derive(Clone, Copy)]
pub(crate) struct Float {
    mantissa: u128,
    exponent: i64,
}

/// Unity in fixed point.
pub(crate) const ONE: i128 = 1 << 126;
/// Half of the last of 48 digits, in a number of 80 digits.
const HALF_UNIT: i128 = 1 << 31;

impl Float {
    /// A positive number, with an error within 2⁻¹²⁷ of it.
    pub(crate) fn of(value: &Rational) -> Option<Self> {
        let (numerator, denominator) = (value.numer(), value.denom());
        // The quotient has 129 or 130 digits.
        let shift = 129 + denominator.bits() as i64 - numerator.bits() as i64;
        let quotient = match shift {
            0.. => (numerator << shift) / denominator,
            _ => numerator / (denominator << -shift),
        };
        let excess = quotient.bits().checked_sub(128).filter(|_| value.is_positive())?;
        Some(Self { mantissa: (quotient.abs() >> excess).to_u128()?, exponent: excess as i64 - shift })
    }

    /// 2 to a power, with the digits of f64.
    fn power_of_two(power: f64) -> Self {
        let octave = power.floor();
        // From 2^52 up, so that nothing is after the point.
        let mantissa = ((power - octave).exp2() * 2f64.powi(52)) as u128;
        Self { mantissa, exponent: octave as i64 - 52 }.normal()
    }

    fn normal(self) -> Self {
        let shift = self.mantissa.leading_zeros();
        Self { mantissa: self.mantissa << shift, exponent: self.exponent - i64::from(shift) }
    }

    /// The product, with an error within 2⁻¹²⁵ of it.
    pub(crate) fn times(self, other: Self) -> Self {
        let mantissa = upper_half(self.mantissa, other.mantissa);
        Self { mantissa, exponent: self.exponent + other.exponent + 128 }.normal()
    }

    /// A power with an exponent of at least 1, with an error within that exponent times 2⁻¹²⁴ of it.
    pub(crate) fn power(self, exponent: u32) -> Self {
        let bits = exponent.checked_ilog2().unwrap_or(0);
        (0..bits).rev().fold(self, |power, bit| {
            let square = power.times(power);
            if exponent >> bit & 1 == 1 { square.times(self) } else { square }
        })
    }

    pub(crate) fn log2(self) -> f64 {
        (self.mantissa as f64).log2() + self.exponent as f64
    }

    /// value^(1/p) within 2⁻⁷⁴, for values from 2⁻²⁰⁴⁸ to 2²⁰⁴⁸ and p ≥ 4 up to 2³².
    ///
    /// The root for a fraction near p, whose digits are few enough for [`root`](Self::root), times an exponential. For
    /// p with more digits the exponential is at most 2⁻²³ away from 1, and off by a few 2⁻⁵³ of that.
    pub(crate) fn real_root(value: &Rational, p: &Rational) -> Option<Self> {
        let (k, q) = convergent(p)?;
        let logarithm = Self::of(value)?.log2() * core::f64::consts::LN_2;
        let growth = ((p.recip() - fraction(q, k)).to_f64() * logarithm).exp_m1();
        Some(Self::root(value, (q, k))?.less(-(growth * ONE as f64) as i128))
    }

    /// value^(`q`/`k`) within 2⁻¹¹⁰, if it lies between 2⁻⁵¹² and 2⁵¹².
    ///
    /// With v = value^(−q), a step of Newton's method takes x to x − x (v x^k − 1)/k. It turns an error e into k e²/2;
    /// the first e is below 2⁻⁴³, so that k e is below 2⁻¹¹. The rounding errors of v and x^k, q and 2 k last digits,
    /// are divided by k.
    fn root(value: &Rational, (q, k): (u32, u32)) -> Option<Self> {
        let inverse = Self::of(&value.recip())?.power(q);
        let mut root = Self::power_of_two(-inverse.log2() / f64::from(k));
        for _ in 0..3 {
            let surplus = inverse.times(root.power(k)).fixed() - ONE;
            root = root.less(surplus / i128::from(k));
        }
        Some(root)
    }

    /// The fraction f and the exponent e of f · 2^e, 1 ≤ f < 2.
    pub(crate) fn split(self) -> (Self, i64) {
        (Self { exponent: -127, ..self }, self.exponent + 127)
    }

    /// A number below 2 in fixed point, of which [`ONE`] is the unit.
    pub(crate) fn fixed(self) -> i128 {
        let shift = u32::try_from(-126 - self.exponent).unwrap_or(u32::MAX);
        self.mantissa.checked_shr(shift).unwrap_or(0) as i128
    }

    /// The number minus a small share of itself, in fixed point.
    pub(crate) fn less(self, share: i128) -> Self {
        let part = upper_half(self.mantissa, share.unsigned_abs() << 2);
        // Leaves room for a sum.
        let (whole, part) = (self.mantissa >> 1, part >> 1);
        let mantissa = if share > 0 { whole - part } else { whole + part };
        Self { mantissa, exponent: self.exponent + 1 }.normal()
    }

    /// The number as a sum of three in single precision, in descending order. The first two make one of 48 digits, so
    /// that f64 adds them without rounding. None if not all of them are in range.
    pub(crate) fn in_parts(self) -> Option<[f32; 3]> {
        let all = (self.mantissa >> 48) as i128;
        let whole = (all + HALF_UNIT) & !(2 * HALF_UNIT - 1);
        let first = whole as f32;
        let parts = [first, (whole - first as i128) as f32, (all - whole) as f32];
        let unit = 2f64.powi(i32::try_from(self.exponent + 48).ok()?);
        (-60.0..120.0).contains(&self.log2()).then(|| parts.map(|part| (f64::from(part) * unit) as f32))
    }
}

/// The product divided by 2¹²⁸.
fn upper_half(x: u128, y: u128) -> u128 {
    let halves = |x: u128| (x >> 64, x & u128::from(u64::MAX));
    let ((x1, x0), (y1, y0)) = (halves(x), halves(y));
    let (middle, low) = (x1 * y0, halves(x0 * y0).0);
    let middle = halves(middle);
    let other = x0 * y1 + middle.1 + low;
    x1 * y1 + middle.0 + (other >> 64)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::*;
    use crate::number::integer;
    use crate::tests::exact;

    /// Compares value^q with root^k in exact arithmetic, for the three parts of the root.
    #[test]
    fn roots_have_the_digits_of_three_parts() {
        for (q, k) in [(1, 6), (2, 9), (4, 25), (10, 63), (3, 13), (100, 637)] {
            for value in [fraction(9, 8), fraction(1, 3), integer(7), fraction(1, 1_000_000_007)] {
                let parts = Float::root(&value, (q, k)).unwrap().in_parts().unwrap();
                let exact = |part: f32| Rational::from_float(part.into()).unwrap();
                let root = exact(parts[0]) + exact(parts[1]) + exact(parts[2]);
                let error = root.pow(k as i32) / value.pow(q as i32) - integer(1);
                let bound = integer(2).pow(-70) * integer(k);
                assert!(error.abs() < bound, "{value}^({q}/{k})");
                let sum = f64::from(parts[0]) + f64::from(parts[1]);
                assert_eq!(exact(parts[0]) + exact(parts[1]), Rational::from_float(sum).unwrap());
            }
        }
    }

    /// As above, for numbers whose exact powers are too long.
    #[test]
    fn roots_have_their_digits_whatever_the_power_is() {
        for (q, k) in [(100_000, 714_159), (1_000_000_000, 4_123_456_789), (1, u32::MAX)] {
            for octave in [-2047, -3, 0, 2047] {
                let value = fraction(9, 8) * integer(2).pow(octave);
                let (root, _) = Float::root(&value, (q, k)).unwrap().split();
                let [a, b, c] =
                    root.in_parts().unwrap().map(|part| Rational::from_float(part.into()).unwrap());
                let root = Float::of(&(a + b + c)).unwrap();
                let [found, expected] = [root.power(k), Float::of(&value).unwrap().power(q)];
                // The octave that was taken out makes a whole number of them.
                let (found, expected) = (found.split().0, expected.split().0);
                let error = found.mantissa.wrapping_sub(expected.mantissa) as i128;
                let bound = i128::from(k) << (128 - 70);
                assert!(error.abs() < bound, "{value}^({q}/{k}): {error}");
            }
        }
    }

    /// For powers that differ by 10⁻¹² and 10⁻¹⁶; the first is nearer to 6 than to any other short fraction.
    #[test]
    fn roots_have_their_digits_however_many_the_power_has() {
        for (power, digits) in [("6.000000000001", 12), ("7.1415926535897932", 16)] {
            let p = exact(power);
            for value in [fraction(9, 8), fraction(1, 3), integer(2).pow(2048), integer(2).pow(-2048)] {
                let root = Float::real_root(&value, &p).unwrap();
                let next = Float::real_root(&value, &(&p + fraction(1, 10_u64.pow(digits)))).unwrap();
                let found = (root.mantissa.wrapping_sub(next.mantissa) as i128) as f64 / root.mantissa as f64;
                let expected = value_log(&value) / p.to_f64().powi(2) * 0.1_f64.powi(digits as i32);
                // The second order is a share of the first, and 2⁻⁷⁴ is the error.
                let bound = 1e-9 * expected.abs() + 2f64.powi(-73);
                assert!((found - expected).abs() < bound, "{value}^(1/{power}): {found:e}, not {expected:e}");
            }
        }
    }

    fn value_log(value: &Rational) -> f64 {
        Float::of(value).unwrap().log2() * core::f64::consts::LN_2
    }

    #[test]
    fn roots_of_periods_have_the_same_digits() {
        for (q, k) in [(1, 5), (2, 13), (10, 63)] {
            let root = |value: Rational| Float::root(&value, (q, k)).unwrap().in_parts().unwrap();
            let (one, next) = (root(fraction(13, 8)), root(fraction(13, 8) * integer(2).pow(k as i32)));
            assert_eq!(one.map(|part| part * 2f32.powi(q as i32)), next);
        }
    }

    #[test]
    fn what_is_no_positive_number_of_single_precision_is_none() {
        assert!(Float::of(&integer(0)).is_none() && Float::of(&integer(-2)).is_none());
        let large = Float::of(&integer(2).pow(200)).unwrap();
        assert!(large.in_parts().is_none() && large.log2() == 200.0);
        assert_eq!(Float::of(&integer(3)).unwrap().in_parts(), Some([3.0, 0.0, 0.0]));
    }
}
