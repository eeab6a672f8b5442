//! Isolating the smallest positive root of a polynomial: Descartes' rule of signs on ever smaller intervals.
//!
//! The sign changes of Bernstein's coefficients bound the number of roots in an interval (`bernstein`): there is no
//! root if there is no change, one root if there is one, and the changes never grow when the interval is divided. So
//! the interval in front is divided until it has 0 or 1.
//!
//! The search goes from one power of two to the next, as roots may be of any magnitude; a bound that costs nothing
//! skips most of these intervals.
//!
//! Halving alone needs a step for every bit by which two roots differ. A cluster of k roots at c gives p'/p = k/(x -
//! c) nearby, so c is close to a - k p(a)/p'(a). Where both ends a of an interval lead to nearly the same point, a
//! small interval around it is tried: if it keeps all k sign changes, nothing else is left to look at.
//!
//! An interval has no more digits than its signs need, as digits are most of the work. Missing digits come from an
//! interval around it (`source`).
//!
//! Termination: the roots are simple (repeated ones are made so first), and by the theorem of the two circles
//! (Obreshkoff, Ostrowski) there are 0 changes or 1 once the interval is shorter than a fraction of the distance
//! between two complex roots. Every step shortens the interval at least by half, or gives it more digits until all
//! signs are certain.
//!
//! G. E. Collins, A. G. Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976,
//! 272-275, doi 10.1145/800205.806346; A. Eigenwillig, L. Kettner, W. Krandick, K. Mehlhorn, S. Schmitt, N. Wolpert,
//! A Descartes algorithm for polynomials with bit-stream coefficients, CASC 2005, 138-149, doi 10.1007/11555964_12;
//! M. Sagraloff, When Newton meets Descartes, ISSAC 2012, doi 10.1145/2442829.2442872.

use core::cmp::Ordering;

use num_bigint::BigInt;

use crate::first_zero::TooIntricate;
use crate::first_zero::bernstein::{Bernstein, SignChanges};
use crate::first_zero::common_divisor::square_free;
use crate::first_zero::first_root::{FirstRoot, RootPlace};
use crate::first_zero::integer_polynomial::IntegerPolynomial;
use crate::first_zero::outline::Outline;
use crate::first_zero::part::{Part, Whole};
use crate::first_zero::powers::Powers;
use crate::first_zero::source::Source;

/// Coefficients beyond this length, in bits, stand for differences that no measured gap has.
const MAXIMUM_LENGTH: u64 = 1 << 19;
/// So do decisions that take more digits. It bounds the time of a proof: a minimum at degree 1000 that takes all of them
/// takes seven seconds where macros are not optimised, at degree 256 half a second.
const MAXIMUM_DIGITS: u64 = 1 << 15;

/// Digits that the piece around a cluster has beyond its own needs, as the next piece is likely to be taken from it.
const SURPLUS: u64 = 128;
/// Digits that the shortest number of an interval keeps when the interval is divided.
const KEPT_DIGITS: u64 = 64;

/// The smallest positive root of a polynomial that is positive at 0.
pub(crate) fn first_root(polynomial: &IntegerPolynomial) -> Result<Option<FirstRoot>, TooIntricate> {
    let polynomial = square_free(polynomial);
    let outline = Outline::new(&polynomial);
    let lowest = -polynomial.clone().reversed().root_bound();
    for exponent in lowest..polynomial.root_bound() {
        if outline.stays_positive_between_powers(exponent) {
            continue;
        }
        if exponent.unsigned_abs().saturating_mul(polynomial.degree() as u64) > MAXIMUM_LENGTH {
            return Err(TooIntricate);
        }
        let whole = Whole::new(&polynomial, exponent);
        if let Some(place) = (Search { whole: &whole }).first_place()? {
            return Ok(Some(FirstRoot::new(polynomial, place)));
        }
    }
    Ok(None)
}

/// The search for the first root from 2^exponent to 2^(exponent + 1).
struct Search<'a> {
    whole: &'a Whole<'a>,
}

