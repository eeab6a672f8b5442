//! The shear modulus and the permeability of a cartilage layer from a creep test, by least squares.
//!
//! ```text
//! cargo run --release --example creep_fit
//! ```
//!
//! A rigid ball is pressed on one layer with a constant force, and its approach is measured in time: at first the
//! shear modulus decides, later the permeability. The method is that of Gauss and Newton on the logarithms of both,
//! which keeps them positive. The Jacobian comes from dual numbers, so that no step width of a difference has to be
//! chosen, and gives the standard errors too.

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use cartcontact::{Contact, Layer, Medium, Scalar, gap_profile, load};
use nalgebra::{Matrix2, Vector2};
use num_dual::Dual64;

/// A ball on a plane; the field is its radius in mm.
#[gap_profile(r^2 / (2 * radius))]
struct Ball<T> {
    radius: T,
}

/// In mm.
const BALL_RADIUS: f64 = 25.0;
/// In mm.
const THICKNESS: f64 = 0.8;
/// In N.
const FORCE: f64 = 30.0;

/// Times in s, and the approach in mm at each: made up from 0.3 MPa and 1.5e-3 mm⁴/(N s), with a noise of 0.8 µm.
const MEASURED: [(f64, f64); 24] = [
    (1.0, 0.2353),
    (2.0, 0.2357),
    (3.0, 0.2357),
    (5.0, 0.2359),
    (7.0, 0.2362),
    (10.0, 0.2381),
    (15.0, 0.2374),
    (20.0, 0.2381),
    (30.0, 0.2397),
    (45.0, 0.2429),
    (60.0, 0.2451),
    (80.0, 0.247),
    (100.0, 0.2524),
    (130.0, 0.2547),
    (160.0, 0.2587),
    (200.0, 0.2651),
    (250.0, 0.2704),
    (300.0, 0.2778),
    (360.0, 0.2853),
    (420.0, 0.2914),
    (480.0, 0.2968),
    (540.0, 0.3019),
    (600.0, 0.3085),
    (660.0, 0.3156),
];

/// Where the search begins: a shear modulus in MPa and a permeability in mm⁴/(N s).
const GUESS: [f64; 2] = [1.0, 1e-2];
/// The largest step of a logarithm: a factor of e.
const LONGEST_STEP: f64 = 1.0;
/// Steps of logarithms below this change no digit that is printed.
const SHORTEST_STEP: f64 = 1e-9;
const MOST_STEPS: usize = 50;

fn main() -> ExitCode {
    examples::run("creep_fit", [], |[]| run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut out = io::stdout().lock();
    writeln!(out, "step  shear modulus, MPa  permeability, mm⁴/(N s)  residual, µm")?;
    let mut logarithms = Vector2::from(GUESS.map(f64::ln));
    for step in 0..MOST_STEPS {
        let sums = Sums::at(logarithms)?;
        let [shear_modulus, permeability] = logarithms.map(f64::exp).into();
        let residual = 1e3 * sums.deviation();
        writeln!(out, "{step:>4}  {shear_modulus:>18.4}  {permeability:>23.3e}  {residual:>12.2}")?;
        let covariance =
            sums.curvature.try_inverse().ok_or("the measurements do not determine both constants")?;
        let change = -covariance * sums.slope;
        if change.amax() < SHORTEST_STEP {
            return report(&mut out, logarithms, &sums, covariance);
        }
        logarithms += change * (LONGEST_STEP / change.amax()).min(1.0);
    }
    Err(format!("no fit after {MOST_STEPS} steps; begin nearer to the expected constants").into())
}

/// The approach in mm at a time, for the logarithms of both constants.
fn approach<T: Scalar>(logarithms: [T; 2], time: f64) -> Result<T, Box<dyn Error>> {
    let [shear_modulus, permeability] = logarithms.map(T::exp);
    let [thickness, radius, force, time] = [THICKNESS, BALL_RADIUS, FORCE, time].map(T::constant);
    let medium = Medium::against_rigid(Layer { thickness, shear_modulus, permeability })?;
    Ok(Contact::new(Ball { radius }, medium, load::Constant(force))?.at(time)?.approach())
}

/// What the method needs of the residuals r, which are model less measurement, and of their Jacobian J.
struct Sums {
    /// Jᵀ J, rows and columns in the order of the constants.
    curvature: Matrix2<f64>,
    /// Jᵀ r
    slope: Vector2<f64>,
    /// rᵀ r, in mm².
    squares: f64,
}

impl Sums {
    fn at(logarithms: Vector2<f64>) -> Result<Self, Box<dyn Error>> {
        let mut sums = Self { curvature: Matrix2::zeros(), slope: Vector2::zeros(), squares: 0.0 };
        for (time, measured) in MEASURED {
            let [x, y] = logarithms.map(Dual64::from).into();
            let (along_x, along_y) =
                (approach([x.derivative(), y], time)?, approach([x, y.derivative()], time)?);
            let (residual, gradient) = (along_x.re - measured, Vector2::new(along_x.eps, along_y.eps));
            sums.curvature += gradient * gradient.transpose();
            sums.slope += gradient * residual;
            sums.squares += residual * residual;
        }
        Ok(sums)
    }

    /// The standard deviation of the residuals in mm, which have two degrees of freedom less.
    fn deviation(&self) -> f64 {
        (self.squares / (MEASURED.len() - 2) as f64).sqrt()
    }
}

/// Writes the constants with their standard errors: that of a logarithm is the relative one.
fn report(
    out: &mut impl Write,
    logarithms: Vector2<f64>,
    sums: &Sums,
    covariance: Matrix2<f64>,
) -> Result<(), Box<dyn Error>> {
    let [shear_modulus, permeability] = logarithms.map(f64::exp).into();
    let error = covariance.diagonal().map(f64::sqrt) * sums.deviation();
    writeln!(out, "\nshear modulus {shear_modulus:.4} ± {:.4} MPa", shear_modulus * error.x)?;
    writeln!(out, "permeability  {permeability:.3e} ± {:.0e} mm⁴/(N s)", permeability * error.y)?;

    let layer = Layer { thickness: THICKNESS, shear_modulus, permeability };
    let contact =
        Contact::new(Ball { radius: BALL_RADIUS }, Medium::against_rigid(layer)?, load::Constant(FORCE))?;
    let thicknesses = contact.at(0.0)?.radius() / THICKNESS;
    writeln!(
        out,
        "\nThe contact radius is {thicknesses:.1} thicknesses: the README says how good the model is there."
    )?;
    Ok(())
}
