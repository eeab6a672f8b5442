//! Contacts whose radius at a time is given.

use core::f64::consts::FRAC_PI_4;

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, GapProfile, Medium, Scalar};

/// The stiffness m with which the contact radius at `t` is `a`.
#[must_use]
pub fn stiffness<T: Scalar>(
    profile: &(impl GapProfile<T> + ?Sized),
    load: &(impl Load<T> + ?Sized),
    chi: T,
    a: T,
    t: T,
) -> T {
    (load.force(t) + chi * load.impulse(t)) / profile.load_integral(a) / T::constant(FRAC_PI_4)
}

/// The contact whose radius at `t` is `a`.
///
/// # Errors
///
/// As [`Contact::new`], and if no stiffness gives that radius.
pub fn contact<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    profile: P,
    load: L,
    chi: T,
    a: T,
    t: T,
) -> Result<Contact<T, P, L>, ContactError> {
    let medium = Medium::from_constants(stiffness(&profile, &load, chi, a, t), chi)?;
    Contact::new(profile, medium, load)
}
