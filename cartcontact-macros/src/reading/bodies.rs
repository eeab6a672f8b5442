//! The two bodies of a gap, `upper = ...` and `lower = ...`, and entries that are meant as bodies.

use proc_macro2::{Ident, Span};

use crate::diagnostics::{Diagnostics, Extent};
use crate::reading::entry::{Assignment, Entry};
use crate::reading::syntax::{Expression, Kind, Summand};

/// A name that stands for a body, and which of `upper` and `lower` it is meant as.
type OtherName<'a> = (&'a Ident, &'static str);

/// The names that two bodies have been given in place of `upper` and `lower`, each with the one that is meant: `femur =
/// sphere(20), tibia = sphere(30)`. Empty if something else is written.
pub(super) fn of_other_names(entries: &[Entry]) -> Vec<OtherName<'_>> {
    let options = entries.iter().filter_map(Entry::assignment);
    let written: Vec<&Ident> = options.map(|option| option.name).collect();
    let mut free: Vec<&str> =
        ["upper", "lower"].into_iter().filter(|body| !written.iter().any(|name| *name == body)).collect();
    let named: Vec<&Ident> = entries.iter().filter_map(Entry::body_of_other_name).collect();
    let are_two = match named.as_slice() {
        [first, second] => free.len() == 2 && first != second,
        [_] => free.len() == 1,
        _ => false,
    };
    if !are_two {
        return Vec::new();
    }
    if named.first().is_some_and(|first| *first == "bottom") {
        free.reverse();
    }
    named.into_iter().zip(free).collect()
}

/// The body that an option stands for, possibly by another name.
pub(super) fn read(
    option: &Assignment<'_>,
    of_other_names: &[OtherName<'_>],
    diagnostics: &mut Diagnostics,
) -> Expression {
    if let Some(message) = other_name(option.name, of_other_names) {
        diagnostics.report(option.name.span(), message);
    }
    option.expression(diagnostics)
}

/// Whether this is the name of a body, or is meant as one.
pub(super) fn names_body(name: &Ident, of_other_names: &[OtherName<'_>]) -> bool {
    name == "upper" || name == "lower" || other_name(name, of_other_names).is_some()
}

/// What to say about a name that is meant as the name of a body.
fn other_name(name: &Ident, of_other_names: &[OtherName<'_>]) -> Option<String> {
    let (_, meant) = of_other_names.iter().find(|(other, _)| *other == name)?;
    Some(format!(
        "`{name}` is not an option; the two bodies of a gap are called `upper` and `lower`; write `{meant} =`"
    ))
}

/// The gap, from one expression or two bodies in the order in which they were written.
pub(super) fn whole(
    gap: Option<Expression>,
    bodies: Vec<(&Ident, Expression)>,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    let summand = |expression| Summand { subtracted: false, expression };
    match (gap, bodies.as_slice()) {
        (gap @ Some(_), []) => gap,
        // The unreadable entry may be a body.
        (Some(gap @ Expression { kind: Kind::Faulty, .. }), _) => {
            let extent = gap.extent;
            let read = bodies.into_iter().map(|(_, expression)| expression);
            Some(Expression { kind: Kind::Sum(read.chain([gap]).map(summand).collect()), extent })
        }
        (Some(gap), _) => {
            let names: Vec<String> = bodies.iter().map(|(name, _)| format!("`{name}`")).collect();
            let names = names.join(" and ");
            let message = format!("a gap is one expression or two bodies; remove {names} or the expression");
            diagnostics.report(gap.extent, message);
            None
        }
        (None, []) => {
            let message = "the gap is missing; write it first, as in `#[gap_profile(0.025 * r^2)]`";
            diagnostics.report(Span::call_site(), message);
            None
        }
        (None, [(name, _)]) => {
            let other = if *name == "upper" { "lower" } else { "upper" };
            let message = format!(
                "a gap lies between two bodies, and `{other}` is missing; a flat one is written `{other} = 0`"
            );
            diagnostics.report(name.span(), message);
            None
        }
        (None, [(_, first), .., (_, last)]) => {
            let extent = Extent::between(first.extent, last.extent);
            let bodies = bodies.into_iter().map(|(_, expression)| summand(expression));
            Some(Expression { kind: Kind::Sum(bodies.collect()), extent })
        }
    }
}
