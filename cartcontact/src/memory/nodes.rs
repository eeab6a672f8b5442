//! The nodes of a rule for an integral over the radius, side by side, so that vectors take several at a time.

use super::Increment;
use super::quadrature::{MOST_NODES, Rule};
use super::stretch::Stretch;
use crate::load::Load;
use crate::{GapProfile, Scalar};

/// A node of an integral over the radius. Of radius and depth one is rounded: near the edge the radius, near the centre
/// the depth.
pub(super) struct Node<T> {
    pub(super) s: T,
    /// Below the edge.
    pub(super) depth: T,
    /// Of ds.
    pub(super) weight: T,
}

/// All nodes, with what is integrated at each.
pub(super) struct Nodes<T> {
    count: usize,
    radii: [T; MOST_NODES],
    /// δ₀′
    slopes: [T; MOST_NODES],
    /// δ₀′ e^(−χ age) ds
    weights: [T; MOST_NODES],
}

impl<T: Scalar> Nodes<T> {
    /// Room for them: what is returned by value is copied.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = [T::zero(); MOST_NODES];
        Self { count: 0, radii: zero, slopes: zero, weights: zero }
    }

    /// Takes those of a rule for a variable from `low` to `high`; `place` makes a node of its value and its weight.
    #[inline(always)]
    pub(super) fn take<P, L>(
        &mut self,
        stretch: &Stretch<'_, T, P, L>,
        rule: &Rule,
        (low, high): (T, T),
        place: impl Fn(T, T) -> Node<T>,
    ) where
        P: GapProfile<T>,
        L: Load<T>,
    {
        self.count = rule.len();
        let nodes = ..rule.len();
        let zero = [T::zero(); MOST_NODES];
        let (mut depths, mut drops, mut decays) = (zero, zero, zero);
        let (depths, drops, decays) = (&mut depths[nodes], &mut drops[nodes], &mut decays[nodes]);
        let (radii, slopes) = (&mut self.radii[nodes], &mut self.slopes[nodes]);
        let weights = &mut self.weights[nodes];
        let rows = radii.iter_mut().zip(&mut *depths).zip(&mut *weights);
        for (((radius, depth), weight), (x, dx)) in rows.zip(rule.nodes(low, high)) {
            let node = place(x, dx);
            (*radius, *depth, *weight) = (node.s, node.depth, node.weight);
        }
        stretch.contact.profile().fill_slopes_and_drops(stretch.high, (radii, depths), (slopes, drops));
        stretch.fill_decays(drops, decays);
        for ((weight, &slope), &decay) in weights.iter_mut().zip(&*slopes).zip(&*decays) {
            *weight = *weight * slope * decay;
        }
    }

    /// ∫ δ₀′ e^(−χ age) {s² − low², 1} ds
    #[inline(always)]
    pub(super) fn increment(&self, low: T) -> Increment<T> {
        let (radii, weights) = (&self.radii[..self.count], &self.weights[..self.count]);
        Increment::of(radii, weights, low)
    }

    /// Whether s δ₀′ rises with the radius from node to node, if nodes are placed by their depth.
    #[inline(always)]
    pub(super) fn are_steady(&self) -> bool {
        let rounding = T::one() + T::default_epsilon() * T::constant(16.0);
        let steepness = |k: usize| self.radii[k] * self.slopes[k];
        // At the outermost nodes so far, toward the edge and toward the centre.
        let (mut outer, mut inner) = (T::zero(), T::infinity());
        (0..self.count).step_by(2).all(|k| {
            let (before, after) = ((outer, inner), (steepness(k), steepness(k + 1)));
            (outer, inner) = after;
            outer * rounding >= before.0 && inner <= before.1 * rounding && inner <= outer * rounding
        })
    }
}
