//! A knot on a straight piece of a load changes no pressure, also under terms of both signs, where the edge may spread
//! faster in the middle of a piece than at both ends.

use cartcontact::{ContactError, Polynomial};
use tests::budget;
use tests::condition::edge;
use tests::loads::{Knots, along, through};
use tests::measure::{relative_error, ulps};
use tests::planted;

/// One straight piece of a load.
struct Piece {
    /// The gap, on its whole admissible range.
    terms: &'static [(f64, f64)],
    /// The contact radius before it.
    start: f64,
    /// χ times its duration.
    folds: f64,
    /// The force at its end over that at its beginning.
    growth: f64,
}

const PIECES: [Piece; 7] = [
    // Held: the edge spreads fastest where s⁴ δ₀′ is greatest.
    Piece { terms: &[(3.42, 2.0), (-84.2, 63.0)], start: 0.588, folds: 14.05, growth: 1.0 },
    Piece { terms: &[(2.12, 2.0), (-0.75, 3.0)], start: 1.108, folds: 21.05, growth: 1.0 },
    Piece { terms: &[(0.842, 2.0), (-1.65e7, 24.0)], start: 0.262, folds: 19.9, growth: 1.0 },
    // δ₀′ nearly vanishes on the way.
    Piece { terms: &[(1.0, 2.0), (-0.01195, 7.0), (5.14e-5, 12.0)], start: 1.265, folds: 19.5, growth: 1.0 },
    // Rising.
    Piece { terms: &[(0.842, 2.0), (-1.65e7, 24.0)], start: 0.264, folds: 18.95, growth: 1.008 },
    Piece { terms: &[(4.1e6, 4.0), (-3.75e10, 12.0)], start: 0.192, folds: 20.95, growth: 1.112 },
    // Falling, with a pair of complex singularities.
    Piece { terms: &[(1.0, 2.0), (-0.01195, 7.0), (5.14e-5, 12.0)], start: 2.545, folds: 3.0, growth: 0.609 },
];

const SHARES: [f64; 5] = [0.0, 0.3, 0.6, 0.9, 0.99];

impl Piece {
    /// The contact radius at its end, and the pressures at some shares of that, if the piece has knots that divide it
    /// into so many parts. Nothing but shares counts, so that χ and the first force are 1.
    fn pressures(&self, parts: u32) -> Result<(f64, [f64; 5]), ContactError> {
        let piece = [(0.0, 1.0), (self.folds, self.growth)];
        let load = through(&along(piece, parts).collect::<Vec<_>>());
        let contact = planted::contact(Polynomial::new(self.terms)?, load, 1.0, self.start, 0.0)?;
        let now = contact.at(self.folds)?;
        Ok((now.radius(), SHARES.map(|share| now.pressure(share * now.radius()))))
    }
}

/// Both results may be off by as much as documented, without the condition number that the bound has under terms of
/// both signs.
#[test]
fn a_piece_is_the_sum_of_its_parts() -> Result<(), ContactError> {
    for piece in &PIECES {
        let (a, whole) = piece.pressures(1)?;
        for parts in [2, 8, 64] {
            let (_, in_parts) = piece.pressures(parts)?;
            for ((share, whole), in_parts) in SHARES.into_iter().zip(whole).zip(in_parts) {
                let error = relative_error(whole, in_parts, f64::EPSILON);
                let allowed = 2.0 * budget::PRESSURE.double * edge(a, share * a);
                assert!(error < allowed, "{:?}, {parts} parts, {share}: {error} ε", piece.terms);
            }
        }
    }
    Ok(())
}

/// A load that falls to nearly nothing and then rises along a line, with knots that divide the rise into so many parts.
fn fall_and_rise(folds: f64, parts: u32) -> Knots {
    let (end, last) = (24.0, 1e-4_f64);
    let fall = (0..12).map(|k| (2.0 * f64::from(k), last.powf(f64::from(k) / 12.0)));
    let rise = along([(end, last), (end + folds, 0.3)], parts);
    through(&fall.chain(rise).collect::<Vec<_>>())
}

/// Continued backwards, Y stands still just before such a rise: there ages are a square root of the radius.
#[test]
fn a_rise_from_next_to_nothing_is_the_sum_of_its_parts() -> Result<(), ContactError> {
    for exponent in [0.5, 2.0, 4.0, 24.75] {
        for folds in [0.5, 1.0, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0] {
            let peak = |parts| -> Result<f64, ContactError> {
                let (gap, load) = (Polynomial::new([(1.0, exponent)])?, fall_and_rise(folds, parts));
                let end = 24.0 + folds;
                Ok(planted::contact(gap, load, 1.0, 1.0, end)?.at(end)?.peak_pressure())
            };
            let error = ulps(peak(1)?, peak(64)?.into(), f64::EPSILON);
            assert!(error <= 2.0 * budget::PEAK_PRESSURE.double, "r^{exponent}, {folds}: {error} ulp");
        }
    }
    Ok(())
}
