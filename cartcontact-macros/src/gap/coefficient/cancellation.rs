//! Whether a coefficient may lose digits that its fields have.
//!
//! In 1/a − 1/(b + c) the quotients are rounded, and the difference of two that are nearly equal consists of these
//! roundings: the radii of congruent joint surfaces are such. The difference of two words, such as a − b, loses nothing,
//! nor does 1/a − 1/b, which is computed as a [product](Coefficient::factored).
//!
//! In c b³/(7 d³) eight roundings may add up. They are the same in all radii of a geometry, as those of its fields are.

use super::{Atom, Coefficient, Product};
use crate::number::{self, Rational};

/// The coefficient of r^n may have so many operations in words, and n more. A contact radius takes over 1/(n + 4) of
/// their roundings, which is less than ε/2. Spheres, whose r^(2j) have at most 2j operations, remain in words.
const OPERATIONS: f64 = 3.0;

impl Coefficient {
    /// Whether words are too short to compute it in, as the coefficient of r^`n`.
    pub(crate) fn loses_digits(&self, n: &Rational) -> bool {
        self.may_cancel() || self.operations() > n.to_f64() + OPERATIONS
    }

    /// The most operations whose roundings add up, powers as products; a division without a dividend is none.
    fn operations(&self) -> f64 {
        let of_products = self.products.iter().map(Product::operations).fold(0.0, f64::max);
        of_products + self.products.len().saturating_sub(1) as f64
    }

    /// Whether rounded numbers are added in it that may have different signs.
    fn may_cancel(&self) -> bool {
        let are_rounded = self.products.len() > 2 || !self.products.iter().all(Product::is_word);
        let is_sum = self.products.len() > 1 && self.certain_sign().is_none();
        let adds_roundings = is_sum && are_rounded && self.factored().is_none();
        adds_roundings || self.sums().any(Coefficient::may_cancel)
    }
}

impl Product {
    /// Whether it is a word without being rounded.
    fn is_word(&self) -> bool {
        match self.single_atom() {
            Some(Atom::Field { .. }) => number::is_power_of_two(&self.number),
            _ => self.powers.is_empty() && number::has_few_digits(&self.number),
        }
    }

    /// One for each factor but the first, and another for a number that is rounded.
    fn operations(&self) -> f64 {
        let of_powers = self.powers.iter().map(|(atom, exponent)| {
            let of_base = match atom {
                Atom::Field { .. } => 0.0,
                Atom::Sum(inner) => inner.operations(),
            };
            exponent.to_f64().abs() * (of_base + 1.0)
        });
        let of_number = if number::is_power_of_two(&self.number) { 0.0 } else { 2.0 };
        of_powers.sum::<f64>() + of_number - 1.0
    }
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;
    use crate::gap::coefficient::samples::{field, inverse, number, power};
    use crate::number::fraction;

    #[test]
    fn rounded_differences_cancel() {
        let (a, b) = (field("a"), field("b"));
        let curvatures = inverse(&a).add(&inverse(&b).scaled(&fraction(-1, 2)));
        assert!(curvatures.may_cancel());
        assert!(curvatures.scaled(&fraction(1, 2)).multiply(&a).may_cancel());
        assert!(a.add(&b).add(&field("c").negated()).may_cancel());
        assert!(a.add(&number(-1, 10)).may_cancel());
        // One digit more than single precision has.
        assert!(a.add(&number(-(1 << 24) - 1, 1)).may_cancel());
        assert!(a.multiply(&b).add(&number(1, 1)).may_cancel());
        // A common factor is left as it is.
        let common = a.multiply(&b).add(&number(-1, 1));
        let [x, y] = ["x", "y"].map(|name| inverse(&field(name)).multiply(&common));
        let sum = x.add(&y.negated());
        assert!(sum.factored().is_some() && sum.may_cancel());
    }

    #[test]
    fn products_of_many_factors_lose_digits() {
        let [a, b] = ["a", "b"].map(field);
        let (difference, slight) = (b.add(&a.negated()), fraction(1, 4));
        for few in [
            power(&a, -3, 1).scaled(&fraction(1, 8)),
            power(&a, -2, 1).scaled(&fraction(1, 3)),
            b.multiply(&power(&a, -3, 1)).scaled(&fraction(1, 8)),
            difference.multiply(&inverse(&a.multiply(&b))),
        ] {
            assert!(!few.loses_digits(&slight));
            let many = few.multiply(&power(&b, 3, 1));
            assert!(many.loses_digits(&slight) && !many.loses_digits(&fraction(4, 1)));
        }
        assert!(power(&a, -3, 1).scaled(&fraction(1, 7)).loses_digits(&slight));
        assert!(power(&difference, -3, 1).loses_digits(&slight));
    }

    #[test]
    fn spheres_of_any_order_lose_none() {
        let radius = field("a");
        for n in [2, 4, 6, 20, 60] {
            assert!(!power(&radius, 1 - n, 1).scaled(&fraction(5, 128)).loses_digits(&fraction(n, 1)));
        }
    }

    #[test]
    fn words_and_positive_sums_do_not() {
        let (a, b) = (field("a"), field("b"));
        for exact in [a.add(&b.negated()), a.add(&number(1, 1)), inverse(&a.multiply(&b))] {
            assert!(!exact.may_cancel());
            assert!(!power(&exact.scaled(&fraction(1, 3)), 2, 1).may_cancel());
        }
        let lengths = ["a", "b"].map(|name| inverse(&Coefficient::positive_field(format_ident!("{name}"))));
        assert!(!lengths[0].add(&lengths[1]).may_cancel());
        assert!(lengths[0].add(&lengths[1].scaled(&fraction(-1, 2))).may_cancel());
        // This one is computed as (b − a)/(a b).
        assert!(!lengths[0].add(&lengths[1].negated()).may_cancel());
    }
}
