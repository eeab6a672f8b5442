//! The nodes of a rule for an integral over the radius, side by side, so that vectors take several at a time.

use super::Increment;
use super::stretch::Stretch;
use crate::dispatch::half_wide;
use crate::load::Load;
use crate::quadrature::{MOST_NODES, Rule, error_of_finest};
use crate::{GapProfile, Scalar};

/// A node of an integral over the radius. Either its radius or its depth is rounded: near the edge the radius, near the
/// centre the depth.
pub(super) struct Node<T> {
    pub(super) s: T,
    /// The depth below the edge.
    pub(super) depth: T,
    /// The weight of the node, including ds.
    pub(super) weight: T,
}

/// A number for every node. It begins at a cache line, so that no vector needs two of them.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct PerNode<T>(pub(super) [T; MOST_NODES]);

impl<T: Scalar> PerNode<T> {
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self([T::zero(); MOST_NODES])
    }
}

/// An integral by a rule.
pub(super) struct PanelIntegral<T> {
    pub(super) increment: Increment<T>,
    /// Whether s δ₀′ rises with the radius from node to node, as it does for positive terms.
    pub(super) is_steady: bool,
    /// An estimate of the relative error, if the rule is the finest one and s δ₀′ does not rise; otherwise 0.
    pub(super) error: T,
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> Stretch<'_, T, P, L> {
    /// The integral by a rule for a variable between `ends`; `place` makes a node of a value of the variable and its
    /// weight, and must be inlined.
    #[inline(always)]
    pub(super) fn integrate(
        &self,
        rule: &Rule,
        ends: (T, T),
        place: impl Fn(T, T) -> Node<T>,
    ) -> PanelIntegral<T> {
        half_wide(
            #[inline(always)]
            || {
                let mut nodes = Nodes::none();
                nodes.take(self, rule, ends, place);
                let is_steady = self.contact.profile().has_only_positive_terms() || nodes.are_steady();
                let is_judged = !is_steady && rule.is_finest();
                let error = if is_judged { error_of_finest(&nodes.weights.0) } else { T::zero() };
                PanelIntegral { increment: nodes.increment(self.low), is_steady, error }
            },
        )
    }
}

/// All nodes, with the integrand at each.
struct Nodes<T> {
    count: usize,
    radii: PerNode<T>,
    /// δ₀′
    slopes: PerNode<T>,
    /// δ₀′ e^(−age) ds
    weights: PerNode<T>,
}

impl<T: Scalar> Nodes<T> {
    /// Room for nodes to be filled in place: nodes returned by value would be copied.
    #[inline(always)]
    fn none() -> Self {
        let zero = PerNode::zero();
        Self { count: 0, radii: zero, slopes: zero, weights: zero }
    }

    /// Takes the nodes of a rule for a variable from `low` to `high`; `place` makes a node of a value of the variable
    /// and its weight.
    #[inline(always)]
    fn take<P, L>(
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
        let zero = PerNode::zero();
        let (mut depths, mut drops) = (zero, zero);
        let (depths, drops) = (&mut depths.0[nodes], &mut drops.0[nodes]);
        let (radii, slopes) = (&mut self.radii.0[nodes], &mut self.slopes.0[nodes]);
        let weights = &mut self.weights.0[nodes];
        let rows = radii.iter_mut().zip(&mut *depths).zip(&mut *weights);
        for (((radius, depth), weight), (x, dx)) in rows.zip(rule.nodes(low, high)) {
            let node = place(x, dx);
            (*radius, *depth, *weight) = (node.s, node.depth, node.weight);
        }
        stretch.contact.profile().fill_slopes_and_drops(stretch.high, (radii, depths), (slopes, drops));
        for (weight, &slope) in weights.iter_mut().zip(&*slopes) {
            *weight *= slope;
        }
        stretch.fade(weights, drops);
    }

    /// The integrals of an [`Increment`] by the rule.
    #[inline(always)]
    fn increment(&self, low: T) -> Increment<T> {
        // A minimum leaves no panic in the program, which a bound that only `take` knows would.
        let nodes = ..self.count.min(MOST_NODES);
        Increment::of(&self.radii.0[nodes], &self.weights.0[nodes], low)
    }

    /// Whether s δ₀′ rises with the radius from node to node, if nodes are placed by their depth.
    #[inline(always)]
    fn are_steady(&self) -> bool {
        let rounding = T::one() + T::default_epsilon() * T::constant(16.0);
        let (radii, slopes) = (self.radii.0.as_chunks().0, self.slopes.0.as_chunks().0);
        // At the outermost nodes so far, toward the edge and toward the centre.
        let (mut outer, mut inner) = (T::zero(), T::infinity());
        radii.iter().zip(slopes).take(self.count.div_ceil(2)).all(|(radii, slopes): (&[T; 2], &[T; 2])| {
            let before = (outer, inner);
            (outer, inner) = (radii[0] * slopes[0], radii[1] * slopes[1]);
            outer * rounding >= before.0 && inner <= before.1 * rounding && inner <= outer * rounding
        })
    }
}
