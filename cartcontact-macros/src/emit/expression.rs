//! Coefficients as Rust code.

use num_traits::{One, ToPrimitive};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::coefficients::{Coefficients, Digits, field_variable, inverse_variable};
use super::local;
use crate::gap::coefficient::{Atom, Coefficient, Product, is_divisor};
use crate::number::{Rational, integer};

impl Coefficients<'_> {
    /// An expression in the fields, over the variables that [`fields`](Self::fields) and [`inverses`](Self::inverses)
    /// bind. Each product has at most one division. In words, a sum that would lose digits is
    /// [factored](Coefficient::factored), unless that is not finite.
    pub(super) fn expression(&self, coefficient: &Coefficient) -> TokenStream {
        let sum = self.unfactored(coefficient);
        match coefficient.factored() {
            Some(factored) if self.digits == Digits::OfAWord => {
                let (finite_or, factored) = (self.names.generated("finite_or"), self.expression(&factored));
                quote!(#finite_or(#factored, #sum))
            }
            _ => sum,
        }
    }

    fn unfactored(&self, coefficient: &Coefficient) -> TokenStream {
        let mut products = coefficient.products.iter();
        let Some(first) = products.next() else { return self.number(&integer(0)) };
        let start = self.product(first);
        let start = if first.number.is_negative() { quote!(-#start) } else { start };
        products.fold(start, |sum, product| {
            let next = self.product(product);
            if product.number.is_negative() { quote!(#sum - #next) } else { quote!(#sum + #next) }
        })
    }

    /// The product without the sign of its number.
    fn product(&self, product: &Product) -> TokenStream {
        let number = product.number.abs();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (atom, exponent) in product.powers.iter() {
            if is_divisor(exponent) {
                below.push(self.raised(self.base(atom), &exponent.abs()));
            } else {
                above.push(self.raised(self.base(atom), exponent));
            }
        }
        if let Some((field, exponent)) = self.with_shared_inverse(product) {
            return self.times_power_of_inverse(&number, above, field, &exponent.abs());
        }
        let above = self.weighted(&number, &above);
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
        let [first, others @ ..] = factors else { return self.number(number) };
        let start = if number.is_one() {
            first.clone()
        } else if let Some(scaled) = self.scaled(number, first) {
            scaled
        } else {
            let number = self.number(number);
            quote!(#number * #first)
        };
        quote!(#start #(* #others)*)
    }

    fn base(&self, atom: &Atom) -> TokenStream {
        match atom {
            Atom::Field { ident, .. } => field_variable(ident).into_token_stream(),
            Atom::Sum(inner) => {
                let inner = self.expression(inner);
                quote!((#inner))
            }
        }
    }

    /// The only divisor, if a variable holds its inverse, to multiply with instead of a division. Inverses of several
    /// divisors, one after the other, may leave the format where the product of these divisors does not.
    fn with_shared_inverse<'b>(&self, product: &'b Product) -> Option<(&'b Ident, &'b Rational)> {
        product.only_divisor().filter(|(field, _)| self.shares_inverse(field))
    }

    /// The product of a number, factors, and a power of the inverse of a field.
    ///
    /// That power alone may be infinite where the product is not, as 1e-5/c² at c = 1e-155. It is multiplied in parts,
    /// after which the product so far lies between that of the other factors and the whole one.
    fn times_power_of_inverse(
        &self,
        number: &Rational,
        mut factors: Vec<TokenStream>,
        field: &Ident,
        exponent: &Rational,
    ) -> TokenStream {
        let inverse = inverse_variable(field).into_token_stream();
        match exponent.to_u32() {
            Some(count @ ..=3) => factors.extend((0..count).map(|_| inverse.clone())),
            Some(count) => {
                let half = local("half").into_token_stream();
                let value = self.raised(inverse.clone(), &integer(count / 2));
                factors.extend([half.clone(), half.clone()]);
                factors.extend((!count.is_multiple_of(2)).then_some(inverse));
                let product = self.weighted(number, &factors);
                return quote!(({ let #half = #value; #product }));
            }
            None => factors.push(self.raised(inverse, exponent)),
        }
        self.weighted(number, &factors)
    }

    fn raised(&self, base: TokenStream, exponent: &Rational) -> TokenStream {
        match (exponent.is_integer(), exponent.to_u32()) {
            (true, Some(1)) => base,
            (true, Some(exponent)) => {
                let variable = local("base");
                let repeated = repeated(&variable, exponent);
                quote!(({ let #variable = #base; #repeated }))
            }
            _ => self.power(&base, exponent),
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
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use super::super::Names;
    use super::*;
    use crate::diagnostics::Diagnostics;
    use crate::reading::item;
    use crate::tests::run;

    /// The first coefficient of a gap, with short names.
    fn code(gap: &str, digits: Digits) -> String {
        let input = quote!(
            struct Knee {
                a: f64,
                b: f64,
            }
        );
        let item = item::parse(input.clone(), &mut Diagnostics::default()).unwrap();
        let geometry = run(gap.parse().unwrap(), input).unwrap();
        let names = Names::of(&item);
        let coefficients = Coefficients { digits, ..Coefficients::new(&item, &geometry, &names) };
        let code = coefficients.expression(&geometry.gap.terms[0].coefficient).to_string();
        let names = [
            ("< T as __cartcontact :: Scalar > :: constant", "c"),
            ("< __cartcontact :: Precise < T , __FUSED > >", "Precise"),
            ("__cartcontact :: ", ""),
            ("__field_", ""),
        ];
        names.iter().fold(code, |code, (name, short)| code.replace(name, short))
    }

    #[test]
    fn code_uses_the_fields_and_the_operators() {
        for (gap, expected) in [
            ("-r^2 / (2 * a)", "- c (0.5f64) / a"),
            ("r^2 / a^0.5", "real_power (a , Exponent :: in_parts (- 1 , 0.5 , 0.0))"),
            ("(a - 1/4) * a * r^2", "- a * (c (0.25f64) - a)"),
        ] {
            assert_eq!(code(gap, Digits::OfAWord), expected, "{gap}");
        }
    }

    #[test]
    fn inverses_replace_divisions_where_there_are_several() {
        let quotient = "Precise :: scaled (b , 0.5f64) * __inverse_a * __inverse_a * __inverse_a";
        assert_eq!(code("r^2 * b / (2 * a^3) + r^4 / a", Digits::OfTwo), quotient);
    }

    /// 1/a alone may be infinite or zero where 1/(a b) is neither.
    #[test]
    fn several_divisors_are_multiplied_first() {
        let quotient = "Precise :: constant (1.0 , 0.0) / (a * b)";
        assert_eq!(code("r^2 / (a * b) + r^4 / a + r^6 / a^2", Digits::OfTwo), quotient);
    }

    /// The fifth power alone may be infinite.
    #[test]
    fn powers_of_inverses_are_multiplied_in_parts() {
        let half = "let __half = ({ let __base = __inverse_a ; __base * __base }) ;";
        let product = "b * __half * __half * __inverse_a";
        assert_eq!(code("r^2 * b / a^5 + r^4 / a", Digits::OfTwo), format!("({{ {half} {product} }})"));
    }

    #[test]
    fn sums_that_would_lose_digits_are_factored() {
        let difference = "r^2 / a - r^2 / b";
        let factored = "finite_or (- (a - b) / (a * b) , c (1.0f64) / a - c (1.0f64) / b)";
        assert_eq!(code(difference, Digits::OfAWord), factored);
        let plain = "Precise :: constant (1.0 , 0.0) / a - Precise :: constant (1.0 , 0.0) / b";
        assert_eq!(code(difference, Digits::OfTwo), plain);
    }
}
