#![deny(warnings)]
#![allow(non_snake_case)]

use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^2 / (2 * T))]
struct Ball {
    T: f64,
}

fn main() {
    assert!(GapProfile::<f64>::radius(&Ball { T: 20.0 }, 1.0).is_ok());
}
