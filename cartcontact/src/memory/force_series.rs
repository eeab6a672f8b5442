//! A force over a step of time as a sum of Chebyshev polynomials, and how the hereditary load rose during the step.
//!
//! A load that is not straight tells its force and its impulse. The impulse grows without end, so that after a long
//! history the difference of two has lost the digits of what lies between: at χ t = 1000 the hereditary load of the last
//! e-folding is off by 500 ε. So what drains in a step follows from the forces within it.
//!
//! Let ξ go from −1 at the start of the step to 1 at its end, and F = Σ cₖ Tₖ(ξ) interpolate the forces at cos(π j/N),
//! which include both ends; no error of a force is multiplied by more than 3. Its integral has the coefficients
//! (cₖ₋₁ − cₖ₊₁)/(2k), and the mean force from ξ to the end is that integral from ξ to 1 over 1 − ξ. The division is exact,
//! by Clenshaw's recurrence at 1, so that the mean has all its digits also where the time to the end is short.
//!
//! F′ multiplies the rounding of forces by up to N², but within integrals over time that drops out but for what it is at
//! the ends.
//!
//! Source: J. C. Mason, D. C. Handscomb, Chebyshev Polynomials (2003), chapters 2.4, 6.3.

use crate::Scalar;
use crate::load::Load;

/// The degree N.
const DEGREE: usize = 16;

/// cos(π j/16), rounded from 40 digits.
const COSINES: [f64; DEGREE / 2 + 1] = [
    1.0,
    0.980_785_280_403_230_4,
    0.923_879_532_511_286_7,
    0.831_469_612_302_545_2,
    core::f64::consts::FRAC_1_SQRT_2,
    0.555_570_233_019_602_2,
    0.382_683_432_365_089_8,
    0.195_090_322_016_128_28,
    0.0,
];

/// The coefficients of Chebyshev polynomials.
type Coefficients<T> = [T; DEGREE + 1];

/// The force during a step, and what follows from it.
pub(crate) struct ForceSeries<T> {
    duration: T,
    /// χ times the duration.
    folds: T,
    force: Coefficients<T>,
    /// dF/dξ.
    slope: Coefficients<T>,
    /// The mean force from ξ to the end.
    mean: Coefficients<T>,
    /// How many coefficients are more than rounding, and the size of the largest.
    length: usize,
    size: T,
    /// The forces at the nodes, from the end to the start.
    forces: [T; DEGREE + 1],
    /// By how much the hereditary load grows in all.
    gain: T,
    /// The most by which the hereditary load grows in an e-folding.
    pub(super) highest_rate: T,
    /// Whether the force falls anywhere.
    pub(super) falls: bool,
}

/// A force, dF/dξ, and the mean force from there to the end.
struct Local<T> {
    force: T,
    slope: T,
    mean: T,
}

impl<T: Scalar> ForceSeries<T> {
    /// The first node in time, which are counted from the end.
    pub(crate) const START: usize = DEGREE;

    /// The series of a load between two times without a knot between them, with what holds for all of the step.
    pub(super) fn of<L: Load<T>>(load: &L, times: (T, T), chi: T) -> Self {
        let mut series = Self::between(load, times, chi);
        series.survey();
        series
    }

    /// [`of`](Self::of) without what holds for all of the step.
    pub(crate) fn between<L: Load<T> + ?Sized>(load: &L, (start, end): (T, T), chi: T) -> Self {
        let duration = end - start;
        let forces: Coefficients<T> = core::array::from_fn(|place| {
            let before_end = duration * (T::one() - T::constant(cosine(place))) * T::constant(0.5);
            let time = end - before_end;
            if time < end { load.force(time) } else { load.force_before(end) }
        });
        let (force, size) = coefficients(&forces);
        let negligible = size * T::default_epsilon() * T::constant(0.5);
        let length = force.iter().rposition(|c| c.abs() > negligible).map_or(1, |last| last + 1);
        let (slope, mean) = (derivative(&force[..length]), mean_to_the_end(&force[..length]));
        let (folds, none) = (chi * duration, T::zero());
        Self {
            duration,
            folds,
            force,
            slope,
            mean,
            length,
            size,
            forces,
            gain: none,
            highest_rate: none,
            falls: false,
        }
    }

    /// Notes what holds for all of the step.
    fn survey(&mut self) {
        for (place, &force) in self.forces.iter().enumerate() {
            let here = self.at(T::constant(cosine(place)));
            self.highest_rate = self.highest_rate.max(self.rate(&here));
            // From the end to the start.
            let later = self.forces[place.saturating_sub(1)];
            self.falls |= force > later * (T::one() + T::default_epsilon() * T::constant(8.0));
        }
        self.gain = self.shortfall(self.folds).0;
    }

    /// χ times the duration.
    pub(super) fn folds(&self) -> T {
        self.folds
    }

    /// The force at the end.
    fn last(&self) -> T {
        self.forces[0]
    }

    /// ∫F over the step, and by how much it may be off for what the series leaves out.
    pub(crate) fn impulse(&self) -> (T, T) {
        let mean = self.at(-T::one()).mean;
        (self.duration * mean, self.duration * self.rest())
    }

