//! Halley's step from a seed to the contact radius.
//!
//! ```text
//! a ← a − a f aJ′/((aJ′)² − f a²J″/2),    f = J(a) − y
//! ```
//!
//! leaves |C| e³ of a relative error e, where C = (a J″/2J′)² − a² J‴/6J′. Rounding errors come only from J, whose
//! error is divided by p = a J′/J > 4, and from the last subtraction.
//!
//! **Derivatives.** Where numbers carry some, the step is taken for the value alone. From the radius without derivatives
//! then follow steps a ← a − a (J(a) − y)/aJ′ with aJ′ a plain number: each adds the derivatives of one more order.
//! Nothing is divided by a number with derivatives: the square of that could leave the format. They have no error but
//! rounding, as the radius has none; but J′ multiplies the rounding of the radius by p − 1, and up to twenty times as much
//! where the step finds a root of it. So y is taken times a plain number next to 1 that makes it J of the rounded radius,
//! which leaves da/a = (dy/y) J/aJ′, and J/aJ′ hardly depends on the radius.

use crate::Scalar;
use crate::evaluate::power::integer_power;
use crate::evaluate::steepness::Steepness;
use crate::numbers::halved::{Halved, product_with_few_digits};
use crate::scalar::{has_no_derivatives, highest_derivative, with_value, without_derivatives};

/// The place at which J reaches y, with derivatives, from its value. The function gives J − y and 1/(x J′), of which only
/// the value counts.
#[inline(always)]
pub(super) fn with_derivatives<T: Scalar>(value: T, y: T, function: impl Fn(T) -> (T, T)) -> T {
    let value = without_derivatives(value);
    let (surplus, inverse_slope) = function(value);
    let rounding = y * without_derivatives(surplus / y);
    let share = without_derivatives(inverse_slope * value);
    let mut root = with_value(value, (rounding - surplus) * share);
    for _ in 1..highest_derivative::<T>() {
        root = with_value(value, root + (rounding - function(root).0) * share);
    }
    root
}

/// The radius from a seed of its `Q`-th root, where J has whole powers of that.
#[inline(always)]
pub(super) fn radius_from_root<T: Scalar, const Q: u32>(
    seed: T,
    target: Target<T>,
    evaluate: impl Fn(T) -> Steepness<T>,
) -> T {
    let steepness = evaluate(seed);
    let radius = steepness.radius_from_root::<Q>(seed, target);
    if has_no_derivatives::<T>() {
        return radius;
    }
    let root = with_derivatives(
        steepness.root::<Q>(seed, target),
        target.value,
        #[inline(always)]
        |x| {
            let steepness = evaluate(x);
            (steepness.surplus(target), steepness.inverse_slope())
        },
    );
    // Here, too, only the share counts: the power multiplies the rounding of the root by `Q` − 1.
    let power = integer_power(root, Q);
    with_value(radius, power * without_derivatives(radius / power))
}

/// The value that J has to reach: a number rounded from a product, and what it lacks of that product.
///
/// Where coefficients depend on fields, J is multiplied by the common `denominator` of its weights n/((n+2)(n+4)),
/// divided by a power of two so that it is less than 2. The remaining weights have few digits, often one, and so has the
/// denominator: its product with the load integral loses nothing.
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
    pub(super) fn times_denominator(load_integral: T, denominator: T) -> Self {
        let (value, rest) = product_with_few_digits(load_integral, denominator);
        Self { value, rest }
    }
}

impl<T: Scalar> Steepness<T> {
    /// The radius from its seed.
    #[inline(always)]
    pub(super) fn halley(self, a: T, target: Target<T>) -> T {
        a - self.step(a, target)
    }

    /// The radius from the seed of its `Q`-th root x, where J has whole powers of that.
    ///
    /// As exact as the root less its step: the power of the seed is exact or comes with what it lacks, and what is
    /// subtracted is small. The square is exact if the seed has half its digits.
    #[inline(always)]
    pub(super) fn radius_from_root<const Q: u32>(self, seed: T, target: Target<T>) -> T {
        match Q {
            1 => self.halley(seed, target),
            2 => {
                let step = self.step(seed, target);
                seed * seed - step * (seed + (seed - step))
            }
            _ => {
                let e = self.share_of_high_power(target);
                // 1 − (1 − e)^Q up to the fourth power of Q e, with e ≤ 10⁻⁶, by the ratios (Q − k)/(k + 1) of
                // neighbouring binomial coefficients.
                let ratio = |k: u32| T::constant(f64::from(Q.saturating_sub(k)) / f64::from(k + 1)) * e;
                let share = ratio(0) * (T::one() - ratio(1) * (T::one() - ratio(2) * (T::one() - ratio(3))));
                let seed = Halved::of(seed);
                let (power, lost) = seed.whole_power::<Q>(seed.square()).word_and_lost();
                power - (power * share - lost)
            }
        }
    }

    /// The `Q`-th root of the radius from its seed.
    #[inline(always)]
    fn root<const Q: u32>(self, seed: T, target: Target<T>) -> T {
        if Q > 2 { seed - seed * self.share_of_high_power(target) } else { self.halley(seed, target) }
    }

    /// 1/aJ′.
    #[inline(always)]
    fn inverse_slope(self) -> T {
        let [power, first, per_unit] = [self.power, self.first, self.per_unit].map(without_derivatives);
        per_unit / (power * first)
    }

    /// How much a seed exceeds the radius.
    #[inline(always)]
    fn step(self, a: T, target: Target<T>) -> T {
        self.step_of(self.surplus(target), a)
    }

    /// The share of itself by which a seed of a high power exceeds the radius, to third order.
    ///
    /// For J ~ a^p, C is (p² − 1)/12, and e nearly f/(p J): Halley's step leaves e (f/J)²/12.
    #[inline(always)]
    fn share_of_high_power(self, target: Target<T>) -> T {
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
