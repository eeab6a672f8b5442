//! From one row of pressures to others.
//!
//! Memory bounds the speed. Rows are taken two at a time, so that the pressures and radii they come from are read once
//! for both, and in tiles of columns that stay in the first cache while all rows of a block pass over them; only the
//! results travel to memory. Columns beyond the edge are set to zero while their neighbours are in the cache, which is
//! a twentieth quicker than another pass over them. Vectors of results begin at cache lines: long slices mostly begin in
//! the middle of one, and with vectors that straddle two lines a field takes half as long again.

use core::ops::Range;

use super::BLOCK;
use crate::Scalar;
use crate::dispatch::wide;
use crate::memory::{Transition, not_negative};

/// Columns of a tile. Its pressures and squares take 16 KiB in f64, half of the smallest first cache. Programs without
/// `std` may run where there is no cache and little stack: there they take 1 KiB in f32.
pub(super) const TILE: usize = if cfg!(feature = "std") { 1024 } else { 128 };

/// In bytes, as long as the widest vectors.
const CACHE_LINE: usize = 64;

/// How pressures change at all radii that were covered before:
/// P ← kept · P + (gain · P + (on_axis − slope r²)).
///
/// The factor of P, the decay, is `kept` + `gain`. For a decay near 1, `kept` is 1 and `gain` is small and
/// negative, so that its rounding, the same in every block of equal times, does not add up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change<T> {
    pub(super) kept: T,
    pub(super) gain: T,
    pub(super) on_axis: T,
    pub(super) slope: T,
}

impl<T: Scalar> Change<T> {
    /// No change.
    pub(super) fn none() -> Self {
        Self { kept: T::one(), gain: T::zero(), on_axis: T::zero(), slope: T::zero() }
    }

