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

#[::core::prelude::v1::test]
fn generated_code_needs_no_prelude() {
    let radii = [
        super::radius::<f64>(&Constant),
        super::radius::<f32>(&Constant),
        super::radius(&Symbolic { radius: 20.0_f64 }),
        super::radius(&Symbolic { radius: 20.0_f32 }),
        super::radius::<f64>(&Single { radius: 20.0 }),
    ];
    for radius in radii {
        ::std::assert!(radius > 0.0, "{radius}");
    }
}
