//! When a load of any kind first falls so fast that the edge of the contact recedes.
//!
//! The edge recedes while the hereditary load Y = F + χ ∫F falls. Between knots the load is followed in panels, in
//! which its force is a [polynomial](ForceSeries) F = Σ cₖ Tₖ(ξ) through N + 1 nodes. Then dY/dξ is one too,
//! Σ gₖ Tₖ, and what it leaves out is about N² ρ, where ρ is the size of the last coefficients cₖ. On a panel
//!
//! - Y rises if g₀ − Σ|gₖ| − N² ρ ≥ 0, since |Tₖ| ≤ 1;
//! - Y falls if at a node it is below its highest so far by more than rounding;
//! - otherwise Y may do either, and the panel is halved until only rounding can hide between the nodes.
//!
//! Two things show that the nodes miss nothing: the coefficients, which must decrease, and the impulse, which the load
//! gives independently: a dip between nodes, or a swing that happens to look smooth at them, has an area.
//!
//! An impulse that no force through the nodes can have, unless Y falls between them, is a
//! [contradiction](super::contradiction) if no fall is found there.
//!
//! No panel that misses something is halved below 2^−17 of the time between knots, and only a limited number of other
//! panels is, so the search ends. What a panel still leaves out when it is halved no more is a jump, a kink, or noise
//! such as the rounding of 1 − e^(−t) early on; because of noise the bound [grows](Shortest).
//!
//! A load that is [straight](super::straight) between its knots is not searched.
//!
//! The steps of a pressure are chosen likewise, see `memory::march`, but by two results of an integral: there a kink that
//! nothing falls at counts, here a fall that no integral notices.

use super::contradiction::Contradiction;
use super::fault::{Fault, tolerances};
use crate::Scalar;
use crate::load::rounding::{rounding_of_hereditary, rounding_within_load, tolerance_of_falls};
use crate::load::{ForceSeries, Load, Piece, Shortest, knot_between, least_step};
use crate::scalar::is_single;

/// The most halvings of panels because of their impulse, which may simply be that of another load, or of panels that
/// are short already. From 16 to 1024 no test tells a difference but in time.
const MOST_DOUBTS: u32 = 128;

/// 2⁻¹⁷ of the time between knots: panels that miss something are no shorter. Steps of pressures go down to
/// 2⁻²⁰, as they have to integrate what panels only have to notice.
const SHORTEST_SHARE: f64 = 1.0 / 131_072.0;

/// The most panels that are given up at jumps and kinks that no knot reports: enough for a thousand of these. By
/// rounding, a smooth rise from zero may be a flight of many thousands of jumps too, and always is in single precision.
const MOST_AT_KNOTS: u32 = 2000;

/// Fails with the first fault of a history up to `t`.
pub(super) fn first_fault<T: Scalar, L: Load<T> + ?Sized>(load: &L, chi: T, t: T) -> Result<(), Fault<T>> {
    let zero = T::zero();
    let (negligible, tolerance) = tolerances(load, chi, t);
    let mut search = Search {
        load,
        chi,
        negligible,
        tolerance,
        time: zero,
        impulse: zero,
        crest: Crest::at(zero),
        shortest: Shortest::of(T::constant(SHORTEST_SHARE), if is_single::<T>() { 0 } else { MOST_AT_KNOTS }),
        doubts: MOST_DOUBTS,
        suspicion: None,
    };
    while search.time < t {
        let end = knot_between(load, search.time, t).unwrap_or(t);
        search.follow(end)?;
    }
    Ok(())
}

/// A search in progress.
struct Search<'a, T, L: ?Sized> {
    load: &'a L,
    chi: T,
    /// By how much a force may be negative.
    negligible: T,
    /// By how much an impulse may be off.
    tolerance: T,
    time: T,
    /// ∫F up to now.
    impulse: T,
    /// The highest hereditary load so far.
    crest: Crest<T>,
    /// The share of the time between knots below which panels are short.
    shortest: Shortest<T>,
    /// How many more panels may be halved because of their impulse, or although they are short.
    doubts: u32,
    /// The shortest contradiction so far, unless a fall that is found before its end explains it.
    suspicion: Option<Contradiction<T>>,
}

/// When the hereditary load was highest, by how much it has fallen since, and in how many panels.
#[derive(Clone, Copy)]
struct Crest<T> {
    time: T,
    fallen: T,
    /// By how much the fall may be off because of what the series of these panels leave out.
    uncertainty: T,
    panels: u32,
}

impl<T: Scalar> Crest<T> {
    fn at(time: T) -> Self {
        Self { time, fallen: T::zero(), uncertainty: T::zero(), panels: 0 }
    }
}

/// What a panel tells.
enum Finding<T> {
    /// The hereditary load falls from a time on.
    Falls(T),
    /// It seems to fall, by no more than the rounding of gains within the panel.
    SeemsToFall(T),
    /// It does not fall; with its crest at the end of the panel.
    Rises(Crest<T>),
    /// It may fall between the nodes.
    Unclear(Crest<T>),
}

