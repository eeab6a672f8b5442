//! The constants of a medium against its formulas in more digits, against each other, and for layers of any size.

use cartcontact::{Layer, Medium, MediumError};
use tests::measure::relative_error;
use tests::random::Stream;

/// A random layer of numbers that single precision holds.
fn layer(stream: &mut Stream) -> Layer<f32> {
    let mut number = |low: f64, high: f64| stream.between(low, high) as f32;
    Layer { thickness: number(0.3, 3.0), shear_modulus: number(0.1, 1.0), permeability: number(1e-4, 1e-2) }
}

/// The same layer in double precision.
fn double(layer: Layer<f32>) -> Layer<f64> {
    Layer {
        thickness: layer.thickness.into(),
        shear_modulus: layer.shear_modulus.into(),
        permeability: layer.permeability.into(),
    }
}

/// h³/(3 μ)
fn compliance(layer: Layer<f64>) -> f64 {
    layer.thickness.powi(3) / (3.0 * layer.shear_modulus)
}

/// Six roundings of ε/2 make 3 ε, and three more 4.5 ε.
#[test]
fn constants_are_as_exact_as_documented() -> Result<(), MediumError> {
    let mut stream = Stream::of_case(1, 0);
    let (mut worst_of_m, mut worst_of_chi) = (0.0_f64, 0.0_f64);
    for _ in 0..200_000 {
        let (first, second) = (layer(&mut stream), layer(&mut stream));
        let found = Medium::between(first, second)?;
        let (first, second) = (double(first), double(second));
        let m = 1.0 / (compliance(first) + compliance(second));
        let chi = m * (first.thickness * first.permeability + second.thickness * second.permeability);
        let error = |found: f32, expected| relative_error(found.into(), expected, f32::EPSILON.into());
        worst_of_m = worst_of_m.max(error(found.m(), m));
        worst_of_chi = worst_of_chi.max(error(found.chi(), chi));
    }
    assert!(worst_of_m <= 3.0, "m: {worst_of_m} ε");
    assert!(worst_of_chi <= 5.0, "χ: {worst_of_chi} ε");
    // Bounds far above what occurs would not be worth documenting.
    assert!(worst_of_m > 1.0 && worst_of_chi > 1.0, "{worst_of_m}, {worst_of_chi}");
    Ok(())
}

/// Two equal layers mirror one layer on a rigid plane; the printed rate is twice as large.
#[test]
fn equal_layers_have_the_rate_of_one() -> Result<(), MediumError> {
    let mut stream = Stream::of_case(2, 0);
    for _ in 0..1000 {
        let layer = double(layer(&mut stream));
        let own = Medium::against_rigid(layer)?.chi();
        let error =
            |medium: Medium<f64>, factor: f64| relative_error(medium.chi(), factor * own, f64::EPSILON);
        assert!(error(Medium::between(layer, layer)?, 1.0) <= 5.0);
        assert!(error(Medium::between_as_printed_2011(layer, layer)?, 2.0) <= 5.0);
    }
    Ok(())
}

/// Intermediate products are out of range although the results are not.
#[test]
fn layers_of_any_size_make_a_medium() -> Result<(), MediumError> {
    let layer = Layer { thickness: 1e-100_f64, shear_modulus: 1e-10, permeability: 1e-230 };
    for (medium, share) in [(Medium::against_rigid(layer)?, 1.0), (Medium::between(layer, layer)?, 0.5)] {
        // As documented.
        assert!((medium.m() / (3e290 * share) - 1.0).abs() <= 3.0 * f64::EPSILON, "{medium:?}");
        assert!((medium.chi() / 3e-40 - 1.0).abs() <= 5.0 * f64::EPSILON, "{medium:?}");
    }
    Ok(())
}
