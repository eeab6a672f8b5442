//! Contacts whose radius at a time is given.

use core::f64::consts::FRAC_PI_4;

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, GapProfile, Medium};

/// The stiffness m with which the contact radius at `t` is `a`.
#[must_use]
pub fn stiffness(
    profile: &(impl GapProfile<f64> + ?Sized),
    load: &(impl Load<f64> + ?Sized),
    chi: f64,
    a: f64,
    t: f64,
) -> f64 {
    (load.force(t) + chi * load.impulse(t)) / profile.load_integral(a) / FRAC_PI_4
}

/// The contact whose radius at `t` is `a`.
///
/// # Errors
///
/// As [`Contact::new`].
///
/// # Panics
///
/// If no stiffness gives that radius.
pub fn contact<P: GapProfile<f64>, L: Load<f64>>(
    profile: P,
    load: L,
    chi: f64,
    a: f64,
    t: f64,
) -> Result<Contact<f64, P, L>, ContactError> {
    let medium = Medium::from_constants(stiffness(&profile, &load, chi, a, t), chi);
    Contact::new(profile, medium.unwrap_or_else(|error| unreachable!("{error}")), load)
}
