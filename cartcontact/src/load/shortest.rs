//! The shortest part into which a history is divided.

use crate::Scalar;
use crate::scalar::smallest_normal;

/// After this many parts that are given up, the shortest length is doubled: a load may have a few jumps that no knot
/// reports, at each of which parts are given up, and they should all be found with full sharpness.
const GIVEN_UP_PER_DOUBLING: u32 = 16;

/// The shortest step on the way to a time: four roundings of it, which surely move a time up to there, and a normal
/// number.
pub(crate) fn least_step<T: Scalar>(end: T) -> T {
    (end * T::default_epsilon() * T::constant(4.0)).max(smallest_normal())
}

/// How many times the shortest length a part has that tells jumps and kinks from noise. With 64, ten thousand jumps are
/// taken for noise; with 4, some noise takes twenty times as many forces.
const LONG: f64 = 16.0;

/// The shortest length of a part, as a time or as a share of the time between knots, whichever its owner divides. It is
/// doubled after every sixteen parts that are given up although they still leave something out. Otherwise the noise of a
/// load would be followed through a whole history. Jumps and kinks are not noise while there are long parts between them
/// that leave nothing out.
pub(crate) struct Shortest<T> {
    length: T,
    /// Since the length was doubled, or a long part was resolved.
    given_up: u32,
    /// How many more may be given up at jumps and kinks.
    at_knots: u32,
}

impl<T: Scalar> Shortest<T> {
    /// At most `at_knots` parts are given up at jumps and kinks, as some noise resembles these; all others are noise.
    pub(crate) fn of(length: T, at_knots: u32) -> Self {
        Self { length, given_up: 0, at_knots }
    }

    pub(crate) fn length(&self) -> T {
        self.length
    }

    /// Notes a part that is given up.
    pub(crate) fn give_up(&mut self) {
        self.given_up += 1;
        if self.given_up == GIVEN_UP_PER_DOUBLING {
            self.given_up = 0;
            self.length += self.length;
        }
    }

    /// Notes a part of some length that leaves nothing out.
    pub(crate) fn resolve(&mut self, length: T) {
        if self.at_knots > 0 && length >= self.length * T::constant(LONG) {
            self.at_knots = self.at_knots.saturating_sub(self.given_up);
            self.given_up = 0;
        }
    }
}
