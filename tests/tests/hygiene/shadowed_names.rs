//! Items and macros in scope that are named like those of the standard library or of generated code.

#![allow(dead_code, unused_macros, reason = "what is here is in the way on purpose")]

use super::{OF_BALL, radius};

struct Some;
struct None;
struct Ok;
struct Err;
struct Option;
struct Result;
struct Copy;
struct Iterator;
struct Scalar;
struct GapProfile;
struct PositiveTerm;
#[allow(non_camel_case_types, reason = "it is in the way on purpose")]
struct bool;
mod core {}
mod generated {}
fn coefficients() {}
fn invert() {}
fn limit() {}

trait Constant {
    fn constant(self) -> Self;
    fn gap(&self) {}
    fn radius(&self) {}
}

impl Constant for f64 {
    fn constant(self) -> Self {
        f64::NAN
    }
}

macro_rules! vec {
    () => {
        compile_error!("not this one")
    };
}

/// Newton's method, a range, fields and negative terms.
#[::cartcontact::gap_profile(r^2 / (2 * radius) - r^4 / (1e30 * radius) + r^2.5 / 1e30, max_radius = radius)]
struct Ball {
    radius: f64,
}

#[test]
fn names_in_scope_are_not_used() {
    assert!((radius::<f64>(&Ball { radius: 20.0 }) / OF_BALL - 1.0).abs() < 1e-12);
}
