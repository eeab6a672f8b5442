//! Geometries with so many terms that the generated code holds their constants in tables instead of writing them out, or
//! with such high powers that slopes and drops are summed at several radii at a time.

use cartcontact::load::Constant;
use cartcontact::{Contact, GapProfile, Medium, Polynomial, gap_profile};
use tests::budget::{self, Allowance};
use tests::condition::edge;
use tests::kernel::{self, Kernel};
use tests::measure::relative_error;

/// Even powers up to the 24th.
#[gap_profile(sphere(10) + sphere(20), order = 24, max_radius = 5)]
struct Spheres;

/// Even powers up to the 64th, whose coefficients fall to 2e-85.
#[gap_profile(sphere(20), order = 64, max_radius = 10)]
struct HighOrder;

/// All powers from the second to the 13th.
#[gap_profile(0.05*r^2 + 1e-3*r^3 + 1e-4*r^4 + 2e-5*r^5 + 1e-6*r^6 + 1e-7*r^7 + 1e-8*r^8 + 3e-9*r^9 + 1e-10*r^10
    + 2e-12*r^11 + 1e-13*r^12 + 1e-15*r^13)]
struct Dense;

/// One power far above the others.
#[gap_profile(0.05*r + 1e-2*r^2 + 1e-3*r^3 + 1e-4*r^4 + 2e-5*r^5 + 1e-6*r^6 + 1e-7*r^7 + 1e-8*r^8 + 3e-9*r^9
    + 1e-40*r^48, max_radius = 5)]
struct FarApart;

/// Both parities, most powers missing.
#[gap_profile(0.05*r + 1e-3*r^3 + 1e-5*r^5 + 1e-10*r^10 + 1e-14*r^15 + 1e-16*r^20)]
struct WideGaps;

/// Odd powers, whose load integral is odd, too.
#[gap_profile(1e-12*r^21 + 1e-14*r^23)]
struct HighOdd;

/// Compares everything with the same geometry as a `Polynomial`, whose weights are formed in double words; either may
/// be off by the allowance.
fn compare<P: GapProfile<f64>>(profile: P, terms: &[(f64, f64)]) {
    let polynomial = Polynomial::with_max_radius(terms, 5.0).unwrap_or_else(|error| unreachable!("{error}"));
    let assert_near = |found: f64, expected: f64, allowance: Allowance, condition: f64| {
        let error = relative_error(found, expected, f64::EPSILON);
        let Allowance { quantity, double, .. } = allowance;
        assert!(error <= 2.0 * double * condition, "{quantity}: {found:e} is off by {error} ε");
    };
    let close = |found, expected, allowance| assert_near(found, expected, allowance, 1.0);
    let mut targets = Vec::new();
    for a in (1..=48).map(|k| 0.1 * f64::from(k)) {
        for Kernel { allowance, double, .. } in kernel::ALL {
            close(double(&profile, a, 0.6 * a), double(&polynomial, a, 0.6 * a), allowance);
        }
        targets.push(polynomial.load_integral(a));
    }
    let mut radii = vec![0.0; targets.len()];
    profile.radii(&targets, &mut radii).unwrap_or_else(|error| unreachable!("{error}"));
    for (&radius, &target) in radii.iter().zip(&targets) {
        close(radius, polynomial.radius(target).unwrap_or(f64::NAN), budget::RADIUS);
    }
    let medium = Medium::from_constants(2.0, 1e-2).unwrap_or_else(|error| unreachable!("{error}"));
    // The pressure includes a memory integral.
    let radius_and_pressure = |profile: &dyn GapProfile<f64>| {
        let contact = Contact::new(profile, medium, Constant(20.0));
        let now = contact.and_then(|contact| contact.at(30.0).map(|now| (now.radius(), now.pressure(1.0))));
        now.unwrap_or_else(|error| unreachable!("{error}"))
    };
    let ((radius, found), (_, expected)) = (radius_and_pressure(&profile), radius_and_pressure(&polynomial));
    assert_near(found, expected, budget::PRESSURE, edge(radius, 1.0));
}

#[test]
fn long_sums_are_those_of_their_terms() {
    compare(Spheres, &Spheres::TERMS);
    compare(HighOrder, &HighOrder::TERMS);
    compare(Dense, &Dense::TERMS);
    compare(FarApart, &FarApart::TERMS);
    compare(WideGaps, &WideGaps::TERMS);
    compare(HighOdd, &HighOdd::TERMS);
}
