//! Isolating the smallest positive root of a polynomial: Descartes' rule of signs on ever smaller intervals.
//!
//! The sign changes of Bernstein's coefficients bound the number of roots in an interval (`bernstein`): there is none
//! if there is no change, one if there is one, and they never grow when the interval is divided. So the interval in
//! front is divided until there is 0 or 1.
//!
//! The search goes from one power of two to the next, as roots may be of any magnitude; most of these intervals a
//! bound that costs nothing skips.
//!
//! Halving alone needs a step for every bit by which two roots differ. A cluster of k roots at c gives p'/p = k/(x -
//! c) nearby, so c is close to a - k p(a)/p'(a). Where both ends a of an interval lead to nearly the same point, a
//! small interval around it is tried: if it keeps all k sign changes, nothing else is left to look at. Two sign
//! changes that are left where the polynomial is convex are decided by its minimum (`minimum`).
//!
//! An interval is cut out of the one before it, whose numbers are much shorter than those of the whole polynomial, and
//! around a cluster ever fewer powers count (`powers`). Only digits that are missing are taken from the polynomial.
//!
//! Termination: the roots are simple (repeated ones are made so first), and by the theorem of the two circles
//! (Obreshkoff, Ostrowski) there are 0 changes or 1 once the interval is shorter than a fraction of the distance
//! between two complex roots. Every step shortens the interval at least by half, or doubles the digits of an interval
//! until all signs are certain.
//!
//! G. E. Collins, A. G. Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976,
//! 272-275, doi 10.1145/800205.806346; A. Eigenwillig, L. Kettner, W. Krandick, K. Mehlhorn, S. Schmitt, N. Wolpert,
//! A Descartes algorithm for polynomials with bit-stream coefficients, CASC 2005, 138-149, doi 10.1007/11555964_12;
//! M. Sagraloff, When Newton meets Descartes, ISSAC 2012, doi 10.1145/2442829.2442872.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::Zero;

use crate::proof::bernstein::{Bernstein, SignChanges};
use crate::proof::common_divisor::square_free;
use crate::proof::first_root::{FirstRoot, Place};
use crate::proof::integer_polynomial::IntegerPolynomial;
use crate::proof::minimum::{Bracket, Convex, First, Undecided};
use crate::proof::outline::Outline;
use crate::proof::part::{Part, Whole};

/// Coefficients beyond this length, in bits, stand for differences that no measured gap has.
const MAXIMUM_LENGTH: u64 = 1 << 19;
/// So do decisions with more digits; it bounds the time of a proof.
const MAXIMUM_DIGITS: u64 = 1 << 16;

/// A proof takes longer numbers than [`MAXIMUM_LENGTH`] and [`MAXIMUM_DIGITS`] allow.
pub(crate) struct TooIntricate;

/// The smallest positive root of a polynomial that is positive at 0.
pub(crate) fn first_root(polynomial: &IntegerPolynomial) -> Result<Option<FirstRoot>, TooIntricate> {
    if polynomial.sign_changes() == 0 {
        return Ok(None);
    }
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
        if let Some(place) = (Search { whole }).first_place()? {
            return Ok(Some(FirstRoot::new(polynomial, place)));
        }
    }
    Ok(None)
}

/// The search for the first root from 2^exponent to 2^(exponent + 1).
struct Search<'a> {
    whole: Whole<'a>,
}

/// A part of the interval with the polynomial over it.
struct Candidate {
    part: Part,
    local: Bernstein,
    digits: u64,
    missed: Missed,
    /// So many changes were counted with all powers of the polynomial.
    counted: usize,
}

/// What there is around the roots of a candidate.
enum Around {
    /// An interval that has all of them.
    Piece(Candidate),
    /// One that it takes so many digits to know about.
    Unclear(u64),
    Nothing,
}

/// An interval 2^-width long did not have all of so many roots.
#[derive(Clone, Copy)]
struct Missed {
    count: usize,
    width: u64,
}

