//! The contact radius at a time, and why there may be none.
//!
//! | method | from | the edge |
//! |---|---|---|
//! | `radius_at` | a time | is looked at |
//! | `radius_if_advancing` | a time, and when the edge recedes | is looked at from then on |
//! | `advancing_radius_at` | a time | is known to advance |
//!
//! All three first try `common_radius_at`, which checks that numbers are of common size, and then `checked_radius_under`,
//! which looks for faults one by one. `radius_under_loading`, `radius_under_hereditary` and `radius_of_integral` check
//! nothing but the range of the geometry.

use super::common_sizes::CommonSizes;
use super::loading::Loading;
use super::{Contact, ContactError};
use crate::Scalar;
use crate::load::{Load, LoadError, impulse_tolerance};
use crate::memory::share_that_counts;
use crate::profile::{GapProfile, RadiusError};
use crate::scalar::{is_finite_and_not_negative, is_normal_and_positive, smallest_normal};

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    #[inline]
    pub(crate) fn radius_at(&self, t: T) -> Result<T, ContactError> {
        let is_advancing = || self.load.recession(self.medium.chi(), t).is_none();
        self.common_radius_at(t, is_advancing).map_or_else(|| self.checked_radius_at(t), Ok)
    }

    /// [`radius_at`](Self::radius_at) where the caller knows that the edge does not recede up to `t`.
    pub(crate) fn advancing_radius_at(&self, t: T) -> Result<T, ContactError> {
        let checked_radius = || self.checked_radius_under(self.valid_loading(t)?, t);
        self.common_radius_at(t, || true).map_or_else(checked_radius, Ok)
    }

    /// [`radius_at`](Self::radius_at) where the caller knows from when on the edge recedes, if it does: `recedes_from`
    /// is the [`recession_within`](super::recession_within) of times up to `t` and later. At that very time it need not
    /// have moved yet.
    pub(crate) fn radius_if_advancing(&self, t: T, recedes_from: Option<T>) -> Result<T, ContactError> {
        match recedes_from {
            Some(since) if t >= since => self.radius_at(t),
            _ => self.advancing_radius_at(t),
        }
    }

    /// The contact radius, if all numbers on the way to it are of common size and the edge never recedes.
    #[inline(always)]
    fn common_radius_at(&self, t: T, is_advancing: impl FnOnce() -> bool) -> Option<T> {
        let sizes = CommonSizes::new();
        // At an invalid time a load need not have a force.
        let time = sizes.time_near(t);
        let loading = self.loading(time);
        let load_integrals = self.scales.load_integrals(loading);
        let is_common =
            (time == t) & sizes.contain_rate(self.medium.chi()) & sizes.contain_load(loading, load_integrals);
        if !is_common || !is_advancing() {
            return None;
        }
        self.radius_of_integral(load_integrals.1).ok().filter(|&radius| sizes.contain(radius))
    }

    /// The contact radius, or the first of its faults.
    #[inline(never)]
    fn checked_radius_at(&self, t: T) -> Result<T, ContactError> {
        let loading = self.valid_loading(t)?;
        let chi = self.medium.chi();
        if let Some(since) = self.load.recession(chi, t) {
            let receding = ContactError::Receding { time: t.value(), since: since.value() };
            return Err(self.load.contradiction(chi, t).map_or(receding, ContactError::Load));
        }
        self.checked_radius_under(loading, t)
    }

    /// The contact radius under the loading at a time, or why there is none.
    #[inline(never)]
    fn checked_radius_under(&self, loading: Loading<T>, t: T) -> Result<T, ContactError> {
        let unrepresentable = ContactError::Unrepresentable { time: t.value(), force: loading.force.value() };
        if !self.has_digits(loading) {
            return Err(unrepresentable);
        }
        let load_integral = self.scales.load_integral(loading);
        let radius = self.radius_of_integral(load_integral).map_err(|error| match error {
            RadiusError::BeyondRange { max_radius, .. } => ContactError::BeyondRange {
                time: t.value(),
                leaves_at: self.time_of_leaving(t).value(),
                max_radius,
            },
            RadiusError::Unrepresentable { .. } => unrepresentable,
            other => ContactError::Radius { time: t.value(), error: other },
        })?;
        if self.keeps_digits(loading.force, radius, load_integral) {
            Ok(radius)
        } else {
            Err(unrepresentable)
        }
    }

    /// Whether a⁴, δ₀′, the curvature of the pressure and the slope that the memory of it adds up are neither subnormal
    /// nor infinite, and a J′ and the slopes that count next to the centre are finite.
    ///
    /// J/a⁵ is δ₀′ up to a factor of 8 to 2056, F/a⁴ is the curvature, and a⁵ δ₀′ is 2 a J′. Once most of a load has
    /// drained, what the rest presses together is a slope of 8 F/(π m a⁴), a small share of δ₀′.
    #[inline(always)]
    pub(super) fn keeps_digits(&self, force: T, radius: T, load_integral: T) -> bool {
        let square = radius * radius;
        let power = square * square;
        let slope = self.profile.quick_approach_slope(radius);
        let has_power = is_normal_and_positive(power);
        // An exponent n below 1 makes a slope (a/s)^(1−n) times as steep.
        let steepest = if self.profile.is_smooth_at_centre() { slope } else { slope / share_that_counts() };
        let has_slope = is_normal_quotient(load_integral / radius, power) & steepest.is_finite();
        let has_increments = (power * slope * radius).is_finite();
        let of_force = force * self.scales.integral_per_load;
        let has_pressure =
            force.is_zero() | (is_normal_quotient(force, power) & is_normal_quotient(of_force, power));
        radius.is_zero() | (has_power & has_slope & has_increments & has_pressure)
    }

    /// The loading at a time, from a load that a user may have got wrong.
    pub(super) fn valid_loading(&self, t: T) -> Result<Loading<T>, ContactError> {
        if !is_finite_and_not_negative(t) {
            return Err(ContactError::InvalidTime { time: t.value() });
        }
        let loading = self.loading(t);
        if !is_finite_and_not_negative(loading.force) {
            let (time, force) = (t.value(), loading.force.value());
            return Err(ContactError::Load(LoadError::InvalidForce { time, force }));
        }
        // Early on a valid impulse, being a difference of nearly equal numbers, may be negative by rounding.
        let is_rounding = || {
            let rounding = impulse_tolerance(loading.hereditary, self.medium.chi());
            loading.impulse.is_finite() && loading.impulse.abs() <= rounding
        };
        if !(is_finite_and_not_negative(loading.impulse) || is_rounding()) {
            let (time, impulse) = (t.value(), loading.impulse.value());
            return Err(ContactError::Load(LoadError::InvalidImpulse { time, impulse }));
        }
        Ok(loading)
    }

    /// Whether there is no load, or one with all its digits.
    pub(super) fn has_digits(&self, loading: Loading<T>) -> bool {
        loading.hereditary.is_zero()
            || loading.has_digits(self.medium.chi(), self.scales.load_integrals(loading))
    }

    /// The last time up to `t` at which the radius is still admissible, or the time of the jump that ends that; by
    /// bisection to the last bit. 0 if it never is.
    fn time_of_leaving(&self, t: T) -> T {
        let radius_at = |time| self.radius_under_loading(self.loading(time));
        let half = T::constant(0.5);
        let (mut inside, mut outside) = (T::zero(), t);
        // Halving towards a zero that is never admissible would only end after all exponents of the format.
        let Ok(mut radius) = radius_at(inside) else {
            return inside;
        };
        loop {
            let middle = inside + (outside - inside) * half;
            if !(inside < middle && middle < outside) {
                break;
            }
            match radius_at(middle) {
                Ok(found) => (inside, radius) = (middle, found),
                Err(_) => outside = middle,
            }
        }
        let reaches_end = radius >= self.max_radius * (T::one() - T::default_epsilon().sqrt());
        if reaches_end { inside } else { outside }
    }

    /// The contact radius under a load.
    #[inline(always)]
    pub(crate) fn radius_under_loading(&self, loading: Loading<T>) -> Result<T, RadiusError> {
        self.radius_of_integral_out_of_line(self.scales.load_integral(loading))
    }

    /// The contact radius under a hereditary load Y.
    pub(crate) fn radius_under_hereditary(&self, hereditary: T) -> Result<T, RadiusError> {
        self.radius_of_integral_out_of_line(hereditary * self.scales.integral_per_load)
    }

    /// The contact radius of a single load integral: out of line, and given the number in a register.
    ///
    /// A [`Loading`] would be passed in memory, with a store-forwarding stall: its numbers are written one by one, but
    /// two of them are then read at once, and a processor waits with that until all earlier work is done, 20 ns of one
    /// pressure.
    #[inline(never)]
    fn radius_of_integral_out_of_line(&self, load_integral: T) -> Result<T, RadiusError> {
        self.radius_of_integral(load_integral)
    }

    /// The contact radius of a load integral.
    #[inline(always)]
    pub(crate) fn radius_of_integral(&self, load_integral: T) -> Result<T, RadiusError> {
        self.profile.radius_within(load_integral, self.max_radius)
    }

    /// The contact radii of many load integrals.
    pub(crate) fn radii_of(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError> {
        self.profile.radii_within(load_integrals, self.max_radius, radii)
    }
}

