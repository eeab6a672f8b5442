//! The contact radii at many times, without a branch for each.
//!
//! Times are taken in blocks. A block whose numbers are all of common size needs no other check. For any other, such as
//! one that begins unloaded, the conditions themselves are checked; where one of these fails, times are taken one by
//! one, until the first without a radius names its fault.

use super::common_sizes::CommonSizes;
use super::recession::latest;
use super::{Contact, ContactError, Loading};
use crate::Scalar;
use crate::dispatch::wide;
use crate::load::Load;
use crate::profile::GapProfile;

/// How many radii are solved for at once; with their times and load integrals they stay in the nearest cache.
pub(super) const BLOCK: usize = 256;

/// The radii at as many times; `recedes_from` is their [`recession_within`](super::recession_within).
pub(super) fn fill<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    times: &[T],
    radii: &mut [T],
    recedes_from: Option<T>,
) -> Result<(), ContactError> {
    let mut load_integrals = [T::zero(); BLOCK];
    for (times, radii) in times.chunks(BLOCK).zip(radii.chunks_mut(BLOCK)) {
        let is_advancing = recedes_from.is_none_or(|since| latest(times) < since);
        let load_integrals = &mut load_integrals[..times.len()];
        if !(is_advancing && Block { contact, times, load_integrals, radii }.fill()) {
            for (radius, &time) in radii.iter_mut().zip(times) {
                *radius = contact.radius_if_advancing(time, recedes_from)?;
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
        let is_common = self.take_load_integrals();
        (is_common || self.take_unusual_load_integrals())
            && self.take_radii()
            && (is_common && self.has_common_radii() || self.keeps_digits())
    }

    /// Takes the load integrals; false unless all of them, all times and all forces are of common size.
    #[inline(always)]
    fn take_load_integrals(&mut self) -> bool {
        let contact = self.contact;
        // Their places hold the impulses first.
        if contact.load.fill_impulses(self.times, self.load_integrals) {
            return self.take_load_integrals_under(|t, impulse| contact.loading_of_impulse(t, impulse));
        }
        wide(
            #[inline(always)]
            || {
                self.take_load_integrals_under(
                    #[inline(always)]
                    |t, _| contact.loading(t),
                )
            },
        )
    }

    /// Takes the load integrals under loadings that are a function of the time and of what is in their places.
    #[inline(always)]
    fn take_load_integrals_under(&mut self, loading: impl Fn(T, T) -> Loading<T>) -> bool {
        let (sizes, scales) = (CommonSizes::new(), self.contact.scales);
        let mut are_common = sizes.contain_rate(self.contact.medium.chi());
        for (load_integral, &time) in self.load_integrals.iter_mut().zip(self.times) {
            let common_time = sizes.time_near(time);
            let loading = loading(common_time, *load_integral);
            let load_integrals = scales.load_integrals(loading);
            *load_integral = load_integrals.1;
            are_common &= (common_time == time) & sizes.contain_load(loading, load_integrals);
        }
        are_common
    }

    /// Takes the load integrals; false unless [`Contact::at`] accepts all times and loads.
    fn take_unusual_load_integrals(&mut self) -> bool {
        let contact = self.contact;
        self.load_integrals.iter_mut().zip(self.times).all(|(load_integral, &time)| {
            contact.valid_loading(time).is_ok_and(|loading| {
                *load_integral = contact.scales.load_integral(loading);
                contact.has_digits(loading)
            })
        })
    }

    fn take_radii(&mut self) -> bool {
        self.contact.radii_of(self.load_integrals, self.radii).is_ok()
    }

    fn has_common_radii(&self) -> bool {
        wide(
            #[inline(always)]
            || self.radii.iter().fold(true, |all, &radius| all & CommonSizes::new().contain(radius)),
        )
    }

    fn keeps_digits(&self) -> bool {
        wide(
            #[inline(always)]
            || {
                let contacts = self.times.iter().zip(&*self.radii).zip(&*self.load_integrals);
                contacts.fold(true, |all, ((&time, &radius), &load_integral)| {
                    all & self.contact.keeps_digits(self.contact.load.force(time), radius, load_integral)
                })
            },
        )
    }
}
