//! One step of Halley's method from a seed: a cubic in the fraction of the load integral.

use super::table::{Row, Step, Table, single};
use super::units::Units;
use crate::Scalar;
use crate::evaluate::bits::{exponent, power_of_two};
use crate::evaluate::halved::product_with_few_digits;
use crate::profile::RadiusError;

/// What J has to be: a number, and what it lacks of a product that it was rounded from.
///
/// Of symbols, J is multiplied by the common denominator of its weights C n/((n+2)(n+4)), divided by a power of two so that
/// it is less than 2. What is left of the weights has few digits, often one, and so has the factor: of its product with the
/// load integral nothing is lost.
#[derive(Clone, Copy, Debug)]
pub struct Target<T> {
    pub(super) value: T,
    pub(super) rest: T,
}

/// J and its derivatives at a radius, divided by the lowest power a^k of J; the derivatives in units of a number j p, that
/// the highest power of a J′ may be free of a coefficient.
#[derive(Clone, Copy, Debug)]
pub struct Steepness<T> {
    /// a^k.
    pub power: T,
    /// J.
    pub value: T,
    /// How much a^k J is too large, where that is known.
    pub excess: T,
    /// a J′/(j p).
    pub first: T,
    /// a² J″/(2 j² p²).
    pub half_second: T,
    /// 1/(j p).
    pub per_unit: T,
}

impl Table {
    /// The radius at which J is `load_integral`; none outside the table or beyond `limit`, and for other scalars
    /// than f32 and f64.
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

    /// The radii of many load integrals; blocks that are not all in the table, and few, by `general`.
    ///
    /// # Errors
    ///
    /// The first of those of `general`, and if the slices differ in length.
    #[inline]
    pub fn radii<T: Scalar>(
        &self,
        values: (&[T], &mut [T]),
        limit: T,
        units: impl Units<T>,
        evaluate: impl Fn(T) -> Steepness<T> + Copy,
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        self.find_all(values, limit, Halley { units, evaluate }, general)
    }
}

/// The step, in some units, with a function that evaluates J.
#[derive(Clone, Copy)]
struct Halley<U, F> {
    units: U,
    evaluate: F,
}

impl<T: Scalar, U: Units<T>, F: Fn(T) -> Steepness<T> + Copy> Step<T> for Halley<U, F> {
    type Start = f32;

    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        self.units.in_table(load_integral)
    }

    /// The cubic c₀ + c₁ u + c₂ u² + c₃ u³ at 1 plus the last 23 bits as a fraction, from a row of c₀, c₂, c₁ and c₃.
    #[inline(always)]
    fn start(row: &Row, digits: u32) -> f32 {
        let u = f32::from_bits(digits & 0x007f_ffff | 0x3f80_0000);
        (row.at(0) + row.at(2) * u) + (row.at(1) + row.at(3) * u) * (u * u)
    }

    #[inline(always)]
    fn radius(self, _row: &Row, start: f32, load_integral: T) -> T {
        let seed = self.units.seed(single(start));
        self.units.radius(seed, (self.evaluate)(seed).step(seed, self.units.target(load_integral)))
    }
}

impl<T: Scalar> Target<T> {
    #[inline(always)]
    pub(super) fn of(value: T) -> Self {
        Self { value, rest: T::zero() }
    }

    #[inline(always)]
    pub(super) fn in_units(load_integral: T, per_unit: T) -> Self {
        let (value, rest) = product_with_few_digits(load_integral, per_unit);
        Self { value, rest }
    }
}

impl<T: Scalar> Steepness<T> {
    /// That of no terms at all, in units of 1.
    #[inline(always)]
    pub(crate) fn of_nothing() -> Self {
        let (zero, one) = (T::zero(), T::one());
        Self { power: one, value: zero, excess: zero, first: zero, half_second: zero, per_unit: one }
    }

    /// Adds the derivatives of a term of the power p.
    #[inline(always)]
    pub(crate) fn add_derivatives(&mut self, term: T, p: T) {
        let (first, half) = (p * term, T::constant(0.5));
        self.first += first;
        self.half_second += half * (p - T::one()) * first;
    }

    /// With derivatives in units of the power of two at a J′, whose square single precision may not hold.
    #[inline(always)]
    pub(crate) fn in_units_of_its_slope(self) -> Self {
        let per_unit = power_of_two(-exponent(self.first));
        let (first, half_second) = (self.first * per_unit, self.half_second * per_unit * per_unit);
        Self { first, half_second, per_unit, ..self }
    }

    /// The radius from its seed.
    #[inline(always)]
    pub(super) fn halley(self, a: T, target: Target<T>) -> T {
        a - self.step(a, target)
    }

    /// What a seed exceeds the radius by.
    #[inline(always)]
    fn step(self, a: T, target: Target<T>) -> T {
        // Differences instead of sums, as a zero that is taken away takes no instruction.
        let surplus = ((self.power * self.value - target.value) - self.excess) - target.rest;
        // What needs no surplus is multiplied while that is formed, and nothing after the division.
        let steep = self.power * self.first * self.first - surplus * self.half_second;
        (a * self.per_unit * self.first) * surplus / steep
    }
}
