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
        fn excess_on_axis(&self, a: T) -> T;
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
        fn checked_max_radius(&self) -> Result<T, ProfileError>;
    }
}
