use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere(radius), order = 4, max_radius = 2 * radius)]
struct Ball {
    radius: f64,
}

#[gap_profile(sphere(10) + k^2 * r^2, order = 4, max_radius = 12)]
struct Worn {
    k: f64,
}

fn main() {
    let _: f64 = Ball { radius: 20.0 }.gap(1.0);
    let _: f64 = Worn { k: 1.0 }.gap(1.0);
}
