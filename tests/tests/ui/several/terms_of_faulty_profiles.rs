//! Items that a program asks of the type exist, and items of its own are no second definitions.

use cartcontact::gap_profile;

/// Its own constant has a name that only a gap without fields takes.
#[gap_profile(2r^2 / radius)]
struct Ball {
    radius: f64,
}

impl Ball {
    const MAX_RADIUS: f64 = 6.0;
}

/// The same for a gap in two bodies, of any scalar.
#[gap_profile(upper = r^2 / radius, lower = sin(r))]
struct Any<T> {
    radius: T,
}

/// Its own method has a name that only a gap of fields takes.
#[gap_profile(2r^2, max_radius = 6.0)]
struct Flat {
    name: String,
}

impl Flat {
    fn terms(&self) -> usize {
        Flat::TERMS.len() + self.name.len()
    }
}

/// A field that only the range names makes no gap of fields.
#[gap_profile(0.025*r^2 + , max_radius = end)]
struct Limited {
    end: f64,
}

fn main() {
    println!("{} {}", Limited::TERMS.len(), Limited { end: 6.0 }.end);
    for (coefficient, exponent) in (Ball { radius: Ball::MAX_RADIUS }).terms::<f64>() {
        println!("{coefficient} r^{exponent}");
    }
    for (coefficient, exponent) in (Any { radius: 20.0_f32 }).terms() {
        println!("{coefficient} r^{exponent}");
    }
    println!("{} {}", Flat { name: String::new() }.terms(), Flat::MAX_RADIUS);
}
