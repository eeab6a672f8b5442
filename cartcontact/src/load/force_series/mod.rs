//! A force over a step of time as a sum of Chebyshev polynomials, and how the hereditary load rose during the step.
//!
//! A load that is not straight gives its force and its impulse. The impulse grows without end, so that after a long
//! history the difference of two impulses has lost the digits of what lies between: at χ t = 1000 the hereditary load
//! of the last e-folding is off by 500 ε. So what drains in a step follows from the forces within it.
//!
//! Let ξ go from −1 at the start of the step to 1 at its end, and F − F(1) = Σ cₖ Tₖ(ξ) interpolate the forces at
//! cos(π j/N), which include both ends; no error of a force is multiplied by more than 3. In a step of h e-foldings the
//! hereditary load grows at dY/dξ = F′ + (h/2) F, and its mean growth M from ξ to the end gives what it still gains,
//! (1 − ξ) M. The division by 1 − ξ is exact, by Clenshaw's recurrence at 1, so that the gain has all its digits even
//! where the time to the end is short; and the force enters only through its difference from that at the end, so that
//! the many small gains of a long history do not round as the force does.
//!
//! How well a series follows its force is graded by what it leaves out, Σ|cₖ| over the last three:
//!
//! | it is | if it leaves out | a step of pressures |
//! |---|---|---|
//! | loose | more than rounding | is shortened, down to 2⁻²⁰ of the time between knots |
//! | rough | more than √ε of the force | is shortened further, down to roundings of the time |
//! | unresolved | as much as it has: the coefficients do not fall | is taken for a jump, if it can be no shorter |

mod age;
mod chebyshev;
mod rounded_times;

use super::Load;
use super::rounding::{is_force, rounding_within_load};
use crate::Scalar;
use chebyshev::{
    Coefficients, DEGREE, abscissa, derivative, leave_out, left_out, length_above, mean_to_the_end, sums_at,
};
use rounded_times::interpolate_at_rounded;

/// The force during a step, and what follows from it.
pub(crate) struct ForceSeries<T> {
    /// When the step ends.
    end: T,
    duration: T,
    /// χ times the duration.
    folds: T,
    /// The forces at the nodes, from the end to the start.
    forces: Coefficients<T>,
    /// The size of the largest force.
    size: T,
    /// What the series [leaves out](left_out).
    rest: T,
    /// What it would leave out if times were not rounded at the nodes: by so much an impulse may be off.
    rest_at_nodes: T,
    /// How many coefficients are more than rounding.
    length: usize,
    /// The series of the force minus that at the end.
    variation: Coefficients<T>,
    /// dY/dξ.
    growth: Coefficients<T>,
    /// The mean of dY/dξ from ξ to the end.
    mean_growth: Coefficients<T>,
}

impl<T: Scalar> ForceSeries<T> {
    /// The first node in time; nodes are counted from the end.
    pub(in crate::load) const START: usize = DEGREE;

    /// The series of a load between two times without a knot between them.
    pub(crate) fn between<L: Load<T> + ?Sized>(load: &L, times: (T, T), chi: T) -> Self {
        Self::through_forces(load, times, chi).grown()
    }

    /// The series [between](Self::between) two times without the coefficients that are noise.
    pub(crate) fn without_noise<L: Load<T>>(load: &L, times: (T, T), chi: T) -> Self {
        Self::through_forces(load, times, chi).denoised().grown()
    }

    fn through_forces<L: Load<T> + ?Sized>(load: &L, (start, end): (T, T), chi: T) -> Self {
        let duration = end - start;
        // Exactly the start: the duration is rounded, and a little earlier the load may be another.
        let times = core::array::from_fn(|place| {
            if place == Self::START { start } else { time_at(abscissa(place), (duration, end)) }
        });
        let forces = times.map(|time| if time < end { load.force(time) } else { load.force_before(end) });
        let size = largest(&forces);
        let (mut variation, rest_at_nodes) =
            interpolate_at_rounded(&forces.map(|force| force - forces[0]), &times);
        let rest = left_out(&variation);
        // The rounding of the largest force.
        let length = length_above(&variation, size * T::default_epsilon() * T::constant(0.5));
        let length = leave_out(&mut variation, length);
        let none = [T::zero(); DEGREE + 1];
        let folds = chi * duration;
        Self {
            end,
            duration,
            folds,
            forces,
            size,
            rest,
            rest_at_nodes,
            length,
            variation,
            growth: none,
            mean_growth: none,
        }
    }

