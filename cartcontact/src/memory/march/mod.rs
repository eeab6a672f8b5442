//! From one stage to another, knot by knot.
//!
//! **Rounding.** The hereditary load Y grows like χ t, and an error ε Y is an error ε Y/F in χ t: after a long history
//! two stages computed independently would not agree on what lies between them. So only differences are used: a surplus
//! follows from the previous one and from what Y and J have gained since, both without cancellation.
//!
//! **The strip** between the rounded edge and the exact one, and what is laid at one radius: see [`edge`].
//!
//! **The load** that a stretch adds follows from the forces at its ends, and its integral is scaled to that load: then
//! forces balance, and on the axis most of the rounding cancels. The load is unknown for a cut stretch and where forces
//! are pure rounding, so nothing is scaled there. Under a load that is not straight the forces within a stretch may hold
//! less of its growth than their rounding, while those at its ends still tell the load that is kept: if the integral
//! carries another, that load is laid at one radius.
//!
//! **Straight loads.** The load hands out its pieces in order. Short ones are integrated many at once
//! ([`batch`](super::batch)), the others one by one.
//!
//! **Loads that are not straight** are followed in [`steps`], from shortly before the edge [passes](reach) the reach on.

mod edge;
mod reach;
mod steps;

use super::batch::Batch;
use super::fading::{Fading, faded_folds};
use super::stretch::{Course, Stretch};
use super::{Edge, Stage, Transition, not_negative, surplus_that_counts};
use crate::contact::{Contact, Loading};
use crate::load::{Load, MOST_PIECES, Piece, knot_between, least_step, pieces_between, same_time_before};
use crate::numbers::compensated_sum::CompensatedSum;
use crate::scalar::{has_no_derivatives, is_plain_zero, with_value};
use crate::{GapProfile, Scalar};

/// The transition to the edge at a later time, for radii up to `reach` or the first radius, the larger of the two.
// Inlined into its few callers, which then need not copy the stages.
#[inline(always)]
pub(crate) fn march<T, P, L>(
    contact: &Contact<T, P, L>,
    from: Stage<T>,
    end: Edge<T>,
    reach: T,
) -> Transition<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let force_at_end = contact.load().force(end.time);
    // Of equal ones the first radius: from there on load is laid, also for other values of the parameters with respect to
    // which numbers carry derivatives.
    let reach = from.radius.max(reach);
    let mut march = March {
        contact,
        // An edge that stands still may seem to recede by a rounding.
        end: Edge { radius: end.radius.max(from.radius), ..end },
        force_at_end,
        now: from,
        // The pressures at the start include the strip beyond its rounded radius.
        has_strip: reach <= from.radius,
        transition: Transition::none(reach),
    };
    march.advance();
    march.add_strip();
    march.transition.offset = not_negative(march.transition.offset.value).into();
    march.transition
}

/// Whether a difference has kept its bits, all but the last four; `sizes` is the sum of the magnitudes that it is the
/// difference of.
fn is_well_conditioned<T: Scalar>(difference: T, sizes: T) -> bool {
    sizes <= T::constant(16.0) * difference
}

/// A transition in progress.
struct March<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    /// Where it ends; the radius there must be met to the last bit.
    end: Edge<T>,
    force_at_end: T,
    now: Stage<T>,
    /// Whether the transition includes the strip of the present stage.
    has_strip: bool,
    transition: Transition<T>,
}

// Not derived, because neither profile nor load need be `Clone`.
impl<T: Scalar, P, L> Clone for March<'_, T, P, L> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<T: Scalar, P: GapProfile<T>, L: Load<T>> March<'_, T, P, L> {
    /// Continues to the end. The time of a knot there, or that of the start, need not have the derivatives of the time
    /// asked for: what lies between the two takes no time, but may have derivatives.
    fn advance(&mut self) {
        let (contact, end, force_at_end) = (self.contact, self.end, self.force_at_end);
        let Some(time) = same_time_before(contact.load(), self.now.time, end.time) else {
            return self.advance_along_load();
        };
        let loading = contact.loading(time);
        let radius = with_value(end.radius, contact.radius_under_loading(loading).unwrap_or(end.radius));
        (self.end, self.force_at_end) = (Edge { time, radius }, loading.force);
        self.advance_along_load();
        (self.end, self.force_at_end) = (end, force_at_end);
        self.advance_straight(Piece { start: (time, loading.force), end: (end.time, force_at_end) });
    }

