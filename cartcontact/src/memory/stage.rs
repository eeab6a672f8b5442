//! A time with its contact radius, and what the radius lacks of the load then.

use crate::contact::{Contact, Loading};
use crate::load::Load;
use crate::numbers::compensated_sum::CompensatedSum;
use crate::scalar::is_plain_zero;
use crate::{GapProfile, Scalar};

/// The edge of the contact at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge<T> {
    pub(crate) time: T,
    /// The contact radius then.
    pub(crate) radius: T,
}

/// A stage of the contact: its edge at a time, and what follows from the load.
///
/// The radius is rounded, which moves pressures by up to (n+2) ε/2. `surplus` is the amount by which the hereditary
/// load exceeds that of the rounded radius; to first order the two together are the radius to twice the precision.
/// Stages along one history share the error of the first surplus, which amounts to a slightly different time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stage<T> {
    pub(crate) time: T,
    pub(crate) radius: T,
    pub(crate) surplus: T,
    /// ∫F from the beginning.
    pub(crate) impulse: CompensatedSum<T>,
}

impl<T: Scalar> Stage<T> {
    /// ∫ δ₀′ ds from the rounded radius to the exact one, 2 surplus/((π m/4) a⁴) because dJ = a⁴ δ₀′ da/2.
    #[inline(always)]
    pub(crate) fn strip(&self, integral_per_load: T) -> T {
        if is_plain_zero(self.surplus) || self.radius.is_zero() {
            return T::zero();
        }
        // One division, and a⁴ need not be in range.
        let per_square = (self.radius * self.radius).recip();
        T::constant(2.0) * self.surplus * integral_per_load * per_square * per_square
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Contact<T, P, L> {
    /// The stage of an edge, for integrals that begin or end there.
    pub(crate) fn stage(&self, edge: Edge<T>) -> Stage<T> {
        self.stage_with_loading(self.loading(edge.time), edge)
    }

    /// [`stage`](Self::stage) under a loading that the caller knows.
    pub(crate) fn stage_with_loading(&self, loading: Loading<T>, edge: Edge<T>) -> Stage<T> {
        self.stage_with_load_integral(loading, edge, self.profile().quick_load_integral(edge.radius))
    }

    /// The stage with a radius whose load integral is known.
    pub(crate) fn stage_with_load_integral(
        &self,
        loading: Loading<T>,
        Edge { time, radius }: Edge<T>,
        load_integral: T,
    ) -> Stage<T> {
        let surplus = loading.hereditary - self.load_per_integral() * load_integral;
        let surplus = surplus_that_counts(surplus, loading.force);
        Stage { time, radius, surplus, impulse: loading.impulse.into() }
    }
}

/// The surplus of a stage, unless it is too large for its radius to be taken as exact to first order.
///
/// A surplus of x times the force adds a pressure of first order in x, and shifts all ages by x e-foldings, which takes
/// as much away, since a held load has little more to drain. When the hereditary load is at least 1/√ε times
/// the force, its rounding makes x² larger than rounding. Leaving the surplus out moves the radius by no more than a
/// rounding error.
pub(super) fn surplus_that_counts<T: Scalar>(surplus: T, force: T) -> T {
    if surplus.abs() <= force * T::default_epsilon().sqrt() { surplus } else { T::zero() }
}
