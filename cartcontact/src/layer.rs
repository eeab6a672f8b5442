//! A cartilage layer.

use crate::Scalar;
use crate::medium::MediumError;
use crate::numbers::binary::quotient;
use crate::scalar::{is_finite_and_not_negative, is_finite_and_positive};

/// One biphasic layer on its bone.
///
/// Any consistent units will do; those of the field are mm, N, MPa = N/mm² and s.
///
/// # Examples
///
/// ```
/// use cartcontact::{Layer, Medium};
///
/// let patella = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
/// let femur = Layer { thickness: 0.5, ..patella };
/// assert_eq!(Medium::between(patella, femur)?, Medium::between(femur, patella)?);
/// # Ok::<(), cartcontact::MediumError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer<T> {
    /// Thickness h, in mm.
    pub thickness: T,
    /// Shear modulus μ of the solid matrix, in MPa: H (1 − 2 ν)/(2 (1 − ν)) from an aggregate modulus H and Poisson's
    /// ratio ν, E/(2 (1 + ν)) from Young's modulus.
    pub shear_modulus: T,
    /// Permeability k, in mm⁴/(N s): 1e-15 m⁴/(N s), as it is often given, is 1e-3 mm⁴/(N s).
    pub permeability: T,
}

impl<T: Scalar> Layer<T> {
    /// The time in which fluid diffuses through the layer, in s: results hold for times that are short compared with
    /// it.
    ///
    /// `poisson_ratio` is that of the solid matrix, ν. Without permeability the time is infinite; beyond the range of the
    /// format it is rounded, to 0 or infinity.
    ///
    /// # Formula
    ///
    /// ```text
    /// h²/(k H),     H = 2 μ (1 − ν)/(1 − 2 ν)
    /// ```
    ///
    /// H is the aggregate modulus λ + 2 μ. For one layer, or two that are alike, the memory fades within a similar
    /// time, 1/χ = h²/(3 μ k).
    ///
    /// # Errors
    ///
    /// [`MediumError`] unless thickness and shear modulus are positive and finite, the permeability is finite and not
    /// negative, and −1 < ν < 1/2.
    ///
    /// # Examples
    ///
    /// ```
    /// # use cartcontact::Layer;
    /// let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    /// assert_eq!(layer.diffusion_time(0.0)?, 1000.0); // s
    /// # Ok::<(), cartcontact::MediumError>(())
    /// ```
    pub fn diffusion_time(&self, poisson_ratio: T) -> Result<T, MediumError> {
        self.check()?;
        let (one, two) = (T::one(), T::constant(2.0));
        if !(-one < poisson_ratio && two * poisson_ratio < one) {
            return Err(MediumError::PoissonRatio { poisson_ratio: poisson_ratio.value() });
        }
        if self.permeability.is_zero() {
            return Ok(T::infinity());
        }
        let per_modulus = (one - two * poisson_ratio) / (two * (one - poisson_ratio));
        let Self { thickness: h, shear_modulus, permeability } = *self;
        Ok(quotient([per_modulus, h, h], [shear_modulus, permeability]))
    }

    /// Whether the three constants are valid.
    fn check(&self) -> Result<(), MediumError> {
        if !is_finite_and_positive(self.thickness) {
            return Err(MediumError::Thickness { thickness: self.thickness.value() });
        }
        if !is_finite_and_positive(self.shear_modulus) {
            return Err(MediumError::ShearModulus { shear_modulus: self.shear_modulus.value() });
        }
        if !is_finite_and_not_negative(self.permeability) {
            return Err(MediumError::Permeability { permeability: self.permeability.value() });
        }
        Ok(())
    }

    /// h³/(3 μ), after a check of the three constants.
    pub(crate) fn compliance(&self) -> Result<T, MediumError> {
        self.check()?;
        let h = self.thickness;
        Ok(quotient([h, h, h], [self.shear_modulus, T::constant(3.0)]))
    }

    /// m h k, what the layer adds to the rate of a medium.
    pub(crate) fn rate_within(&self, m: T) -> T {
        quotient([m, self.thickness, self.permeability], [])
    }

    /// 3 μ k/h², the rate of the layer on its own.
    pub(crate) fn own_rate(&self) -> T {
        let h = self.thickness;
        quotient([T::constant(3.0), self.shear_modulus, self.permeability], [h, h])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_in_range_wherever_their_factors_lie() -> Result<(), MediumError> {
        let layer = |thickness, shear_modulus, permeability| Layer { thickness, shear_modulus, permeability };
        let error = |found: f64, expected: f64| (found / expected - 1.0).abs();
        // h²/(2 μ k).
        assert!(error(layer(1e160, 1.0, 1e300).diffusion_time(0.0)?, 5e19) < 1e-15);
        assert!(error(layer(1e-170, 1.0, 1e-300).diffusion_time(0.0)?, 5e-41) < 1e-15);
        // 3 μ k/h².
        assert!(error(layer(1e-160, 1e-200, 1e-150).own_rate(), 3e-30) < 1e-15);
        assert!(error(layer(1e120, 1e250, 1.0).compliance()?, 1e110 / 3.0) < 1e-15);
        assert!(error(layer(1e-200, 1.0, 1e-100).rate_within(1e290), 1e-10) < 1e-15);
        assert_eq!(layer(1.0, 1.0, 0.0).rate_within(1e290), 0.0);
        Ok(())
    }
}
