//! Much earlier rows, from which the present one is computed anew now and then, so that roundings do not add up.
//!
//! Blocks of equal duration change a row by equal shares, whose roundings have the same sign. After every 4 blocks the
//! last row is taken from the row before all of them, after every 4² from the row before these, and so on: over N
//! blocks 4 roundings of every length add up, instead of N. Radii that the contact had not reached at that row keep
//! their values.

use super::long_change::LongChange;
use super::sweep::Change;
use crate::Scalar;
use crate::memory::Edge;

/// How many blocks, or lengths of the next shorter kind, an anchor lasts.
const RATIO: usize = 4;

/// How many kinds of lengths there are; the longest is a quarter of a million blocks.
const LENGTHS: usize = 9;

/// The rows that began the present length of every kind, shortest first.
pub(super) struct Anchors<T>([Anchor<T>; LENGTHS]);

/// A row, and how pressures have changed since, up to the end of the last length of the next shorter kind.
#[derive(Clone, Copy)]
struct Anchor<T> {
    row: usize,
    edge: Edge<T>,
    /// How many lengths of the next shorter kind ago it was.
    age: usize,
    since: LongChange<T>,
}

impl<T: Scalar> Anchors<T> {
    /// All anchors at the same row, with its edge.
    pub(super) fn at(row: usize, edge: Edge<T>) -> Self {
        Self([Anchor::at(row, edge); LENGTHS])
    }

    /// Passes a block, by whose change its last row, with an edge, follows from the row before the block, and computes
    /// that last row of `values` anew if it is time to.
    pub(super) fn pass(
        &mut self,
        change: Change<T>,
        (row, edge): (usize, Edge<T>),
        radii: &[T],
        values: &mut [T],
    ) {
        if !change.is_slow() {
            *self = Self::at(row, edge);
            return;
        }
        let (mut since, mut longest) = (change, None);
        for anchor in &mut self.0 {
            anchor.pass(since);
            if anchor.has_faded() {
                // So have those before it.
                *self = Self::at(row, edge);
                break;
            }
            if anchor.age < RATIO {
                break;
            }
            since = anchor.since.rounded();
            longest = Some(core::mem::replace(anchor, Anchor::at(row, edge)));
        }
        if let Some(longest) = longest {
            longest.renew(row, radii, values);
        }
    }
}

impl<T: Scalar> Anchor<T> {
    fn at(row: usize, edge: Edge<T>) -> Self {
        Self { row, edge, age: 0, since: LongChange::none() }
    }

    fn pass(&mut self, change: Change<T>) {
        self.since.pass(change);
        self.age += 1;
    }

    /// Whether less than half of its pressures is left, and of their roundings.
    ///
    /// A row computed from them would be a difference of nearly equal numbers: under a load that falls for long, rounding
    /// alone.
    fn has_faded(&self) -> bool {
        self.since.rounded().fades()
    }

    /// Computes a later row from this one, at the radii that were covered here.
    fn renew(&self, row: usize, radii: &[T], values: &mut [T]) {
        let change = self.since.rounded();
        let (before, now) = values[self.row * radii.len()..].split_at_mut((row - self.row) * radii.len());
        for ((now, &before), &r) in now.iter_mut().zip(&*before).zip(radii) {
            // Chosen afterwards, for vectors.
            let renewed = change.apply(before, r * r);
            *now = if r < self.edge.radius { renewed } else { *now };
        }
    }
}
