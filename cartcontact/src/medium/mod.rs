//! The two constants that cartilage layers contribute to the model.

mod error;

pub use error::MediumError;

use crate::Scalar;
use crate::layer::Layer;
use crate::scalar::is_normal_and_positive;

/// What the layers contribute to the solution: the stiffness m and the rate of drainage χ.
///
/// Nothing else of the layers enters a result, so that a creep test, however long, determines two constants only.
/// Thickness, shear modulus and permeability of a layer cannot all be fitted: (h, μ, k) and (2 h, 8 μ, k/2) are the
/// same medium. Nor can the curvature of a paraboloid, if only its approach is measured, which depends on the radius R
/// of the ball by m R² alone; a contact radius would tell them apart. Measure thickness and curvature; otherwise the
/// matrix of the normal equations is singular, though rounding may hide that.
///
/// # Examples
///
/// ```
/// use cartcontact::{Layer, Medium};
///
/// let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
/// let medium = Medium::between(layer, layer)?;
/// assert_eq!((medium.m(), medium.chi()), (0.375, 0.0015));
/// # Ok::<(), cartcontact::MediumError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium<T> {
    m: T,
    chi: T,
}

impl<T: Scalar> Medium<T> {
    /// Two layers in contact, with the rate that follows from the layers' displacements.
    ///
    /// # Formula
    ///
    /// ```text
    /// m = 1 / (h₁³/(3 μ₁) + h₂³/(3 μ₂))
    /// χ = m (h₁ k₁ + h₂ k₂)
    /// ```
    ///
    /// The paper prints another χ, see [`between_as_printed_2011`](Self::between_as_printed_2011). By symmetry two
    /// equal layers behave like one [against a rigid body](Self::against_rigid) and must have its rate. With this χ
    /// they do; the printed one is twice that.
    ///
    /// # Accuracy
    ///
    /// m is within 3 ε, χ within 5 ε. Errors of a contact are stated for the values that [`m`](Self::m) and
    /// [`chi`](Self::chi) return.
    ///
    /// # Errors
    ///
    /// [`MediumError`] unless all thicknesses and shear moduli are positive and finite, permeabilities are finite and
    /// not negative, and m and χ are representable.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Layer, Medium};
    /// let patella = Layer { thickness: 2.0, shear_modulus: 0.25, permeability: 2e-3 };
    /// let femur = Layer { thickness: 1.0, ..patella };
    /// let medium = Medium::between(patella, femur)?;
    /// assert!((medium.m() - 1.0 / 12.0_f64).abs() < 1e-16); // MPa/mm³
    /// assert!((medium.chi() - 5e-4_f64).abs() < 1e-18); // 1/s
    /// # Ok::<(), cartcontact::MediumError>(())
    /// ```
    ///
    /// # References
    ///
    /// For m, I. Argatov, Mech. Res. Commun. 38 (2011), section 2, doi 10.1016/j.mechrescom.2010.11.006.
    pub fn between(first: Layer<T>, second: Layer<T>) -> Result<Self, MediumError> {
        let m = stiffness(first, second)?;
        Self::of_layers(m, first.rate_within(m) + second.rate_within(m), [first, second])
    }

    /// Two layers in contact, with the rate as the paper prints it, for comparison with published curves.
    ///
    /// # Formula
    ///
    /// ```text
    /// χ = 3 μ₁ k₁/h₁² + 3 μ₂ k₂/h₂²
    /// ```
    ///
    /// For two equal layers this is twice the rate of [`between`](Self::between), and it diverges as one of
    /// the layers becomes thin.
    ///
    /// # Errors
    ///
    /// [`MediumError`] as for [`between`](Self::between).
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Layer, Medium};
    /// let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    /// let printed = Medium::between_as_printed_2011(layer, layer)?;
    /// assert_eq!(printed.chi(), 2.0 * Medium::between(layer, layer)?.chi());
    /// # Ok::<(), cartcontact::MediumError>(())
    /// ```
    ///
    /// # References
    ///
    /// I. Argatov, Mech. Res. Commun. 38 (2011), section 2, doi 10.1016/j.mechrescom.2010.11.006.
    pub fn between_as_printed_2011(first: Layer<T>, second: Layer<T>) -> Result<Self, MediumError> {
        Self::of_layers(stiffness(first, second)?, first.own_rate() + second.own_rate(), [first, second])
    }

    /// One layer against a rigid impermeable body.
    ///
    /// # Formula
    ///
    /// ```text
    /// m = 3 μ/h³,     χ = 3 μ k/h²
    /// ```
    ///
    /// # Errors
    ///
    /// [`MediumError`] as for [`between`](Self::between).
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::{Layer, Medium};
    /// let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    /// let medium = Medium::against_rigid(layer)?;
    /// assert_eq!((medium.m(), medium.chi()), (0.75, 0.0015));
    /// # Ok::<(), cartcontact::MediumError>(())
    /// ```
    ///
    /// # References
    ///
    /// The terms of one layer in I. Argatov, Mech. Res. Commun. 38 (2011), section 2, doi
    /// 10.1016/j.mechrescom.2010.11.006.
    pub fn against_rigid(layer: Layer<T>) -> Result<Self, MediumError> {
        let m = layer.compliance()?.recip();
        Self::of_layers(m, layer.rate_within(m), [layer])
    }

    /// The constants themselves: m in MPa/mm³, χ in 1/s.
    ///
    /// # Errors
    ///
    /// [`MediumError`] unless m is positive, χ is 0 or positive, both are finite, and neither is so small that it loses
    /// digits: positive but below 2⁻¹⁰²² in f64 or 2⁻¹²⁶ in f32.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::Medium;
    /// let elastic = Medium::from_constants(0.375, 0.0)?;
    /// assert_eq!((elastic.m(), elastic.chi()), (0.375, 0.0));
    /// # Ok::<(), cartcontact::MediumError>(())
    /// ```
    pub fn from_constants(m: T, chi: T) -> Result<Self, MediumError> {
        if !is_normal_and_positive(m) {
            return Err(MediumError::Stiffness { m: m.value() });
        }
        if !(chi.is_zero() || is_normal_and_positive(chi)) {
            return Err(MediumError::Rate { chi: chi.value() });
        }
        Ok(Self { m, chi })
    }

    /// A rate of zero is that of layers without permeability, not one that the format has rounded to zero.
    fn of_layers<const N: usize>(m: T, chi: T, layers: [Layer<T>; N]) -> Result<Self, MediumError> {
        let medium = Self::from_constants(m, chi)?;
        if chi.is_zero() && layers.iter().any(|layer| !layer.permeability.is_zero()) {
            return Err(MediumError::Rate { chi: 0.0 });
        }
        Ok(medium)
    }

    /// The stiffness m, in MPa/mm³.
    #[inline]
    pub fn m(&self) -> T {
        self.m
    }

    /// The rate of drainage χ, in 1/s.
    #[inline]
    pub fn chi(&self) -> T {
        self.chi
    }
}

/// m = 1/(h₁³/(3 μ₁) + h₂³/(3 μ₂))
fn stiffness<T: Scalar>(first: Layer<T>, second: Layer<T>) -> Result<T, MediumError> {
    Ok((first.compliance()? + second.compliance()?).recip())
}
