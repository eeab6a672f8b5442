//! The functions of geometries with fields against the oracle, at random values of the fields and random radii that are
//! the same in every run.

use core::fmt::Debug;

use cartcontact::{GapProfile, gap_profile};
use tests::budget::FUNCTION_OF_FIELDS;
use tests::kernel::{self, Kernel};
use tests::measure::{Errors, Exact};
use tests::oracle::number::whole;
use tests::oracle::{Profile, Real, decimal, double};
use tests::random::Stream;

/// How many values of the fields and radii each geometry is given, in both precisions.
const DRAWS: u64 = 150;
const SEED: u64 = 20_261_123;

/// The terms (coefficient, exponent) of a gap.
type Terms = Vec<(Real, Real)>;

mod shapes {
    use super::gap_profile;

    #[gap_profile(c * r^5)]
    pub(super) struct Fifth {
        pub(super) c: f64,
    }
    #[gap_profile(c * r^2.3)]
    pub(super) struct Decimal {
        pub(super) c: f64,
    }
    #[gap_profile(c * r^2 + d * r^2.5)]
    pub(super) struct Halves {
        pub(super) c: f64,
        pub(super) d: f64,
    }
    #[gap_profile(b * r + r^2 / 30 + d * r^3)]
    pub(super) struct WithAConstant {
        pub(super) b: f64,
        pub(super) d: f64,
    }
    #[gap_profile(0.05 * r^2 + d * r^4)]
    pub(super) struct BesideADecimal {
        pub(super) d: f64,
    }
    #[gap_profile(0.7 * r^2.3 + d * r^2.5)]
    pub(super) struct BesideADecimalOfAFraction {
        pub(super) d: f64,
    }
    #[gap_profile(r^2.3 / (3 * radius))]
    pub(super) struct DecimalOfALength {
        pub(super) radius: f64,
    }
    #[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3))]
    pub(super) struct Ball {
        pub(super) radius: f64,
    }
    #[gap_profile(sphere(radius), order = 16)]
    pub(super) struct Sphere {
        pub(super) radius: f64,
    }
    #[gap_profile(upper = sphere(first), lower = sphere(second), order = 4)]
    pub(super) struct TwoSpheres {
        pub(super) first: f64,
        pub(super) second: f64,
    }
    #[gap_profile(b / (c^5 * d^5) * r^2 + r^4 / c + r^6 / d)]
    pub(super) struct ManyDivisors {
        pub(super) b: f64,
        pub(super) c: f64,
        pub(super) d: f64,
    }
    // The base 3 (b + d) has all its digits, and the second exponent is no multiple of 1/4.
    #[gap_profile((3 * (b + d))^-1.5 * r^2 + (b / 7)^2.2 * r^4)]
    pub(super) struct Powers {
        pub(super) b: f64,
        pub(super) d: f64,
    }
}

/// Compares all functions of a geometry that is made from three numbers with those of its terms.
fn check<P: GapProfile<f64> + GapProfile<f32>>(
    profile: impl Fn([f64; 3]) -> P,
    terms: impl Fn([Real; 3]) -> Terms,
) {
    let [mut errors, mut errors_of_single] =
        [Errors::of(FUNCTION_OF_FIELDS), Errors::of_single(FUNCTION_OF_FIELDS)];
    for case in 0..DRAWS {
        let mut stream = Stream::of_case(SEED, case);
        let fields = [(); 3].map(|()| stream.magnitude(-1.0, 3.0));
        let a = stream.magnitude(-1.0, 2.0);
        let r = a * (1.0 - stream.magnitude(-6.0, 0.0));
        let oracle = Profile::of_numbers(terms(fields.map(double)));
        compare(&profile(fields), &oracle, (a, r), &fields, &mut errors);
        // The same in numbers that single precision holds.
        let fields = fields.map(single);
        let oracle = Profile::of_numbers(terms(fields.map(double)));
        compare_in_single(&profile(fields), &oracle, (a as f32, r as f32), &fields, &mut errors_of_single);
    }
    errors.check_worst();
    errors_of_single.check_worst();
}

fn compare(
    profile: &dyn GapProfile<f64>,
    oracle: &Profile,
    (a, r): (f64, f64),
    fields: &dyn Debug,
    errors: &mut Errors,
) {
    for Kernel { double: compute, oracle: define, .. } in kernel::ALL {
        let expected = Exact::from(&define(oracle, &double(a), &double(r)));
        errors.add(compute(profile, a, r), expected, 1.0, &(fields, a, r));
    }
}

fn compare_in_single(
    profile: &dyn GapProfile<f32>,
    oracle: &Profile,
    (a, r): (f32, f32),
    fields: &dyn Debug,
    errors: &mut Errors,
) {
    for Kernel { single: compute, oracle: define, .. } in kernel::ALL {
        let expected = Exact::from(&define(oracle, &double(a.into()), &double(r.into())));
        let is_in_range = (f64::from(f32::MIN_POSITIVE)..1e34).contains(&expected.nearest);
        if is_in_range {
            errors.add(compute(profile, a, r).into(), expected, 1.0, &(fields, a, r));
        }
    }
}

fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The terms of a sphere up to r^(2 `count`): R − √(R² − r²).
fn of_sphere(radius: &Real, count: i64) -> Terms {
    let mut coefficient = whole(1) / (whole(2) * radius);
    let mut terms = Vec::new();
    for k in 1..=count {
        terms.push((coefficient.clone(), whole(2 * k)));
        coefficient = coefficient * whole(2 * k - 1) / (whole(2 * k + 2) * radius * radius);
    }
    terms
}

