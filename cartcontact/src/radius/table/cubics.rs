//! Seeds from a table of cubics in the fraction of the load integral, and one step from each.

use super::units::Units;
use super::{Row, Step, Table};
use crate::Scalar;
use crate::evaluate::steepness::Steepness;
use crate::numbers::bits::fraction;
use crate::profile::RadiusError;
use crate::scalar::from_single;

impl Table {
    /// `Table::find` by Halley's step from a cubic.
    #[inline(always)]
    pub fn radius<T: Scalar>(
        &self,
        load_integral: T,
        limit: T,
        units: impl Units<T>,
        evaluate: impl Fn(T) -> Steepness<T> + Copy,
    ) -> Option<T> {
        self.find(load_integral, limit, Halley { units, evaluate })
    }

    /// `Table::find_all` by Halley's step from a cubic.
    ///
    /// # Errors
    ///
    /// As `Table::find_all`.
    #[inline]
    pub fn radii<T: Scalar>(
        &self,
        values: (&[T], &mut [T]),
        limit: T,
        units: impl Units<T>,
        evaluate: impl Fn(T) -> Steepness<T> + Copy,
        solve: impl Fn(T, u32) -> (T, bool),
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        self.find_all(values, limit, Halley { units, evaluate }, solve, general)
    }
}

/// Halley's step in some units, with a function that evaluates J.
#[derive(Clone, Copy)]
struct Halley<U, F> {
    units: U,
    evaluate: F,
}

impl<T: Scalar, U: Units<T>, F: Fn(T) -> Steepness<T> + Copy> Step<T> for Halley<U, F> {
    type Start = f32;
    const HAS_DERIVATIVES: bool = true;

    #[inline(always)]
    fn in_table(self, load_integral: T) -> (T, i32) {
        (self.units.in_table(load_integral), 0)
    }

    /// The cubic c₀ + c₁ f + c₂ f² + c₃ f³ where f is 1 plus the last 23 bits as a fraction. A row has the order c₀,
    /// c₂, c₁, c₃.
    #[inline(always)]
    fn start(self, row: &Row, digits: u32, _periods: i32) -> f32 {
        let f = fraction(f32::from_bits(digits));
        (row.at(0) + row.at(2) * f) + (row.at(1) + row.at(3) * f) * (f * f)
    }

    #[inline(always)]
    fn radius(self, _row: &Row, start: f32, load_integral: T) -> T {
        let seed = self.units.seed(from_single(start));
        self.units.radius(seed, self.units.target(load_integral), self.evaluate)
    }
}
