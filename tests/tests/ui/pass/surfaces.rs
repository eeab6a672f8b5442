use cartcontact::gap_profile;

#[gap_profile(sphere(10) - sphere(20), order = 4)]
struct Expression;

#[gap_profile(upper = sphere(10), lower = -sphere(20), order = 4)]
struct Bodies;

#[gap_profile(sphere(radius), order = 6)]
struct Ball {
    radius: f64,
}

fn main() {
    // Gap (29) of the paper.
    assert_eq!(Expression::TERMS, [(0.025, 2.0), (1.09375e-4, 4.0)]);
    assert_eq!(Bodies::TERMS, Expression::TERMS);
    let gap: f64 = cartcontact::GapProfile::gap(&Ball { radius: 1.0 }, 0.5);
    assert_eq!(gap, 0.5 / 4.0 + 0.125 / 16.0 + 0.0625 / 64.0);
}
