use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere(10) - conic(10, -1e-300), order = 128)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
