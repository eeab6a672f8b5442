//! Pressure fields as matrices of `nalgebra`.

use nalgebra::DMatrix;

use crate::Scalar;
use crate::contact::{Contact, ContactError};
use crate::load::Load;
use crate::profile::GapProfile;

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    /// The pressures at many times and radii, in MPa, as a matrix with one row per time and one column per
    /// radius: [`pressure_field`](Self::pressure_field) with its result allocated.
    ///
    /// # Errors
    ///
    /// [`ContactError`] as [`pressure_field`](Self::pressure_field).
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Contact, Medium, Polynomial, load};
    /// let medium = Medium::from_constants(0.375, 0.0015)?;
    /// let contact = Contact::new(Polynomial::new([(0.025, 2.0)])?, medium, load::Constant(100.0))?;
    /// let pressures = contact.pressure_matrix(&[0.0, 100.0, 200.0], &[0.0, 3.0])?;
    /// assert_eq!(pressures.shape(), (3, 2));
    /// assert!(pressures[(2, 0)] < pressures[(0, 0)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure_matrix(&self, times: &[T], radii: &[T]) -> Result<DMatrix<T>, ContactError> {
        let mut values = vec![T::zero(); times.len() * radii.len()];
        self.pressure_field(times, radii, &mut values)?;
        Ok(DMatrix::from_row_slice(times.len(), radii.len(), &values))
    }
}
