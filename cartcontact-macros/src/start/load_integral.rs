//! J with its derivatives and its inverse in the digits of f64, for tables of radii.

/// J(a) = Σ j a^p as pairs (j, p) in ascending order of p.
pub(crate) struct LoadIntegral {
    pub(crate) terms: Vec<(f64, f64)>,
}

/// J with a J′, a² J″ and a³ J‴.
pub(crate) struct Derivatives {
    pub(crate) value: f64,
    pub(crate) first: f64,
    pub(crate) second: f64,
    pub(crate) third: f64,
}

impl LoadIntegral {
    pub(crate) fn at(&self, a: f64) -> Derivatives {
        let mut sums = Derivatives { value: 0.0, first: 0.0, second: 0.0, third: 0.0 };
        for &(j, p) in &self.terms {
            let term = j * a.powf(p);
            sums.value += term;
            sums.first += p * term;
            sums.second += p * (p - 1.0) * term;
            sums.third += p * (p - 1.0) * (p - 2.0) * term;
        }
        sums
    }

    /// The radius of `y`, from that of the positive term that is largest there.
    pub(crate) fn radius(&self, y: f64) -> Option<f64> {
        let alone = self.terms.iter().filter(|(j, _)| *j > 0.0).map(|&(j, p)| (y / j).powf(1.0 / p));
        self.radius_near(alone.reduce(f64::min)?, y)
    }

    /// The radius of `y` by Newton's method on logarithms, in which J is nearly linear.
    ///
    /// Without an admissible radius it finds none, or one of no use: what is made from it passes no check.
    pub(crate) fn radius_near(&self, start: f64, y: f64) -> Option<f64> {
        let mut a = start;
        for _ in 0..50 {
            let Derivatives { value, first, .. } = self.at(a);
            let step = (value / y).ln() * value / first;
            a *= (-step).exp();
            // The method is of second order: what this step leaves is below the rounding.
            if step.abs() < 1e-9 {
                return Some(a);
            }
        }
        None
    }
}
