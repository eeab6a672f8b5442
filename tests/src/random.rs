//! Random geometries and numbers.

use cartcontact::Polynomial;
use proptest::prelude::*;

/// A geometry known at run time only.
pub type Sum = Polynomial<f64, Vec<(f64, f64)>>;

/// As many cases as asked for, without files of failures.
#[must_use]
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { cases: count, failure_persistence: None, ..ProptestConfig::default() }
}

/// A number between two powers of ten, all magnitudes alike.
pub fn magnitude(exponents: core::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| 10_f64.powf(exponent))
}

/// Exponents of every kind: whole and not, small and large.
pub fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![(1_u32..=12).prop_map(f64::from), Just(1.5), Just(2.5), Just(3.25), 0.1..8.0, Just(64.0)]
}

/// Sums of up to five positive terms, each of a size of 1e-3 to 1e3 at some radius near 1.
pub fn positive_sums() -> impl Strategy<Value = Sum> {
    proptest::collection::vec((magnitude(-3.0..3.0), exponent()), 1..=5).prop_map(sum)
}

/// The gap Σ C r^n over pairs (C, n).
///
/// # Panics
///
/// If it is not admissible.
#[must_use]
pub fn sum(terms: Vec<(f64, f64)>) -> Sum {
    Polynomial::new(terms).unwrap_or_else(|error| unreachable!("{error}"))
}

/// a J′/J, the degree of the load integral at a radius: by this the relative error of a radius is multiplied.
#[must_use]
pub fn degree(profile: &dyn cartcontact::GapProfile<f64>, a: f64) -> f64 {
    let square = a * a;
    square * square * (a * profile.approach_slope(a) / 2.0) / profile.load_integral(a)
}
