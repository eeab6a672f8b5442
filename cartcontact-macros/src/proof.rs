//! Gap -> proof that the contact radius is determined.
//!
//! It is determined exactly where the approach grows with the contact radius a, that is, where the gap exceeds its own
//! mean over the contact disc: pressures are then non-negative and the surfaces stay apart outside. For a gap Σ C rⁿ,
//! the slope of the approach is
//!
//! ```text
//! δ₀′(a) = Σ 2 C n aⁿ⁻¹/(n+2)
//! ```
//!
//! If its lowest term is positive, the geometry is admissible up to the first zero of this sum and no further; a zero
//! without a change of sign ends the range too. All of it is decided with exact numbers.
//!
//! I. Argatov, Mech. Res. Commun. 38 (2011) 29-33, doi 10.1016/j.mechrescom.2010.11.006, Eq. (10).

use core::cmp::Ordering;

use crate::diagnostics::Extent;
use crate::fault::{Fault, Rank, Remedy};
use crate::first_zero::{End, first_zero};
use crate::gap::coefficient::Sign;
use crate::gap::{Gap, Term};
use crate::number::{self, Rational};

/// Where δ₀′(a) is known to be positive.
#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) enum Proof {
    /// For every a > 0, with the reason.
    AllRadii { by: &'static str },
    /// Up to the declared `max_radius`.
    OnRange,
    /// Depends on values that are known only at run time.
    AtRunTime,
}

/// The radii that a proof is wanted for.
pub(crate) enum Wanted<'a> {
    AllRadii,
    UpTo(&'a Rational, Extent),
    /// The end of the range is known only at run time.
    UpToSomewhere,
}

/// Proves that δ₀′(a) > 0, or says where that fails.
pub(crate) fn prove(gap: &Gap, wanted: &Wanted<'_>) -> Result<Proof, Fault> {
    if let Some(first) = gap.terms.first()
        && first.coefficient.certain_sign() == Some(Sign::NotPositive)
    {
        let message = "the gap falls from the centre on, so the surfaces would overlap; the term with the lowest power \
                       needs a positive coefficient, as where a socket is wider than its ball";
        return Err(Fault::new(Rank::Opening, first.extent, message));
    }
    let Some(terms) = slope(gap) else { return Ok(of_fields(gap)) };
    let negative = terms.iter().zip(&gap.terms).find(|((_, coefficient), _)| coefficient.is_negative());
    let Some((_, guilty)) = negative else {
        return Ok(Proof::AllRadii { by: "all coefficients are positive" });
    };
    let end = first_zero(&terms).map_err(|message| Fault::new(Rank::Undecided, guilty.extent, message))?;
    let Some(mut end) = end else {
        return Ok(Proof::AllRadii { by: "the slope of the approach has no positive root" });
    };
    match wanted {
        Wanted::UpToSomewhere => Ok(Proof::AtRunTime),
        Wanted::UpTo(radius, _) if end.compare(radius) == Ordering::Greater => Ok(Proof::OnRange),
        Wanted::UpTo(_, extent) => Err(too_large(*extent, &mut end)),
        Wanted::AllRadii => Err(unlimited(guilty.extent, &mut end)),
    }
}

/// What can be proved although the coefficients depend on fields.
fn of_fields(gap: &Gap) -> Proof {
    let positive = |term: &Term| term.coefficient.certain_sign() == Some(Sign::NotNegative);
    if gap.terms.iter().all(positive) {
        Proof::AllRadii { by: "no coefficient can be negative, whatever values the fields may have" }
    } else {
        Proof::AtRunTime
    }
}

fn too_large(extent: Extent, end: &mut End) -> Fault {
    let (shown, largest) = end.decimals();
    let rule = format!(
        "max_radius must lie below r = {shown}, where the gap no longer exceeds its mean over the contact disc"
    );
    let fault = Fault::new(Rank::Range, extent, rule);
    with_remedy(fault, largest, |largest| format!("write at most `{largest}`"), "write a smaller one")
}

fn unlimited(extent: Extent, end: &mut End) -> Fault {
    let (shown, largest) = end.decimals();
    let rule = format!(
        "the gap no longer exceeds its mean over the contact disc from r = {shown} on: beyond it the contact radius is \
         not determined"
    );
    let fault = Fault::new(Rank::Range, extent, rule);
    with_remedy(
        fault,
        largest,
        |largest| format!("add `max_radius = {largest}`"),
        "add a `max_radius` well below that",
    )
}

/// Adds the remedy for a range that goes too far. `largest` is the largest decimal below its end, if there is an `f64`
/// there.
fn with_remedy(fault: Fault, largest: Option<Rational>, remedy: Remedy, otherwise: &str) -> Fault {
    let otherwise = if largest.is_some() { otherwise } else { "use a smaller unit of length" };
    fault.or_max_radius(remedy, largest).otherwise(otherwise)
}

/// n and C n/(n+2) of each term; nothing if a coefficient is not a number.
fn slope(gap: &Gap) -> Option<Vec<(Rational, Rational)>> {
    let terms = gap.terms.iter().map(|term| {
        let share = &term.exponent / (&term.exponent + number::integer(2));
        Some((term.exponent.clone(), term.coefficient.as_constant()? * share))
    });
    terms.collect()
}
