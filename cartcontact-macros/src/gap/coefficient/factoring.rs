//! Differences of equal powers of two fields as products, which lose no digits.
//!
//! ```text
//! xᵏ − yᵏ   = (x − y) Σ xⁱ yʲ               i + j = k − 1
//! x⁻ᵏ − y⁻ᵏ = (y − x)/(x y) Σ x⁻ⁱ y⁻ʲ
//! ```
//!
//! The difference of two fields is rounded once, however near they are. Of fields with one sign nothing cancels in the
//! sum; of others it is at least 1/k of its magnitudes if k is odd, and for an even k it has the factor x + y.

use num_traits::{One, ToPrimitive, Zero};

use super::{Atom, Coefficient, Powers, Product};
use crate::number::{Rational, integer};

/// The highest power that is taken apart; the sum has as many products.
const HIGHEST_POWER: i64 = 12;

impl Coefficient {
    /// The same as a product, if it is the difference of powers of two fields, which may have common factors.
    pub(crate) fn factored(&self) -> Option<Self> {
        let [left, right] = self.products.as_slice() else {
            return None;
        };
        // Common factors cancel in the quotient of the two.
        let mut quotient = left.powers.clone();
        for (atom, exponent) in right.powers.iter() {
            quotient.add(atom.clone(), -exponent);
        }
        let [(x, power), (y, inverse_power)] = &*quotient else {
            return None;
        };
        let is_difference = (&left.number + &right.number).is_zero() && (power + inverse_power).is_zero();
        let k = power.is_integer().then(|| power.to_i64())??;
        let has_factors = (2..=HIGHEST_POWER).contains(&k.abs()) || k == -1;
        let are_fields = [x, y].iter().all(|atom| matches!(atom, Atom::Field { .. }));
        if !(is_difference && has_factors && are_fields) {
            return None;
        }
        let mut common = left.clone();
        common.powers.add(x.clone(), -power);
        Coefficient::from(common).multiply(&difference(x, y, k)).into()
    }
}

/// xᵏ − yᵏ for k = −1 and |k| ≥ 2.
fn difference(x: &Atom, y: &Atom, k: i64) -> Coefficient {
    let rest = integer(k.abs() - 1);
    let sign = integer(k.signum());
    let mut sum = Coefficient::constant(Rational::zero());
    let mut i = rest.clone();
    while i >= Rational::zero() {
        sum = sum.add(&product(x, &i * &sign, y, (&rest - &i) * &sign));
        i -= Rational::one();
    }
    let (x_alone, y_alone) =
        (product(x, Rational::one(), y, Rational::zero()), product(x, Rational::zero(), y, Rational::one()));
    if k > 0 {
        return x_alone.add(&y_alone.negated()).multiply(&sum);
    }
    y_alone.add(&x_alone.negated()).multiply(&sum).multiply(&product(x, sign.clone(), y, sign))
}

/// A power of x times one of y.
fn product(x: &Atom, power_of_x: Rational, y: &Atom, power_of_y: Rational) -> Coefficient {
    let mut powers = Powers::of(x.clone(), power_of_x);
    powers.add(y.clone(), power_of_y);
    Product { powers, number: Rational::one() }.into()
}

#[cfg(test)]
mod tests {
    use super::super::samples::{field, inverse, number, power};
    use super::*;

    fn shown(coefficient: &Coefficient) -> Option<String> {
        coefficient.factored().map(|factored| factored.to_string())
    }

    #[test]
    fn differences_of_equal_powers_have_factors() {
        let (a, b) = (field("a"), field("b"));
        let minus = |x: &Coefficient, y: &Coefficient| x.add(&y.negated());
        assert_eq!(shown(&minus(&inverse(&a), &inverse(&b))).as_deref(), Some("-(a - b)/(a·b)"));
        let cubes = minus(&power(&a, -3, 1), &power(&b, -3, 1));
        assert_eq!(shown(&cubes).as_deref(), Some("-(1/a^2 + 1/(a·b) + 1/b^2)·(a - b)/(a·b)"));
        let products = minus(&a.multiply(&power(&b, 3, 1)), &b.multiply(&power(&a, 3, 1)));
        assert_eq!(shown(&products).as_deref(), Some("-a^2·b^2·(1/a + 1/b)·(a - b)"));
    }

    #[test]
    fn other_differences_have_none() {
        let (a, b) = (field("a"), field("b"));
        for other in [
            a.add(&b.negated()),
            inverse(&a).add(&inverse(&b)),
            inverse(&a).add(&power(&b, -2, 1).negated()),
            inverse(&a).add(&inverse(&b).multiply(&number(-1, 2))),
            power(&a, 1, 2).add(&power(&b, 1, 2).negated()),
            power(&a, 13, 1).add(&power(&b, 13, 1).negated()),
            power(&a, 2, 1).add(&number(-1, 1)),
            inverse(&a.add(&number(1, 1))).add(&inverse(&b).negated()),
        ] {
            assert_eq!(other.factored(), None, "{other}");
        }
    }
}
