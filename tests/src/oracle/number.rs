//! Numbers of 96 digits, to and from text and `f64`.

use core::str::FromStr;

use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig};

/// A number of [`BITS`] bits, rounded to nearest.
pub type Real = FBig<HalfEven, 2>;

/// 96 digits: 40 are wanted; 1 − r/a = 1e-12 costs 24 in the bracket of the pressure kernel, χ t = 1e4 another 4 in
/// the memory, and the remaining ones absorb the rounding of some thousand nodes.
pub const BITS: usize = 320;

/// A whole number.
#[must_use]
pub fn whole(k: i64) -> Real {
    Real::from(k).with_precision(BITS).value()
}

/// The number that a finite `f64` stands for.
///
/// # Panics
///
/// If it is not finite.
#[must_use]
pub fn double(x: f64) -> Real {
    let exact = Real::try_from(x).unwrap_or_else(|error| unreachable!("{x}: {error}"));
    exact.with_precision(BITS).value()
}

/// The number that a decimal stands for, such as `0.025` or `1e-40`.
///
/// # Panics
///
/// If it is not a decimal.
#[must_use]
pub fn decimal(text: &str) -> Real {
    let exact = FBig::<HalfEven, 10>::from_str(text).unwrap_or_else(|error| unreachable!("{text}: {error}"));
    exact.with_base_and_precision::<2>(BITS).value()
}

/// The decimal that a literal means: 0.025 is 1/40.
#[must_use]
pub fn literal(x: f64) -> Real {
    decimal(&format!("{x:e}"))
}

/// The nearest `f64`.
#[must_use]
pub fn rounded(x: &Real) -> f64 {
    x.to_f64().value()
}

/// |x|.
#[must_use]
pub fn size(x: Real) -> Real {
    if x < Real::ZERO { -x } else { x }
}

/// π, with all its bits.
#[must_use]
pub fn pi() -> Real {
    Context::<HalfEven>::new(BITS).pi(None).value()
}

/// An exponent n > 0, and 4 n if that is whole.
#[derive(Clone, Debug)]
pub struct Exponent {
    pub(super) value: Real,
    quarters: Option<i64>,
}

impl Exponent {
    pub(super) fn of(value: Real) -> Self {
        let quarters = i64::try_from(whole(4) * &value).ok();
        Self { value, quarters }
    }

    /// xⁿ. Where 4 n is whole, roots and products are quicker than a logarithm and an exponential.
    pub(super) fn power_of(&self, x: &Real) -> Real {
        match self.quarters {
            _ if x.repr().is_pos_zero() => whole(0),
            Some(quarters) if quarters % 4 == 0 => x.powi((quarters / 4).into()),
            Some(quarters) => x.sqrt().sqrt().powi(quarters.into()),
            None => (&self.value * x.ln()).exp(),
        }
    }
}

/// `count` significant digits in the notation of the files in `reference/`: trailing zeros are written, and numbers
/// below 1e-7, or without a digit after the point, have an exponent.
#[must_use]
pub fn digits(x: &Real, count: usize) -> String {
    if x.repr().is_pos_zero() || x.repr().is_neg_zero() {
        return "0.0".to_owned();
    }
    let (significand, exponent) =
        x.clone().with_base_and_precision::<10>(count).value().into_repr().into_parts();
    let text = significand.to_string();
    let (sign, figures) = text.strip_prefix('-').map_or(("", text.as_str()), |figures| ("-", figures));
    let power = exponent + figures.len() as isize - 1;
    let figures = format!("{figures:0<count$}");
    let placed = match power {
        -7..0 => format!("0.{}{figures}", "0".repeat(power.unsigned_abs() - 1)),
        0.. if power.unsigned_abs() + 1 < count => {
            let (before, after) = figures.split_at(power.unsigned_abs() + 1);
            format!("{before}.{after}")
        }
        _ => {
            let (before, after) = figures.split_at(1);
            format!("{before}.{after}e{power:+}")
        }
    };
    format!("{sign}{placed}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_written_as_in_the_reference() {
        for text in
            ["0.02500000000000000000000000", "7.727111777930266958604007", "123.4560000000000000000000"]
        {
            assert_eq!(digits(&decimal(text), 25), text);
        }
        assert_eq!(digits(&decimal("1.5e-7"), 3), "0.000000150");
        assert_eq!(digits(&decimal("-1.5e-8"), 3), "-1.50e-8");
        assert_eq!(digits(&decimal("9.9996"), 4), "10.00");
        assert_eq!(digits(&whole(0), 25), "0.0");
    }

    #[test]
    fn powers_of_every_kind_agree() {
        let x = decimal("3.7");
        for exponent in ["2", "2.5", "2.25", "2.3"] {
            let expected = x.powf(&decimal(exponent));
            let found = Exponent::of(decimal(exponent)).power_of(&x);
            assert!(size(found / expected - whole(1)) < decimal("1e-94"), "{exponent}");
        }
    }
}
