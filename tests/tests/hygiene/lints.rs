//! What a program denies is not found in generated code, where nobody has written it.

#![deny(clippy::approx_constant)]

use super::radius;

/// Its coefficient is near π.
#[cartcontact::gap_profile(3.14159265358979 * r^2)]
struct NearPi;

/// The coefficient of its load integral is near 1/π.
#[cartcontact::gap_profile(0.9549 * r^4)]
struct NearItsInverse;

#[test]
fn coefficients_may_be_near_famous_numbers() {
    assert!(radius::<f64>(&NearPi) > 0.0 && radius::<f64>(&NearItsInverse) > 0.0);
}
