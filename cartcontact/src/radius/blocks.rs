//! The radii of many load integrals, in blocks that compile to vector code.

use core::iter;

use super::table::{Row, Step, Table, digits};
use super::whole_powers::find_blocks;
use crate::Scalar;
use crate::dispatch::wide;
use crate::profile::{RadiusError, check_places};

/// Radii per block. Their rows and seeds stay in the first-level cache.
const BLOCK: usize = 64;

/// Radii per block at the end of a slice. Fewer than these are quicker one by one.
const SMALL_BLOCK: usize = 16;

impl<const N: usize, const BYTES: usize> Table<N, BYTES> {
    /// [`fill`] with blocks solved by a step from the rows, and blocks that are not in the table from a second start by
    /// `solve`, as by [`WholePowers::solve`](super::whole_powers::WholePowers::solve): those after them may be in the
    /// table. Where there is no second start, `solve` is [`nowhere`](super::table::nowhere).
    #[inline(always)]
    pub(super) fn find_all<T: Scalar>(
        &self,
        values: (&[T], &mut [T]),
        limit: T,
        step: impl Step<T, N>,
        solve: impl Fn(T, u32) -> (T, bool),
        general: impl Fn(T) -> Result<T, RadiusError>,
    ) -> Result<(), RadiusError> {
        let blocks = Blocks { table: self, limit, step };
        let least = if self.has_blocks::<T>() { SMALL_BLOCK } else { usize::MAX };
        fill(
            values,
            (least, BLOCK),
            #[inline(always)]
            |load_integrals, radii| match blocks.solve(load_integrals, radii) {
                0 => {
                    let block = ..radii.len().min(BLOCK);
                    let in_table = |load_integral| self.find(load_integral, limit, step);
                    find_blocks(&load_integrals[block], &mut radii[block], limit, &solve, in_table)
                }
                found => found,
            },
            general,
        )
    }
}

/// Fills the radii of many load integrals. `leading` solves as many as it can, in vector code, and is asked again for the
/// rest; where it solves none, `general` solves the next `block` one by one. Fewer than `least` are left to `general`.
///
/// # Errors
///
/// [`RadiusError::Length`] if the slices differ in length, and the first error of `general`.
#[inline(always)]
pub(super) fn fill<T: Scalar>(
    (load_integrals, radii): (&[T], &mut [T]),
    (least, block): (usize, usize),
    leading: impl Fn(&[T], &mut [T]) -> usize,
    general: impl Fn(T) -> Result<T, RadiusError>,
) -> Result<(), RadiusError> {
    check_places(load_integrals, radii)?;
    let mut start = 0;
    while start < radii.len() {
        let (load_integrals, radii) = (&load_integrals[start..], &mut radii[start..]);
        let mut found = if radii.len() >= least {
            wide(
                #[inline(always)]
                || leading(load_integrals, radii),
            )
        } else {
            0
        };
        if found == 0 {
            for (radius, &load_integral) in radii.iter_mut().zip(load_integrals).take(block) {
                *radius = general(load_integral)?;
            }
            found = block;
        }
        start += found;
    }
    Ok(())
}

/// Solves blocks of `N` load integrals, one after the other, until `block` fails. Returns how many radii it has found.
#[inline(always)]
pub(super) fn leading_blocks<T, const N: usize>(
    load_integrals: &[T],
    radii: &mut [T],
    mut block: impl FnMut(&[T; N], &mut [T; N]) -> bool,
) -> usize {
    let (load_integrals, radii) = (load_integrals.as_chunks().0, radii.as_chunks_mut().0);
    let mut found = 0;
    for (load_integrals, radii) in load_integrals.iter().zip(radii) {
        if !block(load_integrals, radii) {
            break;
        }
        found += N;
    }
    found
}

/// Longer rows are quicker used where they are, one by one: each has enough numbers to fill vectors by itself.
const LONGEST_COPIED_ROW: usize = 32;

/// How the load integrals of a block are solved.
struct Blocks<'a, T, S, const N: usize, const BYTES: usize> {
    table: &'a Table<N, BYTES>,
    limit: T,
    step: S,
}

