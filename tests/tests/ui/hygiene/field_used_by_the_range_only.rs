#![deny(warnings)]

use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^2 / (2 * radius), max_radius = limit)]
struct Ball {
    radius: f64,
    limit: f64,
}

fn main() {
    let ball = Ball { radius: 20.0, limit: 5.0 };
    assert_eq!(GapProfile::<f64>::max_radius(&ball), 5.0);
}
