//! How far a result is from what it should be.

use crate::budget::Allowance;
use crate::oracle::{Real, double, rounded};

/// A real number to twice the precision: the nearest `f64` and the rest.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The nearest `f64`.
    pub nearest: f64,
    rest: f64,
}

impl Exact {
    /// The number that differs from an `f64` by `rest`, which is some roundings at most.
    #[must_use]
    pub fn beside(nearest: f64, rest: f64) -> Self {
        Self { nearest, rest }
    }
}

impl From<f64> for Exact {
    fn from(nearest: f64) -> Self {
        Self { nearest, rest: 0.0 }
    }
}

impl From<&Real> for Exact {
    fn from(x: &Real) -> Self {
        let nearest = rounded(x);
        Self { nearest, rest: rounded(&(x - double(nearest))) }
    }
}

impl core::fmt::Display for Exact {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{:e}{:+e}", self.nearest, self.rest)
    }
}

/// The distance of `found` from `expected` in units in the last place of a format with this `epsilon`; infinite for
/// NaN.
///
/// One unit is `epsilon` times the power of two at or below |`expected`|: an error of one unit is a relative error
/// between ε/2 and ε.
#[must_use]
pub fn ulps(found: f64, expected: Exact, epsilon: f64) -> f64 {
    let exponent = f64::from_bits(expected.nearest.to_bits() & 0x7ff0_0000_0000_0000);
    let distance = ((found - expected.nearest) - expected.rest).abs();
    let error = if distance == 0.0 { 0.0 } else { distance / exponent / epsilon };
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The distance of `found` from `expected` relative to `expected`, in units of `epsilon`; infinite for NaN.
#[must_use]
pub fn relative_error(found: f64, expected: f64, epsilon: f64) -> f64 {
    let error = if found == expected { 0.0 } else { ((found - expected) / expected).abs() / epsilon };
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The errors of one quantity, compared with what is allowed for it.
#[derive(Debug)]
pub struct Errors {
    quantity: &'static str,
    epsilon: f64,
    allowed: f64,
    seen: Option<f64>,
    /// The worst error, and where it is.
    worst: (f64, String),
    count: usize,
}

impl Errors {
    /// Errors of results in double precision.
    #[must_use]
    pub fn of(Allowance { quantity, double, seen, .. }: Allowance) -> Self {
        Self::with(quantity, f64::EPSILON, double, seen[0])
    }

    /// Errors of results in single precision, in units in the last place of `f32`.
    #[must_use]
    pub fn of_single(Allowance { quantity, single, seen, .. }: Allowance) -> Self {
        Self::with(quantity, f64::from(f32::EPSILON), single, seen[1])
    }

    fn with(quantity: &'static str, epsilon: f64, allowed: f64, seen: Option<f64>) -> Self {
        Self { quantity, epsilon, allowed, seen, worst: (0.0, String::new()), count: 0 }
    }

    /// Notes the error of a result whose allowance is multiplied by `condition`.
    ///
    /// # Panics
    ///
    /// If `condition` is no finite number above 0: no error would exceed the allowance.
    pub fn add(
        &mut self,
        found: f64,
        expected: impl Into<Exact>,
        condition: f64,
        place: &dyn core::fmt::Debug,
    ) {
        let expected = expected.into();
        assert!(condition.is_finite() && condition > 0.0, "the condition of {place:?} is {condition}");
        let error = ulps(found, expected, self.epsilon) / condition;
        self.count += 1;
        if error > self.worst.0 {
            self.worst = (error, format!("{found:e} instead of {expected}, for {place:?}"));
        }
    }

    /// Compares the worst error with the table: with the allowed error, and with the one seen, from which it may differ
    /// by a quarter with another mathematical library.
    ///
    /// # Panics
    ///
    /// If it exceeds either, or nothing was measured.
    pub fn check(&self) {
        let (Self { quantity, allowed, count, .. }, (error, place)) = (self, &self.worst);
        let seen = self.seen();
        println!("{quantity}: {error:.2} of {allowed} ulp in {count} values; {place}");
        assert!(*count > 0, "no values of {quantity}");
        assert!(error <= allowed, "{quantity}: {error:.2} ulp, {allowed} ulp are allowed; {place}");
        assert!(*error <= 1.25 * seen, "{quantity}: {error:.2} ulp, {seen} ulp were the worst; {place}");
    }

    /// [`check`](Self::check), in the test in which the worst error of all was seen.
    ///
    /// # Panics
    ///
    /// Also if the error is no longer as large.
    pub fn check_worst(&self) {
        self.check();
        let (quantity, seen, error) = (self.quantity, self.seen(), self.worst.0);
        assert!(error >= 0.75 * seen, "{quantity}: {error:.2} ulp, but the table still says {seen}");
    }

    fn seen(&self) -> f64 {
        self.seen.unwrap_or_else(|| unreachable!("the table does not say what was seen of {}", self.quantity))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::decimal;

    #[test]
    #[should_panic(expected = "the condition of \"here\" is NaN")]
    fn a_condition_is_a_number() {
        Errors::of(crate::budget::RADIUS).add(1.0, 1.0, f64::NAN, &"here");
    }

    #[test]
    fn a_unit_in_the_last_place_is_that_of_the_binade() {
        let next = 1.5 + f64::EPSILON;
        assert_eq!(ulps(next, 1.5.into(), f64::EPSILON), 1.0);
        assert_eq!(ulps(4.0 * next, 6.0.into(), f64::EPSILON), 1.0);
        assert_eq!(ulps(0.0, 0.0.into(), f64::EPSILON), 0.0);
        assert_eq!(ulps(f64::NAN, 1.0.into(), f64::EPSILON), f64::INFINITY);
        // 0.1 in f64 is 0.1000000000000000055511151231257827…, 0.4 units of 2^−56 too large.
        let error = ulps(0.1, Exact::from(&decimal("0.1")), f64::EPSILON);
        assert!((error - 0.4).abs() < 1e-12, "{error}");
    }
}