    /// Whether the load has another impulse over the step, by more than rounding: the nodes then miss what it does
    /// between them.
    pub(crate) fn misses(&self, impulse: T, rounding: T) -> bool {
        let (of_series, uncertainty) = self.impulse();
        (impulse - of_series).abs() > uncertainty + rounding
    }

    /// Whether the step is too long for the series.
    pub(crate) fn is_rough(&self) -> bool {
        self.rest() > self.force[0].abs() * T::default_epsilon().sqrt()
    }

    /// Whether the coefficients do not decrease, so that the series only meets the force at the nodes.
    pub(crate) fn is_unresolved(&self) -> bool {
        let varying = self.force[1..].iter().fold(T::zero(), |sum, c| sum + c.abs());
        let rounding = self.size * T::default_epsilon() * T::constant(16.0);
        self.rest() > varying * T::constant(1.0 / 1024.0) + rounding
    }

    /// The most by which the hereditary load can fall within the step, as far as the coefficients tell: it does not if
    /// this is not above zero.
    pub(crate) fn deepest_dip(&self) -> T {
        let half_folds = self.folds * T::constant(0.5);
        let growth = self.slope.iter().zip(&self.force).map(|(&slope, &force)| slope + half_folds * force);
        let least =
            growth.enumerate().fold(T::zero(), |least, (k, g)| if k == 0 { g } else { least - g.abs() });
        let left_out = self.rest() * T::constant((DEGREE * DEGREE) as f64);
        T::constant(2.0) * (left_out - least)
    }

    /// By how much a [dip](Self::deepest_dip) may come from the rounding of forces, N³ ε of them.
    pub(crate) fn noise(&self) -> T {
        self.size * T::default_epsilon() * T::constant((DEGREE * DEGREE * DEGREE) as f64)
    }

    /// By how much the hereditary load grows from a node to the end.
    pub(crate) fn growth_since(&self, node: usize) -> T {
        let x = T::constant(cosine(node));
        let since = self.folds * (T::one() - x) * T::constant(0.5);
        (self.last() - self.forces[node]) + since * self.at(x).mean
    }

    /// By how much [`growth_since`](Self::growth_since) may be off for what the series leaves out.
    pub(crate) fn uncertainty(&self) -> T {
        self.folds * self.rest()
    }

    /// The force at a node.
    pub(crate) fn force_at(&self, node: usize) -> T {
        self.forces[node]
    }

    /// The time of a node, if the step ends at `end`.
    pub(crate) fn time(&self, node: usize, end: T) -> T {
        self.time_at(T::constant(cosine(node)), end)
    }

    fn time_at(&self, x: T, end: T) -> T {
        end - self.duration * (T::one() - x) * T::constant(0.5)
    }

    /// When the hereditary load turns, next to the node at which it is highest of all.
    pub(crate) fn time_of_turn(&self, highest: usize, end: T) -> T {
        let half = T::constant(0.5);
        let position = |node: usize| T::constant(cosine(node));
        let (mut rising, mut falling) =
            (position((highest + 1).min(DEGREE)), position(highest.saturating_sub(1)));
        for _ in 0..60 {
            let middle = (rising + falling) * half;
            let here = self.at(middle);
            if here.slope + self.folds * half * here.force > T::zero() {
                rising = middle;
            } else {
                falling = middle;
            }
        }
        self.time_at(rising, end)
    }

    /// Whether the series leaves out more than what rounds: forces, and the times up to `end` that they are of.
    pub(super) fn is_loose(&self, end: T) -> bool {
        let change = self.slope.iter().fold(T::zero(), |sum, c| sum + c.abs());
        let forces = self.size * T::constant(64.0);
        self.rest() > (forces + change * (end / self.duration)) * T::default_epsilon()
    }

    /// The size of the last coefficients, which is more than that of all behind them if they fall.
    fn rest(&self) -> T {
        self.force[DEGREE - 2..].iter().fold(T::zero(), |rest, c| rest + c.abs())
    }

    /// How much smaller than at the end the hereditary load was some e-foldings before, and by how much it grew in an
    /// e-folding.
    pub(super) fn shortfall(&self, folds: T) -> (T, T) {
        let share = folds / self.folds;
        let here = self.at(T::one() - share - share);
        (self.last() - here.force + folds * here.mean, self.rate(&here))
    }

    /// How long before the end the hereditary load was smaller by `deficit`.
    pub(super) fn age(&self, deficit: T) -> T {
        self.folds_since(deficit) / self.folds * self.duration
    }

