//! How far a result is from what it should be.

use crate::budget::Allowance;

/// The distance of `found` from `expected` relative to `expected`, in units of `epsilon`; infinite for NaN.
#[must_use]
pub fn relative_error(found: f64, expected: f64, epsilon: f64) -> f64 {
    let error = if found == expected { 0.0 } else { ((found - expected) / expected).abs() / epsilon };
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The errors of one quantity, compared with what is allowed for it.
#[derive(Debug)]
pub struct Errors {
    allowance: Allowance,
    epsilon: f64,
    allowed: f64,
    /// The worst error as a share of what is allowed, and where it is.
    worst: (f64, String),
    count: usize,
}

impl Errors {
    /// Errors of results in double precision.
    #[must_use]
    pub fn of(allowance: Allowance) -> Self {
        Self::with(allowance, f64::EPSILON, allowance.double)
    }

    /// Errors of results in single precision, in units of its own ε.
    #[must_use]
    pub fn of_single(allowance: Allowance) -> Self {
        Self::with(allowance, f64::from(f32::EPSILON), allowance.single)
    }

    fn with(allowance: Allowance, epsilon: f64, allowed: f64) -> Self {
        Self { allowance, epsilon, allowed, worst: (0.0, String::new()), count: 0 }
    }

    /// Notes the error of a result whose allowance is multiplied by `condition`.
    pub fn add(&mut self, found: f64, expected: f64, condition: f64, place: &dyn core::fmt::Debug) {
        let error = relative_error(found, expected, self.epsilon) / condition;
        self.count += 1;
        if error > self.worst.0 {
            self.worst = (error, format!("{found:e} instead of {expected:e}, for {place:?}"));
        }
    }

    /// Compares the worst error with the table.
    ///
    /// # Panics
    ///
    /// If it exceeds what the table allows, or nothing was measured.
    pub fn check(self) {
        let (Self { allowance, allowed, count, .. }, (error, place)) = (&self, &self.worst);
        println!("{}: {error:.2} of {allowed} ε in {count} values; {place}", allowance.quantity);
        assert!(*count > 0, "no values of {}", allowance.quantity);
        assert!(error <= allowed, "{}: {error:.2} ε, {allowed} ε are allowed; {place}", allowance.quantity);
    }
}
