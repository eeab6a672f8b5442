//! The first zero of a sum of powers of r, exactly.
//!
//! With n_1 the lowest exponent and g the greatest common divisor of the differences n_i - n_1, the sum is
//! r^n_1 q(r^g), where q is a polynomial of the lowest degree possible.
//!
//! | what | modules |
//! |---|---|
//! | q, and the part of it without multiple roots | `integer_polynomial`, `common_divisor` |
//! | isolating its smallest positive root | `search`, on ever smaller parts of an interval: `source` and `part` with its digits, `bernstein` with its signs; `outline` says where no root is |
//! | what these compute with | `fixed_point`, `horner`, `taylor`, `powers`, `interval_power` |
//! | the root, and the end of the range | `first_root`, `end`; `compared_power` orders it among others |

mod bernstein;
mod common_divisor;
mod compared_power;
mod end;
mod first_root;
mod fixed_point;
mod horner;
mod integer_polynomial;
mod interval_power;
mod outline;
mod part;
mod powers;
mod search;
mod source;
mod taylor;

use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

use crate::number::Rational;
pub(crate) use end::End;
use integer_polynomial::{IntegerPolynomial, from_terms};
use search::first_root;

/// The highest degree of q, which bounds the time that a proof takes: enough for all integer exponents up to 1024.
const MAXIMUM_DEGREE: usize = 1024;
/// The largest denominator of g: enough for exponents of three decimals.
const MAXIMUM_DENOMINATOR: u32 = 1000;

/// A proof takes more digits than are allowed.
struct TooIntricate;

/// The smallest r > 0 at which a sum of coefficient * r^exponent is zero, if there is one.
///
/// The pairs (exponent, coefficient) ascend, no coefficient is zero, and the first is positive. An error says why the
/// question is too hard.
pub(crate) fn first_zero(terms: &[(Rational, Rational)]) -> Result<Option<End>, &'static str> {
    if !terms.iter().any(|(_, coefficient)| coefficient.is_negative()) {
        return Ok(None);
    }
    let Equation { polynomial, numerator, denominator } = Equation::new(terms)?;
    let root = first_root(&polynomial).map_err(|TooIntricate| {
        "this gap is too intricate to be proved: its terms differ too much in size; leave out those that do not matter \
         at the radii in question"
    })?;
    Ok(root.map(|root| End::new(root, numerator, denominator)))
}

/// q(a^g) = 0 with g = numerator/denominator.
struct Equation {
    polynomial: IntegerPolynomial,
    numerator: u32,
    denominator: u32,
}

impl Equation {
    fn new(terms: &[(Rational, Rational)]) -> Result<Self, &'static str> {
        let lowest = terms.first().map_or_else(Rational::zero, |(exponent, _)| exponent.clone());
        let mut step = Rational::zero();
        for (exponent, _) in terms {
            step = common_step(&step, &(exponent - &lowest));
        }
        let powers = terms.iter().map(|(exponent, coefficient)| {
            let degree = ((exponent - &lowest) / &step).to_usize()?;
            (degree <= MAXIMUM_DEGREE).then_some((degree, coefficient))
        });
        let powers: Option<Vec<(usize, &Rational)>> = powers.collect();
        // Bounded by the denominator, as exponents are below 1024 apart.
        let numerator = step.numer().to_u32();
        let denominator = step.denom().to_u32().filter(|&denominator| denominator <= MAXIMUM_DENOMINATOR);
        match (powers, numerator, denominator) {
            (Some(powers), Some(numerator), Some(denominator)) => {
                Ok(Equation { polynomial: from_terms(&powers), numerator, denominator })
            }
            _ => Err(
                "a gap with a negative term can be proved if its exponents differ by at most 1024 steps of a common fraction \
                 whose denominator is at most 1000; round them to fewer decimals, as in `r^2.5`",
            ),
        }
    }
}

/// The largest number that two others are integer multiples of.
fn common_step(left: &Rational, right: &Rational) -> Rational {
    let numerator = (left.numer() * right.denom()).gcd(&(right.numer() * left.denom()));
    Rational::new(numerator, left.denom() * right.denom())
}
