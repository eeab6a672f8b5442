//! User-defined loads on a gap that is admissible only by a millionth: where δ₀′ nearly vanishes, the rounding of a
//! load integral moves the radius by a hundred thousand of its own roundings, and this must not shorten the steps of
//! the load.

use cartcontact::{ContactError, GapProfile, Polynomial, gap_profile};
use tests::budget;
use tests::condition::{edge, of_radius, of_sizes};
use tests::loads::{CountingForces, Unannounced, through};
use tests::measure::Errors;
use tests::planted;

/// δ₀′ = a (1 − 2 (a/7) + 1.000001 (a/7)²).
#[gap_profile(r^2 - 5/21 * r^3 + 0.75 * 1.000001 / 49 * r^4)]
struct NearlyFlat;

/// Where δ₀′/a is least.
const FLATTEST: f64 = 7.0;

const CHI: f64 = 0.0015;

/// The time at which the last force is reached and the pressure is taken.
const END: f64 = 200.0;

#[test]
fn pressures_are_those_of_a_straight_load_and_take_few_forces() -> Result<(), ContactError> {
    let load = through(&[(0.0, 50.0), (END, 100.0)]);
    let mut errors = Errors::of(budget::PRESSURE);
    for end in [6.5, 6.9, 6.99, 6.998, 6.999, 7.0, 7.001, 7.01, 7.5] {
        let straight = planted::contact(NearlyFlat, &load, CHI, end, END)?;
        // Followed like a load that is not straight.
        let curved = CountingForces::new(Unannounced(&load));
        let curved = planted::contact(NearlyFlat, curved, CHI, end, END)?;
        let (expected, found) = (straight.at(END)?, curved.at(END)?);
        let a = expected.radius();
        // Radii that the contact has passed count too: the condition is that at the flattest of them.
        let condition = of_radius(&NearlyFlat, &of_sizes(&NearlyFlat::TERMS), a.min(FLATTEST));
        for share in [0.0, 0.5, 0.9, 0.99, 0.999, 0.99999] {
            curved.load().forces();
            let r = share * a;
            errors.add(found.pressure(r), expected.pressure(r), condition * edge(a, r), &(end, share));
            let forces = curved.load().forces();
            assert!(forces < 5000, "{end}, {share}: {forces} forces");
        }
    }
    errors.check();
    Ok(())
}

/// Where the last term first exceeds either of two negative ones, the first term still hides that both together exceed
/// it.
#[test]
fn the_last_term_has_to_outweigh_all_negative_ones() {
    // 2 C n/(n+2) is 3/2, −1, −1 and 1: δ₀′ vanishes near 1.08.
    let negative = (-11.9 / 19.8, 9.9);
    let terms = [(1.5, 2.0), negative, negative, (0.6, 10.0)];
    let end = Polynomial::new(terms).map_or(f64::NAN, |gap| gap.max_radius());
    assert!(1.0 < end && end < 1.3, "{end}");
}
