use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(r^2 / (2 * radius) + k * r^4, positive(radius, k))]
struct Worn {
    radius: f64,
    k: f64,
    name: &'static str,
}

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let worn = Worn { radius: 20.0, k: 1e-5, name: "worn" };
    let contact = Contact::new(worn, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
