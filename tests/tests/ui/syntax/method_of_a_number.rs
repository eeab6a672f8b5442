use cartcontact::gap_profile;

#[gap_profile(2.0.sqrt() * r^2 + 3.powi(2) * r^4)]
struct Knee;

fn main() {}
