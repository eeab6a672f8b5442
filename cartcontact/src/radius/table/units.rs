//! The units of a table of seeds.

use crate::Scalar;
use crate::evaluate::power::{fractional_power, integer_power, plain_whole_term};
use crate::evaluate::steepness::Steepness;
use crate::numbers::binary::{divide, scale, split};
use crate::numbers::bits::with_half_its_digits;
use crate::numbers::exponent::Exponent;
use crate::radius::halley::{Target, radius_from_root};
use crate::scalar::{is_finite_and_positive, is_single};

/// The units of a table's load integrals and radii, and of the step from them.
///
/// A type for each kind, so that the units of the geometry itself cost nothing.
pub trait Units<T: Scalar>: Copy {
    /// A load integral of the geometry in units of the table.
    fn in_table(self, load_integral: T) -> T;

    /// A radius from the table in the units of the step.
    fn length(self, radius: T) -> T;

    /// That length with half its digits, so that its square is exact.
    #[inline(always)]
    fn seed(self, radius: T) -> T {
        with_half_its_digits(self.length(radius))
    }

    /// The load integral as the target of the step.
    fn target(self, load_integral: T) -> Target<T>;

    /// The radius from its seed, by one step with a function that evaluates J.
    #[inline(always)]
    fn radius(self, seed: T, target: Target<T>, evaluate: impl Fn(T) -> Steepness<T>) -> T {
        radius_from_root::<_, 1>(seed, target, evaluate)
    }
}

/// The units of the geometry that the table was made for.
#[derive(Clone, Copy, Debug)]
pub struct OwnUnits;

impl<T: Scalar> Units<T> for OwnUnits {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        load_integral
    }

    #[inline(always)]
    fn length(self, radius: T) -> T {
        radius
    }

    #[inline(always)]
    fn seed(self, radius: T) -> T {
        // The table's numbers have half the digits of double precision.
        if is_single::<T>() { with_half_its_digits(radius) } else { radius }
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        Target::of(load_integral)
    }
}

/// Units in which the first two terms of J have the coefficients 1 and ±1. All J whose other coefficients agree in
/// these units share one table. The unit of length is the radius at which the first two terms have the same size, the
/// unit of J that size.
#[derive(Clone, Copy, Debug)]
pub struct EqualTerms<T> {
    radius: T,
    per_load_integral: T,
    denominator: T,
}

impl<T: Scalar> EqualTerms<T> {
    /// From the terms j aᵖ and j′ aᵖ′ as pairs (j, p), p < p′, the coefficients of all others, each times its sign in
    /// the table, and the common denominator of the weights, see `Target`.
    ///
    /// If all j and the unit of J lie between 1/b and b, then y, aJ′ and J′/a^(p−1) lie within 2^±71 b, and aᵖ within
    /// 2^±64 b²: none of their products in a step leaves the format. In single precision all these are 20 octaves
    /// nearer to 1. Terms outside these bounds have no table.
    #[inline(always)]
    pub fn of<const N: usize>(low: (T, T), high: (T, T), others: [T; N], denominator: T) -> Self {
        let (least, most) = if is_single::<T>() { (1e-11, 1e11) } else { (1e-60, 1e60) };
        let (least, most) = (T::constant(least), T::constant(most));
        let (radius, per_size) = equal_terms(low, high);
        // A term with a sign other than in the table has a negative size; the unit may then be NaN or not.
        let fits = |j: T| (least <= j) & (j <= most);
        let mut has_table = fits(per_size) & fits(low.0) & fits(high.0);
        for &other in &others {
            has_table &= fits(other);
        }
        // Zero lies in no table.
        Self {
            radius,
            per_load_integral: if has_table { denominator * per_size } else { T::zero() },
            denominator,
        }
    }
}

impl<T: Scalar> Units<T> for EqualTerms<T> {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        load_integral * self.per_load_integral
    }

    #[inline(always)]
    fn length(self, radius: T) -> T {
        radius * self.radius
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        Target::times_denominator(load_integral, self.denominator)
    }
}

/// Where the terms c x^p and d x^q, 0 < p < q, are equal, and the reciprocal of their value there, both to a few digits
/// less than a word has.
///
/// Where c/d is x or x², the reciprocal is formed from powers of d/c and does not wait for x. Inlined where exponents
/// are constants, which leaves only products.
#[inline(always)]
fn equal_terms<T: Scalar>((c, p): (T, T), (d, q): (T, T)) -> (T, T) {
    let per_low = c.recip();
    let (ratio, inverse, order) = (c / d, d * per_low, q - p);
    let Exponent { whole, fraction, .. } = Exponent::of(p);
    let is_whole = fraction.is_zero();
    if order == T::one() && is_whole {
        return (ratio, per_low * integer_power(inverse, whole as u32));
    }
    if order == T::constant(2.0) && is_whole {
        let even = per_low * integer_power(inverse, whole as u32 / 2);
        return (ratio.sqrt(), if whole & 1 == 1 { even * inverse.sqrt() } else { even });
    }
    let x = if order == T::constant(4.0) { ratio.sqrt().sqrt() } else { root(ratio, order) };
    let whole_term = plain_whole_term(c, x, whole as u32);
    (x, (if is_whole { whole_term } else { whole_term * fractional_power(x, fraction) }).recip())
}

