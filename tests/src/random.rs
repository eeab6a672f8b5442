//! Random geometries and numbers.

use cartcontact::Polynomial;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A geometry known at run time only.
pub type Sum = Polynomial<f64, Vec<(f64, f64)>>;

/// `count` cases, the same in every run, so that no files of failures are needed.
///
/// `PROPTEST_RNG_SEED=2 cargo test -p tests` draws others, and `PROPTEST_CASES=10000` more of them.
#[must_use]
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig {
        cases: count,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1),
        ..ProptestConfig::default()
    }
}

/// A case that fails with an error.
pub fn failure(error: impl core::fmt::Display) -> TestCaseError {
    TestCaseError::fail(error.to_string())
}

/// A number between two powers of ten, with a uniform logarithm.
pub fn magnitude(exponents: core::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| 10_f64.powf(exponent))
}

/// Exponents of every kind: whole and not, small and large.
pub fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![(1_u32..=12).prop_map(f64::from), Just(1.5), Just(2.5), Just(3.25), 0.1..8.0, Just(64.0)]
}

/// Sums of up to five positive terms, each between 1e-3 and 1e3 at the radius 1.
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

/// A stream of numbers that a seed determines on every machine: SplitMix64.
///
/// Source: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014,
/// doi 10.1145/2660193.2660195.
#[derive(Clone, Copy, Debug)]
pub struct Stream(u64);

impl Stream {
    /// The stream of one case of a campaign: any case can be drawn again on its own.
    #[must_use]
    pub fn of_case(seed: u64, case: u64) -> Self {
        let mut stream = Self(seed);
        Self(stream.bits() ^ case.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let share = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * share
    }

    /// A number between two powers of ten, with a uniform logarithm.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }

    /// A whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        self.between(0.0, count as f64) as usize
    }

    /// 2^k with −`most` ≤ k < `most`.
    pub fn power_of_two(&mut self, most: i32) -> f64 {
        2_f64.powi(self.below(2 * most as usize) as i32 - most)
    }

    /// True in one of `count` cases.
    pub fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    /// One of the elements.
    ///
    /// # Panics
    ///
    /// If there are none.
    pub fn one_of<V: Copy>(&mut self, values: &[V]) -> V {
        values[self.below(values.len())]
    }
}
