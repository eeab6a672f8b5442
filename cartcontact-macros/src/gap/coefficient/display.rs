//! Coefficients as people write them.

use core::fmt::{Display, Formatter, Result};

use num_traits::One;

use super::{Atom, Coefficient, Product};
use crate::number::{self, Rational};

impl Coefficient {
    /// Whether it is written as a sum, which stands in parentheses beside other operators.
    pub(crate) fn is_sum(&self) -> bool {
        self.products.len() > 1
    }
}

impl Display for Coefficient {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        if self.is_zero() {
            return formatter.write_str("0");
        }
        for (index, product) in self.products.iter().enumerate() {
            formatter.write_str(match (index, product.number.is_negative()) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            })?;
            product.fmt(formatter)?;
        }
        Ok(())
    }
}

/// The product without the sign of its number.
impl Display for Product {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        let (below, above): (Vec<_>, Vec<_>) =
            self.powers.iter().partition(|(_, exponent)| exponent.is_negative());
        let mut numerator: Vec<String> =
            above.into_iter().map(|(atom, exponent)| raised(atom, exponent)).collect();
        let mut denominator: Vec<String> =
            below.into_iter().map(|(atom, exponent)| raised(atom, &exponent.abs())).collect();
        let number = self.number.abs();
        let short = number.numer().bits() <= 20 && number.denom().bits() <= 10;
        let (above, below) = if self.powers.is_empty() {
            (number::decimal(&number), "1".to_owned())
        } else if short {
            (number.numer().to_string(), number.denom().to_string())
        } else {
            (number::operand(&number), "1".to_owned())
        };
        if above != "1" || numerator.is_empty() {
            numerator.insert(0, above);
        }
        if below != "1" {
            denominator.insert(0, below);
        }
        formatter.write_str(&numerator.join("·"))?;
        match denominator.as_slice() {
            [] => Ok(()),
            [only] => write!(formatter, "/{only}"),
            several => write!(formatter, "/({})", several.join("·")),
        }
    }
}

fn raised(atom: &Atom, exponent: &Rational) -> String {
    let base = match atom {
        Atom::Field { ident, .. } => ident.to_string(),
        Atom::Sum(inner) => format!("({inner})"),
    };
    if exponent.is_one() {
        return base;
    }
    format!("{base}^{}", number::operand(exponent))
}

#[cfg(test)]
mod tests {
    use crate::gap::coefficient::samples::{field, number, power};

    #[test]
    fn people_read_fractions() {
        let radius = field("radius");
        assert_eq!(power(&radius, -1, 1).multiply(&number(1, 2)).to_string(), "1/(2·radius)");
        assert_eq!(power(&radius, 3, 1).multiply(&number(1, 8)).to_string(), "radius^3/8");
        assert_eq!(radius.multiply(&number(7, 64_000)).to_string(), "1.09375e-4·radius");
        assert_eq!(power(&radius, 1, 3).to_string(), "radius^(1/3)");
        assert_eq!(radius.multiply(&number(1, 1296)).to_string(), "(1/1296)·radius");
        let sum = radius.negated().add(&number(1, 1));
        assert_eq!(power(&sum, -2, 1).to_string(), "1/(1 - radius)^2");
        assert_eq!(number(1, 40).to_string(), "0.025");
    }
}
