//! Derivatives next to the axis, under very small loads, and far from the end of the range.
//!
//! For the gap C r², similarity gives a ∝ F^(1/6), δ₀ ∝ F^(1/3) and P(0, t) ∝ F^(2/3) under a held load F.

use cartcontact::load::{Constant, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, Medium, Polynomial, Scalar, gap_profile};
use num_dual::{Dual2_32, Dual2_64, Dual32, Dual64};
use tests::budget;
use tests::measure::relative_error;
use tests::profiles::Paraboloid;
use tests::stress::precision::Precision;

type Failure = Box<dyn core::error::Error>;

/// The degrees of a, δ₀ and P(0, t) in F.
const DEGREES: [f64; 3] = [1.0 / 6.0, 1.0 / 3.0, 2.0 / 3.0];

#[gap_profile(0.015 * r^2.3)]
struct Blunt;

#[gap_profile(25.0 * r^2 + 1e5 * r^4)]
struct SmallBall;

#[gap_profile(0.025 * r^2 + 1e-4 * r^5)]
struct Whole;

/// A derivative is allowed as much as two pressures.
fn assert_close<T: Precision>(found: T, expected: f64, place: &dyn core::fmt::Debug) {
    let error = relative_error(found.value(), expected, T::EPSILON);
    let allowed = 2.0 * T::allowed(budget::PRESSURE);
    assert!(error <= allowed, "{found} instead of {expected}, {error:.2} of {allowed} ε, for {place:?}");
}

/// Contact radius, approach, peak pressure, and the pressure at r, for a stiffness m and a held load.
fn results<T: Scalar>(
    profile: &dyn GapProfile<T>,
    (m, force): (f64, T),
    (r, t): (T, f64),
) -> Result<[T; 4], Failure> {
    let medium = Medium::from_constants(T::constant(m), T::constant(0.0015))?;
    let contact = Contact::new(profile, medium, Constant(force))?;
    let now = contact.at(T::constant(t))?;
    Ok([now.radius(), now.approach(), now.peak_pressure(), now.pressure(r)])
}

/// Radii that are zero but for rounding, such as 0.1 + 0.2 − 0.3, and such as no contact has.
#[test]
fn pressures_next_to_the_axis_have_the_derivatives_on_it() -> Result<(), Failure> {
    let force = Dual64::from(100.0).derivative();
    let polynomial = Polynomial::new([(Dual64::from(0.025), Dual64::from(2.0))])?;
    let profiles: [&dyn GapProfile<Dual64>; 3] = [&polynomial, &Paraboloid, &Blunt];
    for (index, profile) in profiles.into_iter().enumerate() {
        for t in [0.0, 200.0] {
            let pressure = |r: f64| -> Result<f64, Failure> {
                let [.., pressure] = results(profile, (0.375, force), (r.into(), t))?;
                Ok(pressure.eps)
            };
            let on_axis = pressure(0.0)?;
            for r in [5e-324, 1e-308, 1e-160, 1e-30, 0.1 + 0.2 - 0.3, 1e-12] {
                assert_close(pressure(r)?, on_axis, &(index, t, r));
            }
        }
    }
    Ok(())
}

/// ∂G/∂r = −δ₀ r/2 + Σ C rⁿ⁺¹/(n+2) vanishes there, and so must its error.
#[test]
fn kernels_of_whole_powers_have_slopes_next_to_the_axis() {
    for r in [1e-12, 1e-6, 1e-3, 0.1, 1.0_f64] {
        let found = Whole.pressure_kernel(Dual64::from(5.0), Dual64::from(r).derivative()).eps;
        let expected = -0.5 * Whole.approach(5.0) * r + 0.025 * r.powi(3) / 4.0 + 1e-4 * r.powi(6) / 7.0;
        assert_close(found, expected, &r);
    }
}

/// The second derivative of the pressure with respect to r.
fn curvature(profile: &dyn GapProfile<Dual2_64>, r: f64, t: f64) -> Result<f64, Failure> {
    let r = Dual2_64::from(r).derivative();
    let [.., pressure] = results(profile, (0.375, Dual2_64::from(100.0)), (r, t))?;
    Ok(pressure.v2)
}