    /// Leaves out the coefficients that are noise.
    ///
    /// After a long history the times of the nodes are rounded by a share of the step, and the forces with them.
    /// Coefficients then no longer decrease, but from some degree on are as large as the last. F′ multiplies them by
    /// up to N², and no quadrature rule resolves such waves. The series still has the forces at both ends, so that
    /// steps join, and what a pressure gains and loses during them remains that of one history.
    fn denoised(mut self) -> Self {
        let noise = (largest(&self.variation[DEGREE - 2..]) * T::constant(4.0)).min(self.rounding());
        let length = length_above(&self.variation[..self.length], noise).max(2);
        self.length = leave_out(&mut self.variation, length);
        let (mut at_end, mut at_start) = (T::zero(), self.forces[Self::START] - self.last());
        for (k, &c) in self.variation.iter().enumerate() {
            at_end -= c;
            at_start -= if k.is_multiple_of(2) { c } else { -c };
        }
        let half = T::constant(0.5);
        self.variation[0] += (at_end + at_start) * half;
        self.variation[1] += (at_end - at_start) * half;
        self
    }

    /// Derives the growth from the variation of the force.
    fn grown(mut self) -> Self {
        let (length, half_folds) = (self.length, self.folds * T::constant(0.5));
        self.growth = derivative(&self.variation[..length]);
        for (growth, &variation) in self.growth.iter_mut().zip(&self.variation[..length]) {
            *growth += half_folds * variation;
        }
        self.growth[0] += half_folds * self.last();
        self.mean_growth = mean_to_the_end(&self.growth[..length]);
        self
    }

    /// When the step ends.
    pub(crate) fn end(&self) -> T {
        self.end
    }

    /// The duration of the step.
    pub(crate) fn duration(&self) -> T {
        self.duration
    }

    /// χ times the duration.
    pub(crate) fn folds(&self) -> T {
        self.folds
    }

    /// The force at the start, and just before the end.
    pub(crate) fn ends(&self) -> (T, T) {
        (self.forces[Self::START], self.last())
    }

    /// The force just before the end.
    pub(crate) fn last(&self) -> T {
        self.forces[0]
    }

    /// The largest force at a node.
    pub(crate) fn largest(&self) -> T {
        self.size
    }

    /// ∫F over the step, and by how much it may be off because of what the series leaves out.
    pub(crate) fn impulse(&self) -> (T, T) {
        // The mean of Tₖ is 1/(1 − k²) for even k and zero for odd k.
        let even = self.variation.iter().step_by(2).zip((0_u16..).step_by(2));
        let means = even.map(|(&c, k)| c / (T::one() - T::constant(f64::from(k * k))));
        let mean = self.last() + means.fold(T::zero(), |sum, c| sum + c);
        (self.duration * mean, self.duration * self.rest_at_nodes)
    }

    /// Whether the load has another impulse over the step, by more than rounding: the nodes then miss what it does
    /// between them.
    pub(crate) fn misses(&self, impulse: T, rounding: T) -> bool {
        let (of_series, uncertainty) = self.impulse();
        (impulse - of_series).abs() > uncertainty + rounding
    }

    /// Whether the step is too long for the series.
    pub(crate) fn is_rough(&self) -> bool {
        self.rest > self.size * T::default_epsilon().sqrt()
    }

    /// Whether the force falls so far that its rounding at the start counts at the end.
    ///
    /// A fall to 1/16 within two e-foldings is faster than e^(−χ t): such forces are rounding themselves.
    pub(crate) fn falls_far(&self) -> bool {
        let share = T::constant(1.0 / 16.0);
        self.last() < self.size * share && self.folds > T::constant(2.0)
    }

    /// Whether the coefficients do not decrease, so that the series meets the force only at the nodes.
    ///
    /// Any share from 2⁻⁶ to 2⁻¹⁴ would do, and 2 ε as well; with 128 ε rises from zero take more than twice as many
    /// forces.
    pub(crate) fn is_unresolved(&self) -> bool {
        let varying = self.variation[1..].iter().fold(T::zero(), |sum, c| sum + c.abs());
        let rounding = self.size * T::default_epsilon() * T::constant(16.0);
        self.rest > varying * T::constant(1.0 / 1024.0) + rounding
    }

    /// The most by which the hereditary load can fall within the step, as far as the coefficients tell: it does not
    /// fall unless this is above zero.
    pub(in crate::load) fn deepest_dip(&self) -> T {
        let least = self.growth[1..].iter().fold(self.growth[0], |least, g| least - g.abs());
        let left_out = self.rest * T::constant((DEGREE * DEGREE) as f64);
        T::constant(2.0) * (left_out - least)
    }

    /// The most by which the hereditary load may grow in an e-folding, as far as the coefficients tell.
    pub(crate) fn highest_rate(&self) -> T {
        self.growth.iter().fold(T::zero(), |sum, g| sum + g.abs()) * T::constant(2.0) / self.folds
    }

