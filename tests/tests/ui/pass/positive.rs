use cartcontact::{Contact, GapProfile, Medium, gap_profile, load};

#[gap_profile(r^2 / (2 * radius) + k * r^4, positive)]
struct All {
    radius: f64,
    k: f64,
}

#[gap_profile(sphere(radius) + k * r^4, order = 6, positive = (radius, k), max_radius = radius / 2)]
struct Some<T> {
    radius: T,
    k: T,
    name: &'static str,
}

#[gap_profile(positive * r^2 - r^4 / 1e6, positive = positive, max_radius = 2)]
struct SameName {
    positive: f64,
}

macro_rules! two_symbols {
    ($($symbol:expr),*) => {
        #[gap_profile(c * r^2 + d * r^4, positive = ($($symbol),*))]
        struct Listed {
            c: f64,
            d: f64,
        }
    };
}

two_symbols!(c, d);

fn main() {
    let medium = Medium::from_constants(0.375, 0.0015).unwrap();
    let contact = Contact::new(All { radius: 20.0, k: 1e-5 }, medium, load::Constant(100.0)).unwrap();
    assert_eq!(GapProfile::<f64>::max_radius(contact.profile()), f64::INFINITY);
    let some = Some { radius: 20.0_f64, k: 1e-5, name: "worn" };
    assert_eq!((some.max_radius(), some.check(), some.name), (10.0, Ok(()), "worn"));
    assert_eq!(GapProfile::<f64>::max_radius(&Listed { c: 0.025, d: 1e-4 }), f64::INFINITY);
    assert_eq!(GapProfile::<f64>::max_radius(&SameName { positive: 1.0 }), 2.0);
}
