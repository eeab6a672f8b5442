use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2)]
struct Knee(f64);

fn contact_radius(knee: &Knee) -> f64 {
    GapProfile::<f64>::max_radius(knee)
}

fn main() {
    let _ = contact_radius;
}
