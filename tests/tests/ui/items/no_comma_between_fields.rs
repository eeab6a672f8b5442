use cartcontact::gap_profile;

#[gap_profile(c * r^2 + d * r^4)]
struct Knee {
    c: f64
    d: f64,
}

fn main() {}
