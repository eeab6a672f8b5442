//! Laws that relate the functions of a geometry to each other, and generated solvers to polynomials.

use cartcontact::{GapProfile, Polynomial, ProfileError, Scalar, gap_profile};
use proptest::prelude::*;
use tests::budget;
use tests::condition::degree;
use tests::kernel::{self, Kernel};
use tests::measure::{Errors, Exact, relative_error};
use tests::oracle::{Profile, double as exact};
use tests::profiles::cases;
use tests::quadrature::Graded;
use tests::random::{self, magnitude};

proptest! {
    #![proptest_config(random::cases(400))]

    #[test]
    fn generated_solvers_agree_with_polynomials(index in 0..cases().len(), share in 0.0..1.0, q in 0.0..1.0) {
        let case = cases()[index];
        let a = share * case.max_radius.unwrap_or(20.0);
        for kernel @ Kernel { allowance, double, .. } in kernel::ALL {
            let (generated, polynomial) = (double(case.double, a, q * a), double(&case.polynomial(), a, q * a));
            let error = relative_error(generated, polynomial, f64::EPSILON);
            let allowed = 2.0 * allowance.double * kernel.condition(&case.of_sizes(), (a, q * a), generated);
            prop_assert!(error <= allowed, "{} of {case:?} at {a}, {q}: {error}", allowance.quantity);
        }
    }

    /// The factored kernel keeps its digits up to the edge: G = ¼ ∫ δ₀′(s) (s² − r²) ds over s from r to a.
    #[test]
    fn pressure_kernel_is_accurate_up_to_the_edge(
        index in 0..cases().len(),
        share in 0.01..1.0,
        depth in magnitude(-12.0..-0.5),
    ) {
        let case = cases()[index];
        let a = share * case.max_radius.unwrap_or(16.0);
        let r = a * (1.0 - depth);
        // Integrated outwards from r with the exact a − r, because r is not exactly a (1 − depth).
        let depth = a - r;
        let integral = Graded::new(40, 0).integrate(0.0, depth, |h| {
            case.double.approach_slope(r + h) * h * (r + (r + h)) / 4.0
        });
        let error = relative_error(case.double.pressure_kernel(a, r), integral, f64::EPSILON);
        let condition = kernel::PRESSURE.condition(&case.of_sizes(), (a, r), integral);
        let allowed = budget::PRESSURE_KERNEL_BY_QUADRATURE.double * condition;
        prop_assert!(error <= allowed, "{case:?} at {a}, {depth:e}: {error}");
    }

    /// δ₀′ = (2/a) (Φ − δ₀).
    #[test]
    fn slope_of_approach_is_what_the_gap_exceeds_its_mean_by(index in 0..cases().len(), share in 1e-3..1.0) {
        let case = cases()[index];
        let a = share * case.max_radius.unwrap_or(20.0);
        let (gap, approach) = (case.double.gap(a), case.double.approach(a));
        let difference = 2.0 * (gap - approach) / a;
        // δ₀ and a δ₀′/2 are the shares 2/(n+2) and n/(n+2) of each term of Φ.
        let shares = budget::APPROACH.double.max(budget::APPROACH_SLOPE.double);
        let allowed = 2.0 * (budget::GAP.double + shares) * f64::EPSILON * case.of_sizes().gap(a) / a;
        prop_assert!((case.double.approach_slope(a) - difference).abs() <= allowed, "{case:?} at {a}");
    }

    /// J(a) − J(a − depth) keeps its digits at any depth.
    #[test]
    fn drop_of_load_integral_is_accurate_at_any_depth(
        index in 0..cases().len(),
        share in 0.01..1.0,
        depth in magnitude(-15.0..0.0),
    ) {
        let case = cases()[index];
        let a = share * case.max_radius.unwrap_or(16.0);
        let depth = a * depth;
        // J′ = a⁴ δ₀′/2.
        let slope = |s: f64| s * s * s * s * case.double.approach_slope(s) / 2.0;
        let integral = Graded::new(40, 2).integrate(0.0, depth, |h| slope(a - h));
        let sizes = case.of_sizes();
        // The degree multiplies the rounding of radii, here and in the quadrature.
        let condition = sizes.load_integral_drop(a, depth) * (1.0 + degree(&sizes, a) / 4.0);
        for found in [case.double.load_integral_drop(a, depth), case.polynomial().load_integral_drop(a, depth)] {
            let allowed = budget::LOAD_INTEGRAL_DROP.double * f64::EPSILON * condition;
            prop_assert!((found - integral).abs() <= allowed, "{case:?} at {a}, {depth:e}: {found} {integral}");
        }
    }
}

