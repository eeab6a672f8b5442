//! Radii in any order, as ranges in which they ascend.

use core::ops::Range;

use crate::Scalar;

/// The longest ranges in which radii ascend.
pub(super) struct Runs<'a, T> {
    radii: &'a [T],
    /// Where the first of them ends; for radii that all ascend it is the only one and need not be searched
    /// again.
    first: usize,
}

impl<'a, T: Scalar> Runs<'a, T> {
    pub(super) fn of(radii: &'a [T]) -> Self {
        Self { radii, first: ascending(radii) }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = Range<usize>> {
        let mut next = 0..self.first;
        core::iter::from_fn(move || {
            let run = next.clone();
            next = run.end..run.end + ascending(&self.radii[run.end..]);
            (!run.is_empty()).then_some(run)
        })
    }
}

/// How many radii ascend from the first one on.
fn ascending<T: Scalar>(radii: &[T]) -> usize {
    let pairs = || radii.iter().zip(radii.iter().skip(1));
    // All at once first, which is a loop without branches.
    if pairs().fold(true, |all, (r, next)| all & (r <= next)) {
        return radii.len();
    }
    pairs().position(|(r, next)| next < r).map_or(radii.len(), |last| last + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_cover_everything_in_order() {
        let radii = [0.0, 1.0, 1.0, 0.5, 2.0, 1.0];
        assert!(Runs::of(&radii).iter().eq([0..3, 3..5, 5..6]));
    }
}
