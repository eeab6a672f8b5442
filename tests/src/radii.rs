//! What tests of radii share: the exact radius, and a comparison of many radii at once with radii one by one.

use core::fmt::Debug;

use cartcontact::GapProfile;

use crate::measure::Exact;
use crate::oracle::{Profile, double};

/// The radius at which J of the terms (C, n) is `load_integral`.
#[must_use]
pub fn exact_radius(terms: &[(f64, f64)], load_integral: f64) -> Exact {
    Exact::from(&Profile::of(terms).radius(&double(load_integral)))
}

/// Asserts that the radii of a slice are those of its load integrals one by one, to the last bit: in the given order, in
/// ascending order, and of six hundred close to the first.
///
/// # Panics
///
/// If a radius differs, or a slice is refused.
pub fn assert_same_one_by_one(profile: &dyn GapProfile<f64>, load_integrals: &[f64], place: &dyn Debug) {
    let mut ascending = load_integrals.to_vec();
    ascending.sort_by(f64::total_cmp);
    let close = load_integrals.first().map_or(0.0, |&first| first);
    let close: Vec<f64> = (0..600).map(|k| close * 0.999_f64.powi(k)).collect();
    for load_integrals in [load_integrals, &ascending, &close] {
        let mut radii = vec![f64::NAN; load_integrals.len()];
        assert_eq!(profile.radii(load_integrals, &mut radii), Ok(()), "{place:?}");
        let single = |&load_integral| profile.radius(load_integral).unwrap_or(f64::NAN);
        assert!(load_integrals.iter().map(single).eq(radii), "{place:?}");
    }
}
