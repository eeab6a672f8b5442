//! Scenes at the ends of a format or of time, with the results that they have all the same.

use cartcontact::load::{Constant, PiecewiseLinear};
use cartcontact::{Contact, ContactError, GapProfile, Medium, Polynomial, ProfileError, Scalar, gap_profile};
use tests::budget;
use tests::joint::joint;
use tests::measure::{relative_error, ulps};

/// r⁶⁴ is out of range at the contact radius in either format, and so is the power r⁶⁸ of J.
#[test]
fn powers_need_not_be_in_range() -> Result<(), Box<dyn core::error::Error>> {
    let double =
        Contact::new(Polynomial::new([(1e-300, 64.0)])?, Medium::from_constants(1.0, 0.0)?, Constant(1e20))?;
    let a: f64 = double.at(0.0)?.radius();
    let expected = (1e20_f64.ln() + 300.0 * core::f64::consts::LN_10
        - (core::f64::consts::FRAC_PI_4 * 64.0 / (66.0 * 68.0)).ln())
        / 68.0;
    // Both logarithms are rounded, of which that of the radius, near 11, hardly depends on the rounding of the radius.
    assert!((a.ln() / expected - 1.0).abs() <= 2.0 * f64::EPSILON, "{a:e}");
    assert!(a.powi(68).is_infinite(), "{a:e}");
    let single = Contact::new(
        Polynomial::new([(1e-33_f32, 64.0)])?,
        Medium::from_constants(1.0, 0.0)?,
        Constant(1e4),
    )?;
    let now = single.at(0.0)?;
    assert!(now.radius().powi(68).is_infinite() && now.peak_pressure().is_finite(), "{now:?}");
    Ok(())
}

/// C aⁿ⁺² is out of range in f32, but n times that is not.
#[test]
fn coefficients_of_tiny_exponents_need_not_be_in_range() -> Result<(), Box<dyn core::error::Error>> {
    /// Pressures at two times, alone and in a field.
    fn pressures<T: Scalar>() -> Result<[[f64; 4]; 2], Box<dyn core::error::Error>> {
        let [c, n, m, chi, force] = [9e21, 1e-36, 2e5, 150.0, 1e26].map(T::constant);
        let contact =
            Contact::new(Polynomial::new([(c, n)])?, Medium::from_constants(m, chi)?, Constant(force))?;
        let (times, radii) = ([0.0, 1.0].map(T::constant), [1e8, 8e8].map(T::constant));
        let mut field = [T::zero(); 4];
        contact.pressure_field(&times, &radii, &mut field)?;
        let mut last = [T::zero(); 2];
        contact.pressure_field(&times[1..], &radii, &mut last)?;
        assert_eq!(last, field[2..]);
        let [first, second] = [contact.at(times[0])?, contact.at(times[1])?];
        let alone = [first, second].map(|now| radii.map(|r| now.pressure(r).value()));
        Ok([*alone.as_flattened().first_chunk().ok_or("four pressures")?, field.map(T::value)])
    }
    let (single, double) = (pressures::<f32>()?, pressures::<f64>()?);
    for (found, expected) in single.as_flattened().iter().zip(double.as_flattened()) {
        let error = relative_error(*found, *expected, f32::EPSILON.into());
        assert!(error <= budget::PRESSURE.single, "{single:?} instead of {double:?}: {error:.2} ε");
    }
    Ok(())
}

/// For n → 0 and next to the edge, G = n C a² δ² (1 − δ/3)/4 with δ = 1 − r/a, although n δ² leaves the format.
#[test]
fn kernels_of_tiny_exponents_keep_their_digits_to_the_edge() -> Result<(), ProfileError> {
    fn error<T: Scalar>(numbers: [f64; 3], depth: f64) -> Result<f64, ProfileError> {
        let [c, n, a] = numbers.map(T::constant);
        let found = Polynomial::new([(c, n)])?.pressure_kernel(a, a * T::constant(1.0 - depth)).value();
        let [c, n, a] = [c, n, a].map(T::value);
        let expected = n * (c * (a * depth).powi(2)) * (1.0 - depth / 3.0) / 4.0;
        Ok(ulps(found, expected.into(), T::default_epsilon().value()))
    }
    for depth in [2_f64.powi(-12), 2_f64.powi(-20)] {
        for scene in [[1e35, 1e-36, 8192.0], [1e30, 1e-36, 1.0]] {
            let error = error::<f32>(scene, depth)?;
            assert!(error <= budget::PRESSURE_KERNEL.single, "{scene:?}, {depth:e}: {error} ulp");
        }
    }
    // What is expected is rounded, too.
    let error = error::<f64>([1e300, 1e-300, 1.0], 2_f64.powi(-30))?;
    assert!(error <= budget::PRESSURE_KERNEL.double + 3.0, "{error} ulp");
    Ok(())
}

