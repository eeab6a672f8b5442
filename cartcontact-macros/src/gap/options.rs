//! The options that govern the expansion of surfaces, `order` and `tolerance`.

use num_traits::{One, ToPrimitive};

use crate::diagnostics::Extent;
use crate::gap::evaluate::Evaluator;
use crate::gap::truncation::HIGHEST_ORDER;
use crate::number::{Rational, integer, nearest};
use crate::reading::attribute::Attribute;
use crate::reading::syntax::{Expression, Kind};

/// The options that govern the expansion.
#[derive(Clone)]
pub(crate) struct Options {
    pub(super) order: Option<(Order, Extent)>,
    pub(super) tolerance: Option<(Rational, Extent)>,
}

#[derive(Clone, Copy)]
pub(crate) enum Order {
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

    pub(crate) fn set_order(&mut self, order: u32) {
        if let Some((own, _)) = &mut self.order {
            *own = Order::Fixed(order);
        }
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
            format!("order must be at most {HIGHEST_ORDER}; if less does not suffice, end the range earlier");
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