    /// Continues to the end along the load.
    #[inline(always)]
    fn advance_along_load(&mut self) {
        let has_knots = knot_between(self.contact.load(), self.now.time, self.end.time).is_some();
        match (self.contact.load().is_linear_between_knots(), has_knots) {
            _ if is_plain_zero(self.contact.medium().chi()) => self.advance_at_once(),
            (true, true) => self.advance_in_pieces(),
            (true, false) => self.advance_in_one_piece(),
            (false, _) => self.advance_from_knot_to_knot(),
        }
    }

    /// Continues to the end where nothing drains: then it does not count when the load has risen.
    fn advance_at_once(&mut self) {
        let before = self.force_now();
        self.now.time = self.end.time;
        self.jump(before, self.force_at_end);
    }

    /// Continues to the end along a straight load, and through the jump that it may make there.
    /// [`advance_in_pieces`](Self::advance_in_pieces) would do the same, but most loads are held and need no room for
    /// pieces.
    fn advance_in_one_piece(&mut self) {
        let (load, start) = (self.contact.load(), self.now.time);
        if start < self.end.time {
            let piece = Piece {
                start: (start, load.force(start)),
                end: (self.end.time, load.force_before(self.end.time)),
            };
            self.advance_straight(piece);
            self.jump(piece.end.1, self.force_at_end);
        }
    }

    /// Continues to the end along the straight pieces of the load, and through the jumps between them.
    fn advance_in_pieces(&mut self) {
        let mut pieces = [Piece::none(); MOST_PIECES];
        while self.now.time < self.end.time {
            let times = (self.now.time, self.end.time);
            let mut ahead = pieces_between(self.contact.load(), times, &mut pieces);
            while !ahead.is_empty() {
                let count = self.advance_along_first(ahead).min(ahead.len());
                let (done, rest) = ahead.split_at(count);
                let last = done.last().map_or(self.force_at_end, |piece| piece.end.1);
                let next = rest.first().map_or_else(|| self.force_now(), |piece| piece.start.1);
                self.jump(last, next);
                ahead = rest;
            }
        }
    }

    /// Continues to the end along a load that is not straight, and through its jumps.
    fn advance_from_knot_to_knot(&mut self) {
        while self.now.time < self.end.time {
            let knot = knot_between(self.contact.load(), self.now.time, self.end.time);
            let end = knot.unwrap_or(self.end.time);
            if !self.is_covered() {
                self.approach_reach(end);
            }
            self.advance_in_steps(end);
        }
    }

    fn force_now(&self) -> T {
        if self.now.time < self.end.time {
            self.contact.load().force(self.now.time)
        } else {
            self.force_at_end
        }
    }

    /// Passes a jump of the load, which is never downward. A jump of no height may have a derivative.
    fn jump(&mut self, before: T, after: T) {
        if after > before || !has_no_derivatives::<T>() {
            let radius = self.radius_under(self.now.time, after);
            self.cover(radius, &Course::jump(), (before, after), after - before);
        }
    }

