//! How long ago the hereditary load was smaller, along a straight load.
//!
//! Time counts in durations of the load, so that rates are gains over one duration: they are forces, and as far within
//! the range of numbers as those of the load. A rate χ F of a small force may be below that range.

use crate::Scalar;
use crate::numbers::binary::{scale, split};
use crate::scalar::{is_plain_zero, raised_to_zero, smallest_normal};

/// A straight load, as seen from its end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<T> {
    /// χ times the duration.
    pub(super) folds: T,
    /// F′.
    pub(super) force_rate: T,
    /// Y′ = F′ + χ F at the end. It is 0 for a load that falls as fast as it may, and then rounding of either sign, which
    /// adds up to nothing.
    pub(super) hereditary_rate: T,
}

impl<T: Scalar> Line<T> {
    /// The line that ends at a force, after a rise of so much during so many e-foldings.
    pub(crate) fn to(force: T, rise: T, folds: T) -> Self {
        Self { folds, force_rate: rise, hereditary_rate: rise + folds * force }
    }

    /// How many durations before the end Y was smaller than at the end by `deficit`.
    #[inline]
    pub(crate) fn age(self, deficit: T) -> T {
        if self.is_held() {
            deficit / self.hereditary_rate
        } else if self.has_root(deficit) {
            self.root(deficit)
        } else {
            self.age_in_units(deficit)
        }
    }

    /// Whether F′ = 0, also for other values of the parameters with respect to which numbers carry derivatives.
    #[inline(always)]
    pub(super) fn is_held(self) -> bool {
        is_plain_zero(self.force_rate)
    }

    /// How many e-foldings a held load takes per deficit.
    #[inline(always)]
    pub(super) fn folds_per_deficit(self) -> T {
        self.folds / self.hereditary_rate
    }

    /// Y′ at the end, as ages need it.
    #[inline(always)]
    fn rate(self) -> T {
        raised_to_zero(self.hereditary_rate)
    }

    /// 2 χ F′ times a deficit, as a product of two numbers of the size of Y′.
    #[inline(always)]
    fn bend(self, deficit: T) -> T {
        (T::constant(2.0) * self.force_rate) * (self.folds * deficit)
    }

    /// The age of a deficit that [has one](Self::has_root) by this formula.
    ///
    /// Y(end) − Y(end − z) = Y′ z − χ F′ z²/2, solved for z in the form without cancellation; the square root in it is
    /// Y′ at the time found.
    #[inline(always)]
    pub(super) fn root(self, deficit: T) -> T {
        let (rate, two) = (self.rate(), T::constant(2.0));
        let straight = rate * rate;
        // The radicand without its sign: where Y′ vanishes at the end, a deficit that rounding makes negative must not
        // count as a long time after the end.
        two * deficit / (rate + (straight - self.bend(deficit)).abs().sqrt())
    }

    /// Whether the squares of rates are in range.
    #[inline(always)]
    pub(super) fn has_root(self, deficit: T) -> bool {
        let rate = self.rate();
        let size = rate * rate + self.bend(deficit).abs();
        size.is_finite() & (size * T::default_epsilon() > smallest_normal())
    }

    /// The age of a deficit where the squares of rates are out of range: the same root, with all rates in units of a
    /// power of two near the largest, so that not a bit depends on the units of the load.
    fn age_in_units(self, deficit: T) -> T {
        let Self { folds, force_rate, .. } = self;
        let rate = self.rate();
        let curved = folds.sqrt() * force_rate.abs().sqrt() * deficit.abs().sqrt();
        let largest = rate.max(curved);
        if largest.is_zero() {
            return T::zero();
        }
        let (_, exponent) = split(largest);
        let [rate, force_rate, deficit] = [rate, force_rate, deficit].map(|x| scale(x, -exponent));
        Self { folds, force_rate, hereditary_rate: rate }.root(deficit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bit_of_an_age_depends_on_the_units_of_the_load() {
        for (force_rate, hereditary_rate) in [(0.7, 1.3), (-0.7, 1.3), (-0.7, 0.0)] {
            let age = |unit: f64| {
                let line = Line {
                    folds: 0.3,
                    force_rate: force_rate * unit,
                    hereditary_rate: hereditary_rate * unit,
                };
                line.age(0.1 * unit)
            };
            for exponent in -1000..=1000 {
                assert_eq!(age(2f64.powi(exponent)), age(1.0), "{force_rate}, {hereditary_rate}, {exponent}");
            }
        }
    }

    /// Y′ at the end is rounding of either sign, and so may be a deficit.
    #[test]
    fn ages_are_finite_where_a_load_falls_as_fast_as_it_may() {
        for hereditary_rate in [0.0, 1e-17, -1e-17] {
            let line = Line { folds: 2.0, force_rate: -1.0, hereditary_rate };
            let ages = [0.0, 0.25, -0.25].map(|deficit| line.age(deficit));
            assert_eq!(ages, [0.0, 0.5, -0.5], "{hereditary_rate:e}");
        }
    }
}
