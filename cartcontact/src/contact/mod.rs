//! A contact: a geometry, a medium and a load.

mod common;
mod error;
mod radii;

use core::fmt;

use common::CommonSizes;
pub use error::ContactError;

use crate::load::{Load, LoadError, is_force};
use crate::medium::Medium;
use crate::memory::{Moment, surplus_that_counts};
use crate::profile::{GapProfile, RadiusError};
use crate::scalar::smallest_normal;
use crate::snapshot::Snapshot;
use crate::{Scalar, field};

/// A load at a time: F, ∫F and Y = F + χ ∫F.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loading<T> {
    pub(crate) force: T,
    pub(crate) impulse: T,
    pub(crate) hereditary: T,
}

impl<T: Scalar> Loading<T> {
    /// From a force and an impulse.
    #[inline(always)]
    pub(crate) fn new(force: T, impulse: T, chi: T) -> Self {
        Self { force, impulse, hereditary: force + chi * impulse }
    }

    /// Whether the load has all its digits: as it is, over π m/4, times χ and times t.
    #[inline(always)]
    fn has_digits(&self, chi: T, load_integral: T) -> bool {
        let (force, least) = (self.force, smallest_normal());
        let drained = chi * force;
        let has_drained = chi.is_zero() | ((drained >= least) & (drained + drained).is_finite());
        let has_force = force.is_zero() | ((force >= least) & has_drained);
        // Of an impulse only what is not rounding beside the force has to be right.
        let has_impulse = (chi <= force * least.recip()) | (self.impulse >= least);
        has_force & has_impulse & (load_integral >= least)
    }
}

/// The contact of two cartilage layers: the solution for a geometry, a medium and a load.
///
/// # Examples
///
/// ```
/// use cartcontact::{Contact, Layer, Medium, gap_profile, load};
///
/// #[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
/// struct Patellofemoral;
///
/// let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
/// let contact = Contact::new(Patellofemoral, Medium::between(layer, layer)?, load::Constant(100.0))?;
/// let now = contact.at(200.0)?;
/// assert!((now.radius() - 7.447_f64).abs() < 5e-4);
/// assert!((now.peak_pressure() - 1.666_f64).abs() < 5e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
///
/// I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.
#[derive(Clone, Copy)]
pub struct Contact<T, P, L> {
    profile: P,
    medium: Medium<T>,
    load: L,
    max_radius: T,
    /// A multiplication takes a third of the time of a division.
    per_stiffness: T,
}

