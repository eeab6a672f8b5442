use cartcontact::{GapProfile, gap_profile};

#[gap_profile(k * r^2 + c * r^4)]
struct Knee {
    k: f64;
    c: f64
}

fn main() {
    let _: f64 = Knee { k: 1.0, c: 1.0 }.gap(1.0);
}
