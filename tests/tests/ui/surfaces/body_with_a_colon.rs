use cartcontact::{GapProfile, gap_profile};

#[gap_profile(upper: sphere(10), lower = 0, order = 4)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
