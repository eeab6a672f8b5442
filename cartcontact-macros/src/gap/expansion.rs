//! [`Shape`] -> [`Polynomial`]: surfaces are expanded in even powers of r, up to the requested order.
//!
//! `order = auto` takes the smallest order whose neglected terms are within the tolerance. An order without a surface
//! is refused, as it would cut off nothing: powers of r are kept however high they are.

use num_traits::One;

use crate::diagnostics::Extent;
use crate::fault::{Fault, Rank};
use crate::gap::MAXIMUM_EXPONENT;
use crate::gap::coefficient::Coefficient;
use crate::gap::options::{Options, Order};
use crate::gap::polynomial::{Monomial, Polynomial};
use crate::gap::range::Range;
use crate::gap::rim::{rim, share_of_rim};
use crate::gap::shape::Shape;
use crate::gap::surface::Surface;
use crate::gap::truncation::{HIGHEST_ORDER, Neglected, Unprovable};
use crate::number::{Rational, decimal, fraction, integer};

/// A shape whose surfaces have become powers of r.
pub(crate) struct Expanded {
    pub(crate) powers: Polynomial,
    /// Nothing without surfaces. A fault here may only follow from the powers not being a gap.
    pub(crate) truncation: Result<Option<Truncation>, Fault>,
}

/// How far surfaces were expanded.
pub(crate) struct Truncation {
    pub(crate) order: u32,
    /// An upper bound of what is neglected, relative to the gap, if it can be told when the program is compiled.
    pub(crate) error: Option<Rational>,
    /// The surfaces whose rims max_radius must stay within, as far as that is not known when the program is compiled.
    pub(crate) unchecked: Vec<Surface>,
}

/// Expands the surfaces, if there are any; max_radius was written at `limit`.
pub(crate) fn expand(
    shape: &Shape,
    options: &Options,
    range: &Range,
    limit: Option<Extent>,
) -> Result<Expanded, Fault> {
    let Some(first) = shape.surfaces.first() else { return without_surfaces(&shape.powers, options) };
    let tolerance = options.tolerance.as_ref();
    let (request, place) = match (options.order, tolerance) {
        (Some((Order::Fixed(order), place)), _) => (Request::Order(order, tolerance), place),
        (Some((Order::Smallest, place)), Some(tolerance)) => (Request::Smallest(tolerance), place),
        (Some((Order::Smallest, place)), None) => {
            return Err(Fault::of_truncation(place, without_tolerance(limit)));
        }
        (None, _) => return Err(Fault::of_truncation(first.extent, without_order(tolerance.is_some()))),
    };
    let highest = request.highest_order();
    let expansion = Expansion { shape, range, limit, place };
    let truncation = match (expansion.unchecked(), expansion.neglected(highest), tolerance) {
        (Err(beyond_rim), _, _) => Err(beyond_rim),
        (Ok(_), Ok(neglected), _) => expansion.bounded(&request, &neglected),
        (Ok(_), Err(reason), Some((_, place))) => return Err(Fault::of_truncation(*place, reason)),
        (Ok(unchecked), Err(_), None) => Ok(Truncation { order: highest, error: None, unchecked }),
    };
    let order = truncation.as_ref().map_or(highest, |truncation| truncation.order);
    let powers = expanded(shape, order);
    if powers.as_ref().is_ok_and(|powers| powers.terms().is_empty())
        && let Some(fault) = expansion.nothing_left(order, tolerance)
    {
        return Err(fault);
    }
    match (powers, truncation) {
        (Ok(powers), truncation) => Ok(Expanded { powers, truncation: truncation.map(Some) }),
        // Nobody asked for this order.
        (Err(_), Err(fault)) if matches!(request, Request::Smallest(_)) => Err(fault),
        (Err(fault), _) => Err(fault),
    }
}

const OVERWHELMED: &str =
    "the terms that the order neglects may be as large as the gap itself before max_radius";
const LESS: &str = "lower max_radius, or raise the tolerance";

/// Why a search for an order has found none, and what to do.
fn unattainable(search: &Result<Option<u32>, Unprovable>) -> String {
    match search {
        Ok(_) => format!("no order up to {HIGHEST_ORDER} is within this tolerance; {LESS}"),
        Err(Unprovable { order }) => format!(
            "no order below {order} is within this tolerance, and what others neglect cannot be compared with it beside \
             these exponents; lower max_radius, raise the tolerance, or round the exponents, as in `r^2.5`"
        ),
    }
}

