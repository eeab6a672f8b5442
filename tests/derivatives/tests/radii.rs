//! Contact radii of dual numbers: the values of plain numbers, and derivatives up to the third.

use cartcontact::{GapProfile, Polynomial, ProfileError, RadiusError, Scalar, gap_profile};
use num_dual::{Dual2_64, Dual3_64, Dual32, Dual64, DualSVec64, HyperDual64, HyperHyperDual64};
use tests::measure::relative_error;
use tests::profiles::{MixedSign, Patellofemoral};

/// Two even powers, for which fields set the units.
#[gap_profile(b * r^2 + 1.09375e-4 * c * r^4)]
#[derive(Clone, Copy)]
struct Even<T> {
    b: T,
    c: T,
}

/// A single term.
#[gap_profile(b * r^2.5)]
#[derive(Clone, Copy)]
struct Single<T> {
    b: T,
}

/// Whole powers of the square root.
#[gap_profile(b * r^2 + 0.01 * r^2.5)]
#[derive(Clone, Copy)]
struct Halves<T> {
    b: T,
}

/// Whole powers of the fifth root.
#[gap_profile(b * r^2 + 0.01 * r^2.2)]
#[derive(Clone, Copy)]
struct Fifths<T> {
    b: T,
}

/// Three coefficients have no units in common.
#[gap_profile(b * r^2 + 1e-3 * r^3 + 2e-4 * r^4)]
#[derive(Clone, Copy)]
struct Whole<T> {
    b: T,
}

/// Three coefficients, and powers of the square root.
#[gap_profile(b * r^2 + 1e-3 * r^2.5 + 2e-4 * r^4)]
#[derive(Clone, Copy)]
struct WholeOfRoot<T> {
    b: T,
}

/// Powers without a common root.
#[gap_profile(b * r^2 + 2e-3 * r^2.37)]
#[derive(Clone, Copy)]
struct Real<T> {
    b: T,
}

/// Terms of both signs, for which fields set the units.
#[gap_profile(b * r^2 - 1e-4 * r^4, max_radius = 9)]
#[derive(Clone, Copy)]
struct Falling<T> {
    b: T,
}

/// Its coefficient b, and its terms at b = 0.025.
trait Geometry {
    const TERMS: &'static [(f64, f64)];

    /// The most that a value may differ from the radius of plain numbers, in ε: the general solution evaluates J by fused
    /// operations only without derivatives.
    const DIFFERENCE: f64 = 0.0;

    /// The radius of a load integral.
    fn radius<T: Scalar>(b: T, load_integral: T) -> Result<T, RadiusError>;
}

macro_rules! geometries {
    ($($name:ident, $b:ident => $profile:expr, $terms:expr $(, $difference:literal)?;)*) => { $(
        struct $name;
        impl Geometry for $name {
            $(const DIFFERENCE: f64 = $difference;)?
            const TERMS: &'static [(f64, f64)] = &$terms;
            fn radius<T: Scalar>($b: T, load_integral: T) -> Result<T, RadiusError> {
                $profile.radius(load_integral)
            }
        }
    )* };
}

geometries! {
    OfEven, b => Even { b, c: T::one() }, [(0.025, 2.0), (1.09375e-4, 4.0)];
    OfSingle, b => Single { b }, [(0.025, 2.5)], 1.0;
    OfHalves, b => Halves { b }, [(0.025, 2.0), (0.01, 2.5)];
    OfFifths, b => Fifths { b }, [(0.025, 2.0), (0.01, 2.2)];
    OfWhole, b => Whole { b }, [(0.025, 2.0), (1e-3, 3.0), (2e-4, 4.0)];
    OfWholeOfRoot, b => WholeOfRoot { b }, [(0.025, 2.0), (1e-3, 2.5), (2e-4, 4.0)];
    OfReal, b => Real { b }, [(0.025, 2.0), (2e-3, 2.37)];
    OfFalling, b => Falling { b }, [(0.025, 2.0), (-1e-4, 4.0)];
    OfPolynomial, b => polynomial([(b, 2.0), (T::constant(2e-3), 2.37), (T::constant(1e-4), 4.0)]),
        [(0.025, 2.0), (2e-3, 2.37), (1e-4, 4.0)];
    OfFallingPolynomial, b => polynomial([(b, 2.0), (T::constant(-1e-4), 4.0), (T::constant(2e-6), 6.0)]),
        [(0.025, 2.0), (-1e-4, 4.0), (2e-6, 6.0)], 1.0;
}

fn polynomial<T: Scalar>(terms: [(T, f64); 3]) -> Polynomial<T, [(T, T); 3]> {
    let terms = terms.map(|(c, n)| (c, T::constant(n)));
    Polynomial::new(terms).unwrap_or_else(|error: ProfileError| unreachable!("{error}"))
}

