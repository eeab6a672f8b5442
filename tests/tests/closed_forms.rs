//! One-term profiles Φ = C rⁿ against the closed forms of Eqs. (16)–(21).
//!
//! ```text
//! a(t)  = (4 (n+2)(n+4) Y / (π m C n))^(1/(n+4))                 (18)
//! δ₀(t) = 2 C aⁿ/(n+2)                                           (10)
//! P(r, 0) = m C [n aⁿ⁺² − (n+2) aⁿ r² + 2 rⁿ⁺²] / (2 (n+2)²)     (16)
//! a/a₀ = (1 + χ t)^(1/(n+4)),  δ₀/δ₀(0) = (1 + χ t)^(n/(n+4))    (20), (21), constant load
//! ```

use core::f64::consts::{PI, SQRT_2};

use cartcontact::load::Constant;
use cartcontact::{Contact, ContactError, GapProfile, Layer, Medium, gap_profile};
use proptest::prelude::*;
use tests::budget;
use tests::profiles::{Paraboloid, Patellofemoral};
use tests::random::{self, exponent, failure, magnitude, sum};

/// A paraboloid of any curvature.
#[gap_profile(c * r^2)]
struct Square {
    c: f64,
}

/// A flat-ended geometry of any height.
#[gap_profile(c * r^11)]
struct Eleventh {
    c: f64,
}

/// A power that is not whole, of any size.
#[gap_profile(c * r^3.2)]
struct Fractional {
    c: f64,
}

/// In ε, how much the closed form of a radius or of its growth may be off: its exponent is rounded twice, which counts
/// with the logarithm of the result, at most 14 here; the root divides the errors of its nine factors.
const POWER: f64 = 16.0;

/// C, n, m, χ and F.
#[derive(Clone, Copy, Debug)]
struct Problem {
    c: f64,
    n: f64,
    m: f64,
    chi: f64,
    force: f64,
}

impl Problem {
    fn radius(&self, t: f64) -> f64 {
        let Self { c, n, m, chi, force } = *self;
        let hereditary = force * (1.0 + chi * t);
        (4.0 * (n + 2.0) * (n + 4.0) * hereditary / (PI * m * c * n)).powf(1.0 / (n + 4.0))
    }

    fn approach(&self, t: f64) -> f64 {
        2.0 * self.c * self.radius(t).powf(self.n) / (self.n + 2.0)
    }

    /// The first pressure in terms of q = r/a.
    fn first_pressure(&self, q: f64) -> f64 {
        let Self { c, n, m, .. } = *self;
        let shape = n - (n + 2.0) * q * q + 2.0 * q.powf(n + 2.0);
        m * c * self.radius(0.0).powf(n + 2.0) * shape / (2.0 * (n + 2.0) * (n + 2.0))
    }

    fn contact<P: GapProfile<f64>>(
        &self,
        profile: P,
    ) -> Result<Contact<f64, P, Constant<f64>>, ContactError> {
        Contact::new(profile, Medium::from_constants(self.m, self.chi)?, Constant(self.force))
    }

