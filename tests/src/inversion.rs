//! Geometries of which only load integrals and their radii count.

use cartcontact::{GapProfile, RadiusError, Scalar};

/// What tests of radii ask of a geometry. For each of dozens of geometries in two formats, a table of all functions of a
/// [`GapProfile`] would have to be compiled.
pub trait Inversion<T> {
    /// J(a).
    fn load_integral(&self, a: T) -> T;
    /// The end of the range.
    fn max_radius(&self) -> T;
    /// The radius of a load integral.
    ///
    /// # Errors
    ///
    /// As [`GapProfile::radius`].
    fn radius(&self, load_integral: T) -> Result<T, RadiusError>;
    /// The same up to a limit.
    ///
    /// # Errors
    ///
    /// As [`GapProfile::radius_within`].
    fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError>;
    /// The radii of many load integrals.
    ///
    /// # Errors
    ///
    /// As [`GapProfile::radii`].
    fn radii(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError>;
}

impl<T: Scalar, P: GapProfile<T>> Inversion<T> for P {
    fn load_integral(&self, a: T) -> T {
        GapProfile::load_integral(self, a)
    }

    fn max_radius(&self) -> T {
        GapProfile::max_radius(self)
    }

    fn radius(&self, load_integral: T) -> Result<T, RadiusError> {
        GapProfile::radius(self, load_integral)
    }

    fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError> {
        GapProfile::radius_within(self, load_integral, limit)
    }

    fn radii(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError> {
        GapProfile::radii(self, load_integrals, radii)
    }
}
