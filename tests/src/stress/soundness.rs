//! For any input: no panic, no result that is not a number, no negative pressure, and a pressure that carries the load.
//!
//! The fuzz target and a seeded test draw their input from words in the same way, so that each reaches what the other
//! does.

use super::examine::{Depth, examine};
use super::finding::{Fault, Findings, Quantity, Tally};
use super::precision::Precision;
use super::scene::{Form, Scene};

/// The share of the load by which a balance may be off, in ε: 1e-13 in f64.
///
/// Of a hundred thousand scenes none was off by more than 8, but some of their numbers are arbitrary, and fuzzing draws
/// many more. The worst in the seeded test is 3.0; the campaign compares with the table.
const BALANCE: f64 = 450.0;

/// A scene from any sequence of words: most numbers are like those of a joint, some are arbitrary.
pub fn scene<T: Precision>(word: &mut dyn FnMut() -> u64) -> Scene<T> {
    let terms = (0..=word() % 6).map(|_| (number(word()), exponent(word()))).collect();
    let max_radius = word().is_multiple_of(8).then(|| number::<T>(word()).abs());
    let (m, chi) = (number::<T>(word()).abs(), number::<T>(word()).abs());
    let mut time = T::zero();
    let knots = (0..=word() % 6).map(|index| {
        let step = word();
        time += if index == 0 || step.is_multiple_of(4) { T::zero() } else { number::<T>(step).abs() };
        (time, number::<T>(word()).abs())
    });
    let knots = knots.collect();
    let inset = (word() % 1000) as f64 / 1000.0;
    Scene { form: Form::Polynomial, terms, max_radius, m, chi, knots, time: number::<T>(word()).abs(), inset }
}

/// In three of four cases a number up to 1023 times a power of ten, else any bits.
fn number<T: Precision>(word: u64) -> T {
    if word.is_multiple_of(4) {
        return T::from_leading_bits(word);
    }
    let digits = (word >> 2 & 0x3ff) as f64;
    let power = (word >> 12 & 0x1f) as f64 - 16.0;
    let sign = if (word >> 17).is_multiple_of(8) { -1.0 } else { 1.0 };
    T::constant(sign * digits * 10_f64.powf(power / 2.0))
}

/// Mostly a multiple of 1/4 up to 16, never below 0.
fn exponent<T: Precision>(word: u64) -> T {
    let quarters = 1 + (word >> 2 & 0x3f);
    match word % 4 {
        0 => number::<T>(word >> 2).abs(),
        1 => T::constant(quarters as f64),
        _ => T::constant(quarters as f64 / 4.0),
    }
}

/// Computes a scene and returns its outcome; panics are left to the caller.
///
/// # Errors
///
/// The first unsound result, as text.
pub fn check<T: Precision>(scene: &Scene<T>) -> Result<Tally, String> {
    let allowed = T::allowed(Quantity::Balance.allowance());
    let mut worst = Unsound { allowed, outcome: Tally::Refused, found: None };
    examine(scene, Depth { memory: false, balance: true }, &mut worst);
    worst.found.map_or(Ok(worst.outcome), |text| Err(format!("{text}\n{scene:?}")))
}

/// The first finding that makes a result unsound.
struct Unsound {
    /// The error that the table allows for a balance, in ε.
    allowed: f64,
    outcome: Tally,
    found: Option<String>,
}

impl Findings for Unsound {
    fn count(&mut self, tally: Tally) {
        if tally != Tally::Units {
            self.outcome = tally;
        }
    }

    fn error(&mut self, quantity: Quantity, share: f64) {
        let error = share * self.allowed;
        if quantity == Quantity::Balance && error > BALANCE {
            self.found.get_or_insert_with(|| format!("the pressure carries another load, by {error:e} ε"));
        }
    }

    fn fault(&mut self, fault: Fault, about: &dyn core::fmt::Display) {
        if matches!(fault, Fault::NotANumber | Fault::NegativePressure) {
            self.found.get_or_insert_with(|| format!("{}: {about}", fault.name()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_sound<T: Precision>(
        (c, n): (f64, f64),
        (m, chi): (f64, f64),
        knots: &[(f64, f64)],
        (time, inset): (f64, f64),
    ) {
        let scene = Scene::<T> {
            form: Form::Polynomial,
            terms: vec![(T::constant(c), T::constant(n))],
            max_radius: None,
            m: T::constant(m),
            chi: T::constant(chi),
            knots: knots.iter().map(|&(t, force)| (T::constant(t), T::constant(force))).collect(),
            time: T::constant(time),
            inset,
        };
        let found = check(&scene);
        assert!(found.is_ok(), "{}", found.err().unwrap_or_default());
    }

    /// Found by fuzzing: slopes that lose digits once a load has drained, C aⁿ⁺² and a² P beyond the largest number,
    /// a force and an impulse that round to zero beside their sum, which does not, K below the smallest number, χ F below
    /// it while F is not, and a load that would round to none.
    #[test]
    fn scenes_at_the_ends_of_the_formats_are_sound() {
        let drained = (32_350_100_463.522_52, 0.237);
        let held = [(0.0, 2.860_840_130_871_601_3e-283)];
        assert_sound::<f64>((1.76, 2.525_301_555_949_885_7e-302), (drained.0, 0.0417), &held, drained);
        let falling = [(0.0, 6.770_423_4e22), (189_104.2, 578.0), (294_104.2, 88e3), (382_104.2, 88e3)];
        assert_sound::<f32>(
            (9.445_885e21, 1.555_755_2e-36),
            (189_104.2, 141.986_27),
            &falling,
            (578.0, 0.99),
        );
        let held = [(0.0, 3.376_252e38)];
        assert_sound::<f32>(
            (2.478_433e17, 1.432_511_7e-3),
            (48.747_055, 1.44e-4),
            &held,
            (3.345_713e-11, 0.943),
        );
        let stepped = [(0.0, 0.0), (18_183_096.5, 2.121_995_791e-314), (18_183_096.5, 101_509.1)];
        assert_sound::<f64>((1.2e163, 12.75), (1.12e8, 2.06e283), &stepped, (5e-7, 0.405));
        let held = [(0.0, 2.223_081_2e-3)];
        assert_sound::<f32>((7.741_458e31, 8.217_346e-34), (2.207_738_6e-18, 1.36e-5), &held, (0.0, 0.09));
        let risen = [(0.0, 0.0), (3.235_01e10, 2.52e-43), (3.235_01e10, 3.365_909_2e-7)];
        assert_sound::<f32>((3.9e-7, 13.25), (31.0, 4.656_613e-10), &risen, (3.235_01e10, 0.54));
        let rising = [(0.0, 0.0), (3.235_01e10, 2.231_458e-38)];
        assert_sound::<f32>((1.510_000_6e-10, 25.0), (0.115_734_1, 3850.0), &rising, (578.0, 0.65));
    }
}
