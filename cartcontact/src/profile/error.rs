//! What can be wrong with a geometry or a load integral, and the messages.

use core::fmt;

use crate::Scalar;
use crate::profile::Parameters;
use crate::shown::Shown;

/// Why there is no contact radius for a load integral.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RadiusError {
    /// The load integral is negative, infinite or not a number.
    InvalidLoadIntegral {
        /// What was given, in mm⁵.
        load_integral: f64,
    },
    /// The contact would grow beyond the admissible range of the geometry.
    BeyondRange {
        /// What was given, in mm⁵.
        load_integral: f64,
        /// The largest admissible load integral, in mm⁵.
        largest: f64,
        /// The contact radius that belongs to it, in mm.
        max_radius: f64,
    },
    /// Terms of both signs cancel to the load integral, but they or those of a J′ are too large for the format; or the
    /// load integral is so near an end of the format that the derivatives of its radius are not numbers.
    Unrepresentable {
        /// What was given, in mm⁵.
        load_integral: f64,
    },
    /// The number of places for radii differs from the number of load integrals.
    Length {
        /// The number of load integrals.
        load_integrals: usize,
        /// The number of places for radii.
        radii: usize,
    },
}

/// Checks that there is a place for the radius of every load integral.
pub(crate) fn check_places<T>(load_integrals: &[T], radii: &[T]) -> Result<(), RadiusError> {
    let (load_integrals, radii) = (load_integrals.len(), radii.len());
    if load_integrals == radii { Ok(()) } else { Err(RadiusError::Length { load_integrals, radii }) }
}

impl fmt::Display for RadiusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::InvalidLoadIntegral { load_integral } => write!(
                f,
                "the load integral is {}, but it must be finite and not negative to have a contact radius; check the \
                 load and the medium",
                Shown(load_integral)
            ),
            // A limit of a caller, or the end that a geometry has if it is not usable.
            Self::BeyondRange { max_radius, .. } if max_radius.is_nan() || max_radius <= 0.0 => write!(
                f,
                "contact radii are admissible up to {}, so that there is none; give a positive limit, or ask \
                 `GapProfile::check` what is wrong with the geometry",
                Shown(max_radius)
            ),
            Self::BeyondRange { load_integral, largest, max_radius } => write!(
                f,
                "the load integral {} exceeds {}, which the contact reaches at the end of the admissible \
                 range, radius {}; lower the load, or extend `max_radius` if one was given",
                Shown(load_integral),
                Shown(largest),
                Shown(max_radius)
            ),
            Self::Unrepresentable { load_integral } => write!(
                f,
                "the load integral {} is a difference of terms that are too large for the format, or its radius has \
                 derivatives that are; choose units in which force and length are nearer to 1",
                Shown(load_integral)
            ),
            Self::Length { load_integrals, radii } => write!(
                f,
                "there are {load_integrals} load integrals and {radii} places for their radii; give slices of \
                 the same length"
            ),
        }
    }
}

impl core::error::Error for RadiusError {}