    /// Newton's method in a bracket, which is halved where a step would leave it. It ends with the step after which
    /// there is nothing but rounding left, so that derivatives are those of the root, and after 60 steps at the latest.
    ///
    /// A rounded radius may belong to a time just outside the step.
    fn folds_since(&self, deficit: T) -> T {
        let margin = self.folds * T::constant(1.0 / 64.0);
        let (mut low, mut high) = (-margin, self.folds + margin);
        let noise = (self.last().abs() + deficit.abs()) * T::default_epsilon();
        let mut folds = if self.gain > T::zero() { self.folds * (deficit / self.gain) } else { T::zero() };
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

    /// By how much the hereditary load grows in an e-folding.
    fn rate(&self, here: &Local<T>) -> T {
        here.force + T::constant(2.0) * here.slope / self.folds
    }

    fn at(&self, x: T) -> Local<T> {
        let mut local = Local { force: self.force[0], slope: self.slope[0], mean: self.mean[0] };
        let (mut before, mut value) = (T::one(), x);
        for degree in 1..self.length {
            local.force += self.force[degree] * value;
            local.slope += self.slope[degree] * value;
            local.mean += self.mean[degree] * value;
            (before, value) = (value, (x + x) * value - before);
        }
        local
    }
}

/// cos(π k/16).
fn cosine(k: usize) -> f64 {
    let turn = k % (2 * DEGREE);
    let half = turn.min(2 * DEGREE - turn);
    if half <= DEGREE / 2 { COSINES[half] } else { -COSINES[DEGREE - half] }
}

/// The coefficients of the polynomial through values at cos(π j/N), and the size of the largest.
fn coefficients<T: Scalar>(values: &Coefficients<T>) -> (Coefficients<T>, T) {
    // The first and the last count half in either sum.
    let weight = |index: usize| if index.is_multiple_of(DEGREE) { 0.5 } else { 1.0 };
    let coefficients = core::array::from_fn(|k| {
        let terms =
            values.iter().enumerate().map(|(j, &value)| value * T::constant(weight(j) * cosine(j * k)));
        terms.fold(T::zero(), |sum, term| sum + term) * T::constant(weight(k) * 2.0 / DEGREE as f64)
    });
    let size = coefficients.iter().fold(T::zero(), |size: T, c: &T| size.max(c.abs()));
    (coefficients, size)
}

/// The derivative of a sum: d₍ₖ₋₁₎ = d₍ₖ₊₁₎ + 2 k cₖ, of which the first is halved.
fn derivative<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let mut slope = [T::zero(); DEGREE + 1];
    for k in (1..sum.len()).rev() {
        let above = if k < DEGREE { slope[k + 1] } else { T::zero() };
        slope[k - 1] = above + sum[k] * T::constant(2.0 * k as f64);
    }
    slope[0] *= T::constant(0.5);
    slope
}

/// The mean of a sum from ξ to 1.
///
/// With the coefficients aₖ of the integral, βₖ = 2 β₍ₖ₊₁₎ − β₍ₖ₊₂₎ + aₖ are those of its quotient by ξ − 1: β₁ + 2 Σ β₍ₖ₊₁₎ Tₖ.
fn mean_to_the_end<T: Scalar>(sum: &[T]) -> Coefficients<T> {
    let at = |k: usize| sum.get(k).copied().unwrap_or(T::zero());
    let two = T::constant(2.0);
    let mut mean = [T::zero(); DEGREE + 1];
    let (mut above, mut next) = (T::zero(), T::zero());
    for k in (1..=sum.len()).rev() {
        let first = if k == 1 { two * at(0) } else { at(k - 1) };
        let of_integral = (first - at(k + 1)) * T::constant(0.5 / k as f64);
        (above, next) = (next, two * next - above + of_integral);
        mean[k - 1] = if k == 1 { next } else { two * next };
    }
    mean
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let series = ForceSeries::of(&Fall, (start, end), chi);
            assert!(series.falls && !series.is_rough());
            for age in [0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.37, 0.5] {
                let deficit = Fall.force(end) * (chi - 1.0) * f64::exp_m1(age);
                let (found, rate) = series.shortfall(chi * age);
                let scale = Fall.force(end - age) * (1.0 + chi * age) * f64::EPSILON;
                assert!((found - deficit).abs() < 8.0 * scale, "{chi}, {age}: {found:e}, {deficit:e}");
                let exact_rate = Fall.force(end - age) * (chi - 1.0) / chi;
                assert!((rate / exact_rate - 1.0).abs() < 1e-12, "{chi}, {age}: {rate:e}, {exact_rate:e}");
                let error = chi * (series.age(deficit) - age) * rate;
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
        let series = ForceSeries::of(&load, (1e6, 1.5e6), 0.02);
        for age in [1e-9, 0.3, 1e3, 4e5] {
            let found: f64 = series.age(0.02 * age * 70.0);
            assert!((found / age - 1.0).abs() < 4.0 * f64::EPSILON, "{age}: {found}");
        }
    }

    #[test]
    fn a_kink_is_rough() {
        struct Kink;
        impl Load<f64> for Kink {
            fn force(&self, t: f64) -> f64 {
                1.0 + (t - 0.3).max(0.0)
            }
            fn impulse(&self, t: f64) -> f64 {
                t + (t - 0.3).max(0.0).powi(2) / 2.0
            }
        }
        assert!(ForceSeries::of(&Kink, (0.0, 1.0), 1.0).is_rough());
        assert!(!ForceSeries::of(&Kink, (0.3, 1.0), 1.0).is_rough());
    }
}
