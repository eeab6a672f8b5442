//! Dual numbers carry exact derivatives through a whole contact.

use core::f64::consts::PI;

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, ContactError, GapProfile, Layer, Medium, Polynomial, Scalar, gap_profile};
use derivatives::{SLOPE, assert_close};
use num_dual::{Dual3_64, Dual32, Dual64};
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::{Fall, Rise};
use tests::measure::relative_error;
use tests::profiles::Blunt;

type Failure = Box<dyn core::error::Error>;

/// A ball over any scalar.
#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3))]
struct Ball<T> {
    radius: T,
}

/// x with the derivative 1.
fn variable(x: f64) -> Dual64 {
    Dual64::from(x).derivative()
}

/// The slope of `f` at `x` by central differences of fourth order in h, to about ten digits.
fn slope(f: impl Fn(f64) -> f64, x: f64, h: f64) -> f64 {
    (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h)
}

/// In ε: how much differences over steps of a thousandth of x are off, whose 3/2 over the step multiplies results off by
/// a few ε each; the worst here is 4.5e-12, twenty thousand.
const DIFFERENCES: f64 = 1e-11 / f64::EPSILON;
/// The share of P/F by which such differences may miss the derivative of a pressure under a load from nothing; the
/// worst here is 4e-13.
const DIFFERENCES_FROM_NOTHING: f64 = 1e-12;
/// In ε: the sixth root of a quotient by `powf`, and a product with it.
const CLOSED_FORM: f64 = 4.0;

/// Compares radius, approach and pressure at 3 mm with those of plain numbers.
fn assert_same(dual: [Dual64; 3], plain: [f64; 3]) {
    // The approach has a degree of at most 4.
    let of_pressure = budget::PRESSURE.double * edge(plain[0], 3.0);
    let allowed = [budget::CONTACT_RADIUS.double, 5.0 * budget::CONTACT_APPROACH.double, of_pressure];
    for ((dual, plain), allowed) in dual.into_iter().zip(plain).zip(allowed) {
        assert_close(dual.re, plain, 2.0 * allowed);
    }
}

/// a = (48 F (1 + χ t)/(π m C))^(1/6) with respect to F.
#[test]
fn slope_of_a_radius_is_that_of_its_closed_form() -> Result<(), Failure> {
    let profile = Polynomial::new([(Dual64::from(0.025), Dual64::from(2.0))])?;
    let contact = joint(profile, 0.0015, Constant(variable(100.0)));
    for t in [0.0, 200.0] {
        let now = contact.at(Dual64::from(t))?;
        let a = (48.0 * 100.0 * (1.0 + 0.0015 * t) / (PI * 0.375 * 0.025)).powf(1.0 / 6.0);
        assert_close(now.radius().re, a, budget::CONTACT_RADIUS.double + CLOSED_FORM);
        assert_close(now.radius().eps, a / 600.0, SLOPE);
        // δ₀ = C a²/2 grows with F^(1/3).
        assert_close(now.approach().eps, now.approach().re / 300.0, SLOPE);
    }
    Ok(())
}

/// P(0, 0) = 3 F/(π a²) of a paraboloid, with respect to F, C and m.
#[test]
fn slope_of_the_first_peak_pressure_is_that_of_its_closed_form() -> Result<(), Failure> {
    let peak = |c, m, force| -> Result<Dual64, Failure> {
        let profile = Polynomial::new([(c, Dual64::from(2.0))])?;
        let contact =
            Contact::new(profile, Medium::from_constants(m, Dual64::from(0.0015))?, Constant(force))?;
        Ok(contact.at(Dual64::from(0.0))?.peak_pressure())
    };
    let [c, m, force] = [0.025, 0.375, 100.0];
    let plain = Dual64::from;
    // P ∝ F^(2/3) (m C)^(1/3).
    for (found, share, x) in [
        (peak(plain(c), plain(m), variable(force))?, 2.0 / 3.0, force),
        (peak(variable(c), plain(m), plain(force))?, 1.0 / 3.0, c),
        (peak(plain(c), variable(m), plain(force))?, 1.0 / 3.0, m),
    ] {
        assert_close(found.eps, share * found.re / x, SLOPE);
    }
    Ok(())
}

/// Radius, approach and pressure at 3 mm, after a ramp and a hold.
fn results<T: Scalar>(profile: &impl GapProfile<T>, permeability: T, force: T) -> Result<[T; 3], Failure> {
    let constant = T::constant;
    let layer = Layer { thickness: constant(1.0), shear_modulus: constant(0.25), permeability };
    let load = PiecewiseLinear::new([(constant(0.0), force * constant(0.2)), (constant(30.0), force)])?;
    let contact = Contact::new(profile, Medium::between(layer, layer)?, load)?;
    let now = contact.at(constant(200.0))?;
    Ok([now.radius(), now.approach(), now.pressure(constant(3.0))])
}

