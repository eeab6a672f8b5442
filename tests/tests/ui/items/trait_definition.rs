use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2)]
trait Knee {}

fn main() {
    let _ = <cartcontact::Polynomial<f64, [(f64, f64); 1]> as GapProfile<f64>>::gap;
}