/// The derivatives of the inverse of f = Σ k a^q at f(a).
fn derivatives_of_inverse(terms: &[(f64, f64)], a: f64) -> [f64; 3] {
    let sum = |factor: fn(f64) -> f64, order: f64| -> f64 {
        terms.iter().map(|&(k, q)| k * factor(q) * a.powf(q - order)).sum()
    };
    let first = sum(|q| q, 1.0);
    let second = sum(|q| q * (q - 1.0), 2.0);
    let third = sum(|q| q * (q - 1.0) * (q - 2.0), 3.0);
    [first.recip(), -second / first.powi(3), (3.0 * second * second - first * third) / first.powi(5)]
}

/// The derivatives of a radius with respect to the load integral y = Σ j a^p.
fn by_load_integral(terms: &[(f64, f64)], a: f64) -> [f64; 3] {
    derivatives_of_inverse(&weighted(terms), a)
}

/// The same with respect to the first coefficient b, which is (y − Σ′ j a^p)/(w a^p₁) with the sum of the other terms.
fn by_first_coefficient(terms: &[(f64, f64)], y: f64, a: f64) -> [f64; 3] {
    let (&(b, _), weighted) = (&terms[0], weighted(terms));
    let (weight, lowest) = (weighted[0].0 / b, weighted[0].1);
    let mut of_b = vec![(y / weight, -lowest)];
    of_b.extend(weighted[1..].iter().map(|&(j, p)| (-j / weight, p - lowest)));
    derivatives_of_inverse(&of_b, a)
}

/// The terms (j, p) of J.
fn weighted(terms: &[(f64, f64)]) -> Vec<(f64, f64)> {
    terms.iter().map(|&(c, n)| (c * n / ((n + 2.0) * (n + 4.0)), n + 4.0)).collect()
}

/// In ε: the closed forms themselves are sums of rounded powers, of which fifth powers are taken; the worst here is 67,
/// of a third derivative with respect to a coefficient of a vanishing share in J.
const ALLOWED: f64 = 100.0;

fn assert_derivatives(y: f64, found: &[f64], expected: [f64; 3], epsilon: f64) {
    for (&found, expected) in found.iter().zip(expected) {
        let error = relative_error(found, expected, epsilon);
        assert!(error <= ALLOWED, "{y}: {error} ε");
    }
}

/// Compares derivatives in all kinds of dual numbers, for load integrals from `least` on, each `factor` times the last.
fn compare<G: Geometry>(least: f64, factor: f64) -> Result<(), RadiusError> {
    let b = 0.025;
    for k in 0..60 {
        let y = least * factor.powi(k);
        let a = G::radius(b, y)?;
        for (expected, [by_y, by_b]) in
            [(by_load_integral(G::TERMS, a), [1.0, 0.0]), (by_first_coefficient(G::TERMS, y, a), [0.0, 1.0])]
        {
            // A value, and derivatives of the first, second and third order.
            let take = |value: f64, found: &[f64]| {
                assert!(
                    relative_error(value, a, f64::EPSILON) <= G::DIFFERENCE,
                    "{y}: {value} instead of {a}"
                );
                assert_derivatives(y, found, expected, f64::EPSILON);
            };
            let one = G::radius(Dual64::new(b, by_b), Dual64::new(y, by_y))?;
            take(one.re, &[one.eps]);
            let two = G::radius(Dual2_64::new(b, by_b, 0.0), Dual2_64::new(y, by_y, 0.0))?;
            take(two.re, &[two.v1, two.v2]);
            let three = G::radius(Dual3_64::new(b, by_b, 0.0, 0.0), Dual3_64::new(y, by_y, 0.0, 0.0))?;
            take(three.re, &[three.v1, three.v2, three.v3]);
            let hyper = |x: f64, d: f64| HyperDual64::new(x, d, d, 0.0);
            let hyper = G::radius(hyper(b, by_b), hyper(y, by_y))?;
            take(hyper.re, &[hyper.eps1, hyper.eps1eps2]);
            let all = |x: f64, d: f64| HyperHyperDual64::new(x, d, d, d, 0.0, 0.0, 0.0, 0.0);
            let all = G::radius(all(b, by_b), all(y, by_y))?;
            take(all.re, &[all.eps3, all.eps1eps3, all.eps1eps2eps3]);
            let [of_y, of_b]: [DualSVec64<1>; 2] = [(y, by_y), (b, by_b)].map(|(x, d)| {
                let mut x = DualSVec64::from_re(x);
                x.eps = num_dual::Derivative::some(nalgebra::SVector::from([d]));
                x
            });
            let vector = G::radius(of_b, of_y)?;
            let first = vector.eps.0.map_or(f64::NAN, |first| first[0]);
            take(vector.re, &[first]);
        }
    }
    Ok(())
}

#[test]
fn radii_have_the_values_of_plain_numbers_and_all_derivatives() -> Result<(), RadiusError> {
    compare::<OfEven>(0.01, 1.3)?;
    compare::<OfSingle>(0.01, 1.3)?;
    compare::<OfHalves>(0.01, 1.3)?;
    compare::<OfFifths>(0.01, 1.3)?;
    compare::<OfWhole>(0.01, 1.3)?;
    compare::<OfWholeOfRoot>(0.01, 1.3)?;
    compare::<OfReal>(0.01, 1.3)?;
    compare::<OfFalling>(0.01, 1.2)?;
    compare::<OfPolynomial>(0.01, 1.3)?;
    compare::<OfFallingPolynomial>(0.01, 1.15)
}

