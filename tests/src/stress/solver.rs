//! The solver and the contact of a scene.

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, GapProfile, Medium, Polynomial};

use super::fields;
use super::precision::Precision;
use super::scene::{Form, Scene};
use crate::profiles::cases;

/// The contact of a scene.
pub(super) type Loaded<'a, T> = Contact<T, &'a dyn GapProfile<T>, PiecewiseLinear<T, &'a [(T, T)]>>;

/// The solver of a scene's geometry.
///
/// # Errors
///
/// As [`Polynomial::new`].
pub(super) fn solver<T: Precision>(
    scene: &Scene<T>,
) -> Result<Box<dyn GapProfile<T>>, cartcontact::ProfileError> {
    Ok(match (scene.form, scene.max_radius) {
        (Form::Constant(index), _) => Box::new(T::solver(&cases()[index])),
        (Form::Fields(index), _) => {
            let coefficients = core::array::from_fn(|term| scene.terms[term].0);
            let solver = fields::solver(index, coefficients);
            solver.check()?;
            solver
        }
        (Form::Polynomial, None) => Box::new(Polynomial::new(scene.terms.clone())?),
        (Form::Polynomial, Some(end)) => Box::new(Polynomial::with_max_radius(scene.terms.clone(), end)?),
    })
}

/// The contact of a scene.
///
/// # Errors
///
/// If the load, the medium or the geometry is refused.
pub(super) fn contact<'a, T: Precision>(
    scene: &'a Scene<T>,
    profile: &'a dyn GapProfile<T>,
) -> Result<Loaded<'a, T>, Box<dyn core::error::Error>> {
    let load = PiecewiseLinear::new(scene.knots.as_slice())?;
    Ok(Contact::new(profile, Medium::from_constants(scene.m, scene.chi)?, load)?)
}
