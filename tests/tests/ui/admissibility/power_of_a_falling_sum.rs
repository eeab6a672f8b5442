use cartcontact::gap_profile;

#[gap_profile((r^2 - r)^2)]
struct Knee;

#[gap_profile((2 * r - r^2) * (r + 1))]
struct Hip;

fn main() {}
