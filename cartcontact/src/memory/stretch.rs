//! One stretch of history without a knot inside, and how long ago the edge passed a radius in it.

use super::degree::{degree_of_load_integral, least_degree};
use super::fading::Fading;
use super::line::Line;
use super::{Increment, time_form};
use crate::contact::Contact;
use crate::load::{ForceSeries, Load};
use crate::numbers::exponential::decay;
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};

/// Below this degree of J the radius, as a function of time, is steeper than a cube root. Measured: time, as the
/// variable, takes ten times as long as the radius at a degree of 1.2, and no longer from 3 on.
const LOW_DEGREE: f64 = 3.0;

/// The radii from `low` to `high` that the edge passed while the load took a course.
pub(super) struct Stretch<'a, T, P, L> {
    pub(super) contact: &'a Contact<T, P, L>,
    pub(super) course: &'a Course<'a, T>,
    pub(super) low: T,
    /// The contact radius at the end of the stretch.
    pub(super) high: T,
    /// The amount by which the hereditary load at the end exceeds that of the rounded radius `high`.
    pub(super) surplus: T,
    /// Whether the whole course counts, rather than only the part beyond `low`.
    pub(super) is_whole: bool,
}

/// How the hereditary load Y = F + χ ∫F rose during a stretch.
pub(super) enum Course<'a, T> {
    /// All at once, `age` e-foldings before the end, chosen so that the right share is left there; `folds` pass in all.
    Step { age: T, folds: T },
    /// Along a straight load.
    Linear(Line<T>),
    /// Along any other load.
    Smooth(&'a ForceSeries<T>),
}

impl<'a, T: Scalar> Course<'a, T> {
    /// A straight load between two forces. A rise during which nothing drains is a step, unless what drains may have a
    /// derivative.
    pub(super) fn straight(folds: T, (first, last): (T, T)) -> Self {
        if last > first && is_instant(folds) && has_no_derivatives::<T>() {
            return Self::at_once(folds);
        }
        Self::Linear(Line::to(last, last - first, folds))
    }

    /// A load of any other kind.
    pub(super) fn smooth(force: &'a ForceSeries<T>) -> Self {
        let folds = force.folds();
        if is_instant(folds) { Self::at_once(folds) } else { Self::Smooth(force) }
    }

    /// A jump of the load, which takes no time.
    pub(super) fn jump() -> Self {
        Self::at_once(T::zero())
    }

    /// All at the end of so many e-foldings.
    fn at_once(folds: T) -> Self {
        Self::Step { age: T::zero(), folds }
    }

    /// χ times the duration.
    pub(super) fn folds(&self) -> T {
        match self {
            Self::Step { folds, .. } | Self::Linear(Line { folds, .. }) => *folds,
            Self::Smooth(force) => force.folds(),
        }
    }

    /// What is left after the course.
    ///
    /// A straight fall by x e-foldings keeps 1/(1 + x) of its force or more, beside which the product that χ times the
    /// duration loses, x ε/2 of e^(−x), is nothing; a smooth one may keep e^(−x).
    pub(super) fn fading(&self, chi: T) -> Fading<T> {
        match self {
            Self::Smooth(force) => Fading::over_duration(chi, force.duration()),
            Self::Step { .. } | Self::Linear(_) => Fading::over(self.folds()),
        }
    }

    /// Whether the load, if the course takes time, was held, so that ages grow as deficits do.
    pub(super) fn is_held(&self) -> bool {
        match self {
            Self::Step { .. } => true,
            Self::Linear(line) => line.is_held(),
            Self::Smooth(_) => false,
        }
    }

    /// Whether the forces at its ends determine those between them.
    pub(super) fn is_straight(&self) -> bool {
        !matches!(self, Self::Smooth(_))
    }
}

