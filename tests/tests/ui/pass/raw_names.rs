use cartcontact::{GapProfile, gap_profile};

#[gap_profile(r^2 / (2 * radius) + r#type * r^4, positive = (radius, type))]
struct Ball {
    r#radius: f64,
    r#type: f64,
}

fn main() {
    assert_eq!(GapProfile::<f64>::max_radius(&Ball { radius: 20.0, r#type: 1e-4 }), f64::INFINITY);
}