/// The second derivative of P(r) ≈ P(0) + P″ r²/2 is that on the axis, wherever P″ r² is nothing.
#[test]
fn pressures_next_to_the_axis_have_the_curvature_on_it() -> Result<(), Failure> {
    let dual = Dual2_64::from;
    let polynomial = Polynomial::new([(dual(0.025), dual(2.0))])?;
    let profiles: [&dyn GapProfile<Dual2_64>; 3] = [&polynomial, &Paraboloid, &Blunt];
    for (index, profile) in profiles.into_iter().enumerate() {
        for t in [1.0, 200.0] {
            let on_axis = curvature(profile, 0.0, t)?;
            assert!(on_axis < -1e-3, "{index}, {t}: {on_axis}");
            for r in [1e-300, 1e-160, 1e-150, 1e-30, 1e-14] {
                assert_close(curvature(profile, r, t)?, on_axis, &(index, t, r));
            }
        }
    }
    Ok(())
}

/// The curvature of the peak: a geometry known at run time has that of the generated one.
#[test]
fn the_peak_has_its_curvature() -> Result<(), Failure> {
    let dual = Dual2_64::from;
    let polynomial = Polynomial::new([(dual(0.025), dual(2.0))])?;
    for t in [0.0, 1.0, 200.0, 5e3] {
        let (found, expected) = (curvature(&polynomial, 0.0, t)?, curvature(&Paraboloid, 0.0, t)?);
        assert!(expected < -1e-3);
        assert_close(found, expected, &t);
    }
    Ok(())
}

/// The squares of these load integrals leave the format.
#[test]
fn derivatives_under_small_loads_are_those_of_similarity() -> Result<(), Failure> {
    let single = Dual32::from;
    let polynomial = Polynomial::new([(single(25.0), single(2.0))])?;
    for force in [1e-12_f32, 1e-9, 1e-5, 1.0] {
        let given = (3.75e14, single(force).derivative());
        let [found @ .., _] = results(&polynomial, given, (single(0.0), 200.0))?;
        let of_similarity = |result: Dual32, degree: f64| f64::from(result.re) / f64::from(force) * degree;
        for (result, degree) in found.into_iter().zip(DEGREES) {
            assert_close(result.eps, of_similarity(result, degree), &(force, degree));
        }
        // Here the second term hardly counts.
        let [found @ .., _] = results(&SmallBall, given, (single(0.0), 200.0))?;
        let share = 1e5 / 25.0 * f64::from(found[0].re).powi(2);
        for (result, degree) in found.into_iter().zip(DEGREES) {
            let error = relative_error(result.eps.into(), of_similarity(result, degree), 1.0);
            let rounding = 2.0 * budget::PRESSURE.single * f64::from(f32::EPSILON);
            assert!(
                error <= share + rounding,
                "{force}, {degree}: {result} is off by {error:e} of {share:e}"
            );
        }
    }
    let dual = Dual64::from;
    let polynomial = Polynomial::new([(dual(0.025), dual(2.0))])?;
    for force in [1e-161, 1e-155, 1e-100, 1e100] {
        let given = (0.375, dual(force).derivative());
        let [found @ .., _] = results(&polynomial, given, (dual(0.0), 200.0))?;
        for (result, degree) in found.into_iter().zip(DEGREES) {
            assert_close(result.eps, result.re / force * degree, &(force, degree));
        }
    }
    Ok(())
}

/// The peak pressure and its derivative with respect to m, of the gap 0.025 r² in mm under 100 N, with the unit of length
/// 2^−`octaves` mm.
fn peak_by_stiffness<T: Scalar>(octaves: i32, variable: impl Fn(f64) -> T) -> Result<(T, f64), Failure> {
    let [unit, m] = [2_f64.powi(octaves), 0.375 * 2_f64.powi(-5 * octaves)];
    let profile = Polynomial::new([(T::constant(0.025 / unit), T::constant(2.0))])?;
    let medium = Medium::from_constants(variable(m), T::constant(0.0015))?;
    let contact = Contact::new(profile, medium, Constant(T::constant(100.0)))?;
    Ok((contact.at(T::constant(200.0))?.peak_pressure(), m))
}

