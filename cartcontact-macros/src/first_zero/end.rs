//! The end of the admissible range: an algebraic number, compared exactly and written in decimals.

use core::cmp::Ordering;
use core::ops::RangeInclusive;

use crate::first_zero::first_root::FirstRoot;
use crate::number::{self, Rational};

/// The radius a with a^g = root, g = numerator/denominator.
pub(crate) struct End {
    root: FirstRoot,
    numerator: u32,
    denominator: u32,
}

/// So many bits that seven digits hardly ever need a narrower root.
const BITS: u64 = 48;
/// Outside this range, numbers of seven digits have no `f64` next to them.
const DECIMAL_EXPONENTS: RangeInclusive<i64> = -307..=307;
/// Outside this range, only the power of ten of an end is computed: higher powers would take long.
const SHOWN_EXPONENTS: RangeInclusive<i64> = -1000..=1000;

impl End {
    pub(crate) fn new(root: FirstRoot, numerator: u32, denominator: u32) -> Self {
        End { root, numerator, denominator }
    }

    /// Compares this radius with another.
    pub(crate) fn compare(&mut self, radius: &Rational) -> Ordering {
        self.root.compare_to_power(radius, self.numerator, self.denominator)
    }

    /// The end for a message, and the largest decimal of seven digits that lies below it together with its nearest
    /// `f64`.
    ///
    /// The radius lies in (mantissa, mantissa + 1] units of the seventh digit: six digits are rounded from there.
    pub(crate) fn decimals(&mut self) -> (String, Option<Rational>) {
        self.root.narrow(BITS);
        let exponent = self.decimal_exponent();
        if !SHOWN_EXPONENTS.contains(&exponent) {
            return (format!("1e{exponent}"), largest_below(exponent));
        }
        let (fine, coarse) = (power_of_ten(exponent - 6), power_of_ten(exponent - 5));
        let mut mantissa = self.mantissa(&fine);
        let digits = (mantissa + 5) / 10;
        if !DECIMAL_EXPONENTS.contains(&exponent) {
            return (scientific(digits, exponent - 5), largest_below(exponent));
        }
        let shown = number::decimal(&(number::integer(digits) * coarse));
        while !self.exceeds_nearest(&(number::integer(mantissa) * &fine)) {
            mantissa -= 1;
        }
        (shown, Some(number::integer(mantissa) * fine))
    }

    fn exceeds_nearest(&mut self, radius: &Rational) -> bool {
        let nearest = number::nearest(radius).and_then(Rational::from_float);
        nearest.is_none_or(|nearest| self.compare(&nearest) == Ordering::Greater)
    }

    /// The largest with mantissa * unit < radius, by bisection of the numbers of seven digits.
    fn mantissa(&mut self, unit: &Rational) -> u32 {
        let (mut below, mut above) = (1_000_000, 10_000_000);
        while above - below > 1 {
            let middle = (below + above) / 2;
            match self.compare(&(number::integer(middle) * unit)) {
                Ordering::Greater => below = middle,
                _ => above = middle,
            }
        }
        below
    }

    /// The e with 10^e < radius <= 10^(e+1): estimated from the narrowed root, then corrected exactly if it is shown.
    fn decimal_exponent(&mut self) -> i64 {
        let per_root = f64::from(self.denominator) / f64::from(self.numerator);
        let mut exponent = (self.root.log10() * per_root).floor() as i64;
        if !SHOWN_EXPONENTS.contains(&exponent) {
            return exponent;
        }
        while !self.exceeds_power_of_ten(exponent) {
            exponent -= 1;
        }
        while self.exceeds_power_of_ten(exponent + 1) {
            exponent += 1;
        }
        exponent
    }

    fn exceeds_power_of_ten(&mut self, exponent: i64) -> bool {
        self.compare(&power_of_ten(exponent)) == Ordering::Greater
    }
}

/// The largest decimal below an end whose exponent no `f64` has; nothing if the end is too small.
fn largest_below(exponent: i64) -> Option<Rational> {
    (exponent > 0).then(|| power_of_ten(*DECIMAL_EXPONENTS.end()))
}

fn power_of_ten(exponent: i64) -> Rational {
    number::integer(10).pow(i32::try_from(exponent).unwrap_or(0))
}

/// `digits` times a power of ten.
fn scientific(digits: u32, exponent: i64) -> String {
    let digits = digits.to_string();
    let exponent = exponent + digits.len() as i64 - 1;
    match digits.trim_end_matches('0').split_at(1) {
        (first, "") => format!("{first}e{exponent}"),
        (first, others) => format!("{first}.{others}e{exponent}"),
    }
}
