//! [`Shape`] -> [`Polynomial`]: surfaces are expanded in even powers of r, up to the order that was asked for.
//!
//! `order = auto` takes the smallest order whose neglected terms are within the tolerance. An order without a surface
//! is refused, as it would cut off nothing: powers of r are kept however high they are.

use num_traits::{One, ToPrimitive};

use crate::diagnostics::Extent;
use crate::gap::MAXIMUM_EXPONENT;
use crate::gap::coefficient::Coefficient;
use crate::gap::evaluate::Evaluator;
use crate::gap::polynomial::{Monomial, Polynomial};
use crate::gap::range::Range;
use crate::gap::shape::Shape;
use crate::gap::surface::Surface;
use crate::gap::truncation::{BeyondRim, HIGHEST_ORDER, Neglected, three_digits};
use crate::number::{Rational, decimal, integer, nearest};
use crate::reading::attribute::Attribute;
use crate::reading::syntax::{Expression, Kind};

/// A place and what is wrong there.
type Fault = (Extent, String);

/// How far surfaces were expanded.
pub(crate) struct Truncation {
    pub(crate) order: u32,
    /// What is neglected at most, relative to the gap, if that can be told when the program is compiled.
    pub(crate) error: Option<Rational>,
    /// The surfaces that max_radius must lie inside of, as far as that is not known when the program is compiled.
    pub(crate) unchecked: Vec<Surface>,
}

/// The options that govern the expansion.
pub(crate) struct Options {
    order: Option<(Order, Extent)>,
    tolerance: Option<(Rational, Extent)>,
}

enum Order {
    Fixed(u32),
    Smallest,
}

impl Options {
    /// The options of an attribute; nothing if one is faulty.
    pub(crate) fn read(attribute: &Attribute, evaluator: &mut Evaluator<'_>) -> Option<Self> {
        let order = attribute.order.as_ref().map(|written| read_order(written, evaluator));
        let tolerance = attribute.tolerance.as_ref().map(|written| read_tolerance(written, evaluator));
        Some(Options { order: transposed(order)?, tolerance: transposed(tolerance)? })
    }
}

/// An option that is there must have a value.
fn transposed<T>(option: Option<Option<T>>) -> Option<Option<T>> {
    match option {
        None => Some(None),
        Some(value) => value.map(Some),
    }
}

fn read_order(written: &Expression, evaluator: &mut Evaluator<'_>) -> Option<(Order, Extent)> {
    let extent = written.extent;
    let number = match &written.kind {
        Kind::Name(name) if name == "auto" => return Some((Order::Smallest, extent)),
        Kind::Name(_) => return evaluator.fault(extent, ORDER),
        _ => evaluator.number(written, ORDER)?,
    };
    if number > integer(HIGHEST_ORDER) {
        let message =
            format!("order must be at most {HIGHEST_ORDER}; lower max_radius if less does not suffice");
        return evaluator.fault(extent, message);
    }
    match (&number / integer(2)).to_u32().filter(|half| integer(2 * half) == number && *half > 0) {
        Some(half) => Some((Order::Fixed(2 * half), extent)),
        None => {
            let next = (number.max(Rational::one()) / integer(2)).ceil() * integer(2);
            let message = format!(
                "order must be even and above 0, as surfaces have even powers of r only; write `order = {next}`"
            );
            evaluator.fault(extent, message)
        }
    }
}

fn read_tolerance(written: &Expression, evaluator: &mut Evaluator<'_>) -> Option<(Rational, Extent)> {
    let tolerance = evaluator.number(written, TOLERANCE)?;
    let is_fraction = tolerance.is_positive() && tolerance < Rational::one() && nearest(&tolerance).is_some();
    if is_fraction { Some((tolerance, written.extent)) } else { evaluator.fault(written.extent, TOLERANCE) }
}

const ORDER: &str = "order must be an even number, as in `order = 4`, or `auto`";
const TOLERANCE: &str =
    "tolerance must be a number between 0 and 1, a fraction of the gap; write `tolerance = 1e-6`";

