use cartcontact::gap_profile;

#[gap_profile(sphere(1000), order = 128, max_radius = 6)]
struct Knee;

fn main() {}
