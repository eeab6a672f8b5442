//! What stands like a call, a name with arguments in parentheses: `sphere(R)` and `conic(R, k)`, or what is none of them.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};

use crate::diagnostics::Extent;
use crate::reading::item::closest;
use crate::reading::parse::Parser;
use crate::reading::syntax::{Expression, Kind, Surface};

impl Parser<'_> {
    /// `sphere(R)` or `conic(R, k)`, its name having been read.
    pub(super) fn surface(&mut self, name: &Ident, group: &Group) -> Expression {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        let mut arguments: Vec<&[TokenTree]> = tokens.split(is_comma).collect();
        arguments.pop_if(|last| last.is_empty());
        let named =
            tokens.iter().any(|token| matches!(token, TokenTree::Punct(equals) if equals.as_char() == '='));
        let (radius, conic_constant) = match (name.to_string().as_str(), arguments.as_slice()) {
            ("sphere", [radius]) if !named => (*radius, None),
            ("conic", [radius, conic_constant]) if !named => (*radius, Some(*conic_constant)),
            (known @ ("sphere" | "conic"), _) => {
                let place = Extent::between(self.previous, group.span().into());
                return self.fault(place, wrong_arguments(known));
            }
            ("pow" | "powi" | "powf", [base, exponent]) => {
                let (base, exponent) = (written(base), written(exponent));
                let message = format!("a power is written with `^`; write `{base}^{exponent}`");
                let place = Extent::between(self.previous, group.span().into());
                return self.fault(place, message);
            }
            (other, _) => return self.fault(name.span(), not_a_surface(other)),
        };
        self.take_token();
        let extent = Extent::between(name.span().into(), self.previous);
        let place = group.span_open();
        let radius = self.inside(radius, place);
        let conic_constant = conic_constant.map(|tokens| self.inside(tokens, place));
        let kind = Kind::Surface(Box::new(Surface { radius, conic_constant }));
        self.unless_method(Expression { kind, extent })
    }
}

fn is_comma(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(comma) if comma.as_char() == ',')
}

fn wrong_arguments(surface: &str) -> &'static str {
    match surface {
        "sphere" => "`sphere` takes the radius of the sphere; write `sphere(20)`",
        _ => "`conic` takes the radius at the vertex and the conic constant; write `conic(20, -0.5)`",
    }
}

fn not_a_surface(name: &str) -> String {
    if let Some(surface) = closest(name, vec!["sphere".to_owned(), "conic".to_owned()]) {
        return format!("`{name}` is not a surface; did you mean `{surface}`?");
    }
    format!(
        "a gap is a sum of powers of r, `sphere(R)` and `conic(R, k)`, without functions such as `{name}`; for a root \
         write `r^0.5`, for a product `*`"
    )
}

fn written(tokens: &[TokenTree]) -> String {
    let text = tokens.iter().cloned().collect::<TokenStream>().to_string();
    if tokens.len() == 1 { text } else { format!("({text})") }
}
