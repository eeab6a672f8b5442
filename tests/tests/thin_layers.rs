//! How good the model itself is: contact radius, approach and peak pressure right after loading, against the exact
//! solution for an elastic layer.
//!
//! At t = 0⁺ no fluid has moved, and a biphasic layer responds like an incompressible elastic one. Let the thickness
//! and the shear modulus of one layer bonded to a rigid plane be 1. The Hankel transform of its surface's displacement
//! is that of the pressure times L(ξ)/(2 ξ), with
//!
//! ```text
//! 1 − L(ξ) = (1 + 2 ξ + 2 ξ² + e^(−2ξ)) / (cosh 2ξ + 1 + 2 ξ²)
//! ```
//!
//! Under a rigid paraboloid, gap C r², with an approach δ the transform of the pressure is ∫₀ᵃ φ(t) cos ξt dt, where
//!
//! ```text
//! φ(x) − ∫₀ᵃ K(x, t) φ(t) dt = (4/π) (δ − 2 C x²),    K(x, t) = (2/π) ∫₀^∞ (1 − L(ξ)) cos ξx cos ξt dξ
//! ```
//!
//! and φ(a) = 0. The load is 2π ∫ φ dt, and the pressure on the axis −∫ φ′(t)/t dt.
//!
//! Source: W. C. Hayes, L. M. Keer, G. Herrmann, L. F. Mockros, A mathematical analysis for indentation tests of
//! articular cartilage, J. Biomech. 5 (1972) 541–551, doi 10.1016/0021-9290(72)90010-3.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_4, PI};
use core::num::NonZeroUsize;

use cartcontact::load::Constant;
use cartcontact::{Contact, GapProfile, Layer, Medium, gap_profile};
use gauss_quad::GaussLegendre;
use nalgebra::{DMatrix, DVector};
use tests::reference::SHIFT_OF_EDGE;

type Failure = Box<dyn core::error::Error>;

const C: f64 = 0.5;

#[gap_profile(0.5 * r^2)]
struct Paraboloid;

/// 1 − L(ξ) is below 1e-17 from here on.
const LARGEST: f64 = 24.0;

/// Nodes and weights between two ends, in panels of 24 nodes.
fn rule((from, to): (f64, f64), panels: u32) -> Vec<(f64, f64)> {
    let rule = GaussLegendre::new(NonZeroUsize::new(24).unwrap_or(NonZeroUsize::MIN));
    let half = (to - from) / f64::from(2 * panels);
    let middles = (0..panels).map(|panel| from + half * f64::from(2 * panel + 1));
    middles
        .flat_map(|middle| rule.iter().map(move |(x, w)| (middle + half * x, half * w)).collect::<Vec<_>>())
        .collect()
}

/// The load, the approach and the pressure on the axis for a contact radius, in thicknesses.
struct Exact {
    load: f64,
    approach: f64,
    peak_pressure: f64,
}

impl Exact {
    fn of(a: f64) -> Option<Self> {
        // A node or more for each thickness, and three or more for each wave of cos ξ(x + t).
        let places = rule((0.0, a), 3 + (a / 8.0) as u32);
        let frequencies = rule((0.0, LARGEST), 4 + (1.5 * a) as u32);
        // The last row is that of x = a.
        let xs: Vec<f64> = places.iter().map(|place| place.0).chain([a]).collect();
        let cosines = DMatrix::from_fn(xs.len(), frequencies.len(), |i, q| (frequencies[q].0 * xs[i]).cos());
        let weighted = DMatrix::from_fn(frequencies.len(), places.len(), |q, j| {
            let ((frequency, of_frequency), (_, of_place)) = (frequencies[q], places[j]);
            FRAC_2_PI * of_frequency * one_less(frequency) * cosines[(j, q)] * of_place
        });
        let kernel = &cosines * &weighted;
        let count = places.len();
        let system = (DMatrix::identity(count, count) - kernel.rows(0, count)).lu();
        let solve = |right: &dyn Fn(f64) -> f64| {
            let inside = system.solve(&DVector::from_fn(count, |i, _| right(xs[i])))?;
            let at_edge = right(a) + (kernel.row(count) * &inside)[0];
            Some((inside, at_edge))
        };
        let (of_approach, approach_at_edge) = solve(&|_| 4.0 / PI)?;
        let (of_gap, gap_at_edge) = solve(&|x| 8.0 * C / PI * x * x)?;
        let approach = gap_at_edge / approach_at_edge;
        let density = of_approach * approach - of_gap;
        let load =
            2.0 * PI * places.iter().zip(&density).map(|(place, density)| place.1 * density).sum::<f64>();
        // −φ′(x)/x, the derivative of the equation.
        let transform = &weighted * &density;
        let slope = |x: f64| {
            let of_layer = frequencies.iter().zip(&transform);
            16.0 * C / PI + of_layer.map(|(&(xi, _), value)| xi * (xi * x).sin() / x * value).sum::<f64>()
        };
        let peak_pressure = places.iter().map(|&(x, weight)| weight * slope(x)).sum();
        Some(Self { load, approach, peak_pressure })
    }