/// Why a geometry given at run time has no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ProfileError {
    /// No term has a coefficient other than zero.
    Empty,
    /// With the values of the fields all coefficients are zero.
    Vanishing {
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
    /// A field that is declared positive is not a finite number above 0.
    NotPositive {
        /// The name of the field.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A field is a number of f64 that the format of the contact does not hold: too large, or too small for all its
    /// digits.
    OutOfFormat {
        /// The name of the field.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// A coefficient is not a number, is so small that it loses digits, or twice its size is infinite.
    InvalidCoefficient {
        /// The coefficient.
        coefficient: f64,
        /// The exponent of its term.
        exponent: f64,
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
    /// An exponent is not in the range from above 0 to 1024, or so near to 0 that the slope of the gap loses digits.
    InvalidExponent {
        /// The exponent.
        exponent: f64,
    },
    /// The end of the range of contact radii is not a positive number.
    InvalidMaxRadius {
        /// What was given, in mm.
        max_radius: f64,
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
    /// The surfaces overlap, or do not separate, next to the first point of contact.
    NotOpening {
        /// The smallest exponent of the gap.
        exponent: f64,
        /// Its coefficient.
        coefficient: f64,
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
    /// The requested range ends where the series of a surface no longer converges.
    BeyondSurface {
        /// The requested end of the range, in mm.
        max_radius: f64,
        /// Where the series ends, in mm: for a sphere at its radius.
        rim: f64,
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
    /// The gap no longer exceeds its mean over the contact disc before the requested end of the range.
    NotAdmissible {
        /// The requested end of the range, in mm.
        max_radius: f64,
        /// The radius at which the condition fails, in mm.
        fails_at: f64,
        /// The fields that the geometry depends on.
        parameters: Parameters,
    },
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => {
                write!(
                    f,
                    "the gap has no term with a coefficient other than 0; give at least one (coefficient, exponent), \
                     such as (0.025, 2)"
                )
            }
            Self::Vanishing { parameters } => write!(
                f,
                "{parameters}all coefficients of the gap are 0, so that the surfaces touch everywhere; choose values \
                 with which at least one is not"
            ),
            Self::NotPositive { field, value } => write!(
                f,
                "`{field}` is {}, but the geometry declares it positive; give it a finite value above 0",
                Shown(value)
            ),
            Self::OutOfFormat { field, value } => write!(
                f,
                "`{field}` is {}, which is out of the range of the format that the contact computes in; use units that \
                 bring it nearer to 1, or a format with more exponents, such as f64",
                Shown(value)
            ),
            Self::InvalidCoefficient { coefficient, exponent, parameters } => write!(
                f,
                "{parameters}the coefficient of r^{} is {}, but {}",
                Shown(exponent),
                Shown(coefficient),
                rule_for_coefficient(coefficient)
            ),
            Self::InvalidExponent { exponent } if exponent > 0.0 && exponent < 1.0 => write!(
                f,
                "the exponent is {}, so near to 0 that the slope of the gap would lose its digits; give one above {}",
                Shown(exponent),
                Shown(exponent)
            ),
            Self::InvalidExponent { exponent } => write!(
                f,
                "the exponent is {}, but it must be above 0, as the gap vanishes at r = 0, and at most 1024; check \
                 that pairs are (coefficient, exponent)",
                Shown(exponent)
            ),
            Self::InvalidMaxRadius { max_radius, parameters } => write!(
                f,
                "{parameters}the largest contact radius is {}, but it must be positive; if there is no limit, give \
                 infinity, or use `Polynomial::new` or an attribute without `max_radius`",
                Shown(max_radius)
            ),
            Self::NotOpening { exponent, coefficient, parameters } => write!(
                f,
                "{parameters}the gap does not open at r = 0: its leading term is {} r^{}; {}",
                Shown(coefficient),
                Shown(exponent),
                if coefficient == 0.0 {
                    "its coefficients cancel; leave these terms out"
                } else if coefficient > 0.0 {
                    "it is no more than rounding, or others outweigh it beyond radii too small for the format; check \
                     the coefficients, or use a smaller unit of length"
                } else {
                    "the lowest power needs a coefficient that is positive by more than rounding, as where a socket is \
                     wider than its ball"
                }
            ),
            Self::BeyondSurface { max_radius, rim, parameters } => write!(
                f,
                "{parameters}the largest contact radius is {}, but the series of a surface ends at r = {}; choose \
                 `max_radius` below {}",
                Shown(max_radius),
                Shown(rim),
                Shown(rim)
            ),
            Self::NotAdmissible { max_radius, fails_at, parameters } => write!(
                f,
                "{parameters}the gap does not exceed its mean over the contact disc at r = {}, inside the requested \
                 range up to {}; choose `max_radius` below {}",
                Shown(fails_at),
                Shown(max_radius),
                Shown(fails_at)
            ),
        }
    }
}

/// What a refused coefficient must be, and what to do; the rest of a sentence that ends in "but".
fn rule_for_coefficient(coefficient: f64) -> &'static str {
    if coefficient == 0.0 {
        "only because the format rounds it to that; use a unit of length that brings it nearer to 1, or a format with \
         more exponents"
    } else if !coefficient.is_finite() {
        "it must be a finite number; check the geometry's parameters for zero, overflow and NaN"
    } else if coefficient.abs() > 1.0 {
        "twice its size must be a finite number; use a unit of length that brings it nearer to 1, or a format with \
         more exponents"
    } else {
        "it must be 0 or large enough to keep its digits; use a unit of length that brings it nearer to 1, or a \
         format with more exponents"
    }
}

impl core::error::Error for ProfileError {}

/// The outcome of a check, an error with the fields that caused it.
pub fn with_parameters<T: Scalar, const N: usize>(
    checked: Result<T, ProfileError>,
    names: &'static [&'static str; N],
    values: [T; N],
) -> Result<T, ProfileError> {
    let Err(mut error) = checked else { return checked };
    match &mut error {
        ProfileError::Vanishing { parameters }
        | ProfileError::InvalidCoefficient { parameters, .. }
        | ProfileError::InvalidMaxRadius { parameters, .. }
        | ProfileError::NotOpening { parameters, .. }
        | ProfileError::BeyondSurface { parameters, .. }
        | ProfileError::NotAdmissible { parameters, .. } => *parameters = Parameters::new(names, values),
        ProfileError::Empty => error = ProfileError::Vanishing { parameters: Parameters::new(names, values) },
        ProfileError::InvalidExponent { .. }
        | ProfileError::NotPositive { .. }
        | ProfileError::OutOfFormat { .. } => {}
    }
    Err(error)
}