#[test]
fn weights_of_fields_are_not_rounded() {
    check(|[c, ..]| shapes::Fifth { c }, |[c, ..]| vec![(c, whole(5))]);
    check(|[c, ..]| shapes::Decimal { c }, |[c, ..]| vec![(c, decimal("2.3"))]);
    check(|[c, d, _]| shapes::Halves { c, d }, |[c, d, _]| vec![(c, whole(2)), (d, decimal("2.5"))]);
    check(
        |[b, d, _]| shapes::WithAConstant { b, d },
        |[b, d, _]| vec![(b, whole(1)), (whole(1) / whole(30), whole(2)), (d, whole(3))],
    );
}

/// Fields so small that the constant decides.
#[test]
fn constants_beside_fields_are_not_rounded() {
    let small = |d: f64| d * 2f64.powi(-20);
    let exact = |d: Real| d / whole(1 << 20);
    check(
        |[d, ..]| shapes::BesideADecimal { d: small(d) },
        |[d, ..]| vec![(decimal("0.05"), whole(2)), (exact(d), whole(4))],
    );
    check(
        |[d, ..]| shapes::BesideADecimalOfAFraction { d: small(d) },
        |[d, ..]| vec![(decimal("0.7"), decimal("2.3")), (exact(d), decimal("2.5"))],
    );
}

#[test]
fn quotients_of_fields_are_not_rounded() {
    check(
        |[radius, ..]| shapes::DecimalOfALength { radius },
        |[radius, ..]| vec![(whole(1) / (whole(3) * radius), decimal("2.3"))],
    );
    check(|[radius, ..]| shapes::Ball { radius }, |[radius, ..]| of_sphere(&radius, 2));
    check(|[radius, ..]| shapes::Sphere { radius }, |[radius, ..]| of_sphere(&radius, 8));
    check(
        |[first, second, _]| shapes::TwoSpheres { first, second },
        |[first, second, _]| {
            let pairs = of_sphere(&first, 2).into_iter().zip(of_sphere(&second, 2));
            pairs.map(|((first, n), (second, _))| (first + second, n)).collect()
        },
    );
}

#[test]
fn powers_of_fields_are_not_rounded() {
    check(
        |[b, d, _]| shapes::Powers { b, d },
        |[b, d, _]| {
            let power = |base: Real, exponent: &str| (decimal(exponent) * base.ln()).exp();
            let first = power(whole(3) * (&b + d), "-1.5");
            vec![(first, whole(2)), (power(b / whole(7), "2.2"), whole(4))]
        },
    );
}

/// R^−15 is infinite, but not 429/32768 of it, the coefficient of r^16.
#[test]
fn powers_of_an_inverse_may_leave_the_format() {
    let [mut errors, mut errors_of_single] =
        [Errors::of(FUNCTION_OF_FIELDS), Errors::of_single(FUNCTION_OF_FIELDS)];
    let sphere =
        |radius: f64| (shapes::Sphere { radius }, Profile::of_numbers(of_sphere(&double(radius), 8)));
    for share in [0.2, 0.7, 0.9] {
        let radius = 2.4e-21;
        let (solver, oracle) = sphere(radius);
        let a = share * radius;
        compare(&solver, &oracle, (a, 0.5 * a), &radius, &mut errors);
        let radius = single(2.3e-3);
        let (solver, oracle) = sphere(radius);
        let a = (share * radius) as f32;
        compare_in_single(&solver, &oracle, (a, 0.5 * a), &radius, &mut errors_of_single);
    }
    errors.check();
    errors_of_single.check();
}

/// Neither b/c⁵ nor b/d⁵ need be in the format, as c⁵ d⁵ is.
#[test]
fn products_of_divisors_need_no_quotient_on_the_way() {
    let [mut errors, mut errors_of_single] =
        [Errors::of(FUNCTION_OF_FIELDS), Errors::of_single(FUNCTION_OF_FIELDS)];
    let shape = |fields: [f64; 3]| {
        let ([b, c, d], [exact_b, exact_c, exact_d]) = (fields, fields.map(double));
        let fifth = |x: &Real| x * x * x * x * x;
        let first = exact_b / (fifth(&exact_c) * fifth(&exact_d));
        let terms = [(first, whole(2)), (whole(1) / exact_c, whole(4)), (whole(1) / exact_d, whole(6))];
        (shapes::ManyDivisors { b, c, d }, Profile::of_numbers(terms.to_vec()))
    };
    for (b, [c, d]) in [(3e6, [1e-7, 5e6]), (3e6, [5e6, 1e-7]), (3e-6, [1e-7, 5e6]), (3e-6, [5e6, 1e-7])] {
        let (a, r) = (1.3, 0.6);
        let fields = [b, c, d].map(single);
        let (solver, oracle) = shape(fields);
        compare_in_single(&solver, &oracle, (a as f32, r as f32), &fields, &mut errors_of_single);
        let fields = [b.powi(6), c.powi(8), d.powi(8)];
        let (solver, oracle) = shape(fields);
        compare(&solver, &oracle, (a, r), &fields, &mut errors);
    }
    errors.check();
    errors_of_single.check();
}
