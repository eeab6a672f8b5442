//! A contact: a geometry, a medium and a load.

use core::fmt;

use crate::error::Shown;
use crate::load::{Load, LoadError, is_force};
use crate::medium::Medium;
use crate::memory::{Moment, surplus_that_counts};
use crate::profile::{GapProfile, ProfileError, RadiusError};
use crate::scalar::smallest_normal;
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
        profile.check().map_err(ContactError::Profile)?;
        load.check().map_err(ContactError::Load)?;
        let max_radius = profile.max_radius();
        Ok(Self { profile, medium, load, max_radius })
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
    /// The radius is within 2 ε for sums of positive terms; otherwise times the condition number of J,
    /// divided by a J′/J.
    ///
    /// This holds over the whole range of the format: as long as the input, χ F, Y, J(a), a J′(a), J(a)/a⁵, a⁴, F/a⁴
    /// and the result are normal numbers, powers and products on the way to them need not be. Pressures want the rate
    /// F′ + χ F to be finite as well.
    ///
    /// # Errors
    ///
    /// [`ContactError`] if `t` is negative or not finite, the contact has left the admissible range of the
    /// geometry, the load has fallen so fast that the edge recedes, or these numbers
    /// leave the range of the format.
    ///
    /// # References
    ///
    /// Eq. (14), doi 10.1016/j.mechrescom.2010.11.006.
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
        for (radius, &time) in radii.iter_mut().zip(times) {
            *radius = self.radius_at(time)?;
        }
        Ok(())
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
        self.medium.m() * T::frac_pi_4()
    }

    /// The contact radius under a hereditary load Y.
    pub(crate) fn radius_under(&self, hereditary: T) -> Result<T, RadiusError> {
        self.radius_of(hereditary / self.stiffness())
    }

    /// The contact radius of a load integral.
    pub(crate) fn radius_of(&self, load_integral: T) -> Result<T, RadiusError> {
        self.profile.radius_within(load_integral, self.max_radius)
    }

    /// What a hereditary load exceeds that of a radius.
    pub(crate) fn surplus(&self, hereditary: T, radius: T) -> T {
        hereditary - self.stiffness() * self.profile.load_integral(radius)
    }

    /// A time with its contact radius, for integrals that begin or end there.
    pub(crate) fn moment(&self, time: T, radius: T) -> Moment<T> {
        let force = self.load.force(time);
        let hereditary = force + self.medium.chi() * self.load.impulse(time);
        Moment { time, radius, surplus: surplus_that_counts(self.surplus(hereditary, radius), force) }
    }

    pub(crate) fn radius_at(&self, t: T) -> Result<T, ContactError> {
        if !(t >= T::zero() && t.is_finite()) {
            return Err(ContactError::InvalidTime { time: t.value() });
        }
        let hereditary = self.hereditary_load(t)?;
        if let Some(since) = self.load.recession(self.medium.chi(), t) {
            return Err(ContactError::Receding { time: t.value(), since: since.value() });
        }
        self.check_digits(t, hereditary)?;
        let radius = self.radius_under(hereditary).map_err(|error| match error {
            RadiusError::BeyondRange { max_radius, .. } => ContactError::BeyondRange {
                time: t.value(),
                leaves_at: self.time_of_leaving(t).value(),
                max_radius,
            },
            other => ContactError::Radius { time: t.value(), error: other },
        })?;
        // J/a⁵ is δ₀′ but for a factor of 8 to 2056, and F/a⁴ the curvature of the pressure.
        let (square, force) = (radius * radius, self.load.force(t));
        let fourth = square * square;
        let slope = hereditary / self.stiffness() / fourth / radius;
        let has_pressure = force.is_zero() || has_digits(force / fourth);
        if radius.is_zero() || has_digits(fourth) && has_digits(slope) && has_pressure {
            Ok(radius)
        } else {
            Err(ContactError::OutOfRange { time: t.value(), force: self.load.force(t).value() })
        }
    }

    /// Whether a load is large enough to have all its digits: as it is, over π m/4, times χ and times t.
    fn check_digits(&self, t: T, hereditary: T) -> Result<(), ContactError> {
        let (force, chi) = (self.load.force(t), self.medium.chi());
        let has_force = force.is_zero() || has_digits(force) && (chi.is_zero() || has_digits(chi * force));
        // Of an impulse only what is not rounding beside the force has to be right.
        let has_impulse = chi * smallest_normal() <= force || has_digits(self.load.impulse(t));
        let is_unloaded = hereditary.is_zero();
        if is_unloaded || has_force && has_impulse && has_digits(hereditary / self.stiffness()) {
            return Ok(());
        }
        Err(ContactError::OutOfRange { time: t.value(), force: force.value() })
    }

    /// Y(t) = F(t) + χ ∫₀ᵗ F, from forces and impulses that a load of the user's own may get wrong.
    fn hereditary_load(&self, t: T) -> Result<T, ContactError> {
        let (force, impulse) = (self.load.force(t), self.load.impulse(t));
        let time = t.value();
        if !is_force(force) {
            return Err(ContactError::Load(LoadError::InvalidForce { time, force: force.value() }));
        }
        if !is_force(impulse) {
            return Err(ContactError::Load(LoadError::InvalidImpulse { time, impulse: impulse.value() }));
        }
        Ok(force + self.medium.chi() * impulse)
    }

    /// The last time up to `t` at which the radius is still admissible, by bisection to the last bit.
    fn time_of_leaving(&self, t: T) -> T {
        let half = T::constant(0.5);
        let (mut inside, mut outside) = (T::zero(), t);
        loop {
            let middle = inside + (outside - inside) * half;
            if !(inside < middle && middle < outside) {
                return inside;
            }
            let hereditary = self.load.force(middle) + self.medium.chi() * self.load.impulse(middle);
            if self.radius_under(hereditary).is_ok() {
                inside = middle;
            } else {
                outside = middle;
            }
        }
    }
}

