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
fn values<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
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
