use cartcontact::load::{Constant, Load};

fn contact(_load: impl Load<f64>) {}

fn main() {
    contact(100.0);
    contact(Constant(100));
}
