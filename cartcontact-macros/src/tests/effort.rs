//! How long an expansion takes, without the compiler around it. `CARGO_PROFILE_TEST_OPT_LEVEL=0
//! CARGO_PROFILE_TEST_DEBUG=0 cargo test -p cartcontact-macros effort_is_bounded -- --nocapture` prints it for the
//! macro as cargo builds it by default: not optimised, and without debug information, which would make it up to twice
//! as slow.

use std::time::{Duration, Instant};

use quote::quote;

use crate::expand;

/// Far above the measured times, so that only another order of growth fails.
const LIMIT: Duration = if cfg!(debug_assertions) { Duration::from_secs(20) } else { Duration::from_secs(2) };

/// The powers of r with these exponents; those with an exponent of 0 or 1 modulo 4 have the sign `sign`.
fn sum(exponents: impl Iterator<Item = u32>, sign: char) -> String {
    let terms = exponents.map(|n| format!("{} 1.234567e-{n} * r^{n}", if n % 4 > 1 { '+' } else { sign }));
    terms.collect::<Vec<String>>().join(" ")
}

/// Many multiples of an expression by powers of a field.
fn powers_of_a_field(multiplied: &str) -> String {
    (1..1000).map(|n| format!("a^{n} * {multiplied}")).collect::<Vec<String>>().join(" + ")
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
            "two conics, order = auto",
            "conic(10.37, -0.2) - sphere(20.11), order = auto, tolerance = 1e-9, max_radius = 7.1".to_owned(),
        ),
        (
            "two conics near a rim, order = auto",
            "conic(10, -2) + sphere(16.5), order = auto, tolerance = 1e-5, max_radius = 9.5".to_owned(),
        ),
        ("two spheres, order 128", "sphere(10) - sphere(20), order = 128, max_radius = 9.99".to_owned()),
        ("two conics of fields, order 64", "conic(a, b) - b * conic(a + c, c), order = 64".to_owned()),
        ("a power of 2 fields", "(a*r + b*r^2)^16".to_owned()),
        ("a high power of numbers", "(0.123456789*r + 0.987654321*r^2)^127".to_owned()),
        ("a power of 3 fields", "(a*r + b*r^2 + c*r^3)^8".to_owned()),
        ("powers of 64ths", "r^(1/64) - 1e-3 * r^16, max_radius = 1.1".to_owned()),
        ("powers of hundredths", "0.05*r^2.37 - 0.001*r^3.41 + 0.01*r^5.5".to_owned()),
        ("powers of thousandths", "r^2.001 - 0.1*r^2.372 + 1e-3*r^3.013, max_radius = 1.5".to_owned()),
        ("powers of thousandths without end", "r^2.001 - 1.1*r^2.372 + 0.4*r^3.013".to_owned()),
    ] {
        let output = timed(name, &attribute);
        assert!(!output.contains("compile_error"), "{name}: {output}");
    }
}

/// Each gap is short to write, and long once it is multiplied out.
#[test]
fn what_would_take_long_is_refused() {
    for (name, attribute, rule) in [
        ("a power of 3 fields", "(a*r + b*r^2 + c*r^3)^64".to_owned(), "too long an expression"),
        ("3 fields, 12 times", ["(a*r + b*r^2 + c*r^3)"; 12].join("*"), "too long an expression"),
        ("a sum of powers of a field", powers_of_a_field("r^2"), "at most 256 terms"),
        (
            "a sum of multiples of a sphere",
            powers_of_a_field("sphere(10)") + ", order = 4",
            "at most 256 terms",
        ),
        ("a power of 3 numbers", "(r + r^2 + r^3)^4000".to_owned(), "too many terms"),
        ("257 terms", sum(2..259, '+'), "a gap may have at most 256 terms"),
        ("a power of long numbers", format!("(1.{}*r + r^2)^127", "1".repeat(40)), "too large"),
        ("a high power of four decimals", "r^2 - 1e-9 * r^64.3333".to_owned(), "a common fraction"),
    ] {
        let output = timed(name, &attribute);
        assert!(output.matches("compile_error").count() == 1 && output.contains(rule), "{name}: {output}");
    }
}

/// If each call were read twice, the time would double with every level.
#[test]
fn nested_calls_are_read_once() {
    for (open, close) in
        [("f(", ")"), ("r(", ")"), ("pow(2, ", ")"), ("sphere(1, ", ")"), ("conic[", "]"), ("1/2(", "+)")]
    {
        let output = timed(open, &(open.repeat(24) + "1" + &close.repeat(24)));
        assert!(output.contains("compile_error"), "{open}: {output}");
    }
}

/// The radius at which the gap fails is compared with decimals, whose powers are as long as the denominator of
/// exponents is large.
#[test]
fn what_fails_at_some_radius_is_refused_in_time() {
    for attribute in [
        "0.0512*r^2.034 + 0.001*r^2.5 - 0.00123*r^2.871",
        "0.05*r^2.123 + 0.01*r^2.5 - 0.001*r^2.917",
        "13.9*r^1.932 + 5.19*r^2.029 - 16.7*r^2.22",
        "0.05*r^2 - 0.001*r^4.371",
        "r^2 - 1e-9*r^1000.015625",
        // At r = 1, exactly.
        "r^2 - 65999/127998*r^63.999",
    ] {
        let output = timed(attribute, attribute);
        assert!(output.contains("add `max_radius = "), "{attribute}: {output}");
    }
}

/// The expansion, which may not take longer than [`LIMIT`].
fn timed(name: &str, attribute: &str) -> String {
    let item = quote!(
        struct Knee {
            a: f64,
            b: f64,
            c: f64,
        }
    );
    let mut fastest = Duration::MAX;
    let mut output = String::new();
    // The first run is slowed down by code that has not run before.
    for _ in 0..3 {
        let attribute = attribute.parse().unwrap();
        let start = Instant::now();
        let expanded = expand(attribute, item.clone());
        fastest = fastest.min(start.elapsed());
        output = expanded.to_string();
    }
    println!("{name}: {fastest:.1?}, {} characters", output.len());
    assert!(fastest < LIMIT, "{name} took {fastest:?}");
    output
}
