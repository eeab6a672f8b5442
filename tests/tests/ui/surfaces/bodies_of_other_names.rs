use cartcontact::{GapProfile, gap_profile};

#[gap_profile(femur = sphere(20,5), tibia = conic(R = 30, k = -0.5), order = 4)]
struct Knee;

fn main() {
    let _: f64 = Knee.gap(1.0);
}
