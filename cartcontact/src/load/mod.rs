//! How hard the joint is loaded, as a function of time.
//!
//! | load | type |
//! |---|---|
//! | applied at once and held, as in a creep test | [`Constant`] |
//! | a ramp, steps, or a measured record: pairs (time, force) | [`PiecewiseLinear`] |
//! | a formula, or samples that come one by one | a type of your own that implements [`Load`] |
//!
//! No force may fall faster than e^(−χ t): otherwise the edge of the contact would recede, and a contact answers with
//! [`ContactError::Receding`](crate::ContactError::Receding).

// Loads: `constant`, `piecewise_linear` (through `knots`), and `pointers` to loads of a user; what can be wrong with
// one is an `error`. A straight part of any of them is a `piece`, and `pieces` asks for them; where a load is not
// straight, a `force_series` is its force during a step. `recession`: up to when the solution covers a history, which is
// divided into parts no shorter than `shortest`; what counts as `rounding` there.
mod constant;
mod error;
mod force_series;
mod knots;
mod piece;
mod pieces;
mod piecewise_linear;
mod pointers;
mod recession;
mod rounding;
mod shortest;

use crate::Scalar;

pub use constant::Constant;
pub use error::LoadError;
pub(crate) use force_series::ForceSeries;
pub use piece::Piece;
use pieces::piece_to_knot;
pub(crate) use pieces::{MOST_PIECES, knot_between, pieces_between, same_time_before};
pub use piecewise_linear::PiecewiseLinear;
pub(crate) use rounding::{impulse_tolerance, rounding_of_hereditary, rounding_within_load};
pub(crate) use shortest::{Shortest, least_step};

