//! A load given by its values at some times, linear between them.

use core::fmt;
use core::num::NonZero;

use super::knots::{check, pieces};
use super::recession::Descent;
use super::rounding::may_add_up;
use super::{Load, LoadError, Piece};
use crate::Scalar;
use crate::numbers::compensated_sum::CompensatedSum;
use crate::pairs::Pairs;

/// How many impulses and rates of fall a load stores, 512 bytes of each. Any other impulse is the sum of one and of up to
/// a 64th of the pieces, and a search for the first fall that is too fast passes no more.
const CHECKPOINTS: usize = 64;

/// A load through knots (time in s, force in N), linear between them and constant after the last.
///
/// The knots may be held in any storage: an array, a slice, a `Vec`. The first is at time 0; two knots at the
/// same time are a step. There is no solution after a step down, at time 0 as at any other.
///
/// # Examples
///
/// ```
/// use cartcontact::load::{Load, PiecewiseLinear};
///
/// let ramp_and_hold = PiecewiseLinear::new([(0.0, 0.0), (20.0, 100.0)])?;
/// assert_eq!(ramp_and_hold.force(5.0), 25.0);
/// assert_eq!(ramp_and_hold.impulse(30.0), 2000.0);
/// # Ok::<(), cartcontact::load::LoadError>(())
/// ```
///
/// The solution holds while the edge of the contact does not recede: from one knot to the next, Δt later, a force F may
/// fall to F/(1 + χ Δt) and no lower. The noise of a measured record falls faster, however well it is smoothed, and
/// must be clamped. A clamped record follows the peaks of the noise and is too high: for a load held for a minute,
/// noise with a standard deviation σ of 1 %, and χ = 0.0015/s, by 1 σ at 1 Hz and by 3.4 σ at 1 kHz, and less where χ
/// or the load is larger. Smooth such a record first, over as many samples as its ramps allow. Once the joint is really
/// unloaded, as in gait, the solution no longer holds, and a clamped record has the results of its higher load: check
/// how far it lies above the measured one. A fit of permeabilities changes χ, and with it what is too fast: clamp with
/// the lowest χ that it may try. The fall of a load that relaxes is no noise, and must not be clamped: from one knot to
/// the next, where it falls to F′, it needs a χ of (F/F′ − 1)/Δt. A fit begins above the largest of these, and shortens
/// a step that is refused.
///
/// ```
/// use cartcontact::{Contact, Medium, Polynomial, load::PiecewiseLinear};
///
/// let (gap, medium) = (Polynomial::new([(0.025, 2.0)])?, Medium::from_constants(0.375, 0.0015)?);
/// let mut record: [(f64, f64); 4] = [(0.0, 79.6), (0.01, 80.3), (0.02, 79.9), (0.03, 80.1)];
/// assert!(Contact::new(&gap, medium, PiecewiseLinear::new(&record)?)?.at(0.03).is_err());
///
/// for k in 1..record.len() {
///     let (before, force) = record[k - 1];
///     let lowest = force / (1.0 + medium.chi() * (record[k].0 - before));
///     if record[k].1 < lowest {
///         record[k].1 = lowest; // `max` would hide a force that is not a number
///     }
/// }
/// assert!(Contact::new(&gap, medium, PiecewiseLinear::new(&record)?)?.at(0.03).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct PiecewiseLinear<T, K> {
    knots: K,
    /// The impulses up to every `stride`-th knot.
    impulses: [T; CHECKPOINTS],
    /// The largest −F′/F that counts among the pieces that begin before the next of these knots: if χ is no smaller, the
    /// edge does not recede during them.
    fastest_falls: [T; CHECKPOINTS],
    stride: NonZero<usize>,
}

/// A knot, and the impulse up to it as a sum that began at the checkpoint before it.
type SumToKnot<T> = (usize, CompensatedSum<T>);

// Not derived: the knots say all.
impl<T, K: fmt::Debug> fmt::Debug for PiecewiseLinear<T, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PiecewiseLinear").field("knots", &self.knots).finish_non_exhaustive()
    }
}

