use cartcontact::gap_profile;

#[gap_profile(sphere(20) - sphere(10), order = 4, max_radius = 5)]
struct Knee;

#[gap_profile(upper = sphere(20), lower = -sphere(10), order = auto, tolerance = 1e-3, max_radius = 5)]
struct Hip;

fn main() {}
