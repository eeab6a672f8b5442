//! A name in an expression that is neither r nor a field, and what is meant by it.

use proc_macro2::Ident;

use crate::reading::item::Item;
use crate::reading::literal;
use crate::reading::name::{is_keyword, unraw};
use crate::reading::parse::NO_CONSTANTS;
use crate::reading::similar::{closest, known_number, power_of_r};
use crate::reading::unit;

/// Where a name stands, which decides what can be meant by it.
#[derive(Clone, Copy)]
pub(crate) enum Context {
    /// If the gap names r, a name such as `R` is no slip for it.
    Gap { names_r: bool },
    /// In an expression without r, such as a radius.
    Coefficient,
    /// Where only a number may stand, as in an exponent.
    Number,
}

impl Item {
    /// What to write in place of an unknown name.
    pub(crate) fn remedy(&self, name: &Ident, context: Context) -> String {
        let written = unraw(name);
        let knows_r = match context {
            Context::Gap { names_r } => !(names_r && written.eq_ignore_ascii_case("r")),
            Context::Coefficient | Context::Number => false,
        };
        let mut known = if matches!(context, Context::Number) { Vec::new() } else { self.field_names() };
        known.extend(knows_r.then(|| "r".to_owned()));
        let with_stars = || written.contains('·').then(|| literal::with_stars(&written));
        if let Some(product) = product(&written, &known).or_else(with_stars) {
            return format!(
                "a product is written with `*`; write `{product}`, and parentheses around the product behind `/`"
            );
        }
        if let Some(similar) = closest(&written, known) {
            return format!("did you mean `{similar}`?");
        }
        known_number(name).map_or_else(|| self.remedy_for_others(name, context, knows_r), str::to_owned)
    }

    /// What to write in place of a name that is like no known one.
    fn remedy_for_others(&self, name: &Ident, context: Context, knows_r: bool) -> String {
        let written = unraw(name);
        let (only, known) = match power_of_r(&written) {
            Some(power) if knows_r => (format!("for the power write `{power}`; "), format!("`{power}`")),
            _ if knows_r => ("only `r` is known here; ".to_owned(), "`r`".to_owned()),
            _ => (String::new(), "a number".to_owned()),
        };
        match context {
            Context::Number => "write a number".to_owned(),
            Context::Gap { names_r: false } if DISTANCES.contains(&&*written) => {
                "the distance from the axis is called `r`".to_owned()
            }
            _ if name == "sphere" => "a surface has a radius, as in `sphere(20)`".to_owned(),
            _ if name == "conic" => "a surface has a radius, as in `conic(20, -0.5)`".to_owned(),
            _ if unit::is_unit(&written) => unit::no_units(&written, "remove it and the operator before it"),
            // Words of Rust cannot name a field.
            _ if is_keyword(name) => format!("write {known} or a field"),
            _ if self.fields.is_empty() && is_like_constant(&written) => {
                let field = format!("`struct {} {{ {name}: f64 }}`", self.ident);
                format!("{NO_CONSTANTS}: write the number, or declare a field, as in {field}")
            }
            // A single letter is more likely one of a formula.
            _ if is_like_constant(&written) && written.chars().count() > 1 => {
                format!("{NO_CONSTANTS}: write the number, or a field of `{}`", self.ident)
            }
            _ if self.fields.is_empty() && self.others.is_empty() => {
                format!("{only}a field declares a symbol, as in `struct {} {{ {name}: f64 }}`", self.ident)
            }
            _ => format!("write {known} or a field of `{}`", self.ident),
        }
    }
}

/// The product that a name such as `kr` is meant as, if it consists of two known ones.
fn product(name: &str, known: &[String]) -> Option<String> {
    let mut splits = known.iter().filter_map(|first| Some((first, name.strip_prefix(first.as_str())?)));
    let (first, second) = splits.find(|(_, second)| known.iter().any(|known| known == second))?;
    Some(format!("{first} * {second}"))
}

/// What the distance from the axis is often called.
pub(super) const DISTANCES: [&str; 3] = ["x", "rho", "ρ"];

/// Whether constants are named like this, and fields are not.
fn is_like_constant(name: &str) -> bool {
    name.contains(char::is_uppercase) && !name.contains(char::is_lowercase)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test stops at the first surprise")]
    use quote::{format_ident, quote};

    use super::*;
    use crate::diagnostics::Diagnostics;
    use crate::reading::item::parse;

    #[test]
    fn unknown_names_get_the_closest_one() {
        let input = quote!(
            struct Ball {
                radius: f64,
            }
        );
        let item = parse(input, &mut Diagnostics::default()).unwrap();
        let remedy = |name| item.remedy(&format_ident!("{name}"), Context::Gap { names_r: false });
        assert_eq!(remedy("raduis"), "did you mean `radius`?");
        assert_eq!(remedy("R"), "did you mean `r`?");
        assert_eq!(remedy("curvature"), "write `r` or a field of `Ball`");
        assert_eq!(remedy("r4"), "write `r^4` or a field of `Ball`");
        assert!(remedy("radiusr").starts_with("a product is written with `*`; write `radius * r`"));
        assert_eq!(remedy("ρ"), "the distance from the axis is called `r`");
        assert_eq!(remedy("true"), "write `r` or a field");
        let remedy = |context| item.remedy(&format_ident!("R"), context);
        assert_eq!(remedy(Context::Gap { names_r: true }), remedy(Context::Coefficient));
        assert_eq!(remedy(Context::Coefficient), "write a number or a field of `Ball`");
        assert_eq!(remedy(Context::Number), "write a number");
    }
}
