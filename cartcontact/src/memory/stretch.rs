//! One stretch of history without a knot inside, and how long ago the edge passed a radius in it.

use super::quadrature::Eight;
use super::{Increment, radius_form, time_form};
use crate::contact::Contact;
use crate::evaluate::binary::estimated_root_of_product;
use crate::evaluate::exponential::exponentials;
use crate::load::Load;
use crate::{GapProfile, Scalar};

/// The radii from `low` to `high` that the edge passed while the load took a course.
pub(super) struct Stretch<'a, T, P, L> {
    pub(super) contact: &'a Contact<T, P, L>,
    pub(super) course: Course<'a, T, L>,
    pub(super) low: T,
    /// The contact radius at the end of the stretch.
    pub(super) high: T,
    /// What the hereditary load at the end exceeds that of the radius `high`, which is rounded.
    pub(super) surplus: T,
}

/// How the hereditary load Y = F + χ ∫F rose during a stretch.
pub(super) enum Course<'a, T, L> {
    /// At once, at the end.
    Step,
    /// Along a straight load: Y′ at the end, F′, and the duration.
    Linear { rate: T, load_rate: T, duration: T },
    /// Along any other load.
    Smooth { load: &'a L, start: T, duration: T },
}

impl<'a, T: Scalar, L: Load<T>> Course<'a, T, L> {
    /// A straight load between two forces.
    pub(super) fn straight(chi: T, duration: T, (first, last): (T, T)) -> Self {
        let load_rate = (last - first) / duration;
        // A load that falls as fast as it may has Y′ = 0, which rounding can make negative.
        Self::Linear { rate: (load_rate + chi * last).max(T::zero()), load_rate, duration }
    }

    pub(super) fn decay(&self, chi: T) -> T {
        match self {
            Self::Step => T::one(),
            Self::Linear { duration, .. } | Self::Smooth { duration, .. } => (-(chi * *duration)).exp(),
        }
    }

    /// How long before the end Y was smaller than at the end by `deficit`.
    pub(super) fn age(&self, chi: T, deficit: T) -> T {
        match *self {
            Self::Step => T::zero(),
            Self::Linear { rate, load_rate, .. } if load_rate.is_zero() => deficit / rate,
            Self::Linear { rate, load_rate, .. } => age_along_line(rate, chi * load_rate, deficit),
            Self::Smooth { load, start, duration } => {
                let end = start + duration;
                let hereditary = |time: T| load.force(time) + chi * load.impulse(time);
                let final_value = load.force_before(end) + chi * load.impulse(end);
                first_crossing(duration, deficit, |z| final_value - hereditary(end - z))
            }
        }
    }
}

