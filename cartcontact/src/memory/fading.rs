//! What time takes from a memory, all of it or e^(−x) − 1.

use crate::Scalar;

/// After how many e-foldings a pressure is below rounding, with a margin.
pub(crate) fn faded_folds<T: Scalar>() -> T {
    -T::default_epsilon().ln() + T::constant(4.0)
}

/// The most e-foldings for which [`decay_gain`] is meant.
pub(crate) const FEW_FOLDS: f64 = 1.0 / 8.0;

/// e^(−x) − 1 for 0 ≤ x ≤ 1/8 by its Taylor series; the first term left out is below 3e-17 x.
#[inline(always)]
pub(crate) fn decay_gain<T: Scalar>(x: T) -> T {
    let mut sum = T::one();
    for share in [1.0 / 10.0, 1.0 / 9.0, 0.125, 1.0 / 7.0, 1.0 / 6.0, 0.2, 0.25, 1.0 / 3.0, 0.5] {
        sum = T::one() - x * T::constant(share) * sum;
    }
    -x * sum
}

/// A value after some e-foldings in which something was gained.
///
/// Of few e-foldings what fades is taken away: thousands of short steps with one rounded e^(−x) between them would be
/// off by thousands of roundings of one sign.
#[inline(always)]
pub(super) fn after<T: Scalar>(folds: T) -> impl Fn(T, T) -> T {
    let are_few = folds <= T::constant(FEW_FOLDS);
    let factor = if are_few { decay_gain(folds) } else { (-folds).exp() };
    move |value, gained| {
        let rest = value * factor + gained;
        if are_few { value + rest } else { rest }
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
    fn short_steps_fade_as_one_long_one() {
        let mut value = 1.0;
        for step in 1..=10_000 {
            value = after(1e-4)(value, 0.0);
            let error = value / (-1e-4 * f64::from(step)).exp() - 1.0;
            assert!(error.abs() < 50.0 * f64::EPSILON, "{step}: {error:e}");
        }
    }
}
