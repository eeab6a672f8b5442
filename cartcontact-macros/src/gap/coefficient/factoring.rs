//! Sums and differences of equal powers of two fields as products, which lose no digits.
//!
//! ```text
//! xᵏ − yᵏ   = (x − y) Σ xⁱ yʲ               i + j = k − 1
//! x⁻ᵏ − y⁻ᵏ = (y − x)/(x y) Σ x⁻ⁱ y⁻ʲ
//! ```
//!
//! and the same with −y for y. The difference of two fields is rounded once, however near they are. For an odd k the sum
//! is at least 1/k of its magnitudes, for any x and y; for an even k it has the factor x + y, and is formed without loss
//! only if it is no more than that.

use num_traits::{One, ToPrimitive, Zero};

use super::{Atom, Coefficient, Powers, Product};
use crate::number::{Rational, integer};

/// The highest power that is taken apart; the sum has as many products.
const HIGHEST_POWER: i64 = 11;

impl Coefficient {
    /// The same as a product, if it is a sum of powers of two fields that may cancel. They may have common factors.
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
        let k = power.is_integer().then(|| power.to_i64())??;
        let ratio = -(&right.number / &left.number);
        let is_odd = k % 2 != 0 && k != 1 && k.abs() <= HIGHEST_POWER;
        let has_factors = ratio.abs().is_one() && (is_odd || k == 2 && ratio.is_positive());
        let are_fields = [x, y].iter().all(|atom| matches!(atom, Atom::Field { .. }));
        let may_cancel = self.certain_sign().is_none();
        if !(has_factors && (power + inverse_power).is_zero() && are_fields && may_cancel) {
            return None;
        }
        let mut common = left.clone();
        common.powers.add(x.clone(), -power);
        Some(Coefficient::from(common).multiply(&difference(x, y, &ratio, k)))
    }
}

/// xᵏ − (`sign` y)ᵏ, for a sign of ±1.
fn difference(x: &Atom, y: &Atom, sign: &Rational, k: i64) -> Coefficient {
    let direction = k.signum();
    let last = k.abs() - 1;
    let mut sum = Coefficient::constant(Rational::zero());
    let mut sign_of_product = Rational::one();
    for j in 0..=last {
        sum = sum.add(&powers(x, (last - j) * direction, y, j * direction).scaled(&sign_of_product));
        sign_of_product = &sign_of_product * sign;
    }
    let (x_alone, y_alone) = (powers(x, 1, y, 0), powers(x, 0, y, 1).scaled(sign));
    if k > 0 {
        return x_alone.add(&y_alone.negated()).multiply(&sum);
    }
    let inverse = powers(x, -1, y, -1).scaled(sign);
    y_alone.add(&x_alone.negated()).multiply(&sum).multiply(&inverse)
}

/// A power of x times one of y.
fn powers(x: &Atom, power_of_x: i64, y: &Atom, power_of_y: i64) -> Coefficient {
    let mut powers = Powers::of(x.clone(), integer(power_of_x));
    powers.add(y.clone(), integer(power_of_y));
    Product { powers, number: Rational::one() }.into()
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;
    use crate::gap::coefficient::samples::{field, inverse, number, power};

    fn shown(coefficient: &Coefficient) -> Option<String> {
        coefficient.factored().map(|factored| factored.to_string())
    }

    #[test]
    fn sums_of_equal_powers_have_factors() {
        let (a, b) = (field("a"), field("b"));
        let minus = |x: &Coefficient, y: &Coefficient| x.add(&y.negated());
        assert_eq!(shown(&minus(&inverse(&a), &inverse(&b))).as_deref(), Some("-(a - b)/(a·b)"));
        assert_eq!(shown(&inverse(&a).add(&inverse(&b))).as_deref(), Some("(a + b)/(a·b)"));
        let cubes = [&a, &b].map(|radius| power(radius, -3, 1));
        assert_eq!(
            shown(&minus(&cubes[0], &cubes[1])).as_deref(),
            Some("-(1/a^2 + 1/(a·b) + 1/b^2)·(a - b)/(a·b)")
        );
        assert_eq!(
            shown(&cubes[0].add(&cubes[1])).as_deref(),
            Some("(1/a^2 - 1/(a·b) + 1/b^2)·(a + b)/(a·b)")
        );
        let products = minus(&a.multiply(&power(&b, 3, 1)), &b.multiply(&power(&a, 3, 1)));
        assert_eq!(shown(&products), None);
        let squares = minus(&power(&a, 2, 1), &power(&b, 2, 1));
        assert_eq!(shown(&squares).as_deref(), Some("(a - b)·(a + b)"));
    }

    #[test]
    fn other_sums_have_none() {
        let (a, b) = (field("a"), field("b"));
        let lengths = ["a", "b"].map(|name| inverse(&Coefficient::positive_field(format_ident!("{name}"))));
        for other in [
            a.add(&b.negated()),
            lengths[0].add(&lengths[1]),
            inverse(&a).add(&power(&b, -2, 1).negated()),
            inverse(&a).add(&inverse(&b).multiply(&number(-1, 2))),
            power(&a, -2, 1).add(&power(&b, -2, 1).negated()),
            power(&a, 2, 1).add(&power(&b, 2, 1)),
            // Its sign is that of c.
            field("c").multiply(&power(&a, 2, 1)).add(&field("c").multiply(&power(&b, 2, 1))),
            power(&a, 1, 2).add(&power(&b, 1, 2).negated()),
            power(&a, 13, 1).add(&power(&b, 13, 1).negated()),
            power(&a, 2, 1).add(&number(-1, 1)),
            inverse(&a.add(&number(1, 1))).add(&inverse(&b).negated()),
        ] {
            assert_eq!(other.factored(), None, "{other}");
        }
    }
}
