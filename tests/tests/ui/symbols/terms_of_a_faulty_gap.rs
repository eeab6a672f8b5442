use cartcontact::gap_profile;

#[gap_profile(r^2 / (2 * raduis))]
struct Ball {
    radius: f64,
}

fn main() {
    let ball = Ball { radius: 20.0 };
    println!("{:?}", ball.terms::<f64>());
}
