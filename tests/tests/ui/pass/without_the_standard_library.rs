#![no_std]
#![no_implicit_prelude]
#![forbid(unsafe_code)]
#![deny(missing_docs, unreachable_pub, warnings)]
//! A microcontroller's crate: no standard library, no prelude, no unsafe code, no warnings.

extern crate std;

/// The patella.
#[::cartcontact::gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct Patella;

/// A ball.
#[::cartcontact::gap_profile(r^2 / (2 * radius), max_radius = radius)]
pub struct Ball {
    /// Its radius, in mm.
    pub radius: f32,
}

fn main() {
    ::core::assert!(::cartcontact::GapProfile::<f32>::radius(&Patella, 1.0).is_ok());
    ::core::assert!(::cartcontact::GapProfile::<f32>::radius(&Ball { radius: 20.0 }, 1.0).is_ok());
}
