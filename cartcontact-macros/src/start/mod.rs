//! [`Geometry`] -> [`Start`]: what leads to the contact radius before the general solution has to be used.

pub(crate) mod curves;
mod load_integral;
pub(crate) mod own_units;
pub(crate) mod roots;
pub(crate) mod seeds;
pub(crate) mod table;

use crate::closed_forms::ClosedForms;
use crate::gap::coefficient::Sign;
use crate::gap::{Gap, Term};
use crate::geometry::Geometry;
use crate::number::{Rational, integer};
use curves::Curves;
use roots::Roots;
use seeds::Seeds;
use table::ROWS;

/// Powers of a square root take little longer than those of the radius.
const HIGHEST_ROOT_OF_STEPS: i32 = 2;
/// A step with more takes longer than a curve, for one radius by half, and for one of many a little.
const MOST_TERMS_OF_STEPS: usize = 8;

pub(crate) enum Start {
    /// A polynomial in each row of a table, for constants whose powers are not multiples of 1/2, or with many of them.
    Curves(Curves),
    /// A step from the radius to six digits, which is in a table.
    Seeds(Seeds),
    /// A series from the radius in the middle of a row, for a gap of one term.
    Roots(Roots),
    /// Steps from the radius that one term alone would have, where no table covers all coefficients, or none is near
    /// enough.
    LeadingTerm,
}

impl Start {
    /// None if only the general solution leads to the radius.
    pub(crate) fn of(geometry: &Geometry, forms: &ClosedForms) -> Option<Self> {
        let table = match forms.load_integral.summands.as_slice() {
            // A step with whole powers is the quickest.
            [only] if !(roots::has_window(only) && only.exponent.is_integer()) => {
                roots::roots(geometry, only).map(Start::Roots)
            }
            _ => curves_or_seeds(geometry, forms),
        };
        table.or_else(|| may_have_leading_term(&geometry.gap).then_some(Start::LeadingTerm))
    }
}

/// Curves instead of steps that would form powers that are not whole, high powers of a root, or many. Where two powers
/// are so far apart that curves are too short, there may be more seeds.
fn curves_or_seeds(geometry: &Geometry, forms: &ClosedForms) -> Option<Start> {
    let powers = &forms.load_integral.summands;
    let is_quick = |power: &Rational| (power * integer(HIGHEST_ROOT_OF_STEPS)).is_integer();
    let has_quick_steps =
        powers.len() <= MOST_TERMS_OF_STEPS && powers.iter().all(|summand| is_quick(&summand.exponent));
    let curves = if has_quick_steps { None } else { curves::curves(geometry, &forms.load_integral) };
    let rows = curves.as_ref().map_or(0, |curves| curves.double.rows.len());
    if rows == ROWS {
        return curves.map(Start::Curves);
    }
    let seeds = seeds::seeds(geometry, &forms.stepped);
    let curves = curves.filter(|_| seeds.as_ref().is_none_or(|seeds| seeds.table.rows.len() <= rows));
    curves.map(Start::Curves).or(seeds.map(Start::Seeds))
}

/// Steps from a leading term cannot use a negative coefficient.
pub(crate) fn may_have_leading_term(gap: &Gap) -> bool {
    let is_negative = |term: &Term| term.coefficient.certain_sign() == Some(Sign::NotPositive);
    gap.terms.len() > 1 && !gap.terms.iter().any(is_negative)
}

/// Whether a geometry with a table of seeds or curves has functions for the steps from a leading term, too. With fields
/// a term may be zero, or so small that usual load integrals lie outside the table. With constants only unusual ones
/// do, and functions for whole powers are short.
pub(crate) fn has_leading_term_beside_table(gap: &Gap) -> bool {
    let are_whole = || gap.terms.iter().all(|term| term.exponent.is_integer());
    may_have_leading_term(gap) && (!gap.is_constant() || are_whole())
}
