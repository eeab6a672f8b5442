//! Fractions of few digits near a number: the convergents of its continued fraction.

use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

use super::Rational;

/// The last convergent of a positive number with at most 32 binary digits in numerator and denominator; none for a
/// larger number.
///
/// The next convergent, h/k, has more digits. The reciprocal of the last convergent, with the numerator h′, is
/// therefore off from 1/x by less than 1/(h′ h), and so by less than 2⁻³² over h′.
pub(crate) fn convergent(value: &Rational) -> Option<(u32, u32)> {
    let (mut numerator, mut denominator) = (value.numer().clone(), value.denom().clone());
    let (mut before, mut last) = ((0, 1), (1, 0));
    while !denominator.is_zero() {
        let (whole, rest) = numerator.div_rem(&denominator);
        let Some(next) = whole.to_u32().and_then(|whole| next(whole, before, last)) else { break };
        (before, last) = (last, next);
        numerator = core::mem::replace(&mut denominator, rest);
    }
    (last.1 != 0).then_some(last)
}

fn next(whole: u32, before: (u32, u32), last: (u32, u32)) -> Option<(u32, u32)> {
    let next = |before: u32, last: u32| whole.checked_mul(last)?.checked_add(before);
    Some((next(before.0, last.0)?, next(before.1, last.1)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{fraction, integer};

    #[test]
    fn short_fractions_are_their_own() {
        for (numerator, denominator) in [(6, 1), (637, 100), (714_159, 100_000), (u32::MAX, 7)] {
            let value = fraction(numerator, denominator);
            assert_eq!(convergent(&value), Some((numerator, denominator)));
        }
    }

    #[test]
    fn long_fractions_have_near_ones() {
        let power = fraction(7_141_592_653_589_793_u64, 1_000_000_000_000_000_u64);
        let lacking = |(numerator, denominator)| {
            let difference = power.recip() - fraction(denominator, numerator);
            (difference.to_f64() * f64::from(numerator)).abs()
        };
        assert!(convergent(&power).is_some_and(|found| lacking(found) < 2f64.powi(-32)));
        assert_eq!(convergent(&(integer(6) + fraction(1, 10_u64.pow(12)))), Some((6, 1)));
        assert_eq!(convergent(&integer(u64::MAX)), None);
    }
}