/// Compares the derivatives in `dual` with differences of `plain` about `x`.
fn compare(dual: [Dual64; 3], plain: impl Fn(f64) -> [f64; 3], x: f64) {
    assert_same(dual, plain(x));
    for (index, dual) in dual.into_iter().enumerate() {
        assert_close(dual.eps, slope(|x| plain(x)[index], x, 1e-3 * x), DIFFERENCES);
    }
}

fn or_nan(results: Result<[f64; 3], Failure>) -> [f64; 3] {
    results.unwrap_or([f64::NAN; 3])
}

#[test]
fn slopes_with_respect_to_the_geometry_are_those_of_differences() -> Result<(), Failure> {
    let dual = results(&Ball { radius: variable(20.0) }, Dual64::from(2e-3), Dual64::from(100.0))?;
    compare(dual, |radius| or_nan(results(&Ball { radius }, 2e-3, 100.0)), 20.0);
    Ok(())
}

#[test]
fn slopes_with_respect_to_the_medium_are_those_of_differences() -> Result<(), Failure> {
    let dual = results(&Blunt, variable(2e-3), Dual64::from(100.0))?;
    let plain = |permeability| or_nan(results(&Blunt, permeability, 100.0));
    compare(dual, plain, 2e-3);
    Ok(())
}

#[test]
fn slopes_with_respect_to_the_load_are_those_of_differences() -> Result<(), Failure> {
    let dual = results(&Blunt, Dual64::from(2e-3), variable(100.0))?;
    compare(dual, |force| or_nan(results(&Blunt, 2e-3, force)), 100.0);
    Ok(())
}

/// The derivative of Φ = C rⁿ with respect to n is Φ ln r, whether n is whole or not.
#[test]
fn slope_with_respect_to_an_exponent_is_that_of_the_power() -> Result<(), Failure> {
    for n in [2.0, 2.5, 2.3] {
        let profile = Polynomial::new([(Dual64::from(0.5), variable(n))])?;
        let plain = |n: f64| Polynomial::new([(0.5, n)]);
        let gap = profile.gap(Dual64::from(3.0));
        assert_close(gap.eps, gap.re * 3.0_f64.ln(), SLOPE);
        let radius = |n: f64| plain(n).map_or(f64::NAN, |profile| profile.radius(3.0).unwrap_or(f64::NAN));
        assert_close(profile.radius(Dual64::from(3.0))?.eps, slope(radius, n, 1e-3 * n), DIFFERENCES);
    }
    Ok(())
}

/// A dual number whose derivative is zero is a plain number.
#[test]
fn values_are_those_of_plain_numbers() -> Result<(), Failure> {
    let plain = results(&Blunt, 2e-3, 100.0)?;
    let dual = results(&Blunt, Dual64::from(2e-3), Dual64::from(100.0))?;
    assert_same(dual, plain);
    assert_eq!(dual.map(|result| result.eps), [0.0; 3]);
    Ok(())
}

/// Single-precision numbers have the limits of single precision, also with derivatives.
#[test]
fn single_precision_has_its_own_range() -> Result<(), Failure> {
    let dual = Dual32::from;
    for tiny in [0.0, 1e-44] {
        assert!(Medium::from_constants(dual(tiny), dual(0.0)).is_err(), "m = {tiny}");
        assert!(Polynomial::new([(dual(tiny), dual(2.0))]).is_err(), "C = {tiny}");
    }
    let peak = |force: Dual32| -> Result<Dual32, Failure> {
        let profile = Polynomial::new([(dual(0.025), dual(2.0))])?;
        let medium = Medium::from_constants(dual(0.375), dual(0.0015))?;
        Ok(Contact::new(profile, medium, Constant(force))?.at(dual(200.0))?.peak_pressure())
    };
    assert!(peak(dual(1e-40)).is_err());
    let found = peak(dual(100.0).derivative())?;
    // P ∝ F^(2/3) of a paraboloid.
    let allowed = 2.0 * budget::PEAK_PRESSURE.single as f32 * f32::EPSILON;
    assert!((found.eps * 150.0 / found.re - 1.0).abs() <= allowed, "{found}");
    Ok(())
}

/// F (1 − e^(−t/10)).
fn from_nothing<T: Scalar>(rise: T) -> Rise<T> {
    Rise { start: T::zero(), rise, rate: T::constant(0.1) }
}

/// The pressures at 0 mm and 3 mm, at a time.
fn pressures<T: Scalar>(
    profile: &impl GapProfile<T>,
    load: &dyn Load<T>,
    t: f64,
) -> Result<[T; 2], ContactError> {
    let contact = joint(profile, 0.0015, load);
    let now = contact.at(T::constant(t))?;
    Ok([now.peak_pressure(), now.pressure(T::constant(3.0))])
}

