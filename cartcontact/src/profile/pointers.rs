//! A reference to a profile is the profile: all its methods are forwarded, so that none falls back to the provided one.

use super::{GapProfile, ProfileError, RadiusError};
use crate::Scalar;

impl<T: Scalar, P: GapProfile<T> + ?Sized> GapProfile<T> for &P {
    fn gap(&self, r: T) -> T {
        (**self).gap(r)
    }
    fn approach(&self, a: T) -> T {
        (**self).approach(a)
    }
    fn approach_slope(&self, a: T) -> T {
        (**self).approach_slope(a)
    }
    fn load_integral(&self, a: T) -> T {
        (**self).load_integral(a)
    }
    fn log_kernel(&self, x: T) -> T {
        (**self).log_kernel(x)
    }
    fn pressure_kernel(&self, a: T, r: T) -> T {
        (**self).pressure_kernel(a, r)
    }
    fn approach_and_load_integral(&self, a: T) -> (T, T) {
        (**self).approach_and_load_integral(a)
    }
    fn quick_approach(&self, a: T) -> T {
        (**self).quick_approach(a)
    }
    fn quick_approach_slope(&self, a: T) -> T {
        (**self).quick_approach_slope(a)
    }
    fn quick_load_integral(&self, a: T) -> T {
        (**self).quick_load_integral(a)
    }
    fn quick_pressure_kernel(&self, a: T, r: T) -> T {
        (**self).quick_pressure_kernel(a, r)
    }
    #[inline(always)]
    fn radius(&self, load_integral: T) -> Result<T, RadiusError> {
        (**self).radius(load_integral)
    }
    fn radius_within(&self, load_integral: T, limit: T) -> Result<T, RadiusError> {
        (**self).radius_within(load_integral, limit)
    }
    fn radii(&self, load_integrals: &[T], radii: &mut [T]) -> Result<(), RadiusError> {
        (**self).radii(load_integrals, radii)
    }
    fn radii_within(&self, load_integrals: &[T], limit: T, radii: &mut [T]) -> Result<(), RadiusError> {
        (**self).radii_within(load_integrals, limit, radii)
    }
    fn max_radius(&self) -> T {
        (**self).max_radius()
    }
    fn load_integral_drop(&self, a: T, depth: T) -> T {
        (**self).load_integral_drop(a, depth)
    }
    #[inline(always)]
    fn fill_slopes_and_drops(&self, a: T, places: (&[T], &[T]), values: (&mut [T], &mut [T])) {
        (**self).fill_slopes_and_drops(a, places, values);
    }
    fn highest_exponent(&self) -> T {
        (**self).highest_exponent()
    }
    fn is_smooth_at_centre(&self) -> bool {
        (**self).is_smooth_at_centre()
    }
    fn has_only_positive_terms(&self) -> bool {
        (**self).has_only_positive_terms()
    }
    fn has_quick_radii(&self) -> bool {
        (**self).has_quick_radii()
    }
    fn check(&self) -> Result<(), ProfileError> {
        (**self).check()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A profile in which every method gives another number than the provided one would.
    struct Numbered;

    impl GapProfile<f64> for Numbered {
        fn gap(&self, _r: f64) -> f64 {
            1.0
        }
        fn approach(&self, _a: f64) -> f64 {
            2.0
        }
        fn approach_slope(&self, _a: f64) -> f64 {
            3.0
        }
        fn load_integral(&self, _a: f64) -> f64 {
            4.0
        }
        fn log_kernel(&self, _x: f64) -> f64 {
            5.0
        }
        fn pressure_kernel(&self, _a: f64, _r: f64) -> f64 {
            6.0
        }
        fn quick_approach(&self, _a: f64) -> f64 {
            7.0
        }
        fn quick_approach_slope(&self, _a: f64) -> f64 {
            8.0
        }
        fn quick_load_integral(&self, _a: f64) -> f64 {
            9.0
        }
        fn quick_pressure_kernel(&self, _a: f64, _r: f64) -> f64 {
            10.0
        }
        fn radius(&self, _load_integral: f64) -> Result<f64, RadiusError> {
            Ok(11.0)
        }
        fn radius_within(&self, _load_integral: f64, _limit: f64) -> Result<f64, RadiusError> {
            Ok(12.0)
        }
        fn radii(&self, _load_integrals: &[f64], radii: &mut [f64]) -> Result<(), RadiusError> {
            radii.fill(13.0);
            Ok(())
        }
        fn radii_within(
            &self,
            _load_integrals: &[f64],
            _limit: f64,
            radii: &mut [f64],
        ) -> Result<(), RadiusError> {
            radii.fill(14.0);
            Ok(())
        }
        fn max_radius(&self) -> f64 {
            15.0
        }
        fn load_integral_drop(&self, _a: f64, _depth: f64) -> f64 {
            16.0
        }
        fn fill_slopes_and_drops(
            &self,
            _a: f64,
            _places: (&[f64], &[f64]),
            (slopes, drops): (&mut [f64], &mut [f64]),
        ) {
            slopes.fill(17.0);
            drops.fill(18.0);
        }
        fn highest_exponent(&self) -> f64 {
            19.0
        }
        fn approach_and_load_integral(&self, _a: f64) -> (f64, f64) {
            (20.0, 21.0)
        }
        fn is_smooth_at_centre(&self) -> bool {
            true
        }
        fn has_only_positive_terms(&self) -> bool {
            true
        }
        fn has_quick_radii(&self) -> bool {
            true
        }
        fn check(&self) -> Result<(), ProfileError> {
            Err(ProfileError::Empty)
        }
    }

    fn numbers(profile: impl GapProfile<f64>) -> Result<[f64; 21], RadiusError> {
        let ([mut radii, mut within, mut slopes, mut drops], one) = ([[0.0]; 4], [1.0]);
        profile.radii(&one, &mut radii)?;
        profile.radii_within(&one, 1.0, &mut within)?;
        profile.fill_slopes_and_drops(1.0, (&one, &one), (&mut slopes, &mut drops));
        let (approach, load_integral) = profile.approach_and_load_integral(1.0);
        Ok([
            profile.gap(1.0),
            profile.approach(1.0),
            profile.approach_slope(1.0),
            profile.load_integral(1.0),
            profile.log_kernel(1.0),
            profile.pressure_kernel(1.0, 0.0),
            profile.quick_approach(1.0),
            profile.quick_approach_slope(1.0),
            profile.quick_load_integral(1.0),
            profile.quick_pressure_kernel(1.0, 0.0),
            profile.radius(1.0)?,
            profile.radius_within(1.0, 1.0)?,
            radii[0],
            within[0],
            profile.max_radius(),
            profile.load_integral_drop(1.0, 0.5),
            slopes[0],
            drops[0],
            profile.highest_exponent(),
            approach,
            load_integral,
        ])
    }

    #[test]
    fn a_reference_is_the_profile() {
        assert_eq!(numbers(&Numbered), Ok(core::array::from_fn(|index| index as f64 + 1.0)));
        let reference = &Numbered;
        assert!(GapProfile::is_smooth_at_centre(&reference));
        assert!(GapProfile::has_only_positive_terms(&reference));
        assert!(GapProfile::has_quick_radii(&reference));
        assert_eq!(GapProfile::check(&reference), Err(ProfileError::Empty));
    }
}
