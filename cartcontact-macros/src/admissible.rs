//! Gap with constant coefficients -> proof that the contact radius is determined.
//!
//! It is exactly where the approach grows with the contact radius a, that is, where the gap exceeds its own mean over
//! the contact disc: pressures are then non-negative and the surfaces stay apart outside. With the gap a sum of
//! C r^n, the slope of the approach is
//!
//! ```text
//! delta0'(a) = sum 2 C n a^(n-1)/(n+2)  =  2 a^(n_1 - 1) q(a^g)
//! ```
//!
//! with n_1 the lowest exponent and g the greatest common divisor of the differences n_i - n_1, so that q is a
//! polynomial of the lowest degree possible. If q(0), the sign of the lowest term, is positive, the geometry is
//! admissible up to the smallest positive root of q and no further; a root where q only touches zero ends the range
//! too. All of it is decided on exact numbers.
//!
//! I. Argatov, Mech. Res. Commun. 38 (2011) 29-33, doi 10.1016/j.mechrescom.2010.11.006, Eq. (10).

use core::cmp::Ordering;

use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::diagnostics::Extent;
use crate::end::End;
use crate::first_root::{TooIntricate, first_root};
use crate::gap::Gap;
use crate::integer_polynomial::{IntegerPolynomial, from_terms};
use crate::number::{self, Rational};

/// Bounds the time that a proof takes; enough for all integer exponents up to 1024.
const MAXIMUM_DEGREE: usize = 1024;
const MAXIMUM_DENOMINATOR: u32 = 64;

const TOO_INTRICATE: &str = "this gap is too intricate to be proved: its terms differ too much in size; leave out those \
                             that do not matter at the radii in question";

/// Where delta0'(a) is known to be positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// For every a > 0, with the reason.
    AllRadii { by: &'static str },
    /// Up to the declared `max_radius`.
    OnRange,
    /// Depends on values that are known only at run time.
    AtRunTime,
}

/// What a proof is wanted for.
pub(crate) enum Wanted<'a> {
    AllRadii,
    UpTo(&'a Rational, Extent),
    /// The end of the range is known only at run time.
    UpToSomewhere,
}

/// Proves that delta0'(a) > 0, or says where that fails.
pub(crate) fn prove(gap: &Gap, wanted: &Wanted<'_>) -> Result<Proof, (Extent, String)> {
    let Some(terms) = slope(gap) else { return Ok(Proof::AtRunTime) };
    let negative = terms.iter().zip(&gap.terms).find(|((_, coefficient), _)| coefficient.is_negative());
    let Some((_, guilty)) = negative else {
        return Ok(Proof::AllRadii { by: "all coefficients are positive" });
    };
    if terms.first().is_some_and(|(_, coefficient)| coefficient.is_negative()) {
        let message = "the gap falls from the centre on, so the surfaces would overlap; the term with the lowest power \
                       needs a positive coefficient";
        return Err((guilty.extent, message.to_owned()));
    }
    let equation = Equation::new(&terms).map_err(|message| (guilty.extent, message.to_owned()))?;
    let root =
        first_root(&equation.polynomial).map_err(|TooIntricate| (guilty.extent, TOO_INTRICATE.to_owned()))?;
    let Some(root) = root else {
        return Ok(Proof::AllRadii { by: "the slope of the approach has no positive root" });
    };
    let mut end = End::new(root, equation.numerator, equation.denominator);
    match wanted {
        Wanted::UpToSomewhere => Ok(Proof::AtRunTime),
        Wanted::UpTo(radius, _) if end.compare(radius) == Ordering::Greater => Ok(Proof::OnRange),
        Wanted::UpTo(_, extent) => Err((*extent, too_large(&mut end))),
        Wanted::AllRadii => Err((guilty.extent, unlimited(&mut end))),
    }
}

fn too_large(end: &mut End) -> String {
    let (shown, largest) = end.decimals();
    let remedy = largest
        .map_or_else(|| "a larger unit of length".to_owned(), |largest| format!("at most `{largest}`"));
    format!(
        "max_radius must lie below r = {shown}, where the gap no longer exceeds its mean over the contact disc; write {remedy}"
    )
}

fn unlimited(end: &mut End) -> String {
    let (shown, largest) = end.decimals();
    let remedy = largest.map_or_else(String::new, |largest| format!("; add `max_radius = {largest}`"));
    format!(
        "the gap no longer exceeds its mean over the contact disc from r = {shown} on: beyond it the contact radius is \
         not determined{remedy}"
    )
}

/// n - n_1 and C n/(n+2) of each term; nothing if a coefficient is no number.
fn slope(gap: &Gap) -> Option<Vec<(Rational, Rational)>> {
    let lowest = &gap.terms.first()?.exponent;
    let terms = gap.terms.iter().map(|term| {
        let share = &term.exponent / (&term.exponent + number::integer(2));
        Some((&term.exponent - lowest, term.coefficient.as_constant()? * share))
    });
    terms.collect()
}

/// q(a^g) = 0 with g = numerator/denominator.
struct Equation {
    polynomial: IntegerPolynomial,
    numerator: u32,
    denominator: u32,
}

impl Equation {
    fn new(terms: &[(Rational, Rational)]) -> Result<Self, &'static str> {
        let step = terms.iter().fold(Rational::zero(), |step, (exponent, _)| common_step(&step, exponent));
        let degrees = terms.iter().map(|(exponent, _)| (exponent / &step).to_usize());
        let degrees: Option<Vec<usize>> = degrees.collect();
        match (degrees, step.numer().to_u32(), step.denom().to_u32()) {
            (Some(degrees), Some(numerator), Some(denominator))
                if denominator <= MAXIMUM_DENOMINATOR
                    && degrees.iter().all(|degree| *degree <= MAXIMUM_DEGREE) =>
            {
                let coefficients = terms.iter().map(|(_, coefficient)| coefficient);
                let polynomial = from_terms(degrees.into_iter().zip(coefficients));
                Ok(Equation { polynomial, numerator, denominator })
            }
            _ => Err(
                "a gap with a negative term needs exponents with a small common denominator to be proved; round \
                      them, as in `r^2.5`",
            ),
        }
    }
}

/// The largest number that two others are integer multiples of.
fn common_step(left: &Rational, right: &Rational) -> Rational {
    let numerator = (left.numer() * right.denom()).gcd(&(right.numer() * left.denom()));
    Rational::new(numerator, left.denom() * right.denom())
}
