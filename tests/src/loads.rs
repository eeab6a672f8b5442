//! Load histories of every kind that the solution covers, and loads that tell less of another one or count what it is
//! asked.

use core::cell::Cell;
use core::f64::consts::PI;
use core::ops::Range;

use cartcontact::Scalar;
use cartcontact::load::{Load, PiecewiseLinear};

/// A load given by its knots.
pub type Knots<T = f64> = PiecewiseLinear<T, Vec<(T, T)>>;

/// The load through `knots`.
///
/// # Panics
///
/// If no load has these knots.
#[must_use]
pub fn through<T: Scalar>(knots: &[(T, T)]) -> Knots<T> {
    PiecewiseLinear::new(knots.to_vec()).unwrap_or_else(|error| unreachable!("{knots:?}: {error}"))
}

/// Knots that divide a straight piece, from one knot to another, into so many parts.
pub fn along([start, end]: [(f64, f64); 2], parts: u32) -> impl Iterator<Item = (f64, f64)> {
    (0..=parts).map(move |part| {
        let share = f64::from(part) / f64::from(parts);
        (start.0 + (end.0 - start.0) * share, start.1 + (end.1 - start.1) * share)
    })
}

/// Named histories of piecewise-linear loads that never fall faster than e^(−χ t).
#[must_use]
pub fn histories(chi: f64) -> Vec<(&'static str, Knots)> {
    // F′ + χ F = 0 at the end of a fall from 100 to 80 that takes (100/80 − 1)/χ.
    let fastest_fall = 0.25 / chi;
    vec![
        ("constant", through(&[(0.0, 100.0)])),
        ("ramp from zero", through(&[(0.0, 0.0), (1.0 / chi, 100.0)])),
        ("ramp and hold", through(&[(0.0, 20.0), (0.1 / chi, 100.0), (0.3 / chi, 130.0)])),
        (
            "steps",
            through(&[
                (0.0, 50.0),
                (0.1 / chi, 50.0),
                (0.1 / chi, 75.0),
                (1.0 / chi, 75.0),
                (1.0 / chi, 200.0),
            ]),
        ),
        ("slow fall", through(&[(0.0, 100.0), (2.0 / chi, 60.0), (4.0 / chi, 90.0)])),
        ("fastest fall", through(&[(0.0, 100.0), (fastest_fall, 80.0), (2.0 / chi, 80.0)])),
    ]
}

/// A user-defined load with only the two required methods that rises exponentially to its final value.
#[derive(Clone, Copy, Debug)]
pub struct Rise<T> {
    /// The first force.
    pub start: T,
    /// The last force minus the first.
    pub rise: T,
    /// The rate of the exponential.
    pub rate: T,
}

impl<T: Scalar> Load<T> for Rise<T> {
    fn force(&self, t: T) -> T {
        self.start - self.rise * (-self.rate * t).exp_m1()
    }

    fn impulse(&self, t: T) -> T {
        self.start * t + self.rise * (t + (-self.rate * t).exp_m1() / self.rate)
    }
}

/// A user-defined load that falls exponentially.
#[derive(Clone, Copy, Debug)]
pub struct Fall<T> {
    /// The first force.
    pub force: T,
    /// The rate of the exponential.
    pub rate: T,
}

impl<T: Scalar> Load<T> for Fall<T> {
    fn force(&self, t: T) -> T {
        self.force * (-self.rate * t).exp()
    }

    fn impulse(&self, t: T) -> T {
        -self.force * (-self.rate * t).exp_m1() / self.rate
    }
}

/// A user-defined load that swings about its mean.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    /// The mean force.
    pub mean: f64,
    /// The amplitude.
    pub amplitude: f64,
    /// The angular frequency.
    pub frequency: f64,
}

impl<T: Scalar> Load<T> for Swing {
    fn force(&self, t: T) -> T {
        T::constant(self.mean) + T::constant(self.amplitude) * (T::constant(self.frequency) * t).sin()
    }

    fn impulse(&self, t: T) -> T {
        let frequency = T::constant(self.frequency);
        let half = (frequency * t * T::constant(0.5)).sin();
        T::constant(self.mean) * t + T::constant(2.0 * self.amplitude) * half * half / frequency
    }
}

