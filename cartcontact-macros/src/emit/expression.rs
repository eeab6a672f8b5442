//! Coefficients as Rust code.

use num_traits::{One, ToPrimitive};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::local;
use crate::gap::coefficient::{Atom, Coefficient, Product, is_divisor};
use crate::number::{self, Rational};

/// How parts of an expression are written.
pub(crate) struct Writer<'a> {
    pub(crate) variable: fn(&Ident) -> Ident,
    /// The variable that holds the inverse of a field, to multiply with instead of a division.
    pub(crate) inverse: &'a dyn Fn(&Ident) -> Option<Ident>,
    /// A product with a number that takes no multiplication.
    pub(crate) scaled: &'a dyn Fn(&Rational, &TokenStream) -> Option<TokenStream>,
    /// Where sums lose digits: a function that returns its first argument, a [factored](Coefficient::factored) sum, or
    /// the second one if that is not finite.
    pub(crate) finite_or: Option<&'a TokenStream>,
    pub(crate) number: &'a dyn Fn(&Rational) -> TokenStream,
    /// A power whose exponent is not an integer.
    pub(crate) power: &'a dyn Fn(&TokenStream, &Rational) -> TokenStream,
}

impl Writer<'_> {
    /// An expression over the variables of the fields, of a type that is `Copy` and has the arithmetic operators. Each
    /// product has at most one division.
    pub(crate) fn sum(&self, coefficient: &Coefficient) -> TokenStream {
        let sum = self.unfactored(coefficient);
        match (self.finite_or, coefficient.factored()) {
            (Some(finite_or), Some(factored)) => {
                let factored = self.sum(&factored);
                quote!(#finite_or(#factored, #sum))
            }
            _ => sum,
        }
    }

    fn unfactored(&self, coefficient: &Coefficient) -> TokenStream {
        let mut products = coefficient.products.iter();
        let Some(first) = products.next() else { return (self.number)(&number::integer(0)) };
        let start = self.product(first);
        let start = if first.number.is_negative() { quote!(-#start) } else { start };
        products.fold(start, |sum, product| {
            let next = self.product(product);
            if product.number.is_negative() { quote!(#sum - #next) } else { quote!(#sum + #next) }
        })
    }

    /// The product without the sign of its number.
    fn product(&self, product: &Product) -> TokenStream {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (atom, exponent) in product.powers.iter() {
            if !is_divisor(exponent) {
                above.push(self.raised(self.base(atom), exponent));
            } else if let Some(inverse) = self.inverse(atom) {
                above.push(self.raised(inverse, &exponent.abs()));
            } else {
                below.push(self.raised(self.base(atom), &exponent.abs()));
            }
        }
        let above = self.weighted(&product.number.abs(), &above);
        match below.as_slice() {
            [] => above,
            [only] => quote!(#above / #only),
            several => {
                let below = multiplied(several);
                quote!(#above / (#below))
            }
        }
    }

    fn weighted(&self, number: &Rational, factors: &[TokenStream]) -> TokenStream {
        let product = multiplied(factors);
        if factors.is_empty() {
            (self.number)(number)
        } else if number.is_one() {
            product
        } else if let Some(scaled) = (self.scaled)(number, &product) {
            scaled
        } else {
            let number = (self.number)(number);
            quote!(#number * #product)
        }
    }

    fn base(&self, atom: &Atom) -> TokenStream {
        match atom {
            Atom::Field { ident, .. } => (self.variable)(ident).to_token_stream(),
            Atom::Sum(inner) => {
                let inner = self.sum(inner);
                quote!((#inner))
            }
        }
    }

    fn inverse(&self, atom: &Atom) -> Option<TokenStream> {
        match atom {
            Atom::Field { ident, .. } => (self.inverse)(ident).map(ToTokens::into_token_stream),
            Atom::Sum(_) => None,
        }
    }

    fn raised(&self, base: TokenStream, exponent: &Rational) -> TokenStream {
        match (exponent.is_integer(), exponent.to_u32()) {
            (true, Some(1)) => base,
            (true, Some(exponent)) => {
                let variable = local("base");
                let repeated = repeated(&variable, exponent);
                quote!(({ let #variable = #base; #repeated }))
            }
            _ => (self.power)(&base, exponent),
        }
    }
}

fn multiplied(factors: &[impl ToTokens]) -> TokenStream {
    let mut product = TokenStream::new();
    for (index, factor) in factors.iter().enumerate() {
        product.extend(if index == 0 { quote!(#factor) } else { quote!(* #factor) });
    }
    product
}

/// `base` to an integer power > 0, by squaring: at least log2 of the exponent multiplications, at most twice that.
fn repeated(base: &Ident, exponent: u32) -> TokenStream {
    if exponent <= 3 {
        let copies: Vec<&Ident> = (0..exponent).map(|_| base).collect();
        return multiplied(&copies);
    }
    let square = local("square");
    let half = repeated(base, exponent / 2);
    let even = quote!(({ let #square = #half; #square * #square }));
    if exponent.is_multiple_of(2) { even } else { quote!(#even * #base) }
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;
    use crate::gap::coefficient::samples::{field, number, power};

    fn code(of: &Coefficient) -> String {
        code_with(of, None)
    }

    fn code_with(of: &Coefficient, finite_or: Option<&TokenStream>) -> String {
        code_dividing(of, finite_or, &|_| None)
    }

    fn code_dividing(
        of: &Coefficient,
        finite_or: Option<&TokenStream>,
        inverse: &dyn Fn(&Ident) -> Option<Ident>,
    ) -> String {
        let number = |value: &Rational| {
            let literal = number::literal(value);
            quote!(c(#literal))
        };
        let power = |base: &TokenStream, exponent: &Rational| {
            let exponent = number(exponent);
            quote!(p(#base, #exponent))
        };
        let variable = Ident::clone;
        let writer =
            Writer { variable, inverse, scaled: &|_, _| None, finite_or, number: &number, power: &power };
        writer.sum(of).to_string()
    }

    #[test]
    fn code_uses_the_fields_and_the_given_paths() {
        let radius = field("radius");
        assert_eq!(code(&power(&radius, -1, 1).multiply(&number(-1, 2))), "- c (0.5f64) / radius");
        assert_eq!(code(&power(&radius, -1, 2)), "p (radius , c (- 0.5f64))");
        let sum = radius.add(&number(-1, 4));
        assert_eq!(code(&sum.multiply(&radius)), "- radius * (c (0.25f64) - radius)");
    }

    #[test]
    fn inverses_replace_divisions_where_there_are_any() {
        let quotient = power(&field("b"), -1, 1).multiply(&power(&field("a"), -3, 1)).multiply(&number(1, 2));
        let of_a = |field: &Ident| (field == "a").then(|| format_ident!("inverse_of_{field}"));
        let cube = "({ let __base = inverse_of_a ; __base * __base * __base })";
        assert_eq!(code_dividing(&quotient, None, &of_a), format!("c (0.5f64) * {cube} / b"));
    }

    #[test]
    fn sums_that_would_lose_digits_are_factored() {
        let [a, b] = ["a", "b"].map(|name| power(&field(name), -1, 1));
        let difference = a.add(&b.negated());
        let plain = "c (1.0f64) / a - c (1.0f64) / b";
        assert_eq!(code(&difference), plain);
        let either = code_with(&difference, Some(&quote!(f)));
        assert_eq!(either, format!("f (- (a - b) / (a * b) , {plain})"));
    }
}
