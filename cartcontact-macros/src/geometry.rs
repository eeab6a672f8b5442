//! Attribute and item -> [`Geometry`]: the last stage before code is written.

use num_traits::Signed;

use crate::admissible::{self, Proof, Wanted};
use crate::attribute::Attribute;
use crate::coefficient::Coefficient;
use crate::diagnostics::{Diagnostics, Extent};
use crate::gap::{Evaluator, Gap};
use crate::item::Item;
use crate::number::{self, Rational};

/// A gap whose contact radius is determined in its range.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    pub(crate) gap: Gap,
    pub(crate) range: Range,
    pub(crate) proof: Proof,
}

/// The radii that the geometry is declared for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Range {
    Unbounded,
    /// Up to the exact value of an `f64`.
    Limited(Rational),
    /// Up to a radius that depends on the fields.
    Symbolic(Coefficient),
}

/// Evaluates the gap and its range, and proves them. Every fault is reported.
pub(crate) fn geometry(
    attribute: &Attribute,
    item: &mut Item,
    diagnostics: &mut Diagnostics,
) -> Option<Geometry> {
    let mut evaluator = Evaluator::new(item, diagnostics);
    let gap = attribute.gap.as_ref().and_then(|gap| evaluator.gap(gap));
    let limit = attribute.max_radius.as_ref();
    let range = match limit {
        None => Some(Range::Unbounded),
        Some(limit) => evaluator
            .coefficient(limit, "max_radius")
            .and_then(|value| range(value).map_err(|message| diagnostics.report(limit.extent, message)).ok()),
    };
    let (gap, range) = gap.zip(range)?;
    item.mark_used(
        |field| uses(&gap, &range).any(|coefficient| coefficient.fields().contains(field)),
        diagnostics,
    );
    let place = limit.map(|limit| limit.extent);
    match admissible::prove(&gap, &wanted(&range, place)) {
        Ok(proof) => Some(Geometry { gap, range, proof }),
        Err((extent, message)) => {
            diagnostics.report(extent, message);
            None
        }
    }
}

fn range(value: Coefficient) -> Result<Range, &'static str> {
    let Some(radius) = value.as_constant() else {
        return if value.is_representable() { Ok(Range::Symbolic(value)) } else { Err(UNREPRESENTABLE) };
    };
    if !radius.is_positive() {
        return Err("max_radius must be greater than 0; leave it out if the gap has no end");
    }
    number::nearest(&radius).and_then(Rational::from_float).map(Range::Limited).ok_or(UNREPRESENTABLE)
}

const UNREPRESENTABLE: &str = "max_radius does not fit into an `f64`; leave it out if the gap has no end";

fn wanted(range: &Range, place: Option<Extent>) -> Wanted<'_> {
    match (range, place) {
        (Range::Limited(radius), Some(place)) => Wanted::UpTo(radius, place),
        (Range::Symbolic(_), _) => Wanted::UpToSomewhere,
        _ => Wanted::AllRadii,
    }
}

fn uses<'a>(gap: &'a Gap, range: &'a Range) -> impl Iterator<Item = &'a Coefficient> {
    let limit = match range {
        Range::Symbolic(limit) => Some(limit),
        _ => None,
    };
    gap.terms.iter().map(|term| &term.coefficient).chain(limit)
}
