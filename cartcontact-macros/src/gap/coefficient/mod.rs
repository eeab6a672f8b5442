//! Exact coefficients: numbers, fields, and what is computed from them.
//!
//! The normal form is a sum of products `number * atom^e * atom^e * ...` with distinct lists of powers. An atom is a
//! field, or a whole coefficient that is not taken apart, such as `(1 + radius)` under a fraction line. Atoms are
//! compared by structure, so that equal ones merge and cancel.
//!
//! Products and powers of sums are *not* multiplied out: `(b - a) * (b + a)` is computed as written, since
//! `b*b - a*a` loses digits where `a` and `b` are close, as the radii of congruent joint surfaces are.

mod cancellation;
mod display;
mod factoring;
#[cfg(test)]
pub(crate) mod samples;
mod sign;
mod structure;

use num_bigint::BigInt;
use num_traits::{One, Zero};
use proc_macro2::Ident;

use crate::gap::like_terms::LikeTerms;
use crate::number::{self, Rational};
pub(crate) use sign::Sign;
pub(crate) use structure::is_divisor;

/// The largest power of a field: beyond it an `f64` is zero or infinite for nearly every value.
const MAXIMUM_POWER: u32 = 1024;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Coefficient {
    /// Sorted by their powers; no number is zero, and no two lists of powers are equal.
    pub(crate) products: Vec<Product>,
}

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct Product {
    /// No exponent is zero.
    pub(crate) powers: Powers,
    pub(crate) number: Rational,
}

pub(crate) type Powers = LikeTerms<Atom, Rational>;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(test, derive(Debug))]
pub(crate) enum Atom {
    Field {
        ident: Ident,
        is_positive: bool,
    },
    /// Has several products, the first with a positive number and the last with the number 1 or -1, or is the base of a
    /// power whose exponent is not an integer.
    Sum(Coefficient),
}

impl Coefficient {
    pub(crate) fn constant(number: Rational) -> Self {
        Product { powers: Powers::default(), number }.into()
    }

    pub(crate) fn field(ident: Ident) -> Self {
        Coefficient::atom(Atom::Field { ident, is_positive: false })
    }

    /// A field that is greater than 0 whenever the coefficient is computed.
    pub(crate) fn positive_field(ident: Ident) -> Self {
        Coefficient::atom(Atom::Field { ident, is_positive: true })
    }

    fn atom(atom: Atom) -> Self {
        Product { powers: Powers::of(atom, Rational::one()), number: Rational::one() }.into()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.products.is_empty()
    }

    /// The value, if it depends on no field.
    pub(crate) fn as_constant(&self) -> Option<Rational> {
        match self.products.as_slice() {
            [] => Some(Rational::zero()),
            [only] if only.powers.is_empty() => Some(only.number.clone()),
            _ => None,
        }
    }

    pub(crate) fn add(&self, other: &Self) -> Self {
        let (left, right) = (self.to_product(), other.to_product());
        if left.powers == right.powers {
            return Product { number: left.number + right.number, powers: left.powers }.into();
        }
        let mut numbers: LikeTerms<Powers, Rational> = LikeTerms::default();
        for product in self.opened().chain(other.opened()) {
            numbers.add(product.powers, product.number);
        }
        let products = numbers.into_iter().map(|(powers, number)| Product { powers, number });
        Coefficient { products: products.collect() }
    }

    pub(crate) fn negated(&self) -> Self {
        self.scaled(&-Rational::one())
    }

    pub(crate) fn multiply(&self, other: &Self) -> Self {
        match (self.as_constant(), other.as_constant()) {
            (Some(number), _) => other.scaled(&number),
            (_, Some(number)) => self.scaled(&number),
            _ => self.to_product().multiply(other.to_product()).into(),
        }
    }

    /// `self`, which is not zero, to a power, or the rule that is broken if there is none.
    pub(crate) fn power(&self, exponent: &Rational) -> Result<Self, &'static str> {
        if exponent.is_zero() {
            return Ok(Coefficient::constant(Rational::one()));
        }
        let product = self.to_product();
        if exponent.is_integer() {
            return product.integer_power(exponent.numer()).map(Into::into);
        }
        if product.powers.is_empty() {
            return root_of_number(&product.number, exponent).map(Coefficient::constant);
        }
        let powers = match product.single_atom().filter(|_| product.number.is_one()) {
            Some(atom) => Powers::of(atom, exponent.clone()),
            // The root of a square differs from the base if that is negative, so the powers stay apart.
            None => Powers::of(Atom::Sum(self.clone()), exponent.clone()),
        };
        Product { powers, number: Rational::one() }.limited().map(Into::into)
    }

    pub(crate) fn scaled(&self, number: &Rational) -> Self {
        if number.is_zero() {
            return Coefficient { products: Vec::new() };
        }
        match self.products.as_slice() {
            [_] | [] => self.times_each(number),
            _ if number.abs().is_one() => self.times_each(number),
            _ => {
                let product = self.to_product();
                Product { number: product.number * number, ..product }.into()
            }
        }
    }

    fn times_each(&self, number: &Rational) -> Self {
        let products = self.products.iter().cloned();
        Coefficient {
            products: products
                .map(|product| Product { number: product.number * number, ..product })
                .collect(),
        }
    }

    /// As one product, in which a sum becomes an atom.
    fn to_product(&self) -> Product {
        match self.products.as_slice() {
            [] => Product { powers: Powers::default(), number: Rational::zero() },
            [only] => only.clone(),
            [first, .., last] => {
                let size = last.number.abs();
                let number = if first.number.is_negative() { -size } else { size };
                let atom = Atom::Sum(self.times_each(&number.recip()));
                Product { powers: Powers::of(atom, Rational::one()), number }
            }
        }
    }

    /// The products to add up: a sum that has no factor but a number is taken apart.
    fn opened(&self) -> impl Iterator<Item = Product> {
        match self.products.as_slice() {
            [only] => match only.single_atom() {
                Some(Atom::Sum(inner)) => inner.times_each(&only.number).products,
                _ => self.products.clone(),
            },
            _ => self.products.clone(),
        }
        .into_iter()
    }
}

