//! Where the polynomial over a part comes from, and the digits that turn out to be missing later.
//!
//! Digits that a cluster of roots has used up are zero in all numbers around it, and most of the others are no longer
//! needed once the cluster has split into smaller ones. So every interval has few digits, and remembers the intervals
//! that it was cut out of: missing digits come from there, where numbers are shorter than those of the whole polynomial.
//!
//! **Error.** A polynomial over a part is as many units off as its source, and one or two more (`powers`). Derivatives
//! by Horner's rule (`horner`) lose less than their factor and 2 in each step, which is at most n^k + 2 for the k-th. This loss
//! does not grow any more over a part, where the variable is at most 1, and at most 2^j times over the whole. With
//! guard digits for (n + 1)^(k+1), for 2^n over the whole, and 3 more, it is less than one unit, and rounding the
//! result loses another one.

use core::cell::RefCell;
use std::rc::Rc;

use num_bigint::BigInt;

use crate::first_zero::horner::{Abscissa, CoefficientTable};
use crate::first_zero::part::{Part, Whole};
use crate::first_zero::powers::Powers;
use crate::number::shifted;

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
    powers: Rc<Powers>,
    digits: u64,
    table: Option<Rc<CoefficientTable>>,
}

impl<'a> Source<'a> {
    pub(crate) fn whole(whole: &'a Whole<'a>) -> Self {
        Source { whole, near: None }
    }

    pub(crate) fn is_whole(&self) -> bool {
        self.near.is_none()
    }

    /// What was taken from this source over a part, with this many digits, as a source itself.
    pub(crate) fn near(self, part: Part, powers: Powers, digits: u64, spent: u64) -> Self {
        let known = RefCell::new(Growing { powers: Rc::new(powers), digits, table: None });
        Source { whole: self.whole, near: Some(Rc::new(Near { part, spent, wider: self, known })) }
    }

    /// This source with at least that many digits.
    pub(crate) fn with_digits(&self, digits: u64) -> Self {
        match &self.near {
            Some(near) if self.digits() < digits => {
                // More are likely to be asked for.
                let digits = digits + digits / 4;
                let powers = near.wider.having(digits).powers_over(&near.part, digits);
                near.known.replace(Growing { powers: Rc::new(powers), digits, table: None });
                self.clone()
            }
            _ => self.clone(),
        }
    }

    /// The nearest source for values with this many digits, which the whole polynomial has at once.
    pub(crate) fn for_values(&self, digits: u64) -> Self {
        match &self.near {
            Some(near) if self.digits() < digits => match near.wider.is_whole() {
                true => near.wider.clone(),
                // Numbers of the whole are hardly longer.
                false if 4 * near.spent < digits => Source::whole(self.whole),
                false => self.with_digits(digits),
            },
            _ => self.clone(),
        }
    }

    /// The nearest source that has this many digits; if only the whole polynomial has them, the one over its interval.
    fn having(&self, digits: u64) -> Self {
        match &self.near {
            Some(near) if self.digits() < digits => {
                if near.wider.is_whole() {
                    self.with_digits(digits)
                } else {
                    near.wider.having(digits)
                }
            }
            _ => self.clone(),
        }
    }

    /// How many leading digits are zero in all numbers.
    pub(crate) fn spent_digits(&self) -> u64 {
        self.near.as_ref().map_or(0, |near| near.spent)
    }

    /// The bound for the error of a value.
    pub(crate) fn error(&self) -> u64 {
        self.near.as_ref().map_or(0, |near| near.known.borrow().powers.error as u64 + 1) + 2
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

    /// The value at a point in units of 2^-digits, unless it lies beyond the part.
    pub(crate) fn value(&self, point: &Part, digits: u64) -> Option<BigInt> {
        let (offset, bits) = match &self.near {
            None => (point.offset.clone(), point.bits),
            Some(near) => near.part.locate(point),
        };
        (offset.bits() <= bits).then(|| self.derivative(0, point, digits as i64))
    }

    /// A derivative at a point by the variable of the source, in units of 2^-digits. A value is less than `error` from
    /// the true one if the source has that many digits.
    pub(crate) fn derivative(&self, order: u64, point: &Part, digits: i64) -> BigInt {
        let degree = self.whole.degree();
        let guard = (order + 1) as i64 * i64::from(u64::BITS - degree.leading_zeros()) + 3;
        let (value, unit) = match &self.near {
            None => {
                let at = Abscissa::new(&point.offset, point.bits, true);
                let fine = digits + guard + degree as i64;
                self.whole.table(fine).derivative(order as usize, &at, fine)
            }
            Some(near) => {
                let (offset, bits) = near.part.locate(point);
                let at = Abscissa::new(&offset, bits, false);
                near.table().derivative(order as usize, &at, digits + guard)
            }
        };
        shifted(&value, digits - unit)
    }
}

impl Near<'_> {
    fn table(&self) -> Rc<CoefficientTable> {
        let Growing { powers, digits, table } = &mut *self.known.borrow_mut();
        let digits = (*digits + powers.guard) as i64;
        table.get_or_insert_with(|| Rc::new(CoefficientTable::new(&powers.numbers, digits))).clone()
    }
}
