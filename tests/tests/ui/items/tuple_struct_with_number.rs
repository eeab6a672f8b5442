use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^2 / (2 * self.0))]
struct Ball(f64);

fn contact_radius(ball: &Ball) -> f64 {
    GapProfile::<f64>::max_radius(ball)
}

fn main() {
    let _ = contact_radius;
}
