use cartcontact::{GapProfile, gap_profile};

#[gap_profile(sphere = 20, order = 4)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