    /// Continues along the short pieces that come first, or else along the first piece and the step behind it, and
    /// returns how many these are.
    fn advance_along_first(&mut self, pieces: &[Piece<T>]) -> usize {
        let mut count = 1 + usize::from(pieces.get(1).is_some_and(Piece::is_step));
        // A single piece costs less over the radius.
        if pieces.len() > 1 && self.is_covered() {
            let batch = Batch::of(self.contact, pieces, self.now.impulse, |piece| self.faded_since(piece));
            if batch.len() > 1 {
                count = batch.len();
                if self.advance_batch(&batch, pieces.get(..count).unwrap_or(pieces)) {
                    return count;
                }
            }
        }
        let mut before = None;
        for piece in pieces.iter().take(count) {
            // Between two pieces there may be a step that only derivatives show.
            if let Some(before) = before.filter(|_| !has_no_derivatives::<T>()) {
                self.jump(before, piece.start.1);
            }
            if piece.is_step() {
                self.jump(piece.start.1, piece.end.1);
            } else {
                self.advance_straight(*piece);
            }
            before = Some(piece.end.1);
        }
        count
    }

    /// Continues along a batch of pieces; along none if one of them turns out not to be short.
    fn advance_batch(&mut self, batch: &Batch<'_, T, P, L>, pieces: &[Piece<T>]) -> bool {
        let [first, .., last] = pieces else { return false };
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let (end, force) = last.end;
        let share = (-self.faded_since(last)).exp();
        let radius = self.radius_after(batch.impulse, last.end);
        let Some(mut increment) = batch.increment((self.transition.reach, radius), share) else {
            return false;
        };
        let fading = Fading::over(chi * (end - self.now.time));
        let (kept, sizes) = fading.kept_of((first.start.1, force));
        if is_well_conditioned(kept, sizes) {
            let load = kept * contact.integral_per_load();
            increment = increment.scaled_to_load(load, self.transition.reach).unwrap_or(increment);
        }
        // Integrals over time do not use rounded radii: they include the strips.
        self.add_strip();
        self.transition.advance(fading, self.quarter_m(), increment, self.transition.reach);
        self.now.impulse = batch.impulse;
        let surplus = surplus_that_counts(self.surplus_at(radius, batch.gain), force);
        self.now = Stage { time: end, radius, surplus, ..self.now };
        true
    }

    /// The least number of e-foldings by which a piece's share in the pressures at the end has faded.
    ///
    /// The pressures when the piece ended carry F e^(−age) of the force at the end, on a smaller disc; a margin of 3
    /// makes up for the sizes of the discs.
    fn faded_since(&self, piece: &Piece<T>) -> T {
        if piece.end.1 > self.force_at_end {
            return T::zero();
        }
        (self.contact.medium().chi() * (self.end.time - piece.end.0) - T::constant(3.0)).max(T::zero())
    }

    /// Skips the early part of a straight stretch that does not fall, of which nothing is left at its end, and returns
    /// the rest.
    ///
    /// What a held load covered `folds` e-foldings ago carries e^(−folds) of it. The panels of an integral are chosen
    /// to resolve what counts, next to the edge, and could not do so within a much longer stretch.
    fn skip_what_fades(&mut self, piece: Piece<T>) -> Piece<T> {
        let chi = self.contact.medium().chi();
        let folds = faded_folds::<T>();
        let (start, end) = (piece.start.0, piece.end.0);
        if chi * piece.duration() <= folds + folds
            || start >= end * (T::one() - T::default_epsilon() * T::constant(8.0))
            || piece.rise() < T::zero()
        {
            return piece;
        }
        // At least a few roundings of the time, so that something is left.
        let time = end - (folds / chi).max(least_step(end));
        let skipped = piece.before(time);
        self.now.impulse.add(skipped.impulse());
        let force = skipped.end.1;
        let radius = self.radius_under(time, force);
        self.leave_strip();
        self.transition.fade(Fading::over(chi * skipped.duration()));
        self.now = self
            .contact
            .stage_with_loading(Loading::new(force, self.now.impulse.value, chi), Edge { time, radius });
        Piece { start: skipped.end, end: piece.end }
    }

    fn advance_straight(&mut self, piece: Piece<T>) {
        let chi = self.contact.medium().chi();
        let piece = self.skip_what_fades(piece);
        let (forces, impulse) = ((piece.start.1, piece.end.1), piece.impulse());
        self.now.impulse.add(impulse);
        let radius = self.radius_under(piece.end.0, piece.end.1);
        let gain = piece.rise() + chi * impulse;
        self.cover(radius, &Course::straight(chi * piece.duration(), forces), forces, gain);
        self.now.time = piece.end.0;
    }