/// In f32 the two terms of a J′ are infinite from 9e4 mm on; their difference, some 400 times smaller, is not.
#[test]
fn infinite_terms_of_both_signs_are_refused() -> Result<(), Box<dyn core::error::Error>> {
    let (c, d, force) = (4.01e-4_f32, 4e-4_f32, 0.168_f32);
    let radius = |m: f32| -> Result<_, Box<dyn core::error::Error>> {
        let gap = Polynomial::new([(-d, 4.5), (c, 4.5)])?;
        let contact = Contact::new(gap, Medium::from_constants(m, 0.0)?, Constant(force))?;
        Ok(contact.at(0.0).map(|now| now.radius()))
    };
    assert!(matches!(radius(1.7e-38)?, Err(ContactError::Unrepresentable { .. })));
    let m = 1.7e-35;
    let load_integral = f64::from(force) / (core::f64::consts::FRAC_PI_4 * f64::from(m));
    let coefficient = (f64::from(c) - f64::from(d)) * 4.5 / (6.5 * 8.5);
    let expected = (load_integral / coefficient).powf(1.0 / 8.5);
    let error = f64::from(radius(m)??) / expected - 1.0;
    assert!(error.abs() < 400.0 * f64::from(f32::EPSILON), "{error:e}");
    Ok(())
}

/// A sphere on another one or on a plane.
#[gap_profile(r^2 / (2 * upper) - r^2 / (2 * lower))]
struct SphereOnSphere {
    upper: f64,
    lower: f64,
}

/// The product of both radii leaves the format, in which their difference would be formed without loss.
#[test]
fn a_sphere_of_huge_radius_is_a_plane() {
    for lower in [1e100, 1e307, 4e307, 1e308, f64::INFINITY] {
        let [(coefficient, _)] = SphereOnSphere { upper: 5.0, lower }.terms::<f64>();
        assert!((coefficient - 0.1).abs() < 0.1 * f64::EPSILON, "{lower:e}: {coefficient}");
    }
    for lower in [1e30, 3e37, 1e38, 3e38, f64::INFINITY] {
        let [(coefficient, _)] = SphereOnSphere { upper: 5.0, lower }.terms::<f32>();
        assert!((coefficient - 0.1).abs() < 0.1 * f32::EPSILON, "{lower:e}: {coefficient}");
    }
}

/// A term with a coefficient of zero may have a power that is out of range.
#[test]
fn a_coefficient_of_zero_is_no_term() -> Result<(), Box<dyn core::error::Error>> {
    let medium = Medium::from_constants(1.0, 0.01)?;
    let alone = Contact::new(Polynomial::new(vec![(2e-4, 4.0)])?, medium, Constant(1e20_f32))?;
    let beside = Contact::new(Polynomial::new(vec![(2e-4, 4.0), (0.0, 48.0)])?, medium, Constant(1e20))?;
    for time in [0.0, 300.0] {
        let [alone, beside] = [alone.at(time)?, beside.at(time)?];
        assert_eq!(alone.radius(), beside.radius());
        assert_eq!(alone.approach(), beside.approach());
        assert_eq!(alone.peak_pressure(), beside.peak_pressure());
    }
    // The slope of r^0.5 is infinite on the axis.
    assert_eq!(Polynomial::new([(1.0, 2.0), (0.0, 0.5)])?.approach_slope(0.0_f64), 0.0);
    Ok(())
}

