//! A gap and the integrals over it.

use std::sync::{Mutex, PoisonError};

use super::number::{Exponent, Real, decimal, double, rounded, size, whole};
use super::quadrature::integrate;

/// A gap Φ(r) = Σ C rⁿ and its integrals.
///
/// Every integral over a power is taken in x = ρ/a, once: ∫₀ᵃ ρⁿ ρ (2ρ² − a²) dρ = aⁿ⁺⁴ ∫₀¹ xⁿ⁺¹ (2x² − 1) dx,
/// and the integral over x by quadrature.
#[derive(Clone, Debug)]
pub struct Profile {
    terms: Vec<Term>,
}

#[derive(Clone, Debug)]
struct Term {
    coefficient: Real,
    exponent: Exponent,
    /// 2 ∫₀¹ xⁿ⁺¹ dx.
    mean: Real,
    /// ∫₀¹ xⁿ⁺¹ (2x² − 1) dx.
    load: Real,
    /// ∫₀¹ xⁿ⁺¹ ln(1/x) dx.
    log: Real,
}

impl Term {
    fn of(coefficient: Real, exponent: Real) -> Self {
        let [mean, load, log] = integrals(&exponent);
        Self { coefficient, exponent: Exponent::of(exponent), mean, load, log }
    }
}

/// 2 ∫₀¹ xⁿ⁺¹ dx, ∫₀¹ xⁿ⁺¹ (2x² − 1) dx and ∫₀¹ xⁿ⁺¹ ln(1/x) dx, evaluated once per exponent.
fn integrals(exponent: &Real) -> [Real; 3] {
    static KNOWN: Mutex<Vec<(Real, [Real; 3])>> = Mutex::new(Vec::new());
    let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, integrals)) = known().iter().find(|(known, _)| known == exponent) {
        return integrals.clone();
    }
    // The error is 1e-72 or less, as a result has about twice the digits in which it agrees with the one before; the
    // bracket of the pressure kernel cancels up to 24 of these digits.
    let tolerance = decimal("1e-48");
    let next = Exponent::of(exponent + whole(1));
    let integrals = integrate(&whole(0), &whole(1), &tolerance, |x| {
        let power = next.power_of(x);
        [whole(2) * &power, &power * (whole(2) * x * x - whole(1)), -(power * x.ln())]
    });
    known().push((exponent.clone(), integrals.clone()));
    integrals
}

impl Profile {
    /// The gap of the pairs (C, n) with exactly these `f64`.
    #[must_use]
    pub fn of(terms: &[(f64, f64)]) -> Self {
        Self { terms: terms.iter().map(|&(c, n)| Term::of(double(c), double(n))).collect() }
    }

    /// The gap of the pairs (C, n) with exactly these decimals or quotients of decimals, such as `7/3`.
    #[must_use]
    pub fn of_decimals(terms: &[(&str, &str)]) -> Self {
        let number = |text: &str| match text.split_once('/') {
            Some((dividend, divisor)) => decimal(dividend) / decimal(divisor),
            None => decimal(text),
        };
        Self { terms: terms.iter().map(|&(c, n)| Term::of(number(c), number(n))).collect() }
    }

    /// The gap of the pairs (C, n).
    #[must_use]
    pub fn of_numbers(terms: Vec<(Real, Real)>) -> Self {
        Self { terms: terms.into_iter().map(|(c, n)| Term::of(c, n)).collect() }
    }

    /// Φ(r).
    #[must_use]
    pub fn gap(&self, r: &Real) -> Real {
        self.at(r).gap()
    }

    /// δ₀(a) = (2/a²) ∫₀ᵃ Φ ρ dρ, the mean of the gap over the contact disc: Eq. (10).
    #[must_use]
    pub fn approach(&self, a: &Real) -> Real {
        self.at(a).approach()
    }

    /// δ₀′(a) = (2/a) (Φ(a) − δ₀(a)), the derivative of the approach.
    #[must_use]
    pub fn approach_slope(&self, a: &Real) -> Real {
        let at = self.at(a);
        whole(2) * (at.gap() - at.approach()) / a
    }

    /// J(a) = ∫₀ᵃ Φ ρ (2ρ² − a²) dρ of Eq. (14).
    #[must_use]
    pub fn load_integral(&self, a: &Real) -> Real {
        self.at(a).load_integral()
    }

    /// L(x) = ∫₀ˣ Φ ρ ln(x/ρ) dρ of Eq. (28).
    #[must_use]
    pub fn log_kernel(&self, x: &Real) -> Real {
        self.at(x).log_kernel()
    }

