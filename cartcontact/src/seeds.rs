//! The contact radius in one step, from a table that the macro has computed.
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
use crate::dispatch::wide;
use crate::profile::{RadiusError, check_lengths};
use crate::scalar::is;

/// How many radii are stepped to at once; their seeds stay in registers and the nearest cache.
const BLOCK: usize = 64;

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

/// What the table's load integrals and radii are multiplied by: 1 for the geometry that it was made for.
///
/// The tables of J = j aᵖ + j′ aᵖ′ are all the same one, that of xᵖ + xᵖ′, in units of the radius at which both terms
/// are equal and of the value that they have there.
#[derive(Clone, Copy, Debug)]
pub struct Scale<T> {
    radius: T,
    per_load_integral: T,
    /// The units are numbers of the geometry: they may be out of range or, for terms of different sign, not exist.
    is_given: bool,
}

impl<T: Scalar> Scale<T> {
    /// A table of the geometry's own.
    #[inline(always)]
    pub fn none() -> Self {
        Self { radius: T::one(), per_load_integral: T::one(), is_given: false }
    }

    /// Whether a step that began at `seed` ended at the radius.
    ///
    /// Seeds are good to six digits, so that a longer step can only begin at one from units out of range.
    #[inline(always)]
    fn confirms(&self, radius: T, seed: T) -> bool {
        !self.is_given | ((radius - seed).abs() <= seed * T::constant(1e-5))
    }
}

/// From the units of a table: a radius and a load integral.
impl<T: Scalar> From<(T, T)> for Scale<T> {
    #[inline(always)]
    fn from((radius, load_integral): (T, T)) -> Self {
        Self { radius, per_load_integral: load_integral.recip(), is_given: true }
    }
}

impl<const N: usize> Seeds<N> {
    /// The radius at which J is `load_integral`; none outside the table or beyond `limit`, and for other scalars
    /// than f32 and f64.
    #[inline(always)]
    pub fn radius<T: Scalar>(
        &self,
        load_integral: T,
        limit: T,
        scale: Scale<T>,
        evaluate: impl Fn(T) -> Steepness<T>,
    ) -> Option<T> {
        if !self.holds::<T>() {
            return None;
        }
        let (index, fraction) = self.place(load_integral * scale.per_load_integral);
        let seed = single::<T>(cubic(self.rows.get(index)?, fraction)) * scale.radius;
        let radius = evaluate(seed).step(seed, load_integral);
        // No comparison where the limit is infinite; and nothing here is NaN.
        let is_beyond = radius > limit;
        (!is_beyond && scale.confirms(radius, seed)).then_some(radius)
    }

    /// The radii of many load integrals; blocks that are not all in the table by `general`.
    ///
    /// # Errors
    ///
    /// The first of those of `general`, and if the slices differ in length.
    #[inline]
    pub fn radii<T: Scalar>(
        &self,
        (load_integrals, radii): (&[T], &mut [T]),
        limit: T,
        scale: Scale<T>,
        evaluate: impl Fn(T) -> Steepness<T>,
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        check_lengths(load_integrals, radii)?;
        let mut start = 0;
        while start < radii.len() {
            let (load_integrals, radii) = (&load_integrals[start..], &mut radii[start..]);
            let found = if self.holds::<T>() {
                wide(
                    #[inline(always)]
                    || self.leading_blocks(load_integrals, limit, scale, radii, &evaluate),
                )
            } else {
                0
            };
            let end = radii.len().min(found + BLOCK);
            for (radius, &load_integral) in radii[found..end].iter_mut().zip(&load_integrals[found..end]) {
                *radius = general(load_integral)?;
            }
            start += end;
        }
        Ok(())
    }

    /// The radii of the blocks before the first that is not all in the table, and how many they are.
    #[inline(always)]
    fn leading_blocks<T: Scalar>(
        &self,
        load_integrals: &[T],
        limit: T,
        scale: Scale<T>,
        radii: &mut [T],
        evaluate: impl Fn(T) -> Steepness<T>,
    ) -> usize {
        let mut found = 0;
        for (load_integrals, radii) in load_integrals.chunks(BLOCK).zip(radii.chunks_mut(BLOCK)) {
            if !self.block(load_integrals, limit, scale, radii, &evaluate) {
                break;
            }
            found += radii.len();
        }
        found
    }

    /// The radii of a block; false if one of them is not to be found in the table.
    ///
    /// Only copying the rows goes value by value; the loops before and after take several at once.
    #[inline(always)]
    fn block<T: Scalar>(
        &self,
        load_integrals: &[T],
        limit: T,
        scale: Scale<T>,
        radii: &mut [T],
        evaluate: impl Fn(T) -> Steepness<T>,
    ) -> bool {
        let mut found = true;
        let (mut indices, mut fractions) = ([0; BLOCK], [0; BLOCK]);
        for ((index, fraction), &load_integral) in indices.iter_mut().zip(&mut fractions).zip(load_integrals)
        {
            (*index, *fraction) = self.place(load_integral * scale.per_load_integral);
            found &= *index < N;
            *index = (*index).min(N - 1);
        }
        let rows = indices.map(|index| self.rows[index]);
        let mut seeds = [0.0; BLOCK];
        for ((seed, row), &fraction) in seeds.iter_mut().zip(&rows).zip(&fractions) {
            *seed = cubic(row, fraction);
        }
        for ((radius, &load_integral), &seed) in radii.iter_mut().zip(load_integrals).zip(&seeds) {
            let seed = single::<T>(seed) * scale.radius;
            *radius = evaluate(seed).step(seed, load_integral);
            let is_beyond = *radius > limit;
            found &= !is_beyond & scale.confirms(*radius, seed);
        }
        found
    }

    fn holds<T: Scalar>(&self) -> bool {
        is::<T, f64>() || (is::<T, f32>() && self.single)
    }

    /// The index of the row, and the fraction of the load integral as the last 23 bits.
    ///
    /// The index is made of the exponent and two digits of the fraction. Too small for the table, or with the sign
    /// set, they become an index that is too large.
    #[inline(always)]
    fn place<T: Scalar>(&self, load_integral: T) -> (usize, u32) {
        let any: &dyn Any = &load_integral;
        let (index, bias, fraction) = match any.downcast_ref::<f32>() {
            Some(single) => (single.to_bits() >> 21, 127, single.to_bits()),
            None => {
                let bits = load_integral.value().to_bits();
                ((bits >> 50) as u32, 1023, (bits >> 29) as u32)
            }
        };
        ((index as usize).wrapping_sub((4 * bias + self.first) as usize), fraction)
    }
}

/// The cubic at 1 plus the last 23 bits as a fraction.
#[inline(always)]
fn cubic(row: &[f32; 4], fraction: u32) -> f32 {
    let u = f32::from_bits(fraction & 0x007f_ffff | 0x3f80_0000);
    (row[0] + row[1] * u) + (row[2] + row[3] * u) * (u * u)
}

#[inline(always)]
fn single<T: Scalar>(value: f32) -> T {
    <T as SupersetOf<f32>>::from_subset(&value)
}

impl<T: Scalar> Steepness<T> {
    #[inline(always)]
    fn surplus(&self, load_integral: T) -> T {
        self.power * self.value - load_integral * self.per_unit
    }

    /// The radius from its seed.
    #[inline(always)]
    fn step(self, seed: T, load_integral: T) -> T {
        if is::<T, f32>() { self.newton(seed, load_integral) } else { self.halley(seed, load_integral) }
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
