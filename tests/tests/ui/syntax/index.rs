use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(c[0] * r^2 + c[1] * r^4)]
struct Knee {
    c: [f64; 2],
}

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Knee { c: [0.025, 1e-4] }, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
