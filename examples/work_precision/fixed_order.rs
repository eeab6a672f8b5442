//! The generated kernels with one Gauss-Legendre rule for all scenes, instead of the library's choice.

use std::error::Error;
use std::f64::consts::PI;
use std::num::NonZeroUsize;

use cartcontact::{GapProfile, RadiusError};
use gauss_quad::GaussLegendre;

use crate::Patellofemoral;
use crate::scenes::{FORCE, RATE, STIFFNESS};

/// The pressure as a sum of positive parts, with the memory integral over the contact radius s:
///
/// ```text
/// P = m G(a₀, r) e^(−χ t) + (m/4) ∫ δ₀′(s) (s² − r²) e^(−χ (t − τ(s))) ds
/// χ (t − τ(s)) = (π m/4) (J(a) − J(s))/F
/// ```
#[derive(Debug)]
pub(crate) struct Pressure {
    rule: GaussLegendre,
    initial_radius: f64,
}

impl Pressure {
    pub(crate) fn with_order(order: usize) -> Result<Self, Box<dyn Error>> {
        let order = NonZeroUsize::new(order).ok_or("a rule needs nodes")?;
        Ok(Self { rule: GaussLegendre::new(order), initial_radius: radius(0.0)? })
    }

    pub(crate) fn at(&self, time: f64, r: f64) -> Result<f64, RadiusError> {
        let (first, last) = (self.initial_radius, radius(time)?);
        let fading = PI * STIFFNESS / 4.0 / FORCE;
        let memory = self.rule.integrate(r.max(first), last, |s| {
            let drop = Patellofemoral.load_integral_drop(last, last - s);
            Patellofemoral.approach_slope(s) * ((s - r) * (s + r)) * (-fading * drop).exp()
        });
        let initial = Patellofemoral.pressure_kernel(first, r) * (-RATE * time).exp();
        Ok(STIFFNESS * (initial + 0.25 * memory))
    }
}

fn radius(time: f64) -> Result<f64, RadiusError> {
    Patellofemoral.radius(4.0 / (PI * STIFFNESS) * FORCE * (1.0 + RATE * time))
}
