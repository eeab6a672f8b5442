//! The contact radius of a constant geometry in one step, from a table that the macro has computed.
//!
//! A row of the table is a cubic in the fraction of the load integral y that meets the radius to six digits.
//! From there one step of Halley's method reaches the last bit of double precision,
//!
//! ```text
//! a ← a − a f aJ′/((aJ′)² − f a²J″/2),    f = J(a) − y
//! ```
//!
//! and one of Newton's that of single precision. The macro has checked what the step leaves at every row: less
//! than ε/8. J itself, whose error is divided by p = a J′/J > 4, and the last subtraction round.
//!
//! What lies outside the table, be it zero, not a number, or beyond the range, is left to the general solution:
//! one comparison finds all of it.

use core::any::Any;

use simba::scalar::SupersetOf;

use crate::Scalar;
use crate::scalar::is;

/// a(y) ≈ Σ rows\[k\]\[i\] uⁱ with y = u · 2^e, 1 ≤ u < 2, and k = 4 e + ⌊4 (u − 1)⌋ − `first`.
#[derive(Debug)]
pub struct Seeds<const N: usize> {
    /// 4 e of the first octave, plus its quarter.
    pub first: i32,
    /// Whether single precision holds all y, and all powers of a, up to 2^±100.
    pub single: bool,
    /// Cubics in ascending powers.
    pub rows: [[f32; 4]; N],
}

/// J and its derivatives at a radius in units of its highest power a^p, all divided by their lowest power a^k.
#[derive(Clone, Copy, Debug)]
pub struct Steepness<T> {
    /// a^k.
    pub power: T,
    /// J.
    pub value: T,
    /// a J′/p.
    pub first: T,
    /// a² J″/(2 p²).
    pub half_second: T,
    /// 1 over the coefficient of a^p.
    pub per_unit: T,
    /// 1/p.
    pub per_degree: T,
}

impl<const N: usize> Seeds<N> {
    /// The radius at which J is `load_integral`; none outside the table or beyond `limit`, and for other scalars
    /// than f32 and f64.
    #[inline(always)]
    pub fn radius<T: Scalar>(
        &self,
        load_integral: T,
        limit: T,
        evaluate: impl Fn(T) -> Steepness<T>,
    ) -> Option<T> {
        let radius = if is::<T, f64>() {
            let seed = T::constant(self.of_double(load_integral.value())?);
            evaluate(seed).halley(seed, load_integral)
        } else {
            let any: &dyn Any = &load_integral;
            if !self.single {
                return None;
            }
            let seed = <T as SupersetOf<f32>>::from_subset(&self.of_single(*any.downcast_ref()?)?);
            evaluate(seed).newton(seed, load_integral)
        };
        (radius <= limit).then_some(radius)
    }

    #[inline(always)]
    fn of_double(&self, y: f64) -> Option<f64> {
        let bits = y.to_bits();
        // The exponent and two digits of the fraction: too small for the table, or with the sign set, they become
        // an index that is too large.
        let index = ((bits >> 50) as usize).wrapping_sub((4 * 1023 + self.first) as usize);
        Some(f64::from(cubic(self.rows.get(index)?, (bits >> 29) as u32)))
    }

    #[inline(always)]
    fn of_single(&self, y: f32) -> Option<f32> {
        let bits = y.to_bits();
        let index = ((bits >> 21) as usize).wrapping_sub((4 * 127 + self.first) as usize);
        Some(cubic(self.rows.get(index)?, bits))
    }
}

/// The cubic at 1 plus the last 23 bits as a fraction.
#[inline(always)]
fn cubic(row: &[f32; 4], fraction: u32) -> f32 {
    let u = f32::from_bits(fraction & 0x007f_ffff | 0x3f80_0000);
    row[0] + u * (row[1] + u * (row[2] + u * row[3]))
}

impl<T: Scalar> Steepness<T> {
    #[inline(always)]
    fn surplus(&self, load_integral: T) -> T {
        self.power * self.value - load_integral * self.per_unit
    }

    #[inline(always)]
    fn halley(self, a: T, load_integral: T) -> T {
        let surplus = self.surplus(load_integral);
        let steep = self.power * self.first * self.first - surplus * self.half_second;
        a - (a * self.per_degree) * (surplus * self.first / steep)
    }

    #[inline(always)]
    fn newton(self, a: T, load_integral: T) -> T {
        a - (a * self.per_degree) * (self.surplus(load_integral) / (self.power * self.first))
    }
}

/// The general solution, out of the way of the step from the table.
#[cold]
#[inline(never)]
pub fn elsewhere<R>(solve: impl FnOnce() -> R) -> R {
    solve()
}