/// The derivative of a quotient is a difference of products, and those of load integrals in µm⁵ leave the format.
#[test]
fn derivatives_are_there_where_products_of_load_integrals_are_not() -> Result<(), Failure> {
    // P(0, t) ∝ m^(1/3)
    for octaves in [0, 8, 10] {
        let (peak, m) = peak_by_stiffness(octaves, |m| Dual32::from(m as f32).derivative())?;
        assert_close(peak.eps, f64::from(peak.re) / (3.0 * m), &octaves);
    }
    for octaves in [0, 70, 95] {
        let (peak, m) = peak_by_stiffness(octaves, |m| Dual64::from(m).derivative())?;
        assert_close(peak.eps, peak.re / (3.0 * m), &octaves);
    }
    Ok(())
}

/// The peak pressure of the gap C r² + D r⁴ at 200 s under a load with a fall, for [C, D, m, F] and shares of F at times.
fn peak_after_a_fall<T: Scalar>([c, d, m, force]: [T; 4], knots: &[(f64, f64)]) -> Result<T, Failure> {
    let profile = Polynomial::new([(c, T::constant(2.0)), (d, T::constant(4.0))])?;
    let knots = knots.iter().map(|&(t, share)| (T::constant(t), force * T::constant(share)));
    let load = PiecewiseLinear::new(knots.collect::<Vec<_>>())?;
    let contact = Contact::new(profile, Medium::from_constants(m, T::constant(0.0015))?, load)?;
    Ok(contact.at(T::constant(200.0))?.peak_pressure())
}

/// The derivative of a quotient by a⁴ is a difference of products with a⁴: in m⁴ they are too small for f32, in µm⁴ too
/// large.
#[test]
fn derivatives_are_there_where_products_with_a_power_of_the_radius_are_not() -> Result<(), Failure> {
    let record: &[_] = &[(0.0, 0.2), (7.0, 1.0), (100.0, 0.9), (150.0, 1.1)];
    let fall: &[_] = &[(0.0, 1.0), (200.0, 0.9)];
    for (values, variable, knots) in [
        ([25.0, 109_375.0, 3.75e14, 0.01], 2, record),
        ([25.0, 109_375.0, 3e15, 1.0], 2, record),
        ([25.0, 109_375.0, 3e16, 100.0], 2, record),
        ([2.5e-5, 1.093_75e-13, 3.75e-10, 1e8], 1, record),
        ([2.5e-5, 1.093_75e-13, 3.75e-16, 100.0], 1, record),
        ([2.5e-5, 1.093_75e-13, 3.75e-16, 100.0], 0, fall),
        ([2.5e-5, 1.093_75e-13, 3.75e-16, 100.0], 1, fall),
        ([25.0, 109_375.0, 3e16, 100.0], 2, fall),
        ([25.0, 109_375.0, 3.75e14, 0.01], 2, fall),
        ([2.5e-5, 1.093_75e-13, 3.75e-10, 1e8], 1, fall),
    ] {
        let mut single = values.map(|x| Dual32::from(x as f32));
        single[variable] = single[variable].derivative();
        let mut double = single.map(|x| Dual64::from(f64::from(x.re)));
        double[variable] = double[variable].derivative();
        let (found, expected) = (peak_after_a_fall(single, knots)?, peak_after_a_fall(double, knots)?);
        // The derivative is a difference of shares of the pressure, and that is off by its rounding.
        let share = expected.re / double[variable].re;
        let rounding = 2.0 * budget::PRESSURE.single * f64::from(f32::EPSILON);
        let error = (f64::from(found.eps) - expected.eps).abs();
        let allowed = rounding * (expected.eps.abs() + share);
        assert!(error <= allowed, "{found} instead of {expected} for {values:?}");
    }
    Ok(())
}