impl<T: Scalar, S: Step<T, LENGTH>, const LENGTH: usize, const BYTES: usize> Blocks<'_, T, S, LENGTH, BYTES> {
    /// Finds the radii before the first block that fails, or before the last few. Returns how many it has found.
    #[inline(always)]
    fn solve(&self, load_integrals: &[T], radii: &mut [T]) -> usize {
        let found = self.solve_blocks::<BLOCK>(load_integrals, radii);
        if radii.len() - found >= BLOCK {
            return found;
        }
        // Never less; said so that no panic is left in the program.
        let found = found.min(load_integrals.len()).min(radii.len());
        found + self.solve_blocks::<SMALL_BLOCK>(&load_integrals[found..], &mut radii[found..])
    }

    #[inline(always)]
    fn solve_blocks<const N: usize>(&self, load_integrals: &[T], radii: &mut [T]) -> usize {
        let (mut rows, mut starts) = ([Row::default(); N], [S::Start::default(); N]);
        leading_blocks(
            load_integrals,
            radii,
            #[inline(always)]
            |load_integrals, radii| self.block(load_integrals, (&mut rows, &mut starts), radii),
        )
    }

    /// The radii of a block; false if one of them is not in the table or exceeds the limit.
    ///
    /// Only the rows are copied one by one, or used so if they are long; the loops before and after handle several values
    /// at once. At increasing times most blocks have one row, and no copies.
    #[inline(always)]
    fn block<const N: usize>(
        &self,
        load_integrals: &[T; N],
        (rows, starts): (&mut [Row<LENGTH>; N], &mut [S::Start; N]),
        radii: &mut [T; N],
    ) -> bool {
        // Copies, which cannot alias what is written: otherwise they would be read again for every radius.
        let (Self { table, limit, .. }, step) = (self, self.step);
        let [from, to] = table.ends::<T>();
        let mut found = true;
        let (mut all_digits, mut all_periods) = ([0; N], [0; N]);
        let places = all_digits.iter_mut().zip(&mut all_periods);
        for ((all_digits, all_periods), &load_integral) in places.zip(load_integrals) {
            let (y, periods) = step.in_table(load_integral);
            (*all_digits, *all_periods) = (digits(y), periods);
            found &= (from <= y) & (y < to);
        }
        if !found {
            return false;
        }
        let places = all_digits.iter().copied().zip(all_periods);
        if let Some(row) = table.row_of_all(&all_digits) {
            take_steps(step, iter::repeat(&row), places, starts, (load_integrals, radii));
        } else if const { LENGTH > LONGEST_COPIED_ROW } {
            // An exit keeps compilers from gathering the numbers of several rows, which takes up to twice as long.
            for (radius, &load_integral) in radii.iter_mut().zip(load_integrals) {
                match table.find(load_integral, *limit, step) {
                    Some(found) => *radius = found,
                    None => return false,
                }
            }
            return true;
        } else {
            for (row, &digits) in rows.iter_mut().zip(&all_digits) {
                *row = table.row(digits);
            }
            take_steps(step, rows.iter(), places, starts, (load_integrals, radii));
        }
        // Usually there is no limit; no radius is within a limit of NaN.
        *limit == T::infinity() || radii.iter().fold(true, |all, radius| all & (radius <= limit))
    }
}

/// The radii by a step from each row, for load integrals with these digits and periods.
#[inline(always)]
fn take_steps<'a, T: Scalar, S: Step<T, LENGTH>, const N: usize, const LENGTH: usize>(
    step: S,
    rows: impl Iterator<Item = &'a Row<LENGTH>> + Clone,
    places: impl Iterator<Item = (u32, i32)>,
    starts: &mut [S::Start; N],
    (load_integrals, radii): (&[T; N], &mut [T; N]),
) {
    for ((start, row), (digits, periods)) in starts.iter_mut().zip(rows.clone()).zip(places) {
        *start = step.start(row, digits, periods);
    }
    let values = load_integrals.iter().zip(radii);
    for ((row, &start), (&load_integral, radius)) in rows.zip(&*starts).zip(values) {
        *radius = step.radius(row, start, load_integral);
    }
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use super::*;

    /// How many of 100 numbers are solved one by one if a block of 16 at a time is solved, unless it holds one of these.
    fn solved_one_by_one(unsolvable: &[f64]) -> usize {
        let targets: Vec<f64> = (0..100).map(f64::from).collect();
        let (mut radii, count) = (vec![-1.0; 100], Cell::new(0));
        let leading = |targets: &[f64], radii: &mut [f64]| {
            leading_blocks::<_, 16>(&targets[..16], radii, |targets, radii| {
                *radii = *targets;
                !targets.iter().any(|target| unsolvable.contains(target))
            })
        };
        let general = |target| {
            count.set(count.get() + 1);
            Ok(target)
        };
        assert_eq!(fill((&targets, &mut radii), (16, 16), leading, general), Ok(()));
        assert_eq!(radii, targets);
        count.get()
    }

    #[test]
    fn only_blocks_that_fail_are_solved_one_by_one() {
        // The last four are no block.
        assert_eq!(solved_one_by_one(&[]), 4);
        assert_eq!(solved_one_by_one(&[20.0]), 20);
        assert_eq!(solved_one_by_one(&[0.0, 50.0, 51.0]), 36);
    }
}
