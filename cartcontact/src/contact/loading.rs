//! What is known of a load at a time.

use super::Contact;
use crate::Scalar;
use crate::load::Load;
use crate::scalar::smallest_normal;

/// A load at a time: F, ∫F and Y = F + χ ∫F.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loading<T> {
    pub(crate) force: T,
    pub(crate) impulse: T,
    pub(crate) hereditary: T,
}

impl<T: Scalar> Loading<T> {
    /// From a force and an impulse.
    #[inline(always)]
    pub(crate) fn new(force: T, impulse: T, chi: T) -> Self {
        Self { force, impulse, hereditary: force + chi * impulse }
    }

    /// Whether F, 2 χ F, ∫F, 2 Y, the load integral of the force and that of the whole load are normal numbers. A force
    /// of zero may be one of them, χ F if χ is zero, and an impulse that is no more than a rounding of the force.
    #[inline(always)]
    pub(super) fn has_digits(&self, chi: T, (of_force, load_integral): (T, T)) -> bool {
        let (force, least) = (self.force, smallest_normal());
        let drained = chi * force;
        let has_drained = chi.is_zero() | ((drained >= least) & (drained + drained).is_finite());
        let has_force = force.is_zero() | ((force >= least) & (of_force >= least) & has_drained);
        // An impulse below the normal numbers is off by up to ε times the least of these, which is a rounding of the
        // force if χ times the least is no more than the force.
        let has_impulse = (chi <= force * least.recip()) | (self.impulse >= least);
        // Before anything has drained, a² P(0, t) is up to 4 Y/π.
        let is_finite = (self.hereditary + self.hereditary).is_finite() & load_integral.is_finite();
        has_force & has_impulse & (load_integral >= least) & is_finite
    }
}

impl<T: Scalar, P, L: Load<T>> Contact<T, P, L> {
    /// What is known of the load at a time.
    #[inline(always)]
    pub(crate) fn loading(&self, t: T) -> Loading<T> {
        self.loading_of_impulse(t, self.load.impulse(t))
    }

    /// The [`loading`](Self::loading) at a time up to which ∫F is known.
    #[inline(always)]
    pub(crate) fn loading_of_impulse(&self, t: T, impulse: T) -> Loading<T> {
        Loading::new(self.load.force(t), impulse, self.medium.chi())
    }
}
