//! What can be wrong with a contact, and how it is said.

use core::fmt;

use crate::load::LoadError;
use crate::medium::MediumError;
use crate::profile::{ProfileError, RadiusError};
use crate::shown::Shown;

/// Why a contact cannot be set up or evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContactError {
    /// The geometry is not usable.
    Profile(ProfileError),
    /// The load is not usable.
    Load(LoadError),
    /// The layers make no medium. No contact reports it; it lets a function that makes both have one type of error.
    Medium(MediumError),
    /// A time is negative, infinite or not a number.
    InvalidTime {
        /// The time, in s.
        time: f64,
    },
    /// A radius is negative, infinite or not a number.
    InvalidRadius {
        /// Its index in the slice.
        index: usize,
        /// The radius, in mm.
        radius: f64,
    },
    /// The contact has left the admissible range of the geometry.
    BeyondRange {
        /// The time asked for, in s.
        time: f64,
        /// The time at which the contact leaves the range, in s, or up to 30 roundings of the hereditary load later.
        leaves_at: f64,
        /// The end of the range, in mm.
        max_radius: f64,
    },
    /// The load fell so fast that the edge of the contact recedes.
    Receding {
        /// The time asked for, in s.
        time: f64,
        /// The time at which the edge begins to recede, in s.
        since: f64,
    },
    /// A number that the result depends on is so small that the format cannot hold all its digits, or infinite;
    /// [`Contact::at`](crate::Contact::at) lists these numbers.
    Unrepresentable {
        /// The time, in s.
        time: f64,
        /// The force at that time, in N.
        force: f64,
    },
    /// A [`GapProfile`](crate::GapProfile) from outside this crate gave no contact radius.
    Radius {
        /// The time, in s.
        time: f64,
        /// The reason.
        error: RadiusError,
    },
    /// A slice has no elements.
    Empty {
        /// Which slice.
        what: &'static str,
    },
    /// A slice has the wrong length.
    Length {
        /// Which slice.
        what: &'static str,
        /// Its length.
        length: usize,
        /// The length it must have.
        expected: usize,
    },
    /// Times are not in ascending order.
    Unsorted {
        /// The index of the first time that is before its predecessor.
        index: usize,
        /// That time, in s.
        time: f64,
    },
}

impl fmt::Display for ContactError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Profile(error) => error.fmt(f),
            Self::Load(error) => error.fmt(f),
            Self::Medium(error) => error.fmt(f),
            Self::InvalidTime { time } => {
                write!(
                    f,
                    "the time is {}, but it must be finite and not negative; give the time since the load was \
                     applied, in s",
                    Shown(time)
                )
            }
            Self::InvalidRadius { index, radius } => write!(
                f,
                "the radius at index {index} is {}, but it must be finite and not negative; give distances from the \
                 axis",
                Shown(radius)
            ),
            Self::BeyondRange { leaves_at: 0.0, max_radius, .. } => write!(
                f,
                "the contact exceeds the admissible range of the geometry, radii up to {}, as soon as the load is \
                 applied; lower the load, or extend `max_radius` if one was given",
                Shown(max_radius)
            ),
            Self::BeyondRange { time, leaves_at, max_radius } => write!(
                f,
                "at time {} the contact has left the admissible range of the geometry: its radius reaches {} \
                 at time {}; ask for earlier times, lower the load, or extend `max_radius` if one was \
                 given",
                Shown(time),
                Shown(max_radius),
                Shown(leaves_at)
            ),
            Self::Receding { time, since } => write!(
                f,
                "the load falls faster than e^(-chi t) at time {}, so at time {} the edge of the contact has \
                 receded, which this solution does not cover; {}check whether the chi of the layers should be larger, or \
                 clamp falls that are noise, as the documentation of `PiecewiseLinear` shows: from one knot to the next, \
                 dt later, a force F may fall to F/(1 + chi dt)",
                Shown(since),
                Shown(time),
                if since > 0.0 { "ask for earlier times, " } else { "" }
            ),
            Self::Unrepresentable { time, force } => write!(
                f,
                "at time {}, where the force is {}, a number that the result depends on is too small or too large for \
                 the format to hold all its digits; choose units in which force, length and time are nearer to 1",
                Shown(time),
                Shown(force)
            ),
            Self::Radius { time, error } => write!(f, "at time {}: {error}", Shown(time)),
            Self::Empty { what } => write!(f, "`{what}` is empty; give at least one"),
            Self::Length { what, length, expected } => {
                write!(
                    f,
                    "`{what}` has length {length}, but it needs {expected}, a place for each result; resize it"
                )
            }
            Self::Unsorted { index, time } => write!(
                f,
                "the time at index {index} is {}, earlier than the time before it; sort the times in ascending order",
                Shown(time)
            ),
        }
    }
}

// Without a source, because the message has that of the error inside; reports of a chain would print it twice.
impl core::error::Error for ContactError {}

impl From<ProfileError> for ContactError {
    fn from(error: ProfileError) -> Self {
        Self::Profile(error)
    }
}

impl From<LoadError> for ContactError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

impl From<MediumError> for ContactError {
    fn from(error: MediumError) -> Self {
        Self::Medium(error)
    }
}
