//! The contact radius in one step, from a table that the macro has computed.
//!
//! A row of the table is a cubic in the fraction of the load integral y that meets the radius to six digits.
//! From there one step of Halley's method reaches the last bit,
//!
//! ```text
//! a ← a − a f aJ′/((aJ′)² − f a²J″/2),    f = J(a) − y
//! ```
//!
//! in single precision, too, where the seed is cut to half its digits first, so that its square is exact in both. The macro
//! has checked what the step leaves at every row: less than ε/8. J itself, whose error is divided by p = a J′/J > 4, and the
//! last subtraction round. Symbols have few digits for weights, see [`Target`], so that they round no more than constants.
//! Of five million random radii each of eleven geometries with whole powers, fewer than one in a million was off by more than
//! 1 ulp, and 5 in single precision; 15 where the gap begins with r, whose p is the least, by 1.16 at the most. Of two million
//! of r^1.5 and r^2.5, whose root rounds, too, 18 and 68 in a million were, by 1.21 at the most.
//!
//! What lies outside the table, be it zero, not a number, or beyond the range, is left to the general solution:
//! one comparison finds all of it.

mod blocks;
mod leading_term;
mod single_term;
mod units;
mod whole_powers;

use core::any::Any;

use simba::scalar::SupersetOf;

pub use leading_term::radius_of_real_powers;
pub use single_term::SingleTerm;
use units::Units;
pub use units::{EqualTerms, OwnUnits};
pub use whole_powers::{WholePowers, radii_of_whole_powers};

use crate::Scalar;
use crate::evaluate::bits::{fraction, power_of_two};
use crate::evaluate::halved::product_with_few_digits;
use crate::scalar::is;

/// a(y) ≈ c₀ + c₁ u + c₂ u² + c₃ u³ with y = u · 2^e, 1 ≤ u < 2, for quarters of octaves k = 4 e + ⌊4 (u − 1)⌋.
#[derive(Debug)]
pub struct Seeds {
    /// The first k of the table.
    pub first: i32,
    /// How many there are, at most 256.
    pub count: u32,
    /// Whether single precision holds all y, and all powers of a, up to 2^±100.
    pub single: bool,
    /// The row of k at k − 4 modulo 256.
    ///
    /// That is the number in eight bits of y, six of its exponent and two of its fraction: the row that they name needs
    /// no check of bounds.
    pub rows: Rows,
}

/// 256 rows, as bytes: one literal for the compiler to read, instead of a thousand. None lies in two lines of a cache.
#[derive(Debug)]
#[repr(align(16))]
pub struct Rows(pub [u8; 4096]);

/// c₀, c₂, c₁ and c₃ in single precision, the low byte first.
type Row = [u8; 16];

/// What J has to be: a number, and what it lacks of a product that it was rounded from.
///
/// Of symbols, J is multiplied by the common denominator of its weights C n/((n+2)(n+4)), divided by a power of two so that
/// it is less than 2. What is left of the weights has few digits, often one, and so has the factor: of its product with the
/// load integral nothing is lost.
#[derive(Clone, Copy, Debug)]
pub struct Target<T> {
    value: T,
    rest: T,
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

impl Seeds {
    /// The radius at which J is `load_integral`; none outside the table or beyond `limit`, and for other scalars
    /// than f32 and f64.
    #[inline(always)]
    pub fn radius<T: Scalar>(
        &self,
        load_integral: T,
        limit: T,
        units: impl Units<T>,
        evaluate: impl Fn(T) -> Steepness<T>,
    ) -> Option<T> {
        let y = units.in_table(load_integral);
        if !(self.holds::<T>() && self.contains(y)) {
            return None;
        }
        let digits = digits(y);
        let seed = units.seed(single(cubic(self.row(digits), digits)));
        let stepped = evaluate(seed).halley(seed, units.target(load_integral));
        let radius = units.of_geometry(stepped, load_integral);
        // No comparison where the limit is infinite at compile time, and one where it is none; it may not be a number.
        let is_within = radius <= limit || limit == T::infinity();
        is_within.then_some(radius)
    }

    fn holds<T: Scalar>(&self) -> bool {
        is::<T, f64>() || (is::<T, f32>() && self.single)
    }

    /// Too small for the table, or with the sign set, y becomes an index that is too large.
    #[inline(always)]
    fn contains<T: Scalar>(&self, y: T) -> bool {
        let any: &dyn Any = &y;
        let (quarter, bias) = match any.downcast_ref::<f32>() {
            Some(single) => (single.to_bits() >> 21, 127),
            None => ((y.value().to_bits() >> 50) as u32, 1023),
        };
        quarter.wrapping_sub((4 * bias + self.first) as u32) < self.count
    }

    /// The load integrals at both ends.
    fn ends<T: Scalar>(&self) -> [T; 2] {
        let quarter = |k: i32| T::constant(f64::from_bits(((4 * 1023 + k) as u64) << 50));
        [self.first, self.first + self.count as i32].map(quarter)
    }

    #[inline(always)]
    fn row(&self, digits: u32) -> &Row {
        let (rows, _) = self.rows.0.as_chunks();
        &rows[usize::from((digits >> 21) as u8)]
    }
}

/// 23 bits of the fraction of y, and above them the last of its exponent.
#[inline(always)]
fn digits<T: Scalar>(y: T) -> u32 {
    let any: &dyn Any = &y;
    any.downcast_ref::<f32>().map_or_else(|| (y.value().to_bits() >> 29) as u32, |single| single.to_bits())
}

/// The cubic at 1 plus the last 23 bits as a fraction.
#[inline(always)]
fn cubic(row: &Row, digits: u32) -> f32 {
    let u = f32::from_bits(digits & 0x007f_ffff | 0x3f80_0000);
    let (places, _) = row.as_chunks();
    let at = |place: usize| f32::from_le_bytes(places[place]);
    (at(0) + at(2) * u) + (at(1) + at(3) * u) * (u * u)
}

#[inline(always)]
fn single<T: Scalar>(value: f32) -> T {
    <T as SupersetOf<f32>>::from_subset(&value)
}

impl<T: Scalar> Target<T> {
    #[inline(always)]
    fn of(value: T) -> Self {
        Self { value, rest: T::zero() }
    }

    #[inline(always)]
    fn in_units(load_integral: T, per_unit: T) -> Self {
        let (value, rest) = product_with_few_digits(load_integral, per_unit);
        Self { value, rest }
    }

    #[inline(always)]
    fn times(self, power: T) -> Self {
        Self { value: self.value * power, rest: self.rest * power }
    }

    /// Divided by the power of two at or below it, which is 2^`exponent`.
    #[inline(always)]
    fn fraction(self, exponent: i32) -> Self {
        Self { value: fraction(self.value), rest: self.rest * power_of_two(-exponent) }
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

    /// The radius from its seed.
    #[inline(always)]
    fn halley(self, a: T, target: Target<T>) -> T {
        // Differences instead of sums, as a zero that is taken away takes no instruction.
        let surplus = ((self.power * self.value - target.value) - self.excess) - target.rest;
        // What needs no surplus is multiplied while that is formed, and nothing after the division.
        let steep = self.power * self.first * self.first - surplus * self.half_second;
        a - (a * self.per_unit * self.first) * surplus / steep
    }
}

/// The general solution, out of the way of the step from the table.
#[cold]
#[inline(never)]
pub fn elsewhere<R>(solve: impl FnOnce() -> R) -> R {
    solve()
}
