//! How much of a memory fades over some e-foldings.

use crate::Scalar;
use crate::numbers::compensated_sum::CompensatedSum;
use crate::numbers::double_word::DoubleWord;
use crate::numbers::tabled::{Tabled, tabled};

/// The number of e-foldings after which a pressure is below rounding; four more make up for a history whose pressures
/// were up to fifty times as high.
pub(crate) fn faded_folds<T: Scalar>() -> T {
    -T::default_epsilon().ln() + T::constant(4.0)
}

/// The most e-foldings that [`decay_gain`] is meant for.
pub(crate) const FEW_FOLDS: f64 = 1.0 / 8.0;

/// e^(−x) − 1 for 0 ≤ x ≤ 1/8 by its Taylor series; the first term left out is below 3e-17 x.
#[inline(always)]
pub(crate) fn decay_gain<T: Scalar>(x: T) -> T {
    let mut sum = T::one();
    for share in SHARES {
        sum = T::one() - x * share.get::<T>() * sum;
    }
    -x * sum
}

/// 1/k for k from 10 down to 2: in the series of e^(−x) − 1, the term of x^k is −x/k times the one before it.
const SHARES: [Tabled; 9] =
    tabled([1.0 / 10.0, 1.0 / 9.0, 0.125, 1.0 / 7.0, 1.0 / 6.0, 0.2, 0.25, 1.0 / 3.0, 0.5]);

/// What is left after some e-foldings, and what fades.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fading<T> {
    /// e^(−x) − 1 for few e-foldings, e^(−x) for more.
    factor: T,
    are_few: bool,
}

impl<T: Scalar> Fading<T> {
    #[inline(always)]
    pub(super) fn over(folds: T) -> Self {
        let are_few = folds <= T::constant(FEW_FOLDS);
        Self { factor: if are_few { decay_gain(folds) } else { (-folds).exp() }, are_few }
    }

    /// Over a duration at a rate. What the product of the two loses is an absolute error of the exponent, and so a
    /// relative error of what is left.
    pub(super) fn over_duration(chi: T, duration: T) -> Self {
        let product = <DoubleWord<T>>::product(chi, duration);
        let (fading, lost) = (Self::over(product.high()), product.low());
        // The halves of huge numbers overflow.
        if fading.are_few || !lost.is_finite() {
            return fading;
        }
        Self { factor: fading.factor * (T::one() - lost), ..fading }
    }

    /// A value after the e-foldings, with what was gained during them.
    #[inline(always)]
    pub(super) fn after(self, value: T, gained: T) -> T {
        let rest = value * self.factor + gained;
        if self.are_few { value + rest } else { rest }
    }

    /// Replaces a value by that [`after`](Self::after) the e-foldings.
    ///
    /// Over few e-foldings only what fades is subtracted: thousands of short steps that share one rounded e^(−x), or
    /// that round the value after each, would be off by thousands of roundings of one sign.
    #[inline(always)]
    pub(super) fn pass(self, value: &mut CompensatedSum<T>, gained: T) {
        let rest = value.value * self.factor + gained;
        if self.are_few {
            value.add(rest);
        } else {
            *value = rest.into();
        }
    }

    /// F₂ − E F₁, what remains at the end of the gain between two forces, and the sum of the magnitudes that it is the
    /// difference of, to judge cancellation: a rise and what has drained over few e-foldings, two forces over many.
    #[inline(always)]
    pub(super) fn kept_of(self, (first, last): (T, T)) -> (T, T) {
        let changed = first * self.factor;
        if self.are_few {
            let rise = last - first;
            (rise - changed, rise.abs() - changed)
        } else {
            (last - changed, last + changed)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_the_exponential() {
        for k in 0..=1000 {
            let x = FEW_FOLDS * f64::from(k) / 1000.0;
            assert!((decay_gain(x) - (-x).exp_m1()).abs() <= 2.0 * f64::EPSILON * x, "{x}");
        }
    }

    #[test]
    fn what_is_kept_loses_no_digits() {
        for k in 1..=1000 {
            let x = 20.0 * f64::from(k) / 1000.0;
            let (kept, sizes) = Fading::over(x).kept_of((1.0, 1.0));
            // For a held load this is 1 − E; near x = 1/8 that is a ninth of the numbers it is the difference of.
            assert!((kept / -(-x).exp_m1() - 1.0).abs() <= 3.0 * f64::EPSILON, "{x}");
            assert!(kept <= sizes && sizes <= 17.0 * kept, "{x}");
        }
    }

    /// A force that falls like e^(−χ t) gains nothing: the sizes must tell that what is kept is rounding.
    #[test]
    fn what_is_kept_of_the_fastest_fall_is_rounding() {
        for x in [1e-3_f64, 0.1, 0.5, 3.0] {
            let left = (-x).exp();
            let (kept, sizes) = Fading::over(x).kept_of((1.0, left));
            assert!(kept.abs() <= f64::EPSILON && sizes > left.min(1.0 - left), "{x}: {kept:e}, {sizes}");
        }
    }

    #[test]
    fn many_e_foldings_are_not_rounded() {
        for k in 1..=1000_u16 {
            let (chi, duration) = (0.377_f32, 0.1 * f32::from(k));
            let exact = (-f64::from(chi) * f64::from(duration)).exp();
            let found = f64::from(Fading::over_duration(chi, duration).after(1.0, 0.0));
            assert!((found / exact - 1.0).abs() <= 2.0 * f64::from(f32::EPSILON), "{duration}");
        }
    }

    /// The halves of a huge rate are out of range, but not its product with a short duration.
    #[test]
    fn rates_and_durations_may_be_of_any_size() {
        for (chi, duration) in [(1e306, 2e-306), (2e-306, 1e306)] {
            let left = Fading::over_duration(chi, duration).after(1.0, 0.0);
            assert!((left * 2_f64.exp() - 1.0).abs() <= 4.0 * f64::EPSILON, "{chi:e}: {left}");
        }
    }

    #[test]
    fn short_steps_fade_as_one_long_one() {
        let mut value = CompensatedSum::from(1.0);
        for step in 1..=100_000 {
            Fading::over(1e-5).pass(&mut value, 0.0);
            let error = value.value / (-1e-5 * f64::from(step)).exp() - 1.0;
            assert!(error.abs() < 3.0 * f64::EPSILON, "{step}: {error:e}");
        }
    }
}