/// Whether nothing drains in so few e-foldings.
fn is_instant<T: Scalar>(folds: T) -> bool {
    folds <= T::default_epsilon() * T::constant(0.125)
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// What the stretch adds to the pressure, and whether it is integrated over time, and so up to the exact radius at
    /// its end.
    ///
    /// Where the edge nearly stands still, a falling load can make τ(s) steep like a square root, and so can one that
    /// is not straight; all others are integrated over the radius, which needs no inversion of J. So is a steady load
    /// where J nearly stands still instead, which makes the radius steep as a function of time.
    #[inline(always)]
    pub(super) fn increment(&self) -> (Increment<T>, bool) {
        // Rounding can put the radii in the wrong order.
        if self.low >= self.high {
            return (Increment::zero(), false);
        }
        let over_time = match *self.course {
            Course::Linear(line) if line.force_rate < T::zero() => {
                let (rate, rise) = (line.hereditary_rate / line.folds, -line.force_rate / line.folds);
                let half = T::constant(0.5);
                time_form::increment(
                    self,
                    (rate, rise),
                    #[inline(always)]
                    |x| (x * (rate + half * rise * x), rate + rise * x),
                )
            }
            Course::Smooth(force)
                if self.may_be_smooth()
                    && self.begins_loaded()
                    && !(least_degree(self.contact.profile(), self.high) < T::constant(LOW_DEGREE)
                        && force.grows_steadily()) =>
            {
                time_form::increment(self, (force.highest_rate(), T::zero()), |x| force.shortfall(x))
            }
            _ => return (self.increment_over_radius(), false),
        };
        (over_time, true)
    }

    /// Whether the load has courses other than straight ones. Where its type tells that it has none, compilers leave
    /// out the code for them, a tenth of the code of a pressure.
    #[inline(always)]
    fn may_be_smooth(&self) -> bool {
        !self.contact.load().is_linear_between_knots()
    }

    /// How many e-foldings before the end Y was smaller than at the end by `deficit`.
    #[inline(always)]
    pub(super) fn age(&self, deficit: T) -> T {
        match *self.course {
            Course::Step { age, .. } => age,
            Course::Linear(line) => line.folds * line.age(deficit),
            Course::Smooth(force) if self.may_be_smooth() => force.age(deficit),
            Course::Smooth(_) => T::zero(),
        }
    }

    /// Whether the hereditary load is well above zero throughout.
    fn begins_loaded(&self) -> bool {
        let profile = self.contact.profile();
        let sixteenth = T::constant(1.0 / 16.0);
        profile.quick_load_integral(self.low) >= profile.quick_load_integral(self.high) * sixteenth
    }

    /// How many e-foldings before the end the edge passed the radius `high` − `depth`.
    #[inline]
    pub(super) fn age_at(&self, depth: T) -> T {
        let drop = self.contact.profile().load_integral_drop(self.high, depth);
        self.age(self.deficit(drop))
    }

    /// By how much the hereditary load at the end exceeds that of a radius whose J is smaller by `drop`.
    #[inline(always)]
    fn deficit(&self, drop: T) -> T {
        self.contact.load_per_integral() * drop + self.surplus
    }

    /// Multiplies each weight, laid at a radius whose J is smaller by a drop, by e^(−age), the share left at the end.
    #[inline(always)]
    pub(super) fn fade(&self, weights: &mut [T], drops: &[T]) {
        // Ages that one formula gives are computed in vectors.
        match *self.course {
            // Next to the smallest subnormal forces the quotient overflows, and times no deficit would be no number.
            Course::Linear(line) if line.is_held() && line.folds_per_deficit().is_finite() => {
                let folds_per_deficit = line.folds_per_deficit();
                self.fade_by(
                    #[inline(always)]
                    |deficit| deficit * folds_per_deficit,
                    (weights, drops),
                );
            }
            Course::Linear(line) if self.have_roots(line, drops) => self.fade_by(
                #[inline(always)]
                |deficit| line.folds * line.root(deficit),
                (weights, drops),
            ),
            _ => self.fade_by(|deficit| self.age(deficit), (weights, drops)),
        }
    }

    /// [`fade`](Self::fade) with the ages of deficits by a function.
    #[inline(always)]
    fn fade_by(&self, age: impl Fn(T) -> T, (weights, drops): (&mut [T], &[T])) {
        for (weight, &drop) in weights.iter_mut().zip(drops) {
            *weight *= decay(age(self.deficit(drop)));
        }
    }

    /// Whether all drops have an age by [`Line::root`].
    #[inline(always)]
    fn have_roots(&self, line: Line<T>, drops: &[T]) -> bool {
        drops.iter().fold(
            true,
            #[inline(always)]
            |all, &drop| all & line.has_root(self.deficit(drop)),
        )
    }

    /// The distance, in the plane of complex radii, at which the age of a radius below `top` has a singularity.
    ///
    /// Along a straight rising load it is the branch point of the square root, Y′ = 0, of the load continued backwards:
    /// there J falls short of its value at the edge by Y′²/(2 χ F′). J is nearly a power a^p, with p = a J′/J at `top`;
    /// where it would have to be negative, |J|^(1/p) e^(iπ/p) is the nearest root, and sin(π/p) > 2.8/p for p ≥ 4. For
    /// any other load nothing is known; half that distance is assumed.
    pub(super) fn singularity(&self, top: T) -> Option<T> {
        let half = T::constant(0.5);
        let off_axis = |radius: T, degree: T| radius * T::constant(2.8) / degree;
        match *self.course {
            Course::Linear(Line { folds, force_rate, hereditary_rate }) if force_rate > T::zero() => {
                let profile = self.contact.profile();
                let load_integral = profile.quick_load_integral(top);
                let deficit = (hereditary_rate / force_rate) * (hereditary_rate / folds) * half;
                // As shares of J at `top`: the deficit is a force, and divided by π m/4 it may be out of range.
                let share_of_deficit = deficit / (self.contact.load_per_integral() * load_integral);
                let singular = profile.quick_load_integral(self.high) / load_integral - share_of_deficit;
                let degree = degree_of_load_integral(profile, top, load_integral);
                let radius = top * singular.abs().powf(degree.recip());
                // A panel of 2.15 times this, 0.86 of the way there, has its singularity at ρ = 2.19: ρ^(−48) is 5e-17.
                let on_axis = (top - radius) * T::constant(0.4);
                Some(if singular < T::zero() { off_axis(radius, degree) } else { on_axis })
            }
            Course::Smooth(_) => {
                let profile = self.contact.profile();
                let degree = degree_of_load_integral(profile, top, profile.quick_load_integral(top));
                Some(off_axis(top, degree) * half)
            }
            Course::Linear(_) | Course::Step { .. } => None,
        }
    }
}
