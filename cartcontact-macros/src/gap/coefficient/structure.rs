//! What a coefficient consists of: its fields, divisors, factors and roots.

use num_traits::One;
use proc_macro2::Ident;

use super::{Atom, Coefficient, Product};
use crate::number::{self, Rational};

impl Coefficient {
    /// The factor of a field, if the coefficient is a multiple of one field.
    pub(crate) fn as_multiple_of_field(&self) -> Option<&Rational> {
        match self.products.as_slice() {
            [only] if matches!(only.single_atom(), Some(Atom::Field { .. })) => Some(&only.number),
            _ => None,
        }
    }

    /// One over the coefficient, if that is a number over fields and its inverse takes no division: 2 R for 1/(2 R).
    pub(crate) fn inverse_of_divisors(&self) -> Option<Self> {
        let [only] = self.products.as_slice() else { return None };
        let are_divisors =
            !only.powers.is_empty() && only.powers.iter().all(|(_, exponent)| is_divisor(exponent));
        are_divisors.then(|| self.power(&-Rational::one()).ok()).flatten()
    }

    pub(crate) fn depends_on(&self, field: &Ident) -> bool {
        self.powers().any(|(atom, _)| match atom {
            Atom::Field { ident, .. } => ident == field,
            Atom::Sum(inner) => inner.depends_on(field),
        })
    }

    /// The fields whose integer powers are the only divisor of a product, each as often as it is written.
    pub(crate) fn only_divisors(&self) -> Vec<&Ident> {
        let own = self.products.iter().filter_map(|product| Some(product.only_divisor()?.0));
        own.chain(self.sums().flat_map(Coefficient::only_divisors)).collect()
    }

    /// The fields and sums whose positive powers, and whose negative ones, are multiplied in it; none if it is a sum
    /// itself.
    pub(crate) fn factors_and_divisors(&self) -> Option<[Vec<Self>; 2]> {
        let [only] = self.products.as_slice() else { return None };
        let with_sign = |is_negative: bool| {
            let powers =
                only.powers.iter().filter(move |(_, exponent)| exponent.is_negative() == is_negative);
            powers.map(|(atom, _)| Coefficient::atom(atom.clone())).collect()
        };
        Some([false, true].map(with_sign))
    }

    /// The products that it is the sum of, and those of the sums in them, without constants.
    pub(crate) fn products_of_fields(&self) -> Vec<Self> {
        let of_fields = self.products.iter().filter(|product| !product.powers.is_empty());
        let own = of_fields.map(|product| Coefficient { products: vec![product.clone()] });
        own.chain(self.sums().flat_map(Coefficient::products_of_fields)).collect()
    }

    /// Whether it has a power whose exponent is not an integer.
    pub(crate) fn has_root(&self) -> bool {
        self.powers().any(|(_, exponent)| !exponent.is_integer()) || self.sums().any(Coefficient::has_root)
    }

    /// The number of fields in it, each counted as often as it is written.
    pub(crate) fn size(&self) -> usize {
        let sizes = self.powers().map(|(atom, _)| match atom {
            Atom::Field { .. } => 1,
            Atom::Sum(inner) => inner.size(),
        });
        sizes.sum()
    }

    /// The powers in its products, not those within sums.
    fn powers(&self) -> impl Iterator<Item = &(Atom, Rational)> {
        self.products.iter().flat_map(|product| product.powers.iter())
    }

    /// The sums that are atoms of its products.
    pub(super) fn sums(&self) -> impl Iterator<Item = &Coefficient> {
        self.powers().filter_map(|(atom, _)| match atom {
            Atom::Field { .. } => None,
            Atom::Sum(inner) => Some(inner),
        })
    }

    /// Whether every number in it has a finite `f64` other than 0 next to it.
    pub(crate) fn is_representable(&self) -> bool {
        self.products.iter().all(|product| number::nearest(&product.number).is_some())
            && self.sums().all(Coefficient::is_representable)
    }
}

impl Product {
    /// The field of which an integer power is the only divisor, and the exponent.
    pub(crate) fn only_divisor(&self) -> Option<(&Ident, &Rational)> {
        let mut divisors = self.powers.iter().filter(|(_, exponent)| is_divisor(exponent));
        match (divisors.next()?, divisors.next()) {
            ((Atom::Field { ident, .. }, exponent), None) => Some((ident, exponent)),
            _ => None,
        }
    }
}

/// Whether a power with that exponent is a quotient.
pub(crate) fn is_divisor(exponent: &Rational) -> bool {
    exponent.is_integer() && exponent.is_negative()
}

#[cfg(test)]
mod tests {
    use super::super::samples::{field, inverse, number, power};

    #[test]
    fn divisors_and_roots_are_found_within_sums() {
        let [a, b] = ["a", "b"].map(field);
        let difference = inverse(&a).add(&inverse(&b).negated());
        let quotient = difference.multiply(&power(&a, -3, 1));
        let names: Vec<String> = quotient.only_divisors().into_iter().map(ToString::to_string).collect();
        assert_eq!(names, ["a", "a", "b"]);
        assert!(inverse(&a.multiply(&b)).only_divisors().is_empty());
        assert!(!quotient.has_root() && power(&quotient, 1, 2).has_root());
        assert!(power(&a, -1, 2).only_divisors().is_empty());
    }

    #[test]
    fn products_within_sums_are_found() {
        let [a, b, c] = ["a", "b", "c"].map(field);
        let (square, product) = (power(&a, 2, 1), b.multiply(&c));
        let sum = square.add(&product).add(&number(1, 2));
        assert_eq!(sum.products_of_fields(), [square.clone(), product.clone()]);
        let multiple = sum.multiply(&c);
        assert_eq!(multiple.products_of_fields(), [multiple, square, product]);
    }

    #[test]
    fn inverses_take_no_division() {
        let [a, b] = ["a", "b"].map(field);
        let quotient = number(1, 3).multiply(&power(&a.multiply(&b), -2, 1));
        let expected = number(3, 1).multiply(&power(&a.multiply(&b), 2, 1));
        assert_eq!(quotient.inverse_of_divisors(), Some(expected));
        let others = [number(1, 3), a.clone(), a.multiply(&inverse(&b)), inverse(&a).add(&inverse(&b))];
        assert!(others.iter().all(|other| other.inverse_of_divisors().is_none()));
    }
}
