//! The contact radius from the leading term where powers are whole, and many of them in vector code.
//!
//! With a = 2ᵏ x, 1 ≤ x < 2, and y = 2ᵉ z, 1 ≤ z < 4, the terms are j 2^(k p − e) x^p: no step leaves the format, and a
//! change of units by a power of two changes only k and e. Fractional powers are whole powers of a root of the radius,
//! which then takes the place of a.

use super::blocks::{fill, leading_blocks};
use super::halley::{Target, radius_from_root};
use super::leading_term::{MORE_STEPS, Spread, Start, logarithm_alone};
use crate::Scalar;
use crate::dispatch::out_of_line;
use crate::evaluate::steepness::Steepness;
use crate::numbers::bits::{exponent, fraction, is_normal, log2_digits, power_of_two};
use crate::profile::RadiusError;
use crate::scalar::{has_no_derivatives, lesser};

/// How many radii are found at once.
const BLOCK: usize = 16;

/// J = Σ j x^p with whole powers in ascending order and coefficients that are positive or zero; x is the `ROOT`-th root
/// of the radius, and mostly the radius itself.
///
/// Other coefficients find no radius here. The sign bit of a negative one makes its logarithm 2048 octaves too large,
/// or 256 in single precision; infinity has a logarithm of 1024, or 128. Both put 2^(k p − e) out of the format for
/// their own power, and so for the lowest or for the highest.
#[derive(Clone, Copy, Debug)]
pub struct WholePowers<T, F, L, const N: usize, const ROOT: u32> {
    /// j.
    pub coefficients: [T; N],
    /// p.
    pub powers: [u32; N],
    /// J and its derivatives at x with these powers and other coefficients.
    pub steepness: F,
    /// The same for the last step: the higher powers of a root would round too often.
    pub last_steepness: L,
    /// The common denominator of the weights, by which J and load integrals are multiplied: see `Target`.
    pub denominator: T,
}

impl<T, F, L, const N: usize, const ROOT: u32> WholePowers<T, F, L, N, ROOT>
where
    T: Scalar,
    F: Fn(T, [T; N]) -> Steepness<T> + Copy,
    L: Fn(T, [T; N]) -> Steepness<T> + Copy,
{
    /// The radius at which J is `load_integral`; none beyond `limit`, and where the steps have not come near.
    #[inline(always)]
    pub fn radius(&self, load_integral: T, limit: T) -> Option<T> {
        let found = |(radius, is_found): (T, bool)| (is_found & (radius <= limit)).then_some(radius);
        // A copy for the cold call. What it can see must be kept in memory, and the logarithms would be taken again for
        // each of many radii.
        let again = *self;
        match found(self.solve(load_integral, 0)) {
            // More steps do not lead to the centre, either.
            None if load_integral.is_zero() => None,
            None => out_of_line(move || found(again.solve(load_integral, MORE_STEPS))),
            first => first,
        }
    }

    /// The radius at which J is `load_integral`, and whether the steps have found it; `more` is the number of steps beyond
    /// those that usually suffice.
    #[inline(always)]
    pub fn solve(&self, load_integral: T, more: u32) -> (T, bool) {
        let [lowest, .., highest] = self.powers[..] else { return (load_integral, false) };
        let logarithm_of_y = log2_digits(load_integral * self.denominator);
        let alone = self.coefficients.iter().zip(&self.powers).map(
            #[inline(always)]
            |(&j, &p)| logarithm_alone(logarithm_of_y, (j, T::constant(f64::from(p)))),
        );
        let Some(least) = alone.reduce(lesser) else { return (load_integral, false) };
        let start = Start::of(T::constant(f64::from(lowest)), least);
        let exponent = exponent(load_integral);
        let shift = |p: u32| start.octave * p as i32 - exponent;
        let mut scaled = self.coefficients;
        for (j, &p) in scaled.iter_mut().zip(&self.powers) {
            *j *= power_of_two(shift(p));
        }
        let fits = is_normal::<T>(exponent) & is_normal::<T>(shift(lowest)) & is_normal::<T>(shift(highest));
        let spread =
            Spread { lowest: T::constant(f64::from(lowest)), highest: T::constant(f64::from(highest)) };
        // From the fraction alone, so that nothing is lost next to the ends of the format, either.
        let target = Target::times_denominator(fraction(load_integral), self.denominator);
        let (radius, is_near) = spread.radius(
            more,
            target.value,
            start.fraction,
            #[inline(always)]
            |x| (self.steepness)(x, scaled),
            #[inline(always)]
            |x| {
                radius_from_root::<_, ROOT>(
                    x,
                    target,
                    #[inline(always)]
                    |x| (self.last_steepness)(x, scaled),
                )
            },
        );
        (radius * power_of_two(start.octave * ROOT as i32), fits & is_near)
    }
}

