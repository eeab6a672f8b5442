//! The numbers the crate computes with.

use simba::scalar::{RealField, SupersetOf};

/// A real number type: every `simba`/`nalgebra` [`RealField`] that is `Copy`.
///
/// `f32` and `f64` are; so are the dual numbers of `num-dual`, with which every result carries its exact
/// derivatives.
///
/// # Examples
///
/// ```
/// use cartcontact::Scalar;
///
/// fn half<T: Scalar>(x: T) -> T {
///     x * T::constant(0.5)
/// }
/// assert_eq!(half(3.0_f32), 1.5);
/// ```
pub trait Scalar: RealField + Copy {
    /// The number nearest to a literal; exact whenever `Self` holds it.
    fn constant(value: f64) -> Self;

    /// The plain value, without derivatives, for messages and for decisions on size.
    fn value(self) -> f64;

    /// Positive infinity.
    fn infinity() -> Self;
}

impl<T: RealField + Copy> Scalar for T {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        <T as SupersetOf<f64>>::from_subset(&value)
    }

    #[inline(always)]
    fn value(self) -> f64 {
        <T as SupersetOf<f64>>::to_subset_unchecked(&self)
    }

    #[inline(always)]
    fn infinity() -> Self {
        <T as SupersetOf<f32>>::from_subset(&f32::INFINITY)
    }
}
