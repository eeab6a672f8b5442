use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^3 / 6 + kr^2)]
struct Knee {
    k: f64,
}

fn main() {
    let _: f64 = Knee { k: 0.025 }.gap(1.0);
}