/// A load F(t) ≥ 0 from t = 0 on, in N, with its impulse.
///
/// The two required methods are enough for a load that never falls faster than e^(−χ t). The others tell the solver
/// what it can skip or must not step over: kinks, jumps, straight pieces, and the time at which a falling load lets the
/// edge of the contact recede, which this solution does not cover. Jumps and kinks that [`next_knot`](Self::next_knot)
/// does not report are found too, by thousands of calls of [`force`](Self::force) each: with forty jumps a pressure
/// loses no digits, with three thousand it is off by 1e-12, and with ten thousand kinks by 1e-10. Tens of thousands, at
/// intervals below 2⁻¹⁶ of the time between knots, may be taken for noise; a pressure is then off by some per cent.
/// Sampled data and steps need `next_knot`, or a [`PiecewiseLinear`]. For each wave of the force within the last forty
/// e-foldings that is more than rounding, a pressure takes 20 to 200 calls of `force`, up to a million in all; waves
/// beyond that may be stepped over, and it is then off by as much as 1e-3.
///
/// The impulse must be the integral of the force, as both are used. It may come from a quadrature: an error of up to √ε
/// Y/χ, with the hereditary load Y and √ε = 1.5e-8 in f64, is never reported as a contradiction. An impulse is refused
/// with [`LoadError::ContradictoryImpulse`] if no force through the samples can have it unless the edge recedes. One
/// that is off by up to a few per cent, or wrong only before the time asked for, may go unnoticed: the radius is then
/// that of the impulse, and the pressure lies between that of the impulse and that of the force.
///
/// A force that is for a short while negative, infinite or not a number may go unnoticed; the pressures are then those
/// of the load around it, or not numbers.
///
/// A reference to a load is a load, too; with the feature `std` so are a `Box` and an `Arc`, also of a `dyn Load<T>`
/// chosen at run time.
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
///
/// In a control loop forces come one by one. The following load clamps each of them, so that none falls too fast and no
/// search for one is needed, and does not allocate: when there is no more room, it keeps its samples twice as far
/// apart. The time for a pressure grows with the number of samples, which limits how often a loop can ask for one; that
/// for a radius does not:
///
/// ```
/// use cartcontact::load::{Load, PiecewiseLinear};
/// use cartcontact::{Contact, Medium, Polynomial};
///
/// struct Live {
///     chi: f64,
///     /// Times and forces, and the impulses up to then.
///     samples: [(f64, f64, f64); 256],
///     count: usize,
///     /// How far apart samples are, all but the last.
///     interval: f64,
/// }
///
/// impl Live {
///     fn push(&mut self, time: f64, force: f64) {
///         // Before the last sample makes room, so that no peak is forgotten. NaN becomes the lowest, too.
///         let force = force.max(self.lowest(time));
///         let [.., before, last] = &self.samples[..self.count] else { return self.append(time, force) };
///         // The last sample stays once it is far enough from the one before it.
///         if last.0 - before.0 < 0.999 * self.interval {
///             self.count -= 1;
///         }
///         if self.count == self.samples.len() {
///             self.interval *= 2.0;
///             let count = core::mem::replace(&mut self.count, 1);
///             for k in (2..count).step_by(2) {
///                 let (time, force, _) = self.samples[k];
///                 self.append(time, force);
///             }
///         }
///         self.append(time, force);
///     }
///     fn lowest(&self, time: f64) -> f64 {
///         let (before, last, _) = self.samples[self.count - 1];
///         last / (1.0 + self.chi * (time - before))
///     }
///     fn append(&mut self, time: f64, force: f64) {
///         let (before, last, impulse) = self.samples[self.count - 1];
///         let force = force.max(self.lowest(time));
///         self.samples[self.count] = (time, force, impulse + 0.5 * (last + force) * (time - before));
///         self.count += 1;
///     }
///     /// The start of the straight piece that contains a time, and the force at that time.
///     fn at(&self, t: f64) -> ((f64, f64, f64), f64) {
///         let samples = &self.samples[..self.count];
///         let next = samples.partition_point(|sample| sample.0 <= t);
///         let (start, end) = (samples[next - 1], samples.get(next));
///         let slope = end.map_or(0.0, |end| (end.1 - start.1) / (end.0 - start.0));
///         (start, start.1 + slope * (t - start.0))
///     }
/// }
///
/// impl Load<f64> for Live {
///     fn force(&self, t: f64) -> f64 {
///         self.at(t).1
///     }
///     fn impulse(&self, t: f64) -> f64 {
///         let ((start, first, impulse), force) = self.at(t);
///         impulse + 0.5 * (first + force) * (t - start)
///     }
///     fn next_knot(&self, t: f64) -> Option<f64> {
///         let samples = &self.samples[..self.count];
///         samples.get(samples.partition_point(|sample| sample.0 <= t)).map(|sample| sample.0)
///     }
///     fn is_linear_between_knots(&self) -> bool {
///         true
///     }
///     fn recession(&self, _chi: f64, _t: f64) -> Option<f64> {
///         None
///     }
/// }
///
/// let (gap, medium) = (Polynomial::new([(0.025, 2.0)])?, Medium::from_constants(0.375, 0.0015)?);
/// let mut load = Live { chi: medium.chi(), samples: [(0.0, 0.0, 0.0); 256], count: 1, interval: 1e-3 };
/// // 100 N within a second, and held for a minute.
/// for k in 1..=60_000 {
///     let time = f64::from(k) * 1e-3;
///     load.push(time, 100.0 * time.min(1.0));
///     if k % 1000 == 0 {
///         assert!(Contact::new(&gap, medium, &load)?.at(time)?.radius() > 7.0);
///     }
/// }
/// let exact = PiecewiseLinear::new([(0.0, 0.0), (1.0, 100.0)])?;
/// assert!((load.impulse(60.0) / exact.impulse(60.0) - 1.0).abs() < 2e-3);
/// let found = Contact::new(&gap, medium, &load)?.at(60.0)?.peak_pressure();
/// let expected = Contact::new(&gap, medium, &exact)?.at(60.0)?.peak_pressure();
/// assert!((found / expected - 1.0).abs() < 2e-4);
/// load.push(60.001, 200.0);
/// load.push(60.002, 100.0);
/// assert!(load.force(60.002) > 199.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a load with forces of type `{T}`",
    label = "not a load",
    note = "a constant load is `load::Constant(100.0)`, with a decimal point",
    note = "a measured load is `load::PiecewiseLinear::new(...)?` of pairs (time, force), with `?`",
    note = "all numbers of a contact have one type: in a contact of f32 that is `load::Constant(100.0_f32)`",
    note = "for any other implement `Load`: it also needs the integral of the force over time"
)]
pub trait Load<T: Scalar> {
    /// The force F(t) at a time t ≥ 0, in N; at a jump, its value just after the jump.
    fn force(&self, t: T) -> T;

