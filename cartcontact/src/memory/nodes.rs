//! The nodes of a rule for an integral over the radius, side by side, so that vectors take several at a time.

use super::Increment;
use super::quadrature::{MOST_NODES, Rule};
use super::stretch::Stretch;
use crate::load::Load;
use crate::{GapProfile, Scalar};

/// Above which power of the gap δ₀′ is corrected for the rounding of a radius, which r⁶⁴ multiplies by 64.
const HIGH_POWER: f64 = 24.0;

/// A node of an integral over the radius. Of radius and depth one is rounded: near the edge the radius, near the centre
/// the depth.
pub(super) struct Node<T> {
    pub(super) s: T,
    /// Below the edge.
    pub(super) depth: T,
    /// Of ds.
    pub(super) weight: T,
}

impl<T: Scalar> Node<T> {
    /// δ₀′ at the radius `edge` − depth, of which s is the rounded value.
    ///
    /// A power sⁿ multiplies the rounding by n. Where that is much, a short step inwards stands for the derivative.
    #[inline(always)]
    fn approach_slope<P: GapProfile<T>>(&self, profile: &P, edge: T) -> T {
        let slope = profile.quick_approach_slope(self.s);
        if profile.highest_exponent() <= T::constant(HIGH_POWER) {
            return slope;
        }
        let rounding = (edge - self.s) - self.depth;
        let step = self.s * T::constant(1.0 / 4096.0);
        slope + (slope - profile.quick_approach_slope(self.s - step)) * (rounding / step)
    }
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
        let (mut deficits, mut decays) = ([T::zero(); MOST_NODES], [T::zero(); MOST_NODES]);
        let rows = self.radii.iter_mut().zip(&mut self.slopes).zip(&mut self.weights).zip(&mut deficits);
        for ((((radius, slope), weight), deficit), (x, dx)) in rows.zip(rule.nodes(low, high)) {
            let node = place(x, dx);
            *radius = node.s;
            *slope = node.approach_slope(stretch.contact.profile(), stretch.high);
            *weight = node.weight;
            *deficit = stretch.deficit_at(node.depth);
        }
        let (deficits, decays) = (&deficits[..rule.len()], &mut decays[..rule.len()]);
        stretch.fill_decays(deficits, decays);
        for ((weight, &slope), &decay) in self.weights.iter_mut().zip(&self.slopes).zip(&*decays) {
            *weight = *weight * slope * decay;
        }
    }

    /// ∫ δ₀′ e^(−χ age) {s² − low², 1} ds
    #[inline(always)]
    pub(super) fn increment(&self, low: T) -> Increment<T> {
        let (radii, weights) = (&self.radii[..self.count], &self.weights[..self.count]);
        let mut moments = [T::zero(); MOST_NODES];
        Increment::of(radii, weights, &mut moments[..self.count], low)
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