fn without_surfaces(powers: &Polynomial, options: &Options) -> Result<Expanded, Fault> {
    let order = options.order.as_ref().map(|(_, extent)| *extent);
    let tolerance = options.tolerance.as_ref().map(|(_, extent)| *extent);
    let (place, named, them) = match (order, tolerance) {
        (Some(order), Some(_)) => (order, "`order` and `tolerance` are", "them"),
        (Some(order), None) => (order, "`order` is", "it"),
        (None, Some(tolerance)) => (tolerance, "`tolerance` is", "it"),
        (None, None) => return Ok(Expanded { powers: powers.clone(), truncation: Ok(None) }),
    };
    // A gap with no terms left is reported when it is checked.
    if powers.terms().is_empty() {
        return Ok(Expanded { powers: powers.clone(), truncation: Ok(None) });
    }
    let message = format!(
        "{named} for surfaces, and this gap has no `sphere(R)` or `conic(R, k)`, or they cancel; remove {them}"
    );
    Err(Fault::of_truncation(place, message))
}

fn without_order(is_auto_likely: bool) -> String {
    let wanted = if is_auto_likely { "auto" } else { "4" };
    format!("a surface is expanded in powers of r; say how far, as in `order = {wanted}`, after a comma")
}

fn without_tolerance(limit: Option<Extent>) -> String {
    let range = if limit.is_some() { "" } else { ", max_radius = 6.0" };
    format!("`order = auto` meets a tolerance; add one, as in `tolerance = 1e-6{range}`")
}

/// A number below 1, and the place where it was written.
type Tolerance = (Rational, Extent);

/// The requested order.
enum Request<'a> {
    Order(u32, Option<&'a Tolerance>),
    Smallest(&'a Tolerance),
}

impl Request<'_> {
    fn highest_order(&self) -> u32 {
        match self {
            Request::Order(order, _) => *order,
            Request::Smallest(_) => HIGHEST_ORDER,
        }
    }
}

/// Surfaces to expand, and the range. The end of the range was written at `limit`, the order at `place`.
struct Expansion<'a> {
    shape: &'a Shape,
    range: &'a Range,
    limit: Option<Extent>,
    place: Extent,
}

