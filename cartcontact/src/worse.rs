//! The worst of many errors, for unit tests.

/// The larger of two errors; infinite if one is no number, which `f64::max` would leave out.
pub(crate) fn worse(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::INFINITY } else { one.max(other) }
}
