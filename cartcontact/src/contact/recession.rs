//! From when on the edge of the contact recedes, up to the latest of some times.

use super::Contact;
use crate::Scalar;
use crate::load::{Load, rounding_of_hereditary};
use crate::profile::GapProfile;
use crate::scalar::is_finite_and_not_negative;

/// Since when the load falls too fast, if it does up to the latest of some times.
///
/// A search through a history of very many waves may miss what some of the times show. So where the hereditary load falls
/// most from one of them to the next, the history up to there is searched as well.
pub(crate) fn recession_within<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    times: &[T],
) -> Option<T> {
    let recession = |time| contact.load.recession(contact.medium.chi(), time);
    recession(latest(times)).or_else(|| {
        let is_searched = !contact.load.is_linear_between_knots();
        if is_searched { deepest_fall(contact, times).and_then(recession) } else { None }
    })
}

/// The time at the end of the deepest fall of the hereditary load from one of the times to the next, or the other way
/// round, if there is one that is more than rounding.
fn deepest_fall<T: Scalar, P: GapProfile<T>, L: Load<T>>(
    contact: &Contact<T, P, L>,
    times: &[T],
) -> Option<T> {
    let mut valid = times.iter().filter(|&&time| is_finite_and_not_negative(time));
    let hereditary_at = |time: T| (time, contact.loading(time).hereditary);
    let mut before = hereditary_at(*valid.next()?);
    let mut deepest = (T::zero(), None);
    for &time in valid {
        let now = hereditary_at(time);
        let ((_, first), (end, last)) = if now.0 < before.0 { (now, before) } else { (before, now) };
        let fall = first - last;
        if fall > rounding_of_hereditary(first) && fall > deepest.0 {
            deepest = (fall, Some(end));
        }
        before = now;
    }
    deepest.1
}

/// The latest of the times that a contact may be asked for; 0 if there is none.
pub(super) fn latest<T: Scalar>(times: &[T]) -> T {
    times
        .iter()
        .fold(T::zero(), |latest, &time| if (time > latest) & time.is_finite() { time } else { latest })
}
