//! One stretch of history without a knot inside, and how long ago the edge passed a radius in it.

use super::{Increment, radius_form, time_form};
use crate::contact::Contact;
use crate::evaluate::binary::{scale, split};
use crate::load::Load;
use crate::scalar::smallest_normal;
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
    /// A straight load between two forces; a rise during which nothing drains is a step, whose rate need not be in range.
    pub(super) fn straight(chi: T, duration: T, (first, last): (T, T)) -> Self {
        if last > first && chi * duration <= T::default_epsilon() * T::constant(0.125) {
            return Self::Step;
        }
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

    /// 1 − decay, to full accuracy.
    pub(super) fn fading(&self, chi: T) -> T {
        match self {
            Self::Step => T::zero(),
            Self::Linear { duration, .. } | Self::Smooth { duration, .. } => -(-(chi * *duration)).exp_m1(),
        }
    }

    /// How long before the end Y was smaller than at the end by `deficit`.
    #[inline(always)]
    pub(super) fn age(&self, chi: T, deficit: T) -> T {
        match *self {
            Self::Step => T::zero(),
            Self::Linear { rate, load_rate, .. } => age_along_line(rate, (chi, load_rate), deficit),
            Self::Smooth { load, start, duration } => age_along_curve(load, chi, (start, duration), deficit),
        }
    }
}

/// How long before the end of a straight load, where Y grows at `rate`, Y was smaller than at the end by `deficit`.
///
/// Y(end) − Y(end − z) = Y′ z − χ F′ z²/2, whose root is taken in the form without cancellation; its square root is
/// Y′ at the time found.
#[inline]
pub(crate) fn age_along_line<T: Scalar>(rate: T, (chi, load_rate): (T, T), deficit: T) -> T {
    if load_rate.is_zero() {
        return deficit / rate;
    }
    let two = T::constant(2.0);
    // The size of the radicand: a deficit that rounding makes negative must not, where Y′ vanishes at the end,
    // count as a long time after it.
    let (straight, bend) = (rate * rate, two * chi * load_rate * deficit);
    let size = straight + bend.abs();
    if !(size.is_finite() && size * T::default_epsilon() > smallest_normal()) {
        return age_in_units(rate, (chi, load_rate), deficit);
    }
    two * deficit / (rate + (straight - bend).abs().sqrt())
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

/// How long before the end of a stretch of any load, from its start on, Y was smaller than at the end by `deficit`.
#[inline(never)]
fn age_along_curve<T: Scalar, L: Load<T>>(load: &L, chi: T, (start, duration): (T, T), deficit: T) -> T {
    let end = start + duration;
    let hereditary = |time: T| load.force(time) + chi * load.impulse(time);
    let final_value = load.force_before(end) + chi * load.impulse(end);
    first_crossing(duration, deficit, |z| final_value - hereditary(end - z))
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
    #[inline]
    pub(super) fn age_at(&self, depth: T) -> T {
        let deficit = self.contact.profile().load_integral_drop(self.high, depth);
        self.course.age(self.contact.medium().chi(), self.contact.stiffness() * deficit + self.surplus)
    }

    /// δ₀′ and e^(−χ age) at the radius s = `high` − `depth`, of which one is rounded: near the edge s, near the centre
    /// the depth.
    #[inline(always)]
    pub(super) fn slope_and_fading(&self, s: T, depth: T) -> (T, T) {
        let fading = (-(self.contact.medium().chi() * self.age_at(depth))).exp();
        (self.contact.profile().approach_slope(s), fading)
    }

    /// How near, in the plane of complex radii, the age of a radius below `top` has a singularity.
    ///
    /// Along a straight rising load it is the branch point of the square root, Y′ = 0, which the load would have
    /// to have come from: J falls short of its value at the edge by Y′²/(2 χ F′). J is nearly a power a^p, with
    /// p = a J′/J at `top`; where it would have to be negative, |J|^(1/p) e^(iπ/p) is the nearest root, and
    /// sin(π/p) > 2.8/p for p ≥ 4. Of any other load nothing is known; it is taken to have half that distance.
    pub(super) fn singularity(&self, top: T) -> Option<T> {
        let half = T::constant(0.5);
        let profile = self.contact.profile();
        let load_integral = profile.quick_load_integral(top);
        // a J′/J = a⁵ δ₀′/(2 J), in an order that keeps the fifth power in range.
        let square = top * top;
        let degree = (top * profile.approach_slope(top) * half) * (square / (load_integral / square));
        let off_axis = |radius: T| radius * T::constant(2.8) / degree;
        match self.course {
            Course::Linear { rate, load_rate, .. } if load_rate > T::zero() => {
                let chi = self.contact.medium().chi();
                let deficit = (rate / load_rate) * (rate / chi) * half;
                // In shares of J at `top`: the deficit is a force, and over π m/4 it may be out of range.
                let share_of_deficit = deficit / (self.contact.stiffness() * load_integral);
                let singular = profile.quick_load_integral(self.high) / load_integral - share_of_deficit;
                let radius = top * singular.abs().powf(degree.recip());
                let on_axis = (top - radius) * T::constant(0.4);
                Some(if singular < T::zero() { off_axis(radius) } else { on_axis })
            }
            Course::Smooth { .. } => Some(off_axis(top) * half),
            Course::Linear { .. } | Course::Step => None,
        }
    }
}
