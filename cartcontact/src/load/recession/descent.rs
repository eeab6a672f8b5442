//! How far the hereditary load Y = F + χ ∫F falls below its highest value along straight pieces.
//!
//! Y falls nowhere along a piece if F₁ ≥ F₀/(1 + χ Δt). As forces are rounded, each may fall short of that by 8 ε.
//! These allowances add up: pieces of 1/1000 s, in which a force may fall by ten ε in single precision, could fall at
//! twice the rate that the pressure follows. So the falls are summed, and a sum of √ε of the force is too much. Forces
//! rounded independently, by at most ε/2, stay below that over up to 4/ε pieces, as their errors add up like a square
//! root; and up to 1/(8 √ε) pieces stay below it whatever they do.
//!
//! Where F₁ is F₀/(1 + χ Δt) as rounded to the format, it is the bound and not a fall, however often: in equal steps it
//! is rounded the same way each time.

use crate::Scalar;
use crate::load::Piece;
use crate::scalar::from_single;

/// A walk along straight pieces that hardly fall too fast, if at all.
pub(in crate::load) struct Descent<T> {
    chi: T,
    /// The time at which Y was highest, and the force then.
    crest: (T, T),
    /// By how much Y has fallen since.
    fallen: T,
}

/// What the falls of many pieces may add up to, as a share of the force.
fn tolerance<T: Scalar>() -> T {
    T::default_epsilon().sqrt()
}

/// Whether the falls of so many pieces, each within its allowance, can add up to too much.
pub(in crate::load) fn may_add_up<T: Scalar>(count: usize) -> bool {
    from_single::<T>(count as f32 * 8.0) * T::default_epsilon() > tolerance()
}

impl<T: Scalar> Descent<T> {
    pub(in crate::load) fn new(chi: T) -> Self {
        Self { chi, crest: (T::zero(), T::zero()), fallen: T::zero() }
    }

    /// Continues along a piece that begins at the end of the one before it, and returns since when the edge has receded
    /// at `t`, if it has.
    pub(in crate::load) fn pass(&mut self, piece: &Piece<T>, t: T) -> Option<T> {
        if let Some(turn) = piece.recession(self.chi) {
            // At the very time at which a slope becomes too steep the edge has not moved yet.
            return (turn < t || piece.duration().is_zero()).then_some(turn);
        }
        if piece.end.0 > t {
            return None;
        }
        if self.fallen.is_zero() {
            self.crest = piece.start;
        }
        self.fallen = (self.fallen - self.gain(piece)).max(T::zero());
        (self.fallen > self.crest.1 * tolerance()).then_some(self.crest.0)
    }

    /// By how much Y rises along a piece.
    fn gain(&self, piece: &Piece<T>) -> T {
        let (folds, half) = (self.chi * piece.duration(), T::constant(0.5));
        // The impulse need not be in range.
        let gain = piece.rise() + folds * (piece.start.1 * half + piece.end.1 * half);
        if gain < T::zero() && piece.keeps_bound(self.chi) { T::zero() } else { gain }
    }
}