    /// G(a, r) = δ₀(a) (a² − r²)/4 + L(r) − L(a) of Eq. (28); zero for r ≥ a.
    #[must_use]
    pub fn pressure_kernel(&self, a: &Real, r: &Real) -> Real {
        self.at(a).pressure_kernel(&self.at(r))
    }

    /// The powers of a radius, from which all functions at that radius follow.
    pub(super) fn at(&self, radius: &Real) -> At<'_> {
        let power = |term: &Term| &term.coefficient * term.exponent.power_of(radius);
        At { terms: &self.terms, square: radius * radius, powers: self.terms.iter().map(power).collect() }
    }

    /// The contact radius at which J is `target`, by Newton's method from a start in `f64`.
    ///
    /// # Panics
    ///
    /// If there is none.
    #[must_use]
    pub fn radius(&self, target: &Real) -> Real {
        if target.repr().is_pos_zero() {
            return whole(0);
        }
        let close = decimal("1e-28");
        let mut a = double(self.start(rounded(target)));
        for _ in 0..40 {
            let at = self.at(&a);
            let correction = (at.load_integral() - target) / at.log_slope_of_load_integral();
            a = &a - &a * &correction;
            // The remaining error is of the order of the correction squared.
            if size(correction) < close {
                return a;
            }
        }
        unreachable!("no contact radius for the load integral {target}")
    }

    /// The first radius at which J reaches `target`, in `f64`.
    ///
    /// J is below the target while each of its N positive terms is below target/N; from there the radius grows in steps
    /// of 1 % until J reaches the target, and the last step is bisected.
    ///
    /// # Panics
    ///
    /// If J does not reach it at any radius of an `f64`.
    fn start(&self, target: f64) -> f64 {
        let terms: Vec<(f64, f64, f64)> = self
            .terms
            .iter()
            .map(|term| {
                let weight = rounded(&term.coefficient);
                let log = weight.abs().ln() + rounded(&term.load).ln() - target.ln();
                (weight.signum(), log, rounded(&term.exponent.value) + 4.0)
            })
            .collect();
        let reaches = |x: f64| {
            terms.iter().map(|&(sign, log, power)| sign * (log + power * x).exp()).sum::<f64>() >= 1.0
        };
        let count = terms.len() as f64;
        let positive = terms.iter().filter(|term| term.0 > 0.0);
        let mut low =
            positive.map(|&(_, log, p)| -(log + count.ln()) / p).fold(f64::INFINITY, f64::min) - 1e-9;
        let mut high = low + 0.01;
        while !reaches(high) {
            assert!(high < f64::MAX.ln(), "no contact radius for the load integral {target}");
            (low, high) = (high, high + 0.01);
        }
        for _ in 0..60 {
            let middle = low + (high - low) / 2.0;
            if reaches(middle) { high = middle } else { low = middle }
        }
        high.exp()
    }
}

/// A profile at one radius.
pub(super) struct At<'a> {
    terms: &'a [Term],
    square: Real,
    /// C xⁿ of every term.
    powers: Vec<Real>,
}

impl At<'_> {
    fn sum(&self, weight: impl Fn(&Term) -> Real) -> Real {
        self.powers.iter().zip(self.terms).fold(whole(0), |sum, (power, term)| sum + power * weight(term))
    }

    fn gap(&self) -> Real {
        self.sum(|_| whole(1))
    }

    fn approach(&self) -> Real {
        self.sum(|term| term.mean.clone())
    }

    fn load_integral(&self) -> Real {
        self.sum(|term| term.load.clone()) * &self.square * &self.square
    }

    /// a J′(a).
    fn log_slope_of_load_integral(&self) -> Real {
        self.sum(|term| &term.load * (&term.exponent.value + whole(4))) * &self.square * &self.square
    }

    fn log_kernel(&self) -> Real {
        self.sum(|term| term.log.clone()) * &self.square
    }

    /// G(a, r) for this radius a and another radius r.
    pub(super) fn pressure_kernel(&self, r: &Self) -> Real {
        if r.square >= self.square {
            return whole(0);
        }
        self.approach() * (&self.square - &r.square) / whole(4) + r.log_kernel() - self.log_kernel()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[should_panic(expected = "no contact radius")]
    fn a_load_integral_beyond_the_largest_has_no_radius() {
        let _ = Profile::of(&[(0.025, 2.0), (-1e-4, 4.0)]).radius(&double(1e9));
    }
}
