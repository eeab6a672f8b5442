use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(r^2/2R + r^4/8 R^3)]
#[allow(non_snake_case)]
struct Ball {
    R: f64,
}

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Ball { R: 20.0 }, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