    /// A transition over `folds` e-foldings of the memory.
    ///
    /// Taking its parabola from the axis instead of from `reach` costs up to ε reach/(a − r) near the edge.
    pub(super) fn of(transition: Transition<T>, folds: T) -> Self {
        let Transition { decay, offset, slope, reach } = transition;
        let (decay, offset, slope) = (decay.value, offset.value, slope.value);
        let on_axis = offset + slope * reach * reach;
        if decay > T::constant(0.5) {
            Self { kept: T::one(), gain: (-folds).exp_m1(), on_axis, slope }
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

    /// Whether less than half of the pressure before it is left.
    pub(super) fn fades(self) -> bool {
        self.kept + self.gain < T::constant(0.5)
    }

    /// The pressure after the change.
    #[inline(always)]
    pub(super) fn apply(self, pressure: T, square: T) -> T {
        not_negative(self.kept * pressure + (self.gain * pressure + (self.on_axis - self.slope * square)))
    }

    /// Whether the decay is near 1, as it is in all but the last change of a block.
    #[inline(always)]
    pub(super) fn is_slow(self) -> bool {
        self.kept == T::one()
    }

    /// The pressure after a slow change, the same to the last bit as [`apply`](Self::apply) gives.
    #[inline(always)]
    fn apply_slow(self, pressure: T, square: T) -> T {
        not_negative(pressure + (self.gain * pressure + (self.on_axis - self.slope * square)))
    }

    /// The pressures after the change at `radii`.
    pub(super) fn apply_to_row(self, pressures: &[T], radii: &[T], results: &mut [T]) {
        for ((result, &pressure), &r) in results.iter_mut().zip(pressures).zip(radii) {
            *result = self.apply(pressure, r * r);
        }
    }
}

/// The changes of the rows of a block, component by component, so that vectors can take many rows at once.
pub(super) struct Changes<T> {
    kept: [T; BLOCK],
    pub(super) gain: [T; BLOCK],
    pub(super) on_axis: [T; BLOCK],
    pub(super) slope: [T; BLOCK],
}

impl<T: Scalar> Changes<T> {
    /// No changes.
    pub(super) fn none() -> Self {
        let zeros = [T::zero(); BLOCK];
        Self { kept: [T::one(); BLOCK], gain: zeros, on_axis: zeros, slope: zeros }
    }

    /// Marks all decays as near 1, so that their gains are small.
    pub(super) fn slow_down(&mut self) {
        self.kept.fill(T::one());
    }

    /// Sets the parabolas of `count` rows to the sums of those of `steps`.
    pub(super) fn add_up(&mut self, steps: &Self, count: usize) {
        let (mut on_axis, mut slope) = (T::zero(), T::zero());
        for row in 0..count {
            on_axis += steps.on_axis[row];
            slope += steps.slope[row];
            (self.on_axis[row], self.slope[row]) = (on_axis, slope);
        }
    }

    pub(super) fn set(&mut self, row: usize, change: Change<T>) {
        self.kept[row] = change.kept;
        self.gain[row] = change.gain;
        self.on_axis[row] = change.on_axis;
        self.slope[row] = change.slope;
    }

    #[inline(always)]
    pub(super) fn get(&self, row: usize) -> Change<T> {
        let (kept, gain) = (self.kept[row], self.gain[row]);
        Change { kept, gain, on_axis: self.on_axis[row], slope: self.slope[row] }
    }
}

/// Takes some columns of all `rows`, each as wide as `base`, from the row `base`, and sets all others to zero.
///
/// `squares` is room for those of the radii, shared by all blocks: initialising it takes as long as some rows.
pub(super) fn take_rows_from<T: Scalar>(
    base: &[T],
    radii: &[T],
    columns: Range<usize>,
    changes: &Changes<T>,
    squares: &mut [T; TILE],
    rows: &mut [T],
) {
    if columns.is_empty() {
        rows.fill(T::zero());
        return;
    }
    wide(
        #[inline(always)]
        || {
            for start in columns.clone().step_by(TILE) {
                let tile = start..columns.end.min(start + TILE);
                let squares = &mut squares[..tile.len()];
                for (square, &r) in squares.iter_mut().zip(&radii[tile.clone()]) {
                    *square = r * r;
                }
                let bases = (&base[tile.clone()], &*squares);
                for (index, pair) in rows.chunks_mut(2 * base.len()).enumerate() {
                    let changes = [changes.get(2 * index), changes.get(2 * index + 1)];
                    take_pair(bases, changes, &tile, base.len(), pair);
                    pair.chunks_mut(base.len()).for_each(|row| zero_beside(row, &tile, &columns));
                }
            }
        },
    );
}

/// Columns of a part that is passed over if all of them are inside an edge.
const PART: usize = 64;

/// Sets those of some columns to zero, in all `rows`, whose radii are not inside an edge.
pub(super) fn set_beyond_to_zero<T: Scalar>(radii: &[T], edge: T, columns: Range<usize>, rows: &mut [T]) {
    wide(
        #[inline(always)]
        || {
            for start in columns.clone().step_by(PART) {
                let part = start..columns.end.min(start + PART);
                let in_part = &radii[part.clone()];
                if in_part.iter().fold(true, |all, &r| all & (r < edge)) {
                    continue;
                }
                for row in rows.chunks_mut(radii.len()) {
                    for (value, &r) in row[part.clone()].iter_mut().zip(in_part) {
                        *value = if r < edge { *value } else { T::zero() };
                    }
                }
            }
        },
    );
}

/// Takes some columns of one or two rows of a `width` from their pressures in the base and their squares.
#[inline(always)]
fn take_pair<T: Scalar>(
    bases: (&[T], &[T]),
    [one, two]: [Change<T>; 2],
    columns: &Range<usize>,
    width: usize,
    pair: &mut [T],
) {
    let (first, second) = pair.split_at_mut(width);
    let first = &mut first[columns.clone()];
    if second.is_empty() {
        take_row(bases, first, |p, square| one.apply(p, square));
        return;
    }
    let second = &mut second[columns.clone()];
    if one.is_slow() && two.is_slow() {
        take_two_slow(bases, (one, first), (two, second));
    } else {
        take_row(bases, first, |p, square| one.apply(p, square));
        take_row(bases, second, |p, square| two.apply(p, square));
    }
}

/// Sets what lies beside all `columns` to zero, on the sides on which a tile ends them.
#[inline(always)]
fn zero_beside<T: Scalar>(row: &mut [T], tile: &Range<usize>, columns: &Range<usize>) {
    if tile.start == columns.start {
        row[..columns.start].fill(T::zero());
    }
    if tile.end == columns.end {
        row[columns.end..].fill(T::zero());
    }
}

#[inline(always)]
fn take_two_slow<T: Scalar>(
    bases: (&[T], &[T]),
    (one, first): (Change<T>, &mut [T]),
    (two, second): (Change<T>, &mut [T]),
) {
    let (of_one, of_two) = (|p, square| one.apply_slow(p, square), |p, square| two.apply_slow(p, square));
    if before_line(first) != before_line(second) {
        take_row(bases, first, of_one);
        take_row(bases, second, of_two);
        return;
    }
    let (pressures, squares) = bases;
    for part in from_line(first) {
        let bases = pressures[part.clone()].iter().zip(&squares[part.clone()]);
        let results = first[part.clone()].iter_mut().zip(&mut second[part]);
        for ((&pressure, &square), (first, second)) in bases.zip(results) {
            (*first, *second) = (of_one(pressure, square), of_two(pressure, square));
        }
    }
}

/// The pressures after a change, given as a function of pressure and square of the radius.
#[inline(always)]
fn take_row<T: Scalar>((pressures, squares): (&[T], &[T]), results: &mut [T], change: impl Fn(T, T) -> T) {
    for part in from_line(results) {
        let bases = pressures[part.clone()].iter().zip(&squares[part.clone()]);
        for ((&pressure, &square), result) in bases.zip(&mut results[part]) {
            *result = change(pressure, square);
        }
    }
}

/// How many values lie before the first that begins a cache line.
#[inline(always)]
fn before_line<T>(values: &[T]) -> usize {
    values.as_ptr().align_offset(CACHE_LINE).min(values.len())
}

/// The values before the first that begins a cache line, and all others.
#[inline(always)]
fn from_line<T>(values: &[T]) -> [Range<usize>; 2] {
    let line = before_line(values);
    [0..line, line..values.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows taken with wide vectors agree to the last bit with the same arithmetic value by value.
    fn check<T: Scalar>() {
        let width = TILE + 37;
        let grid =
            |scale: f64| (0..width).map(|k| T::constant((k as f64 * scale).sin() + 1.0)).collect::<Vec<T>>();
        let (base, radii) = (grid(0.37), grid(0.011));
        for count in [1, 2, 7] {
            let mut changes = Changes::none();
            for row in 0..count {
                let x = T::constant(0.3 / (row + 3) as f64);
                let kept = if row == 5 { T::zero() } else { T::one() };
                changes.set(row, Change { kept, gain: -x, on_axis: x + x, slope: x * x });
            }
            let mut rows = vec![T::one(); count * width];
            take_rows_from(&base, &radii, 3..width - 2, &changes, &mut [T::zero(); TILE], &mut rows);
            for (row, values) in rows.chunks(width).enumerate() {
                let mut expected = vec![T::zero(); width];
                let columns = 3..width - 2;
                let expected_part = &mut expected[columns.clone()];
                changes.get(row).apply_to_row(&base[columns.clone()], &radii[columns], expected_part);
                assert!(values == expected, "row {row} of {count}");
            }
        }
    }

    #[test]
    fn wide_vectors_change_no_bit() {
        check::<f64>();
        check::<f32>();
    }

    #[test]
    fn a_change_after_another_is_both() {
        for kept in [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)] {
            let one = Change { kept: kept.0, gain: 0.25, on_axis: 3.0, slope: 0.5 };
            let two = Change { kept: kept.1, gain: -0.125, on_axis: 1.0, slope: 0.25 };
            assert_eq!(one.then(two).apply(8.0, 2.0), two.apply(one.apply(8.0, 2.0), 2.0), "{kept:?}");
        }
    }
}
