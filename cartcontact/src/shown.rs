//! How numbers look in error messages.

use core::fmt;

/// A number as a person would write it: plain where that is short, with an exponent elsewhere.
///
/// A number of single precision has the digits that tell it from others of that precision: 0.1, not
/// 0.10000000149011612. An `f64` with the same value is hardly ever meant to have more.
pub(crate) struct Shown(pub(crate) f64);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (size, single) = (self.0.abs(), self.0 as f32);
        let is_plain = size == 0.0 || !size.is_finite() || (1e-4..1e7).contains(&size);
        match (is_plain, f64::from(single) == self.0) {
            (true, true) => write!(f, "{single}"),
            (true, false) => write!(f, "{}", self.0),
            (false, true) => write!(f, "{single:e}"),
            (false, false) => write!(f, "{:e}", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_of_their_format() {
        let shown = |number: f64| Shown(number).to_string();
        assert_eq!([0.1, -2.5e-8, 1e12, 200.0].map(shown), ["0.1", "-2.5e-8", "1e12", "200"]);
        assert_eq!([0.1_f32, 3903.3066, 1e-30].map(f64::from).map(shown), ["0.1", "3903.3066", "1e-30"]);
        assert_eq!([0.0, 1.0 / 3.0, f64::INFINITY].map(shown), ["0", "0.3333333333333333", "inf"]);
    }
}
