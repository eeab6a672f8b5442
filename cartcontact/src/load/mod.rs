//! How hard the joint is loaded, as a function of time.

mod constant;
mod contradiction;
mod piece;
mod piecewise_linear;
mod recession;
mod sum;

use core::fmt;

use crate::Scalar;
use crate::shown::Shown;

pub use constant::Constant;
pub use piece::Piece;
pub use piecewise_linear::PiecewiseLinear;
pub(crate) use sum::Sum;

/// A load F(t) ≥ 0 from t = 0 on, in N, with its impulse.
///
/// Two methods are enough for a load that is smooth and never falls faster than e^(−χ t). The others tell the
/// solver what it can skip or must not step over: kinks, jumps, straight pieces, and the time at which a
/// falling load lets the edge of the contact recede, which this solution does not cover.
///
/// The impulse must be that of the force; both are used. It may come from a quadrature: an error of √ε of the
/// hereditary load over χ, 1.5e-8 in f64, is never taken for more than that. An impulse that no force through the
/// samples can have without receding is refused, [`LoadError::ContradictoryImpulse`]. One that is off by a
/// few hundredths or less, or is right at the time asked for, may not be noticed: the radius is then that of the
/// impulse, the pressure lies between the two.
///
/// # Examples
///
/// ```
/// use cartcontact::load::Load;
///
/// /// A load that approaches its final value exponentially.
/// struct Rise {
///     force: f64,
///     rate: f64,
/// }
///
/// impl Load<f64> for Rise {
///     fn force(&self, t: f64) -> f64 {
///         -self.force * (-self.rate * t).exp_m1()
///     }
///     fn impulse(&self, t: f64) -> f64 {
///         self.force * (t + (-self.rate * t).exp_m1() / self.rate)
///     }
/// }
/// ```
pub trait Load<T: Scalar> {
    /// The force F(t) at a time t ≥ 0, in N; just after a jump, its value behind the jump.
    fn force(&self, t: T) -> T;

    /// The impulse ∫₀ᵗ F dτ up to a time t ≥ 0, in N s.
    fn impulse(&self, t: T) -> T;

    /// The force just before `t`, in N; differs from [`force`](Self::force) where the load jumps.
    fn force_before(&self, t: T) -> T {
        self.force(t)
    }

    /// The first time after `t` at which the load jumps or has a kink.
    fn next_knot(&self, _t: T) -> Option<T> {
        None
    }

    /// Whether the force is linear in time between knots; memory integrals are then explicit.
    fn is_linear_between_knots(&self) -> bool {
        false
    }

    /// Fills `pieces` with the straight pieces between two times, in order and as many as there is room for, and says
    /// how many they are; for loads that are [linear between knots](Self::is_linear_between_knots).
    ///
    /// The first begins at `from`, with the force behind a step there, the last ends at `until` at the latest.
    /// The provided method looks for one knot after the other; a load that holds its knots in order need not.
    #[inline]
    fn straight_pieces(&self, (from, until): (T, T), pieces: &mut [Piece<T>]) -> usize {
        let mut time = from;
        let mut count = 0;
        while count < pieces.len() && time < until {
            let end = knot_between(self, time, until).unwrap_or(until);
            pieces[count] = Piece { start: (time, self.force(time)), end: (end, self.force_before(end)) };
            count += 1;
            time = end;
        }
        count
    }

    /// The time up to `t` from which the history is not one that the solution covers, if there is one: the hereditary
    /// load F + χ ∫F falls, so that the edge recedes, or the load is not what it says, a
    /// [`contradiction`](Self::contradiction).
    ///
    /// The provided method follows the force between knots as closely as it varies, and finds every fall by more than
    /// rounding, 8 ε of the hereditary load. It needs some 17 forces for each panel of a few radians of an oscillation,
    /// or a few e-foldings of a decay; a load that knows the answer should give it.
    fn recession(&self, chi: T, t: T) -> Option<T> {
        recession::first_fault(self, chi, t).map(|fault| fault.time())
    }

    /// What is wrong with the load up to `t`, if that shows before the hereditary load falls: a force that is negative
    /// or not finite, or an impulse that is not that of the force.
    ///
    /// A contact asks for it only where there is a [`recession`](Self::recession), to tell why.
    fn contradiction(&self, chi: T, t: T) -> Option<LoadError> {
        recession::first_fault(self, chi, t)?.contradiction()
    }

    /// Checks values that the type itself cannot rule out.
    ///
    /// # Errors
    ///
    /// [`LoadError`] for a negative or non-finite force.
    fn check(&self) -> Result<(), LoadError> {
        Ok(())
    }
}

impl<T: Scalar, L: Load<T> + ?Sized> Load<T> for &L {
    fn force(&self, t: T) -> T {
        (**self).force(t)
    }
    fn impulse(&self, t: T) -> T {
        (**self).impulse(t)
    }
    fn force_before(&self, t: T) -> T {
        (**self).force_before(t)
    }
    fn next_knot(&self, t: T) -> Option<T> {
        (**self).next_knot(t)
    }
    fn is_linear_between_knots(&self) -> bool {
        (**self).is_linear_between_knots()
    }
    fn straight_pieces(&self, times: (T, T), pieces: &mut [Piece<T>]) -> usize {
        (**self).straight_pieces(times, pieces)
    }
    fn recession(&self, chi: T, t: T) -> Option<T> {
        (**self).recession(chi, t)
    }
    fn contradiction(&self, chi: T, t: T) -> Option<LoadError> {
        (**self).contradiction(chi, t)
    }
    fn check(&self) -> Result<(), LoadError> {
        (**self).check()
    }
}

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
    /// The impulse is not the integral of the force; or the force falls, but within a time too short to be seen.
    ContradictoryImpulse {
        /// The beginning of the time in which they differ, in s.
        from: f64,
        /// Its end, in s.
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
    /// The first knot is not at time 0.
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
                "the force at time {} is {}, but it must be finite and not negative, as tension would pull the \
                 surfaces apart; give compression as a positive force",
                Shown(time),
                Shown(force)
            ),
            Self::InvalidImpulse { time, impulse } => write!(
                f,
                "the impulse up to time {} is {}, but it must be finite and not negative; check `impulse`, the \
                 integral of the force from 0",
                Shown(time),
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
                "the first knot is at time {}, but a load history starts at 0; shift the times, or add a knot \
                 at 0",
                Shown(time)
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

/// The first knot of a load after one time and before another; what else a load of a user's own may name is no knot.
#[inline]
pub(crate) fn knot_between<T: Scalar, L: Load<T> + ?Sized>(load: &L, from: T, until: T) -> Option<T> {
    load.next_knot(from).filter(|&knot| from < knot && knot < until)
}

/// Whether a force is one that a contact can carry.
#[inline(always)]
pub(crate) fn is_force<T: Scalar>(force: T) -> bool {
    (force >= T::zero()) & force.is_finite()
}