#[test]
fn all_kernels_but_the_slope_of_a_cone_vanish_at_the_centre() {
    for case in cases() {
        for Kernel { allowance, double, .. } in kernel::ALL {
            let found = double(case.double, 0.0, 0.0);
            if allowance.quantity == budget::APPROACH_SLOPE.quantity {
                // It is 2C/3 for a cone.
                let expected =
                    case.terms.iter().filter(|term| term.1 == 1.0).map(|term| 2.0 * term.0 / 3.0).sum();
                let error = relative_error(found, expected, f64::EPSILON);
                assert!(error <= allowance.double, "{case:?}: {found} instead of {expected}");
            } else {
                assert_eq!(found, 0.0, "{} of {case:?}", allowance.quantity);
            }
        }
    }
}

/// In one call they share the coefficients, which change no digit: neither where only the load integral takes double
/// words, nor where both do, nor where numbers overflow.
#[test]
fn approach_and_load_integral_are_those_of_each_alone() {
    #[gap_profile(c * r^2)]
    struct Multiple<T> {
        c: T,
    }
    #[gap_profile((1/inner - 1/outer) * r^2 / 2 + inner^0.5 * r^3.5 / 1e4, max_radius = 100 * inner)]
    struct Nested<T> {
        inner: T,
        outer: T,
    }
    fn agree<T: Scalar>(profile: &impl GapProfile<T>) {
        for exponent in -40..40 {
            let a = T::constant(1.37_f64.powi(exponent));
            let alone = (profile.approach(a), profile.load_integral(a));
            assert_eq!(profile.approach_and_load_integral(a), alone, "{a}");
        }
    }
    for k in 1..20 {
        let c = 0.013 * f64::from(k);
        agree(&Multiple { c });
        agree(&Multiple { c: c as f32 });
        agree(&Multiple { c: c as f32 * 1e37 });
        agree(&Nested { inner: c, outer: 2.0 });
        agree(&Nested { inner: c as f32, outer: 2.0 });
    }
}

#[test]
fn pressure_kernel_is_zero_outside() {
    for case in cases() {
        for a in [1e-3, 1.0, 7.0] {
            for r in [a, a * (1.0 + f64::EPSILON), 2.0 * a, 1e300, f64::INFINITY] {
                assert_eq!(case.double.pressure_kernel(a, r), 0.0, "{case:?} at {a}, {r}");
                assert_eq!(case.polynomial().pressure_kernel(a, r), 0.0, "{case:?} at {a}, {r}");
            }
        }
    }
}

#[gap_profile(0.37 * r^63.9)]
struct Steep;

#[gap_profile(0.37 * r^33)]
struct Whole;

#[gap_profile(0.37 * r^17)]
struct Odd;

#[gap_profile(0.37 * r^12)]
struct Even;

/// Next to the edge the kernel is far smaller than the power in it, which may overflow.
#[test]
fn pressure_kernel_is_a_number_where_the_power_in_it_is_none() {
    let kernel = |n: &str, a: f64, r: f64| {
        Exact::from(&Profile::of_decimals(&[("0.37", n)]).pressure_kernel(&exact(a), &exact(r)))
    };
    let mut errors = Errors::of_single(budget::PRESSURE_KERNEL);
    let single: [(&dyn GapProfile<f32>, &str, f32, f32); 4] = [
        (&Steep, "63.9", 5.2687073, 5.268_619),
        (&Whole, "33", 16.371202, 16.37119),
        (&Odd, "17", 250.0, 249.999_98),
        (&Even, "12", 999.9461, 999.7702),
    ];
    for (profile, n, a, r) in single {
        errors.add(profile.pressure_kernel(a, r).into(), kernel(n, a.into(), r.into()), 1.0, &(n, a, r));
    }
    errors.check();
    let mut errors = Errors::of(budget::PRESSURE_KERNEL);
    let (a, r) = (86328.82540994423, 86328.82540901842);
    errors.add(Steep.pressure_kernel(a, r), kernel("63.9", a, r), 1.0, &(a, r));
    errors.check();
}

