//! [`Geometry`] -> [`Start`]: what leads to the contact radius before the general solution has to be used.

pub(crate) mod own_units;
pub(crate) mod roots;
pub(crate) mod seeds;
pub(crate) mod table;

use crate::closed_forms::ClosedForms;
use crate::gap::coefficient::Sign;
use crate::gap::{Gap, Term};
use crate::geometry::Geometry;
use roots::Roots;
use seeds::Seeds;

pub(crate) enum Start {
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
            _ => seeds::seeds(geometry, &forms.stepped).map(Start::Seeds),
        };
        table.or_else(|| may_have_leading_term(&geometry.gap).then_some(Start::LeadingTerm))
    }
}

/// Steps from a leading term cannot use a negative coefficient.
pub(crate) fn may_have_leading_term(gap: &Gap) -> bool {
    let is_negative = |term: &Term| term.coefficient.certain_sign() == Some(Sign::NotPositive);
    gap.terms.len() > 1 && !gap.terms.iter().any(is_negative)
}

/// Whether a geometry with a table of seeds has functions for the steps from a leading term, too. With fields a term may
/// be zero, or so small that usual load integrals lie outside the table. With constants only unusual ones do, and
/// functions for whole powers are short.
pub(crate) fn has_leading_term_beside_seeds(gap: &Gap) -> bool {
    let are_whole = || gap.terms.iter().all(|term| term.exponent.is_integer());
    may_have_leading_term(gap) && (!gap.is_constant() || are_whole())
}