    /// The contact radius and the rest under a load, by the secant method from a radius nearby.
    fn under(load: f64, start: f64) -> Option<(f64, Self)> {
        let misfit = |a: f64| Some((Self::of(a)?.load / load).ln());
        let (mut before, mut now) = (start * 0.99, start);
        let mut misfit_before = misfit(before)?;
        for _ in 0..20 {
            let misfit_now = misfit(now)?;
            if misfit_now.abs() < 1e-10 {
                return Some((now, Self::of(now)?));
            }
            let next = now - misfit_now * (now - before) / (misfit_now - misfit_before);
            (before, misfit_before, now) = (now, misfit_now, next);
        }
        None
    }
}

/// 1 − L(ξ)
fn one_less(xi: f64) -> f64 {
    let polynomial = 1.0 + 2.0 * xi * xi;
    (polynomial + 2.0 * xi + (-2.0 * xi).exp()) / ((2.0 * xi).cosh() + polynomial)
}

/// The model's contact radius, approach and peak pressure over the exact ones, and the exact radius, for a contact
/// radius by the model; all in thicknesses.
fn ratios(thicknesses: f64) -> Result<([f64; 3], f64), Failure> {
    let layer = Layer { thickness: 1.0, shear_modulus: 1.0, permeability: 1.0 };
    let medium = Medium::against_rigid(layer)?;
    let load = FRAC_PI_4 * medium.m() * Paraboloid.load_integral(thicknesses);
    let contact = Contact::new(Paraboloid, medium, Constant(load))?;
    let model = contact.at(0.0)?;
    let (radius, exact) = Exact::under(load, thicknesses - 1.4).ok_or("no exact solution")?;
    let ratios = [
        model.radius() / radius,
        model.approach() / exact.approach,
        model.peak_pressure() / exact.peak_pressure,
    ];
    Ok((ratios, radius))
}

/// In per cent; the documentation has two digits of them.
#[test]
fn errors_are_as_documented() -> Result<(), Failure> {
    for (thicknesses, documented) in [
        (4.0, [47.6, 30.1, -29.0]),
        (8.0, [21.4, 8.9, -10.1]),
        (16.0, [9.9, 2.5, -2.8]),
        (32.0, [4.8, 0.66, -0.71]),
    ] {
        let (ratios, _) = ratios(thicknesses)?;
        for (ratio, documented) in ratios.into_iter().zip(documented) {
            let error = 100.0 * (ratio - 1.0);
            assert!(
                (error - documented).abs() < 0.06,
                "a/h = {thicknesses}: {error} instead of {documented}"
            );
        }
    }
    Ok(())
}

/// The shift hardly depends on the radius.
#[test]
fn radii_less_the_shift_of_the_edge_are_as_documented() -> Result<(), Failure> {
    for (thicknesses, documented) in [(4.0, 6.5), (8.0, 0.9), (16.0, 0.15), (32.0, 0.05)] {
        let (_, radius) = ratios(thicknesses)?;
        let error = 100.0 * ((thicknesses - SHIFT_OF_EDGE) / radius - 1.0).abs();
        assert!(error < documented, "a/h = {thicknesses}: {error} %");
    }
    Ok(())
}

/// A layer that is thick against the contact is a half-space, for which Hertz's solution has the load 32/3 C a³, the
/// approach 2 C a² and the pressure 3/2 of the mean one.
#[test]
fn thick_layers_are_half_spaces() -> Result<(), Failure> {
    let a = 1e-4;
    let exact = Exact::of(a).ok_or("no exact solution")?;
    let hertz = [32.0 / 3.0 * C * a * a * a, 2.0 * C * a * a, 16.0 / PI * C * a];
    for (found, expected) in [exact.load, exact.approach, exact.peak_pressure].into_iter().zip(hertz) {
        assert!((found / expected - 1.0).abs() < 2.0 * a, "{found} instead of {expected}");
    }
    Ok(())
}