    /// Compares everything with a solver of the same geometry.
    fn compare(&self, profile: &dyn GapProfile<f64>) -> Result<(), TestCaseError> {
        let contact = self.contact(profile).map_err(failure)?;
        let first = contact.at(0.0).map_err(failure)?;
        let close =
            |x: f64, y: f64, scale: f64, allowed: f64| (x - y).abs() <= allowed * f64::EPSILON * scale;
        let (n, of_radius) = (self.n, budget::CONTACT_RADIUS.double);
        let of_approach = (budget::ROUNDINGS_OF_APPROACH + n) * budget::CONTACT_APPROACH.double;
        // The difference in the shape is rounded, which is n on the axis, and so is r.
        let of_pressure = budget::PEAK_PRESSURE.double + (n + 2.0) * POWER + 6.0 * (n + 2.0) / n;
        for q in [0.0, 0.3, 0.8, 0.99] {
            let (found, expected) = (first.pressure(q * first.radius()), self.first_pressure(q));
            prop_assert!(
                close(found, expected, self.first_pressure(0.0), of_pressure),
                "{self:?}, {q}: {found} {expected}"
            );
        }
        for x in [0.0, 0.2, 3.0, 1e6] {
            let now = contact.at(x / self.chi).map_err(failure)?;
            let (a, delta) = (self.radius(x / self.chi), self.approach(x / self.chi));
            prop_assert!(close(now.radius(), a, a, of_radius + POWER), "{self:?}, {x}: {} {a}", now.radius());
            prop_assert!(
                close(now.approach(), delta, delta, of_approach + n.max(1.0) * POWER),
                "{self:?}, {x}"
            );
            let growth = now.radius() / first.radius();
            let expected = (1.0 + x).powf(1.0 / (self.n + 4.0));
            prop_assert!(close(growth, expected, expected, 2.0 * of_radius + POWER), "{self:?}, {x}");
            let growth = now.approach() / first.approach();
            let expected = (1.0 + x).powf(self.n / (self.n + 4.0));
            prop_assert!(close(growth, expected, expected, 2.0 * of_approach + POWER), "{self:?}, {x}");
        }
        Ok(())
    }
}

fn problems(n: impl Strategy<Value = f64>) -> impl Strategy<Value = Problem> {
    (magnitude(-6.0..2.0), n, magnitude(-3.0..3.0), magnitude(-5.0..1.0), magnitude(-2.0..5.0))
        .prop_map(|(c, n, m, chi, force)| Problem { c, n, m, chi, force })
}

proptest! {
    #![proptest_config(random::cases(60))]

    #[test]
    fn one_term_of_any_exponent_has_its_closed_form(problem in problems(exponent())) {
        problem.compare(&sum(vec![(problem.c, problem.n)]))?;
    }

    #[test]
    fn generated_solvers_of_one_term_have_its_closed_form(problem in problems(Just(2.0))) {
        let c = problem.c;
        problem.compare(&Square { c })?;
        Problem { n: 11.0, ..problem }.compare(&Eleventh { c })?;
        Problem { n: 3.2, ..problem }.compare(&Fractional { c })?;
    }

    /// As χ t grows, the pressure tends to the paraboloid 2F/(π a²) (1 − r²/a²) for any geometry: the rest is a few
    /// times 1/(χ t), which is 1e-6 here.
    #[test]
    fn pressure_becomes_parabolic_in_the_long_run(problem in problems(exponent())) {
        let contact = problem.contact(sum(vec![(problem.c, problem.n)])).map_err(failure)?;
        let late = contact.at(1e6 / problem.chi).map_err(failure)?;
        let a = late.radius();
        for q in [0.0, 0.4, 0.9] {
            let expected = 2.0 * problem.force / (PI * a * a) * (1.0 - q * q);
            let found = late.pressure(q * a);
            prop_assert!((found / expected - 1.0).abs() < 1e-5, "{q}: {found} {expected}");
        }
    }
}

/// A ball of half the radius on layers of four times the stiffness has the same m R², and the radius of its contact is
/// smaller by √2: a fit to approaches alone cannot tell the two apart.
#[test]
fn approaches_to_a_ball_depend_on_its_radius_by_m_r_squared_alone() -> Result<(), ContactError> {
    let problem = Problem { c: 0.025, n: 2.0, m: 0.375, chi: 0.02, force: 100.0 };
    let smaller = Problem { c: 2.0 * problem.c, m: 4.0 * problem.m, ..problem };
    let [contact, other] = [problem, smaller].map(|problem| problem.contact(Square { c: problem.c }));
    let (contact, other) = (contact?, other?);
    for t in [0.0, 20.0, 500.0] {
        let (now, then) = (contact.at(t)?, other.at(t)?);
        let close = |x: f64, y: f64, allowed: f64| (x / y - 1.0).abs() <= 2.0 * allowed * f64::EPSILON;
        assert!(close(now.approach(), then.approach(), 3.0 * budget::CONTACT_APPROACH.double), "{t}");
        assert!(close(now.radius(), SQRT_2 * then.radius(), budget::CONTACT_RADIUS.double), "{t}");
    }
    Ok(())
}

