use cartcontact::{GapProfile, gap_profile};

#[gap_profile(
    0.025 * r^2 /// of the ball
        + 1e-4 * r.^4
)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
