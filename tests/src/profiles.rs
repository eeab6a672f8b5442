//! The geometries of `reference/profiles.json`, generated and as run-time polynomials.

use cartcontact::{GapProfile, Polynomial, gap_profile};

use crate::condition;
use crate::oracle::{Profile, literal};
use crate::random::Sum;
use crate::stress::wide::Wide;

/// One term.
#[gap_profile(0.025 * r^2)]
#[derive(Clone, Copy, Debug)]
pub struct Paraboloid;

/// Two even powers: the paper's example.
#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
#[derive(Clone, Copy, Debug)]
pub struct Patellofemoral;

/// The lowest power that is used in practice.
#[gap_profile(0.1 * r)]
#[derive(Clone, Copy, Debug)]
pub struct Cone;

/// Odd powers.
#[gap_profile(0.05 * r + 0.01 * r^3)]
#[derive(Clone, Copy, Debug)]
pub struct BluntedCone;

/// One high power.
#[gap_profile(3e-4 * r^4)]
#[derive(Clone, Copy, Debug)]
pub struct Quartic;

/// Many terms.
#[gap_profile(0.02*r^2 + 1e-4*r^4 + 2e-6*r^6 + 3e-8*r^8 + 4e-10*r^10 + 5e-12*r^12)]
#[derive(Clone, Copy, Debug)]
pub struct SixTerm;

/// Very high powers, far apart, with coefficients far apart.
#[gap_profile(1e-9 * r^12 + 1e-40 * r^64)]
#[derive(Clone, Copy, Debug)]
pub struct FlatEnded;

/// One power that is not whole.
#[gap_profile(0.03 * r^2.5)]
#[derive(Clone, Copy, Debug)]
pub struct Hertzian52;

/// Several powers that are not whole.
#[gap_profile(0.01*r^1.5 + 0.002*r^3.25)]
#[derive(Clone, Copy, Debug)]
pub struct RealPowers;

/// A whole power and one that is a multiple of 1/4; not one of the reference geometries.
#[gap_profile(0.025 * r^2 + 0.002 * r^3.25)]
#[derive(Clone, Copy, Debug)]
pub struct Blunt;

/// Exponents that neither single nor double precision holds exactly; not one of the reference geometries.
#[gap_profile(0.2 * r^0.7 + 0.03 * r^1.7 + 2e-3 * r^3.1)]
#[derive(Clone, Copy, Debug)]
pub struct Decimals;

/// The terms of [`Decimals`].
pub const DECIMALS: [(&str, &str); 3] = [("0.2", "0.7"), ("0.03", "1.7"), ("2e-3", "3.1")];

/// Admissible up to a limit only.
#[gap_profile(0.025*r^2 - 1e-4*r^4, max_radius = 8.0)]
#[derive(Clone, Copy, Debug)]
pub struct Oblate;

/// Not convex, yet admissible everywhere; used up to a limit.
#[gap_profile(0.05*r^2 - 0.004*r^3 + 2e-4*r^4, max_radius = 20.0)]
#[derive(Clone, Copy, Debug)]
pub struct MixedSign;

/// A geometry in every form in which the crate can hold it.
#[derive(Clone, Copy)]
pub struct Case {
    /// Its name in the reference values.
    pub name: &'static str,
    /// The expression in its attribute.
    pub expression: &'static str,
    /// The pairs (coefficient, exponent).
    pub terms: &'static [(f64, f64)],
    /// The declared end of its range.
    pub max_radius: Option<f64>,
    /// The generated solver.
    pub double: &'static dyn GapProfile<f64>,
    /// The generated solver in single precision.
    pub single: &'static dyn GapProfile<f32>,
}

impl core::fmt::Debug for Case {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name)
    }
}

impl Case {
    /// The same geometry as a run-time polynomial.
    #[must_use]
    pub fn polynomial(&self) -> Polynomial<f64, &'static [(f64, f64)]> {
        let polynomial = match self.max_radius {
            Some(max_radius) => Polynomial::with_max_radius(self.terms, max_radius),
            None => Polynomial::new(self.terms),
        };
        polynomial.unwrap_or_else(|error| unreachable!("{}: {error}", self.name))
    }

    /// The same geometry for the oracle, with its coefficients as written.
    #[must_use]
    pub fn oracle(&self) -> Profile {
        Profile::of_numbers(self.terms.iter().map(|&(c, n)| (literal(c), literal(n))).collect())
    }

    /// The terms with their coefficients as written, in 31 digits.
    #[must_use]
    pub fn exact_terms(&self) -> Vec<(Wide, f64)> {
        self.terms.iter().map(|&(c, n)| (Wide::of_decimal(c), n)).collect()
    }

    /// The geometry of the absolute terms.
    #[must_use]
    pub fn of_sizes(&self) -> Sum {
        condition::of_sizes(self.terms)
    }
}

macro_rules! cases {
    ($($name:ident: $expression:literal, $max_radius:expr, $terms:expr;)*) => {
        [$(Case {
            name: stringify!($name),
            expression: $expression,
            terms: &$terms,
            max_radius: $max_radius,
            double: &$name,
            single: &$name,
        }),*]
    };
}

/// All of them, in the order of the reference values.
#[must_use]
pub fn cases() -> [Case; 11] {
    cases! {
        Paraboloid: "0.025 * r^2", None, [(0.025, 2.0)];
        Patellofemoral: "0.025 * r^2 + 1.09375e-4 * r^4", None, [(0.025, 2.0), (1.09375e-4, 4.0)];
        Cone: "0.1 * r", None, [(0.1, 1.0)];
        BluntedCone: "0.05 * r + 0.01 * r^3", None, [(0.05, 1.0), (0.01, 3.0)];
        Quartic: "3e-4 * r^4", None, [(3e-4, 4.0)];
        SixTerm: "0.02*r^2 + 1e-4*r^4 + 2e-6*r^6 + 3e-8*r^8 + 4e-10*r^10 + 5e-12*r^12", None,
            [(0.02, 2.0), (1e-4, 4.0), (2e-6, 6.0), (3e-8, 8.0), (4e-10, 10.0), (5e-12, 12.0)];
        FlatEnded: "1e-9 * r^12 + 1e-40 * r^64", None, [(1e-9, 12.0), (1e-40, 64.0)];
        Hertzian52: "0.03 * r^2.5", None, [(0.03, 2.5)];
        RealPowers: "0.01*r^1.5 + 0.002*r^3.25", None, [(0.01, 1.5), (0.002, 3.25)];
        Oblate: "0.025*r^2 - 1e-4*r^4", Some(8.0), [(0.025, 2.0), (-1e-4, 4.0)];
        MixedSign: "0.05*r^2 - 0.004*r^3 + 2e-4*r^4", Some(20.0),
            [(0.05, 2.0), (-0.004, 3.0), (2e-4, 4.0)];
    }
}

/// The geometry of that name.
///
/// # Panics
///
/// If there is none.
#[must_use]
pub fn case(name: &str) -> Case {
    let found = cases().into_iter().find(|case| case.name == name);
    found.unwrap_or_else(|| unreachable!("{name} is not one of the reference geometries"))
}