/// `fill` with blocks solved by `solve`, which calls [`WholePowers::solve`].
///
/// # Errors
///
/// As `fill`.
#[inline]
pub fn radii_of_whole_powers<T: Scalar>(
    values: (&[T], &mut [T]),
    limit: T,
    solve: impl Fn(T, u32) -> (T, bool),
    general: impl Fn(T) -> Result<T, RadiusError>,
) -> Result<(), RadiusError> {
    let least = if has_no_derivatives::<T>() { BLOCK } else { usize::MAX };
    fill(
        values,
        (least, BLOCK),
        #[inline(always)]
        |load_integrals, radii| find_blocks(load_integrals, radii, limit, &solve, |_| None),
        general,
    )
}

/// Finds radii in blocks, until a block has one that is not found. Returns how many have been found. Radii from
/// `preferred` take the places of others.
#[inline(always)]
pub(super) fn find_blocks<T: Scalar>(
    load_integrals: &[T],
    radii: &mut [T],
    limit: T,
    solve: &impl Fn(T, u32) -> (T, bool),
    preferred: impl Fn(T) -> Option<T>,
) -> usize {
    leading_blocks(
        load_integrals,
        radii,
        #[inline(always)]
        |load_integrals, radii| {
            let are_found = block(
                load_integrals,
                radii,
                limit,
                #[inline(always)]
                |load_integral| solve(load_integral, 0),
            );
            // Each with more steps only if it needs them, so that no radius depends on its neighbours. Marks of those
            // that are found already would cost the usual attempt 4 %, and this one is rare.
            let are_found = are_found
                || block(
                    load_integrals,
                    radii,
                    limit,
                    #[inline(always)]
                    |load_integral| {
                        let (first, again) = (solve(load_integral, 0), solve(load_integral, MORE_STEPS));
                        if first.1 { first } else { again }
                    },
                );
            if !are_found {
                return false;
            }
            for (radius, &load_integral) in radii.iter_mut().zip(load_integrals) {
                if let Some(preferred) = preferred(load_integral) {
                    *radius = preferred;
                }
            }
            true
        },
    )
}

