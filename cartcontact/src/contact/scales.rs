//! Hereditary loads as load integrals: Y = (π m/4) J, Eq. (14).

use super::Loading;
use crate::Scalar;
use crate::in_double_words;
use crate::medium::Medium;
use crate::numbers::binary::{scale, split};
use crate::numbers::bits::is_normal;
use crate::numbers::double_word::DoubleWord;
use crate::scalar::is_single;

/// π/4 minus its word in each format, from the next digits of π; half a unit of the last digit counts for less than
/// 2⁻¹⁰⁶ and 2⁻⁵⁰.
const REST_OF_QUARTER_PI: f64 = 3.061616997868383e-17;
const REST_OF_QUARTER_PI_IN_SINGLE: f64 = -2.1855695e-8;

/// The factors between hereditary loads and load integrals, each rounded once.
///
/// A contact radius is off by as much as its load integral, over the degree of J. F 4/(π m) + ∫F 4 χ/(π m), each
/// product of which is rounded as often as its factors, is off by less than (F + χ ∫F)/(π m/4).
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales<T> {
    /// π m/4, in N/mm⁵.
    pub(super) load_per_integral: T,
    /// 4/(π m), in mm⁵/N: stored, as a product takes a third of the time of a quotient.
    pub(super) integral_per_load: T,
    /// 4 χ/(π m), in mm⁵/(N s), over a power of two: 1, or near its root where it would leave the format itself.
    integral_per_impulse: T,
    unit: T,
}

impl<T: Scalar> Scales<T> {
    pub(super) fn of(medium: &Medium<T>) -> Self {
        // Fractions, because halves of words leave the format before the words do.
        let ((m, exponent), chi) = (split(medium.m()), medium.chi());
        let rest = if is_single::<T>() { REST_OF_QUARTER_PI_IN_SINGLE } else { REST_OF_QUARTER_PI };
        // Of χ = 0 neither is used.
        let (fraction_of_chi, exponent_of_chi) = split(chi);
        let [load, integral, integral_times_chi] = in_double_words!(FUSED => {
            let load = DoubleWord::<T, FUSED>::of(T::frac_pi_4()).plus_word(T::constant(rest)).times_word(m);
            let integral = DoubleWord::of(T::one()).over(load);
            [load, integral, integral.times_word(fraction_of_chi)].map(DoubleWord::rounded)
        });
        let integral_per_load = scale(integral, -exponent);
        let (integral_per_impulse, unit) = if chi.is_zero() {
            // It may carry a derivative.
            (chi * integral_per_load, T::one())
        } else {
            let exponent = exponent_of_chi - exponent;
            // The fraction of the product is from 1/2 to 4.
            let fits = is_normal::<T>(exponent - 1) && is_normal::<T>(exponent + 2);
            let of_unit = if fits { 0 } else { exponent / 2 };
            (scale(integral_times_chi, exponent - of_unit), scale(T::one(), of_unit))
        };
        let load_per_integral = scale(load, exponent);
        Self { load_per_integral, integral_per_load, integral_per_impulse, unit }
    }

    /// The load integral under a load: J = (F + χ ∫F)/(π m/4).
    #[inline(always)]
    pub(super) fn load_integral(&self, loading: Loading<T>) -> T {
        self.load_integrals(loading).1
    }

    /// 4 F/(π m), the load integral of the force alone, and that of the whole load.
    #[inline(always)]
    pub(super) fn load_integrals(&self, loading: Loading<T>) -> (T, T) {
        let of_force = loading.force * self.integral_per_load;
        (of_force, of_force + loading.impulse * self.integral_per_impulse * self.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scales<T: Scalar>(m: f64, chi: f64) -> Option<[f64; 3]> {
        let medium = Medium::from_constants(T::constant(m), T::constant(chi)).ok()?;
        let Scales { load_per_integral, integral_per_load, integral_per_impulse, .. } = Scales::of(&medium);
        Some([load_per_integral, integral_per_load, integral_per_impulse].map(T::value))
    }

    /// Against numbers of 40 digits, rounded.
    #[test]
    fn factors_are_rounded_once() {
        let exact = [0.294_524_311_274_043_1, 3.395_305_452_627_100_7, 0.005_092_958_178_940_651];
        assert_eq!(scales::<f64>(0.375, 0.0015), Some(exact));
        let exact = [0.294_524_3_f32, 3.395_305_4, 0.005_092_958_5].map(f64::from);
        assert_eq!(scales::<f32>(0.375, 0.0015), Some(exact));
    }

    #[test]
    fn factors_are_there_up_to_the_ends_of_the_format() {
        for exponent in [-1000, -500, 500, 1000] {
            let unit = 2f64.powi(exponent);
            let exact = scales::<f64>(0.375, 0.0015)
                .map(|[load, integral, impulse]| [load * unit, integral / unit, impulse]);
            assert_eq!(scales::<f64>(0.375 * unit, 0.0015 * unit), exact);
        }
    }

    /// 4 χ/(π m) leaves the format at either end. Its fraction is below 1 or above 2.
    #[test]
    fn no_quotient_of_the_constants_loses_digits() {
        fn check<T: Scalar>(octaves: i32) {
            for constants in [[1.9, 1.01], [1.9, 1.03], [1.0, 3.8]] {
                let [m, chi] = constants.map(T::constant);
                let load_integral = |unit: T| {
                    let medium = Medium::from_constants(m / unit, chi * unit).ok()?;
                    let loading = Loading { force: T::zero(), impulse: unit.recip(), hereditary: chi };
                    Some(Scales::of(&medium).load_integral(loading) / unit)
                };
                for octave in -octaves..octaves {
                    let unit = T::constant(2f64.powi(octave));
                    assert_eq!(load_integral(unit), load_integral(T::one()), "{constants:?}, 2^{octave}");
                }
            }
        }
        check::<f64>(1000);
        check::<f32>(115);
    }

    /// The quotient χ/m is subnormal in one of the two systems of units.
    #[test]
    fn other_units_change_no_digit() {
        let load_integral = |time: f32, length: f32, force: f32| {
            let (m, chi) = (1.586_556_2e15 * force / length.powi(5), 4.539_673_4e-17);
            let medium = Medium::from_constants(m, chi).ok()?;
            let loading = Loading::new(49_002.473 * force, time * 49_002.473 * force, chi);
            Some(Scales::of(&medium).load_integral(loading) / length.powi(5))
        };
        // By the second time most of the force has drained, so that all digits of the quotient count.
        for time in [1.015_656_6e12, 1.015_656_6e18] {
            let found = load_integral(time, 1.0, 1.0);
            assert!(found.is_some_and(f32::is_normal));
            assert_eq!(found, load_integral(time, 0.0625, 32.0), "{time:e}");
        }
    }
}
