//! The sign that a coefficient has whatever the values of its fields, given those that are declared positive.
//!
//! Even powers are not negative, and neither are powers with exponents that are not integers: of a negative base these
//! have no value, which is detected when the value is known.

use num_integer::Integer;

use super::{Atom, Coefficient, Product};

#[derive(Clone, Copy, PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) enum Sign {
    NotNegative,
    NotPositive,
}

impl Coefficient {
    /// Nothing if the sign depends on the fields.
    pub(crate) fn certain_sign(&self) -> Option<Sign> {
        self.sign(false)
    }

    /// The sign for positive fields, as fields that measure something are; nothing if it depends on their values.
    pub(crate) fn usual_sign(&self) -> Option<Sign> {
        self.sign(true)
    }

    /// The sign if all fields are positive, or only those that are declared to be.
    fn sign(&self, all_positive: bool) -> Option<Sign> {
        let mut signs = self.products.iter().map(|product| product.sign(all_positive));
        let first = signs.next()??;
        signs.all(|sign| sign == Some(first)).then_some(first)
    }
}

impl Product {
    fn sign(&self, all_positive: bool) -> Option<Sign> {
        let mut negative = self.number.is_negative();
        for (atom, exponent) in self.powers.iter() {
            if !exponent.is_integer() || exponent.numer().is_even() {
                continue;
            }
            match atom {
                Atom::Field { is_positive, .. } if all_positive || *is_positive => {}
                Atom::Field { .. } => return None,
                Atom::Sum(inner) => negative ^= inner.sign(all_positive)? == Sign::NotPositive,
            }
        }
        Some(if negative { Sign::NotPositive } else { Sign::NotNegative })
    }
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;
    use crate::gap::coefficient::samples::{field, number, power};

    #[test]
    fn even_powers_decide() {
        let (a, one) = (field("a"), number(1, 1));
        let square = power(&a, 2, 1);
        let sum = square.add(&one);
        assert_eq!(a.certain_sign(), None);
        assert_eq!(power(&a, -2, 1).certain_sign(), Some(Sign::NotNegative));
        assert_eq!(square.negated().certain_sign(), Some(Sign::NotPositive));
        assert_eq!(power(&sum, -3, 1).certain_sign(), Some(Sign::NotNegative));
        assert_eq!(sum.add(&a).certain_sign(), None);
        assert_eq!(square.add(&one.negated()).certain_sign(), None);
        assert_eq!(power(&a, 1, 2).certain_sign(), Some(Sign::NotNegative));
    }

    #[test]
    fn positive_fields_decide() {
        let (a, b) = (Coefficient::positive_field(format_ident!("a")), field("b"));
        let cubed = power(&a.add(&number(1, 1)), -3, 1);
        assert_eq!(a.certain_sign(), Some(Sign::NotNegative));
        assert_eq!(cubed.negated().certain_sign(), Some(Sign::NotPositive));
        assert_eq!(a.multiply(&b).certain_sign(), None);
        assert_eq!(a.add(&number(-1, 1)).certain_sign(), None);
        assert_eq!(a.multiply(&b).negated().usual_sign(), Some(Sign::NotPositive));
        assert_eq!(a.add(&b.negated()).usual_sign(), None);
    }
}
