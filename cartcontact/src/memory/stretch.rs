//! One stretch of history without a knot inside, and how long ago the edge passed a radius in it.

use super::{Increment, radius_form, time_form};
use crate::contact::Contact;
use crate::evaluate::binary::{scale, split};
use crate::evaluate::exponential::decay;
use crate::load::{ForceSeries, Load};
use crate::scalar::smallest_normal;
use crate::{GapProfile, Scalar};

/// The radii from `low` to `high` that the edge passed while the load took a course.
pub(super) struct Stretch<'a, T, P, L> {
    pub(super) contact: &'a Contact<T, P, L>,
    pub(super) course: Course<'a, T>,
    pub(super) low: T,
    /// The contact radius at the end of the stretch.
    pub(super) high: T,
    /// What the hereditary load at the end exceeds that of the radius `high`, which is rounded.
    pub(super) surplus: T,
    /// Whether all that the course lays counts, and not only what it does from `low` on.
    pub(super) is_whole: bool,
}

/// How the hereditary load Y = F + χ ∫F rose during a stretch.
pub(super) enum Course<'a, T> {
    /// At once, at the end.
    Step,
    /// Along a straight load: Y′ at the end, F′, and the duration.
    Linear { rate: T, load_rate: T, duration: T },
    /// Along any other load.
    Smooth(&'a ForceSeries<T>),
}

impl<'a, T: Scalar> Course<'a, T> {
    /// A straight load between two forces; a rise during which nothing drains is a step, whose rate need not be in range.
    pub(super) fn straight(chi: T, duration: T, (first, last): (T, T)) -> Self {
        if last > first && is_instant(chi * duration) {
            return Self::Step;
        }
        let load_rate = (last - first) / duration;
        // A load that falls as fast as it may has Y′ = 0, which rounding can make negative.
        Self::Linear { rate: (load_rate + chi * last).max(T::zero()), load_rate, duration }
    }

    /// A load of any other kind.
    pub(super) fn smooth(force: &'a ForceSeries<T>) -> Self {
        if is_instant(force.folds()) { Self::Step } else { Self::Smooth(force) }
    }

    /// χ times the duration.
    pub(super) fn folds(&self, chi: T) -> T {
        match self {
            Self::Step => T::zero(),
            Self::Linear { duration, .. } => chi * *duration,
            Self::Smooth(force) => force.folds(),
        }
    }

    /// Whether the load, if it lasts, was held, so that ages grow as deficits do.
    pub(super) fn is_held(&self) -> bool {
        match self {
            Self::Step => true,
            Self::Linear { load_rate, .. } => load_rate.is_zero(),
            Self::Smooth(_) => false,
        }
    }

    /// How long before the end Y was smaller than at the end by `deficit`.
    #[inline(always)]
    pub(super) fn age(&self, chi: T, deficit: T) -> T {
        match *self {
            Self::Step => T::zero(),
            Self::Linear { rate, load_rate, .. } => age_along_line(rate, (chi, load_rate), deficit),
            Self::Smooth(force) => force.age(deficit),
        }
    }
}

/// How long before the end of a straight load, where Y grows at `rate`, Y was smaller than at the end by `deficit`.
#[inline]
pub(crate) fn age_along_line<T: Scalar>(rate: T, (chi, load_rate): (T, T), deficit: T) -> T {
    if load_rate.is_zero() {
        return deficit / rate;
    }
    if has_root_along_line(rate, (chi, load_rate), deficit) {
        root_along_line(rate, (chi, load_rate), deficit)
    } else {
        age_in_units(rate, (chi, load_rate), deficit)
    }
}

/// The age of a deficit along a straight load, if it [has one](has_root_along_line) by this formula.
///
/// Y(end) − Y(end − z) = Y′ z − χ F′ z²/2, whose root is taken in the form without cancellation; its square root is
/// Y′ at the time found.
#[inline(always)]
fn root_along_line<T: Scalar>(rate: T, (chi, load_rate): (T, T), deficit: T) -> T {
    let two = T::constant(2.0);
    let (straight, bend) = (rate * rate, two * chi * load_rate * deficit);
    // The size of the radicand: a deficit that rounding makes negative must not, where Y′ vanishes at the end,
    // count as a long time after it.
    two * deficit / (rate + (straight - bend).abs().sqrt())
}

/// Whether the squares of rates are in range.
#[inline(always)]
fn has_root_along_line<T: Scalar>(rate: T, (chi, load_rate): (T, T), deficit: T) -> bool {
    let size = rate * rate + (T::constant(2.0) * chi * load_rate * deficit).abs();
    size.is_finite() & (size * T::default_epsilon() > smallest_normal())
}

/// The age of a deficit along a straight load whose squares of rates are out of range: the same root, with all rates
/// in units of a power of two near the largest, so that not a bit depends on the units of the load.
fn age_in_units<T: Scalar>(rate: T, (chi, load_rate): (T, T), deficit: T) -> T {
    let two = T::constant(2.0);
    let curved = chi.sqrt() * load_rate.abs().sqrt() * deficit.abs().sqrt();
    let largest = rate.max(curved);
    if largest.is_zero() {
        return T::zero();
    }
    let (_, exponent) = split(largest);
    let [rate, load_rate, deficit] = [rate, load_rate, deficit].map(|x| scale(x, -exponent));
    let then = (rate * rate - two * chi * load_rate * deficit).abs().sqrt();
    two * deficit / (rate + then)
}

