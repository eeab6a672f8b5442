//! Lints that a program denies find nothing in generated code.

#![deny(
    clippy::approx_constant,
    deprecated,
    non_camel_case_types,
    non_snake_case,
    single_use_lifetimes,
    unfulfilled_lint_expectations
)]

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

/// Only the generated code uses the struct and its fields.
#[cartcontact::gap_profile(curvature * r^2, max_radius = end)]
#[deprecated]
#[allow(dead_code, reason = "not all of it is read")]
struct Old {
    #[deprecated]
    curvature: f64,
    #[deprecated]
    end: f64,
}

/// The struct uses its lifetime twice, generated code only once.
#[cartcontact::gap_profile(curvature * r^2)]
#[allow(dead_code, reason = "not all of it is read")]
struct Borrowed<'a> {
    curvature: f64,
    name: &'a str,
    other: &'a str,
}

#[cartcontact::gap_profile(r^2 / (2 * R))]
#[allow(non_camel_case_types, reason = "as a symbol")]
#[expect(non_snake_case, reason = "as printed in the paper")]
struct Ball<real> {
    R: real,
}

/// The attribute is no use of a struct: the compiler still finds it unused.
#[cartcontact::gap_profile(curvature * r^2)]
#[expect(dead_code, reason = "nothing makes one")]
struct Unused {
    curvature: f64,
}

#[test]
fn lints_about_the_struct_concern_the_struct_alone() {
    let borrowed = Borrowed { curvature: 0.025, name: "", other: "" };
    assert!(radius::<f64>(&borrowed) > 0.0 && radius(&Ball { R: 20.0 }) > 0.0);
}
