//! The factor on the allowance of a scene: how much larger the unavoidable errors are there.

use super::exact::Kernels;

/// Σ|terms of J|/(a J′) but at least 1: the degree of J divides errors of J, and cancelling terms magnify them.
///
/// Infinite where J falls: rounded coefficients, which count as exact here, may be those of a geometry that is not
/// quite admissible. No radius belongs to a load there, and it is uncertain which radii the contact passes in a jump.
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