impl Expansion<'_> {
    /// The requested order, if it is within the tolerance and neglects less than the gap.
    fn bounded(&self, request: &Request<'_>, neglected: &Neglected) -> Result<Truncation, Fault> {
        let order = match request {
            Request::Order(order, None) => *order,
            Request::Order(order, Some((tolerance, _))) => {
                if !neglected.is_within(tolerance, *order).map_err(|order| self.unprovable(order))? {
                    return Err(self.too_low(*order, tolerance, neglected)?);
                }
                *order
            }
            Request::Smallest((tolerance, place)) => match neglected.smallest_order(tolerance) {
                Ok(Some(smallest)) => smallest,
                Err(unprovable @ Unprovable { order: 2 }) => return Err(self.unprovable(unprovable)),
                none => return Err(Fault::of_truncation(*place, unattainable(&none))),
            },
        };
        // The range has been compared with the rims.
        let unchecked = Vec::new();
        match neglected.bound(order) {
            Ok(None) => Err(self.overwhelmed()),
            Ok(error) => Ok(Truncation { order, error, unchecked }),
            // Nobody asked for it.
            Err(_) => Ok(Truncation { order, error: None, unchecked }),
        }
    }

    /// The surfaces for which the fields decide whether the range ends inside, if the range does not reach the rim of
    /// another.
    fn unchecked(&self) -> Result<Vec<Surface>, Fault> {
        let (Some(end), Some(limit)) = (self.range.end(), self.limit) else { return Ok(Vec::new()) };
        let mut unchecked = Vec::new();
        for surface in &self.shape.surfaces {
            match share_of_rim(surface, &end) {
                None => unchecked.push(surface.clone()),
                Some(share) if share < Rational::one() => {}
                Some(_) => return Err(beyond_rim(limit, surface)),
            }
        }
        Ok(unchecked)
    }

    /// What orders up to `highest` neglect, or the reason why that is not known when the program is compiled.
    fn neglected(&self, highest: u32) -> Result<Neglected, &'static str> {
        let radius = match self.range {
            Range::Limited(radius) => radius,
            Range::Symbolic(_) => return Err(RANGE_OF_FIELDS),
            Range::Unbounded => return Err(NO_RANGE),
        };
        if self.shape.powers.terms().iter().any(|(exponent, _)| !is_of_a_gap(exponent)) {
            return Err(NOT_A_GAP);
        }
        Neglected::new(self.shape, radius, highest).ok_or(GAP_OF_FIELDS)
    }

    fn too_low(&self, order: u32, tolerance: &Rational, neglected: &Neglected) -> Result<Fault, Fault> {
        let size = match neglected.bound(order).map_err(|order| self.unprovable(order))? {
            Some(bound) => format!("up to {} of the gap", decimal(&bound)),
            None => "terms as large as the gap".to_owned(),
        };
        let shown = decimal(tolerance);
        let rule = format!("order {order} neglects {size}, more than the tolerance of {shown}");
        let fault = Fault::of_truncation(self.place, rule);
        Ok(match self.smallest_order(tolerance) {
            Ok(Some(higher)) => fault.or_order(Some(higher)).otherwise(LESS),
            none => fault.otherwise(unattainable(&none)),
        })
    }

    fn overwhelmed(&self) -> Fault {
        let fault = Fault::of_truncation(self.limit.unwrap_or(self.place), OVERWHELMED);
        fault.or_order(self.smallest_order(&fraction(1, 2)).ok().flatten()).otherwise("lower max_radius")
    }

    /// The fault of a gap whose terms cancel up to the order; nothing if no higher order leaves more of the gap.
    fn nothing_left(&self, order: u32, tolerance: Option<&Tolerance>) -> Option<Fault> {
        let opens = |next: &u32| expanded(self.shape, *next).is_ok_and(|powers| !powers.terms().is_empty());
        let next = (order + 2..=HIGHEST_ORDER).step_by(2).find(opens)?;
        let within = tolerance.and_then(|(tolerance, _)| self.smallest_order(tolerance).ok()?);
        let rule = format!("the terms of the gap cancel up to r^{order}, and those behind it are neglected");
        let fault = Fault::of_truncation(self.place, rule).or_order(Some(next)).or_order(within);
        Some(fault.otherwise("raise the order"))
    }

    /// The smallest order within the tolerance, whatever order was requested.
    fn smallest_order(&self, tolerance: &Rational) -> Result<Option<u32>, Unprovable> {
        self.neglected(HIGHEST_ORDER).map_or(Ok(None), |neglected| neglected.smallest_order(tolerance))
    }

    fn unprovable(&self, Unprovable { order }: Unprovable) -> Fault {
        let lower = if order > 2 { "lower the order, " } else { "" };
        let message = format!(
            "what order {order} neglects cannot be compared with a tolerance beside these exponents; {lower}round the \
             exponents, as in `r^2.5`, or write a number for the order and no tolerance"
        );
        Fault::of_truncation(self.place, message)
    }
}

/// Other exponents are reported when the gap is checked, and raising a radius to them would take long.
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

/// The fault of a range that reaches the rim of this surface whatever the values of the fields.
fn beyond_rim(extent: Extent, surface: &Surface) -> Fault {
    let (end, largest) = match rim(surface) {
        Some(mut rim) => {
            let (shown, largest) = rim.decimals();
            (format!("r = {shown}"), largest)
        }
        None => ("the r with |1 + k| r^2 = R^2 (r = R for a sphere)".to_owned(), None),
    };
    let rule = format!("max_radius must lie below {end}, where the series of a surface ends");
    Fault::new(Rank::Rim, extent, rule)
        .or_max_radius(|largest| format!("write at most `{largest}`"), largest)
        .otherwise("write a smaller one")
}

fn expanded(shape: &Shape, order: u32) -> Result<Polynomial, Fault> {
    let beyond_range = |extent| {
        let message = format!("order {order} has coefficients beyond the range of `f64`; write a lower one");
        Err(Fault::of_truncation(extent, message))
    };
    let mut sum = shape.powers.clone();
    for surface in &shape.surfaces {
        let extent = surface.extent;
        let series = surface.series(order / 2).map_err(|message| Fault::of_truncation(extent, message))?;
        if !series.iter().all(Coefficient::is_representable) {
            return beyond_range(extent);
        }
        for (j, coefficient) in (1_u32..).zip(series) {
            sum.accumulate(integer(2 * j), Monomial { coefficient, extent });
        }
    }
    // What is left of surfaces that nearly cancel may be too small. A power that was written is a fault of its own.
    let is_written = |power: &Rational| shape.powers.terms().iter().any(|(own, _)| own == power);
    let mut left = sum.terms().iter().filter(|(_, left)| !left.coefficient.is_representable());
    match left.find(|(power, _)| !is_written(power)) {
        Some((_, lost)) => beyond_range(lost.extent),
        None => Ok(sum),
    }
}
