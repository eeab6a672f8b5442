//! Pressures at many times and radii with three scalars per time and two multiply-adds and a sum per value.
//!
//! Every radius covered at an earlier row takes its pressure from that row by one [`Change`](sweep::Change),
//! whose scalars are shared by all radii; only a radius covered for the first time needs an integral of its
//! own, once. A field of N times × M radii therefore costs O(N + M) integrals.
//!
//! Rows are computed in blocks of up to [`BLOCK`]: [`panel`] finds the changes of a whole block from a few contact
//! radii, [`block`] takes them one by one where there is no such short cut, and [`sweep`] applies them. Radii may come in
//! any order: [`runs`] finds the columns inside an edge.
//!
//! **Rounding.** Taking every row from the one before it would add up N roundings. Rows are therefore taken from the
//! last row before their block; only radii covered within the block go row by row, and where all rows round alike every
//! eighth of them is taken from the one eight rows before. Where rows change too much for blocks, the memory has lost its
//! roundings after some dozen rows; [`anchors`] keep those of many blocks from adding up.

mod anchors;
mod block;
mod long_change;
#[cfg(feature = "nalgebra")]
mod matrix;
mod panel;
mod runs;
mod sweep;

use crate::Scalar;
use crate::contact::{Contact, ContactError, check_length, recession_within};
use crate::load::Load;
use crate::memory::{Edge, faded_folds};
use crate::profile::GapProfile;
use crate::scalar::{has_no_derivatives, is_finite_and_not_negative};
use crate::snapshot::Snapshot;
use anchors::Anchors;
use block::Block;
use runs::Runs;
use sweep::TILE;

/// The most rows in a block: enough to share the cost of a panel, few enough for the stack of a small processor.
const BLOCK: usize = 64;

/// Checks the arguments of [`Contact::pressure_field`], including times, because the load is asked for the last one
/// early on.
pub(crate) fn check<T: Scalar>(times: &[T], radii: &[T], values: &[T]) -> Result<(), ContactError> {
    for (what, slice) in [("times", times), ("radii", radii)] {
        if slice.is_empty() {
            return Err(ContactError::Empty { what });
        }
    }
    check_length("values", values.len(), times.len().saturating_mul(radii.len()))?;
    if let Some(index) = first_invalid(radii) {
        return Err(ContactError::InvalidRadius { index, radius: radii[index].value() });
    }
    if let Some(before) = times.windows(2).position(|pair| pair[1] < pair[0]) {
        return Err(ContactError::Unsorted { index: before + 1, time: times[before + 1].value() });
    }
    match first_invalid(times) {
        Some(index) => Err(ContactError::InvalidTime { time: times[index].value() }),
        None => Ok(()),
    }
}

/// The index of the first number that is negative or not finite.
fn first_invalid<T: Scalar>(numbers: &[T]) -> Option<usize> {
    numbers.iter().position(|&x| !is_finite_and_not_negative(x))
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
    let (width, first) = (radii.len(), contact.at(times[0])?);
    if times.len() == 1 {
        // Room for blocks of rows takes longer to clear than a few pressures to compute.
        first.pressures(radii, values);
        return Ok(());
    }
    // Once for all rows: searching the history of a user-defined load takes as long as many of them.
    let recedes_from = recession_within(contact, times);
    if recedes_from.is_some() {
        times.iter().try_for_each(|&time| contact.radius_if_advancing(time, recedes_from).map(drop))?;
    }
    first.pressures(radii, &mut values[..width]);
    let runs = Runs::of(radii);
    let mut block = Block::after(contact, first.edge());
    let mut anchors = Anchors::at(0, block.last());
    let (mut squares, mut done) = ([T::zero(); TILE], 1);
    while done < times.len() {
        if let Some(now) = snapshot_if_apart(contact, block.last().time, times[done])? {
            now.pressures(radii, &mut values[done * width..][..width]);
            block = Block::after(contact, now.edge());
            anchors = Anchors::at(done, block.last());
            done += 1;
            continue;
        }
        block.advance(&times[done..])?;
        block.fill(&runs, &mut squares, &mut values[(done - 1) * width..]);
        done += block.len();
        if let Some(change) = block.change() {
            anchors.pass(change, (done - 1, block.last()), radii, values);
        }
    }
    Ok(())
}

/// The contact at a time, if its pressures do not follow from those at the time `before`.
fn snapshot_if_apart<'a, T, P, L>(
    contact: &'a Contact<T, P, L>,
    before: T,
    time: T,
) -> Result<Option<Snapshot<'a, T, P, L>>, ContactError>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    if !may_be_apart(contact, before, time) {
        return Ok(None);
    }
    let now = Snapshot::new(contact, Edge { time, radius: contact.advancing_radius_at(time)? });
    let is_apart = time <= before || before < now.start_of_memory();
    Ok(is_apart.then_some(now))
}

/// Whether the pressures at a time may not follow from those at an earlier one.
///
/// After many e-foldings nothing is left of those, unless forces fall as fast, and what lies between takes long to
/// follow. At an equal time no time passes that could carry the derivatives which only the later one may have.
fn may_be_apart<T: Scalar, P: GapProfile<T>, L: Load<T>>(contact: &Contact<T, P, L>, from: T, to: T) -> bool {
    contact.medium().chi() * (to - from) > faded_folds::<T>() || !has_no_derivatives::<T>() && to <= from
}