impl Product {
    fn multiply(mut self, other: Product) -> Product {
        for (atom, exponent) in other.powers {
            self.powers.add(atom, exponent);
        }
        Product { number: self.number * other.number, ..self }
    }

    fn integer_power(mut self, exponent: &BigInt) -> Result<Product, &'static str> {
        let number = number::power(&self.number, exponent).ok_or(TOO_LARGE)?;
        let factor = number::integer(exponent.clone());
        self.powers.map(|own| *own = &*own * &factor);
        Product { number, ..self }.limited()
    }

    fn limited(self) -> Result<Product, &'static str> {
        let limit = number::integer(MAXIMUM_POWER);
        if self.powers.iter().all(|(_, exponent)| exponent.abs() <= limit) {
            Ok(self)
        } else {
            Err("a field may be raised to powers up to 1024; write a lower one")
        }
    }

    /// The atom, if there is only one and its exponent is 1.
    fn single_atom(&self) -> Option<Atom> {
        match &*self.powers {
            [(atom, exponent)] if exponent.is_one() => Some(atom.clone()),
            _ => None,
        }
    }
}

impl From<Product> for Coefficient {
    fn from(product: Product) -> Self {
        if product.number.is_zero() {
            return Coefficient { products: Vec::new() };
        }
        match product.single_atom() {
            Some(Atom::Sum(inner)) if product.number.abs().is_one() || inner.products.len() == 1 => {
                inner.times_each(&product.number)
            }
            _ => Coefficient { products: vec![product] },
        }
    }
}

const TOO_LARGE: &str =
    "this power is too large or too small to compute with; keep it within the range of an `f64`";

fn root_of_number(number: &Rational, exponent: &Rational) -> Result<Rational, &'static str> {
    if number.is_negative() {
        return Err("a negative number has no root here; write a positive one");
    }
    let root = number::root(number, exponent.denom())
        .ok_or("this root is not a fraction, and numbers are kept exact; write it as a decimal")?;
    number::power(&root, exponent.numer()).ok_or(TOO_LARGE)
}

#[cfg(test)]
mod tests {
    use super::samples::{field, inverse, number, power};
    use crate::number::fraction;

    #[test]
    fn like_products_merge_and_cancel() {
        let (a, b) = (field("a"), field("b"));
        let sum = a.add(&b);
        assert_eq!(sum, b.add(&a));
        assert!(sum.add(&b.negated()).add(&a.negated()).is_zero());
        let half = inverse(&number(2, 1));
        let halves = sum.multiply(&half).add(&a.multiply(&half).negated());
        assert_eq!(halves, b.multiply(&half));
        assert_eq!(a.multiply(&b).multiply(&inverse(&a)), b);
    }

    #[test]
    fn sums_cancel_as_wholes() {
        let sum = number(1, 1).add(&field("a"));
        let double = number(2, 1).add(&field("a").multiply(&number(2, 1)));
        assert_eq!(double.multiply(&inverse(&sum)), number(2, 1));
        let cube = power(&sum, 3, 1);
        assert_eq!(cube.multiply(&inverse(&sum)).multiply(&inverse(&sum)), sum);
        assert!(cube.add(&cube.negated()).is_zero());
    }

    #[test]
    fn roots_are_exact_or_symbolic() {
        let half = fraction(1, 2);
        assert_eq!(power(&number(4, 1), 1, 2), number(2, 1));
        assert!(number(2, 1).power(&half).is_err() && number(-4, 1).power(&half).is_err());
        let root = power(&field("a"), 1, 2);
        assert_eq!(root.multiply(&root), field("a"));
        let doubled = field("a").multiply(&number(2, 1));
        let root = power(&doubled, 1, 2);
        assert_eq!(root.multiply(&root), doubled);
        let square = power(&field("a"), 2, 1);
        assert_ne!(power(&square, 1, 2), field("a"));
    }

    #[test]
    fn limits_are_errors() {
        assert!(number(2, 1).power(&fraction(999_999_999, 1)).is_err());
        assert!(field("a").power(&fraction(1025, 1)).is_err());
        assert_eq!(power(&number(-1, 1), 1_000_001, 1), number(-1, 1));
    }
}
