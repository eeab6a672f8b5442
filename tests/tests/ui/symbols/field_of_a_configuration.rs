use cartcontact::gap_profile;

#[gap_profile(r^2 / (2 * radius))]
struct Ball {
    #[cfg(feature = "double")]
    radius: f64,
    #[cfg(not(feature = "double"))]
    radius: f32,
}

fn main() {}
