use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere(10) - sphere(20), order = 4, tolerance = 1e-6, max_radius = 5)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
