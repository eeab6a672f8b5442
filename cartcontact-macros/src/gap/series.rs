//! What the series of a surface adds after some power of r, on the range up to ρ.
//!
//! With u = κ r²/R² the terms of [`crate::gap::surface`] after r^(2J) add up to
//!
//! ```text
//! c_(J+1) r^(2J+2) F(u),    F(u) = Σ b_(J+1+i)/b_(J+1) u^i, i ≥ 0
//! ```
//!
//! and as b_(j+1) = 1/π ∫ t^j √((1−t)/t) dt from 0 to 1, F(u) is a mean of values of 1/(1 − u t). So it grows with u,
//! from or to F(0) = 1, it is convex, and it lies between 1 and 1/(1 − u). Where 1/(1 − u) is far from F, near a rim,
//! there are better upper bounds. For u > 0 they come from the sum of the whole series,
//!
//! ```text
//! b_(J+1) u^(J+1) F(u) = 1 − √(1 − u) − Σ b_j u^j,    j ≤ J
//! ```
//!
//! and for u < 0, with the mean m = b_(J+2)/b_(J+1) of t, from the chord of 1/(1 − u t) from t = 0 to 1:
//!
//! ```text
//! F(u) ≤ 1 − m + m/(1 − u)
//! ```
//!
//! Inside the range F lies below its own chord, F(u r²/ρ²) ≤ 1 + (F(u) − 1) r²/ρ².

use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::gap::coefficient::Coefficient;
use crate::gap::surface::{Surface, binomial_ratio};
use crate::number::{Rational, ceil, floor};

/// Binary digits after the point in the sum of a whole series; where u^J has none there, 1/(1 − u) is near F.
const DIGITS: u64 = 512;
/// Binary digits kept of a bound of F.
const FEW_DIGITS: u64 = 64;

/// A weighted surface: w c_j for j = 1, 2, ...
pub(super) struct Series {
    pub(super) terms: Vec<Rational>,
    /// For each term, an upper bound of the factor F of the tail that begins with it, at the end of the range.
    pub(super) tails_at_end: Vec<Rational>,
    /// A lower bound of all these factors in the range.
    pub(super) least_tail: Rational,
}

impl Series {
    /// Nothing if a coefficient is not a number, or if the range reaches the rim.
    pub(super) fn new(surface: &Surface, range: &Rational, count: usize) -> Option<Self> {
        let (radius, shape) = (surface.radius.as_constant()?, surface.shape.as_constant()?);
        let relative = range / &radius;
        let u = shape * &relative * &relative;
        if u.abs() >= Rational::one() {
            return None;
        }
        let terms = surface.series(count as u32).ok()?;
        let terms = terms.iter().map(Coefficient::as_constant).collect::<Option<_>>()?;
        let geometric = (Rational::one() - &u).recip();
        let tails_at_end = if u.is_positive() {
            let geometric = ceil(&geometric, FEW_DIGITS);
            let least =
                |of_sum: Option<Rational>| of_sum.unwrap_or_else(|| geometric.clone()).min(geometric.clone());
            tail_bounds(&u).map(least).take(count).collect()
        } else {
            let chord = |j: u32| Rational::one() + binomial_ratio(j) * (&geometric - Rational::one());
            (1..).map(|j| ceil(&chord(j), FEW_DIGITS)).take(count).collect()
        };
        let least_tail = floor(&geometric, FEW_DIGITS).min(Rational::one());
        Some(Series { terms, tails_at_end, least_tail })
    }
}

/// F from the sum of the series, or an upper bound of it, for J = 0, 1, ...; nothing where u^J has no digits.
fn tail_bounds(u: &Rational) -> impl Iterator<Item = Option<Rational>> {
    let shifted = |value: &Rational, digits: u64| (value.numer() << digits) / value.denom();
    let step = shifted(u, DIGITS);
    let mut term: BigInt = &step >> 1;
    // Roots and terms are rounded down.
    let mut left = (BigInt::one() << DIGITS) - shifted(&(Rational::one() - u), 2 * DIGITS).sqrt();
    (1_u32..).map(move |j| {
        let bound =
            (!term.is_zero()).then(|| ceil(&Rational::new_raw(left.clone(), term.clone()), FEW_DIGITS));
        left -= &term;
        let ratio = binomial_ratio(j);
        term = ((&term * &step * ratio.numer()) >> DIGITS) / ratio.denom();
        bound
    })
}
