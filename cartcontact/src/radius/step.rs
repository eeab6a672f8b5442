//! Halley's step from a seed to the contact radius.
//!
//! ```text
//! a ← a − a f aJ′/((aJ′)² − f a²J″/2),    f = J(a) − y
//! ```
//!
//! leaves |C| e³ of a relative error e, where C = (a J″/2J′)² − a² J‴/6J′. Rounding errors come only from J, whose
//! error is divided by p = a J′/J > 4, and from the last subtraction.

use crate::Scalar;
use crate::evaluate::halved::product_with_few_digits;
use crate::evaluate::steepness::Steepness;

/// The value that J has to reach: a number rounded from a product, and what it lacks of that product.
///
/// With symbols, J is multiplied by the common denominator of its weights C n/((n+2)(n+4)), divided by a power of two
/// so that it is less than 2. The remaining weights have few digits, often one, and so has the factor: its product with
/// the load integral loses nothing.
#[derive(Clone, Copy, Debug)]
pub struct Target<T> {
    pub(super) value: T,
    pub(super) rest: T,
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
    /// The radius from its seed.
    #[inline(always)]
    pub(super) fn halley(self, a: T, target: Target<T>) -> T {
        a - self.step(a, target)
    }

    /// How much a seed exceeds the radius.
    #[inline(always)]
    pub(super) fn step(self, a: T, target: Target<T>) -> T {
        self.step_of(self.surplus(target), a)
    }

    /// The share of itself by which a seed of a high power exceeds the radius, to third order.
    ///
    /// For J ~ a^p, C is (p² − 1)/12, and e nearly f/(p J): Halley's step leaves e (f/J)²/12.
    #[inline(always)]
    pub(super) fn share_of_high_power(self, target: Target<T>) -> T {
        let surplus = self.surplus(target);
        let share = surplus * target.value.recip();
        self.step_of(surplus, T::one()) * (T::one() + T::constant(1.0 / 12.0) * share * share)
    }

    /// How much J is too large at the seed.
    #[inline(always)]
    fn surplus(self, target: Target<T>) -> T {
        // Differences instead of sums: the subtraction of a constant zero takes no instruction.
        ((self.power * self.value - target.value) - self.excess) - target.rest
    }

    #[inline(always)]
    fn step_of(self, surplus: T, a: T) -> T {
        // Factors that do not need the surplus are multiplied while it is formed, and none after the division.
        let steep = self.power * self.first * self.first - surplus * self.half_second;
        (a * self.per_unit * self.first) * surplus / steep
    }
}
