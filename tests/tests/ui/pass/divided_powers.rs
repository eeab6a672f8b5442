use cartcontact::{Contact, Medium, gap_profile, load};

// Only an exponent of 1 before a division is refused.
#[gap_profile(r^2/20 + r^3/2e3 + r^1.5/40 + r/1e3 + (r^1)/2e3)]
struct Knee;

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Knee, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