/// At first there is no contact, and the radius grows from zero.
#[test]
fn slopes_under_loads_from_nothing_are_those_of_differences() -> Result<(), Failure> {
    for exponents in [[2.0, 4.0], [2.0, 3.0], [2.3, 4.1], [0.5, 4.1]] {
        let [first, second] = exponents;
        let plain_gap = Polynomial::new([(0.025, first), (1e-4, second)])?;
        let [c, d, first, second] = [0.025, 1e-4, first, second].map(Dual64::from);
        let gap = Polynomial::new([(c, first), (d, second)])?;
        for t in [0.7, 20.0, 500.0] {
            let ramp = |force| PiecewiseLinear::new([(0.0, 0.0), (20.0, force)]);
            let dual_ramp = [(Dual64::from(0.0), Dual64::from(0.0)), (Dual64::from(20.0), variable(100.0))];
            for (index, (smooth, straight)) in pressures(&gap, &from_nothing(variable(100.0)), t)?
                .into_iter()
                .zip(pressures(&gap, &PiecewiseLinear::new(dual_ramp)?, t)?)
                .enumerate()
            {
                let of_smooth = |force: f64| pressures(&plain_gap, &from_nothing(force), t);
                let of_straight = |force: f64| pressures(&plain_gap, &ramp(force)?, t);
                let value = |found: Result<[f64; 2], ContactError>| found.map_or(f64::NAN, |p| p[index]);
                for (dual, expected) in [
                    (smooth, slope(|force| value(of_smooth(force)), 100.0, 0.1)),
                    (straight, slope(|force| value(of_straight(force)), 100.0, 0.1)),
                ] {
                    let is_near = (dual.eps - expected).abs() <= DIFFERENCES_FROM_NOTHING * dual.re / 100.0;
                    assert!(is_near, "{exponents:?}, {t}: {dual} instead of {expected}");
                }
            }
        }
    }
    Ok(())
}

/// Distances from the axis as shares of the contact radius.
const SHARES: [f32; 3] = [0.0, 0.5, 0.9];

/// A zero coefficient may carry a derivative, so that its term cannot be left out; times a power beyond the format it
/// is not a number.
#[test]
fn a_zero_before_a_power_beyond_the_format_changes_nothing() -> Result<(), Failure> {
    let number = Dual32::from;
    let terms = [(number(7e-5), number(2.1)), (number(0.0), number(64.0))];
    let medium = Medium::from_constants(number(0.13), number(0.2))?;
    let load = Fall { force: number(18_900.0), rate: number(0.1) };
    let pressures = |count: usize| -> Result<Vec<Dual32>, Failure> {
        let contact = Contact::new(Polynomial::new(&terms[..count])?, medium, load)?;
        let now = contact.at(number(5.0).derivative())?;
        assert!(now.radius().re > 20.0, "{}", now.radius());
        Ok(SHARES.map(|share| now.pressure(now.radius() * number(share))).to_vec())
    };
    for ((found, expected), share) in pressures(2)?.into_iter().zip(pressures(1)?).zip(SHARES) {
        let allowed = 2.0 * budget::PRESSURE.single * edge(1.0, f64::from(share));
        for (found, expected) in [(found.re, expected.re), (found.eps, expected.eps)] {
            let error = relative_error(found.into(), expected.into(), f32::EPSILON.into());
            assert!(error <= allowed, "{found} instead of {expected}, {error:.2} of {allowed} ε");
        }
    }
    Ok(())
}

/// With respect to the rate of drainage.
#[test]
fn third_derivatives_are_the_slopes_of_second_ones() -> Result<(), Failure> {
    let hundred = Dual3_64::from(100.0);
    for t in [1.0, 200.0, 5e3] {
        let peak = |chi: f64| -> Result<Dual3_64, Failure> {
            let medium = Medium::from_constants(Dual3_64::from(0.375), Dual3_64::from(chi).derivative())?;
            Ok(Contact::new(Blunt, medium, Constant(hundred))?.at(t.into())?.peak_pressure())
        };
        let (chi, dual) = (0.0015, peak(0.0015)?);
        let expected = slope(|chi| peak(chi).map_or(f64::NAN, |peak| peak.v2), chi, 1e-2 * chi);
        // Differences over hundredths miss the slope by the fourth power of these; the worst is off by 2.1e-7.
        assert!((dual.v3 / expected - 1.0).abs() < 1e-6, "{t}: {dual} instead of {expected}");
    }
    Ok(())
}

/// A fit may begin where a parameter has no effect yet, and the force does not vary.
#[test]
fn slopes_are_right_where_the_force_does_not_vary() -> Result<(), Failure> {
    for tau in [100.0, 30.0, 10.0] {
        let dual = peak_pressure(variable(0.0), tau)?;
        let plain = |b| peak_pressure(b, tau).unwrap_or(f64::NAN);
        let share = dual.eps / dual.re;
        let error = relative_error(share, slope(plain, 0.0, 1e-3) / dual.re, f64::EPSILON);
        assert!(error <= DIFFERENCES / share.abs(), "{tau}: {share} is off by {error:.2} ε");
    }
    Ok(())
}

/// The peak pressure under F = 100 (1 − b e^(−t/τ)).
fn peak_pressure<T: Scalar>(b: T, tau: f64) -> Result<T, Failure> {
    let [hundred, rate] = [100.0, 1.0 / tau].map(T::constant);
    let load = Rise { start: hundred * (T::one() - b), rise: hundred * b, rate };
    Ok(joint(Blunt, 0.0015, load).at(T::constant(200.0))?.peak_pressure())
}
