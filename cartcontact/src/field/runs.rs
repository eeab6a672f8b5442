//! Radii in any order, as runs that ascend or descend.

use core::ops::Range;

use crate::Scalar;
use crate::dispatch::wide;

/// The longest runs of radii, one after the other. They are found anew in every pass, as there is no place to keep
/// them.
pub(super) struct Runs<'a, T> {
    pub(super) radii: &'a [T],
    /// If the radii are in order it is the only run, and they need not be searched again.
    first: Run,
}

/// Columns whose radii ascend or descend.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    columns: Range<usize>,
    descends: bool,
}

impl<'a, T: Scalar> Runs<'a, T> {
    pub(super) fn of(radii: &'a [T]) -> Self {
        Self { radii, first: Run::starting(radii, 0) }
    }

    /// Whether there is only one run.
    pub(super) fn are_in_order(&self) -> bool {
        self.first.len() == self.radii.len()
    }

    /// Columns that have all whose radii are not inside an edge but inside one as wide or wider, and how many these are.
    pub(super) fn between(&self, edge: T, wider: T) -> (Range<usize>, usize) {
        if self.are_in_order() {
            let [inside, within] = [edge, wider].map(|edge| self.first.count_inside(self.radii, edge));
            let columns = self.first.split(within).0.split(inside).1.columns();
            return (columns.clone(), columns.len());
        }
        let count = wide(
            #[inline(always)]
            || self.radii.iter().fold(0, |count, &r| count + usize::from((edge <= r) & (r < wider))),
        );
        (0..self.radii.len(), count)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = Run> {
        let mut next = self.first.clone();
        core::iter::from_fn(move || {
            let end = next.columns.end;
            let run = core::mem::replace(&mut next, Run::starting(self.radii, end));
            (run.len() > 0).then_some(run)
        })
    }

    /// The narrowest range that has all columns inside an edge.
    pub(super) fn span_inside(&self, edge: T) -> Range<usize> {
        if self.are_in_order() {
            return self.first.split(self.first.count_inside(self.radii, edge)).0.columns;
        }
        let is_inside = |&r: &T| r < edge;
        let first = self.radii.iter().position(is_inside);
        let last = self.radii.iter().rposition(is_inside);
        first.zip(last).map_or(0..0, |(first, last)| first..last + 1)
    }
}

impl Run {
    /// The longest run from a column on.
    fn starting<T: Scalar>(radii: &[T], column: usize) -> Self {
        let rest = &radii[column..];
        let length = |breaks: fn(&T, &T) -> bool| {
            let mut pairs = rest.iter().zip(rest.iter().skip(1));
            pairs.position(|(r, next)| breaks(r, next)).map_or(rest.len(), |last| last + 1)
        };
        let (ascending, descending) = (length(|r, next| next < r), length(|r, next| next > r));
        Self { columns: column..column + ascending.max(descending), descends: ascending < descending }
    }

    pub(super) fn len(&self) -> usize {
        self.columns.len()
    }

    /// The range of the columns.
    pub(super) fn columns(&self) -> Range<usize> {
        self.columns.clone()
    }

    /// The column with `count` others nearer to the axis.
    pub(super) fn column(&self, count: usize) -> usize {
        if self.descends { self.columns.end - 1 - count } else { self.columns.start + count }
    }

    /// The `count` columns nearest to the axis, and the others.
    pub(super) fn split(&self, count: usize) -> (Self, Self) {
        let Self { columns: Range { start, end }, descends } = *self;
        let part = |columns| Self { columns, descends };
        if descends {
            (part(end - count..end), part(start..end - count))
        } else {
            (part(start..start + count), part(start + count..end))
        }
    }

    /// How many columns are inside an edge.
    pub(super) fn count_inside<T: Scalar>(&self, radii: &[T], edge: T) -> usize {
        let radii = &radii[self.columns()];
        if self.descends {
            radii.len() - radii.partition_point(|&r| r >= edge)
        } else {
            radii.partition_point(|&r| r < edge)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The runs as ranges, and whether they descend.
    fn runs(radii: &[f64]) -> Vec<(Range<usize>, bool)> {
        Runs::of(radii).iter().map(|run| (run.columns, run.descends)).collect()
    }

    #[test]
    fn runs_cover_everything_in_order() {
        assert_eq!(
            runs(&[0.0, 1.0, 1.0, 0.5, 0.2, 2.0, 2.0, 1.0, 3.0]),
            [(0..3, false), (3..5, true), (5..8, true), (8..9, false)],
        );
    }

    #[test]
    fn radii_in_order_are_one_run() {
        assert_eq!(runs(&[1.0, 1.0, 2.0]), [(0..3, false)]);
        assert_eq!(runs(&[2.0, 2.0, 1.0, 1.0, 0.0]), [(0..5, true)]);
        assert_eq!(runs(&[1.0, 1.0]), [(0..2, false)]);
        assert_eq!(runs(&[1.0]), [(0..1, false)]);
    }

    #[test]
    fn a_diameter_is_two_runs() {
        assert_eq!(runs(&[2.0, 1.0, 0.0, 1.0, 2.0]), [(0..3, true), (3..5, false)]);
    }

    #[test]
    fn columns_count_from_the_axis() {
        let radii = [0.0, 1.0, 2.0, 2.0, 3.0];
        let run = Run { columns: 0..5, descends: false };
        assert_eq!((run.count_inside(&radii, 2.0), run.column(1)), (2, 1));
        let (near, far) = run.split(2);
        assert_eq!((near.columns(), far.columns()), (0..2, 2..5));

        let radii = [3.0, 2.0, 2.0, 1.0, 0.0];
        let run = Run { columns: 0..5, descends: true };
        assert_eq!((run.count_inside(&radii, 2.0), run.column(1)), (2, 3));
        let (near, far) = run.split(2);
        assert_eq!((near.columns(), far.columns()), (3..5, 0..3));
    }

    #[test]
    fn a_span_has_all_columns_inside() {
        let radii = [5.0, 1.0, 6.0, 0.0, 3.0, 7.0];
        let span = |edge| Runs::of(&radii).span_inside(edge);
        assert_eq!([span(4.0), span(0.5), span(8.0), span(0.0)], [1..5, 3..4, 0..6, 0..0]);
    }
}
