//! Syntax -> [`Gap`], by way of a sum of powers and surfaces: what was written, with exact coefficients.
//!
//! This file has the last step, [`Polynomial`] -> [`Gap`]: it checks that a sum of powers is a gap.
//!
//! | what | modules |
//! |---|---|
//! | the value of an expression | `evaluate` makes a `shape` of powers and `surface`s |
//! | surfaces as powers | `expansion`, by the `series` of a surface up to its `rim`; `truncation` bounds what is neglected |
//! | sums of powers | `polynomial`, `like_terms`, with a `coefficient` for each |
//! | options, and faults of the whole gap | `options`, `range`; `constant` |

pub(crate) mod coefficient;
pub(crate) mod constant;
pub(crate) mod evaluate;
pub(crate) mod expansion;
mod like_terms;
pub(crate) mod options;
pub(crate) mod polynomial;
pub(crate) mod range;
pub(crate) mod rim;
mod series;
pub(crate) mod shape;
pub(crate) mod surface;
pub(crate) mod truncation;

use num_traits::{One, Zero};

use crate::diagnostics::{Diagnostics, Extent};
use crate::number::{self, Rational};
use coefficient::Coefficient;
use constant::WrittenConstant;
use polynomial::{Monomial, Polynomial};

/// At 0.999 of the radius where it is 1, r^1024 is 0.36: beyond that, a contact cannot tell it from a step.
pub(crate) const MAXIMUM_EXPONENT: u32 = 1024;
/// Its reciprocal is the least: at 0.001 of the radius where it is 1, r^(1/1024) is 0.993.
const LARGEST_INVERSE: u32 = 1024;
/// Far more than a gap needs.
const MAXIMUM_TERMS: usize = 256;

/// The gap between the undeformed surfaces, a sum of terms `coefficient * r^exponent`.
pub(crate) struct Gap {
    /// In ascending order of their exponents; there is at least one.
    pub(crate) terms: Vec<Term>,
}

pub(crate) struct Term {
    /// From 1/1024 to 1024.
    pub(crate) exponent: Rational,
    /// Not zero.
    pub(crate) coefficient: Coefficient,
    /// Where the first contribution to it was written, or the one that determined its sign.
    pub(crate) extent: Extent,
}

impl Gap {
    /// The gap that a polynomial written at `extent` stands for. Every fault is reported.
    pub(crate) fn new(
        polynomial: Polynomial,
        constant: Option<&WrittenConstant>,
        extent: Extent,
        diagnostics: &mut Diagnostics,
    ) -> Option<Self> {
        if let [(exponent, only)] = polynomial.terms()
            && exponent.is_zero()
        {
            let message = "the gap is the same at all r; write one that opens with r, as in `0.025 * r^2`";
            diagnostics.report(only.extent, message);
            return None;
        }
        let terms = Gap::checked_terms(polynomial, constant, diagnostics)?;
        if terms.is_empty() {
            diagnostics
                .report(extent, "the gap is zero everywhere: its terms cancel; write one that opens with r");
            return None;
        }
        if terms.len() > MAXIMUM_TERMS {
            let message =
                format!("a gap may have at most {MAXIMUM_TERMS} terms; leave out those that do not matter");
            diagnostics.report(extent, message);
            return None;
        }
        Some(Gap { terms })
    }

    /// Reports the faults in the part of a gap that could be read. A constant is no fault: the part that could not be
    /// read may cancel it, as in `1 - cos(r)`.
    pub(crate) fn check_rest(polynomial: Polynomial, diagnostics: &mut Diagnostics) {
        let powers = polynomial.into_terms().filter(|(exponent, _)| !exponent.is_zero());
        let faults = powers.filter_map(|(exponent, monomial)| term(exponent, monomial).err());
        faults.for_each(|(extent, message)| diagnostics.report(extent, message));
    }

    /// The terms, unless one cannot be part of a gap. Every fault is reported. A constant does not stop it if there are
    /// other terms: whatever removes the constant leaves them as they are.
    pub(crate) fn checked_terms(
        polynomial: Polynomial,
        constant: Option<&WrittenConstant>,
        diagnostics: &mut Diagnostics,
    ) -> Option<Vec<Term>> {
        let mut terms = Some(Vec::new());
        for (exponent, monomial) in polynomial.into_terms() {
            if exponent.is_zero() {
                diagnostics.report(monomial.extent, constant::message(&monomial.coefficient, constant));
                continue;
            }
            match (term(exponent, monomial), &mut terms) {
                (Ok(term), Some(terms)) => terms.push(term),
                (Ok(_), None) => {}
                (Err((extent, message)), _) => {
                    diagnostics.report(extent, message);
                    terms = None;
                }
            }
        }
        terms
    }

    /// Whether no coefficient depends on a field.
    pub(crate) fn is_constant(&self) -> bool {
        self.terms.iter().all(|term| term.coefficient.as_constant().is_some())
    }
}

/// The term, if it can be part of a gap. Its exponent is not zero.
fn term(exponent: Rational, monomial: Monomial) -> Result<Term, (Extent, String)> {
    let Monomial { coefficient, extent } = monomial;
    let fault = |message: &str| Err((extent, message.to_owned()));
    if exponent.is_negative() {
        return fault(
            "exponent must be greater than 0, as the gap vanishes at r = 0; write a positive power",
        );
    }
    if exponent > number::integer(MAXIMUM_EXPONENT) {
        return fault(&format!(
            "exponent must be at most {MAXIMUM_EXPONENT}, as the gap beyond is a step; write a lower one"
        ));
    }
    if &exponent * number::integer(LARGEST_INVERSE) < Rational::one() {
        return fault(&format!(
            "exponent must be at least 1/{LARGEST_INVERSE}, as a gap with less is a step; write a higher one"
        ));
    }
    if !coefficient.is_representable() {
        return fault(
            "coefficient does not fit into an `f64`; use a unit of length that brings it nearer to 1",
        );
    }
    Ok(Term { exponent, coefficient, extent })
}
