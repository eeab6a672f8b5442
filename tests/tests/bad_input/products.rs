//! Fields of generated geometries, and products and sums of them, that the format rounds to zero or infinity.

use cartcontact::{GapProfile, ProfileError, gap_profile};

use super::refused;

/// A format without them would leave out a term, whatever its sign.
#[test]
fn fields_need_a_format_that_holds_them() {
    for value in [1e-60, -1e-60, 1e-320, 1e-42, 1e60] {
        let gap = TwoFields { k: value, j: 1.0 };
        let is_field = |e: &ProfileError| matches!(e, ProfileError::OutOfFormat { field: "k", .. });
        refused(GapProfile::<f32>::check(&gap), is_field, format_args!("`k` is {value:e}"));
        let is_first = |e: &ProfileError| matches!(e, ProfileError::NotPositive { field: "k", .. });
        let declared = DeclaredFields { k: value, j: 1.0 };
        assert!(!GapProfile::<f32>::check(&declared).is_err_and(|e| is_first(&e)), "{value:e}");
    }
    let flat = Lens { near: 1e50, far: 2e50 };
    let is_near = |e: &ProfileError| matches!(e, ProfileError::OutOfFormat { field: "near", .. });
    refused(GapProfile::<f32>::check(&flat), is_near, "1e50");
    assert_eq!(GapProfile::<f64>::check(&flat), Ok(()));
    assert_eq!(GapProfile::<f32>::check(&TwoFields { k: 0.0, j: 1.0 }), Ok(()));
}

/// Nor does a product of numbers that the format holds count as nothing when it is too small.
#[test]
fn products_of_fields_need_a_format_that_holds_them() {
    let check = |k, j| GapProfile::<f64>::check(&Powers { k, j });
    assert_eq!([check(1e-90, 1e-90), check(0.0, 1.0), check(-0.0, 1.0)], [Ok(()); 3]);
    let is_product = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 2.0, .. });
    refused(check(1e-200, 1e-200), is_product, "r^2 is 0, but only because the format");
    refused(check(-1e-200, 1e-200), is_product, "with k = -1e-200, j = 1e-200");
    let is_quotient = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 4.0, .. });
    refused(check(1.0, 1e150), is_quotient, "r^4 is 0");
}

/// Nor does a sum of them, unless they cancel.
#[test]
fn sums_of_fields_need_a_format_that_holds_them() {
    let balls =
        |radius| GapProfile::<f32>::check(&Balls { upper_radius: radius, lower_radius: 2.0 * radius });
    assert_eq!(balls(5e4), Ok(()));
    let is_last = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 8.0, .. });
    for radius in [1e6, 2e6, 3e6, 5e6] {
        refused(balls(radius), is_last, "r^8");
    }
    for value in [0.0, 0.1, 1e-18] {
        assert_eq!(GapProfile::<f32>::check(&Cancelling { k: value, j: value }), Ok(()), "{value}");
    }
    let is_difference =
        |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 4.0, .. });
    refused(GapProfile::<f32>::check(&Cancelling { k: 1e-25, j: 1e-30 }), is_difference, "r^4 is 0");
    let multiple = |size, factor| GapProfile::<f32>::check(&Multiple { k: size, j: size, factor });
    assert_eq!([multiple(1e-15, 1e20), multiple(0.1, 0.0), multiple(0.0, 0.1)], [Ok(()); 3]);
    refused(multiple(1e-25, 1e20), is_difference, "r^4 is 0");
}

/// A divisor that has left the format is not infinite as given.
#[test]
fn sums_below_a_fraction_line_need_a_format_that_holds_them() {
    let check = |k, j| GapProfile::<f32>::check(&DividedBySum { factor: 1e30, k, j });
    assert_eq!(
        [check(1e17, 1.0), check(1.0, 1e-17), check(f64::INFINITY, 1.0), check(1.0, 0.0)],
        [Ok(()); 4]
    );
    let is_quotient = |e: &ProfileError| matches!(e, ProfileError::InvalidCoefficient { exponent: 4.0, .. });
    for (k, j) in [(1e25, 1.0), (1.0, 1e-25)] {
        refused(check(k, j), is_quotient, "r^4 is 0");
    }
}

#[gap_profile(k * r^2 + j * r^3)]
struct TwoFields {
    k: f64,
    j: f64,
}

#[gap_profile(k * r^2 + j * r^3, positive)]
struct DeclaredFields {
    k: f64,
    j: f64,
}

#[gap_profile(r^2 / (2 * near) - r^2 / (2 * far) + r^4)]
struct Lens {
    near: f64,
    far: f64,
}

#[gap_profile(k * j * r^2 + 0.1 * r^3 + r^4 / j^3)]
struct Powers {
    k: f64,
    j: f64,
}

#[gap_profile(
    upper = sphere(upper_radius),
    lower = -sphere(lower_radius),
    order = 8,
    max_radius = 0.6 * upper_radius,
    positive
)]
struct Balls {
    upper_radius: f64,
    lower_radius: f64,
}

#[gap_profile(r^2 + (k^2 - j^2) * r^4, max_radius = 1)]
struct Cancelling {
    k: f64,
    j: f64,
}

#[gap_profile(r^2 + (k^2 + j^2) * factor * r^4, max_radius = 1)]
struct Multiple {
    k: f64,
    j: f64,
    factor: f64,
}

#[gap_profile(0.1 * r^2 + factor * r^4 / (k^2 + 1 / j^2))]
struct DividedBySum {
    factor: f64,
    k: f64,
    j: f64,
}