    /// Whether the hereditary load grows at a rate that changes by no more than a half from its mean.
    pub(crate) fn grows_steadily(&self) -> bool {
        let varying = self.growth[1..].iter().fold(T::zero(), |sum, g| sum + g.abs());
        varying + varying <= self.growth[0]
    }

    /// How large a [dip](Self::deepest_dip) the rounding of forces may make, N³ ε of them.
    pub(in crate::load) fn rounding_of_dip(&self) -> T {
        self.size * T::default_epsilon() * T::constant((DEGREE * DEGREE * DEGREE) as f64)
    }

    /// By how much the hereditary load grows in all.
    pub(crate) fn gain(&self) -> T {
        let [_, mean_growth] = self.growth_at(-T::one());
        T::constant(2.0) * mean_growth
    }

    /// By how much the hereditary load grows from each node to the end.
    ///
    /// The forces at the nodes are taken as they are, each with its rounded time, so that a jump between nodes, which
    /// spoils the series, affects only what drains.
    pub(in crate::load) fn growth_since_nodes(&self) -> Coefficients<T> {
        let mean = mean_to_the_end(&self.variation[..self.length]);
        core::array::from_fn(|node| {
            let x = abscissa(node);
            let since = self.folds * ((self.end - self.time(node)) / self.duration);
            let [mean] = sums_at([&mean[..self.length]], x);
            (self.last() - self.forces[node]) + since * (self.last() + mean)
        })
    }

    /// By how much [`growth_since_nodes`](Self::growth_since_nodes) may be off because of what the series leaves out.
    pub(in crate::load) fn uncertainty_of_gains(&self) -> T {
        self.folds * self.rest
    }

    /// By how much [`growth_since_nodes`](Self::growth_since_nodes) may be rounded: early in a long step the hereditary
    /// load may be far smaller.
    pub(in crate::load) fn rounding_of_gains(&self) -> T {
        self.folds * self.size * T::default_epsilon() * T::constant(DEGREE as f64)
    }

    /// The force at a node.
    pub(in crate::load) fn force_at(&self, node: usize) -> T {
        self.forces[node]
    }

    /// The time and the force of the first node whose force is negative by more than what is negligible, or not finite.
    pub(in crate::load) fn invalid_force(&self, negligible: T) -> Option<(T, T)> {
        let node = (0..=Self::START).rev().find(|&node| !is_force(self.forces[node], negligible))?;
        Some((self.time(node), self.forces[node]))
    }

    /// The time of a node.
    pub(in crate::load) fn time(&self, node: usize) -> T {
        time_at(abscissa(node), (self.duration, self.end))
    }

    /// The time at which the hereditary load turns, next to the node at which it is highest.
    pub(in crate::load) fn time_of_turn(&self, highest: usize) -> T {
        let half = T::constant(0.5);
        let (mut rising, mut falling) =
            (abscissa((highest + 1).min(DEGREE)), abscissa(highest.saturating_sub(1)));
        // The nodes are less than 1/2 apart, so this goes down to the spacing of numbers.
        for _ in 0..60 {
            let middle = (rising + falling) * half;
            if self.growth_at(middle)[0] > T::zero() {
                rising = middle;
            } else {
                falling = middle;
            }
        }
        time_at(rising, (self.duration, self.end))
    }

    /// Whether the series leaves out more than rounding.
    pub(crate) fn is_loose(&self) -> bool {
        self.rest > self.rounding()
    }

    /// The effect of rounding the forces, and the times that they belong to.
    fn rounding(&self) -> T {
        let slope = derivative(&self.variation[..self.length]);
        let change = slope.iter().fold(T::zero(), |sum, c| sum + c.abs());
        rounding_within_load(self.size) + change * (self.end / self.duration) * T::default_epsilon()
    }

    /// dY/dξ, and its mean from there to the end.
    fn growth_at(&self, x: T) -> [T; 2] {
        sums_at([&self.growth[..self.length], &self.mean_growth[..self.length]], x)
    }
}

/// The time at ξ in a step of a duration up to an end.
fn time_at<T: Scalar>(x: T, (duration, end): (T, T)) -> T {
    end - duration * (T::one() - x) * T::constant(0.5)
}

/// The largest magnitude among some numbers.
fn largest<T: Scalar>(numbers: &[T]) -> T {
    numbers.iter().fold(T::zero(), |largest, x| largest.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(ForceSeries::between(&Kink, (0.0, 1.0), 1.0).is_rough());
        assert!(!ForceSeries::between(&Kink, (0.3, 1.0), 1.0).is_rough());
    }
}
