use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2 + 3)]
struct Knee;

#[gap_profile(x^2)]
struct Hip;

fn main() {
    let _ = GapProfile::<f64>::radius(&Knee, 1.0);
    let _ = GapProfile::<f64>::radius(&Hip, 1.0);
}
