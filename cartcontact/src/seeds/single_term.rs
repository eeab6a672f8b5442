//! The units in which one table holds all radii of J = j a^p, whatever j and the load integral are.
//!
//! With p = k/q in lowest terms, y/j = a^p multiplied by 2^k multiplies a by 2^q. So j is divided by a power of two until it
//! is between 1 and 2, and y until y/j is between 1 and 2^k; the radius is put back where it belongs at the end. That is
//! exact, so that no step leaves the format, and other units by powers of two change no digit.

use super::Target;
use super::units::Units;
use crate::Scalar;
use crate::evaluate::bits::{exponent, fraction, is_normal, power_of_two, with_half_its_digits};
use crate::scalar::is;

/// What is added to whole periods so that there is no number below them: no quotient is below 2⁻⁴⁰⁹⁶.
const PERIODS_BELOW: u32 = 4096;

/// Those of the term w C aᵖ with a weight w and p = `K`/`Q`.
#[derive(Clone, Copy, Debug)]
pub struct SingleTerm<T, const K: u32, const Q: i32> {
    /// 1/(w C) for the fraction of C, and the exponent of C.
    inverse: T,
    exponent: i32,
    per_unit: T,
}

impl<T: Scalar, const K: u32, const Q: i32> SingleTerm<T, K, Q> {
    /// With C in these units; `per_unit` is what load integrals are multiplied by, see `Target`.
    #[inline(always)]
    pub fn of([c]: [T; 1], weight: T, per_unit: T) -> (Self, [T; 1]) {
        let reduced = fraction(c);
        (Self { inverse: (weight * reduced).recip(), exponent: exponent(c), per_unit }, [reduced])
    }

    /// Y/(w C) as a fraction, how many whole periods it is above 1, and how many octaves above these, where
    /// Y = f · 2^`exponent` with 1 ≤ f < 2.
    #[inline(always)]
    fn quotient(self, (f, exponent_of_load): (T, i32)) -> (T, i32, i32) {
        let quotient = f * self.inverse;
        let octaves = exponent(quotient) + exponent_of_load - self.exponent;
        let above = (octaves as u32).wrapping_add(PERIODS_BELOW * K);
        let periods = above / K;
        (
            fraction(quotient),
            periods.wrapping_sub(PERIODS_BELOW) as i32,
            above.wrapping_sub(periods * K) as i32,
        )
    }

    #[inline(always)]
    fn in_units(self, load_integral: T) -> (Target<T>, i32) {
        let target = Target::in_units(load_integral, self.per_unit);
        let exponent = exponent(target.value);
        (target.fraction(exponent), exponent)
    }
}

impl<T: Scalar, const K: u32, const Q: i32> Units<T> for SingleTerm<T, K, Q> {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        let (target, exponent) = self.in_units(load_integral);
        let (quotient, _, octaves) = self.quotient((target.value, exponent));
        // With their signs set, exponents are none of normal numbers; zero lies in no table.
        let has_place = is_normal::<T>(exponent) & is_normal::<T>(self.exponent);
        if has_place { quotient * power_of_two(octaves) } else { T::zero() }
    }

    #[inline(always)]
    fn seed(self, radius: T) -> T {
        if is::<T, f32>() { with_half_its_digits(radius) } else { radius }
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        let (target, exponent) = self.in_units(load_integral);
        let (_, periods, _) = self.quotient((target.value, exponent));
        target.times(power_of_two(exponent - self.exponent - periods * K as i32))
    }

    #[inline(always)]
    fn of_geometry(self, radius: T, load_integral: T) -> T {
        let (target, exponent) = self.in_units(load_integral);
        let (_, periods, _) = self.quotient((target.value, exponent));
        radius * power_of_two(periods * Q)
    }
}
