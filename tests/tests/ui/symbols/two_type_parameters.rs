use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(r^2 / (2 * first) + r^2 / (2 * second))]
struct Pair<T, U> {
    first: T,
    second: U,
}

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Pair { first: 20.0_f64, second: 10.0_f32 }, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
