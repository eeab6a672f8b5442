//! What is wrong with a geometry as a whole, and the remedy that is offered.
//!
//! A change that satisfies one stage may be refused by another: a range that ends before the gap turns may reach the
//! rim of a surface, or be too long for the order. So a remedy is offered only if it leads to a geometry.

use crate::diagnostics::Extent;
use crate::gap::rim;
use crate::gap::surface::Surface;
use crate::number::{Rational, decimal, fraction, three_digits};

/// Of two faults the one of higher rank is reported: it remains if the other is mended, or it is the reason for the
/// other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// The proof was given up: nobody knows whether the range ends.
    Undecided,
    /// What an order neglects.
    Truncation,
    /// The range goes beyond the one in which the gap determines a contact radius.
    Range,
    Rim,
    /// The gap does not open.
    Opening,
}

/// How to write a radius.
pub(crate) type Remedy = fn(&str) -> String;

/// The ways out are in order of preference; if none works, the message ends with `otherwise`.
pub(crate) struct Fault {
    pub(crate) extent: Extent,
    pub(crate) rank: Rank,
    rule: String,
    ways: Vec<Way>,
    otherwise: String,
}

enum Way {
    MaxRadius { remedy: Remedy, largest: Rational },
    Order(u32),
}

/// An option with another value.
pub(crate) enum Change<'a> {
    MaxRadius(&'a Rational),
    Order(u32),
}

impl Fault {
    /// The fault of an order.
    pub(crate) fn of_truncation(extent: Extent, rule: impl Into<String>) -> Self {
        Self::new(Rank::Truncation, extent, rule)
    }

    /// A fault without a way out.
    pub(crate) fn new(rank: Rank, extent: Extent, rule: impl Into<String>) -> Self {
        Fault { extent, rank, rule: rule.into(), ways: Vec::new(), otherwise: String::new() }
    }

    /// Way out: a `max_radius` that is no larger than this, if there is one.
    pub(crate) fn or_max_radius(mut self, remedy: Remedy, largest: Option<Rational>) -> Self {
        self.ways.extend(largest.map(|largest| Way::MaxRadius { remedy, largest }));
        self
    }

    pub(crate) fn or_order(mut self, order: Option<u32>) -> Self {
        self.ways.extend(order.map(Way::Order));
        self
    }

    pub(crate) fn otherwise(mut self, advice: impl Into<String>) -> Self {
        self.otherwise = advice.into();
        self
    }

    /// The message with the first way out that works. Without surfaces any `max_radius` works.
    pub(crate) fn message(&self, surfaces: &[Surface], works: impl Fn(&Change<'_>) -> bool) -> String {
        let offered = self.ways.iter().find_map(|way| match way {
            Way::MaxRadius { remedy, largest } if surfaces.is_empty() => Some(remedy(&decimal(largest))),
            Way::MaxRadius { remedy, largest } => {
                within_series(*remedy, largest, surfaces, |radius| works(&Change::MaxRadius(radius)))
            }
            Way::Order(order) => works(&Change::Order(*order)).then(|| format!("write `order = {order}`")),
        });
        match offered.as_ref().unwrap_or(&self.otherwise) {
            remedy if remedy.is_empty() => self.rule.clone(),
            remedy => format!("{}; {remedy}", self.rule),
        }
    }
}

/// How to write the largest `max_radius` that works, or a short number not far below it.
fn within_series(
    remedy: Remedy,
    largest: &Rational,
    surfaces: &[Surface],
    works: impl Fn(&Rational) -> bool,
) -> Option<String> {
    let radius = rim::inside(largest, surfaces);
    if works(&radius) {
        let reason = if radius == *largest { "" } else { ", as the series of a surface ends there" };
        return Some(remedy(&decimal(&radius)) + reason);
    }
    let parts = [fraction(3, 4), fraction(1, 2), fraction(1, 4)];
    parts.iter().find_map(|part| {
        let radius = three_digits((&radius * part).to_f64())?;
        works(&radius).then(|| format!("write `max_radius = {}`, for example", decimal(&radius)))
    })
}