/// x^(1/p) of a positive number. Whole periods of octaves are taken out first, so that a change of units by a power of
/// two changes no digit.
fn root<T: Scalar>(x: T, p: T) -> T {
    let inverse = p.recip();
    // Zero, negative numbers, infinity and NaN have no octaves, and have to show in the result.
    if !is_finite_and_positive(x) {
        return x.powf(inverse);
    }
    let (fraction, octaves) = split(x);
    let (whole, rest) = divide(octaves, p, inverse);
    scale(((fraction.log2() + rest) * inverse).exp2(), whole)
}

/// The units `U` for the `Q`-th root x of the radius; J has whole powers of x.
#[derive(Clone, Copy, Debug)]
pub struct RootOf<U, const Q: u32>(pub U);

impl<T: Scalar, U: Units<T>, const Q: u32> Units<T> for RootOf<U, Q> {
    #[inline(always)]
    fn in_table(self, load_integral: T) -> T {
        self.0.in_table(load_integral)
    }

    #[inline(always)]
    fn length(self, radius: T) -> T {
        self.0.length(radius)
    }

    /// Higher roots keep all digits: the step takes powers of them that are not rounded.
    #[inline(always)]
    fn seed(self, radius: T) -> T {
        if Q == 2 { self.0.seed(radius) } else { self.0.length(radius) }
    }

    #[inline(always)]
    fn target(self, load_integral: T) -> Target<T> {
        self.0.target(load_integral)
    }

    #[inline(always)]
    fn radius(self, seed: T, target: Target<T>, evaluate: impl Fn(T) -> Steepness<T>) -> T {
        radius_from_root::<_, Q>(seed, target, evaluate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::steepness::NestedPowers;

    /// For J = a^(41/7), from seeds that are as far off as those of a table, in either direction.
    #[test]
    fn radii_are_powers_of_their_roots() {
        for k in 0..1000 {
            let load_integral = 1.0 + f64::from(k);
            let root = load_integral.powf(1.0 / 41.0);
            for error in [-1e-6, 1e-7, 1e-6] {
                let seed = f64::from((root * (1.0 + error)) as f32);
                let evaluate = |x| NestedPowers::of(x).plus(1.0, 41.0).of_lowest_power::<41>();
                let radius = RootOf::<_, 7>(OwnUnits).radius(seed, Target::of(load_integral), evaluate);
                // Half an ε from each result, and the effect of rounding the exponent.
                let difference = radius / load_integral.powf(7.0 / 41.0) - 1.0;
                assert!(difference.abs() < 2.0 * f64::EPSILON, "{load_integral}, {error}: {difference:e}");
            }
        }
    }

    /// Lengths change by powers of 16, so that quarters are whole powers of two, too.
    #[test]
    fn terms_are_equal_at_the_same_place_in_other_units() {
        let exponents = [(6.0, 12.0), (6.0, 9.0), (9.0, 68.0), (5.25, 6.0), (4.5, 10.75)];
        for (p, q) in
            exponents.into_iter().chain([(6.0, 7.0), (6.0, 8.0), (7.0, 9.0), (6.0, 10.0), (5.5, 7.5)])
        {
            for k in 1..200 {
                let (c, d) = (f64::from(k) / 7.0, 0.3 + f64::from(k % 17));
                let (x, per_value) = equal_terms((c, p), (d, q));
                let share = |j: f64, p: f64| (per_value * (j * x.powf(p)) - 1.0).abs();
                assert!(share(c, p) < 1e-12 && share(d, q) < 1e-12, "{c} {p} {d} {q}");
                for octaves in [-8, -4, 4, 8] {
                    let unit = |p: f64| 2f64.powf(-p * f64::from(octaves));
                    let found = equal_terms((c * unit(p), p), (d * unit(q), q));
                    assert_eq!(found, (x * 2f64.powi(octaves), per_value), "{c} {p} {d} {q}");
                }
            }
        }
        let [turned, none] = [(1.0_f64, -1.0), (f64::NAN, 1.0)].map(|(c, d)| equal_terms((c, 6.0), (d, 9.0)));
        assert!(turned.0.is_nan() && none.0.is_nan());
    }
}