impl<T: Scalar, K: Pairs<T>> PiecewiseLinear<T, K> {
    /// The load through `knots`, pairs (time, force) in the order of time.
    ///
    /// # Errors
    ///
    /// [`LoadError`] if there are no knots, a time is not finite, the first time is not 0, times decrease or
    /// three of them are equal, a force is negative or not finite, or a slope is out of range.
    pub fn new(knots: K) -> Result<Self, LoadError> {
        check(knots.as_ref())?;
        let stride =
            NonZero::new(knots.as_ref().len().div_ceil(CHECKPOINTS)).unwrap_or(NonZero::<usize>::MIN);
        let (impulses, fastest_falls) = ([T::zero(); CHECKPOINTS], [T::zero(); CHECKPOINTS]);
        let mut load = Self { knots, impulses, fastest_falls, stride };
        let mut fastest_fall = T::zero();
        let counts_rounding = may_add_up::<T>(load.knots().len());
        let mut sum = CompensatedSum::from(T::zero());
        for (index, piece) in pieces(load.knots.as_ref()).enumerate() {
            if !piece.has_slope() {
                let (from, to) = (piece.start.0.value(), piece.end.0.value());
                return Err(LoadError::TooSteep { knot: index + 1, from, to });
            }
            // With few pieces, the part of a fall that may be rounding does not count; with many, a fall to the bound as
            // it is rounded does not.
            fastest_fall = if counts_rounding {
                piece.least_rate(fastest_fall)
            } else {
                fastest_fall.max(piece.fall_beyond_rounding())
            };
            sum.add(piece.impulse());
            let knot = index + 1;
            if knot % stride == 0 {
                if let Some(fall) = load.fastest_falls.get_mut(index / stride) {
                    *fall = fastest_fall;
                }
                if let Some(impulse) = load.impulses.get_mut(knot / stride) {
                    *impulse = sum.total();
                }
            }
        }
        let passed = load.knots().len().saturating_sub(1) / stride;
        load.fastest_falls.iter_mut().skip(passed).for_each(|fall| *fall = fastest_fall);
        Ok(load)
    }

    /// The knots (time, force) as they were given.
    pub fn knots(&self) -> &[(T, T)] {
        self.knots.as_ref()
    }

    /// The impulse at `t`. The sum up to the knot before it goes on from that `before` another time, if both begin at one
    /// checkpoint: it is the same as if it had begun there.
    #[inline]
    fn impulse_after(&self, t: T, before: &mut Option<SumToKnot<T>>) -> T {
        let knots = self.knots.as_ref();
        let last = knots.partition_point(|&(time, _)| time <= t).saturating_sub(1);
        let Some(&start) = knots.get(last).filter(|_| t >= T::zero()) else {
            return before_the_start(t);
        };
        let checkpoint = (last / self.stride).min(CHECKPOINTS - 1);
        let (first, stored) = (checkpoint * self.stride.get(), self.impulses[checkpoint]);
        let (from, mut sum) =
            before.filter(|(knot, _)| first <= *knot && *knot <= last).unwrap_or((first, stored.into()));
        for piece in pieces(knots.get(from..=last).unwrap_or_default()) {
            sum.add(piece.impulse());
        }
        *before = Some((last, sum));
        // After the last knot the force is constant.
        let end = knots.get(last + 1).copied().unwrap_or((t, start.1));
        sum.add(Piece { start, end }.before(t).impulse());
        sum.total()
    }

    /// The force at `t`, from the last knot that `is_before` selects and the knot after it.
    fn force_after(&self, t: T, is_before: impl Fn(T) -> bool) -> T {
        let knots = self.knots.as_ref();
        let count = knots.partition_point(|&(time, _)| is_before(time));
        let start = count.checked_sub(1).and_then(|last| knots.get(last));
        match (start, knots.get(count)) {
            (Some(&start), Some(&end)) => Piece { start, end }.force(t),
            (Some(&(_, force)), None) => force,
            (None, _) => before_the_start(t),
        }
    }
}

/// Zero before the load is applied; NaN if the time is NaN.
fn before_the_start<T: Scalar>(t: T) -> T {
    if t.value().is_nan() { t } else { T::zero() }
}

impl<T: Scalar, K: Pairs<T>> Load<T> for PiecewiseLinear<T, K> {
    fn force(&self, t: T) -> T {
        self.force_after(t, |time| time <= t)
    }

    fn impulse(&self, t: T) -> T {
        self.impulse_after(t, &mut None)
    }

    fn fill_impulses(&self, times: &[T], impulses: &mut [T]) -> bool {
        let mut before = None;
        let mut fill = |(impulse, &t): (&mut T, &T)| *impulse = self.impulse_after(t, &mut before);
        let places = impulses.iter_mut().zip(times);
        // Sums go on to later times only.
        if times.first() > times.last() {
            places.rev().for_each(&mut fill);
        } else {
            places.for_each(&mut fill);
        }
        true
    }

    fn force_before(&self, t: T) -> T {
        self.force_after(t, |time| time < t)
    }

    fn next_knot(&self, t: T) -> Option<T> {
        let knots = self.knots.as_ref();
        knots.get(knots.partition_point(|&(time, _)| time <= t)).map(|&(time, _)| time)
    }

