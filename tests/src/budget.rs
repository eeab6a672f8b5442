//! The one table of allowed errors.
//!
//! Relative errors in units of ε (2⁻⁵² for `f64`, 2⁻²³ for `f32`). A test may multiply an entry by the
//! condition number of what it computes, Σ|terms|/|sum|, and by nothing else that is not named here.

/// What is allowed for one quantity.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    /// The quantity.
    pub quantity: &'static str,
    /// In units of the ε of `f64`.
    pub double: f64,
    /// In units of the ε of `f32`.
    pub single: f64,
    /// Why it is above 2, if it is.
    pub reason: &'static str,
}

const fn allow(quantity: &'static str, double: f64, single: f64, reason: &'static str) -> Allowance {
    Allowance { quantity, double, single, reason }
}

/// Φ(r).
pub const GAP: Allowance = allow("gap", 3.0, 3.0, "Horner's rule rounds twice per term, six terms at most");
/// δ₀(a).
pub const APPROACH: Allowance = allow("approach", 3.0, 3.0, "as the gap");
/// δ₀′(a).
pub const APPROACH_SLOPE: Allowance = allow("approach slope", 3.0, 3.0, "as the gap");
/// J(a).
pub const LOAD_INTEGRAL: Allowance = allow("load integral", 4.0, 4.0, "as the gap, and four more factors a");
/// J(a) − J(a − depth), relative to the same difference for the sizes of the terms.
pub const LOAD_INTEGRAL_DROP: Allowance = allow(
    "drop of the load integral",
    40.0,
    40.0,
    "the rounding of a − depth, here and in the quadrature of the test, is multiplied by the degree of J, at most 68",
);
/// L(x).
pub const LOG_KERNEL: Allowance = allow("log kernel", 3.0, 3.0, "as the gap");
/// G(a, r), up to 1 − r/a = 1e-12.
pub const PRESSURE_KERNEL: Allowance =
    allow("pressure kernel", 8.0, 8.0, "two factors a − r, and for powers that are not whole a power of r/a");
/// The inverse of J.
pub const RADIUS: Allowance = allow("radius", 1.5, 1.5, "");
/// a(t).
pub const CONTACT_RADIUS: Allowance = allow("contact radius", 1.5, 1.5, "");
/// δ₀(t), to be multiplied by 1 + a δ₀′/δ₀: the radius is rounded before.
pub const CONTACT_APPROACH: Allowance = allow("approach in time", 1.5, 1.5, "");
/// P(r, t), to be multiplied by 1 + 2a/(a − r): how far the rounding of a moves the edge.
pub const PRESSURE: Allowance =
    allow("pressure", 8.0, 8.0, "dozens of nodes, whose ages are rounded before they go into exponentials");
/// P(0, t).
pub const PEAK_PRESSURE: Allowance =
    allow("peak pressure", 16.0, 16.0, "as the pressure, with the factor 3 that it has at r = 0");
/// P(r, t) from a field against P(r, t) from a snapshot, to be multiplied by 1 + 2a/(a − r).
pub const FIELD: Allowance = allow("pressure field", 16.0, 16.0, "both have the error of a pressure");
/// 2π ∫ P r dr against F: 1e-13.
pub const BALANCE: Allowance = allow(
    "force balance",
    450.0,
    450.0,
    "some hundred pressures near the edge, where their own errors are largest, and the quadrature of the test",
);

/// All of them.
pub const TABLE: [Allowance; 14] = [
    GAP,
    APPROACH,
    APPROACH_SLOPE,
    LOAD_INTEGRAL,
    LOAD_INTEGRAL_DROP,
    LOG_KERNEL,
    PRESSURE_KERNEL,
    RADIUS,
    CONTACT_RADIUS,
    CONTACT_APPROACH,
    PRESSURE,
    PEAK_PRESSURE,
    FIELD,
    BALANCE,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_above_two_has_a_reason() {
        for entry in TABLE {
            let generous = entry.double > 2.0 || entry.single > 2.0;
            assert_eq!(generous, !entry.reason.is_empty(), "{}", entry.quantity);
        }
    }
}
