//! How long an expansion takes, without the compiler around it;
//! `cargo test -p cartcontact-macros effort -- --nocapture` prints it.

use std::time::{Duration, Instant};

use quote::quote;

use crate::expand;

/// Far above what is measured, so that only another order of growth fails.
const LIMIT: Duration = if cfg!(debug_assertions) { Duration::from_secs(20) } else { Duration::from_secs(2) };

/// The powers of r with these exponents; every other pair of them has the sign `sign`.
fn sum(exponents: impl Iterator<Item = u32>, sign: char) -> String {
    let terms = exponents.map(|n| format!("{} 1.234567e-{n} * r^{n}", if n % 4 > 1 { '+' } else { sign }));
    terms.collect::<Vec<String>>().join(" ")
}

#[test]
fn effort_is_bounded() {
    for (name, attribute) in [
        ("2 terms", "0.025 * r^2 + 1.09375e-4 * r^4".to_owned()),
        ("10 terms", sum((2..22).step_by(2), '+')),
        ("10 terms, signs mixed", sum((2..22).step_by(2), '-') + ", max_radius = 0.5"),
        ("degree 64", sum(2..65, '+')),
        ("degree 64, signs mixed", sum(2..65, '-') + ", max_radius = 0.5"),
        ("two spheres, order 4", "sphere(10) - sphere(20), order = 4, max_radius = 6".to_owned()),
        (
            "two conics, smallest order",
            "conic(10.37, -0.2) - sphere(20.11), order = auto, tolerance = 1e-9, max_radius = 7.1".to_owned(),
        ),
    ] {
        let item = quote!(
            struct Knee;
        );
        let mut fastest = Duration::MAX;
        let mut output = String::new();
        // The first is slowed down by code that nobody has run before.
        for _ in 0..3 {
            let attribute = attribute.parse().unwrap();
            let start = Instant::now();
            let expanded = expand(attribute, item.clone());
            fastest = fastest.min(start.elapsed());
            output = expanded.to_string();
        }
        println!("{name}: {fastest:.1?}, {} characters", output.len());
        assert!(!output.contains("compile_error"), "{name}: {output}");
        assert!(fastest < LIMIT, "{name} took {fastest:?}");
    }
}