/// Whether nothing drains in so few e-foldings.
fn is_instant<T: Scalar>(folds: T) -> bool {
    folds <= T::default_epsilon() * T::constant(0.125)
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// What the stretch adds to the pressure, and whether it is integrated over time, up to the exact radius at its end.
    ///
    /// A falling load can make τ(s) steep like a square root, and so can one that is not straight, where the edge nearly
    /// stands still; all others are integrated over the radius, which needs no inversion of J.
    pub(super) fn increment(&self) -> (Increment<T>, bool) {
        // Rounding can put the radii in the wrong order.
        if self.low >= self.high {
            return (Increment::zero(), false);
        }
        let over_time = match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate < T::zero() => {
                let chi = self.contact.medium().chi();
                let (rate, rise) = (rate / chi, -load_rate / chi);
                let half = T::constant(0.5);
                time_form::increment(
                    self,
                    (rate, rise),
                    #[inline(always)]
                    |x| (x * (rate + half * rise * x), rate + rise * x),
                )
            }
            Course::Smooth(force) if self.begins_covered() => {
                time_form::increment(self, (force.highest_rate(), T::zero()), |x| force.shortfall(x))
            }
            _ => return (radius_form::increment(self), false),
        };
        (over_time, true)
    }

    /// Whether the hereditary load is well above zero throughout.
    fn begins_covered(&self) -> bool {
        let profile = self.contact.profile();
        let sixteenth = T::constant(1.0 / 16.0);
        profile.quick_load_integral(self.low) >= profile.quick_load_integral(self.high) * sixteenth
    }

    /// How long before the end the edge passed the radius `high` − `depth`.
    #[inline]
    pub(super) fn age_at(&self, depth: T) -> T {
        let drop = self.contact.profile().load_integral_drop(self.high, depth);
        self.course.age(self.contact.medium().chi(), self.deficit(drop))
    }

    /// By how much the hereditary load at the end exceeds that of a radius whose J is less by a drop.
    #[inline(always)]
    fn deficit(&self, drop: T) -> T {
        self.contact.load_per_integral() * drop + self.surplus
    }

    /// Leaves of weights, laid at radii whose J is less by some drops, what is left at the end: e^(−χ age) of each.
    #[inline(always)]
    pub(super) fn fade(&self, weights: &mut [T], drops: &[T]) {
        let chi = self.contact.medium().chi();
        // Where a formula gives all ages, vectors take them.
        match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate.is_zero() => self.fade_by(
                #[inline(always)]
                |deficit| deficit / rate,
                (weights, drops),
            ),
            Course::Linear { rate, load_rate, .. } if self.has_roots(rate, (chi, load_rate), drops) => self
                .fade_by(
                    #[inline(always)]
                    |deficit| root_along_line(rate, (chi, load_rate), deficit),
                    (weights, drops),
                ),
            _ => self.fade_by(|deficit| self.course.age(chi, deficit), (weights, drops)),
        }
    }

    /// [`fade`](Self::fade) with ages of deficits by a function.
    #[inline(always)]
    fn fade_by(&self, age: impl Fn(T) -> T, (weights, drops): (&mut [T], &[T])) {
        let chi = self.contact.medium().chi();
        for (weight, &drop) in weights.iter_mut().zip(drops) {
            *weight *= decay(chi * age(self.deficit(drop)));
        }
    }

    /// Whether all drops have an age by [`root_along_line`].
    #[inline(always)]
    fn has_roots(&self, rate: T, (chi, load_rate): (T, T), drops: &[T]) -> bool {
        drops.iter().fold(
            true,
            #[inline(always)]
            |all, &drop| all & has_root_along_line(rate, (chi, load_rate), self.deficit(drop)),
        )
    }

    /// How near, in the plane of complex radii, the age of a radius below `top` has a singularity.
    ///
    /// Along a straight rising load it is the branch point of the square root, Y′ = 0, which the load would have
    /// to have come from: J falls short of its value at the edge by Y′²/(2 χ F′). J is nearly a power a^p, with
    /// p = a J′/J at `top`; where it would have to be negative, |J|^(1/p) e^(iπ/p) is the nearest root, and
    /// sin(π/p) > 2.8/p for p ≥ 4. Of any other load nothing is known; it is taken to have half that distance.
    pub(super) fn singularity(&self, top: T) -> Option<T> {
        let half = T::constant(0.5);
        let off_axis = |radius: T, degree: T| radius * T::constant(2.8) / degree;
        match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate > T::zero() => {
                let (profile, chi) = (self.contact.profile(), self.contact.medium().chi());
                let load_integral = profile.quick_load_integral(top);
                let deficit = (rate / load_rate) * (rate / chi) * half;
                // In shares of J at `top`: the deficit is a force, and over π m/4 it may be out of range.
                let share_of_deficit = deficit / (self.contact.load_per_integral() * load_integral);
                let singular = profile.quick_load_integral(self.high) / load_integral - share_of_deficit;
                let degree = self.degree(top, load_integral);
                let radius = top * singular.abs().powf(degree.recip());
                let on_axis = (top - radius) * T::constant(0.4);
                Some(if singular < T::zero() { off_axis(radius, degree) } else { on_axis })
            }
            Course::Smooth(_) => {
                let degree = self.degree(top, self.contact.profile().quick_load_integral(top));
                Some(off_axis(top, degree) * half)
            }
            Course::Linear { .. } | Course::Step => None,
        }
    }

    /// a J′/J = a⁵ δ₀′/(2 J), in an order that keeps the fifth power in range.
    fn degree(&self, a: T, load_integral: T) -> T {
        let square = a * a;
        let slope = self.contact.profile().quick_approach_slope(a);
        (a * slope * T::constant(0.5)) * (square / (load_integral / square))
    }
}
