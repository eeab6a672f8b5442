//! Some rows that are taken from the same row before them.

use core::ops::Range;

use super::panel::Panel;
use super::sweep::{Change, Changes, take_rows_from};
use super::{BLOCK, is_long};
use crate::Scalar;
use crate::contact::{Contact, ContactError};
use crate::load::Load;
use crate::memory::march;
use crate::profile::GapProfile;

/// The edge of the contact at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge<T> {
    pub(super) time: T,
    pub(super) radius: T,
}

/// Rows one after the other, and how they follow from the row before the first of them, their base.
pub(super) struct Block<'a, T, P, L> {
    base: Edge<T>,
    count: usize,
    /// How many rows the next panel may have.
    most: usize,
    times: [T; BLOCK],
    radii: [T; BLOCK],
    since_base: Changes<T>,
    since_previous: Changes<T>,
    /// The panel that the changes come from; without one they come from marches.
    panel: Option<Panel<'a, T, P, L>>,
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Block<'a, T, P, L> {
    /// No rows after `base`.
    pub(super) fn after(base: Edge<T>) -> Self {
        Self {
            base,
            count: 0,
            most: BLOCK,
            times: [base.time; BLOCK],
            radii: [base.radius; BLOCK],
            since_base: Changes::none(),
            since_previous: Changes::none(),
            panel: None,
        }
    }

    /// How many rows there are.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// The edge at the last row.
    pub(super) fn last(&self) -> Edge<T> {
        self.edge_before(self.count)
    }

    /// Goes on to the next rows, at the first of `times`.
    pub(super) fn advance(&mut self, contact: &'a Contact<T, P, L>, times: &[T]) -> Result<(), ContactError> {
        self.base = self.last();
        self.count = 0;
        self.panel = None;
        match Panel::over(contact, self.base, &times[..times.len().min(self.most)]) {
            Some((panel, count)) => self.follow(contact, panel, &times[..count])?,
            None => self.march(contact, &times[..times.len().min(BLOCK)])?,
        }
        // A little longer than what was short enough, and seldom too long.
        self.most = BLOCK.min(self.count + self.count / 8 + 1);
        Ok(())
    }

    /// Takes the rows at `times` from a panel.
    fn follow(
        &mut self,
        contact: &Contact<T, P, L>,
        panel: Panel<'a, T, P, L>,
        times: &[T],
    ) -> Result<(), ContactError> {
        self.count = times.len();
        self.times[..times.len()].copy_from_slice(times);
        contact.advancing_radii(times, &mut self.radii[..times.len()])?;
        panel.changes(times, &mut self.since_previous, &mut self.since_base);
        self.panel = Some(panel);
        Ok(())
    }

    /// Takes rows by one march each: one row under a load that the next may have a panel for, otherwise until
    /// half the memory has faded.
    fn march(&mut self, contact: &Contact<T, P, L>, times: &[T]) -> Result<(), ContactError> {
        let chi = contact.medium().chi();
        let most = if contact.load().is_linear_between_knots() { 1 } else { times.len() };
        for &time in &times[..most] {
            let before = self.last();
            if self.count > 0 && is_long(contact, before.time, time) {
                break;
            }
            let radius = contact.advancing_radius_at(time)?;
            let start = contact.stage(before.time, before.radius);
            let transition = march(contact, start, (time, radius), before.radius);
            let change = Change::of(transition, chi * (time - before.time));
            let since_base = match self.count.checked_sub(1) {
                Some(previous) => self.since_base.get(previous).then(change),
                None => change,
            };
            self.times[self.count] = time;
            self.radii[self.count] = radius;
            self.since_previous.set(self.count, change);
            self.since_base.set(self.count, since_base);
            self.count += 1;
            if since_base.fades() {
                break;
            }
        }
        Ok(())
    }

    /// The edge at the row before the one with an index.
    fn edge_before(&self, index: usize) -> Edge<T> {
        match index.checked_sub(1) {
            Some(previous) => Edge { time: self.times[previous], radius: self.radii[previous] },
            None => self.base,
        }
    }

    /// Fills the rows of `values`, whose first row is the base, in ranges of ascending `radii`.
    pub(super) fn fill(
        &self,
        contact: &Contact<T, P, L>,
        radii: &[T],
        runs: impl Iterator<Item = Range<usize>>,
        values: &mut [T],
    ) {
        let width = radii.len();
        for run in runs {
            let in_base = run.start + radii[run.clone()].partition_point(|&r| r < self.base.radius);
            let (base, rows) = values.split_at_mut(width);
            take_rows_from(
                base,
                radii,
                run.start..in_base,
                &self.since_base,
                &mut rows[..self.count * width],
            );
            let mut covered = in_base;
            for index in 0..self.count {
                let (before, row) = values[index * width..][..2 * width].split_at_mut(width);
                let (before, row) = (&before[in_base..covered], &mut row[in_base..run.end]);
                self.since_previous.get(index).apply_to_row(before, &radii[in_base..covered], row);
                let radius = self.radii[index];
                while covered < run.end && radii[covered] < radius {
                    row[covered - in_base] = self.first_pressure(contact, index, radii[covered]);
                    covered += 1;
                }
                row[covered - in_base..].fill(T::zero());
            }
        }
    }

    /// The pressure at a radius that was not yet covered at the row before.
    fn first_pressure(&self, contact: &Contact<T, P, L>, index: usize, r: T) -> T {
        let (before, now) = (self.edge_before(index), self.edge_before(index + 1));
        match &self.panel {
            Some(panel) => panel.first_pressure(before, now, r),
            None => {
                let start = contact.stage(before.time, before.radius);
                march(contact, start, (now.time, now.radius), r).offset
            }
        }
    }
}
