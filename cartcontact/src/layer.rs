//! A cartilage layer.

use crate::Scalar;
use crate::medium::MediumError;

/// One biphasic layer on its bone.
///
/// Any consistent units do; the field's own are mm, N, MPa = N/mm² and s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer<T> {
    /// Thickness h, in mm.
    pub thickness: T,
    /// Shear modulus μ of the solid matrix, in MPa.
    pub shear_modulus: T,
    /// Permeability k, in mm⁴/(N s).
    pub permeability: T,
}

impl<T: Scalar> Layer<T> {
    /// The time in which fluid diffuses through the layer, in s: results hold for times that are short against it.
    ///
    /// `poisson_ratio` is that of the solid matrix, ν. Without permeability the time is infinite.
    ///
    /// # Formula
    ///
    /// ```text
    /// h²/(k H),     H = 2 μ (1 − ν)/(1 − 2 ν)
    /// ```
    ///
    /// H is the aggregate modulus λ + 2 μ. For one layer, or two that are alike, the memory fades within a like time,
    /// 1/χ = h²/(3 μ k).
    ///
    /// # Errors
    ///
    /// [`MediumError`] unless thickness and shear modulus are positive, the permeability is not negative, and
    /// −1 < ν < 1/2.
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
        let compliance = (one - two * poisson_ratio) / (two * (one - poisson_ratio)) / self.shear_modulus;
        Ok(product_of_three(compliance, self.thickness, self.thickness) / self.permeability)
    }

    /// Whether the three constants are those of a layer.
    fn check(&self) -> Result<(), MediumError> {
        let positive = |x: T| x > T::zero() && x.is_finite();
        if !positive(self.thickness) {
            return Err(MediumError::Thickness { thickness: self.thickness.value() });
        }
        if !positive(self.shear_modulus) {
            return Err(MediumError::ShearModulus { shear_modulus: self.shear_modulus.value() });
        }
        if !(self.permeability >= T::zero() && self.permeability.is_finite()) {
            return Err(MediumError::Permeability { permeability: self.permeability.value() });
        }
        Ok(())
    }

    /// h³/(3 μ), after a check of the three constants.
    pub(crate) fn compliance(&self) -> Result<T, MediumError> {
        self.check()?;
        let h = self.thickness;
        // Neither h³ nor 3 μ need be in range.
        Ok(h / T::constant(3.0) / self.shear_modulus * h * h)
    }

    /// m h k, what the layer adds to the rate of a medium.
    pub(crate) fn rate_within(&self, m: T) -> T {
        product_of_three(m, self.thickness, self.permeability)
    }

    /// 3 μ k/h², the rate of the layer on its own.
    pub(crate) fn own_rate(&self) -> T {
        let square = self.thickness * self.thickness;
        T::constant(3.0) * product_of_three(self.shear_modulus, self.permeability, square.recip())
    }
}

/// x y z of numbers from 0, the largest times the smallest first: that product is out of range only if x y z is.
fn product_of_three<T: Scalar>(x: T, y: T, z: T) -> T {
    let (low, high) = (x.min(y), x.max(y));
    let middle = low.max(high.min(z));
    (low.min(z) * high.max(z)) * middle
}
