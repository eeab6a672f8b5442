use cartcontact::gap_profile;

#[gap_profile(conic(15, -0.5) - conic(16.5, 4), order = 4)]
struct Knee;

#[gap_profile(conic(15, -0.5) - conic(16.5, 4), order = 4, max_radius = 3.26)]
struct Mended;

fn main() {}
