//! How far the model holds where the surfaces are steep: it takes gap, displacement and load along the axis.
//!
//! Compared with thin layers on spheres: a ball of radius R in a socket that is wider by c ≪ R. At the angle θ from the
//! axis the layers are compressed by δ cos θ − c (1 − cos θ), and right after loading the pressure obeys
//!
//! ```text
//! Δp = −m (δ cos θ − c (1 − cos θ)),     p = p′ = 0 at the edge θ₀
//! ```
//!
//! with the Laplacian of the sphere. With u = cos θ₀ its solution has
//!
//! ```text
//! δ = c tan²(θ₀/2),     p(0) = m c R² ((1 − u)/(1 + u) − ln(2/(1 + u))),     F = π m c R⁴ (1 − u)³/(6 (1 + u))
//! ```
//!
//! Here R, c and m are 1. The gap along the axis is then 1/√(1 − r²) − 1.

use core::f64::consts::{LN_2, PI};

use cartcontact::load::Constant;
use cartcontact::{Contact, Medium, Polynomial};

type Failure = Box<dyn core::error::Error>;

/// The errors of contact radius, approach and peak pressure in per cent, under the load for which the radius is a.
fn errors(gap: &[(f64, f64)], a: f64) -> Result<[f64; 3], Failure> {
    let u = (1.0 - a * a).sqrt();
    let load = PI * (1.0 - u).powi(3) / (6.0 * (1.0 + u));
    let approach = (1.0 - u) / (1.0 + u);
    let contact = Contact::new(Polynomial::new(gap)?, Medium::from_constants(1.0, 0.0)?, Constant(load))?;
    let model = contact.at(0.0)?;
    let ratios = [
        model.radius() / a,
        model.approach() / approach,
        model.peak_pressure() / (approach - LN_2 + u.ln_1p()),
    ];
    Ok(ratios.map(|ratio| 100.0 * (ratio - 1.0)))
}

#[test]
fn errors_are_as_documented() -> Result<(), Failure> {
    let mut coefficient = 1.0;
    let series: Vec<(f64, f64)> = (1..=80)
        .map(|k| {
            let power = 2.0 * f64::from(k);
            coefficient *= (power - 1.0) / power;
            (coefficient, power)
        })
        .collect();
    for (gap, a, documented) in [
        (&series[..], 0.1, [0.04, 0.08, 0.00]),
        (&series[..], 0.4, [0.68, 1.49, 0.04]),
        (&series[..], 0.7, [2.15, 6.21, 0.57]),
        (&series[..1], 0.1, [0.17, -0.17, -0.17]),
        (&series[..1], 0.4, [2.88, -2.80, -2.79]),
        (&series[..1], 0.7, [10.83, -9.77, -9.65]),
    ] {
        for (error, documented) in errors(gap, a)?.into_iter().zip(documented) {
            assert!((error - documented).abs() < 0.01, "a/R = {a}: {error} instead of {documented}");
        }
    }
    Ok(())
}
