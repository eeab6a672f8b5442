//! Integrals whose integrand changes quickly near the ends of the range.

use core::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

/// Gauss–Legendre quadrature on panels that shrink towards the places where the integrand is not smooth.
#[derive(Clone, Debug)]
pub struct Graded {
    rule: GaussLegendre,
    panels: i32,
}

impl Graded {
    /// A rule of `nodes` nodes on `panels` panels towards each end, each half as long as the one before.
    #[must_use]
    pub fn new(nodes: usize, panels: i32) -> Self {
        let nodes = NonZeroUsize::new(nodes).unwrap_or(NonZeroUsize::MIN);
        Self { rule: GaussLegendre::new(nodes), panels }
    }

    /// The integral over `from` to `to`, refined towards both of them.
    pub fn integrate(&self, from: f64, to: f64, integrand: impl Fn(f64) -> f64) -> f64 {
        let half = (to - from) / 2.0;
        // Nodes are measured from the end to which they shrink, so that no digits are lost there.
        let below = |distance: f64| integrand(to - distance);
        let above = |distance: f64| integrand(from + distance);
        let border = |index: i32| half * 0.5_f64.powi(index);
        let mut sum = self.rule.integrate(0.0, border(self.panels), below);
        sum += self.rule.integrate(0.0, border(self.panels), above);
        for index in (0..self.panels).rev() {
            sum += self.rule.integrate(border(index + 1), border(index), below);
            sum += self.rule.integrate(border(index + 1), border(index), above);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_at_the_ends_are_integrated() {
        let integral = Graded::new(16, 24).integrate(0.0, 1.0, |x| (x * (1.0 - x)).sqrt());
        assert!((integral / (core::f64::consts::PI / 8.0) - 1.0).abs() < 1e-12, "{integral}");
    }
}
