//! The shear modulus and the permeability of a cartilage layer from a creep test, by least squares.
//!
//! ```text
//! cargo run --release --example creep_fit
//! ```
//!
//! A rigid ball is pressed on one layer with a constant force, and its approach is measured over time: at first it
//! depends on the shear modulus, later on the permeability too. The method is Gauss-Newton on the logarithms of both,
//! which keeps them positive. The Jacobian comes from dual numbers, so that no step of a finite difference has to be
//! chosen, and also gives the standard errors.

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
const BALL_RADIUS: f64 = 100.0;
/// In mm.
const THICKNESS: f64 = 0.5;
/// In N.
const FORCE: f64 = 200.0;

/// Of the matrix; one above 0 makes the diffusion time shorter.
const POISSON_RATIO: f64 = 0.0;

/// Times in s, and the approach in mm at each: made up by the model from 0.3 MPa and
/// 1.5e-3 mm⁴/(N s), with a noise of 0.5 µm.
const MEASURED: [(f64, f64); 24] = [
    (0.5, 0.1098),
    (1.0, 0.1101),
    (1.5, 0.1101),
    (2.0, 0.1101),
    (3.0, 0.1103),
    (4.0, 0.1113),
    (5.0, 0.1106),
    (7.0, 0.1109),
    (10.0, 0.1115),
    (13.0, 0.1126),
    (16.0, 0.1131),
    (20.0, 0.1131),
    (25.0, 0.1155),
    (30.0, 0.1152),
    (35.0, 0.116),
    (40.0, 0.1176),
    (46.0, 0.1179),
    (52.0, 0.1197),
    (58.0, 0.121),
    (65.0, 0.1218),
    (72.0, 0.1224),
    (80.0, 0.123),
    (90.0, 0.125),
    (100.0, 0.1274),
];

/// Where the search begins: a shear modulus in MPa and a permeability in mm⁴/(N s).
const GUESS: [f64; 2] = [1.0, 1e-2];
/// The largest step of a logarithm: a factor of e.
const LONGEST_STEP: f64 = 1.0;
/// Steps of logarithms below this change no digit that is printed.
const SHORTEST_STEP: f64 = 1e-9;
const MOST_STEPS: usize = 50;
/// How many e-foldings of drainage the last measurement must see for there to be a permeability to find.
const LEAST_FOLDS: f64 = 1e-6;

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    const { assert!(MEASURED.len() > 2, "two constants take more than two measurements") };
    let mut out = io::stdout().lock();
    writeln!(out, "step  shear modulus, MPa  permeability, mm⁴/(N s)  residual, µm")?;
    let mut logarithms = Vector2::from(GUESS.map(f64::ln));
    for step in 0..MOST_STEPS {
        let sums = Sums::at(logarithms)?;
        let [shear_modulus, permeability] = logarithms.map(f64::exp).into();
        let residual = 1e3 * sums.deviation();
        writeln!(out, "{step:>4}  {shear_modulus:>18.4}  {permeability:>23.3e}  {residual:>12.2}")?;
        let inverse =
            sums.curvature.try_inverse().ok_or("the measurements do not determine both constants")?;
        let change = -inverse * sums.slope;
        if change.amax() < SHORTEST_STEP {
            return report(&mut out, logarithms, &sums, inverse);
        }
        logarithms += change * (LONGEST_STEP / change.amax()).min(1.0);
    }
    Err(format!(
        "no fit after {MOST_STEPS} steps; begin nearer to the expected constants, or measure until the approach grows"
    )
    .into())
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

    /// The standard deviation of the residuals in mm; the two fitted constants take two degrees of freedom.
    fn deviation(&self) -> f64 {
        (self.squares / (MEASURED.len() - 2) as f64).sqrt()
    }
}

/// Writes the constants with their standard errors, of which that of a logarithm is the relative one, and what these
/// errors leave out.
fn report(
    out: &mut impl Write,
    logarithms: Vector2<f64>,
    sums: &Sums,
    inverse: Matrix2<f64>,
) -> Result<(), Box<dyn Error>> {
    let [shear_modulus, permeability] = logarithms.map(f64::exp).into();
    let layer = Layer { thickness: THICKNESS, shear_modulus, permeability };
    let medium = Medium::against_rigid(layer)?;
    let last = MEASURED.iter().fold(0.0, |last, row| f64::max(last, row.0));
    if last * medium.chi() < LEAST_FOLDS {
        return Err("the approach does not grow, so that there is no permeability to find".into());
    }
    let error = inverse.diagonal().map(f64::sqrt) * sums.deviation();
    writeln!(out, "\nshear modulus {shear_modulus:.4} ± {:.4} MPa", shear_modulus * error.x)?;
    writeln!(out, "permeability  {permeability:.3e} ± {:.0e} mm⁴/(N s)", permeability * error.y)?;

    let contact = Contact::new(Ball { radius: BALL_RADIUS }, medium, load::Constant(FORCE))?;
    let thicknesses = contact.at(0.0)?.radius() / THICKNESS;
    let share = last / layer.diffusion_time(POISSON_RATIO)?;
    writeln!(out, "\nThese errors come from the noise alone. The model is for thin layers: where")?;
    writeln!(out, "the contact radius is 8 thicknesses, a fitted shear modulus is 1.29 times the")?;
    writeln!(
        out,
        "true one, at 16 thicknesses 1.08 times (README). Here it is {thicknesses:.1} thicknesses."
    )?;
    writeln!(out, "It is also for times that are short compared with the diffusion time; the last")?;
    writeln!(out, "measurement is at {share:.2} of it, for a Poisson's ratio of {POISSON_RATIO}.")?;
    Ok(())
}