/// A part of the interval with the polynomial over it.
struct Candidate<'a> {
    part: Part,
    local: Bernstein,
    digits: u64,
    /// Where more digits come from.
    source: Source<'a>,
    missed: Missed,
    /// The number of digits before, and how many changes were uncertain with them.
    before: (u64, usize),
}

/// An interval 2^-width long did not have all of `count` roots.
#[derive(Clone, Copy)]
struct Missed {
    count: usize,
    width: u64,
}

impl<'a> Search<'a> {
    fn first_place(&self) -> Result<Option<RootPlace>, TooIntricate> {
        let missed = Missed { count: 0, width: 0 };
        let mut ahead =
            vec![self.candidate(Part::whole(), Source::whole(self.whole), self.few_digits(), missed)];
        while let Some(mut front) = ahead.pop() {
            let (start, changes) = front.local.sign_changes(&|end| self.whole.sign_at(&front.part, end));
            match changes {
                _ if start == Some(Ordering::Equal) => {
                    return Ok(Some(self.at_start(&front.part)));
                }
                SignChanges { most: 0, .. } => {}
                SignChanges { least: 1, most: 1 } => {
                    return Ok(Some(self.within(&front.part)));
                }
                SignChanges { least, most } if least != most => {
                    ahead.push(self.with_more_digits(front, most - least)?);
                }
                _ if front.is_far_from_source() => {
                    let digits = front.source.digits().min(MAXIMUM_DIGITS);
                    ahead.push(self.with_digits(front, digits)?);
                }
                SignChanges { most: count, .. } => match self.around_cluster(&mut front, count) {
                    Some(piece) => ahead.push(piece),
                    None => ahead.extend(front.halves()),
                },
            }
        }
        Ok(None)
    }

    /// The digits for an interval without clusters: those of the longest coefficient, and those that are lost where
    /// terms cancel.
    fn few_digits(&self) -> u64 {
        self.whole.degree() + 64
    }

    /// A part with this many digits, from a source that has them.
    fn candidate(&self, part: Part, source: Source<'a>, digits: u64, missed: Missed) -> Candidate<'a> {
        let is_exact = self.whole.is_exact_over(&part, digits);
        let powers = source.powers_over(&part, digits);
        let local = Bernstein::new(&powers, is_exact);
        Candidate::new(part, source, (powers, local), digits, missed)
    }

    /// The candidate with as many more digits as needed if each of them makes as many signs certain as the last ones
    /// did, or as the values at the ends call for.
    fn with_more_digits(
        &self,
        candidate: Candidate<'a>,
        uncertain: usize,
    ) -> Result<Candidate<'a>, TooIntricate> {
        let (digits, (last, before)) = (candidate.digits, candidate.before);
        let rate = before.saturating_sub(uncertain) as u64;
        let missing = (uncertain as u64 * digits.saturating_sub(last)).checked_div(rate).unwrap_or(0);
        let enough = (digits + missing + 16).min(4 * digits).max(digits + self.few_digits().max(digits / 2));
        let at_ends = [0, 1].into_iter().filter(|end| !candidate.local.knows_end(*end));
        let at_ends = at_ends.filter_map(|end| self.digits_at(&candidate.part, end, 8 * digits)).max();
        let mut next = self.with_digits(candidate, enough.max(at_ends.unwrap_or(0)))?;
        next.before = (digits, uncertain);
        Ok(next)
    }

    /// The digits down to where the value at an end of a part begins, and some more; nothing if `most` digits show
    /// none.
    fn digits_at(&self, part: &Part, end: u32, most: u64) -> Option<u64> {
        let value = self.whole.value(&part.within(&end.into(), 0, 0), most)?;
        Some(most - value.bits() + KEPT_DIGITS)
    }