/// The sign bit of −0 would make its logarithm the largest.
#[test]
fn a_coefficient_of_minus_zero_is_no_term() -> Result<(), ProfileError> {
    for (c, n) in [(0.025, 2.0), (1e-30, 12.0), (7e133, 9.0)] {
        let (alone, beside) = (Polynomial::new([(c, n)])?, Polynomial::new([(c, n), (-0.0, 3.0)])?);
        for exponent in (-200..200).step_by(5) {
            let load_integral = 10f64.powi(exponent);
            let radius = |gap: &dyn GapProfile<f64>| gap.radius(load_integral).unwrap_or(f64::NAN);
            let error = relative_error(radius(&beside), radius(&alone), f64::EPSILON);
            assert!(error <= 2.0 * budget::RADIUS_OF_SUMS.double, "{c:e}, {load_integral:e}: {error} ε");
        }
    }
    Ok(())
}

/// P = 2 F (a² − r²)/(π a⁴) after a long time, when the load comes from a strip of radii narrower than the spacing of
/// numbers.
#[test]
fn the_end_of_drainage_is_reached() -> Result<(), Box<dyn core::error::Error>> {
    let contact = joint(Polynomial::new([(0.025_f32, 2.0)])?, 1.0, Constant(100.0));
    for time in [1e6, 1e9, 1e12] {
        let now = contact.at(time)?;
        let (found, radius) = (f64::from(now.peak_pressure()), f64::from(now.radius()));
        let drained = 200.0 / (core::f64::consts::PI * radius * radius);
        let rounding = budget::PEAK_PRESSURE.single + 2.0 * budget::CONTACT_RADIUS.single;
        // The memory holds the mean of a⁻² ∝ (1 + χ t)^(−1/3) over the last 1/χ.
        let allowed = rounding * f64::from(f32::EPSILON) + 1.0 / (3.0 * f64::from(time));
        assert!((found / drained - 1.0).abs() <= allowed, "{time:e}: {found:e}, {drained:e}");
    }
    Ok(())
}

/// The largest coefficients times their exponents are out of range, and what follows from them is not.
#[test]
fn coefficients_times_exponents_need_not_be_in_range() -> Result<(), Box<dyn core::error::Error>> {
    let (c, n) = (8e307, 30.0);
    let profile = Polynomial::new([(c, n)])?;
    let a = 1e-10_f64;
    let load_integral = profile.load_integral(a);
    // 1e-10 is rounded, and 34 times that counts.
    let expected = c * 1e-300 * (n / (32.0 * 34.0)) * 1e-40;
    assert!(
        (load_integral / expected - 1.0).abs() < 34.0 * f64::EPSILON,
        "{load_integral:e}, not {expected:e}"
    );
    let slope = profile.approach_slope(a);
    assert!((slope / (2.0 * c * (n / 32.0) * 1e-290) - 1.0).abs() < 29.0 * f64::EPSILON, "{slope:e}");
    let limited = Contact::new(
        Polynomial::with_max_radius([(1e37_f32, 38.0)], 0.1)?,
        Medium::from_constants(1.0, 0.1)?,
        Constant(1.0),
    )?;
    assert!(matches!(limited.at(0.0), Err(ContactError::BeyondRange { .. })));
    Ok(())
}

/// At the end of a rise during which all but its last moments drain, P(0) = 2 F/(π a²): the load comes from a strip that is
/// thinner than the spacing of numbers, also where times cannot tell when it was laid.
fn error_at_the_end_of_a_rise<T: Scalar>(chi: f64) -> Result<f64, Box<dyn core::error::Error>> {
    let load = PiecewiseLinear::new([(0.0, 0.0), (999.0, 0.0), (1000.0, 2.0)].map(|(t, f)| pair(t, f)))?;
    let contact = joint(Polynomial::new([pair::<T>(0.0625, 2.0)])?, chi, load);
    let now = contact.at(T::constant(1000.0))?;
    let a = now.radius().value();
    let share = now.peak_pressure().value() / (4.0 / (core::f64::consts::PI * a * a));
    Ok((share - 1.0).abs() / T::default_epsilon().value())
}

fn pair<T: Scalar>(x: f64, y: f64) -> (T, T) {
    (T::constant(x), T::constant(y))
}

#[test]
fn the_end_of_a_rise_is_not_lost() -> Result<(), Box<dyn core::error::Error>> {
    for exponent in [62, 73, 74, 80, 90] {
        let error = error_at_the_end_of_a_rise::<f64>(2f64.powi(exponent))?;
        assert!(error <= budget::PEAK_PRESSURE.double, "2^{exponent}: {error}");
    }
    for exponent in [30, 41, 42, 50, 62, 73, 74, 80, 90] {
        let error = error_at_the_end_of_a_rise::<f32>(2f64.powi(exponent))?;
        assert!(error <= budget::PEAK_PRESSURE.single, "2^{exponent}: {error}");
    }
    Ok(())
}