// Not derived, because geometries are mostly unit structs without `Debug`.
impl<T: fmt::Debug, P, L> fmt::Debug for Contact<T, P, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contact").field("medium", &self.medium).finish_non_exhaustive()
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    /// Brings together a geometry, a medium and a load; nothing is solved yet.
    ///
    /// # Errors
    ///
    /// [`ContactError`] if the values of the geometry's parameters or of the load are not usable.
    pub fn new(profile: P, medium: Medium<T>, load: L) -> Result<Self, ContactError> {
        profile.check()?;
        load.check()?;
        let max_radius = profile.max_radius();
        let per_stiffness = stiffness(&medium).recip();
        Ok(Self { profile, medium, load, max_radius, per_stiffness })
    }

    /// The geometry.
    pub fn profile(&self) -> &P {
        &self.profile
    }

    /// The medium.
    pub fn medium(&self) -> &Medium<T> {
        &self.medium
    }

    /// The load.
    pub fn load(&self) -> &L {
        &self.load
    }

    /// The state of the contact at time `t`, in s. The radius is solved here, the rest when it is asked for.
    ///
    /// # Formula
    ///
    /// ```text
    /// (π m/4) J(a) = Y(t) = F(t) + χ ∫₀ᵗ F dτ
    /// ```
    ///
    /// # Accuracy
    ///
    /// The radius is within 2 ε for sums of positive terms. Where terms of both signs cancel, that is multiplied by
    /// Σ|terms of J|/(a J′).
    ///
    /// This holds over the whole range of the format: as long as the input, 2 χ F, ∫F, Y, J(a), a J′(a), J(a)/a⁵, a⁴,
    /// F/a⁴ and the result are normal numbers, powers and products on the way to them need not be.
    ///
    /// # Errors
    ///
    /// [`ContactError`] if `t` is negative or not finite, the contact has left the admissible range of the
    /// geometry, the load has fallen so fast that the edge recedes or its impulse is not that of its force, or
    /// these numbers leave the range of the format.
    ///
    /// # References
    ///
    /// Eq. (14), doi 10.1016/j.mechrescom.2010.11.006.
    #[inline]
    pub fn at(&self, t: T) -> Result<Snapshot<'_, T, P, L>, ContactError> {
        Ok(Snapshot::new(self, t, self.radius_at(t)?))
    }

    /// The contact radii at many times, in mm; `radii[i]` belongs to `times[i]`, in any order.
    ///
    /// # Errors
    ///
    /// [`ContactError`] if the slices are empty or differ in length, and for every time as [`at`](Self::at).
    pub fn radii(&self, times: &[T], radii: &mut [T]) -> Result<(), ContactError> {
        if times.is_empty() {
            return Err(ContactError::Empty { what: "times" });
        }
        check_length("radii", radii.len(), times.len())?;
        radii::fill(self, times, radii)
    }

    /// The pressures at many times and radii, in MPa.
    ///
    /// `values` is row-major, times × radii: `values[i * radii.len() + j]` belongs to `times[i]` and
    /// `radii[j]`. Times are in ascending order, equal ones allowed; radii may come in any order, and
    /// ascending ones are quickest. The quadratures number as many as times and radii together, not as many
    /// as values.
    ///
    /// # Accuracy
    ///
    /// That of [`Snapshot::pressure`].
    ///
    /// # Errors
    ///
    /// [`ContactError`] if a slice is empty, `values` has another length than times × radii, times descend,
    /// a radius is negative or not finite, and for every time as [`at`](Self::at).
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let mut values = [0.0; 6];
    /// contact.pressure_field(&[0.0, 200.0], &[0.0, 3.0, 7.5], &mut values)?;
    /// assert_eq!(values[2], 0.0); // not yet covered
    /// assert_eq!(values[5], contact.at(200.0)?.pressure(7.5));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure_field(&self, times: &[T], radii: &[T], values: &mut [T]) -> Result<(), ContactError> {
        field::check(times, radii, values)?;
        field::fill(self, times, radii, values)
    }

    /// The hereditary load of a radius is this times its load integral: π m/4.
    pub(crate) fn stiffness(&self) -> T {
        stiffness(&self.medium)
    }

    /// The load integral over its hereditary load.
    pub(crate) fn per_stiffness(&self) -> T {
        self.per_stiffness
    }

    /// The contact radius under a hereditary load Y.
    pub(crate) fn radius_under(&self, hereditary: T) -> Result<T, RadiusError> {
        self.radius_of(hereditary * self.per_stiffness)
    }

    /// The contact radius of a load integral.
    pub(crate) fn radius_of(&self, load_integral: T) -> Result<T, RadiusError> {
        self.profile.radius_within(load_integral, self.max_radius)
    }

    /// The contact radii under many hereditary loads, which are replaced by their load integrals.
    pub(crate) fn radii_under(&self, hereditary: &mut [T], radii: &mut [T]) -> Result<(), RadiusError> {
        for load in hereditary.iter_mut() {
            *load *= self.per_stiffness;
        }
        self.radii_of(hereditary, radii)
    }

    /// The contact radii of many load integrals.
    pub(crate) fn radii_of(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError> {
        self.profile.radii_within(load_integrals, self.max_radius, radii)
    }

    /// A time with its contact radius, for integrals that begin or end there.
    pub(crate) fn moment(&self, time: T, radius: T) -> Moment<T> {
        self.moment_under(self.loading(time), time, radius)
    }

    /// [`moment`](Self::moment) under a loading that the caller knows.
    pub(crate) fn moment_under(&self, loading: Loading<T>, time: T, radius: T) -> Moment<T> {
        self.moment_of(loading, time, radius, self.profile.quick_load_integral(radius))
    }

    /// [`moment`](Self::moment) with a load integral that is rounded once.
    pub(crate) fn precise_moment(&self, time: T, radius: T) -> Moment<T> {
        self.moment_of(self.loading(time), time, radius, self.profile.load_integral(radius))
    }

    fn moment_of(&self, loading: Loading<T>, time: T, radius: T, load_integral: T) -> Moment<T> {
        let surplus = loading.hereditary - self.stiffness() * load_integral;
        let surplus = surplus_that_counts(surplus, loading.force);
        Moment { time, radius, surplus, impulse: loading.impulse.into() }
    }

    #[inline]
    pub(crate) fn radius_at(&self, t: T) -> Result<T, ContactError> {
        self.common_radius_at(t, || !self.recedes_until(t)).map_or_else(|| self.checked_radius_at(t), Ok)
    }

    /// [`radius_at`](Self::radius_at) a time until which the edge does not [recede](Self::recedes_until).
    pub(crate) fn covered_radius_at(&self, t: T) -> Result<T, ContactError> {
        self.common_radius_at(t, || true).map_or_else(|| self.checked_radius_at(t), Ok)
    }

    /// Whether the load falls too fast up to a time.
    #[inline(always)]
    pub(crate) fn recedes_until(&self, t: T) -> bool {
        self.load.recession(self.medium.chi(), t).is_some()
    }

    /// The contact radius, if all numbers on the way to it are of common size and the history is one that the solution
    /// covers.
    #[inline(always)]
    fn common_radius_at(&self, t: T, is_covered: impl FnOnce() -> bool) -> Option<T> {
        let (sizes, chi, loading) = (CommonSizes::new(), self.medium.chi(), self.loading(t));
        let load_integral = loading.hereditary * self.per_stiffness;
        let is_common = sizes.contain_rate(chi) & sizes.contain_load(t, loading, load_integral);
        if !is_common || !is_covered() {
            return None;
        }
        self.radius_of(load_integral).ok().filter(|&radius| sizes.contain(radius))
    }

    /// The contact radius, or the first of its faults.
    #[inline(never)]
    fn checked_radius_at(&self, t: T) -> Result<T, ContactError> {
        let loading = self.loading_at(t)?;
        let load_integral = loading.hereditary * self.per_stiffness;
        let radius = self.radius_of(load_integral).map_err(|error| match error {
            RadiusError::BeyondRange { max_radius, .. } => ContactError::BeyondRange {
                time: t.value(),
                leaves_at: self.time_of_leaving(t).value(),
                max_radius,
            },
            other => ContactError::Radius { time: t.value(), error: other },
        })?;
        if self.keeps_digits(loading.force, radius, load_integral) {
            Ok(radius)
        } else {
            Err(ContactError::OutOfRange { time: t.value(), force: loading.force.value() })
        }
    }

    /// Whether a⁴, δ₀′ and the curvature of the pressure are neither subnormal nor infinite, and a J′ is finite.
    ///
    /// J/a⁵ is δ₀′ but for a factor of 8 to 2056, F/a⁴ is the curvature, and a⁵ δ₀′ is 2 a J′.
    #[inline(always)]
    fn keeps_digits(&self, force: T, radius: T, load_integral: T) -> bool {
        let square = radius * radius;
        let power = square * square;
        let slope = self.profile.quick_approach_slope(radius);
        let has_power = (power >= smallest_normal()) & power.is_finite();
        let has_slope = is_normal(load_integral / radius, power) & slope.is_finite();
        let has_increments = (power * slope * radius).is_finite();
        let has_pressure = force.is_zero() | is_normal(force, power);
        radius.is_zero() | (has_power & has_slope & has_increments & has_pressure)
    }

    /// What is known of the load at a time.
    #[inline(always)]
    pub(crate) fn loading(&self, t: T) -> Loading<T> {
        Loading::new(self.load.force(t), self.load.impulse(t), self.medium.chi())
    }

    /// The loading at a time that the solution covers.
    fn loading_at(&self, t: T) -> Result<Loading<T>, ContactError> {
        let loading = self.valid_loading(t)?;
        let (time, force) = (t.value(), loading.force.value());
        let chi = self.medium.chi();
        if let Some(since) = self.load.recession(chi, t) {
            let receding = ContactError::Receding { time, since: since.value() };
            return Err(self.load.contradiction(chi, t).map_or(receding, ContactError::Load));
        }
        if self.has_digits(loading) { Ok(loading) } else { Err(ContactError::OutOfRange { time, force }) }
    }

    /// The loading at a time, from a load that a user may have got wrong.
    fn valid_loading(&self, t: T) -> Result<Loading<T>, ContactError> {
        let time = t.value();
        if !is_time(t) {
            return Err(ContactError::InvalidTime { time });
        }
        let loading = self.loading(t);
        let (force, impulse) = (loading.force.value(), loading.impulse.value());
        if !is_force(loading.force) {
            return Err(ContactError::Load(LoadError::InvalidForce { time, force }));
        }
        if !is_force(loading.impulse) {
            return Err(ContactError::Load(LoadError::InvalidImpulse { time, impulse }));
        }
        Ok(loading)
    }

    /// Whether there is no load, or one with all its digits.
    fn has_digits(&self, loading: Loading<T>) -> bool {
        let Loading { hereditary, .. } = loading;
        hereditary.is_zero() || loading.has_digits(self.medium.chi(), hereditary * self.per_stiffness)
    }

    /// The last time up to `t` at which the radius is still admissible, by bisection to the last bit; 0 if it never is.
    fn time_of_leaving(&self, t: T) -> T {
        let is_inside = |time| self.radius_under(self.loading(time).hereditary).is_ok();
        let half = T::constant(0.5);
        let (mut inside, mut outside) = (T::zero(), t);
        // Halving towards a zero that is never admissible would only end after all exponents of the format.
        if !is_inside(inside) {
            return inside;
        }
        loop {
            let middle = inside + (outside - inside) * half;
            if !(inside < middle && middle < outside) {
                return inside;
            }
            if is_inside(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
    }
}

/// The hereditary load of a radius over its load integral: π m/4.
fn stiffness<T: Scalar>(medium: &Medium<T>) -> T {
    medium.m() * T::frac_pi_4()
}

/// Whether a quotient is neither subnormal nor infinite.
#[inline(always)]
fn is_normal<T: Scalar>(value: T, unit: T) -> bool {
    // Subnormal products would be slow; infinite ones are not.
    let most = smallest_normal::<T>().recip();
    (unit <= value * most) & (value <= unit * most)
}

#[inline(always)]
fn is_time<T: Scalar>(t: T) -> bool {
    (t >= T::zero()) & t.is_finite()
}

/// Compares the length of a slice with the one it must have.
pub(crate) fn check_length(what: &'static str, length: usize, expected: usize) -> Result<(), ContactError> {
    if length == expected { Ok(()) } else { Err(ContactError::Length { what, length, expected }) }
}
