use cartcontact::{GapProfile, gap_profile};

#[gap_profile(0.025 * r^2)]
fn knee() {}

fn main() {
    knee();
    let _ = <cartcontact::Polynomial<f64, [(f64, f64); 1]> as GapProfile<f64>>::gap;
}
