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
    /// The rate χ is negative or not finite, or so small that it loses digits.
    Rate {
        /// What was given or follows from the layers, in 1/s.
        chi: f64,
    },
}

impl fmt::Display for MediumError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Thickness { thickness } => write!(
                f,
                "the layer's thickness is {}, but it must be a positive number; for a bare rigid body use \
                 `Medium::against_rigid` with the other layer",
                Shown(thickness)
            ),
            Self::ShearModulus { shear_modulus } => write!(
                f,
                "the layer's shear modulus is {}, but it must be a positive number; for a bare rigid body use \
                 `Medium::against_rigid` with the other layer",
                Shown(shear_modulus)
            ),
            Self::Permeability { permeability } => write!(
                f,
                "the layer's permeability is {}, but it must be 0 (an elastic layer) or a positive number; \
                 check its unit, mm⁴/(N s)",
                Shown(permeability)
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
            Self::Rate { chi } => write!(
                f,
                "the rate chi is {}, but it must be 0 (no drainage) or a positive number that the format holds with \
                 all its digits; check the units of permeability and thickness",
                Shown(chi)
            ),
        }
    }
}

impl core::error::Error for MediumError {}
