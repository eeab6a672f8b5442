//! The solution in 31 digits, straight from the formulas.

use super::wide::Wide;

/// A sum, and the sum of the absolute values of its terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    /// Σ terms.
    pub(super) value: Wide,
    /// Σ |terms|.
    pub(super) size: Wide,
}

impl Sum {
    const ZERO: Self = Self { value: Wide::ZERO, size: Wide::ZERO };

    fn add(&mut self, term: Wide) {
        self.value = self.value + term;
        self.size = self.size + term.abs();
    }

    fn times(self, factor: Wide) -> Self {
        Self { value: self.value * factor, size: self.size * factor }
    }

    /// Σ|terms|/|Σ terms|, by which errors from rounding may grow.
    pub(super) fn condition(self) -> f64 {
        if self.value.is_zero() { 1.0 } else { (self.size / self.value.abs()).value() }
    }
}

/// The functions of a geometry at one radius: Eqs. (10), (14), (28).
#[derive(Clone, Copy, Debug)]
pub(super) struct Kernels {
    /// Φ.
    pub(super) gap: Sum,
    /// δ₀.
    pub(super) approach: Sum,
    /// δ₀′.
    pub(super) approach_slope: Sum,
    /// J.
    pub(super) load_integral: Sum,
    /// L.
    pub(super) log_kernel: Sum,
    /// a J′.
    pub(super) log_slope: Sum,
}

/// The gap Σ C r^n.
#[derive(Clone, Debug)]
pub(super) struct Profile {
    terms: Vec<(Wide, f64)>,
}

impl Profile {
    /// The gap with the given coefficients and exponents.
    pub(super) fn new(terms: Vec<(Wide, f64)>) -> Self {
        Self { terms }
    }

    /// The functions at a radius above 0.
    pub(super) fn kernels(&self, a: Wide) -> Kernels {
        let zero = Sum::ZERO;
        let mut sums = Kernels {
            gap: zero,
            approach: zero,
            approach_slope: zero,
            load_integral: zero,
            log_kernel: zero,
            log_slope: zero,
        };
        for &(c, n) in &self.terms {
            let (n, two, four) = (Wide::of(n), Wide::of(2.0), Wide::of(4.0));
            let gap = c * a.power(n.value());
            let approach = two * gap / (n + two);
            let load_integral = gap * n / ((n + two) * (n + four));
            sums.gap.add(gap);
            sums.approach.add(approach);
            sums.approach_slope.add(approach * n);
            sums.load_integral.add(load_integral);
            sums.log_kernel.add(gap / ((n + two) * (n + two)));
            sums.log_slope.add(load_integral * (n + four));
        }
        let square = a * a;
        Kernels {
            approach_slope: sums.approach_slope.times(Wide::ONE / a),
            load_integral: sums.load_integral.times(square * square),
            log_kernel: sums.log_kernel.times(square),
            log_slope: sums.log_slope.times(square * square),
            ..sums
        }
    }

    /// G(a, r) for r < a: from its bracket away from the edge, from its expansion in 1 − r/a next to the edge.
    pub(super) fn pressure_kernel(&self, a: Wide, r: Wide) -> Sum {
        let (ratio, inset) = (r / a, (a - r) / a);
        let mut sum = Sum::ZERO;
        for &(c, n) in &self.terms {
            let next = Wide::of(n) + Wide::of(2.0);
            let weight = c * a.power(n) * (a * a) / (next * next).scaled(1);
            sum.add(weight * bracket(n, ratio, inset));
        }
        sum
    }

    /// The root of J(a) = y nearest to an estimate, by Newton's method on logarithms, until steps below 1e-17 no longer
    /// shrink; `None` if this is never reached.
    pub(super) fn radius(&self, y: Wide, estimate: Wide) -> Option<Wide> {
        let (mut a, mut last) = (estimate, f64::INFINITY);
        // Where J is nearly flat, each step of Newton's method removes no more than a third of the error.
        for _ in 0..400 {
            let here = self.kernels(a);
            let (value, slope) = (here.load_integral.value, here.log_slope.value);
            if !(value.is_positive() && slope.is_positive()) {
                return None;
            }
            let change = ((value - y) / slope).value();
            // Far away the step is that of the logarithm, as only a ratio of powers counts there.
            let step =
                if change.abs() < 0.1 { change } else { (value / y).ln().value() / (slope / value).value() };
            a = a * (Wide::ONE - Wide::of(step.clamp(-0.7, 0.5)));
            if step.abs() < 1e-17 && (step.abs() >= last || step.abs() < 1e-27) {
                return Some(a);
            }
            last = step.abs();
        }
        None
    }

