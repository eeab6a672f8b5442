use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(0.025 * r^2 + 1e-4 * r^4 - 2e-4 * r^4)]
struct Knee;

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Knee, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