    fn is_linear_between_knots(&self) -> bool {
        true
    }

    fn straight_pieces(&self, (from, until): (T, T), pieces: &mut [Piece<T>]) -> usize {
        let knots = self.knots.as_ref();
        let last = knots.partition_point(|&(time, _)| time <= from).saturating_sub(1);
        let mut count = 0;
        let mut ends = knots.iter().skip(last + 1);
        let mut starts = knots.iter().skip(last);
        while count < pieces.len()
            && let Some(&start) = starts.next()
            && start.0 < until
        {
            let end = ends.next().copied().unwrap_or((until, start.1));
            match pieces[..count].last_mut() {
                // One piece, however often a held force was recorded.
                Some(last) if last.holds_until(end) => last.end = end,
                _ if start != end => {
                    pieces[count] = Piece { start, end };
                    count += 1;
                }
                _ => {}
            }
        }
        // No other piece begins before that time, or ends after it.
        if let Some(first) = pieces[..count].first_mut() {
            *first = first.between(from, until);
        }
        if let Some(last) = pieces[..count].last_mut() {
            *last = last.between(from, until);
        }
        count
    }

    fn recession(&self, chi: T, t: T) -> Option<T> {
        // Along the pieces before these nothing falls, or in all by no more than rounding; mostly there are no others.
        let first = self.fastest_falls.partition_point(|&fall| fall <= chi) * self.stride.get();
        let rest = self.knots().get(first..)?;
        let mut descent = Descent::new(chi);
        let mut begun = pieces(rest).take_while(|piece| piece.start.0 <= t);
        begun.find_map(|piece| descent.pass(&piece, t))
    }