/// The radii of a block; false if one of them is not found.
#[inline(always)]
fn block<T: Scalar>(
    load_integrals: &[T; BLOCK],
    radii: &mut [T; BLOCK],
    limit: T,
    solve: impl Fn(T) -> (T, bool),
) -> bool {
    // An array of its own, which cannot alias what is read.
    let mut values = [T::zero(); BLOCK];
    let mut are_found = true;
    for (value, &load_integral) in values.iter_mut().zip(load_integrals) {
        let (radius, is_found) = solve(load_integral);
        *value = radius;
        are_found &= is_found & (radius <= limit);
    }
    *radii = values;
    are_found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::power::integer_power;
    use crate::evaluate::steepness::NestedPowers;

    /// J = a⁶ + a⁸ + a¹⁰ with other coefficients.
    fn steepness<T: Scalar>(a: T, [b, c, d]: [T; 3]) -> Steepness<T> {
        let (s, one) = (a * a, T::one());
        let sum = |weights: [f64; 3]| {
            let [low, middle, high] = weights.map(T::constant);
            low * b + (middle * c + high * d * s) * s
        };
        let [value, first, half_second] = [[1.0, 1.0, 1.0], [6.0, 8.0, 10.0], [15.0, 28.0, 45.0]].map(sum);
        Steepness { power: s * s * s, value, excess: T::zero(), first, half_second, per_unit: one }
    }

    fn radius<T: Scalar>(coefficients: [T; 3], load_integral: T) -> Option<T> {
        WholePowers::<_, _, _, 3, 1> {
            coefficients,
            powers: [6, 8, 10],
            steepness: steepness::<T>,
            last_steepness: steepness::<T>,
            denominator: T::one(),
        }
        .radius(load_integral, T::infinity())
    }

    /// Not only right, which the general solution would be as well, but found here.
    #[test]
    fn radii_of_positive_terms_are_found() {
        for k in 0..1000 {
            let digit = |place: u32| f64::from(k / 10_i32.pow(place) % 10 - 5);
            for unit in [1e-100, 1.0, 1e100] {
                let coefficients = [0, 1, 2].map(|place| unit * 10f64.powf(digit(place)));
                let found = radius(coefficients, unit).unwrap_or(f64::NAN);
                let at = steepness(found, coefficients);
                let error = (at.power * at.value / unit - 1.0).abs();
                assert!(error < 12.0 * f64::EPSILON, "{coefficients:?}: {found}, {error:e}");
            }
            let coefficients = [0, 1, 2].map(|place| 10f32.powf(digit(place) as f32));
            let found = radius(coefficients, 1.0).unwrap_or(f32::NAN);
            let at = steepness(found, coefficients);
            let error = (at.power * at.value - 1.0).abs();
            assert!(error < 12.0 * f32::EPSILON, "{coefficients:?}: {found}, {error:e}");
        }
    }

    /// J = Σ a^p for p from 6 to 10, whose terms are all equal at a = 1.
    fn of_five<T: Scalar>(a: T, coefficients: [T; 5]) -> Steepness<T> {
        let mut sum = Steepness { power: integer_power(a, 6), ..Steepness::of_nothing() };
        for (p, c) in [6, 7, 8, 9, 10].into_iter().zip(coefficients) {
            let term = c * integer_power(a, p) / sum.power;
            sum.value += term;
            sum.add_derivatives(term, T::constant(f64::from(p)));
        }
        sum
    }

    /// The same by powers that are not rounded.
    fn of_five_exactly(x: f64, [a, b, c, d, e]: [f64; 5]) -> Steepness<f64> {
        let high = NestedPowers::of(x).plus(e, 10.0).times_power::<1>().plus(d, 9.0).times_power::<1>();
        let low = high.plus(c, 8.0).times_power::<1>().plus(b, 7.0).times_power::<1>();
        low.plus(a, 6.0).of_lowest_power::<6>()
    }

    fn assert_found<const ROOT: u32>(last_steepness: impl Fn(f64, [f64; 5]) -> Steepness<f64> + Copy) {
        let five = WholePowers::<_, _, _, 5, ROOT> {
            coefficients: [1.0; 5],
            powers: [6, 7, 8, 9, 10],
            steepness: of_five::<f64>,
            last_steepness,
            denominator: 1.0,
        };
        let planted: Vec<f64> = (0..1600).map(|k| 0.2 * 1.002_f64.powi(k)).collect();
        let value = |x: f64| (6..=10).map(|p| x.powi(p)).sum::<f64>();
        let load_integrals: Vec<f64> = planted.iter().map(|&x| value(x)).collect();
        let mut radii = vec![0.0; planted.len()];
        let general = |_: f64| Err(RadiusError::InvalidLoadIntegral { load_integral: f64::NAN });
        let solve = |load_integral, more| five.solve(load_integral, more);
        let all = radii_of_whole_powers((&load_integrals, &mut radii), f64::INFINITY, solve, general);
        assert_eq!(all, Ok(()));
        for ((&x, &load_integral), &of_slice) in planted.iter().zip(&load_integrals).zip(&radii) {
            for found in [five.radius(load_integral, f64::INFINITY), Some(of_slice)] {
                // The test rounds five terms and their sum, errors that p divides, and the radius.
                let allowed = 2.0 * f64::from(ROOT) * f64::EPSILON;
                let is_near = |found: f64| (found / x.powi(ROOT as i32) - 1.0).abs() < allowed;
                assert!(found.is_some_and(is_near), "{ROOT}: {x}");
            }
        }
    }

    #[test]
    fn radii_of_equal_terms_are_found() {
        assert_found::<1>(of_five);
        assert_found::<2>(|x, coefficients| of_five(x, coefficients).with_exact_power::<6>(x));
        assert_found::<3>(of_five_exactly);
        assert_found::<10>(of_five_exactly);
    }

    #[test]
    fn other_numbers_are_left_to_the_general_solution() {
        assert!(radius([1.0, 0.0, 1e-300], 1.0).is_some());
        for (place, bad) in
            (0..3).flat_map(|place| [-1.0, -1e-300, f64::NAN, f64::INFINITY].map(|bad| (place, bad)))
        {
            let mut coefficients = [1.0, 1.0, 1.0];
            coefficients[place] = bad;
            assert_eq!(radius(coefficients, 1.0), None, "{coefficients:?}");
            let mut coefficients = [1.0_f32, 1.0, 1.0];
            coefficients[place] = bad as f32;
            // −10⁻³⁰⁰ is −0 there, which does not change J.
            assert!(radius(coefficients, 1.0).is_none() || bad == -1e-300, "{coefficients:?}");
        }
        assert_eq!(radius([0.0; 3], 1.0), None);
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::MIN_POSITIVE / 2.0] {
            assert_eq!(radius([1.0; 3], bad), None, "{bad:e}");
        }
    }
}