/// The product of the coefficient and the zero at the edge may leave the format, too.
#[test]
fn pressure_kernel_is_a_number_where_no_product_of_two_factors_is() -> Result<(), ProfileError> {
    fn add<T: Scalar>(
        errors: &mut Errors,
        terms: &[(f64, f64)],
        a: f64,
        inset: f64,
    ) -> Result<(), ProfileError> {
        let profile = Polynomial::new(
            terms.iter().map(|&(c, n)| (T::constant(c), T::constant(n))).collect::<Vec<_>>(),
        )?;
        let [a, r] = [a, a * (1.0 - inset)].map(T::constant);
        let rounded: Vec<_> = profile.terms().iter().map(|&(c, n)| (c.value(), n.value())).collect();
        let expected = Profile::of(&rounded).pressure_kernel(&exact(a.value()), &exact(r.value()));
        errors.add(profile.pressure_kernel(a, r).value(), Exact::from(&expected), 1.0, &(terms, inset));
        Ok(())
    }
    let (mut double, mut single) =
        (Errors::of(budget::PRESSURE_KERNEL), Errors::of_single(budget::PRESSURE_KERNEL));
    for inset in [1e-3, 1e-4, 1e-5] {
        add::<f32>(&mut single, &[(1e-28, 2.0), (1e-36, 2.5)], 8.9e16, inset)?;
        add::<f64>(&mut double, &[(1e-300, 300.0)], 107.8, 1e-4 * inset)?;
    }
    double.check();
    single.check();
    Ok(())
}

/// C aⁿ⁺² is out of range, but n times that is not.
#[test]
fn quick_kernels_of_tiny_exponents_are_numbers() -> Result<(), ProfileError> {
    let (a, profile) = (3e160, Polynomial::new([(1e-10, 1e-3)])?);
    for r in [0.0, 0.5 * a, 0.999 * a] {
        let (quick, precise) = (profile.quick_pressure_kernel(a, r), profile.pressure_kernel(a, r));
        let error = relative_error(quick, precise, f64::EPSILON);
        assert!(error <= 2.0 * budget::PRESSURE_KERNEL.double, "{r:e}: {quick:e} instead of {precise:e}");
    }
    Ok(())
}

#[gap_profile(0.286 * r^64)]
struct Steepest;

#[gap_profile(0.0025 * r^2 + 2.2e-81 * r^62)]
struct FarApart;

/// There a product with a hardly changes the digits, so that all may round in the same direction.
#[test]
fn quick_values_are_right_next_to_powers_of_two_and_their_roots() {
    for (profile, scale) in [(&Steepest as &dyn GapProfile<f64>, 0.25), (&FarApart, 512.0)] {
        for power in [1.0, 2.0_f64.sqrt(), 2.0_f64.powf(0.25)] {
            for k in 0..500 {
                let a = scale * power * (1.0 + f64::from(k) * f64::EPSILON);
                let pairs = [
                    (profile.quick_load_integral(a), profile.load_integral(a)),
                    (profile.quick_approach(a), profile.approach(a)),
                    (profile.quick_approach_slope(a), profile.approach_slope(a)),
                    (profile.quick_pressure_kernel(a, 0.0), profile.pressure_kernel(a, 0.0)),
                    (
                        profile.load_integral_drop(a, 0.25 * a),
                        profile.load_integral(a) - profile.load_integral(0.75 * a),
                    ),
                ];
                for (quick, precise) in pairs {
                    // Either may be off by that; the worst here is 2 ε.
                    let allowed = 2.0 * budget::PRESSURE_KERNEL.double;
                    let error = relative_error(quick, precise, f64::EPSILON);
                    assert!(error <= allowed, "{error} ε at {a:e}: {quick:e} instead of {precise:e}");
                }
            }
        }
    }
}
