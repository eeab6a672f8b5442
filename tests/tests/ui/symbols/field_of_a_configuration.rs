use cartcontact::gap_profile;

#[gap_profile(r^2 / (2 * radius))]
struct Ball {
    #[cfg(debug_assertions)]
    radius: f64,
    #[cfg(not(debug_assertions))]
    radius: f32,
}

fn main() {}
