//! Surfaces of revolution, seen from their vertex, and their series in even powers of r.
//!
//! A conic surface with the radius of curvature R at its vertex and the conic constant k falls away from the tangent
//! plane by its sag. With κ = 1 + k and u = κ r²/R²,
//!
//! ```text
//! z(r) = r² / (R (1 + √(1 − u))) = (R/κ) (1 − √(1 − u))
//! ```
//!
//! and the binomial series 1 − √(1 − u) = Σ b_j u^j, j ≥ 1, gives
//!
//! ```text
//! z(r) = Σ c_j r^(2j),    c_j = b_j κ^(j−1) / R^(2j−1),    b_j = (2j−2)! / (j! (j−1)! 2^(2j−1))
//! b_1 = 1/2,    b_(j+1)/b_j = (2j−1)/(2j+2)
//! ```
//!
//! The first form of z holds for κ = 0 too, where the surface is the paraboloid r²/(2R) and the series ends after its
//! first term. A negative R turns the surface over. The series converges for |κ| r² < R², which for κ > 0 is where the
//! surface exists.

use num_traits::One;

use crate::diagnostics::Extent;
use crate::gap::coefficient::Coefficient;
use crate::number::{Rational, fraction, integer};

/// A surface times a weight.
#[derive(Clone)]
pub(crate) struct Surface {
    pub(crate) weight: Coefficient,
    /// R, not zero.
    pub(crate) radius: Coefficient,
    /// κ = 1 + k: 1 for a sphere, 0 for a paraboloid, negative for a hyperboloid.
    pub(crate) shape: Coefficient,
    pub(crate) extent: Extent,
}

/// b_(j+1)/b_j.
pub(crate) fn binomial_ratio(j: u32) -> Rational {
    fraction(2 * j - 1, 2 * j + 2)
}

impl Surface {
    /// The surface of radius R and conic constant k, a sphere if there is none.
    pub(crate) fn new(radius: Coefficient, conic_constant: Option<Coefficient>, extent: Extent) -> Self {
        let one = Coefficient::constant(Rational::one());
        let shape = conic_constant.map_or_else(|| one.clone(), |k| one.add(&k));
        Surface { weight: one, radius, shape, extent }
    }

    /// Whether both differ only in their weight.
    pub(crate) fn is_like(&self, other: &Surface) -> bool {
        self.radius == other.radius && self.shape == other.shape
    }

    /// weight · c_j for j = 1, 2, ..., up to `count` of them, or the rule that is broken if a power is too large.
    pub(crate) fn series(&self, count: u32) -> Result<Vec<Coefficient>, &'static str> {
        let inverse = self.radius.power(&-Rational::one())?;
        let step = self.shape.multiply(&inverse.power(&integer(2))?);
        let mut next = self.weight.multiply(&inverse).scaled(&fraction(1, 2));
        let mut terms = Vec::new();
        for j in 1..=count {
            let after = next.multiply(&step).scaled(&binomial_ratio(j));
            terms.push(core::mem::replace(&mut next, after));
        }
        Ok(terms)
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use num_traits::Zero;
    use proc_macro2::Span;
    use quote::format_ident;

    use super::*;
    use crate::tests::exact;

    fn number(text: &str) -> Coefficient {
        Coefficient::constant(exact(text))
    }

    fn surface(radius: &str, conic_constant: &str) -> Surface {
        Surface::new(number(radius), Some(number(conic_constant)), Span::call_site().into())
    }

    fn coefficients(surface: &Surface, count: u32) -> Vec<Rational> {
        surface.series(count).unwrap().iter().map(|value| value.as_constant().unwrap()).collect()
    }

    #[test]
    fn the_coefficients_are_those_of_the_formula() {
        let factorial =
            |n: u32| (1..=n).map(integer).fold(Rational::one(), |product, factor| product * factor);
        let (radius, shape) = (integer(20), fraction(3, 4));
        for (j, value) in (1..).zip(coefficients(&surface("20", "-0.25"), 30)) {
            let power = |base: &Rational, exponent: u32| base.pow(i32::try_from(exponent).unwrap());
            let binomial =
                factorial(2 * j - 2) / (factorial(j) * factorial(j - 1) * power(&integer(2), 2 * j - 1));
            assert_eq!(value, binomial * power(&shape, j - 1) / power(&radius, 2 * j - 1));
        }
    }

    /// The sag z solves κ z² − 2 R z + r² = 0: the series does so to every order that it reaches.
    #[test]
    fn the_series_solves_the_equation_of_the_conic() {
        for (radius, conic_constant) in
            [("20", "0"), ("-7.5", "0"), ("3", "-0.3"), ("11", "-2.5"), ("4", "-1"), ("9", "6")]
        {
            let surface = surface(radius, conic_constant);
            let (radius, shape) =
                (surface.radius.as_constant().unwrap(), surface.shape.as_constant().unwrap());
            let terms = coefficients(&surface, 24);
            for j in 1..=terms.len() {
                let products = (1..j).map(|i| &terms[i - 1] * &terms[j - i - 1]);
                let square = products.fold(Rational::zero(), |sum, product| sum + product);
                let constant = if j == 1 { Rational::one() } else { Rational::zero() };
                assert_eq!(
                    &shape * square - integer(2) * &radius * &terms[j - 1] + constant,
                    Rational::zero()
                );
            }
        }
    }

    #[test]
    fn fields_stay_symbols() {
        let radius = Coefficient::field(format_ident!("radius"));
        let k = Coefficient::field(format_ident!("k"));
        let terms = Surface::new(radius, Some(k), Span::call_site().into()).series(3).unwrap();
        let shown: Vec<String> = terms.iter().map(Coefficient::to_string).collect();
        assert_eq!(shown, ["1/(2·radius)", "(1 + k)/(8·radius^3)", "(1 + k)^2/(16·radius^5)"]);
    }
}
