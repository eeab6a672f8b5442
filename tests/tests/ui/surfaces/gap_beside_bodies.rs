use cartcontact::{GapProfile, gap_profile};

#[gap_profile(upper = sphere(10), lower = 0, order = 4, 0.025 * r^2)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
