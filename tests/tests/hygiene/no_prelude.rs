//! Without the prelude: no `Option`, no `Into`, no `Iterator`, no macros in scope.
#![no_implicit_prelude]

/// Constant coefficients.
#[::cartcontact::gap_profile(0.025 * r^2 + 0.01 * r^2.5, max_radius = 60.0)]
struct Constant;

/// Coefficients from fields, a range from a field, negative terms, powers of fields.
#[::cartcontact::gap_profile(r^2 / (2 * radius) - r^4 / (800 * radius^3) + radius^0.5 * r^3, max_radius = 2 * radius)]
struct Symbolic<T> {
    radius: T,
}

/// One term.
#[::cartcontact::gap_profile(r^2 / (2 * radius))]
struct Single {
    radius: f32,
}

/// The roots of a⁶/480 + 2a^6.5/2340 = 1 and of a⁶/480 − a⁸/76800000 + 3√20 a⁷/35 = 1.
const OF_CONSTANT: f64 = 2.572_042_832_713_836;
const OF_SYMBOLIC: f64 = 1.146_031_958_102_065_2;

#[::core::prelude::v1::test]
fn generated_code_needs_no_prelude() {
    let radii = [
        (super::radius::<f64>(&Constant), OF_CONSTANT, 1e-14),
        (super::radius::<f32>(&Constant), OF_CONSTANT, 1e-6),
        (super::radius(&Symbolic { radius: 20.0_f64 }), OF_SYMBOLIC, 1e-14),
        (super::radius(&Symbolic { radius: 20.0_f32 }), OF_SYMBOLIC, 1e-6),
    ];
    for (radius, expected, tolerance) in radii {
        ::std::assert!((radius / expected - 1.0).abs() < tolerance, "{radius} instead of {expected}");
    }
    super::assert_ball::<f64>(&Single { radius: 20.0 });
}