/// The z in [0, `longest`] at which the increasing `deficit_of` reaches `deficit`.
///
/// Regula falsi with the Illinois rule: the bracket holds the root throughout, and an end that stays put has
/// its value halved, so that both ends move. It ends when the bracket is as narrow as rounding allows, and
/// after 60 evaluations at the latest, with the bracket's end if the values are too rough to decide.
fn first_crossing<T: Scalar>(longest: T, deficit: T, deficit_of: impl Fn(T) -> T) -> T {
    let half = T::constant(0.5);
    let (mut low, mut low_value) = (T::zero(), -deficit);
    let (mut high, mut high_value) = (longest, deficit_of(longest) - deficit);
    if high_value <= T::zero() {
        return longest;
    }
    for _ in 0..60 {
        let z = low + (high - low) * (low_value / (low_value - high_value));
        let value = deficit_of(z) - deficit;
        if value < T::zero() {
            (low, low_value, high_value) = (z, value, high_value * half);
        } else {
            (high, high_value, low_value) = (z, value, low_value * half);
        }
        if value.is_zero() || high - low <= T::default_epsilon() * high {
            break;
        }
    }
    high
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// What the stretch adds to the pressure.
    ///
    /// A falling load can make τ(s) steep like a square root, so it is integrated over time; all others over
    /// the radius, which needs no inversion of J.
    pub(super) fn increment(&self) -> Increment<T> {
        // Rounding can put the radii in the wrong order.
        if self.low >= self.high {
            return Increment::zero();
        }
        match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate < T::zero() => {
                time_form::increment(self, rate, load_rate)
            }
            _ => radius_form::increment(self),
        }
    }

    /// How long before the end the edge passed the radius `high` − `depth`.
    pub(super) fn age_at(&self, depth: T) -> T {
        self.course.age(self.contact.medium().chi(), self.deficit(depth))
    }

    /// δ₀′ e^(−χ age) at the radius `high` − `depth`.
    pub(super) fn density(&self, depth: T) -> T {
        let fading = (-(self.contact.medium().chi() * self.age_at(depth))).exp();
        self.contact.profile().approach_slope(self.high - depth) * fading
    }

    /// δ₀′ e^(−χ age) at the radii `high` less eight depths, times their weights.
    #[inline(always)]
    pub(super) fn weighted_densities(&self, depths: Eight<T>, weights: Eight<T>) -> Eight<T> {
        let (profile, chi) = (self.contact.profile(), self.contact.medium().chi());
        let mut folds = depths;
        for fold in &mut folds {
            *fold = self.deficit(*fold);
        }
        // The course is looked at once, not at every depth.
        match self.course {
            Course::Step => folds = [T::zero(); 8],
            Course::Linear { rate, load_rate, .. } if load_rate.is_zero() => {
                let per_deficit = chi / rate;
                for fold in &mut folds {
                    *fold *= -per_deficit;
                }
            }
            Course::Linear { rate, load_rate, .. } => {
                let bend = chi * load_rate;
                for fold in &mut folds {
                    *fold = -(chi * age_along_line(rate, bend, *fold));
                }
            }
            Course::Smooth { .. } => {
                for fold in &mut folds {
                    *fold = -(chi * self.course.age(chi, *fold));
                }
            }
        }
        let mut densities = exponentials(folds);
        for ((density, weight), depth) in densities.iter_mut().zip(weights).zip(depths) {
            *density *= weight * profile.approach_slope(self.high - depth);
        }
        densities
    }

    /// By how much the hereditary load fell short of its end when the edge passed the radius `high` − `depth`.
    #[inline(always)]
    fn deficit(&self, depth: T) -> T {
        self.contact.stiffness() * self.contact.profile().load_integral_drop(self.high, depth) + self.surplus
    }

    /// s u′ at the radius s = `high` − `depth`, with u = χ age: K for a power K s^p/p.
    ///
    /// u′ = χ (π m/4) J′/Y′ where Y′ is known, with J′ = s⁴ δ₀′/2; else a difference over 1/64 of what is left.
    pub(super) fn relative_slope(&self, depth: T, age: T) -> T {
        let (profile, chi) = (self.contact.profile(), self.contact.medium().chi());
        let top = self.high - depth;
        match self.course {
            Course::Step => T::zero(),
            Course::Linear { rate, load_rate, .. } => {
                let square = top * top;
                let slope = profile.approach_slope(top) * top * square * square;
                chi * self.contact.stiffness() * slope * T::constant(0.5) / (rate - chi * load_rate * age)
            }
            Course::Smooth { .. } => {
                let step = (top - self.low) * T::constant(1.0 / 64.0);
                chi * (self.age_at(depth + step) - age) * (top / step)
            }
        }
    }

    /// How far around the radii below a depth, in the plane of complex radii, the age has no singularity.
    ///
    /// Along a straight rising load it is the branch point of the square root, Y′ = 0, which the load would have
    /// to have come from: J falls short of its value at the edge by Y′²/(2 χ F′). J is nearly a power a^p, with
    /// p = a J′/J at the depth; where it would have to be negative, |J|^(1/p) e^(iπ/p) is the nearest root, and
    /// sin(π/p) > 2.8/p for p ≥ 4. Of any other load nothing is known; it is taken to have half that distance.
    ///
    /// A branch point on the axis lies below the stretch; an ellipse as high as 0.38 of the way to it leaves it
    /// outside, if it is around the first half of the way.
    pub(super) fn clearance(&self, depth: T) -> T {
        let rising = match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate > T::zero() => Some((rate, load_rate)),
            Course::Smooth { .. } => None,
            Course::Linear { .. } | Course::Step => return T::infinity(),
        };
        let half = T::constant(0.5);
        let profile = self.contact.profile();
        let top = self.high - depth;
        let load_integral = profile.load_integral(top);
        let square = top * top;
        let degree = square * square * top * profile.approach_slope(top) * half / load_integral;
        let off_axis = |radius: T| radius * T::constant(2.8) / degree;
        let Some((rate, load_rate)) = rising else { return off_axis(top) * half };
        let deficit = rate * rate * half / (self.contact.medium().chi() * load_rate);
        let singular = profile.load_integral(self.high) - deficit / self.contact.stiffness();
        // x^(1/p) ≤ 1 − (1 − x)/p by Bernoulli's inequality, which is close where x is near 1; elsewhere its
        // estimate within 2 % is good enough.
        let share = singular.abs() / load_integral;
        let estimate = estimated_root_of_product(share, T::one(), degree);
        let (one, margin) = (T::one(), T::constant(1.02));
        let largest = top * (one - (one - share) / degree).min(estimate * margin);
        if singular < T::zero() {
            off_axis(top * estimate / margin).max(top - largest)
        } else {
            (top - largest).max(top - self.low) * T::constant(0.38)
        }
    }
}

/// How long ago a straight load, with Y′ = `rate` and χ F′ = `bend` now, had a Y smaller by `deficit`.
///
/// Y(end) − Y(end − z) = Y′ z − χ F′ z²/2, whose root is taken in the form without cancellation; its square
/// root is Y′ at the time found.
fn age_along_line<T: Scalar>(rate: T, bend: T, deficit: T) -> T {
    let two = T::constant(2.0);
    // The size of the radicand: a deficit that rounding makes negative must not, where Y′ vanishes at the end,
    // count as a long time after it.
    let then = (rate * rate - two * bend * deficit).abs().sqrt();
    if (rate + then).is_zero() { T::zero() } else { two * deficit / (rate + then) }
}
