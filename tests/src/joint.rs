//! Contacts in the medium of the paper's joint.

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, GapProfile, Medium, Scalar};

/// The contact of a geometry under a load, with the stiffness m of the paper's layers and a rate χ.
///
/// # Panics
///
/// If the geometry or the load is refused.
pub fn joint<T: Scalar, P: GapProfile<T>, L: Load<T>>(profile: P, chi: f64, load: L) -> Contact<T, P, L> {
    let medium = Medium::from_constants(T::constant(0.375), T::constant(chi));
    let medium = medium.unwrap_or_else(|error| unreachable!("{error}"));
    Contact::new(profile, medium, load).unwrap_or_else(|error| unreachable!("{error}"))
}

/// The pressures at a time, one way after the other: of a snapshot, and of fields of one row and of two.
///
/// # Errors
///
/// If the contact has no solution up to the time.
pub fn pressures_each_way<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    time: f64,
    radii: &[T],
) -> Result<Vec<T>, ContactError> {
    let [time, before] = [time, 0.9 * time].map(T::constant);
    let now = contact.at(time)?;
    let (mut one, mut two) = (vec![T::zero(); radii.len()], vec![T::zero(); 2 * radii.len()]);
    contact.pressure_field(&[time], radii, &mut one)?;
    contact.pressure_field(&[before, time], radii, &mut two)?;
    let snapshot: Vec<T> = radii.iter().map(|&r| now.pressure(r)).collect();
    Ok([&snapshot, &one, &two[radii.len()..]].concat())
}
