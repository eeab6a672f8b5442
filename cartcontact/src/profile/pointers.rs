//! A pointer to a profile is the profile.

use super::{GapProfile, ProfileError, RadiusError};
use crate::Scalar;
use crate::pointers::implement_for_pointers;

implement_for_pointers! {
    GapProfile {
        fn gap(&self, r: T) -> T;
        fn approach(&self, a: T) -> T;
        fn approach_slope(&self, a: T) -> T;
        fn load_integral(&self, a: T) -> T;
        fn log_kernel(&self, x: T) -> T;
        fn pressure_kernel(&self, a: T, r: T) -> T;
        fn approach_and_load_integral(&self, a: T) -> (T, T);
        fn quick_approach(&self, a: T) -> T;
        fn quick_approach_slope(&self, a: T) -> T;
        fn quick_load_integral(&self, a: T) -> T;
        fn quick_pressure_kernel(&self, a: T, r: T) -> T;
        #[inline(always)]
        fn radius(&self, load_integral: T) -> Result<T, RadiusError>;
        fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError>;
        fn radii(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError>;
        fn radii_within(&self, load_integrals: &[T], limit: T, radii: &mut [T]) -> Result<(), RadiusError>;
        fn max_radius(&self) -> T;
        fn load_integral_drop(&self, a: T, depth: T) -> T;
        #[inline(always)]
        fn fill_slopes_and_drops(&self, a: T, places: (&[T], &[T]), values: (&mut [T], &mut [T]));
        fn highest_exponent(&self) -> T;
        fn is_smooth_at_centre(&self) -> bool;
        fn has_only_positive_terms(&self) -> bool;
        fn has_quick_radii(&self) -> bool;
        fn check(&self) -> Result<(), ProfileError>;
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use std::boxed::Box;
    use std::sync::Arc;

    use super::*;
    use crate::{Contact, Medium, Polynomial, load};

    /// A contact that owns a geometry chosen at run time.
    fn radius<P: GapProfile<f64> + 'static>(profile: P) -> Option<f64> {
        let medium = Medium::from_constants(0.375, 0.0015).ok()?;
        Contact::new(profile, medium, load::Constant(100.0)).ok()?.at(30.0).ok().map(|now| now.radius())
    }

    #[test]
    fn a_profile_may_be_boxed_or_shared() -> Result<(), ProfileError> {
        let paraboloid = Polynomial::new([(0.025, 2.0)])?;
        let steeper = Polynomial::new([(0.025, 2.0), (1e-4, 4.0)])?;
        let boxed: [(Box<dyn GapProfile<f64> + Send + Sync>, _); 2] =
            [(Box::new(paraboloid), radius(paraboloid)), (Box::new(steeper), radius(steeper))];
        for (profile, expected) in boxed {
            assert!(expected.is_some() && radius(profile) == expected, "{expected:?}");
        }
        let shared: Arc<dyn GapProfile<f64>> = Arc::new(steeper);
        assert_eq!(radius(shared), radius(steeper));
        Ok(())
    }
}
