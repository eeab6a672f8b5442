use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere(10), order = auto)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
