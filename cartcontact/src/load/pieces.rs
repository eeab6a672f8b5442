//! The knots and the straight pieces that a load is asked for.

use super::{Load, Piece};
use crate::Scalar;
use crate::scalar::{has_no_derivatives, without_derivatives};

/// The first knot of a load after one time and before another; any other answer of a user-defined load is ignored.
#[inline]
pub(crate) fn knot_between<T: Scalar, L: Load<T> + ?Sized>(load: &L, from: T, until: T) -> Option<T> {
    load.next_knot(from).filter(|&knot| from < knot && knot < until)
}

/// The knot at a time, or the start if that is the same time; none unless numbers may have derivatives, which need not be
/// those of the time.
#[inline]
pub(crate) fn same_time_before<T: Scalar, L: Load<T> + ?Sized>(load: &L, from: T, t: T) -> Option<T> {
    if has_no_derivatives::<T>() {
        return None;
    }
    if t <= from {
        return Some(from);
    }
    // The number before t, if that is normal.
    let before = without_derivatives(t) * (T::one() - T::default_epsilon() * T::constant(0.5));
    load.next_knot(before).filter(|&knot| knot == t)
}

/// The most pieces that a load is asked for at once, and that are integrated together.
///
/// With twice as many the pressures of long records take a tenth less time and the solver 4 KiB of stack more; with half
/// as many they take a third more time.
pub(crate) const MOST_PIECES: usize = 16;

/// The [straight pieces](Load::straight_pieces) of a load: at least one, also where a user-defined load gives none that
/// takes time and ends after `from`. A step alone, at a later time, would let no time pass.
pub(crate) fn pieces_between<'a, T: Scalar, L: Load<T> + ?Sized>(
    load: &L,
    (from, until): (T, T),
    room: &'a mut [Piece<T>; MOST_PIECES],
) -> &'a [Piece<T>] {
    let count = load.straight_pieces((from, until), room).min(room.len());
    let last = room[..count].iter().rfind(|piece| !piece.is_step());
    if last.is_some_and(|last| last.end.0 > from) {
        return &room[..count];
    }
    room[0] = piece_to_knot(load, (from, load.force(from)), until);
    &room[..1]
}

/// The piece of a straight load from a time and its force on, up to the next knot or the time `until`.
#[inline]
pub(super) fn piece_to_knot<T: Scalar, L: Load<T> + ?Sized>(load: &L, start: (T, T), until: T) -> Piece<T> {
    let end = knot_between(load, start.0, until).unwrap_or(until);
    Piece { start, end: (end, load.force_before(end)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{Constant, LoadError, PiecewiseLinear};
    use crate::{Contact, ContactError, Medium, Polynomial};

    #[test]
    fn straight_pieces_include_steps_and_end_in_time() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([(0.0, 10.0), (5.0, 20.0), (5.0, 30.0), (7.0, 50.0)])?;
        let piece = |start, end| Piece { start, end };
        let expected = [
            piece((2.5, 15.0), (5.0, 20.0)),
            piece((5.0, 20.0), (5.0, 30.0)),
            piece((5.0, 30.0), (7.0, 50.0)),
            piece((7.0, 50.0), (9.0, 50.0)),
        ];
        let mut pieces = [Piece::none(); 5];
        let provided: &dyn Load<f64> = &Searched(&load);
        for load in [&load as &dyn Load<f64>, provided] {
            for room in 1..=pieces.len() {
                let count = room.min(expected.len());
                assert_eq!(load.straight_pieces((2.5, 9.0), &mut pieces[..room]), count);
                assert_eq!(pieces[..count], expected[..count]);
            }
            assert_eq!(load.straight_pieces((2.5, 5.0), &mut pieces), 1);
            assert_eq!(pieces[0], expected[0]);
            assert_eq!(load.straight_pieces((5.0, 6.0), &mut pieces), 1);
            assert_eq!(pieces[0], piece((5.0, 30.0), (6.0, 40.0)));
        }
        Ok(())
    }

    /// A load that leaves everything to the provided methods.
    struct Searched<'a>(&'a dyn Load<f64>);

    impl Load<f64> for Searched<'_> {
        fn force(&self, t: f64) -> f64 {
            self.0.force(t)
        }
        fn impulse(&self, t: f64) -> f64 {
            self.0.impulse(t)
        }
        fn force_before(&self, t: f64) -> f64 {
            self.0.force_before(t)
        }
        fn next_knot(&self, t: f64) -> Option<f64> {
            self.0.next_knot(t)
        }
    }

    /// A load that is held, but has only a step to show, at a time at which there is none.
    struct Stuck;

    impl Load<f64> for Stuck {
        fn force(&self, _t: f64) -> f64 {
            100.0
        }
        fn impulse(&self, t: f64) -> f64 {
            100.0 * t
        }
        fn next_knot(&self, t: f64) -> Option<f64> {
            (t < 5.0).then_some(5.0)
        }
        fn is_linear_between_knots(&self) -> bool {
            true
        }
        fn straight_pieces(&self, (_, until): (f64, f64), pieces: &mut [Piece<f64>]) -> usize {
            pieces[0] = Piece { start: (until, 100.0), end: (until, 100.0) };
            1
        }
    }

    #[test]
    fn pieces_let_time_pass() -> Result<(), ContactError> {
        let pressure = |load: &dyn Load<f64>| {
            let contact =
                Contact::new(Polynomial::new([(0.025, 2.0)])?, Medium::from_constants(0.375, 0.02)?, load)?;
            Ok::<_, ContactError>(contact.at(60.0)?.pressure(3.0))
        };
        let (stuck, held) = (pressure(&Stuck)?, pressure(&Constant(100.0))?);
        assert!((stuck / held - 1.0).abs() < 1e-14, "{stuck}, {held}");
        Ok(())
    }
}