    fn contradiction(&self, _chi: T, _t: T) -> Option<LoadError> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_has_a_value_on_either_side() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([(0.0, 10.0), (5.0, 10.0), (5.0, 30.0), (7.0, 50.0)])?;
        assert_eq!((load.force_before(5.0), load.force(5.0)), (10.0, 30.0));
        assert_eq!((load.force(6.0), load.force(9.0)), (40.0, 50.0));
        assert_eq!(load.impulse(8.0), 50.0 + 80.0 + 50.0);
        assert_eq!(
            (load.next_knot(0.0), load.next_knot(5.0), load.next_knot(7.0)),
            (Some(5.0), Some(7.0), None)
        );
        Ok(())
    }

    /// A long record that is clamped to its bound needs no search for a recession.
    #[test]
    fn falls_to_the_bound_are_not_too_fast() -> Result<(), LoadError> {
        for chi in [1.5e-3_f32, 0.02, 0.7] {
            let (mut knots, mut force) = (vec![(0.0, 100.0)], 100.0_f32);
            for k in 1..5000_u16 {
                let t = 0.01 * f32::from(k) * (1.0 + 0.3 * f32::from(k % 7));
                let (before, _) = knots[knots.len() - 1];
                if t > before {
                    let wanted = force * if k % 11 == 0 { 1.02 } else { 0.9 };
                    force = wanted.max(force / (1.0 + chi * (t - before)));
                    knots.push((t, force));
                }
            }
            assert!(may_add_up::<f32>(knots.len()));
            let load = PiecewiseLinear::new(knots)?;
            let [.., fastest_fall] = load.fastest_falls;
            assert!(fastest_fall <= chi, "{fastest_fall} > {chi}");
            // It is the least of such rates, so that a smaller one is too small for a piece.
            let slower = fastest_fall * (1.0 - f32::EPSILON);
            assert!(pieces(load.knots()).any(|piece| !piece.keeps_bound(slower)));
        }
        Ok(())
    }

    #[test]
    fn times_that_are_none_have_no_load() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([(0.0, 10.0), (5.0, 20.0)])?;
        assert_eq!((load.force(-1.0), load.impulse(-1.0)), (0.0, 0.0));
        assert!(load.force(f64::NAN).is_nan() && load.impulse(f64::NAN).is_nan());
        Ok(())
    }

    #[test]
    fn impulses_begin_at_any_checkpoint() -> Result<(), LoadError> {
        for count in [1, 2, 63, 64, 65, 128, 129, 1000] {
            let load = PiecewiseLinear::new(
                (0..count).map(|k| (f64::from(k), f64::from(k % 3))).collect::<Vec<_>>(),
            )?;
            for quarter in 0..4 * count + 8 {
                let t = f64::from(quarter) / 4.0;
                let pieces = pieces(load.knots()).filter(|piece| piece.start.0 < t);
                let until = |piece: Piece<f64>| if t < piece.end.0 { piece.before(t) } else { piece };
                let held = (t - f64::from(count - 1)).max(0.0) * f64::from((count - 1) % 3);
                let expected = pieces.map(|piece| until(piece).impulse()).sum::<f64>() + held;
                assert_eq!(load.impulse(t), expected, "{count} knots, {t}");
            }
        }
        Ok(())
    }

    #[test]
    fn an_impulse_may_be_as_large_as_any_number() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([(0.0, 1.5e17_f32), (1.5e21, 1.5e17)])?;
        assert_eq!(load.impulse(1.5e21), 1.5e21 * 1.5e17);
        Ok(())
    }

    #[test]
    fn an_impulse_that_leaves_the_format_is_infinite() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([1.0_f32, 1e10, 2e10, 3e10].map(|end| (end - 1.0, 1e30)))?;
        for t in [1e10, 1.5e10, 2e10, 3e10, 4e10] {
            assert_eq!(load.impulse(t), f32::INFINITY, "{t}");
        }
        assert_eq!(load, load);
        Ok(())
    }

    #[test]
    fn a_force_right_after_the_start_has_all_its_digits() -> Result<(), LoadError> {
        let load = PiecewiseLinear::new([(0.0, 0.0), (3e10, 3e300)])?;
        assert!((load.force(1e-307) / 1e-17 - 1.0_f64).abs() <= 2.0 * f64::EPSILON);
        Ok(())
    }

    #[test]
    fn recession_is_where_the_hereditary_load_turns() -> Result<(), LoadError> {
        // F′ = −2, χ F = 2 at F = 20, that is at t = 40 of the fall from 100.
        let load = PiecewiseLinear::new([(0.0, 100.0), (50.0, 0.0)])?;
        assert_eq!(load.recession(0.1, 40.0), None);
        assert_eq!(load.recession(0.1, 41.0), Some(40.0));
        assert_eq!((load.recession(0.0, 0.0), load.recession(0.0, 1.0)), (None, Some(0.0)));
        let step_down = PiecewiseLinear::new([(0.0, 100.0), (5.0, 100.0), (5.0, 99.0)])?;
        assert_eq!((step_down.recession(10.0, 4.0), step_down.recession(10.0, 5.0)), (None, Some(5.0)));
        Ok(())
    }

    #[test]
    fn no_fall_is_too_slow_for_the_format_to_be_seen() -> Result<(), LoadError> {
        for (duration, force) in [(2e154, 1e154), (1e180, 1e-150), (1e305, 1e300), (1e-150, 1e150)] {
            let load = PiecewiseLinear::new([(0.0, 1.1 * force), (duration, force)])?;
            let half = 0.5 * duration;
            assert_eq!(
                (load.recession(0.0, 0.0), load.recession(0.0, half)),
                (None, Some(0.0)),
                "{duration:e}"
            );
            // Half as fast as the fall at its end, and twice as fast.
            let chi = 0.05 / duration;
            assert_eq!(load.recession(chi, half), Some(0.0), "{duration:e}");
            assert_eq!(load.recession(4.0 * chi, half), None, "{duration:e}");
        }
        let single = PiecewiseLinear::new([(0.0, 2.2e19_f32), (2e19, 2e19)])?;
        assert_eq!((single.recession(0.0, 1e19), single.recession(6e-21, 1e19)), (Some(0.0), None));
        Ok(())
    }

    #[test]
    fn faults_name_the_knot() {
        let fault = |knots: &[(f64, f64)]| PiecewiseLinear::new(knots.to_vec()).err();
        assert_eq!(fault(&[]), Some(LoadError::Empty));
        assert_eq!(fault(&[(1.0, 2.0)]), Some(LoadError::LateStart { time: 1.0 }));
        assert_eq!(
            fault(&[(0.0, 1.0), (2.0, 1.0), (1.0, 1.0)]),
            Some(LoadError::Unsorted { knot: 2, time: 1.0, previous: 2.0 })
        );
        assert_eq!(
            fault(&[(0.0, 1.0), (0.0, 2.0), (0.0, 3.0)]),
            Some(LoadError::RepeatedTime { knot: 2, time: 0.0 })
        );
        assert_eq!(
            fault(&[(0.0, 0.0), (1.0, 0.0), (1.0 + 2e-16, 1e300)]),
            Some(LoadError::TooSteep { knot: 2, from: 1.0, to: 1.0 + 2e-16 })
        );
        assert_eq!(fault(&[(0.0, -1.0)]), Some(LoadError::InvalidForce { time: 0.0, force: -1.0 }));
    }
}
