//! By what an allowance is multiplied for a scene: how much larger errors are there that nothing can be done about.

use super::exact::Kernels;

/// Σ|terms of J|/(a J′), if it is above 1: errors of J are divided by its degree and grow where its terms cancel.
///
/// Infinite where J falls: rounded coefficients, which are exact here, may be those of a geometry that is not quite
/// admissible. No radius belongs to what lies there, and what the contact passes in a jump is in doubt.
pub(super) fn of_radius(here: &Kernels) -> f64 {
    let slope = here.log_slope.value;
    if slope.is_positive() { (here.load_integral.size / slope).value().max(1.0) } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::super::exact::Profile;
    use super::super::wide::Wide;
    use super::*;

    /// δ₀′ = s (1 − 2 (s/7) + (1 + margin) (s/7)²), which vanishes near 7 mm if the margin does.
    fn nearly_admissible(margin: f64) -> Profile {
        let terms = [(1.0, 2.0), (-5.0 / 21.0, 3.0), (0.75 * (1.0 + margin) / 49.0, 4.0)];
        Profile::new(terms.map(|(c, n)| (Wide::of(c), n)).to_vec())
    }

    #[test]
    fn nothing_is_certain_where_the_load_integral_falls() {
        let at = |margin, a| of_radius(&nearly_admissible(margin).kernels(Wide::of(a)));
        assert!(at(1e-6, 7.0) > 1e5 && at(1e-6, 7.0).is_finite());
        assert!(at(-1e-6, 7.0).is_infinite());
        assert!(at(-1e-6, 6.0) < 1e4);
    }
}