impl Search<'_> {
    fn first_place(&self) -> Result<Option<Place>, TooIntricate> {
        let (part, digits) = (Part::whole(), self.few_digits());
        let local = self.whole.over(&part, digits);
        let mut enough = 0;
        let mut ahead =
            vec![Candidate { part, local, digits, missed: Missed { count: 0, width: 0 }, counted: 0 }];
        while let Some(mut front) = ahead.pop() {
            let (start, changes) = front.local.sign_changes(&|end| self.whole.sign_at(&front.part, end));
            match changes {
                _ if start == Some(Ordering::Equal) => {
                    return Ok(Some(self.at(&front.part.end(0), front.part.bits)));
                }
                SignChanges { most: 0, .. } => {}
                SignChanges { least: 1, most: 1 } => {
                    return Ok(Some(self.between(&front.part, &front.part.end(1), front.part.bits)));
                }
                SignChanges { least, most } if least != most => ahead.push(self.with_more_digits(front)?),
                SignChanges { most: 2, .. } if front.local.is_convex() => {
                    if let Some(place) = self.beside_minimum(front, &mut enough)? {
                        return Ok(Some(place));
                    }
                }
                SignChanges { most: count, .. } => match self.around_cluster(&mut front, count) {
                    Around::Piece(closer) => ahead.push(closer),
                    Around::Unclear(digits) => ahead.push(self.with_digits(front, digits)?),
                    Around::Nothing => ahead.extend(front.halves()),
                },
            }
        }
        Ok(None)
    }

    /// For an interval without clusters: the longest coefficient, and what is lost where the terms cancel.
    fn few_digits(&self) -> u64 {
        self.whole.degree() + 64
    }

    fn with_more_digits(&self, candidate: Candidate) -> Result<Candidate, TooIntricate> {
        let digits = self.more(candidate.digits);
        self.with_digits(candidate, digits)
    }

    fn with_digits(&self, candidate: Candidate, digits: u64) -> Result<Candidate, TooIntricate> {
        if digits > MAXIMUM_DIGITS {
            return Err(TooIntricate);
        }
        Ok(Candidate { local: self.whole.over(&candidate.part, digits), digits, ..candidate })
    }

    fn more(&self, digits: u64) -> u64 {
        digits + self.few_digits().max(digits / 2)
    }

    /// A small interval around all roots of the front, if it keeps its sign changes.
    ///
    /// Where one has missed some of them, the next is tried halfway, in bits; unless they turn out to fit into an
    /// interval as short, so that it was in the wrong place.
    fn around_cluster(&self, front: &mut Candidate, count: usize) -> Around {
        let cluster = front.local.cluster(count);
        let width = front.part.width;
        let (short, longest) = match front.missed {
            Missed { count: missed, width: too_small } if missed == count && width < too_small => {
                (None, (too_small - width) / 2)
            }
            _ => (cluster.short_piece(width), u64::MAX),
        };
        for (offset, bits) in short.into_iter().chain(cluster.long_piece(longest)) {
            match self.piece(front, &offset, bits, count) {
                Around::Nothing => front.missed = Missed { count, width: width + bits - 2 },
                found => return found,
            }
        }
        Around::Nothing
    }

    /// The part of the front from offset/2^bits on that is 2^(2-bits) long, if it has so many sign changes.
    ///
    /// A cluster of k roots makes values of the size of the width to the power k. They come from the front if that has
    /// digits enough. Otherwise they are computed anew, with all powers, if those of the front were counted so, too.
    fn piece(&self, front: &Candidate, offset: &BigInt, bits: u64, count: usize) -> Around {
        let part = front.part.within(offset, bits, bits - 2);
        let has_all_powers = |local: &Bernstein| local.degree() == self.whole.degree();
        let (is_first, is_last) = (offset.is_zero(), (offset + 4_u32).bits() > bits);
        let smaller = count as u64 * (bits - 2);
        let mut digits = front.digits.max(front.spent_digits() + smaller + self.few_digits());
        loop {
            let powers = match digits == front.digits {
                true => front.local.piece(offset, bits),
                false if front.counted == count || has_all_powers(&front.local) => {
                    self.whole.powers_over(&part, digits)
                }
                false if digits > 2 * front.digits => return Around::Nothing,
                // The next piece is likely to take more again.
                false => return Around::Unclear(digits + self.few_digits()),
            };
            let local = Bernstein::new(&powers, false);
            let (start, SignChanges { least, most }) =
                local.sign_changes(&|end| self.whole.sign_at(&part, end));
            let known = |end| front.local.knows_end(end) && local.knows_end(end);
            let knows_rest = (is_first || known(0)) && (is_last || known(1));
            if start == Some(Ordering::Equal) || most < count || !(has_all_powers(&local) || knows_rest) {
                return Around::Nothing;
            }
            if least == count {
                let counted = if has_all_powers(&local) { count } else { 0 };
                let fewer = powers.without_negligible();
                let local = fewer.map_or(local, |fewer| Bernstein::new(&fewer, false));
                return Around::Piece(Candidate { part, local, digits, missed: front.missed, counted });
            }
            digits = self.more(digits);
            if digits > MAXIMUM_DIGITS {
                return Around::Unclear(digits);
            }
        }
    }

    /// The first root of a polynomial that is convex over the front and positive at both ends.
    ///
    /// Where digits are missing for it, only what is left for the minimum is computed anew; as many as were enough for
    /// the last one are likely to be enough.
    fn beside_minimum(&self, mut front: Candidate, enough: &mut u64) -> Result<Option<Place>, TooIntricate> {
        let beginning = front.part.clone();
        let mut minimum = Bracket::whole();
        let first = loop {
            let Candidate { part, local, digits, .. } = &front;
            match Convex::new(&self.whole, part, local, *digits).first_root(&mut minimum) {
                Ok(first) => break first,
                Err(Undecided) => {
                    front.part = minimum.part(&front.part);
                    let digits = (*enough).clamp(self.more(front.digits), 4 * front.digits);
                    front = self.with_digits(front, digits)?;
                }
            }
        };
        *enough = front.digits;
        let point = |offset: &BigInt, bits| front.part.within(offset, bits, bits);
        Ok(match first {
            First::None => None,
            First::At(offset, bits) => {
                let point = point(&offset, bits);
                Some(self.at(&point.end(0), point.bits))
            }
            First::Before(offset, bits) => {
                let point = point(&offset, bits);
                Some(self.between(&beginning, &point.end(0), point.bits))
            }
        })
    }

    /// At offset/2^bits of the interval.
    fn at(&self, offset: &BigInt, bits: u64) -> Place {
        Place::At { offset: offset.clone(), exponent: self.whole.exponent - bits as i64 }
    }

    /// From the beginning of a part to upper/2^bits.
    fn between(&self, part: &Part, upper: &BigInt, bits: u64) -> Place {
        let lower = part.end(0) << (bits - part.bits);
        Place::Between { lower, upper: upper.clone(), exponent: self.whole.exponent - bits as i64 }
    }
}

impl Candidate {
    /// Those that are zero in all numbers.
    fn spent_digits(&self) -> u64 {
        self.digits.saturating_sub(self.local.length())
    }

    /// The upper half and, to be looked at first, the lower one.
    fn halves(self) -> [Candidate; 2] {
        let Candidate { part, digits, missed, .. } = self;
        let [lower, upper] = self.local.halves();
        let half = |offset: u32, local| Candidate {
            part: part.within(&offset.into(), 1, 1),
            local,
            digits,
            missed,
            counted: 0,
        };
        [half(1, upper), half(0, lower)]
    }
}