/// The history of a paraboloid under a constant load to twelve digits, in units of a₀ and P(0, 0).
#[test]
fn a_paraboloid_creeps_as_tabulated() -> Result<(), ContactError> {
    let rows = [
        (0.0, 1.0, [1.0, 0.5625, 0.0361, 0.0]),
        (0.1, 1.01601186777, [0.967249682183, 0.556032144016, 0.0453391113422, 0.0]),
        (1.0, 1.12246204831, [0.732339231546, 0.492268196473, 0.121379192424, 0.0198426939921]),
        (10.0, 1.49130147541, [0.310326438432, 0.274140611612, 0.193104952943, 0.150789668694]),
    ];
    let problem = Problem { c: 0.025, n: 2.0, m: 0.375, chi: 0.02, force: 100.0 };
    let contact = problem.contact(Paraboloid)?;
    let first = contact.at(0.0)?;
    let a = first.radius();
    // The square of the radius is off by twice as much as the radius.
    let allowed = (budget::PEAK_PRESSURE.double + 2.0 * budget::CONTACT_RADIUS.double) * f64::EPSILON;
    assert!((first.peak_pressure() / (3.0 * problem.force / (PI * a * a)) - 1.0).abs() <= allowed);
    // Half a unit of the last digit, and a hundredth for all other roundings.
    let [last_of_radius, last_of_pressure] = [0.51e-11, 0.51e-12];
    for (x, radius, pressures) in rows {
        let now = contact.at(x / problem.chi)?;
        assert!((now.radius() / a - radius).abs() < last_of_radius, "χ t = {x}");
        for (q, expected) in [0.0, 0.5, 0.9, 1.05].into_iter().zip(pressures) {
            let found = now.pressure(q * a) / first.peak_pressure();
            assert!((found - expected).abs() < last_of_pressure, "χ t = {x}, r = {q} a₀: {found} {expected}");
        }
    }
    Ok(())
}

/// The example of the paper's section 7, to the known digits.
#[test]
fn the_papers_example_has_its_known_values() -> Result<(), Box<dyn core::error::Error>> {
    let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    let (gap_4, gap_29): (&dyn GapProfile<f64>, &dyn GapProfile<f64>) = (&Paraboloid, &Patellofemoral);
    let consistent = Medium::between(layer, layer)?;
    let printed = Medium::between_as_printed_2011(layer, layer)?;
    assert_eq!((printed.m(), printed.chi()), (consistent.m(), 2.0 * consistent.chi()));
    for (medium, t, gap, radius, approach, pressure) in [
        (consistent, 0.0, gap_4, 7.391, 0.6828, 1.7482),
        (consistent, 0.0, gap_29, 7.146, 0.7335, 1.8318),
        (consistent, 200.0, gap_4, 7.721, 0.7452, 1.5832),
        (consistent, 200.0, gap_29, 7.447, 0.8052, 1.6660),
        (printed, 200.0, gap_4, 7.993, 0.7986, 1.4395),
        (printed, 200.0, gap_29, 7.692, 0.8672, 1.5215),
    ] {
        let contact = Contact::new(gap, medium, Constant(100.0))?;
        let now = contact.at(t)?;
        assert!((now.radius() - radius).abs() <= 5e-4, "{t}: {}", now.radius());
        assert!((now.approach() - approach).abs() <= 5e-5, "{t}: {}", now.approach());
        assert!((now.peak_pressure() - pressure).abs() <= 5e-5, "{t}: {}", now.peak_pressure());
    }
    Ok(())
}