    /// Extends the contact to a radius along a course of the load between two forces, during which the hereditary load
    /// gains `gain`.
    fn cover(&mut self, high: T, course: &Course<'_, T>, forces: (T, T), gain: T) {
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let fading = course.fading(chi);
        let (depth, is_covered) = (high - self.now.radius, self.is_covered());
        // The share by which the radius grows, of which the mean place of what is laid leaves only the second order.
        if depth <= high * T::default_epsilon() * T::constant(16.0) && is_covered {
            self.cover_at_once(high, fading, forces, gain);
            return;
        }
        let exact_surplus = self.surplus_at(high, gain);
        let surplus = surplus_that_counts(exact_surplus, forces.1);
        let low = self.low();
        let stretch = Stretch { contact, course, low, high, surplus, is_whole: is_covered };
        let (mut increment, is_over_time) = stretch.increment();
        if is_covered {
            let is_left_out = surplus != exact_surplus;
            let (kept, sizes) = fading.kept_of(forces);
            let of_strips = self.settle_strips(is_over_time || is_left_out, surplus, fading);
            let laid = kept - of_strips;
            let load = laid * contact.integral_per_load();
            let scaled = if !course.is_straight() {
                increment.scaled_if_resolved(load, low)
            } else if is_well_conditioned(kept, sizes) || is_left_out && !is_over_time {
                increment.scaled_to_load(load, low)
            } else {
                Some(increment)
            };
            increment = scaled.unwrap_or_else(|| self.laid_at_once(high, laid, gain));
        }
        self.transition.advance(fading, self.quarter_m(), increment, low);
        self.now = Stage { radius: high, surplus, ..self.now };
        // An integral over time ends at the exact radius, one over the radius at the rounded one, without the strip.
        self.has_strip = is_over_time;
    }

    /// Whether the contact has reached the radii that the transition is for.
    fn is_covered(&self) -> bool {
        self.transition.reach <= self.now.radius
    }

    /// The radius beyond which the next stretch counts. Of equal ones the present radius: what lies below it, also for
    /// other values of the parameters with respect to which numbers carry derivatives, has been laid.
    fn low(&self) -> T {
        if self.is_covered() { self.now.radius } else { self.transition.reach }
    }

    /// Lets time pass during which nothing is covered.
    fn fade(&mut self, fading: Fading<T>) {
        if self.is_covered() {
            self.add_strip();
        }
        self.transition.fade(fading);
    }

    /// The surplus at a later radius, up to which the hereditary load gains `gain`.
    fn surplus_at(&self, radius: T, gain: T) -> T {
        let contact = self.contact;
        let growth = contact.profile().load_integral_drop(radius, radius - self.now.radius);
        self.now.surplus + (gain - contact.load_per_integral() * growth)
    }

    /// The contact radius at a time under a force and the impulse so far: not less than now, nor more than at the end.
    fn radius_under(&self, time: T, force: T) -> T {
        self.radius_after(self.now.impulse, (time, force))
    }

    /// The contact radius [under](Self::radius_under) a force at a time, after another impulse than that so far.
    fn radius_after(&self, impulse: CompensatedSum<T>, (time, force): (T, T)) -> T {
        if time >= self.end.time && force >= self.force_at_end {
            return self.end.radius;
        }
        // Early on, rounding can make an impulse negative.
        let hereditary = (force + self.contact.medium().chi() * impulse.value).max(T::zero());
        self.contact
            .radius_under_hereditary(hereditary)
            .unwrap_or(self.end.radius)
            .max(self.now.radius)
            .min(self.end.radius)
    }

    fn quarter_m(&self) -> T {
        self.contact.medium().m() * T::constant(0.25)
    }
}
