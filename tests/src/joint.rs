//! Contacts in the medium of the paper's joint.

use cartcontact::load::Load;
use cartcontact::{Contact, GapProfile, Medium, Scalar};

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
