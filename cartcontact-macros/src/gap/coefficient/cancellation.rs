//! Whether a coefficient may lose digits that its fields have.
//!
//! In 1/a − 1/(b + c) the quotients are rounded, and the difference of two that are nearly equal consists of these
//! roundings: the radii of congruent joint surfaces are such. The difference of two words, such as a − b, loses nothing,
//! nor does 1/a − 1/b, which is computed as a [product](Coefficient::factored).

use super::{Atom, Coefficient, Product};
use crate::number::{self, Rational};

/// The digits of a word of single precision.
const DIGITS_OF_SINGLE: u64 = 24;

impl Coefficient {
    /// Whether rounded numbers are added in it that may have different signs.
    pub(crate) fn may_cancel(&self) -> bool {
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
            Some(Atom::Sum(_)) => false,
            None => self.powers.is_empty() && is_short(&self.number),
        }
    }
}

/// Whether a number has no more digits than any word.
fn is_short(value: &Rational) -> bool {
    number::is_binary(value) && value.numer().bits() <= DIGITS_OF_SINGLE
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
