//! Pressures at many times and radii with two scalars per time and two multiply-adds per value.
//!
//! Every radius covered at an earlier row takes its pressure from that row by one
//! [`Transition`](crate::memory::Transition), whose scalars are shared by all radii; only a radius covered
//! for the first time needs an integral of its own, once. A field of N times × M radii therefore costs
//! O(N + M) quadratures.
//!
//! **Rounding.** Taking every row from the one before it would add up N roundings. Rows are therefore taken
//! from the first row of their block of `BLOCK`; only radii covered within the block go row by row. The
//! roundings that add up are at most `BLOCK` + N/`BLOCK`.

use core::ops::Range;

use crate::Scalar;
use crate::contact::{Contact, ContactError, check_length};
use crate::load::Load;
use crate::memory::{Moment, Transition, march};
use crate::profile::GapProfile;

const BLOCK: usize = 32;

/// Checks the arguments of [`Contact::pressure_field`], apart from the times themselves.
pub(crate) fn check<T: Scalar>(times: &[T], radii: &[T], values: &[T]) -> Result<(), ContactError> {
    for (what, slice) in [("times", times), ("radii", radii)] {
        if slice.is_empty() {
            return Err(ContactError::Empty { what });
        }
    }
    check_length("values", values.len(), times.len().saturating_mul(radii.len()))?;
    if let Some(index) = radii.iter().position(|&r| !(r >= T::zero() && r.is_finite())) {
        return Err(ContactError::InvalidRadius { index, radius: radii[index].value() });
    }
    match times.windows(2).position(|pair| pair[1] < pair[0]) {
        Some(before) => Err(ContactError::Unsorted { index: before + 1, time: times[before + 1].value() }),
        None => Ok(()),
    }
}

/// Fills `values`, row-major, times × radii, after [`check`].
pub(crate) fn fill<T, P, L>(
    contact: &Contact<T, P, L>,
    times: &[T],
    radii: &[T],
    values: &mut [T],
) -> Result<(), ContactError>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let width = radii.len();
    let mut rows = None;
    for (index, &time) in times.iter().enumerate() {
        let (done, rest) = values.split_at_mut(index * width);
        let row = &mut rest[..width];
        rows = Some(match rows {
            None => {
                let moment = contact.at(time)?.pressures(radii, row);
                Rows::starting_at(index, moment)
            }
            Some(previous) => {
                let next = previous_to_next(contact, previous, index, time)?;
                next.fill(contact, radii, done, row);
                next.advanced()
            }
        });
    }
    Ok(())
}

/// The rows that a new row is taken from, and the new row.
struct Rows<T> {
    /// The first row of the block, and the change since then.
    base: (usize, Moment<T>),
    since_base: Transition<T>,
    /// The row before the new one, and the change since then.
    previous: (usize, Moment<T>),
    since_previous: Transition<T>,
    now: Moment<T>,
}

impl<T: Scalar> Rows<T> {
    fn starting_at(index: usize, moment: Moment<T>) -> Self {
        let none = Transition::none(moment.radius);
        let here = (index, moment);
        Self { base: here, since_base: none, previous: here, since_previous: none, now: moment }
    }

    /// The state before the row after the new one.
    fn advanced(mut self) -> Self {
        self.previous = (self.previous.0 + 1, self.now);
        if self.previous.0 - self.base.0 == BLOCK {
            Self::starting_at(self.previous.0, self.now)
        } else {
            self
        }
    }

    fn fill<P, L>(&self, contact: &Contact<T, P, L>, radii: &[T], done: &[T], row: &mut [T])
    where
        P: GapProfile<T>,
        L: Load<T>,
    {
        let width = radii.len();
        let base = &done[self.base.0 * width..][..width];
        let previous = &done[self.previous.0 * width..][..width];
        for run in ascending_runs(radii) {
            let offset = run.start;
            let radii = &radii[run];
            let end_of = |limit: T| radii.partition_point(|&r| r <= limit);
            let (in_base, in_previous) = (end_of(self.base.1.radius), end_of(self.previous.1.radius));
            let covered = radii.partition_point(|&r| r < self.now.radius).max(in_previous);
            let row = &mut row[offset..][..radii.len()];
            let update = |row: &mut [T], old: &[T], part: Range<usize>, change: &Transition<T>| {
                let old = &old[offset..][part.clone()];
                change.apply_to_row(old, &radii[part.clone()], &mut row[part]);
            };
            update(row, base, 0..in_base, &self.since_base);
            update(row, previous, in_base..in_previous, &self.since_previous);
            for (value, &r) in row[in_previous..covered].iter_mut().zip(&radii[in_previous..covered]) {
                *value = march(contact, self.previous.1, (self.now.time, self.now.radius), r).0.offset;
            }
            row[covered..].fill(T::zero());
        }
    }
}

fn previous_to_next<T, P, L>(
    contact: &Contact<T, P, L>,
    rows: Rows<T>,
    index: usize,
    time: T,
) -> Result<Rows<T>, ContactError>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    debug_assert_eq!(rows.previous.0 + 1, index);
    let before = rows.previous.1;
    let (since_previous, now) = march(contact, before, (time, contact.radius_at(time)?), before.radius);
    let mut since_base = rows.since_base.then(&since_previous);
    // One rounding instead of one per row.
    since_base.decay = (-(contact.medium().chi() * (time - rows.base.1.time))).exp();
    Ok(Rows { since_base, since_previous, now, ..rows })
}

/// The longest ranges in which radii ascend; one, if they all do.
fn ascending_runs<T: Scalar>(radii: &[T]) -> impl Iterator<Item = Range<usize>> {
    let mut start = 0;
    core::iter::from_fn(move || {
        let rest = radii.get(start..).filter(|rest| !rest.is_empty())?;
        let length = rest.windows(2).position(|pair| pair[1] < pair[0]).map_or(rest.len(), |last| last + 1);
        start += length;
        Some(start - length..start)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_cover_everything_in_order() {
        let radii = [0.0, 1.0, 1.0, 0.5, 2.0, 1.0];
        assert!(ascending_runs(&radii).eq([0..3, 3..5, 5..6]));
    }
}