/// Whether a panel that leaves something open is halved.
#[derive(Clone, Copy, PartialEq)]
enum Halving {
    /// Always.
    Free,
    /// As long as there are [doubts](Search::doubts) left: the panel is short.
    Limited,
    /// Never: its halves would hardly contain another number.
    Over,
}

impl Halving {
    /// Of a panel that begins at a `time` and is as long as a step, on the way to an `end`.
    ///
    /// Always if half of it is no less than `short`, and is a half: rounded, it may reach to the end like the whole.
    fn of<T: Scalar>(step: T, (least, short): (T, T), (time, end): (T, T)) -> Self {
        if step <= least + least {
            Self::Over
        } else if step <= short + short || time + step * T::constant(0.5) + least >= end {
            Self::Limited
        } else {
            Self::Free
        }
    }
}

impl<T: Scalar, L: Load<T> + ?Sized> Search<'_, T, L> {
    /// Continues to a time before which there is no knot, and through a jump there.
    fn follow(&mut self, end: T) -> Result<(), Fault<T>> {
        let whole = end - self.time;
        let mut step = whole;
        let (start, fallen) = ((self.time, self.load.force(self.time)), self.crest.fallen);
        let least = least_step(end);
        while self.time < end {
            let short = (whole * self.shortest.length()).max(least);
            let stop = if self.time + step + least < end { self.time + step } else { end };
            step = stop - self.time;
            let force = ForceSeries::between(self.load, (self.time, stop), self.chi);
            let impulse = self.load.impulse(stop);
            self.check(&force, impulse)?;
            let halving = Halving::of(step, (least, short), (self.time, end));
            self.crest = match self.finding(&force, impulse, halving) {
                None => {
                    step *= T::constant(0.5);
                    continue;
                }
                Some(Finding::Falls(since) | Finding::SeemsToFall(since)) => {
                    return Err(Fault::Falls(since));
                }
                Some(Finding::Rises(crest) | Finding::Unclear(crest)) => {
                    Crest { panels: crest.panels.saturating_add(1), ..crest }
                }
            };
            if force.is_unresolved() || force.is_rough() {
                self.shortest.give_up();
            } else {
                self.shortest.resolve(step / whole);
            }
            (self.time, self.impulse) = (stop, impulse);
            if stop >= end {
                self.forgive_along_bound(&Piece { start, end: (end, force.last()) }, fallen);
            }
            // Also where no knot reports a jump.
            if let Some(since) = self.jump(force.last()) {
                return Err(Fault::Falls(since));
            }
            if let Some(contradiction) = self.suspicion.take_if(|suspicion| suspicion.ends_by(stop)) {
                return Err(Fault::Contradicts(contradiction));
            }
            step += step;
        }
        Ok(())
    }

    /// Takes a fall from knot to knot that keeps the bound F/(1 + χ Δt), as it is rounded, for none, as along
    /// [straight pieces](super::descent): the panels in between have only added up their roundings.
    fn forgive_along_bound(&mut self, piece: &Piece<T>, fallen: T) {
        if piece.keeps_bound(self.chi) {
            self.crest.fallen = self.crest.fallen.min(fallen);
        }
    }

    /// What a panel tells; none if it is to be halved.
    fn finding(&mut self, force: &ForceSeries<T>, impulse: T, halving: Halving) -> Option<Finding<T>> {
        if self.must_halve(force, impulse, halving) {
            return None;
        }
        let rounding = self.rounding(force.last(), impulse);
        let finding = self.examine(force, rounding);
        let is_vague = match finding {
            // A rough series does not tell since when, nor what else the load does.
            Finding::Falls(_) | Finding::Rises(_) => force.is_rough() && halving == Halving::Free,
            Finding::SeemsToFall(_) | Finding::Unclear(_) => self.may_halve(halving),
        };
        (!is_vague).then_some(finding)
    }

    /// By how much the hereditary load may have fallen since its crest and only be rounded.
    ///
    /// The gain of every panel is rounded, so that what is forgiven adds up, to no more than along
    /// [straight pieces](super::descent).
    fn rounding(&self, force: T, impulse: T) -> T {
        let of_one = rounding_of_hereditary(force + self.chi * impulse);
        if self.crest.fallen.is_zero() {
            return of_one;
        }
        let of_all = of_one * T::constant(f64::from(self.crest.panels));
        let most = tolerance_of_falls(self.load.force(self.crest.time));
        of_all.min(most).max(of_one) + self.crest.uncertainty
    }

    /// Fails if a force of a panel is invalid, or the impulse at its end is not finite.
    fn check(&self, force: &ForceSeries<T>, impulse: T) -> Result<(), Fault<T>> {
        match force.invalid_force(self.negligible) {
            Some(invalid) => Err(Fault::of_force(invalid)),
            None => Fault::check_impulse((force.end(), impulse)),
        }
    }

    /// Passes a jump of the load from a force `before`, if there is one, and returns since when the hereditary load
    /// falls, if it does.
    fn jump(&mut self, before: T) -> Option<T> {
        let after = self.load.force(self.time);
        if before == after {
            return None;
        }
        let rounding = self.rounding(before, self.impulse);
        let fallen = self.crest.fallen + (before - after);
        if fallen > T::zero() {
            self.crest.fallen = fallen;
        } else {
            self.crest = Crest::at(self.time);
        }
        (fallen > rounding).then_some(self.crest.time)
    }

    /// Whether a panel is to be halved because its nodes miss what the load does between them.
    fn must_halve(&mut self, force: &ForceSeries<T>, impulse: T, halving: Halving) -> bool {
        if force.is_unresolved() {
            return halving == Halving::Free;
        }
        let gain = impulse - self.impulse;
        let rounding = gain * T::default_epsilon().sqrt() + rounding_within_load(impulse);
        if !force.misses(gain, rounding) {
            return false;
        }
        self.suspect(force, gain);
        halving == Halving::Free && self.spend_doubt()
    }

    /// Notes a contradiction on a panel along which the impulse gains so much, unless one that ends no later is known.
    fn suspect(&mut self, force: &ForceSeries<T>, gain: T) {
        if self.suspicion.as_ref().is_none_or(|known| !known.ends_by(force.end())) {
            let found = Contradiction::within(force, (self.time, gain), self.chi, self.tolerance);
            self.suspicion = found.or(self.suspicion);
        }
    }

    /// Whether a panel that leaves something open is halved.
    fn may_halve(&mut self, halving: Halving) -> bool {
        match halving {
            Halving::Free => true,
            Halving::Limited => self.spend_doubt(),
            Halving::Over => false,
        }
    }

    /// Whether one more panel may be halved because of its impulse, or although it is short.
    fn spend_doubt(&mut self) -> bool {
        let is_left = self.doubts > 0;
        self.doubts = self.doubts.saturating_sub(1);
        is_left
    }

    /// Follows the hereditary load from node to node.
    fn examine(&self, force: &ForceSeries<T>, rounding: T) -> Finding<T> {
        let zero = T::zero();
        let dip = force.deepest_dip();
        let gain = force.gain();
        if dip <= zero && self.crest.fallen <= gain {
            return Finding::Rises(Crest::at(force.end()));
        }
        let rounding = rounding + force.uncertainty_of_gains();
        let mut fallen = self.crest.fallen;
        // The node at which the hereditary load is highest; none while it was higher before the panel.
        let mut highest = fallen.is_zero().then_some(ForceSeries::<T>::START);
        let growths = force.growth_since_nodes();
        let mut growth = growths[ForceSeries::<T>::START];
        for (node, &now) in growths.iter().enumerate().take(ForceSeries::<T>::START).rev() {
            fallen -= growth - now;
            growth = now;
            if fallen <= zero {
                (highest, fallen) = (Some(node), zero);
            } else if fallen > rounding {
                let since = highest.map_or(self.crest.time, |node| force.time_of_turn(node));
                let is_clear = fallen > rounding + force.rounding_of_gains();
                return if is_clear { Finding::Falls(since) } else { Finding::SeemsToFall(since) };
            }
        }
        let crest = highest.map_or(self.crest, |node| Crest::at(force.time(node)));
        let crest = Crest { fallen, uncertainty: crest.uncertainty + force.uncertainty_of_gains(), ..crest };
        if dip > rounding + force.rounding_of_dip() { Finding::Unclear(crest) } else { Finding::Rises(crest) }
    }
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use super::*;
    use crate::load::{LoadError, PiecewiseLinear};

    /// Straight between its knots, without saying so; it counts how often it is asked.
    struct Counted {
        load: PiecewiseLinear<f32, [(f32, f32); 3]>,
        calls: Cell<u32>,
    }

    impl Load<f32> for Counted {
        fn force(&self, t: f32) -> f32 {
            self.calls.set(self.calls.get() + 1);
            assert!(self.calls.get() < 1_000_000, "the search does not end");
            self.load.force(t)
        }
        fn impulse(&self, t: f32) -> f32 {
            self.load.impulse(t)
        }
        fn next_knot(&self, t: f32) -> Option<f32> {
            self.load.next_knot(t)
        }
    }

    /// Between the last knots are 45 numbers, so that forces look rough.
    #[test]
    fn a_search_between_neighbouring_numbers_ends() -> Result<(), LoadError> {
        let knots = [(0.0, 4_200_073.5), (1.967_558_4e-14, 4_307_520.5), (1.967_566e-14, 4_314_350.5)];
        let load = Counted { load: PiecewiseLinear::new(knots)?, calls: Cell::new(0) };
        assert!(first_fault(&load, 0.013_237_532, 3.143_362_8e-10).is_ok());
        Ok(())
    }
}
