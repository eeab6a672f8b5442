use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2 + 1.09375e - 4 * r^4)]
struct Knee;

#[gap_profile(1.5e+ * r^2)]
struct Hip;

#[gap_profile(r^2/2e−4)]
struct Ankle;

fn main() {
    let _: [f64; 3] = [Knee.gap(1.0), Hip.gap(1.0), Ankle.gap(1.0)];
}
