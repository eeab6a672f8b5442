//! Where the polynomial over a part comes from, and the digits that turn out to be missing later.
//!
//! Digits that a cluster of roots has used up are zero in all numbers around it, and most of the others are no longer
//! needed once the cluster has split into smaller ones. So every interval has few digits, and remembers the intervals
//! that it was cut out of: missing digits come from there, where numbers are shorter than those of the whole polynomial.

use core::cell::RefCell;
use std::rc::Rc;

use crate::first_zero::part::{Part, Whole};
use crate::first_zero::powers::Powers;

/// Where a polynomial over a part is taken from.
#[derive(Clone)]
pub(crate) struct Source<'a> {
    whole: &'a Whole<'a>,
    /// Nothing if that is the whole polynomial.
    near: Option<Rc<Near<'a>>>,
}

/// The polynomial over a part that is not the whole.
struct Near<'a> {
    part: Part,
    /// How many leading digits are zero in all numbers.
    spent: u64,
    wider: Source<'a>,
    known: RefCell<Growing>,
}

/// What grows if more digits are asked for.
struct Growing {
    powers: Powers,
    digits: u64,
}

impl<'a> Source<'a> {
    pub(crate) fn whole(whole: &'a Whole<'a>) -> Self {
        Source { whole, near: None }
    }

    /// What was taken from this source over a part, with this many digits, as a source itself.
    pub(crate) fn near(self, part: Part, powers: Powers, digits: u64, spent: u64) -> Self {
        let known = RefCell::new(Growing { powers, digits });
        Source { whole: self.whole, near: Some(Rc::new(Near { part, spent, wider: self, known })) }
    }

    /// Makes it have at least this many digits.
    pub(crate) fn grow(&self, digits: u64) {
        if let Some(near) = &self.near
            && self.digits() < digits
        {
            // More are likely to be asked for.
            let digits = digits + digits / 4;
            let powers = near.wider.having(digits).powers_over(&near.part, digits);
            near.known.replace(Growing { powers, digits });
        }
    }

    /// The nearest source that has this many digits; if only the whole polynomial has them, the one over its interval,
    /// which then grows.
    fn having(&self, digits: u64) -> &Self {
        match &self.near {
            Some(near) if self.digits() < digits && near.wider.near.is_some() => near.wider.having(digits),
            _ => {
                self.grow(digits);
                self
            }
        }
    }

    /// How many leading digits are zero in all numbers.
    pub(crate) fn spent_digits(&self) -> u64 {
        self.near.as_ref().map_or(0, |near| near.spent)
    }

    /// How many digits it has; no limit for the whole.
    pub(crate) fn digits(&self) -> u64 {
        self.near.as_ref().map_or(u64::MAX, |near| near.known.borrow().digits)
    }

    /// In powers from the beginning of a part on, with no more digits than there are.
    pub(crate) fn powers_over(&self, part: &Part, digits: u64) -> Powers {
        let Some(near) = &self.near else { return self.whole.powers(digits) };
        let (offset, bits) = near.part.locate(part);
        let known = near.known.borrow();
        known.powers.cut(known.digits - digits).over(&offset, bits, part.width - near.part.width)
    }
}