/// Where the range ends far beyond the radius, what is computed at its end leaves the format, and more so what
/// derivatives are quotients by.
#[test]
fn a_distant_end_of_the_range_leaves_derivatives_alone() -> Result<(), Failure> {
    let mut count = 0;
    for (n, p) in [(2.37_f32, 4.11_f32), (2.0, 4.0), (3.0, 9.0)] {
        for d in [1.5e-6_f32, 1e-7, 1e-10, 1e-15] {
            let constant = Dual32::from;
            let terms = [(constant(0.97).derivative(), constant(n)), (constant(-d), constant(p))];
            let profile = Polynomial::new(terms)?;
            let largest = profile.load_integral(profile.max_radius()).re;
            for k in 0..500 {
                let load_integral = 10_f32.powf(-5.0 + 0.02 * k as f32);
                if load_integral > 0.5 * largest {
                    break;
                }
                let a = profile.radius(constant(load_integral))?;
                // da/dc = −(∂J/∂c)/J′
                let [re, n, p] = [a.re, n, p].map(f64::from);
                let of_term = |n: f64| n * re.powf(n + 4.0) / (n + 2.0);
                let log_slope = f64::from(0.97_f32) * of_term(n) - f64::from(d) * of_term(p);
                let expected = -re * of_term(n) / (n + 4.0) / log_slope;
                let error = (f64::from(a.eps) / expected - 1.0).abs() / f64::from(f32::EPSILON);
                // The power n + 4 of the radius, and half of the range is left.
                assert!(
                    error < 16.0,
                    "r^{n} − {d:e} r^{p}, {load_integral:e}: {a}, not {expected}: {error} ε"
                );
                count += 1;
            }
        }
    }
    assert!(count > 5000, "{count} of 6000 load integrals are within half of the range");
    Ok(())
}

/// Where δ₀′ nearly vanishes, the slope of J is smaller than J: here its reciprocal leaves the format, and the derivative
/// of a small radius does not.
#[test]
fn slopes_need_no_reciprocal() -> Result<(), Failure> {
    let constant = Dual32::from;
    let slope = |octaves: i32| -> Result<f32, Failure> {
        let unit = 2_f32.powi(octaves);
        let terms = [(0.05, 2_u8), (-0.083_325, 3), (0.037_5, 4)]
            .map(|(c, n)| (constant(c * unit * 2_f32.powi(20 * i32::from(n))), constant(f32::from(n))));
        let gap = Polynomial::new(terms)?;
        let load_integral = gap.load_integral(constant(2_f32.powi(-20))).re;
        Ok(gap.radius(constant(load_integral).derivative())?.eps * unit)
    };
    let (found, expected) = (slope(-32)?, slope(28)?);
    // The sizes of its terms are 2e4 times as large as the slope of J.
    let error = relative_error(found.into(), expected.into(), f32::EPSILON.into());
    assert!(error <= 2e4, "{found:e} instead of {expected:e}");
    Ok(())
}

/// The derivatives of 1/d have factors 1/d² and 1/d³, which leave single precision long before a coefficient d does.
#[test]
fn small_coefficients_leave_second_derivatives_alone() -> Result<(), Failure> {
    for d in [1e-10_f32, 1e-15, 1e-20, 1e-25, 1e-30] {
        let constant = Dual2_32::from;
        let terms = [(0.3_f32, 0.25_f32), (d, 64.0)];
        let profile = Polynomial::new(terms.map(|(c, n)| (constant(c), constant(n))))?;
        for k in 0..200 {
            let load_integral = 10_f32.powf(-2.0 + 0.02 * k as f32);
            let a = profile.radius(constant(load_integral).derivative())?;
            // d²a/dy² = −J″/J′³
            let derivative = |order: i32| -> f64 {
                let of_term = |(c, n): (f32, f32)| {
                    let (c, n, a) = (f64::from(c), f64::from(n), f64::from(a.re));
                    let falling: f64 = (0..order).map(|k| n + 4.0 - f64::from(k)).product();
                    c * n / ((n + 2.0) * (n + 4.0)) * falling * a.powf(n + 4.0 - f64::from(order))
                };
                terms.into_iter().map(of_term).sum()
            };
            let expected = -derivative(2) / derivative(1).powi(3);
            let error = (f64::from(a.v2) / expected - 1.0).abs() / f64::from(f32::EPSILON);
            // Twice the power of the steepest term.
            assert!(error < 136.0, "{d:e}, {load_integral:e}: {a}, not {expected}: {error} ε");
        }
    }
    Ok(())
}
