//! The rim of a surface, |κ| r² = R², where its series ends.

use core::cmp::Ordering;

use crate::first_zero::{End, first_zero};
use crate::gap::coefficient::Coefficient;
use crate::gap::surface::Surface;
use crate::number::{Rational, integer, nearest};

/// Nothing for a paraboloid, or if a field decides.
pub(crate) fn rim(surface: &Surface) -> Option<End> {
    let (radius, shape) = (surface.radius.as_constant()?, surface.shape.as_constant()?);
    first_zero(&[(integer(0), &radius * &radius), (integer(2), -shape.abs())]).ok()?
}

/// |κ| (ρ/R)² at a radius ρ, which is below 1 inside the rim; nothing if a field decides.
pub(super) fn share_of_rim(surface: &Surface, radius: &Coefficient) -> Option<Rational> {
    let square = radius.power(&integer(2)).ok()?;
    let inverse_square = surface.radius.power(&integer(-2)).ok()?;
    surface.shape.multiply(&square).multiply(&inverse_square).as_constant().map(|share| share.abs())
}

/// The decimal if it lies within all rims, otherwise the largest one of seven digits that does.
pub(crate) fn inside(decimal: &Rational, surfaces: &[Surface]) -> Rational {
    surfaces.iter().filter_map(rim).fold(decimal.clone(), |inside, mut rim| {
        let radius = nearest(&inside).and_then(Rational::from_float);
        match radius.map(|radius| rim.compare(&radius)) {
            Some(Ordering::Greater) | None => inside,
            Some(_) => rim.decimals().1.unwrap_or(inside),
        }
    })
}
