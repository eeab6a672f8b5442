//! The contact radius without a table: from the leading term of J, for positive coefficients of any size.
//!
//! **The start.** The term j a^p alone has the radius (y/j)^(1/p). Where N terms add up to y, the root lies between the
//! least of these radii and N^(−1/p₁) times it, with p₁ the lowest power. The start is the least radius divided by
//! 2^(1/(2 p₁)), so that neither end is far. Logarithms are read from the bits of numbers. They are at most 0.09 less
//! than log₂ x, and this error is divided by p > 4.
//!
//! **The steps.** The first is one of Newton's on logarithms, see [`newton`](super::newton). It leaves v/(2 p) times
//! the square of the error, where v is the variance of the powers about their mean p, weighted by their terms; between
//! p₁ and the highest power p₂ that factor is at most (√p₂ − √p₁)²/2. Halley's steps follow. Each leaves
//! (p² − 1 − 2 v)/12 < p₂²/12 times the cube of the error, weighted here by the terms of a J′. If the last step but one
//! changed a by less than 0.05/p₂, it leaves less than 1.1 · 10⁻⁵/p₂, and the last leaves 10⁻¹⁶/p₂ < ε/8; in single
//! precision the same holds for 0.4/p₂. Roots that did not come that near, mostly where three or more terms are of
//! similar size, are solved again with [`MORE_STEPS`], out of line. If that fails, too, or gives NaN, they are left to
//! the general solution.
//!
//! **Accuracy.** The last step starts from a number with half the digits. Its square is exact; the rounding error of
//! another square would be multiplied in every power. Dropping digits changes a by 2⁻²⁵, or 2⁻¹² in single precision,
//! which the step corrects: of 2⁻¹² it leaves ε/8 with p₂ = 110. Powers above 100 in single precision, and above 600 in
//! double precision, are left to the general solution. The correction is small and subtracted directly, so that no
//! other rounding is of the size of 1/2 ulp. Where powers are not whole, or are those of a root, J has more digits in
//! this step, see [`steepness`](crate::evaluate::steepness); with whole powers up to seven roundings are divided by
//! p ≥ 5.

use super::halley::Target;
use crate::Scalar;
use crate::evaluate::steepness::Steepness;
use crate::numbers::bits::{
    LOGARITHM_DIGITS, bias, log2_digits, nearest_integer, one_and_digits, with_half_its_digits,
};
use crate::scalar::{floor, is_single};

/// Added to logarithms, whole numbers over p, before they are rounded. Hardly any then lies so near the midpoint of two
/// integers that its own rounding error, which depends on the units, decides.
const OFF_MIDDLE: f64 = 0.013;

/// How many of Halley's steps a second attempt takes beyond those of the first.
pub(super) const MORE_STEPS: u32 = 2;

/// The start a = `fraction` · 2^`octave`, 1 ≤ `fraction` < 2.
pub(super) struct Start<T> {
    pub(super) octave: i32,
    pub(super) fraction: T,
}

impl<T: Scalar> Start<T> {
    /// From the lowest power and the least of the logarithms of the radii that the terms have alone. A change of units
    /// by a power of two changes only its octave.
    #[inline(always)]
    pub(super) fn of(lowest: T, least: T) -> Self {
        let half_octave = T::constant(f64::from(1 << (LOGARITHM_DIGITS - 1))) / lowest;
        let base = T::constant(f64::from((bias::<T>() << LOGARITHM_DIGITS) - floor(half_octave)))
            + T::constant(OFF_MIDDLE);
        let (_, place) = nearest_integer(least + base);
        // 2^(u−1) by a parabola through both ends of the octave, within 0.32 %.
        let u = one_and_digits::<T>(place);
        let fraction = (T::constant(0.6870) - u * T::constant(0.0305)) + (u * T::constant(0.3435)) * u;
        Self { octave: (place >> LOGARITHM_DIGITS) - bias::<T>(), fraction }
    }
}

/// The logarithm of the radius of the term (j, p) alone, from the logarithm of y.
#[inline(always)]
pub(super) fn logarithm_alone<T: Scalar>(logarithm_of_y: T, (j, p): (T, T)) -> T {
    (logarithm_of_y - log2_digits(j)) * p.recip()
}

/// The range of the powers of J.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spread<T> {
    pub(super) lowest: T,
    pub(super) highest: T,
}

impl<T: Scalar> Spread<T> {
    /// How many of Halley's steps usually suffice, counted for random sums of two to ten terms with coefficients of any
    /// size. Fewer than one in a thousand needs more while the ratio of the powers is below 9; at 14 it is one in five.
    /// Terms that are equal at some radius need one more in a band around it.
    #[inline(always)]
    fn steps(self) -> u32 {
        let is_within = |ratio: f64| self.highest <= T::constant(ratio) * self.lowest;
        if is_within(2.0) {
            1
        } else if is_within(6.0) {
            2
        } else {
            3
        }
    }

    /// The radius from the root of J(a) = y, 1 ≤ y < 4, near `start`, and whether the steps have come near it. All steps
    /// but the last take `evaluate`; `more` is the number of extra steps.
    ///
    /// `evaluate` has derivatives in the unit u = 1: the first step takes them as they are.
    #[inline(always)]
    pub(super) fn radius(
        self,
        more: u32,
        y: T,
        start: T,
        evaluate: impl Fn(T) -> Steepness<T>,
        last_step: impl Fn(T) -> T,
    ) -> (T, bool) {
        let at = evaluate(start);
        debug_assert!(at.per_unit.value() == 1.0, "derivatives in units of their own");
        let value = at.power * at.value;
        let (near, far) = (at.value * (value - y), at.first * (value + y));
        let mut a = start * ((far - near) / (far + near));
        let mut is_near = true;
        let close = T::constant(if is_single::<T>() { 0.4 } else { 0.05 }) / self.highest;
        for _ in 0..self.steps() + more {
            let next = evaluate(a).halley(a, Target::of(y));
            is_near = (next - a).abs() <= a * close;
            a = next;
        }
        (last_step(with_half_its_digits(a)), is_near)
    }
}