    /// The least radius at which one positive term alone reaches J = y: an estimate from above for positive sums.
    pub(super) fn one_term_radius(&self, y: Wide) -> Wide {
        let logarithm = |&(c, n): &(Wide, f64)| {
            let (n, two, four) = (Wide::of(n), Wide::of(2.0), Wide::of(4.0));
            let j = c * n / ((n + two) * (n + four));
            (y / j).ln() / (n + four)
        };
        let positive = self.terms.iter().filter(|(c, _)| c.is_positive());
        positive.map(logarithm).reduce(Wide::min).map_or(Wide::ZERO, Wide::exp)
    }

    /// The radius up to `a` at which a J′ is smallest relative to the absolute terms of J, if the gap has terms of both
    /// signs: the contact passes this radius in no time, and rounding moves it most.
    pub(super) fn flattest_radius(&self, a: Wide) -> Option<Wide> {
        if self.terms.iter().all(|(c, _)| c.is_positive()) {
            return None;
        }
        let steepness = |share: f64| {
            let here = self.kernels(a * Wide::of(share));
            (here.log_slope.value / here.load_integral.size).value()
        };
        let shares = (1..=200).map(|step| f64::from(step) / 200.0);
        let flattest = shares.min_by(|&x, &y| steepness(x).total_cmp(&steepness(y)))?;
        let (mut low, mut high) = (flattest - 0.005, (flattest + 0.005_f64).min(1.0));
        for _ in 0..60 {
            let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if steepness(left) < steepness(right) { high = right } else { low = left }
        }
        Some(a * Wide::of((low + high) / 2.0))
    }
}

/// K(q) = n − (n+2) q² + 2 q^(n+2), from q and 1 − q.
///
/// With δ = 1 − q the binomial series of q^(n+2) leaves n (n+2) δ² + 2 Σ_{j≥3} binom(n+2, j) (−δ)^j. At (n+2) δ = 1/4,
/// where the series takes over, the bracket loses half its digits, and 31 are more than enough.
fn bracket(n: f64, ratio: Wide, inset: Wide) -> Wide {
    let (exponent, two) = (Wide::of(n), Wide::of(2.0));
    let next = exponent + two;
    if (next * inset).value() > 0.25 {
        let power = if ratio.is_zero() { Wide::ZERO } else { ratio.power(n) * ratio * ratio };
        return exponent - next * ratio * ratio + power.scaled(1);
    }
    let mut sum = exponent * next * inset * inset;
    let mut term = next * (next - Wide::ONE) * inset * inset / two;
    for j in 3..60_i32 {
        term = -(term * (next - Wide::of(f64::from(j - 1))) * inset / Wide::of(f64::from(j)));
        sum = sum + term.scaled(1);
        if (term / sum).value().abs() < 1e-32 {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_are_those_of_the_reference() {
        for row in crate::reference::kernels().into_iter().filter(|row| row.r < row.a) {
            let profile = Profile::new(row.case.exact_terms());
            let (a, r) = (Wide::of(row.a), Wide::of(row.r));
            let here = profile.kernels(a);
            assert_eq!(here.gap.value.value(), row.gap.nearest);
            assert_eq!(here.approach.value.value(), row.approach.nearest);
            assert_eq!(here.approach_slope.value.value(), row.approach_slope.nearest);
            assert_eq!(here.load_integral.value.value(), row.load_integral.nearest);
            assert_eq!(here.log_kernel.value.value(), row.log_kernel.nearest);
            assert_eq!(profile.pressure_kernel(a, r).value.value(), row.pressure_kernel.nearest, "{row:?}");
        }
    }
}
