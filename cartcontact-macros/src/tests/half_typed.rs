//! Attributes and items in an editor, at every keystroke.

use proc_macro2::TokenStream;

use crate::expand;

const ATTRIBUTES: [&str; 6] = [
    "0.025 * r^2 + 1.09375e-4 * r^4, max_radius = 8, crate = ::cartcontact",
    "upper = sphere(10), lower = -conic(20, -0.4), order = auto, tolerance = 1e-3, max_radius = 5",
    "r^2/(2*radius) + k*r^4 - r^(1/2), positive = (radius, k), max_radius = 0.5 * radius",
    "2r^2 + sin(r) * a[0] - self.x ** 2 + r.powi(2) + 1.5.e3 mm^-1 , depth: 3, positive(a), max-radius 3",
    "top = sphere(R = 3), bottom = if x { 1 } else { 2 } , order 4 positive",
    "0,025 * r^2, gap(r) => r^2, \"r\", 'a', 0x10, 1_000, 2f32, r#type, a::b::C(3), -, ^, [, ",
];

const ITEMS: [&str; 8] = [
    "pub struct Ball<T: Copy, const N: usize = 3> where T: Clone { pub radius: T, #[doc = \"x\"] k: f32, n: [T; N] }",
    "struct G(f64, pub f32);",
    "struct G;",
    "enum A { B }",
    "union U { a: f64 }",
    "fn f() {}",
    "pub(crate) struct r#type<'a> { a: &'a f64 }",
    "",
];

/// The prefixes of a text that are tokens once their delimiters are closed.
fn beginnings(text: &str) -> impl Iterator<Item = TokenStream> {
    (0..=text.len()).filter_map(|end| closed(&text[..end]).parse().ok())
}

fn closed(text: &str) -> String {
    let mut open = Vec::new();
    for character in text.chars() {
        match character {
            '(' => open.push(')'),
            '[' => open.push(']'),
            '{' => open.push('}'),
            ')' | ']' | '}' => drop(open.pop()),
            _ => {}
        }
    }
    text.chars().chain(open.into_iter().rev()).collect()
}

#[test]
fn nothing_half_typed_panics() {
    for attribute in ATTRIBUTES.into_iter().flat_map(beginnings) {
        for item in ITEMS {
            drop(expand(attribute.clone(), item.parse().unwrap()));
        }
    }
    let with_fields: TokenStream = ATTRIBUTES[2].parse().unwrap();
    for item in ITEMS.into_iter().flat_map(beginnings) {
        drop(expand(with_fields.clone(), item));
    }
}
