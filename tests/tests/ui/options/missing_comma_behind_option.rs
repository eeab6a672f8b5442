use cartcontact::{GapProfile, gap_profile};

#[gap_profile(max_radius = 6 0.025 * r^2)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
