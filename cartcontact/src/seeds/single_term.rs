//! The units in which one table holds all radii of J = j a^p, whatever j and the load integral are.
//!
//! With p = k/q in lowest terms, y/j = a^p multiplied by 2^k multiplies a by 2^q. So y/j is brought between 1 and 2^k by
//! its exponent, and the radius from the table put back where it belongs, both exactly.

use super::Target;
use super::units::Units;
use crate::Scalar;
use crate::evaluate::bits::{exponent, fraction, power_of_two, with_half_its_digits};
use crate::scalar::is;

/// What is added to whole periods so that there is no number below them: no exponent is below −1023.
const PERIODS_BELOW: u32 = 1024;

/// Those of the term j aᵖ with p = `K`/`Q`.
#[derive(Clone, Copy, Debug)]
pub struct SingleTerm<T, const K: u32, const Q: i32> {
    per_load_integral: T,
    per_unit: T,
}

impl<T: Scalar, const K: u32, const Q: i32> SingleTerm<T, K, Q> {
    /// Of the coefficient j, and what load integrals are multiplied by, see [`Target`].
    ///
    /// With j between 1/b and b, and y between 1/b′ and b′, the products of a step lie within 2^±14 b b′. Other terms have
    /// no table, nor have other load integrals.
    #[inline(always)]
    pub fn of(j: T, per_unit: T) -> Self {
        let (least, most) = if is::<T, f32>() { (1e-11, 1e11) } else { (1e-60, 1e60) };
        let has_table = (T::constant(least) <= j) & (j <= T::constant(most));
        // Zero lies in no table.
        Self { per_load_integral: if has_table { per_unit / j } else { T::zero() }, per_unit }
    }

    /// y/j, how many whole periods it is above 1, and how many octaves above these.
    #[inline(always)]
    fn reduced(self, load_integral: T) -> (T, i32, i32) {
        let ratio = load_integral * self.per_load_integral;
        let octaves = (exponent(ratio) as u32).wrapping_add(PERIODS_BELOW * K);
        let periods = octaves / K;
        (ratio, periods.wrapping_sub(PERIODS_BELOW) as i32, octaves.wrapping_sub(periods * K) as i32)
    }
}

impl<T: Scalar, const K: u32, const Q: i32> Units<T> for SingleTerm<T, K, Q> {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        let (least, most) = if is::<T, f32>() { (1e-12, 1e12) } else { (1e-80, 1e80) };
        let (ratio, _, octaves) = self.reduced(load_integral);
        let has_place = (T::constant(least) <= load_integral)
            & (load_integral <= T::constant(most))
            & (ratio > T::zero());
        if has_place { fraction(ratio) * power_of_two(octaves) } else { T::zero() }
    }

    #[inline(always)]
    fn of_geometry(self, radius: T, load_integral: T) -> T {
        let (_, periods, _) = self.reduced(load_integral);
        let radius = radius * power_of_two(periods * Q);
        if is::<T, f32>() { with_half_its_digits(radius) } else { radius }
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        Target::in_units(load_integral, self.per_unit)
    }
}