/// Whether a quotient is neither subnormal nor infinite.
#[inline(always)]
fn is_normal_quotient<T: Scalar>(value: T, unit: T) -> bool {
    // Subnormal products would be slow; infinite ones are not.
    let most = smallest_normal::<T>().recip();
    (unit <= value * most) & (value <= unit * most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{Constant, PiecewiseLinear};
    use crate::{Medium, Polynomial};

    /// Whether the contact of a term (C, n) is refused at a time because a number leaves the format, alone and among many
    /// times; none if there is no contact.
    fn is_refused<T: Scalar>(term: (T, T), (m, chi): (T, T), load: impl Load<T>, t: T) -> Option<[bool; 2]> {
        let gap = Polynomial::new([term]).ok()?;
        let contact = Contact::new(gap, Medium::from_constants(m, chi).ok()?, load).ok()?;
        let errors = [contact.at(t).err(), contact.radii(&[t; 3], &mut [t; 3]).err()];
        Some(errors.map(|error| matches!(error, Some(ContactError::Unrepresentable { .. }))))
    }

    /// Nothing else is out of range.
    #[test]
    fn a_hereditary_load_beyond_the_format_is_refused() {
        let held = |unit: f64| is_refused((0.025, 2.0), (unit, 1e3), Constant(unit), 1e4);
        assert_eq!((held(1e300), held(1e302)), (Some([false; 2]), Some([true; 2])));
        let held = |unit: f32| is_refused((0.025, 2.0), (unit, 1e3), Constant(unit), 1e4);
        assert_eq!((held(1e30), held(1e32)), (Some([false; 2]), Some([true; 2])));
    }

    /// So are force, rate, time, load integral and radius.
    #[test]
    fn a_hereditary_load_beyond_the_format_is_refused_among_common_sizes() {
        let fallen = |since: f32| {
            let fall = (0..=103).map(|k| (since + 0.01 * k as f32, 1e36 * 0.505_f32.powi(k)));
            let knots = core::iter::once((0.0, 1e36)).chain(fall).collect::<Vec<_>>();
            is_refused((0.025, 2.0), (1e33, 100.0), PiecewiseLinear::new(knots).ok()?, since + 1.03)
        };
        assert_eq!((fallen(1.0), fallen(2.0)), (Some([false; 2]), Some([true; 2])));
    }

    /// All numbers are in the format but a² P(0, 0), which is nearly 4 F/π where the exponent is small.
    #[test]
    fn loads_next_to_the_end_of_the_format_are_refused() {
        let held = |force: f32| is_refused((2.5e17, 1.4e-3), (50.0, 1.4e-4), Constant(force), 0.0);
        assert_eq!((held(1.6e38), held(3.3e38)), (Some([false; 2]), Some([true; 2])));
    }

    /// Force, load integral and radius are normal numbers, and so are F/a⁴ and δ₀′, but 8 F/(π m a⁴), which the memory
    /// adds up, is not: in `f64` the pressure of the first would be off by 24 ε.
    #[test]
    fn slopes_of_what_is_left_below_the_normal_numbers_are_refused() {
        fn of_drained<T: Scalar>(of_force: f64, radius: f64, folds: f64) -> Option<[bool; 2]> {
            let (n, m) = (0.01, 1e10 * 4.0 * core::f64::consts::FRAC_1_PI);
            let c = of_force * folds * radius.powf(-n - 4.0) * ((n + 2.0) * (n + 4.0) / n);
            let [c, n, m, force, t] = [c, n, m, 1e10 * of_force, folds].map(T::constant);
            is_refused((c, n), (m, T::one()), Constant(force), t)
        }
        let expected = [Some([true; 2]), Some([false; 2])];
        assert_eq!([of_drained::<f64>(1e-290, 1e5, 1e10), of_drained::<f64>(1e-287, 1e5, 1e10)], expected);
        assert_eq!([of_drained::<f32>(1e-30, 1e3, 1e8), of_drained::<f32>(1e-25, 1e3, 1e8)], expected);
    }

    /// Force, rate, time, load integral and radius are within six decades of 1, or fifty, but √(8/ε) δ₀′ is not in the
    /// format: a pressure on the axis would not be a number.
    #[test]
    fn slopes_beyond_the_format_are_refused_among_common_sizes() {
        fn of_steep_gap<T: Scalar>(load_integral: f64, radius: f64) -> Option<[bool; 2]> {
            let (n, m) = (0.1, 4.0 * core::f64::consts::FRAC_1_PI);
            let c = load_integral * radius.powf(-n - 4.0) * ((n + 2.0) * (n + 4.0) / n);
            let [c, n, m, chi, force] = [c, n, m, 1.0, load_integral].map(T::constant);
            is_refused((c, n), (m, chi), Constant(force), T::zero())
        }
        let expected = [Some([true; 2]), Some([false; 2])];
        assert_eq!([of_steep_gap::<f32>(9e5, 1.1e-6), of_steep_gap::<f32>(9e4, 1.1e-5)], expected);
        assert_eq!([of_steep_gap::<f64>(9e49, 1.1e-50), of_steep_gap::<f64>(9e48, 1.1e-49)], expected);
    }
}