/// Next to the centre the slope of r^0.25 leaves single precision, where it does not count.
#[test]
fn slopes_need_not_be_in_range() -> Result<(), Box<dyn core::error::Error>> {
    fn peak<T: Scalar>(coefficient: f64) -> Result<f64, Box<dyn core::error::Error>> {
        let load = PiecewiseLinear::new([pair::<T>(0.0, 0.0), pair(256.0, 0.5)])?;
        let medium = Medium::from_constants(T::constant(500.0), T::constant(300.0))?;
        let contact = Contact::new(Polynomial::new([pair::<T>(coefficient, 0.25)])?, medium, load)?;
        Ok(contact.at(T::constant(2f64.powi(-10)))?.peak_pressure().value())
    }
    for exponent in [66, 80, 86, 93] {
        let coefficient = 2f64.powi(exponent);
        let error = (peak::<f32>(coefficient)? / peak::<f64>(coefficient)? - 1.0) / f64::from(f32::EPSILON);
        assert!(error.abs() <= budget::PEAK_PRESSURE.single, "2^{exponent}: {error}");
    }
    let steeper = peak::<f32>(2f64.powi(105));
    assert!(steeper.is_err_and(|error| {
        error.downcast_ref().is_some_and(|error| matches!(error, ContactError::Unrepresentable { .. }))
    }));
    Ok(())
}

/// One number in each scene is infinite or has lost digits, and none of the others that are looked at is or has.
#[test]
fn any_number_that_loses_digits_is_noticed() -> Result<(), Box<dyn core::error::Error>> {
    for (name, [m, chi], term, force) in [
        ("F", [1e-20, 0.0], (1e-229, 2.0), 1e-310),
        ("χ F", [1e-20, 1e-10], (1e-290, 2.0), 1e-300),
        ("J", [1e-200, 0.0], (1.0, 2.0), 1e200),
        ("a⁴", [1.0, 0.0], (1e200, 0.25), 1.2e-135),
        ("δ₀′", [1.0, 0.0], (1e-300, 0.25), 2e-217),
        ("a J′", [1e-10, 0.0], (1.0, 2.0), 3.9e297),
        ("F/a⁴", [1e-200, 0.0], (1.2e-149, 2.0), 1e-230),
        // Common forces and load integrals, which are not looked at one by one.
        ("a large radius", [1.0, 0.0], (1e-300, 0.25), 1e45),
        ("a small radius", [1.0, 0.0], (1e300, 0.25), 1e-45),
        ("a small rate", [1.0, 1e-300], (1.0, 2.0), 1e-40),
    ] {
        let contact =
            Contact::new(Polynomial::new([term])?, Medium::from_constants(m, chi)?, Constant(force))?;
        let (alone, many) = (contact.at(0.0).map(drop), contact.radii(&[0.0; 2], &mut [0.0; 2]));
        assert!(matches!(alone, Err(ContactError::Unrepresentable { .. })), "{name}: {alone:?}");
        assert_eq!(many, alone, "{name}");
    }
    Ok(())
}

/// How long ago a force of a few times the smallest number was smaller by nothing.
#[test]
fn a_load_after_the_smallest_forces_has_a_pressure() -> Result<(), Box<dyn core::error::Error>> {
    let (end, force) = (3.2e10, 3.2e10);
    let peak_after = |first: f64| -> Result<f64, Box<dyn core::error::Error>> {
        let load = PiecewiseLinear::new([(0.0, 0.0), (end, first), (end, force)])?;
        let gap = Polynomial::new([(1.9e-197, 0.5)])?;
        Ok(Contact::new(gap, Medium::from_constants(4.7e-4, 4.7e-4)?, load)?.at(end)?.peak_pressure())
    };
    let expected = peak_after(1e-290)?;
    for first in [5e-324, 8e-323, 1e-320] {
        let found = peak_after(first)?;
        assert!((found / expected - 1.0).abs() < 1e-14, "{first:e}: {found:e} instead of {expected:e}");
    }
    Ok(())
}
