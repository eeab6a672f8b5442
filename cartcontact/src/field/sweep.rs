//! From one row of pressures to others.
//!
//! What bounds the speed is memory. Rows are taken two at a time, so that the pressures and radii they come
//! from are read once for both, and in tiles of columns that stay in the first cache while all rows of a block
//! pass over them; only the results travel.

use core::ops::Range;

use crate::Scalar;
use crate::dispatch::wide;
use crate::memory::Transition;

/// Columns of a tile. Its pressures and squares take 16 KiB in f64, half of the smallest first cache.
const TILE: usize = 1024;

/// How pressures change at all radii that were covered before:
/// P ← kept · P + (gain · P + (on_axis − slope r²)).
///
/// The factor of P, the decay, is `kept` + `gain`. For a decay near 1, `kept` is 1 and `gain` is small and
/// negative, so that its rounding, the same in every block of equal times, does not add up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change<T> {
    kept: T,
    gain: T,
    on_axis: T,
    slope: T,
}

impl<T: Scalar> Change<T> {
    /// The change with a decay of 1 + `gain`, for `gain` near 0.
    #[inline(always)]
    pub(super) fn slow(gain: T, on_axis: T, slope: T) -> Self {
        Self { kept: T::one(), gain, on_axis, slope }
    }

    /// No change.
    pub(super) fn none() -> Self {
        Self::slow(T::zero(), T::zero(), T::zero())
    }

    /// A transition over `folds` e-foldings of the memory.
    ///
    /// Taking its parabola from the axis instead of from `reach` costs up to ε reach/(a − r) near the edge.
    pub(super) fn of(transition: Transition<T>, folds: T) -> Self {
        let Transition { decay, offset, slope, reach } = transition;
        let on_axis = offset + slope * reach * reach;
        if decay > T::constant(0.5) {
            Self::slow((-folds).exp_m1(), on_axis, slope)
        } else {
            Self { kept: T::zero(), gain: decay, on_axis, slope }
        }
    }

    /// This change followed by another.
    #[inline(always)]
    pub(super) fn then(self, next: Self) -> Self {
        let after = |x: T| next.kept * x + next.gain * x;
        Self {
            kept: self.kept * next.kept,
            gain: self.kept * next.gain + after(self.gain),
            on_axis: after(self.on_axis) + next.on_axis,
            slope: after(self.slope) + next.slope,
        }
    }

    /// Whether less than half of the pressure before is left.
    pub(super) fn fades(self) -> bool {
        self.kept + self.gain < T::constant(0.5)
    }

    /// The pressure after the change.
    #[inline(always)]
    fn apply(self, pressure: T, square: T) -> T {
        self.kept * pressure + (self.gain * pressure + (self.on_axis - self.slope * square))
    }

    /// The pressures after the change at `radii`.
    pub(super) fn apply_to_row(self, pressures: &[T], radii: &[T], results: &mut [T]) {
        for ((result, &pressure), &r) in results.iter_mut().zip(pressures).zip(radii) {
            *result = self.apply(pressure, r * r);
        }
    }
}

/// Takes some columns of all `rows`, each as wide as `base`, from the row `base`.
pub(super) fn take_rows_from<T: Scalar>(
    base: &[T],
    radii: &[T],
    columns: Range<usize>,
    changes: &[Change<T>],
    rows: &mut [T],
) {
    wide(
        #[inline(always)]
        || {
            let mut squares = [T::zero(); TILE];
            for start in columns.clone().step_by(TILE) {
                let tile = start..columns.end.min(start + TILE);
                let squares = &mut squares[..tile.len()];
                for (square, &r) in squares.iter_mut().zip(&radii[tile.clone()]) {
                    *square = r * r;
                }
                for (pair, changes) in rows.chunks_mut(2 * base.len()).zip(changes.chunks(2)) {
                    let (first, second) = pair.split_at_mut(base.len());
                    let (pressures, first) = (&base[tile.clone()], &mut first[tile.clone()]);
                    match *changes {
                        [one, two] => {
                            take_two(pressures, squares, (one, first), (two, &mut second[tile.clone()]));
                        }
                        [one] => take_one(pressures, squares, one, first),
                        _ => {}
                    }
                }
            }
        },
    );
}

#[inline(always)]
fn take_two<T: Scalar>(
    pressures: &[T],
    squares: &[T],
    (one, first): (Change<T>, &mut [T]),
    (two, second): (Change<T>, &mut [T]),
) {
    for (((&pressure, &square), first), second) in pressures.iter().zip(squares).zip(first).zip(second) {
        *first = one.apply(pressure, square);
        *second = two.apply(pressure, square);
    }
}

#[inline(always)]
fn take_one<T: Scalar>(pressures: &[T], squares: &[T], change: Change<T>, results: &mut [T]) {
    for ((&pressure, &square), result) in pressures.iter().zip(squares).zip(results) {
        *result = change.apply(pressure, square);
    }
}
