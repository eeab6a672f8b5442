use cartcontact::gap_profile;

#[gap_profile(sphere(10) - r^2/20, order = 2, max_radius = 3)]
struct Knee;

#[gap_profile(sphere(10) - r^2/20, order = 4, max_radius = 3)]
struct Mended;

fn main() {}
