use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere(10), order = 4, tolerance = 1e-3, max_radius = 11)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
