//! Why layers do not make a medium, or have no time of diffusion.

use core::fmt;

use crate::shown::Shown;

/// Why layers do not make a medium, or have no time of diffusion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MediumError {
    /// A thickness is not positive and finite.
    Thickness {
        /// What was given, in mm.
        thickness: f64,
    },
    /// A shear modulus is not positive and finite.
    ShearModulus {
        /// What was given, in MPa.
        shear_modulus: f64,
    },
    /// A permeability is negative or not finite.
    Permeability {
        /// What was given, in mm⁴/(N s).
        permeability: f64,
    },
    /// A Poisson's ratio is not between −1 and 1/2.
    PoissonRatio {
        /// What was given.
        poisson_ratio: f64,
    },
    /// The stiffness m is not positive and finite, or so small that it loses digits.
    Stiffness {
        /// What was given or follows from the layers, in MPa/mm³.
        m: f64,
    },
    /// The rate of drainage χ is negative or not finite, or so small that it loses digits.
    Rate {
        /// What was given or follows from the layers, in 1/s; 0 if that of permeable layers is rounded to it.
        chi: f64,
    },
}

impl fmt::Display for MediumError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Thickness { thickness } => write!(
                f,
                "the layer's thickness is {}, but it must be a positive number; {}",
                Shown(thickness),
                remedy_for_thickness(thickness)
            ),
            Self::ShearModulus { shear_modulus } => write!(
                f,
                "the layer's shear modulus is {}, but it must be a positive number; {}",
                Shown(shear_modulus),
                remedy_for_shear_modulus(shear_modulus)
            ),
            Self::Permeability { permeability } => write!(
                f,
                "the layer's permeability is {}, but it must be 0 (an elastic layer) or a positive number; {}",
                Shown(permeability),
                if permeability.is_nan() { NO_NUMBER } else { "check its unit, mm⁴/(N s)" }
            ),
            Self::PoissonRatio { poisson_ratio } => write!(
                f,
                "the Poisson's ratio of the layer's matrix is {}, but it must be above -1 and below 0.5; give that of \
                 the drained matrix, not that of the tissue with its fluid",
                Shown(poisson_ratio)
            ),
            Self::Stiffness { m } => write!(
                f,
                "the stiffness m is {}, but it must be a positive number that the format holds with all its digits; \
                 check the units of thickness and shear modulus",
                Shown(m)
            ),
            Self::Rate { chi: 0.0 } => f.write_str(
                "the rate chi of the layers is so small that the format rounds it to 0; check the units of permeability \
                 and thickness, or give a permeability of 0 if nothing is to drain",
            ),
            Self::Rate { chi } => write!(
                f,
                "the rate chi is {}, but it must be 0 (no drainage) or a positive number that the format holds with \
                 all its digits; check the units of permeability and thickness",
                Shown(chi)
            ),
        }
    }
}

// Also for errors of `Medium::against_rigid`.
const BARE: &str = "if this body is bare, `Medium::against_rigid` takes the layer of the other one";
const NO_NUMBER: &str = "check what it is computed from";

fn remedy_for_thickness(thickness: f64) -> &'static str {
    if thickness == 0.0 {
        BARE
    } else if thickness < 0.0 {
        "give the distance from the bone to the surface of the layer, without a sign"
    } else if thickness.is_nan() {
        NO_NUMBER
    } else {
        "layers are thin against the contact here; give a thickness of that size"
    }
}

fn remedy_for_shear_modulus(shear_modulus: f64) -> &'static str {
    if shear_modulus == f64::INFINITY {
        BARE
    } else if shear_modulus.is_nan() {
        NO_NUMBER
    } else {
        "a layer that does not resist shear carries no load; check its value and unit, MPa"
    }
}

impl core::error::Error for MediumError {}