    fn with_digits(&self, candidate: Candidate<'a>, digits: u64) -> Result<Candidate<'a>, TooIntricate> {
        if digits > MAXIMUM_DIGITS {
            return Err(TooIntricate);
        }
        let Candidate { part, source, missed, .. } = candidate;
        source.grow(digits);
        Ok(self.candidate(part, source, digits, missed))
    }

    /// A small interval around all roots of the front, if it keeps the sign changes.
    ///
    /// If an interval has missed some roots, the next one tried is halfway in bits; unless the roots turn out to fit
    /// into an interval as short, so that the first one was in the wrong place.
    fn around_cluster(&self, front: &mut Candidate<'a>, count: usize) -> Option<Candidate<'a>> {
        let width = front.part.width;
        let longest = match front.missed {
            Missed { count: missed, width: too_small } if missed == count && width < too_small => {
                (too_small - width) / 2
            }
            _ => u64::MAX,
        };
        let (offset, bits) = front.local.cluster(count).piece(longest)?;
        let piece = self.piece(front, &offset, bits, count);
        if piece.is_none() {
            front.missed = Missed { count, width: width + bits - 2 };
        }
        piece
    }

    /// The part of the front from offset/2^bits on that is 2^(2-bits) long, if it has `count` sign changes.
    ///
    /// Around k roots the values shrink by k bits with every halving, starting from about the smallest number of the
    /// front; this gives the digits that the piece takes. If they leave a sign open, the front is halved instead.
    fn piece(
        &self,
        front: &Candidate<'a>,
        offset: &BigInt,
        bits: u64,
        count: usize,
    ) -> Option<Candidate<'a>> {
        let part = front.part.within(offset, bits, bits - 2);
        let smaller = count as u64 * (bits - 2);
        let needed = front.digits + smaller + 32 - front.local.shortest().min(front.digits);
        if needed > MAXIMUM_DIGITS {
            return None;
        }
        front.source.grow(needed);
        let digits = (needed + SURPLUS.max(smaller)).min(front.source.digits());
        let powers = front.source.powers_over(&part, digits);
        let local = Bernstein::new(&powers, false);
        let (start, changes) = local.sign_changes(&|end| self.whole.sign_at(&part, end));
        let has_all = start != Some(Ordering::Equal) && changes.least == count;
        has_all.then(|| Candidate::new(part, front.source.clone(), (powers, local), digits, front.missed))
    }

    fn at_start(&self, part: &Part) -> RootPlace {
        RootPlace::At { offset: part.end(0), exponent: self.whole.exponent - part.bits as i64 }
    }

    fn within(&self, part: &Part) -> RootPlace {
        let exponent = self.whole.exponent - part.bits as i64;
        RootPlace::Between { lower: part.end(0), upper: part.end(1), exponent }
    }
}

impl<'a> Candidate<'a> {
    /// What a source gives over a part becomes the next source.
    fn new(
        part: Part,
        source: Source<'a>,
        (powers, local): (Powers, Bernstein),
        digits: u64,
        missed: Missed,
    ) -> Self {
        let source = source.near(part.clone(), powers, digits, digits.saturating_sub(local.length()));
        Candidate { part, local, digits, source, missed, before: (0, 0) }
    }

    /// How many leading digits are zero in all numbers.
    fn spent_digits(&self) -> u64 {
        self.digits.saturating_sub(self.local.length())
    }

    /// Whether a quarter of the digits that its source had left have been spent since: computing from a source at this
    /// candidate would then take less.
    fn is_far_from_source(&self) -> bool {
        let (spent, all) = (self.source.spent_digits(), self.source.digits());
        4 * self.spent_digits().saturating_sub(spent) > all - spent
    }

    /// The upper half and, last because it is looked at first, the lower one.
    fn halves(self) -> [Candidate<'a>; 2] {
        let Candidate { part, local, digits, source, missed, .. } = self;
        let cut = local.shortest().saturating_sub(KEPT_DIGITS).min(digits - 1);
        let [lower, upper] = local.halves(cut);
        let half = |offset: u32, local| Candidate {
            part: part.within(&offset.into(), 1, 1),
            local,
            digits: digits - cut,
            source: source.clone(),
            missed,
            before: (0, 0),
        };
        [half(1, upper), half(0, lower)]
    }
}