/// The largest error of first derivatives in single precision, in ε, beside those in double precision.
fn error_in_single<G: Geometry>() -> Result<f64, RadiusError> {
    let (b, mut largest) = (0.025_f32, 0.0);
    for k in 0..2000 {
        let y = (0.01 * 1.008_f64.powi(k)) as f32;
        for [by_y, by_b] in [[1.0, 0.0], [0.0, 1.0]] {
            let single = G::radius(Dual32::new(b, by_b), Dual32::new(y, by_y))?;
            let (b, y, by_b, by_y) = (b.into(), y.into(), by_b.into(), by_y.into());
            let double = G::radius(Dual64::new(b, by_b), Dual64::new(y, by_y))?;
            largest = f64::max(largest, relative_error(single.eps.into(), double.eps, f32::EPSILON.into()));
        }
    }
    Ok(largest)
}

/// The rounding of a radius, or of a root of it, is not multiplied by the powers that are taken of it: up to 32 in a
/// geometry of fifth roots.
#[test]
fn first_derivatives_are_right_to_a_few_roundings() -> Result<(), RadiusError> {
    for (name, error) in [
        ("Even", error_in_single::<OfEven>()?),
        ("Single", error_in_single::<OfSingle>()?),
        ("Halves", error_in_single::<OfHalves>()?),
        ("Fifths", error_in_single::<OfFifths>()?),
        ("Whole", error_in_single::<OfWhole>()?),
        ("WholeOfRoot", error_in_single::<OfWholeOfRoot>()?),
        ("Real", error_in_single::<OfReal>()?),
        ("Polynomial", error_in_single::<OfPolynomial>()?),
    ] {
        println!("{name}: {error}");
        assert!(error < 4.0, "{name}: {error} ε");
    }
    Ok(())
}

/// Outside the tables of seeds.
#[test]
fn radii_of_tiny_and_huge_load_integrals_have_all_derivatives() -> Result<(), RadiusError> {
    for least in [1e-60, 1e40] {
        compare::<OfEven>(least, 1.3)?;
        compare::<OfHalves>(least, 1.3)?;
        compare::<OfWhole>(least, 1.3)?;
        compare::<OfReal>(least, 1.3)?;
        compare::<OfPolynomial>(least, 1.3)?;
        compare::<OfFallingPolynomial>(least, 1.3)?;
    }
    Ok(())
}

/// Infinite derivatives would make the radius no number.
#[test]
fn radii_of_load_integrals_at_the_ends_of_the_format_are_refused() -> Result<(), ProfileError> {
    let terms = [(0.2, 0.7), (0.03, 1.7), (2e-3, 3.1)].map(|(c, n)| (Dual64::from(c), Dual64::from(n)));
    let gap = Polynomial::new(terms)?;
    let mut refused = 0;
    for y in [5e-324, 1e-310, 1e-300, 1e300, 1e308, f64::MAX] {
        let found = gap.radius(Dual64::from(y).derivative());
        let is_refused = found == Err(RadiusError::Unrepresentable { load_integral: y });
        assert!(is_refused || found.as_ref().is_ok_and(|found| !found.re.is_nan()), "{y:e}: {found:?}");
        refused += u32::from(is_refused);
    }
    assert!(refused > 0);
    Ok(())
}

/// Of constants only the load integral has derivatives.
#[test]
fn radii_of_constants_have_the_values_of_plain_numbers_and_all_derivatives() -> Result<(), RadiusError> {
    fn radius<T: Scalar>(which: usize, load_integral: T) -> Result<T, RadiusError> {
        if which == 0 { Patellofemoral.radius(load_integral) } else { MixedSign.radius(load_integral) }
    }
    let terms: [&[(f64, f64)]; 2] =
        [&[(0.025, 2.0), (1.09375e-4, 4.0)], &[(0.05, 2.0), (-0.004, 3.0), (2e-4, 4.0)]];
    for (which, terms) in terms.into_iter().enumerate() {
        for k in 0..200 {
            let y = 0.01 * 1.07_f64.powi(k);
            let (a, found) = (radius(which, y)?, radius(which, Dual3_64::from(y).derivative())?);
            assert_eq!(found.re.to_bits(), a.to_bits(), "{y}");
            let expected = by_load_integral(terms, a);
            assert_derivatives(y, &[found.v1, found.v2, found.v3], expected, f64::EPSILON);
            let y = y as f32;
            let (a, found) = (radius(which, y)?, radius(which, Dual32::from(y).derivative())?);
            assert_eq!(found.re.to_bits(), a.to_bits(), "{y}");
            let expected = by_load_integral(terms, f64::from(a));
            assert_derivatives(f64::from(y), &[f64::from(found.eps)], expected, f64::from(f32::EPSILON));
        }
    }
    Ok(())
}