/// Expands the surfaces, if there are any; `limit` is where max_radius was written.
pub(crate) fn expand(
    shape: Shape,
    options: &Options,
    range: &Range,
    limit: Option<Extent>,
) -> Result<(Polynomial, Option<Truncation>), Fault> {
    let Some(first) = shape.surfaces.first() else { return without_surfaces(shape.powers, options) };
    let Some((order, place)) = &options.order else {
        let wanted = if options.tolerance.is_some() { "auto" } else { "4" };
        let message = format!(
            "a surface is expanded in powers of r; say how far, as in `order = {wanted}`, after a comma"
        );
        return Err((first.extent, message));
    };
    let expansion = Expansion { shape: &shape, range, limit };
    let order = expansion.order(order, *place, options.tolerance.as_ref())?;
    let too_hard = |message: &'static str| (*place, message.to_owned());
    let error = match (expansion.neglected(order)?, limit) {
        (Bounded::By(neglected), Some(limit)) => match neglected.bound(order).map_err(too_hard)? {
            None => return Err((limit, OVERWHELMED.to_owned())),
            bound => bound,
        },
        _ => None,
    };
    // What is bounded has been compared with the range.
    let unchecked = if error.is_none() && limit.is_some() {
        shape.surfaces.iter().filter(|surface| !surface.shape.is_zero()).cloned().collect()
    } else {
        Vec::new()
    };
    Ok((expanded(shape, order)?, Some(Truncation { order, error, unchecked })))
}

const OVERWHELMED: &str = "the terms that the order neglects are as large as the gap itself before max_radius; lower \
                           max_radius, or raise the order";

fn without_surfaces(
    powers: Polynomial,
    options: &Options,
) -> Result<(Polynomial, Option<Truncation>), Fault> {
    let order = options.order.as_ref().map(|(_, extent)| *extent);
    let tolerance = options.tolerance.as_ref().map(|(_, extent)| *extent);
    let (place, named, them) = match (order, tolerance) {
        (Some(order), Some(_)) => (order, "`order` and `tolerance` are", "them"),
        (Some(order), None) => (order, "`order` is", "it"),
        (None, Some(tolerance)) => (tolerance, "`tolerance` is", "it"),
        (None, None) => return Ok((powers, None)),
    };
    // A gap of which nothing is left is reported when it is checked.
    if powers.terms().is_empty() {
        return Ok((powers, None));
    }
    let message =
        format!("{named} for surfaces, and this gap has no `sphere(R)` or `conic(R, k)`; remove {them}");
    Err((place, message))
}

/// What is neglected has a bound, or a reason why none is known when the program is compiled.
enum Bounded {
    By(Neglected),
    Not(&'static str),
}

/// Surfaces that are expanded, and the range on which; `limit` is where its end was written.
struct Expansion<'a> {
    shape: &'a Shape,
    range: &'a Range,
    limit: Option<Extent>,
}