/// Whether a positive number is finite and not subnormal.
fn has_digits<T: Scalar>(x: T) -> bool {
    x >= smallest_normal() && x.is_finite()
}

/// Compares the length of a slice with the one it must have.
pub(crate) fn check_length(what: &'static str, length: usize, expected: usize) -> Result<(), ContactError> {
    if length == expected { Ok(()) } else { Err(ContactError::Length { what, length, expected }) }
}

/// Why a contact cannot be set up or evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContactError {
    /// The geometry is not usable.
    Profile(ProfileError),
    /// The load is not usable.
    Load(LoadError),
    /// A time is negative, infinite or not a number.
    InvalidTime {
        /// The time, in s.
        time: f64,
    },
    /// A radius is negative, infinite or not a number.
    InvalidRadius {
        /// Its index in the slice.
        index: usize,
        /// The radius, in mm.
        radius: f64,
    },
    /// The contact has left the admissible range of the geometry.
    BeyondRange {
        /// The time asked for, in s.
        time: f64,
        /// The time at which the contact leaves the range, in s.
        leaves_at: f64,
        /// The end of the range, in mm.
        max_radius: f64,
    },
    /// The load fell so fast that the edge of the contact recedes.
    Receding {
        /// The time asked for, in s.
        time: f64,
        /// The time at which the edge begins to recede, in s.
        since: f64,
    },
    /// The load is so small that it, its quotient by m or its product with χ loses digits, or a⁴ leaves the format.
    OutOfRange {
        /// The time, in s.
        time: f64,
        /// The force at that time, in N.
        force: f64,
    },
    /// There is no contact radius at a time for another reason.
    Radius {
        /// The time, in s.
        time: f64,
        /// The reason.
        error: RadiusError,
    },
    /// A slice has no elements.
    Empty {
        /// Which slice.
        what: &'static str,
    },
    /// A slice has the wrong length.
    Length {
        /// Which slice.
        what: &'static str,
        /// Its length.
        length: usize,
        /// The length it must have.
        expected: usize,
    },
    /// Times are not in ascending order.
    Unsorted {
        /// The index of the first time that is before its predecessor.
        index: usize,
        /// That time, in s.
        time: f64,
    },
}

impl fmt::Display for ContactError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Profile(error) => error.fmt(f),
            Self::Load(error) => error.fmt(f),
            Self::InvalidTime { time } => {
                write!(
                    f,
                    "the time is {}, but it must be a finite number from 0; give the time since the load was \
                     applied, in s",
                    Shown(time)
                )
            }
            Self::InvalidRadius { index, radius } => write!(
                f,
                "radius {index} is {}, but radii must be finite numbers from 0; give distances from the axis",
                Shown(radius)
            ),
            Self::BeyondRange { time, leaves_at, max_radius } => write!(
                f,
                "at time {} the contact has left the admissible range of the geometry: its radius reaches {} \
                 at time {}; ask for earlier times, lower the load, or extend `max_radius` if the geometry \
                 allows it",
                Shown(time),
                Shown(max_radius),
                Shown(leaves_at)
            ),
            Self::Receding { time, since } => write!(
                f,
                "the load falls faster than e^(-chi t) at time {}, so at time {} the edge of the contact has \
                 receded, which this solution does not cover; ask for earlier times or let the load fall more \
                 slowly",
                Shown(since),
                Shown(time)
            ),
            Self::OutOfRange { time, force } => write!(
                f,
                "the force at time {} is {}, for which the numbers of the contact leave the range in which they have \
                 all their digits; choose units of force and length in which they are nearer to 1",
                Shown(time),
                Shown(force)
            ),
            Self::Radius { time, error } => write!(f, "at time {}: {error}", Shown(time)),
            Self::Empty { what } => write!(f, "`{what}` is empty; give at least one"),
            Self::Length { what, length, expected } => {
                write!(f, "`{what}` has {length} elements, but {expected} are needed; resize it")
            }
            Self::Unsorted { index, time } => write!(
                f,
                "time {index} is {}, before the time that precedes it; sort the times in ascending order",
                Shown(time)
            ),
        }
    }
}

impl core::error::Error for ContactError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Profile(error) => Some(error),
            Self::Load(error) => Some(error),
            Self::Radius { error, .. } => Some(error),
            _ => None,
        }
    }
}
