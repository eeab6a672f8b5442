//! When the impulse of a load cannot be that of its force.
//!
//! Between samples a force may be anything, so no number of samples determines its integral. But where the edge does
//! not recede, Y = F + χ ∫F does not fall, and neither does F e^(χ t), whose slope is Y′ e^(χ t). So between two forces
//! F₁ and F₂, x e-foldings apart,
//!
//! ```text
//! F₁ (1 − e^(−x))/χ ≤ ∫F ≤ F₂ (e^x − 1)/χ,
//! ```
//!
//! whatever the force does in between: steps, kinks and oscillations too fast for any sample are no exception. An
//! impulse outside these bounds belongs to another force, or Y falls between the two times.
//!
//! Many impulses result from a quadrature themselves. They may be off by √ε of Y/χ, which counts for little.

use crate::Scalar;
use crate::load::{ForceSeries, LoadError};

/// An impulse that no force with these samples can have unless the hereditary load falls between them.
#[derive(Clone, Copy)]
pub(in crate::load) struct Contradiction<T> {
    from: T,
    to: T,
    impulse: T,
    /// The integral of the force.
    integral: T,
}

/// The least and the most that ∫F can be along a series.
fn bounds<T: Scalar>(force: &ForceSeries<T>, chi: T) -> (T, T) {
    // Nodes are counted from the end.
    (0..ForceSeries::<T>::START).fold((T::zero(), T::zero()), |(least, most), node| {
        let duration = force.time(node) - force.time(node + 1);
        let folds = chi * duration;
        // The means of e^(−x) and e^x between the nodes.
        let (falling, rising) = if folds.is_zero() {
            (T::one(), T::one())
        } else {
            (-(-folds).exp_m1() / folds, folds.exp_m1() / folds)
        };
        let (first, last) = (force.force_at(node + 1), force.force_at(node));
        (least + first * duration * falling, most + last * duration * rising)
    })
}

impl<T: Scalar> Contradiction<T> {
    /// The contradiction, if any, between a force series that begins at a time and what the impulse gains along it; the
    /// impulse may be off by the tolerance at either end.
    pub(super) fn within(
        force: &ForceSeries<T>,
        (from, impulse): (T, T),
        chi: T,
        tolerance: T,
    ) -> Option<Self> {
        let (least, most) = bounds(force, chi);
        let is_outside = (impulse - most).max(least - impulse) > tolerance + tolerance;
        is_outside.then(|| Self { from, to: force.end(), impulse, integral: force.impulse().0 })
    }

    /// The contradiction, if any, between the impulse up to a time and the integral of straight pieces. The integral is
    /// known, but users sum impulses in plain arithmetic, hence 1/256 = 0.4 % is tolerated as well.
    pub(super) fn with_integral((to, impulse): (T, T), integral: T, tolerance: T) -> Option<Self> {
        let is_off = (impulse - integral).abs() > integral * T::constant(1.0 / 256.0) + tolerance;
        is_off.then(|| Self { from: T::zero(), to, impulse, integral })
    }

    pub(super) fn from(&self) -> T {
        self.from
    }

    /// Whether its end is not after a time.
    pub(super) fn ends_by(&self, time: T) -> bool {
        self.to <= time
    }

    pub(super) fn error(&self) -> LoadError {
        LoadError::ContradictoryImpulse {
            from: self.from.value(),
            to: self.to.value(),
            impulse: self.impulse.value(),
            integral: self.integral.value(),
        }
    }
}
