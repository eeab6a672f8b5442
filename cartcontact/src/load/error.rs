//! Why a load cannot be used.

use core::fmt;

use crate::shown::Shown;

/// Why a load cannot be used.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LoadError {
    /// There are no knots.
    Empty,
    /// A force is negative, infinite or not a number.
    InvalidForce {
        /// The time, in s.
        time: f64,
        /// The force, in N.
        force: f64,
    },
    /// An impulse is negative, infinite or not a number.
    InvalidImpulse {
        /// The time, in s.
        time: f64,
        /// The impulse, in N s.
        impulse: f64,
    },
    /// The impulse is not the integral of the force; or the force falls, but in a period too short to be seen.
    ContradictoryImpulse {
        /// The beginning of the period in which they differ, in s.
        from: f64,
        /// Its end, in s; 0 like its beginning if the impulse does not begin at zero.
        to: f64,
        /// By how much the impulse grows, in N s.
        impulse: f64,
        /// The integral of the force, in N s.
        integral: f64,
    },
    /// The time of a knot is infinite or not a number.
    InvalidTime {
        /// Which knot, counted from 0.
        knot: usize,
        /// Its time, in s.
        time: f64,
    },
    /// The first knot is not at time 0, but later or earlier.
    LateStart {
        /// The time of the first knot, in s.
        time: f64,
    },
    /// The time of a knot is before that of the knot before it.
    Unsorted {
        /// Which knot, counted from 0.
        knot: usize,
        /// Its time, in s.
        time: f64,
        /// The time of the knot before it, in s.
        previous: f64,
    },
    /// The load changes so much in so short a time that its slope is out of range.
    TooSteep {
        /// The knot at the end of the slope, counted from 0.
        knot: usize,
        /// The time of the knot before it, in s.
        from: f64,
        /// Its time, in s.
        to: f64,
    },
    /// More than two knots are at the same time.
    RepeatedTime {
        /// The third of the knots, counted from 0.
        knot: usize,
        /// The time, in s.
        time: f64,
    },
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => {
                write!(f, "the load has no knots; give at least one (time, force), such as (0, 100)")
            }
            Self::InvalidForce { time, force } => write!(
                f,
                "the force at time {} is {}, but it must be finite and not negative{}",
                Shown(time),
                Shown(force),
                if force < 0.0 {
                    ", as tension would pull the surfaces apart; give compression as a positive force, and \
                     noise around zero as zero"
                } else {
                    "; check how it is computed, or leave out the sample that is missing"
                }
            ),
            Self::InvalidImpulse { time, impulse } => write!(
                f,
                "the impulse up to time {} is {}, but it must be finite and not negative; {}",
                Shown(time),
                Shown(impulse),
                if impulse > 0.0 {
                    "use units of time and force in which it is not so large"
                } else {
                    "check `impulse`, the integral of the force from 0"
                }
            ),
            Self::ContradictoryImpulse { from: 0.0, to: 0.0, impulse, .. } => write!(
                f,
                "the impulse at time 0 is {}, but it must be 0 there; let `impulse` return the integral of the force \
                 from 0",
                Shown(impulse)
            ),
            Self::ContradictoryImpulse { from, to, impulse, integral } => write!(
                f,
                "from time {} to {} the impulse grows by {}, but the integral of the force is {}; check `impulse`, the \
                 integral of the force from 0, or give the times of very short changes in `next_knot`",
                Shown(from),
                Shown(to),
                Shown(impulse),
                Shown(integral)
            ),
            Self::InvalidTime { knot, time } => {
                write!(
                    f,
                    "the time of knot {knot} is {}, but times must be finite numbers; remove the knot or give its \
                     time in s",
                    Shown(time)
                )
            }
            Self::LateStart { time } => write!(
                f,
                "the first knot is at time {}, but a load history starts at 0; shift the times, or {}, and check that \
                 pairs are (time, force)",
                Shown(time),
                if time < 0.0 { "leave out the knots before 0" } else { "add a knot at 0" }
            ),
            Self::Unsorted { knot, time, previous } => write!(
                f,
                "knot {knot} is at time {}, before the knot at {} that precedes it; sort the knots by time",
                Shown(time),
                Shown(previous)
            ),
            Self::TooSteep { knot, from, to } => write!(
                f,
                "knot {knot} is at time {}, so soon after the one at {} that the slope of the load between them \
                 is out of range; give both the same time, which is a step",
                Shown(to),
                Shown(from)
            ),
            Self::RepeatedTime { knot, time } => write!(
                f,
                "knot {knot} is the third at time {}; two knots at the same time are a step, remove the ones \
                 between",
                Shown(time)
            ),
        }
    }
}

impl core::error::Error for LoadError {}
