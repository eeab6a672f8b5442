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
use crate::load::rounding::tolerance_of_falls;

/// A walk along straight pieces that hardly fall too fast, if at all.
pub(in crate::load) struct Descent<T> {
    chi: T,
    /// The time at which Y was highest, and the force then.
    crest: (T, T),
    /// By how much Y has fallen since.
    fallen: T,
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
            return (turn < t || piece.is_step()).then_some(turn);
        }
        if piece.end.0 > t {
            return None;
        }
        if self.fallen.is_zero() {
            self.crest = piece.start;
        }
        self.fallen = (self.fallen - self.gain(piece)).max(T::zero());
        (self.fallen > tolerance_of_falls(self.crest.1)).then_some(self.crest.0)
    }

    /// By how much Y rises along a piece.
    fn gain(&self, piece: &Piece<T>) -> T {
        // The impulse need not be in range.
        let gain = piece.rise() + self.chi * piece.duration() * piece.mean_force();
        if gain < T::zero() && piece.keeps_bound(self.chi) { T::zero() } else { gain }
    }
}
