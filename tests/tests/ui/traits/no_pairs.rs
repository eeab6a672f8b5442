use cartcontact::Pairs;

fn polynomial(_terms: impl Pairs<f64>) {}

fn main() {
    polynomial([(0.025, 2)]);
    polynomial([[0.025, 2.0], [1e-4, 4.0]]);
}
