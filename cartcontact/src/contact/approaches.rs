//! The approach of the bones from the contact radius, at one time and at many.

use super::radii::BLOCK;
use super::{Contact, Loading};
use crate::Scalar;
use crate::load::Load;
use crate::memory::Edge;
use crate::profile::GapProfile;

/// Puts the approaches in the places of the radii at these times.
pub(super) fn replace_radii<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    times: &[T],
    radii: &mut [T],
) {
    let mut impulses = [T::zero(); BLOCK];
    for (times, radii) in times.chunks(BLOCK).zip(radii.chunks_mut(BLOCK)) {
        let impulses = &mut impulses[..times.len()];
        let are_summed = contact.load.fill_impulses(times, impulses);
        for ((place, &time), &impulse) in radii.iter_mut().zip(times).zip(&*impulses) {
            let loading =
                if are_summed { contact.loading_of_impulse(time, impulse) } else { contact.loading(time) };
            *place = contact.approach(loading, Edge { time, radius: *place });
        }
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    /// δ₀ of a contact radius, and what that radius lacks under its loading.
    pub(crate) fn approach(&self, loading: Loading<T>, edge: Edge<T>) -> T {
        let (approach, load_integral) = self.profile.approach_and_load_integral(edge.radius);
        let stage = self.stage_with_load_integral(loading, edge, load_integral);
        approach + stage.strip(self.integral_per_load())
    }
}