impl Expansion<'_> {
    /// The order that was asked for, which was written at `place`, if it is within the tolerance.
    fn order(
        &self,
        order: &Order,
        place: Extent,
        tolerance: Option<&(Rational, Extent)>,
    ) -> Result<u32, Fault> {
        let too_hard = |message: &'static str| (place, message.to_owned());
        let neglected = |highest, extent: Extent| match self.neglected(highest)? {
            Bounded::By(neglected) => Ok(neglected),
            Bounded::Not(reason) => Err((extent, reason.to_owned())),
        };
        match (order, tolerance) {
            (Order::Fixed(order), None) => Ok(*order),
            (Order::Smallest, None) => {
                let range = if self.limit.is_some() { "" } else { ", max_radius = 6.0" };
                let message =
                    format!("`order = auto` meets a tolerance; add one, as in `tolerance = 1e-6{range}`");
                Err((place, message))
            }
            (Order::Smallest, Some((tolerance, extent))) => {
                let smallest = neglected(HIGHEST_ORDER, *extent)?.smallest_order(tolerance);
                smallest.map_err(too_hard)?.ok_or_else(|| (*extent, unattainable()))
            }
            (Order::Fixed(order), Some((tolerance, extent))) => {
                if neglected(*order, *extent)?.is_within(tolerance, *order).map_err(too_hard)? {
                    return Ok(*order);
                }
                let message = too_low(*order, tolerance, &neglected(HIGHEST_ORDER, *extent)?);
                Err((place, message.map_err(too_hard)?))
            }
        }
    }

    /// What orders up to the highest neglect.
    fn neglected(&self, highest: u32) -> Result<Bounded, Fault> {
        let (radius, limit) = match (self.range, self.limit) {
            (Range::Limited(radius), Some(limit)) => (radius, limit),
            (Range::Symbolic(_), _) => return Ok(Bounded::Not(RANGE_OF_FIELDS)),
            _ => return Ok(Bounded::Not(NO_RANGE)),
        };
        if self.shape.powers.terms().iter().any(|(exponent, _)| !is_of_a_gap(exponent)) {
            return Ok(Bounded::Not(NOT_A_GAP));
        }
        match Neglected::new(self.shape, radius, highest) {
            None => Ok(Bounded::Not(GAP_OF_FIELDS)),
            Some(Ok(neglected)) => Ok(Bounded::By(neglected)),
            Some(Err(BeyondRim(rim))) => Err((limit, beyond_rim(rim))),
        }
    }
}

/// Other exponents are reported when the gap is checked, and would take long to raise a radius to.
fn is_of_a_gap(exponent: &Rational) -> bool {
    exponent.is_positive() && *exponent <= integer(MAXIMUM_EXPONENT)
}

const NO_RANGE: &str = "a tolerance is met up to some radius; say which, as in `max_radius = 6.0`";
const NOT_A_GAP: &str =
    "a tolerance is relative to a gap that opens at r = 0; write one with positive powers";
const GAP_OF_FIELDS: &str = "a tolerance is proved when the program is compiled, and this gap depends on fields; remove \
                             it and write a number for the order";
const RANGE_OF_FIELDS: &str = "a tolerance is proved when the program is compiled, and max_radius depends on fields; \
                               write a number there";

fn beyond_rim(rim: f64) -> String {
    let shown = three_digits(rim).map_or_else(|| rim.to_string(), |rim| decimal(&rim));
    format!("max_radius must lie below r = {shown}, where the series of a surface ends; write a smaller one")
}

fn unattainable() -> String {
    format!(
        "no order up to {HIGHEST_ORDER} is within this tolerance; lower max_radius, or raise the tolerance"
    )
}

fn too_low(order: u32, tolerance: &Rational, neglected: &Neglected) -> Result<String, &'static str> {
    let size = match neglected.bound(order)? {
        Some(bound) => format!("up to {} of the gap", decimal(&bound)),
        None => "terms as large as the gap".to_owned(),
    };
    let remedy = match neglected.smallest_order(tolerance)? {
        Some(order) => format!("write `order = {order}`"),
        None => unattainable(),
    };
    let tolerance = decimal(tolerance);
    Ok(format!("order {order} neglects {size}, more than the tolerance of {tolerance}; {remedy}"))
}

fn expanded(shape: Shape, order: u32) -> Result<Polynomial, Fault> {
    let mut sum = shape.powers;
    for surface in shape.surfaces {
        let extent = surface.extent;
        let series = surface.series(order / 2).map_err(|message| (extent, message.to_owned()))?;
        if !series.iter().all(Coefficient::is_representable) {
            let message =
                format!("order {order} has coefficients beyond the range of `f64`; write a lower one");
            return Err((extent, message));
        }
        for (j, coefficient) in (1_u32..).zip(series) {
            sum.accumulate(integer(2 * j), Monomial { coefficient, extent });
        }
    }
    Ok(sum)
}
