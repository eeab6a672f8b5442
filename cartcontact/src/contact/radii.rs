//! The contact radii at many times, without a branch for each.
//!
//! A time has a radius where [`Contact::at`] finds no fault. A block of times is asked for something simpler first:
//! that all its forces, load integrals and radii lie between 1/b and b. Then a⁴, J/a⁵, F/a⁴ and χ F lie between b⁻⁶
//! and b⁶, which are normal numbers, so that comparisons with constants stand for a division and many more of them.
//! A block that is not so common, such as one that begins unloaded, is held to the conditions themselves; and where
//! one of these fails, times are taken one by one, until the first without a radius names its fault.

use super::{Contact, ContactError, is_time, keeps_digits};
use crate::Scalar;
use crate::dispatch::wide;
use crate::load::{Load, is_force};
use crate::profile::GapProfile;
use crate::scalar::is;

/// How many radii are solved for at once; with their times and load integrals they stay in the nearest cache.
const BLOCK: usize = 256;

/// The radii at as many times.
pub(super) fn fill<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    times: &[T],
    radii: &mut [T],
) -> Result<(), ContactError> {
    let mut load_integrals = [T::zero(); BLOCK];
    for (times, radii) in times.chunks(BLOCK).zip(radii.chunks_mut(BLOCK)) {
        let load_integrals = &mut load_integrals[..times.len()];
        if !(Block { contact, times, load_integrals, radii }).fill() {
            for (radius, &time) in radii.iter_mut().zip(times) {
                *radius = contact.radius_at(time)?;
            }
        }
    }
    Ok(())
}

struct Block<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    times: &'a [T],
    load_integrals: &'a mut [T],
    radii: &'a mut [T],
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Block<'_, T, P, L> {
    /// False if there is a fault; the radii are then not to be used.
    fn fill(&mut self) -> bool {
        let is_common = wide(
            #[inline(always)]
            || self.take_load_integrals(),
        );
        (is_common || self.has_loads())
            && !self.recedes()
            && self.take_radii()
            && (is_common && self.has_common_radii() || self.keeps_digits())
    }

    /// The load integrals; false if not all of them and of the forces are of common size.
    #[inline(always)]
    fn take_load_integrals(&mut self) -> bool {
        let (chi, per_stiffness, zero) = (self.contact.medium.chi(), self.contact.per_stiffness, T::zero());
        let (least, most) = common_sizes();
        let is_common = |size: T| (least <= size) & (size <= most);
        let mut are_common = chi.is_zero() | is_common(chi);
        for (load_integral, &time) in self.load_integrals.iter_mut().zip(self.times) {
            let loading = self.contact.loading(time);
            *load_integral = loading.hereditary * per_stiffness;
            are_common &= is_common(loading.force) & is_common(*load_integral);
            // An infinite impulse makes the load integral infinite or, times a rate of zero, not a number.
            are_common &= (zero <= time) & (time <= most) & (zero <= loading.impulse);
        }
        are_common
    }

    /// Whether times and loads are such as [`Contact::at`] accepts.
    fn has_loads(&self) -> bool {
        let chi = self.contact.medium.chi();
        self.times.iter().zip(&*self.load_integrals).all(|(&time, &load_integral)| {
            let loading = self.contact.loading(time);
            is_time(time)
                && is_force(loading.force)
                && is_force(loading.impulse)
                && (loading.hereditary.is_zero() || loading.has_digits(chi, load_integral))
        })
    }

    /// Whether the load has fallen too fast: up to the last of the times, if up to any.
    fn recedes(&self) -> bool {
        let last = self.times.iter().fold(T::zero(), |last, &time| if time > last { time } else { last });
        self.contact.load.recession(self.contact.medium.chi(), last).is_some()
    }

    fn take_radii(&mut self) -> bool {
        let Contact { profile, max_radius, .. } = self.contact;
        profile.radii_within(self.load_integrals, *max_radius, self.radii).is_ok()
    }

    fn has_common_radii(&self) -> bool {
        let (least, most) = common_sizes();
        wide(
            #[inline(always)]
            || self.radii.iter().fold(true, |all, &radius| all & (least <= radius) & (radius <= most)),
        )
    }

    fn keeps_digits(&self) -> bool {
        wide(
            #[inline(always)]
            || {
                let contacts = self.times.iter().zip(&*self.radii).zip(&*self.load_integrals);
                contacts.fold(true, |all, ((&time, &radius), &load_integral)| {
                    all & keeps_digits(self.contact.load.force(time), radius, load_integral)
                })
            },
        )
    }
}

/// 1/b and b.
fn common_sizes<T: Scalar>() -> (T, T) {
    let (least, most) = if is::<T, f32>() { (5e-7, 2e6) } else { (1e-51, 1e51) };
    (T::constant(least), T::constant(most))
}
