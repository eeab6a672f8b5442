//! The formulas as the paper prints them, with general crates for root and integral; the example `work_precision`
//! includes this file too.

use std::error::Error;
use std::f64::consts::PI;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use roots::{Convergency, SearchError, find_root_newton_raphson};

use super::{FORCE, RATE, STIFFNESS};

/// The coefficients of r² and r⁴ in the gap.
const C: [f64; 2] = [0.025, 1.09375e-4];
/// The last step, in mm, of a search for a root to the full precision of f64, as Newton's method squares errors.
pub(crate) const FULL: f64 = 1e-8;

/// J and J′ by Eq. (14).
fn load_integral(a: f64) -> [f64; 2] {
    let square = a * a;
    let fifth = square * square * a;
    let [c2, c4] = C.map(|c| c / 12.0);
    [fifth * a * (c2 + c4 * square), fifth * (6.0 * c2 + 8.0 * c4 * square)]
}

/// δ₀′(a).
pub(crate) fn approach_slope(a: f64) -> f64 {
    a * (C[0] + C[1] * (4.0 / 3.0) * (a * a))
}

/// a(t) by Eq. (14), until a step is below `last` mm.
pub(crate) fn radius(time: f64, last: f64) -> Result<f64, SearchError> {
    radius_of(4.0 / (PI * STIFFNESS) * FORCE * (1.0 + RATE * time), last)
}

/// The radius of a load integral, starting from that of the first term alone, until a step is below `last` mm.
pub(crate) fn radius_of(target: f64, last: f64) -> Result<f64, SearchError> {
    let start = (target * 12.0 / C[0]).powf(1.0 / 6.0);
    find_root_newton_raphson(
        start,
        |a| load_integral(a)[0] - target,
        |a| load_integral(a)[1],
        &mut LastStep(last),
    )
}

/// Ends Newton's method by its step alone; the ready-made criterion would also compare residues, in mm⁵, with it.
struct LastStep(f64);

impl Convergency<f64> for LastStep {
    fn is_root_found(&mut self, y: f64) -> bool {
        y == 0.0
    }

    fn is_converged(&mut self, x1: f64, x2: f64) -> bool {
        (x1 - x2).abs() < self.0
    }

    fn is_iteration_limit_reached(&mut self, iter: usize) -> bool {
        iter >= 50
    }
}

/// The time at which the contact reaches a distance from the axis; 0 within the initial contact.
pub(crate) fn time_of_contact(r: f64) -> f64 {
    ((PI * STIFFNESS / 4.0 * load_integral(r)[0] / FORCE - 1.0) / RATE).max(0.0)
}

/// G(a, r), the bracket of Eq. (26), from the approach and the log kernel.
pub(crate) fn kernel(a: f64, r: f64) -> f64 {
    let log_kernel = |x: f64| {
        let square = x * x;
        square * square * (C[0] / 16.0 + C[1] / 36.0 * square)
    };
    let square = a * a;
    let approach = square * (C[0] / 2.0 + C[1] / 3.0 * square);
    approach * (square - r * r) / 4.0 + log_kernel(r) - log_kernel(a)
}

/// P(r, t) by Eqs. (25)–(27), with a Gauss-Legendre rule for the memory.
#[derive(Debug)]
pub(crate) struct Pressure {
    rule: GaussLegendre,
}

impl Pressure {
    pub(crate) fn with_order(order: usize) -> Result<Self, Box<dyn Error>> {
        let order = NonZeroUsize::new(order).ok_or("a rule needs nodes")?;
        Ok(Self { rule: GaussLegendre::new(order) })
    }

    pub(crate) fn at(&self, time: f64, r: f64) -> Result<f64, SearchError> {
        let now = radius(time, FULL)?;
        if r >= now {
            return Ok(0.0);
        }
        let memory = self.rule.integrate(time_of_contact(r), time, |earlier| {
            radius(earlier, FULL).map_or(f64::NAN, |a| kernel(a, r)) * (-RATE * (time - earlier)).exp()
        });
        Ok(STIFFNESS * (kernel(now, r) - RATE * memory))
    }
}
