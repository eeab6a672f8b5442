//! A contact: a geometry, a medium and a load.

mod approaches;
mod common_sizes;
mod error;
mod loading;
mod radii;
mod radius;
mod recession;
mod scales;

use core::fmt;

pub use error::ContactError;
pub(crate) use loading::Loading;
pub(crate) use recession::recession_within;
use scales::Scales;

use crate::load::Load;
use crate::medium::Medium;
use crate::memory::Edge;
use crate::profile::GapProfile;
use crate::snapshot::Snapshot;
use crate::{Scalar, field};

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
/// let medium = Medium::between(layer, layer)?;
/// let contact = Contact::new(Patellofemoral, medium, load::Constant(100.0))?;
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
    scales: Scales<T>,
}

// Not derived, because geometries are mostly unit structs without `Debug`.
impl<T: fmt::Debug, P, L> fmt::Debug for Contact<T, P, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contact").field("medium", &self.medium).finish_non_exhaustive()
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    /// Checks a geometry, a medium and a load, and finds the largest admissible contact radius; [`at`](Self::at) solves
    /// for the contact at a time.
    ///
    /// # Errors
    ///
    /// [`ContactError::Profile`] or [`ContactError::Load`] if the values of the geometry's fields or of the load are not
    /// usable.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let gap = Polynomial::new([(0.025, 2.0)])?;
    /// assert!(Contact::new(gap, medium, load::Constant(100.0)).is_ok());
    /// assert!(Contact::new(gap, medium, load::Constant(-100.0)).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(profile: P, medium: Medium<T>, load: L) -> Result<Self, ContactError> {
        let max_radius = profile.checked_max_radius()?;
        load.check()?;
        let scales = Scales::of(&medium);
        Ok(Self { profile, medium, load, max_radius, scales })
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
    /// Σ|terms of J|/(a J′), if that is above 1.
    ///
    /// This holds as long as the input, 2 χ F, 4 F/(π m), ∫F, 2 Y, J(a), a J′(a), J(a)/a⁵, a⁴, F/a⁴, 4 F/(π m a⁴) and the
    /// result are normal numbers, with fractional exponents √(8/ε) δ₀′(a), too, and the terms of a J′ are finite if they
    /// have both signs; powers and products on the way to them need not be.
    ///
    /// # Errors
    ///
    /// [`ContactError`] if `t` is negative or not finite, the contact has left the admissible range of the geometry,
    /// the load has fallen so fast that the edge recedes, a force up to `t` is negative or not finite, an impulse is
    /// not that of the force, or one of the numbers above leaves the range of the format.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, ContactError, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let oblate = Polynomial::with_max_radius([(0.025, 2.0), (-1e-4, 4.0)], 8.0)?;
    /// let contact = Contact::new(oblate, medium, load::Constant(100.0))?;
    /// assert!((contact.at(100.0)?.radius() - 7.94_f64).abs() < 0.01);
    /// // With time the contact outgrows the geometry, and the error says when.
    /// let Err(ContactError::BeyondRange { leaves_at, .. }) = contact.at(200.0) else { unreachable!() };
    /// assert!(100.0 < leaves_at && leaves_at < 200.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (14), doi 10.1016/j.mechrescom.2010.11.006.
    // Always: compilers hesitate to inline a function of this size, so that a change elsewhere would decide whether it
    // is inlined into a loop over times, which saves 40 % of the instructions.
    #[inline(always)]
    pub fn at(&self, t: T) -> Result<Snapshot<'_, T, P, L>, ContactError> {
        Ok(Snapshot::new(self, Edge { time: t, radius: self.radius_at(t)? }))
    }

    /// The contact radii at many times, in mm; `radii[i]` belongs to `times[i]`, in any order.
    ///
    /// # Accuracy
    ///
    /// That of [`at`](Self::at).
    ///
    /// # Errors
    ///
    /// [`ContactError`] if the slices are empty or differ in length, and for every time as [`at`](Self::at); the
    /// contents of `radii` are then not to be used.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let mut radii = [0.0; 3];
    /// contact.radii(&[0.0, 100.0, 200.0], &mut radii)?;
    /// assert_eq!(radii[2], contact.at(200.0)?.radius());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (14), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn radii(&self, times: &[T], radii: &mut [T]) -> Result<(), ContactError> {
        self.radii_into("radii", times, radii)
    }

    /// The approaches of the bones at many times, in mm; `approaches[i]` belongs to `times[i]`, in any order.
    ///
    /// # Accuracy
    ///
    /// That of [`Snapshot::approach`].
    ///
    /// # Errors
    ///
    /// [`ContactError`] as for [`radii`](Self::radii); the contents of `approaches` are then not to be used.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let mut creep = [0.0; 3];
    /// contact.approaches(&[0.0, 100.0, 200.0], &mut creep)?;
    /// assert_eq!(creep[2], contact.at(200.0)?.approach());
    /// assert!(creep[0] < creep[1] && creep[1] < creep[2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # References
    ///
    /// Eq. (10), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn approaches(&self, times: &[T], approaches: &mut [T]) -> Result<(), ContactError> {
        self.radii_into("approaches", times, approaches)?;
        approaches::replace_radii(self, times, approaches);
        Ok(())
    }

    /// [`radii`](Self::radii) in places of that name.
    fn radii_into(&self, name: &'static str, times: &[T], radii: &mut [T]) -> Result<(), ContactError> {
        if times.is_empty() {
            return Err(ContactError::Empty { what: "times" });
        }
        check_length(name, radii.len(), times.len())?;
        radii::fill(self, times, radii, recession_within(self, times))
    }

    /// [`radii`](Self::radii) where the caller knows that the edge does not recede up to any time.
    pub(crate) fn advancing_radii(&self, times: &[T], radii: &mut [T]) -> Result<(), ContactError> {
        radii::fill(self, times, radii, None)
    }

    /// The pressures at many times and radii, in MPa.
    ///
    /// `values` is row-major, times × radii: `values[i * radii.len() + j]` belongs to `times[i]` and `radii[j]`. Times
    /// must be in ascending order, equal ones allowed; radii may be in any order, which changes no bit of the values.
    /// Descending radii, or those along a diameter, take as long as ascending ones, those of a square of pixels up to
    /// 1.6 times as long, and shuffled ones up to three times. The number of quadratures grows with the number of times
    /// plus that of radii, not with that of values.
    ///
    /// # Accuracy
    ///
    /// That of [`Snapshot::pressure`].
    ///
    /// # Errors
    ///
    /// [`ContactError`] if a slice is empty, `values` has another length than times × radii, times descend, a radius is
    /// negative or not finite, and for every time as [`at`](Self::at); the contents of `values` are then not to be
    /// used.
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
    ///
    /// # References
    ///
    /// Eq. (28), doi 10.1016/j.mechrescom.2010.11.006.
    pub fn pressure_field(&self, times: &[T], radii: &[T], values: &mut [T]) -> Result<(), ContactError> {
        field::check(times, radii, values)?;
        field::fill(self, times, radii, values)
    }

    /// π m/4: a load integral times this is its hereditary load.
    pub(crate) fn load_per_integral(&self) -> T {
        self.scales.load_per_integral
    }

    /// 4/(π m): a hereditary load times this is its load integral.
    pub(crate) fn integral_per_load(&self) -> T {
        self.scales.integral_per_load
    }
}

/// Compares the length of a slice with the one it must have.
pub(crate) fn check_length(what: &'static str, length: usize, expected: usize) -> Result<(), ContactError> {
    if length == expected { Ok(()) } else { Err(ContactError::Length { what, length, expected }) }
}
