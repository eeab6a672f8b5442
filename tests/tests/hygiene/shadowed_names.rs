//! Items and macros in scope that are named like those of the standard library or of generated code.

#![allow(dead_code, non_upper_case_globals, unused_macros, reason = "what is here is in the way on purpose")]

use super::assert_ball;

struct Some;
struct None;
struct Ok;
struct Err;
struct Option;
struct Result;
struct Copy;
struct Iterator;
struct Exponent;
struct Scalar;
struct GapProfile;
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

/// Needs Newton's method, a range, fields and negative terms.
#[::cartcontact::gap_profile(r^2 / (2 * radius) - r^4 / (1e30 * radius) + r^2.5 / 1e30, max_radius = radius)]
struct Ball {
    radius: f64,
}

/// A type in bounds that is named like the parameter of generated code.
type T = f64;

#[::cartcontact::gap_profile(r^2 / 40)]
struct Converted<U: ::core::convert::From<T>, V>
where
    V: ::core::convert::Into<r#T>,
{
    of: ::core::marker::PhantomData<(U, V)>,
}

/// Parameters that are named like items of generated code, for a geometry with a table.
#[::cartcontact::gap_profile(r^2 / 40 + r^4 / 1e30)]
struct Counted<const TABLE: usize, const steepness: usize>;

/// The same for coefficients that are computed.
#[::cartcontact::gap_profile(r^2 / (2 * radius) + r^4 / 1e30)]
struct Computed<const coefficients: usize, const steepness: usize> {
    radius: f64,
}

#[test]
fn names_in_scope_are_not_used() {
    let converted: Converted<f64, f32> = Converted { of: ::core::marker::PhantomData };
    assert_ball::<f64>(&Ball { radius: 20.0 });
    assert_ball::<f64>(&converted);
    assert_ball::<f64>(&Counted::<1, 2>);
    assert_ball::<f64>(&Computed::<1, 2> { radius: 20.0 });
}
