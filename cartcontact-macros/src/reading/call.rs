//! What looks like a call, a name with arguments in parentheses: `sphere(R)`, `conic(R, k)`, or neither of them.

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};

use crate::diagnostics::Extent;
use crate::reading::is_punct;
use crate::reading::parse::Parser;
use crate::reading::similar::closest;
use crate::reading::syntax::{Expression, Kind, Surface};

impl Parser<'_> {
    /// `sphere(R)` or `conic(R, k)`, after its name has been read.
    pub(super) fn surface(&mut self, name: &Ident, group: &Group) -> Expression {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        let has_other_marks = tokens.iter().any(|token| is_punct(token, '=') || is_punct(token, ';'));
        let (radius, conic_constant) = match (name.to_string().as_str(), arguments(&tokens).as_slice()) {
            ("sphere", [radius]) if !has_other_marks => (*radius, None),
            ("conic", [radius, conic_constant]) if !has_other_marks => (*radius, Some(*conic_constant)),
            _ => {
                let place = Extent::between(name.span().into(), group.span().into());
                return match self.wrong_arguments(name, &tokens) {
                    Some(message) => self.fault(place, message),
                    None => self.function(name.span(), name, group),
                };
            }
        };
        self.take_token();
        let extent = Extent::between(name.span().into(), self.previous);
        let place = group.span_open();
        let radius = self.inside(radius, place);
        let conic_constant = conic_constant.map(|tokens| self.inside(tokens, place));
        let kind = Kind::Surface(Box::new(Surface { radius, conic_constant }));
        self.unless_method(Expression { kind, extent })
    }

    /// Anything else with arguments, whose name may end a path, which begins at `start`.
    pub(super) fn function(&mut self, start: Span, name: &Ident, group: &Group) -> Expression {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        match self.power_function(name, &arguments(&tokens)) {
            Some(message) => self.fault(Extent::between(start.into(), group.span().into()), message),
            None => self.fault(name.span(), not_a_surface(&name.to_string())),
        }
    }

    /// What to say about a function that raises to a power.
    fn power_function(&self, name: &Ident, arguments: &[&[TokenTree]]) -> Option<String> {
        let written = match (name.to_string().to_lowercase().as_str(), arguments) {
            ("pow" | "powi" | "powf" | "power", [base, exponent]) => {
                Some(format!("{}^{}", operand(base), operand(exponent)))
            }
            ("sq" | "sqr" | "square", [base]) => Some(format!("{}^2", operand(base))),
            ("cbrt", [base]) => Some(format!("{}^(1/3)", operand(base))),
            ("pow" | "powi" | "powf" | "power", _) => None,
            _ => return None,
        };
        let are_readable = arguments.iter().all(|argument| self.is_expression(argument));
        Some(match written.filter(|_| are_readable) {
            Some(power) => format!("a power is written with `^`; write `{power}`"),
            None => "a power is written with `^`, as in `r^2`".to_owned(),
        })
    }
}

/// The tokens between the commas, of which one may stand behind the last.
pub(super) fn arguments(tokens: &[TokenTree]) -> Vec<&[TokenTree]> {
    let mut arguments: Vec<&[TokenTree]> = tokens.split(|token| is_punct(token, ',')).collect();
    arguments.pop_if(|last| last.is_empty());
    arguments
}

fn not_a_surface(name: &str) -> String {
    if let Some(meant) = other_shape(name) {
        return format!("`{name}` is not among the surfaces; {meant}");
    }
    if let Some(instead) = instead_of_function(name) {
        return format!("a gap has no functions such as `{name}`; write {instead}");
    }
    match closest(name, vec!["sphere".to_owned(), "conic".to_owned()]) {
        Some(surface) if surface != name => format!("`{name}` is not a surface; did you mean `{surface}`?"),
        _ => format!(
            "a gap is a sum of powers of r, `sphere(R)` and `conic(R, k)`, without functions such as `{name}`; for a \
             product write `*`"
        ),
    }
}

/// What stands for a function in a gap.
fn instead_of_function(name: &str) -> Option<&'static str> {
    if name.eq_ignore_ascii_case("sqrt") {
        return Some("`sphere(R)` for R - sqrt(R^2 - r^2), and `r^0.5` for a root");
    }
    let has_series = ["exp", "sin", "cos", "tan", "sinh", "cosh", "tanh", "ln", "log"].contains(&name);
    has_series.then_some("the first terms of its series, a sum of powers of r")
}

/// What to say about another shape that a bone may have.
fn other_shape(name: &str) -> Option<&'static str> {
    Some(match name.to_lowercase().as_str() {
        "paraboloid" | "parabola" => "write `conic(R, -1)`, or the power that it is, `r^2 / (2 * R)`",
        "ellipsoid" | "ellipse" => {
            "write `conic(R, k)` with `k` above -1, and the radius of curvature `R` on the axis"
        }
        "hyperboloid" | "hyperbola" => {
            "write `conic(R, k)` with `k` below -1, and the radius of curvature `R` on the axis"
        }
        "cone" => "write the power that it is, as in `0.1 * r`",
        "plane" | "flat" => "a flat body is `0`",
        "cylinder" | "torus" => "the contact is axisymmetric, between surfaces of revolution",
        _ => return None,
    })
}

fn operand(tokens: &[TokenTree]) -> String {
    let text = tokens.iter().cloned().collect::<TokenStream>().to_string();
    if tokens.len() == 1 { text } else { format!("({text})") }
}
