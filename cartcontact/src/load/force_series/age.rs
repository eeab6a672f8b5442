//! How long before the end of a step the hereditary load was smaller by some amount.

use super::ForceSeries;
use crate::Scalar;

impl<T: Scalar> ForceSeries<T> {
    /// How much smaller the hereditary load was some e-foldings before the end than at the end, and how much it grew
    /// per e-folding then.
    pub(crate) fn shortfall(&self, folds: T) -> (T, T) {
        let per_fold = T::constant(2.0) / self.folds;
        let before_end = folds * per_fold;
        let [growth, mean_growth] = self.growth_at(T::one() - before_end);
        (before_end * mean_growth, growth * per_fold)
    }

    /// How many e-foldings before the end the hereditary load was smaller by `deficit`.
    ///
    /// Newton's method in a bracket, which is halved where a step would leave it. It ends with the step after which
    /// only rounding is left, so that derivatives are those of the root, and after 60 steps at the latest.
    ///
    /// A rounded radius may belong to a time just outside the step.
    pub(crate) fn age(&self, deficit: T) -> T {
        let margin = self.folds * T::constant(1.0 / 64.0);
        let (mut low, mut high) = (-margin, self.folds + margin);
        let gain = self.gain();
        let noise = (gain.abs() + deficit.abs()) * T::default_epsilon();
        let mut folds = if gain > T::zero() { self.folds * (deficit / gain) } else { T::zero() };
        folds = folds.max(low).min(high);
        for _ in 0..60 {
            let (found, rate) = self.shortfall(folds);
            let excess = found - deficit;
            if excess < T::zero() {
                low = folds;
            } else {
                high = folds;
            }
            let next = folds - excess / rate;
            folds = if low <= next && next <= high { next } else { (low + high) * T::constant(0.5) };
            if excess.abs() <= noise || high - low <= high * T::default_epsilon() {
                break;
            }
        }
        folds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::Load;

    /// F = e^(−t): Y at the age z before the end is larger by F(end) (1 − χ) (e^z − 1).
    struct Fall;

    impl Load<f64> for Fall {
        fn force(&self, t: f64) -> f64 {
            (-t).exp()
        }

        fn impulse(&self, t: f64) -> f64 {
            -(-t).exp_m1()
        }
    }

    #[test]
    fn ages_are_right_to_the_rounding_of_the_force() {
        for chi in [1.5, 4.0, 1000.0] {
            let (start, end) = (2.0, 2.5);
            let series = ForceSeries::between(&Fall, (start, end), chi);
            assert!(!series.is_rough());
            for age in [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.37, 0.5] {
                let deficit = Fall.force(end) * (chi - 1.0) * f64::exp_m1(age);
                let (found, rate) = series.shortfall(chi * age);
                let scale = Fall.force(end - age) * (1.0 + chi * age) * f64::EPSILON;
                assert!((found - deficit).abs() < 8.0 * scale, "{chi}, {age}: {found:e}, {deficit:e}");
                let exact_rate = Fall.force(end - age) * (chi - 1.0) / chi;
                assert!((rate / exact_rate - 1.0).abs() < 1e-12, "{chi}, {age}: {rate:e}, {exact_rate:e}");
                let error = (series.age(deficit) - chi * age) * rate;
                assert!(error.abs() < 8.0 * scale, "{chi}, {age}: {error:e}");
            }
            let (impulse, uncertainty) = series.impulse();
            let exact = Fall.force(end) * f64::exp_m1(end - start);
            assert!(
                (impulse / exact - 1.0).abs() < 1e-15 && uncertainty < 1e-15 * exact,
                "{impulse:e}, {exact:e}"
            );
        }
    }

    #[test]
    fn a_held_force_has_ages_to_the_last_digit() {
        let load = crate::load::Constant(70.0);
        let series = ForceSeries::between(&load, (1e6, 1.5e6), 0.02);
        for age in [1e-9, 0.3, 1e3, 4e5] {
            let found: f64 = series.age(0.02 * age * 70.0);
            assert!((found / (0.02 * age) - 1.0).abs() < 4.0 * f64::EPSILON, "{age}: {found}");
        }
    }
}
