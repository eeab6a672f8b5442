//! However a program asks for terms and range, it gets only the faults of the profile.

use cartcontact::gap_profile;

#[gap_profile(0.025 * r^2 - 1e-4 * r^4)]
struct Unlimited;

#[gap_profile(0.025 r^2, max_radius = 6.0)]
struct Unread;

/// It has a symbol, and the unknown name may stand for it.
#[gap_profile(curvature * r^2)]
struct Ball {
    kappa: f64,
}

#[gap_profile(r^2/2R)]
#[allow(non_snake_case)]
struct Sphere {
    R: f64,
}

const EXPONENT: f64 = Unlimited::TERMS[0].1;
const _: () = assert!(Unread::MAX_RADIUS >= 5.0);
static COEFFICIENTS: [f64; Unlimited::TERMS.len()] = [0.0; 2];

fn main() {
    assert_eq!(Unlimited::TERMS, [(0.025, 2.0), (-1e-4, 4.0)]);
    let [(coefficient, exponent)] = Unread::TERMS;
    println!("{coefficient} {exponent} {EXPONENT} {COEFFICIENTS:?}");
    let [(coefficient, exponent)] = Ball { kappa: 0.025 }.terms::<f64>();
    println!("{coefficient} {exponent} {}", Unread::MAX_RADIUS.min(Unlimited::MAX_RADIUS));
    for (coefficient, exponent) in (Sphere { R: 20.0 }).terms::<f64>() {
        println!("{coefficient} {exponent}");
    }
}
