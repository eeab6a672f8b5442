//! What people write in place of the grammar, out of habit from other languages: it is reported, with what to write.

use num_traits::One;
use proc_macro2::{Delimiter, Ident, Literal, Spacing, TokenTree};

use crate::diagnostics::Extent;
use crate::number::{Rational, decimal, integer};
use crate::reading::literal::{is_times_ten, is_whole, number, with_name};
use crate::reading::parse::{NO_OPERATOR, Parser};
use crate::reading::syntax::{Expression, Kind};
use crate::reading::{is_punct, is_sign};

impl Parser<'_> {
    /// Reads `**`, which other languages use for powers.
    pub(super) fn reads_double_star(&mut self) -> bool {
        let [TokenTree::Punct(first), TokenTree::Punct(second), rest @ ..] = self.rest else { return false };
        if first.as_char() != '*' || first.spacing() != Spacing::Joint || second.as_char() != '*' {
            return false;
        }
        self.rest = rest;
        let place = Extent::between(first.span().into(), second.span().into());
        self.previous = place;
        self.diagnostics.report(place, "a power is written with `^`, not `**`, as in `r^2`");
        true
    }

    /// Skips the point of `.*`, `./` and `.^`, which MATLAB uses for arrays.
    pub(super) fn reads_point(&mut self) {
        let [TokenTree::Punct(point), TokenTree::Punct(operator), ..] = self.rest else { return };
        let is_one = point.as_char() == '.' && point.spacing() == Spacing::Joint;
        if is_one && "*/^".contains(operator.as_char()) {
            let place = Extent::between(point.span().into(), operator.span().into());
            let message = format!("an operator is written without a point; write `{operator}`");
            self.diagnostics.report(place, message);
            self.take_token();
        }
    }

    /// Whether a second number follows the first, without an operator; `1/mm` is a unit.
    pub(super) fn is_number_next(&self) -> bool {
        let is_number = |token: &TokenTree| number(&token.to_string()).is_ok();
        matches!(self.rest, [next @ TokenTree::Literal(_), ..] if is_number(next)) && !self.is_unit_next()
    }

    /// What is wrong with `1 000`, after its first digits have been read.
    pub(super) fn spaced_number(&mut self, first: &Literal) -> Expression {
        let start = self.previous;
        let mut digits = first.to_string();
        let mut are_thousands = (1..=3).contains(&digits.len());
        while self.is_number_next()
            && let [next, ..] = self.rest
        {
            let next = next.to_string();
            are_thousands &=
                is_whole(&digits) && next.split('.').next().is_some_and(|group| group.len() == 3);
            digits += &next;
            self.take_token();
        }
        let message = if are_thousands {
            format!("a number is written without spaces; write `{digits}`")
        } else {
            NO_OPERATOR.to_owned()
        };
        self.fault(Extent::between(start, self.previous), message)
    }

    /// Whether a percent sign ends what is read; another `%` may be the remainder of a division.
    pub(super) fn is_percent_next(&self) -> bool {
        matches!(self.rest, [sign] if is_punct(sign, '%'))
    }

    /// What is wrong with `0.1%`, after its number has been read.
    pub(super) fn percent(&mut self, number: &Rational) -> Expression {
        let start = self.previous;
        self.take_token();
        let message =
            format!("a number is written without `%`; write `{}`", decimal(&(number / integer(100))));
        self.fault(Extent::between(start, self.previous), message)
    }

    /// Skips the exponent of `1.5d-4`, as in Fortran, or of `1.5 e-4` or `1.5 e4`, after `1.5d` or `1.5` has been read.
    pub(super) fn exponent_apart(&mut self, mantissa: &Literal) -> Option<String> {
        let text = mantissa.to_string();
        let of_fortran = with_name(&text).filter(|(_, name)| name.eq_ignore_ascii_case("d"));
        let (written, name) = of_fortran.unzip();
        let written = written.or_else(|| number(&text).is_ok().then_some(&*text))?;
        // Two exponents make no number.
        if written.contains(['e', 'E']) {
            return None;
        }
        self.exponent(name, written, &format!("{written} * "))
    }

    /// Skips the exponent of `(1 + 2) e-4`, behind an operand that is no number, and reports it.
    pub(super) fn reads_exponent(&mut self) -> bool {
        let start = self.previous;
        let Some(message) = self.exponent(None, "* 1", "* ") else { return false };
        self.diagnostics.report(Extent::between(start, self.previous), message);
        true
    }

    /// Skips an exponent whose `name` has been read, if that is not the next token. It is to be written behind `before`,
    /// and the product that it may be, behind `before_product`.
    fn exponent(&mut self, name: Option<&str>, before: &str, before_product: &str) -> Option<String> {
        let written;
        let (name, digits, behind) = match (name, self.rest) {
            (Some(name), behind) => (name, "", behind),
            (None, [TokenTree::Ident(next), behind @ ..]) => {
                written = next.to_string();
                (&*written, written.strip_prefix(['e', 'E'])?, behind)
            }
            _ => return None,
        };
        let (digits, product, rest) = match (digits, behind) {
            ("", [sign, TokenTree::Literal(size), rest @ ..])
                if is_sign(sign) && is_whole(&size.to_string()) =>
            {
                (format!("{sign}{size}"), format!("{name} {sign} {size}"), rest)
            }
            (digits, _) if !digits.is_empty() && is_whole(digits) => {
                (digits.to_owned(), name.to_owned(), behind)
            }
            _ => return None,
        };
        while self.rest.len() > rest.len() {
            self.take_token();
        }
        Some(format!(
            "an exponent stands right behind a number and `e`; write `{before}e{digits}`, or `{before_product}{product}` \
             if `{name}` is a field"
        ))
    }

    pub(super) fn is_times_ten_next(&self) -> bool {
        matches!(self.rest, [TokenTree::Ident(name), ..] if is_times_ten(&name.to_string()))
    }

    /// What is wrong with `1.5 x10^-4`, after its first number has been read.
    pub(super) fn times_ten(&mut self, first: &Literal) -> Expression {
        let start = self.previous;
        self.take_token();
        let message = format!("a product is written with `*`; write `{first} * 10`");
        self.fault(Extent::between(start, self.previous), message)
    }

    /// Skips an `x` between two operands.
    pub(super) fn reads_times(&mut self) -> bool {
        let [TokenTree::Ident(word), operand, ..] = self.rest else { return false };
        if !is_times(word) || matches!(operand, TokenTree::Punct(_)) {
            return false;
        }
        self.diagnostics.report(word.span(), format!("a product is written with `*`, not `{word}`"));
        self.take_token();
        true
    }

    /// Skips `as f64`, and the power after it.
    pub(super) fn reads_conversion(&mut self) -> bool {
        let [TokenTree::Ident(word), ..] = self.rest else { return false };
        if word != "as" {
            return false;
        }
        let message = "numbers here are exact and have no type; remove `as` and what follows it";
        self.diagnostics.report(word.span(), message);
        self.take_token();
        self.take_token();
        if self.take_punct('^').is_some() || self.reads_double_star() {
            self.deeper(Self::factor);
        }
        true
    }

    /// What is wrong with `r^1/2`: it is (r^1)/2, for which nobody writes the exponent.
    pub(super) fn halved_exponent(
        &self,
        base: &Expression,
        exponent: &Expression,
    ) -> Option<(Extent, String)> {
        let (Kind::Number(one), [TokenTree::Punct(slash), TokenTree::Literal(divisor), ..]) =
            (&exponent.kind, self.rest)
        else {
            return None;
        };
        if !one.is_one() || slash.as_char() != '/' || number(&divisor.to_string()).is_err() {
            return None;
        }
        let base = match &base.kind {
            Kind::Name(name) => name.to_string(),
            Kind::Number(value) => decimal(value),
            _ => "(...)".to_owned(),
        };
        let message = format!(
            "this is read as `({base}^1)/{divisor}`; write `{base}/{divisor}` if that is meant, or the exponent in \
             parentheses, `{base}^(1/{divisor})`"
        );
        Some((Extent::between(exponent.extent, divisor.span().into()), message))
    }

    /// Skips the `[0]` of `a[0]`, after its name has been read; `c [mm]` has a unit.
    pub(super) fn reads_index(&mut self, name: &Ident) -> Option<String> {
        let [TokenTree::Group(brackets), ..] = self.rest else { return None };
        if brackets.delimiter() != Delimiter::Bracket || name == "r" || self.is_unit_next() {
            return None;
        }
        let index: Vec<TokenTree> = brackets.stream().into_iter().collect();
        let [index @ (TokenTree::Literal(_) | TokenTree::Ident(_))] = index.as_slice() else { return None };
        let index = index.to_string();
        let index = if is_whole(&index) { &index } else { "1" };
        self.take_token();
        Some(format!(
            "fields are single numbers, without an index; give each number a field of its own, as in `{name}{index}`"
        ))
    }

    /// The last name of a path such as `f64::INFINITY`, after its first has been read.
    pub(super) fn end_of_path(&mut self) -> Option<Ident> {
        let mut last = None;
        while let [TokenTree::Punct(first), TokenTree::Punct(second), TokenTree::Ident(name), rest @ ..] =
            self.rest
            && first.as_char() == ':'
            && second.as_char() == ':'
        {
            last = Some(name.clone());
            self.rest = rest;
        }
        last
    }

    pub(super) fn case(&mut self, word: &Ident) -> Expression {
        let message = if word == "let" {
            "a gap is one expression, without `let`; write the number in place of its name".to_owned()
        } else {
            format!(
                "a gap is one expression for all radii, without cases such as `{word}`; use a sum of powers"
            )
        };
        self.diagnostics.report(word.span(), message);
        self.rest = &[];
        Expression { kind: Kind::Faulty, extent: word.span().into() }
    }

    /// The receiver, unless a method or a field follows it, as in the Rust expressions `r.powi(2)` and `self.radius`.
    pub(super) fn unless_method(&mut self, receiver: Expression) -> Expression {
        if let (Kind::Name(_), [TokenTree::Punct(dot), TokenTree::Literal(number), ..]) =
            (&receiver.kind, self.rest)
            && dot.as_char() == '.'
        {
            let place = Extent::between(receiver.extent, number.span().into());
            return self.fault(place, "a field of a gap has a name, as in `struct Ball { radius: f64 }`");
        }
        let [TokenTree::Punct(dot), TokenTree::Ident(member), ..] = self.rest else { return receiver };
        if dot.as_char() != '.' {
            return receiver;
        }
        let is_call = matches!(self.rest.get(2), Some(TokenTree::Group(_)));
        let message = match &receiver.kind {
            Kind::Name(name) if name == "self" || (name != "r" && !is_call) => {
                let alone = format!("fields are written by name alone; write `{member}`");
                if name != "self" && is_lower_case(name) {
                    format!("{alone}, or `{name}` if that is the field")
                } else {
                    alone
                }
            }
            Kind::Number(_) if !is_call && member.to_string().starts_with(['e', 'E']) => {
                "a decimal point has digits behind it, as in `1.0e-3`".to_owned()
            }
            Kind::Number(_) if !is_call => {
                "a decimal point has digits behind it; for a product write `*`, as in `2 * r`".to_owned()
            }
            _ => format!(
                "a gap has no methods such as `.{member}`; write powers with `^`, as in `r^2` or `r^0.5`"
            ),
        };
        self.fault(Extent::between(receiver.extent, member.span().into()), message)
    }
}

/// Whether a name is written like that of a field, not like that of a type.
fn is_lower_case(name: &Ident) -> bool {
    !name.to_string().contains(char::is_uppercase)
}

pub(super) fn is_times(name: &Ident) -> bool {
    name == "x" || name == "X"
}

pub(super) fn is_case(name: &Ident) -> bool {
    ["if", "else", "match", "for", "while", "where", "let"].iter().any(|word| name == word)
}
