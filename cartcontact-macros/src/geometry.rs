//! Attribute and item -> [`Geometry`]: the last stage before code is written.

use crate::diagnostics::{Diagnostics, Extent};
use crate::fault::{Change, Fault};
use crate::gap::Gap;
use crate::gap::coefficient::Coefficient;
use crate::gap::constant::WrittenConstant;
use crate::gap::evaluate::Evaluator;
use crate::gap::expansion::{self, Expanded, Truncation};
use crate::gap::options::Options;
use crate::gap::range::Range;
use crate::gap::shape::Shape;
use crate::proof::{self, Proof, Wanted};
use crate::reading::attribute::Attribute;
use crate::reading::item::Item;
use crate::reading::syntax::Expression;

/// A gap whose contact radius is determined in its range.
pub(crate) struct Geometry {
    pub(crate) gap: Gap,
    pub(crate) range: Range,
    pub(crate) proof: Proof,
    /// How surfaces were expanded, if there were any.
    pub(crate) truncation: Option<Truncation>,
}

/// Evaluates the gap and its range, and proves them. Every fault is reported.
pub(crate) fn geometry(
    attribute: &Attribute,
    item: &mut Item,
    diagnostics: &mut Diagnostics,
) -> Option<Geometry> {
    if let Some(positive) = &attribute.positive {
        positive.declare(item, diagnostics);
    }
    let mut evaluator = Evaluator::new(item, attribute.names_r(), diagnostics);
    let written = attribute.gap.as_ref()?;
    let (shape, complete) = evaluator.gap(written);
    let constant = complete.then(|| WrittenConstant::of(written, attribute.is_of_bodies, &mut evaluator));
    let limit = attribute.max_radius.as_ref();
    let range = declared_range(limit, &mut evaluator);
    let options = Options::read(attribute, &mut evaluator);
    let place = limit.map(|limit| limit.extent);
    let is_whole = complete && !attribute.lacks_option;
    let Some((range, options)) = range.zip(options).filter(|_| is_whole) else {
        check_without_range(shape, complete, (constant.as_ref(), written.extent), diagnostics);
        return None;
    };
    let declared = Declared { shape, options, range, extent: written.extent, limit: place };
    let expanded = declared.expanded();
    let Expanded { powers, truncation } =
        expanded.map_err(|fault| declared.report(&fault, diagnostics)).ok()?;
    let gap = Gap::new(powers, constant.as_ref(), declared.extent, diagnostics)?;
    let values = values(&gap, &declared.range, truncation.as_ref().ok().and_then(Option::as_ref));
    item.mark_used(|field| values.iter().any(|value| value.depends_on(field)), diagnostics);
    if let Some(positive) = &attribute.positive {
        positive.check_used(item, diagnostics);
    }
    let proved = match (declared.proof(&gap), truncation) {
        (Ok(proof), Ok(truncation)) => Ok((proof, truncation)),
        (Err(fault), Err(of_surfaces)) if of_surfaces.rank > fault.rank => Err(of_surfaces),
        (Err(fault), _) | (_, Err(fault)) => Err(fault),
    };
    let (proof, truncation) = proved.map_err(|fault| declared.report(&fault, diagnostics)).ok()?;
    Some(Geometry { gap, range: declared.range, proof, truncation })
}

/// What an attribute says, evaluated.
#[derive(Clone)]
struct Declared {
    shape: Shape,
    options: Options,
    range: Range,
    /// Where the gap was written.
    extent: Extent,
    /// Where max_radius was written.
    limit: Option<Extent>,
}

impl Declared {
    fn expanded(&self) -> Result<Expanded, Fault> {
        expansion::expand(&self.shape, &self.options, &self.range, self.limit)
    }

    fn proof(&self, gap: &Gap) -> Result<Proof, Fault> {
        let wanted = match (&self.range, self.limit) {
            (Range::Limited(radius), Some(limit)) => Wanted::UpTo(radius, limit),
            (Range::Symbolic(_), _) => Wanted::UpToSomewhere,
            _ => Wanted::AllRadii,
        };
        proof::prove(gap, &wanted)
    }

    fn report(&self, fault: &Fault, diagnostics: &mut Diagnostics) {
        let works = |change: &Change<'_>| self.with(change).is_some_and(|changed| changed.is_geometry());
        diagnostics.report(fault.extent, fault.message(&self.shape.surfaces, works));
    }

    fn with(&self, change: &Change<'_>) -> Option<Self> {
        let mut changed = self.clone();
        match change {
            Change::Order(order) => changed.options.set_order(*order),
            Change::MaxRadius(radius) => {
                changed.range = Range::of(Coefficient::constant((*radius).clone())).ok()?;
                changed.limit = self.limit.or(Some(self.extent));
            }
        }
        Some(changed)
    }

    fn is_geometry(&self) -> bool {
        let Ok(Expanded { powers, truncation: Ok(_) }) = self.expanded() else { return false };
        let gap = Gap::new(powers, None, self.extent, &mut Diagnostics::default());
        gap.is_some_and(|gap| self.proof(&gap).is_ok())
    }
}

/// Reports what is wrong with a gap whatever its options are, as these could not be read.
fn check_without_range(
    shape: Shape,
    complete: bool,
    (constant, extent): (Option<&WrittenConstant>, Extent),
    diagnostics: &mut Diagnostics,
) {
    if !complete {
        Gap::check_rest(shape.powers, diagnostics);
    } else if !shape.surfaces.is_empty() {
        drop(Gap::checked_terms(shape.powers, constant, diagnostics));
    } else if let Some(gap) = Gap::new(shape.powers, constant, extent, diagnostics)
        && let Err(fault) = proof::prove(&gap, &Wanted::UpToSomewhere)
    {
        diagnostics.report(fault.extent, fault.message(&[], |_| true));
    }
}

/// The range that `max_radius` declares, if it is written; nothing if it is faulty, which is reported.
fn declared_range(limit: Option<&Expression>, evaluator: &mut Evaluator<'_>) -> Option<Range> {
    let Some(limit) = limit else { return Some(Range::Unbounded) };
    let value = evaluator.coefficient(limit, "max_radius")?;
    Range::of(value).map_err(|message| evaluator.fault::<()>(limit.extent, message)).ok()
}

/// All values that may depend on fields.
fn values<'a>(gap: &'a Gap, range: &'a Range, truncation: Option<&'a Truncation>) -> Vec<&'a Coefficient> {
    let mut values: Vec<&Coefficient> = gap.terms.iter().map(|term| &term.coefficient).collect();
    if let Range::Symbolic(limit) = range {
        values.push(limit);
    }
    for surface in truncation.map_or(&[][..], |truncation| &truncation.unchecked) {
        values.extend([&surface.radius, &surface.shape]);
    }
    values
}
