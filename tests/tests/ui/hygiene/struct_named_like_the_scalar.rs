#![deny(warnings)]

use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^2 / 40)]
struct T;

fn main() {
    assert!(T.radius(1.0_f64).is_ok());
}
