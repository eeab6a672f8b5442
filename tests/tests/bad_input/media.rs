//! Layers and constants of a medium.

use cartcontact::{Layer, Medium, MediumError};

use super::{NOT_A_SIZE, NOT_AN_AMOUNT, layer, refused};

#[test]
fn layers_need_positive_sizes() {
    let is_thickness: fn(&MediumError) -> bool = |e| matches!(e, MediumError::Thickness { .. });
    let is_shear_modulus: fn(&MediumError) -> bool = |e| matches!(e, MediumError::ShearModulus { .. });
    for value in NOT_A_SIZE {
        let (thin, soft) = (Layer { thickness: value, ..layer() }, Layer { shear_modulus: value, ..layer() });
        for (faulty, is_expected) in [(thin, is_thickness), (soft, is_shear_modulus)] {
            for between in [Medium::between, Medium::between_as_printed_2011] {
                refused(between(faulty, layer()), is_expected, value);
                refused(between(layer(), faulty), is_expected, value);
            }
            refused(Medium::against_rigid(faulty), is_expected, value);
        }
    }
}

/// Two kinds of layers stand for a bare rigid body: one of no thickness and one of infinite stiffness.
#[test]
fn only_the_numbers_of_a_bare_body_are_taken_for_one() {
    let message = |layer: Layer<f64>| {
        let refused = [Medium::between(layer, self::layer()), Medium::against_rigid(layer)];
        let [between, against] = refused.map(|medium| medium.err().map(|error| error.to_string()));
        assert_eq!(between, against);
        between.unwrap_or_default()
    };
    for value in NOT_A_SIZE {
        let thin = message(Layer { thickness: value, ..layer() });
        assert_eq!(thin.contains("if this body is bare"), value == 0.0, "{thin}");
        let soft = message(Layer { shear_modulus: value, ..layer() });
        assert_eq!(soft.contains("if this body is bare"), value == f64::INFINITY, "{soft}");
    }
}

#[test]
fn permeabilities_may_be_zero_but_not_negative() {
    for value in NOT_AN_AMOUNT {
        let layer = Layer { permeability: value, ..layer() };
        for result in [Medium::between(layer, layer), Medium::against_rigid(layer)] {
            refused(result, |e| matches!(e, MediumError::Permeability { .. }), value);
            let message = result.err().map(|error| error.to_string()).unwrap_or_default();
            assert_eq!(message.contains("check its unit"), !value.is_nan(), "{message}");
        }
    }
    let dry = Layer { permeability: 0.0, ..layer() };
    assert_eq!(Medium::between(dry, dry).map(|medium| medium.chi()), Ok(0.0));
}

#[test]
fn media_too_stiff_or_too_quick_for_the_format_are_refused() {
    let thick = Layer { thickness: 1e200, ..layer() };
    refused(Medium::against_rigid(thick), |e| matches!(e, MediumError::Stiffness { .. }), "0");
    let thin = Layer { thickness: 1e-200, ..layer() };
    refused(Medium::against_rigid(thin), |e| matches!(e, MediumError::Stiffness { .. }), "inf");
    let leaky = Layer { permeability: 1e308, shear_modulus: 1e3, ..layer() };
    refused(Medium::against_rigid(leaky), |e| matches!(e, MediumError::Rate { .. }), "inf");
}

/// It is not that of layers without permeability.
#[test]
fn a_rate_that_is_rounded_to_zero_is_refused() {
    let sluggish = Layer { thickness: 1e100, permeability: 1e-150, ..layer() };
    let is_rate: fn(&MediumError) -> bool = |e| matches!(e, MediumError::Rate { chi: 0.0 });
    refused(Medium::against_rigid(sluggish), is_rate, "rounds it to 0");
    for between in [Medium::between, Medium::between_as_printed_2011] {
        refused(between(sluggish, sluggish), is_rate, "rounds it to 0");
        let dry = Layer { permeability: 0.0, ..layer() };
        refused(between(sluggish, dry), is_rate, "rounds it to 0");
        assert!(between(sluggish, layer()).is_ok());
    }
}

#[test]
fn times_of_diffusion_are_those_of_a_solid_and_a_layer() {
    // H = λ + 2 μ with λ = 2 μ ν/(1 − 2 ν) is 3 μ for ν = 1/4, and 6 μ for ν = 0.4.
    for (poisson_ratio, moduli) in [(0.25, 3.0), (0.4, 6.0)] {
        let time = layer().diffusion_time(poisson_ratio).unwrap_or(f64::NAN);
        let Layer { thickness, shear_modulus, permeability } = layer();
        let expected = thickness * thickness / (permeability * moduli * shear_modulus);
        assert!(
            (time / expected - 1.0).abs() < 4.0 * f64::EPSILON,
            "{poisson_ratio}: {time}, not {expected}"
        );
    }
    for permeability in [0.0, -0.0] {
        assert_eq!(Layer { permeability, ..layer() }.diffusion_time(0.3), Ok(f64::INFINITY));
    }
    for value in [f64::NAN, f64::INFINITY, -f64::INFINITY, 0.5, 0.6, -1.0, -1.5] {
        let result = layer().diffusion_time(value);
        refused(result, |e| matches!(e, MediumError::PoissonRatio { .. }), value);
    }
    let thin = Layer { thickness: 0.0, ..layer() };
    refused(thin.diffusion_time(0.3), |e| matches!(e, MediumError::Thickness { .. }), "0");
}

#[test]
fn constants_of_a_medium_are_checked() {
    for value in NOT_A_SIZE {
        refused(Medium::from_constants(value, 1.0), |e| matches!(e, MediumError::Stiffness { .. }), value);
    }
    for value in NOT_AN_AMOUNT {
        refused(Medium::from_constants(1.0, value), |e| matches!(e, MediumError::Rate { .. }), value);
    }
}
