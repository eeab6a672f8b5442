//! The units in which one table holds all radii of J = j a^p, whatever j and the load integral are.
//!
//! With p = k/q in lowest terms, y/j = a^p multiplied by 2^k multiplies a by 2^q. So j is divided by a power of two until it
//! is between 1 and 2, and y until y/j is between 1 and 2^k; the radius is put back where it belongs at the end. That is
//! exact, so that no step leaves the format, and other units by powers of two change no digit.

use super::Target;
use super::units::Units;
use crate::Scalar;
use crate::evaluate::bits::{exponent, fraction, is_normal, power_of_two};

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

    /// A load integral in these units, and where its radius lies in the table.
    #[inline(always)]
    fn place(self, load_integral: T) -> Place<T> {
        let target = Target::in_units(load_integral, self.per_unit);
        let exponent_of_load = exponent(target.value);
        let target = target.fraction(exponent_of_load);
        let quotient = target.value * self.inverse;
        let octaves = exponent(quotient) + exponent_of_load - self.exponent;
        let above = (octaves as u32).wrapping_add(PERIODS_BELOW * K);
        let periods = above / K;
        Place {
            target,
            exponent: exponent_of_load,
            quotient: fraction(quotient),
            periods: periods.wrapping_sub(PERIODS_BELOW) as i32,
            octaves: above.wrapping_sub(periods * K) as i32,
        }
    }
}

/// Y = `target` · 2^`exponent` and Y/(w C) = `quotient` · 2^(`octaves` + K `periods`), with fractions from 1 to 2 and fewer
/// octaves than K.
struct Place<T> {
    target: Target<T>,
    exponent: i32,
    quotient: T,
    periods: i32,
    octaves: i32,
}

impl<T: Scalar, const K: u32, const Q: i32> Units<T> for SingleTerm<T, K, Q> {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        let Place { exponent, quotient, octaves, .. } = self.place(load_integral);
        // With their signs set, exponents are none of normal numbers; zero lies in no table.
        let has_place = is_normal::<T>(exponent) & is_normal::<T>(self.exponent);
        if has_place { quotient * power_of_two(octaves) } else { T::zero() }
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        let Place { target, exponent, periods, .. } = self.place(load_integral);
        target.times(power_of_two(exponent - self.exponent - periods * K as i32))
    }

    #[inline(always)]
    fn of_geometry(self, radius: T, load_integral: T) -> T {
        radius * power_of_two(self.place(load_integral).periods * Q)
    }
}