impl Swing {
    /// The times in a range at which F′/χ + F is least, and those half-way between them.
    #[must_use]
    pub fn slowest_growths(&self, chi: f64, within: Range<f64>) -> Vec<f64> {
        // F′/χ + F swings with the phase ω t + φ, tan φ = ω/χ, and is least three quarters of a turn later.
        let phase = (self.frequency / chi).atan();
        let time = |half_turns: u32| ((0.5 + f64::from(half_turns)) * PI - phase) / self.frequency;
        (0..)
            .map(time)
            .skip_while(|&time| time < within.start)
            .take_while(|time| within.contains(time))
            .collect()
    }
}

/// A load that reports its knots and whether it is straight between them, and leaves the rest to the provided methods.
#[derive(Clone, Copy, Debug)]
pub struct Announced<L> {
    /// The load.
    pub load: L,
    /// Whether it says that it is straight between its knots.
    pub is_linear: bool,
}

impl<L> Announced<L> {
    /// A load that does not say that it is straight.
    pub fn curved(load: L) -> Self {
        Self { load, is_linear: false }
    }
}

impl<T: Scalar, L: Load<T>> Load<T> for Announced<L> {
    fn force(&self, t: T) -> T {
        self.load.force(t)
    }

    fn impulse(&self, t: T) -> T {
        self.load.impulse(t)
    }

    fn force_before(&self, t: T) -> T {
        self.load.force_before(t)
    }

    fn next_knot(&self, t: T) -> Option<T> {
        self.load.next_knot(t)
    }

    fn is_linear_between_knots(&self) -> bool {
        self.is_linear
    }
}

/// A load that reports only its force and its impulse.
#[derive(Clone, Copy, Debug)]
pub struct Unannounced<L>(pub L);

impl<T: Scalar, L: Load<T>> Load<T> for Unannounced<L> {
    fn force(&self, t: T) -> T {
        self.0.force(t)
    }

    fn impulse(&self, t: T) -> T {
        self.0.impulse(t)
    }
}

/// A load that counts how often its history is searched.
#[derive(Debug)]
pub struct CountingSearches<L> {
    load: L,
    searches: Cell<usize>,
}

impl<L> CountingSearches<L> {
    /// A load that has not been searched yet.
    pub fn new(load: L) -> Self {
        Self { load, searches: Cell::new(0) }
    }

    /// How often it was searched since the last call.
    pub fn searches(&self) -> usize {
        self.searches.take()
    }
}

impl<L: Load<f64>> Load<f64> for CountingSearches<L> {
    fn force(&self, t: f64) -> f64 {
        self.load.force(t)
    }

    fn impulse(&self, t: f64) -> f64 {
        self.load.impulse(t)
    }

    fn force_before(&self, t: f64) -> f64 {
        self.load.force_before(t)
    }

    fn next_knot(&self, t: f64) -> Option<f64> {
        self.load.next_knot(t)
    }

    fn is_linear_between_knots(&self) -> bool {
        self.load.is_linear_between_knots()
    }

    fn recession(&self, chi: f64, t: f64) -> Option<f64> {
        self.searches.set(self.searches.get() + 1);
        self.load.recession(chi, t)
    }
}

/// A load that counts how often it is asked for a force.
#[derive(Debug)]
pub struct CountingForces<L> {
    load: L,
    forces: Cell<usize>,
}

impl<L> CountingForces<L> {
    /// A load that has not been asked yet.
    pub fn new(load: L) -> Self {
        Self { load, forces: Cell::new(0) }
    }

    /// How often it was asked since the last call.
    pub fn forces(&self) -> usize {
        self.forces.take()
    }

    fn count(&self) {
        self.forces.set(self.forces.get() + 1);
    }
}

impl<T: Scalar, L: Load<T>> Load<T> for CountingForces<L> {
    fn force(&self, t: T) -> T {
        self.count();
        self.load.force(t)
    }

    fn impulse(&self, t: T) -> T {
        self.load.impulse(t)
    }

    fn force_before(&self, t: T) -> T {
        self.count();
        self.load.force_before(t)
    }

    fn next_knot(&self, t: T) -> Option<T> {
        self.load.next_knot(t)
    }

    fn is_linear_between_knots(&self) -> bool {
        self.load.is_linear_between_knots()
    }
}
