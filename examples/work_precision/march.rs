//! The same equations as rates, integrated in time with a fixed number of steps.
//!
//! Differentiated in time, Eqs. (14) and (5) are
//!
//! ```text
//! a′ = 8 Y′/(π m δ₀′(a) a⁴),     P′ = (m/4) δ₀′(a) a′ (a² − r²) − χ P = (2/π) Y′ (a² − r²)/a⁴ − χ P
//! ```
//!
//! with Y′ = χ F under a constant force. A march begins when the contact reaches r, with P = 0, or at t = 0
//! with P = m G(a₀, r): from then on everything is smooth, so that a scheme has its full order.

use std::f64::consts::{FRAC_2_PI, PI};

use roots::SearchError;

use crate::printed::{self, FULL, approach_slope, kernel, time_of_contact};
use crate::scenes::{FORCE, RATE, STIFFNESS};

/// The scheme of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Scheme {
    /// Euler's scheme, explicit and of first order.
    Euler,
    /// The classical scheme of Runge and Kutta, of fourth order.
    RungeKutta,
}

/// a(t).
pub(crate) fn radius(scheme: Scheme, steps: u32, time: f64) -> Result<f64, SearchError> {
    let [radius] = scheme.march(steps, time, [printed::radius(0.0, FULL)?], |[a]| [radius_rate(a)]);
    Ok(radius)
}

/// P(r, t).
pub(crate) fn pressure(scheme: Scheme, steps: u32, time: f64, r: f64) -> Result<f64, SearchError> {
    let initial_radius = printed::radius(0.0, FULL)?;
    let (start, state) = if r < initial_radius {
        (0.0, [initial_radius, STIFFNESS * kernel(initial_radius, r)])
    } else {
        (time_of_contact(r), [r, 0.0])
    };
    let [_, pressure] = scheme.march(steps, time - start, state, |[a, pressure]| {
        let square = a * a;
        let supply = FRAC_2_PI * RATE * FORCE * (square - r * r) / (square * square);
        [radius_rate(a), supply - RATE * pressure]
    });
    Ok(pressure)
}

fn radius_rate(a: f64) -> f64 {
    let square = a * a;
    8.0 * RATE * FORCE / (PI * STIFFNESS * approach_slope(a) * (square * square))
}

impl Scheme {
    fn march<const N: usize>(
        self,
        steps: u32,
        duration: f64,
        mut state: [f64; N],
        rate: impl Fn([f64; N]) -> [f64; N],
    ) -> [f64; N] {
        let step = duration / f64::from(steps);
        for _ in 0..steps {
            state = match self {
                Self::Euler => moved(state, step, rate(state)),
                Self::RungeKutta => {
                    let first = rate(state);
                    let second = rate(moved(state, 0.5 * step, first));
                    let third = rate(moved(state, 0.5 * step, second));
                    let fourth = rate(moved(state, step, third));
                    let mean = |i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0;
                    moved(state, step, std::array::from_fn(mean))
                }
            };
        }
        state
    }
}

fn moved<const N: usize>(state: [f64; N], step: f64, rate: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| state[i] + step * rate[i])
}
