use cartcontact::{Contact, Medium, gap_profile, load};

#[gap_profile(2r^2 + sin(r) + raduis * r - name * r + r^radius + r^-1, depth = 3, max_radius = 0)]
struct Ball {
    radius: f64,
    name: String,
}

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(Ball { radius: 20.0, name: String::new() }, medium, load::Constant(100.0_f64)).unwrap();
    let _ = contact.at(200.0).unwrap().peak_pressure();
}