    /// The impulse ∫₀ᵗ F dτ up to a time t ≥ 0, in N s.
    fn impulse(&self, t: T) -> T;

    /// The force just before `t`, in N; differs from [`force`](Self::force) where the load jumps.
    fn force_before(&self, t: T) -> T {
        self.force(t)
    }

    /// Fills the impulses at many times, in any order, in N s, and returns true; or false, with nothing filled, if they
    /// are as quick one by one. Both give the same impulses. The times may be anything, NaN included.
    #[inline]
    fn fill_impulses(&self, _times: &[T], _impulses: &mut [T]) -> bool {
        false
    }

    /// The first time after `t`, in s, at which the load jumps or has a kink; none if there is no such time. A load
    /// that jumps must also provide [`force_before`](Self::force_before), and one with thousands of knots should say if
    /// it is [linear between them](Self::is_linear_between_knots).
    fn next_knot(&self, _t: T) -> Option<T> {
        None
    }

    /// Whether the force is linear in time between knots; memory integrals are then explicit, and the solver looks for
    /// nothing else between them. With ten thousand knots a pressure then takes two calls of `force` for each, not sixty.
    fn is_linear_between_knots(&self) -> bool {
        false
    }

    /// Fills `pieces` with the straight pieces between two times, in order and as many as there is room for, and
    /// returns how many there are, at least one; for loads that are
    /// [linear between knots](Self::is_linear_between_knots).
    ///
    /// The first begins at `from`, with the force after a step there; the last ends at `until` at the latest. Pieces
    /// with one held force may be joined. A step is a piece that takes no time. It may be left out: the next piece then
    /// begins with another force than the one before it ended with; with hundreds of steps, pressures take twice as
    /// long. The provided method looks for one knot after the other; a load that holds its knots in order need not.
    #[inline]
    fn straight_pieces(&self, (from, until): (T, T), pieces: &mut [Piece<T>]) -> usize {
        let (mut count, mut start) = (0, (from, self.force(from)));
        while count < pieces.len() && start.0 < until {
            let piece = piece_to_knot(self, start, until);
            pieces[count] = piece;
            count += 1;
            let end = piece.end;
            start = (end.0, self.force(end.0));
            if count < pieces.len() && start.0 < until && start != end {
                pieces[count] = Piece { start: end, end: start };
                count += 1;
            }
        }
        count
    }

    /// The first time up to `t`, in s, from which the solution does not hold, if there is one: the hereditary load
    /// F + χ ∫F falls there, so that the edge recedes, or the force and the impulse are in
    /// [`contradiction`](Self::contradiction).
    ///
    /// The provided method follows the force between knots in steps that are short enough for its variation. If the
    /// load is smooth over these steps, it finds every fall by more than rounding, 8 ε of the hereditary load. In
    /// ripples that are too short for them it finds falls by √ε of the force, and a pulse between two of its samples
    /// only if the impulse of that exceeds √ε Y/χ. For a wave that falls hardly faster than e^(−χ t) this holds up to
    /// 1e5 periods; with more, the answer may be one of the later waves, and from 1e7 periods on there may be none.
    /// Between a thousand jumps or kinks that no knot reports, in single precision a hundred, it finds falls by 1e-3 of
    /// the force. It calls `force` some 17 times for every few radians of an oscillation, or every few e-foldings of a
    /// decay, some 2500 times for one such kink and 250 times for each of a thousand, and up to 1e6 times where forces
    /// are the rounding of something larger, as 1 − cos t is at first. A load that knows the answer should provide it.
    ///
    /// For a load that is [linear between knots](Self::is_linear_between_knots) it follows the pieces, with two calls
    /// of `force` for each. As forces are rounded, a piece may fall too fast by 8 ε of its force, and all together by √ε.
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

    /// Checks values that the type itself cannot rule out; [`Contact::new`](crate::Contact::new) calls it once. Unless
    /// it is overridden it accepts everything, and forces are checked at the times that are asked for.
    ///
    /// # Errors
    ///
    /// [`LoadError`] for a negative or non-finite force.
    fn check(&self) -> Result<(), LoadError> {
        Ok(())
    }
}
