//! Whole expansions compared with those in `golden/`; `UPDATE_GOLDEN=1` renews them.

use std::path::Path;
use std::{env, fs};

use crate::expand;

/// Name, attribute and item.
const CASES: [[&str; 3]; 14] = [
    ["one_term", "0.025 * r^2", "/// A paraboloid.\npub struct Paraboloid;"],
    ["even_powers", "0.025 * r^2 + 1.09375e-4 * r^4", "struct Patellofemoral;"],
    ["many_terms", "sphere(10) + sphere(20), order = 24, max_radius = 5", "struct Spheres;"],
    ["negative_term", "0.05*r^2 - 0.004*r^3 + 2e-4*r^4, max_radius = 20.0", "struct MixedSign;"],
    ["halves", "0.01*r^1.5 + 0.003*r^2.5", "struct Halves;"],
    ["one_field", "r^2 / (2 * radius)", "struct Ball { radius: f64 }"],
    ["real_powers", "0.01*r^1.5 + 0.002*r^3.25", "struct RealPowers;"],
    [
        "fields",
        "r^2 / (2 * radius) + r^4 / (8 * radius^3), max_radius = limit, crate = crate::renamed",
        "struct Ball { radius: f64, limit: f32, name: String }",
    ],
    ["roots_of_fields", "c * r^2.5 + d * r^4 + e * r^5", "struct Blunt { c: f64, d: f64, e: f64 }"],
    ["generics", "c * r^2 + r^2.5 / c^0.5", "struct Any<'a, S: Copy, T> where T: Clone { c: S, tag: &'a T }"],
    [
        "positive",
        "c * r^2 + r^4 / (8 * radius^3), positive, max_radius = 0.5 * radius",
        "struct Worn { radius: f64, c: f64 }",
    ],
    ["surface_of_a_field", "sphere(radius), order = 4, max_radius = 6", "struct Ball { radius: f64 }"],
    ["faulty", "2r^2 + x", "struct Knee<T> { radius: T }"],
    ["faulty_with_fields", "2r^2 / raduis", "struct Ball<S> { radius: S }"],
];

#[test]
fn expansions_are_the_golden_ones() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    for [name, attribute, item] in CASES {
        let file = folder.join(name).with_extension("rs");
        let expansion = expand(attribute.parse().unwrap(), item.parse().unwrap());
        let expansion = without_tables(&prettyplease::unparse(&syn::parse2(expansion).unwrap()));
        if env::var_os("UPDATE_GOLDEN").is_some() {
            fs::write(&file, &expansion).unwrap();
        }
        let golden = fs::read_to_string(&file).unwrap_or_default();
        assert!(
            expansion == golden,
            "{name} differs; UPDATE_GOLDEN=1 renews {}:\n{expansion}",
            file.display()
        );
    }
}

/// The expansion without the thousands of bytes of its tables.
fn without_tables(expansion: &str) -> String {
    let is_table = |line: &str| line.trim_start().starts_with("*b\"");
    expansion
        .lines()
        .map(|line| if is_table(line) { "*b\"...\",\n".to_owned() } else { format!("{line}\n") })
        .collect()
}
