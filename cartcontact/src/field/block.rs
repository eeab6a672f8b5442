//! Rows that are taken from the same earlier row.

use super::long_change::LongChange;
use super::panel::Panel;
use super::runs::{Run, Runs};
use super::sweep::{Change, Changes, TILE, set_beyond_to_zero, take_rows_from};
use super::{BLOCK, may_be_apart};
use crate::Scalar;
use crate::contact::{Contact, ContactError};
use crate::dispatch::out_of_line;
use crate::load::Load;
use crate::memory::{Edge, Late, Stage, march};
use crate::profile::GapProfile;
use crate::scalar::{greater, has_no_derivatives};

/// After how many rows one is taken from the row before all of them, at radii that were not covered at the base of their
/// block.
const ROWS_PER_ANCHOR: usize = 8;

/// How such rows follow from those [`ROWS_PER_ANCHOR`] before them.
type BetweenAnchors<T> = [Change<T>; BLOCK / ROWS_PER_ANCHOR];

/// Consecutive rows, and how they follow from their base, the row before the first of them.
pub(super) struct Block<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    base: Edge<T>,
    count: usize,
    /// How long the next panel may be: to find that one is too long costs as much as to use it.
    longest: T,
    times: [T; BLOCK],
    radii: [T; BLOCK],
    since_base: Changes<T>,
    since_previous: Changes<T>,
    /// The panel that the changes come from; without one they come from marches.
    panel: Option<Panel<'a, T, P, L>>,
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Block<'a, T, P, L> {
    /// No rows after `base`.
    pub(super) fn after(contact: &'a Contact<T, P, L>, base: Edge<T>) -> Self {
        Self {
            contact,
            base,
            count: 0,
            longest: T::infinity(),
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

    /// How the last row follows from the base; none if there are no rows.
    pub(super) fn change(&self) -> Option<Change<T>> {
        self.count.checked_sub(1).map(|last| self.since_base.get(last))
    }

    /// Goes on to the next rows, at the first of `times`.
    pub(super) fn advance(&mut self, times: &[T]) -> Result<(), ContactError> {
        self.base = self.last();
        self.count = 0;
        self.panel = None;
        let times = &times[..times.len().min(BLOCK)];
        let rows = self.rows_for_panel(times);
        match Panel::over(self.contact, self.base, &times[..rows]) {
            Some((panel, count)) => self.follow(panel, &times[..count])?,
            None => self.march(times)?,
        }
        let duration = self.last().time - self.base.time;
        if self.count < rows && duration > T::zero() {
            self.longest = duration;
        }
        // A little longer than what was short enough, and seldom too long.
        self.longest *= T::constant(1.125);
        Ok(())
    }

    /// How many rows a panel may have, if the load is straight up to its next knot: those before the knot that are not
    /// too late for the longest panel.
    fn rows_for_panel(&self, times: &[T]) -> usize {
        let (load, start) = (self.contact.load(), self.base.time);
        if !load.is_linear_between_knots() {
            return 0;
        }
        let knot = load.next_knot(start);
        times.partition_point(|&time| knot.is_none_or(|knot| time < knot) && time - start <= self.longest)
    }

    /// Takes the rows at `times` from a panel.
    fn follow(&mut self, panel: Panel<'a, T, P, L>, times: &[T]) -> Result<(), ContactError> {
        self.count = times.len();
        self.times[..times.len()].copy_from_slice(times);
        self.contact.advancing_radii(times, &mut self.radii[..times.len()])?;
        panel.changes(times, &mut self.since_previous, &mut self.since_base);
        self.panel = Some(panel);
        Ok(())
    }

    /// Takes rows by one march each: a single row if the load may allow a panel for the next, otherwise rows until half
    /// the memory has faded.
    fn march(&mut self, times: &[T]) -> Result<(), ContactError> {
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let most = if contact.load().is_linear_between_knots() { 1 } else { times.len() };
        let mut since_base = LongChange::none();
        for &time in &times[..most] {
            let before = self.last();
            if self.count > 0 && may_be_apart(contact, before.time, time) {
                break;
            }
            let radius = contact.advancing_radius_at(time)?;
            let start = self.stage(before);
            let transition = march(contact, start, Edge { time, radius }, before.radius);
            let change = Change::of(transition, chi * (time - before.time));
            let is_slow = change.is_slow();
            let until_now = if is_slow {
                since_base.pass(change);
                since_base.rounded()
            } else {
                since_base.rounded().then(change)
            };
            self.times[self.count] = time;
            self.radii[self.count] = radius;
            self.since_previous.set(self.count, change);
            self.since_base.set(self.count, until_now);
            self.count += 1;
            // Only slow changes can be added up.
            if until_now.fades() || !is_slow {
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

    /// Fills the rows of `values`, whose first row is the base.
    pub(super) fn fill(&self, runs: &Runs<'_, T>, squares: &mut [T; TILE], values: &mut [T]) {
        let width = runs.radii.len();
        let (base, rows) = values.split_at_mut(width);
        // All columns at once, because short runs leave no room for vectors; values beyond the edge of the base mean
        // nothing and are replaced next.
        let span = runs.span_inside(self.base.radius);
        let rows = &mut rows[..self.count * width];
        take_rows_from(base, runs.radii, span.clone(), &self.since_base, squares, rows);
        // Not simply the last radius, which rounding may make smaller.
        let widest = self.radii[..self.count].iter().copied().fold(self.base.radius, greater);
        if !runs.are_in_order() {
            set_beyond_to_zero(runs.radii, self.base.radius, span, rows);
        }
        let (columns, count) = runs.between(self.base.radius, widest);
        if count == 0 {
            return;
        }
        if self.count == 1 {
            self.fill_beyond_in_only_row((&runs.radii[columns.clone()], count), &mut rows[columns]);
            return;
        }
        let changes_between_anchors = self.changes_between_anchors();
        for run in runs.iter() {
            let beyond = run.split(run.count_inside(runs.radii, self.base.radius)).1;
            if beyond.len() > 0 && runs.radii[beyond.column(0)] < widest {
                self.fill_beyond((runs.radii, &beyond), changes_between_anchors.as_ref(), values);
            }
        }
    }

    /// Fills columns of the only row, of which so many lie beyond the base. None of these goes from row to row, so that
    /// no order is needed: runs of a few columns take longer to find than to fill. Where there is no panel, many knots
    /// may lie between the two rows.
    fn fill_beyond_in_only_row(&self, (radii, count): (&[T], usize), row: &mut [T]) {
        let (base, now) = (self.base, self.last());
        let late = row.iter_mut().zip(radii).filter(|&(_, &r)| (base.radius <= r) & (r < now.radius));
        if let Some(panel) = &self.panel {
            late.for_each(|(value, &r)| *value = panel.first_pressure(base, now, r));
        } else {
            // Sections take several KiB of the stack.
            out_of_line(move || {
                let start = self.stage(base);
                let mut sections = Late::between(self.contact, start, now, count);
                late.for_each(|(value, &r)| *value = sections.pressure(r));
            });
        }
    }

    /// How rows follow from those [`ROWS_PER_ANCHOR`] before them, for each full number of these; none if rows round each
    /// in its own way.
    ///
    /// The share by which pressures change from row to row itself changes by its square. Where that is more than ε, what
    /// is rounded differs from row to row.
    fn changes_between_anchors(&self) -> Option<BetweenAnchors<T>> {
        let share = self.change()?.gain / T::constant(self.count as f64);
        let anchored = |anchor| {
            let rows = anchor * ROWS_PER_ANCHOR..self.count.min((anchor + 1) * ROWS_PER_ANCHOR);
            rows.fold(Change::none(), |change, row| change.then(self.since_previous.get(row)))
        };
        (share * share <= T::default_epsilon()).then(|| core::array::from_fn(anchored))
    }

    /// Fills the columns of a run that lies beyond the base, which are zero so far.
    ///
    /// Columns go from row to row, and now and then from the last anchor: rows of equal times change by equal shares,
    /// whose roundings have the same sign.
    fn fill_beyond(
        &self,
        (radii, run): (&[T], &Run),
        changes_between_anchors: Option<&BetweenAnchors<T>>,
        values: &mut [T],
    ) {
        let width = radii.len();
        let (mut covered, mut covered_at_anchor) = (0, 0);
        for index in 0..self.count {
            let (before, row) = values.split_at_mut((index + 1) * width);
            let mut take = |from: usize, change: Change<T>, count: usize| {
                let columns = run.split(count).0.columns();
                let before = &before[from * width..][columns.clone()];
                change.apply_to_row(before, &radii[columns.clone()], &mut row[columns]);
            };
            take(index, self.since_previous.get(index), covered);
            if let Some(changes) = changes_between_anchors
                && (index + 1).is_multiple_of(ROWS_PER_ANCHOR)
            {
                take(index + 1 - ROWS_PER_ANCHOR, changes[index / ROWS_PER_ANCHOR], covered_at_anchor);
                covered_at_anchor = covered;
            }
            let radius = self.radii[index];
            while covered < run.len() && radii[run.column(covered)] < radius {
                let column = run.column(covered);
                row[column] = self.first_pressure(index, radii[column]);
                covered += 1;
            }
        }
    }

    /// The pressure at a radius that was not yet covered at the row before.
    fn first_pressure(&self, index: usize, r: T) -> T {
        let (before, now) = (self.edge_before(index), self.edge_before(index + 1));
        match &self.panel {
            Some(panel) => panel.first_pressure(before, now, r),
            None => march(self.contact, self.stage(before), now, r).apply(T::zero(), r),
        }
    }

    /// The stage at a row that others follow from. Where no load has been applied yet the beginning serves as well, and
    /// it has no derivatives: with those of the row's time the first forces would have some, and radii infinite ones.
    fn stage(&self, row: Edge<T>) -> Stage<T> {
        let is_unloaded = !has_no_derivatives::<T>() && row.radius.is_zero();
        self.contact.stage(if is_unloaded { Edge { time: T::zero(), radius: T::zero() } } else { row })
    }
}
