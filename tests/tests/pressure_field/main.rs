//! Pressures at many times and radii at once.

mod fading;
mod late_radii;
mod long_intervals;
mod order;
mod rows;
mod short_intervals;

use cartcontact::load::Load;
use cartcontact::{Contact, ContactError, GapProfile, Scalar};
use tests::condition;

/// A contact under any load: what these tests ask of it is compiled once for each geometry and format, not for each of
/// the loads, too.
type Joint<'a, T, P> = Contact<T, P, &'a dyn Load<T>>;

/// [`joint`](tests::joint::joint) under any load.
fn joint<T: Scalar, P: GapProfile<T>>(profile: P, chi: f64, load: &dyn Load<T>) -> Joint<'_, T, P> {
    tests::joint::joint(profile, chi, load)
}

/// A value of a field, and what the snapshot at its time has there.
struct Value<T> {
    row: usize,
    t: T,
    r: T,
    found: T,
    expected: T,
    /// The factor on the allowed error.
    edge: f64,
}

/// The values in one of `every` rows of a field, and in the last row.
fn values<T: Scalar, P: GapProfile<T>>(
    contact: &Joint<'_, T, P>,
    times: &[T],
    radii: &[T],
    every: usize,
) -> Result<Vec<Value<T>>, ContactError> {
    let mut field = vec![T::constant(f64::NAN); times.len() * radii.len()];
    contact.pressure_field(times, radii, &mut field)?;
    let mut values = Vec::new();
    for (row, (&t, pressures)) in times.iter().zip(field.chunks(radii.len())).enumerate() {
        if row % every == 0 || row + 1 == times.len() {
            let now = contact.at(t)?;
            values.extend(radii.iter().zip(pressures).map(|(&r, &found)| {
                let edge = condition::edge(now.radius(), r);
                Value { row, t, r, found, expected: now.pressure(r), edge }
            }));
        }
    }
    Ok(values)
}
