//! How many contact radii are off by more than one unit in the last place, the table of the README:
//! `cargo run --release -p tests --bin radii`.
//!
//! Radii are compared in 31 digits, by one step of Newton's method from the radius found: the error of that step is the
//! square of the error that it measures.

use std::cell::LazyCell;
use std::f64::consts::FRAC_PI_4;
use std::thread;

use ::tests::fractions::{Hundredths, Quarters, Tenths, Thirds, Twentieths};
use ::tests::inversion::Inversion;
use ::tests::measure::{Exact, ulps};
use ::tests::profiles::{Cone, Paraboloid, Patellofemoral};
use ::tests::random::Stream;
use ::tests::stress::wide::Wide;
use cartcontact::{Contact, GapProfile, Medium, Polynomial, Scalar, gap_profile, load};
use clap::{Parser, value_parser};

/// How many contact radii are off by more than one unit in the last place.
#[derive(Debug, Parser)]
struct Options {
    /// How many random radii of each geometry
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    #[arg(value_parser = value_parser!(u64).range(1..))]
    radii: u64,
    /// Which ones
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
}

/// The decades of radii, within the tables of all geometries.
const DECADES: [f64; 2] = [-1.5, 0.75];
/// m in MPa/mm³ and χ in 1/s, both with few digits.
const MEDIUM: (f64, f64) = (0.375, 1.0 / 512.0);

#[gap_profile(0.03 * r^0.25)]
struct QuarterPower;
#[gap_profile(0.015 * r^2.37)]
struct Blunt;
#[gap_profile(3e-6 * r^8)]
struct Flat;
#[gap_profile(0.02 * r^2 + 1e-4 * r^4 + 2e-6 * r^6)]
struct ThreeTerms;
#[gap_profile(0.02 * r^2 + 1e-3 * r^3 + 1e-4 * r^5 + 3e-6 * r^8)]
struct FourTerms;
#[gap_profile(0.05 * r + 0.01 * r^2)]
struct ConeAndParaboloid;
#[gap_profile(0.05 * r + 0.01 * r^3 + 1e-4 * r^6)]
struct LongCone;
#[gap_profile(0.03 * r^2 + 0.002 * r^2.5)]
struct Halves;
#[gap_profile(0.03 * r^0.5 + 0.01 * r^2.5 + 1e-3 * r^4 + 1e-5 * r^6.5 + 1e-7 * r^8.5)]
struct ManyHalves;
#[gap_profile(0.02 * r^0.61 + 1e-3 * r^2.29 + 1e-5 * r^4.83)]
struct ManyHundredths;
#[gap_profile(0.02 * r^1.5 + 1e-4 * r^3.25)]
struct Blunter;

/// A geometry in both formats, for radii of load integrals.
struct Geometry {
    double: Box<dyn Inversion<f64> + Sync>,
    single: Box<dyn Inversion<f32> + Sync>,
    gap: Gap,
}

/// A geometry in both formats, for radii under loads.
struct Joint {
    double: Box<dyn GapProfile<f64> + Sync>,
    single: Box<dyn GapProfile<f32> + Sync>,
    gap: Gap,
}

/// Generated geometries, for either.
macro_rules! generated {
    ($purpose:ident: $($profile:ident),*) => {
        vec![$($purpose {
            double: Box::new($profile),
            single: Box::new($profile),
            gap: Gap::of(&$profile::TERMS),
        }),*]
    };
}

/// A geometry known at run time only, of coefficients and exponents that `f32` holds.
fn run_time(terms: &[(f32, f32)]) -> Geometry {
    let exact: Vec<(f64, f64)> = terms.iter().map(|&(c, n)| (c.into(), n.into())).collect();
    Geometry {
        gap: Gap::of(&exact),
        double: Box::new(Polynomial::new(exact).unwrap_or_else(|error| unreachable!("{error}"))),
        single: Box::new(Polynomial::new(terms.to_vec()).unwrap_or_else(|error| unreachable!("{error}"))),
    }
}

/// Geometries that are counted together, in a row of the table.
struct Kind<G> {
    name: &'static str,
    geometries: Vec<G>,
}

/// The kinds for radii of a load integral.
fn kinds() -> [Kind<Geometry>; 7] {
    let kind = |name, geometries| Kind { name, geometries };
    [
        kind("one, of any power", generated![Geometry: QuarterPower, Cone, Paraboloid, Blunt, Flat]),
        kind("whole powers", generated![Geometry: Patellofemoral, ThreeTerms, FourTerms]),
        kind("whole powers beginning with r", generated![Geometry: ConeAndParaboloid, LongCone]),
        kind("halves among them", generated![Geometry: Halves, ManyHalves]),
        kind("multiples of 1/3 to 1/20", generated![Geometry: Thirds, Quarters, Tenths, Twentieths]),
        kind("other powers", generated![Geometry: Hundredths, ManyHundredths]),
        kind(
            "`Polynomial`, any powers",
            vec![
                run_time(&[(0.025_390_625, 2.0), (1.0 / 8192.0, 4.0)]),
                run_time(&[(0.0625, 1.0), (0.015_625, 2.375), (1.0 / 65536.0, 7.0)]),
            ],
        ),
    ]
}

/// The geometries for radii under a held load.
fn under_load() -> Kind<Joint> {
    Kind {
        name: "any, under a held load",
        geometries: generated![
            Joint: QuarterPower,
            ConeAndParaboloid,
            Paraboloid,
            Patellofemoral,
            ThreeTerms,
            Blunter
        ],
    }
}

/// The gap Σ C rⁿ in 31 digits.
struct Gap {
    terms: Vec<Term>,
}

struct Term {
    /// C n/((n+2)(n+4)), the weight of rⁿ⁺⁴ in J.
    weight: Wide,
    /// n + 4.
    degree: Wide,
}

impl Gap {
    /// The gap of coefficients that are decimals and of exponents that are fractions with a divisor up to 100, both
    /// rounded to `f64`.
    fn of(terms: &[(f64, f64)]) -> Self {
        let fraction = |n: f64| {
            let multiple = |divisor: &f64| (n * divisor - (n * divisor).round()).abs() < 1e-12;
            let divisor = (1..=100).map(f64::from).find(multiple).unwrap_or(f64::NAN);
            Wide::of((n * divisor).round()) / Wide::of(divisor)
        };
        let term = |&(c, n)| {
            let (n, two) = (fraction(n), Wide::of(2.0));
            let degree = n + two + two;
            Term { weight: Wide::of_decimal(c) * n / ((n + two) * degree), degree }
        };
        Self { terms: terms.iter().map(term).collect() }
    }

    /// J and a J′ at a radius.
    fn load_integral(&self, a: f64) -> (Wide, Wide) {
        let a = Wide::of(a);
        let logarithm = LazyCell::new(|| a.ln());
        self.terms.iter().fold((Wide::ZERO, Wide::ZERO), |(sum, slope), &Term { weight, degree }| {
            let rounded = degree.value();
            // Roots and products are quicker than a logarithm and an exponential.
            let has_root = (4.0 * rounded).fract() == 0.0;
            let power = if has_root { a.power(rounded) } else { (degree * *logarithm).exp() };
            (sum + weight * power, slope + weight * power * degree)
        })
    }

    /// By how many units in the last place a radius is off.
    fn error(&self, found: f64, load_integral: Wide, epsilon: f64) -> f64 {
        let (here, slope) = self.load_integral(found);
        let excess = ((here - load_integral) / slope).value() * found;
        ulps(found, Exact::beside(found, -excess), epsilon)
    }
}

/// How many radii are off by more than a unit, and the largest error in units.
#[derive(Clone, Copy, Default)]
struct Count {
    off: u64,
    all: u64,
    largest: f64,
}

impl Count {
    fn add(&mut self, error: f64) {
        self.all += 1;
        self.off += u64::from(error > 1.0);
        self.largest = self.largest.max(error);
    }

    fn per_million(self) -> f64 {
        self.off as f64 * 1e6 / self.all as f64
    }
}

impl Geometry {
    /// Counts radii of random load integrals, in `f64` and `f32`.
    fn radii_of_load_integrals(&self, mut stream: Stream, count: u64) -> [Count; 2] {
        let [mut double, mut single] = [Count::default(); 2];
        for _ in 0..count {
            let [from, to] = DECADES;
            let y = self.double.load_integral(stream.magnitude(from, to));
            let found = self.double.radius(y).unwrap_or(f64::NAN);
            double.add(self.gap.error(found, Wide::of(y), f64::EPSILON));
            let y = y as f32;
            let found = self.single.radius(y).unwrap_or(f32::NAN);
            single.add(self.gap.error(found.into(), Wide::of(y.into()), f32::EPSILON.into()));
        }
        [double, single]
    }
}

impl Joint {
    /// Counts contact radii at random times under random held loads, in `f64` and `f32`.
    fn radii_under_loads(&self, mut stream: Stream, count: u64) -> [Count; 2] {
        let [mut double, mut single] = [Count::default(); 2];
        let [from, to] = DECADES;
        let (m, chi) = MEDIUM;
        for _ in 0..count {
            let t = stream.magnitude(-1.0, 5.0);
            let hereditary = FRAC_PI_4 * m * (*self.double).load_integral(stream.magnitude(from, to));
            let force = hereditary / (1.0 + chi * t);
            let found = radius_under(&*self.double, force, t).unwrap_or(f64::NAN);
            double.add(self.gap.error(found, exact_load_integral(force, t), f64::EPSILON));
            let (force, t) = (force as f32, t as f32);
            let found = radius_under(&*self.single, force, t).unwrap_or(f32::NAN);
            let y = exact_load_integral(force.into(), t.into());
            single.add(self.gap.error(found.into(), y, f32::EPSILON.into()));
        }
        [double, single]
    }
}

/// a(t) under a held load.
fn radius_under<T: Scalar>(profile: &dyn GapProfile<T>, force: T, t: T) -> Option<T> {
    let medium = Medium::from_constants(T::constant(MEDIUM.0), T::constant(MEDIUM.1)).ok()?;
    let contact = Contact::new(profile, medium, load::Constant(force)).ok()?;
    Some(contact.at(t).ok()?.radius())
}

/// J = F (1 + χ t)/(π m/4).
fn exact_load_integral(force: f64, t: f64) -> Wide {
    let (m, chi) = MEDIUM;
    Wide::of(force) * (Wide::ONE + Wide::of(chi) * Wide::of(t)) / (Wide::FRAC_PI_4 * Wide::of(m))
}

/// Prints a row for every kind: the geometry of which most are off in each format, and the largest error of all.
fn main() {
    let Options { radii: count, seed } = Options::parse();
    println!("| terms                         | f64  | f32  | largest error |");
    println!("|-------------------------------|------|------|---------------|");
    for kind in kinds() {
        print_row(&kind, seed, |geometry, stream| geometry.radii_of_load_integrals(stream, count));
    }
    print_row(&under_load(), seed, |joint, stream| joint.radii_under_loads(stream, count));
}

fn print_row<G: Sync>(kind: &Kind<G>, seed: u64, count: impl Fn(&G, Stream) -> [Count; 2] + Sync) {
    // Each geometry has a thread and a stream of its own.
    let counts: Vec<[Count; 2]> = thread::scope(|scope| {
        let count = &count;
        let threads = (0..)
            .zip(&kind.geometries)
            .map(|(index, geometry)| scope.spawn(move || count(geometry, Stream::of_case(seed, index))));
        let threads: Vec<_> = threads.collect();
        threads.into_iter().filter_map(|thread| thread.join().ok()).collect()
    });
    assert_eq!(counts.len(), kind.geometries.len(), "a thread has panicked");
    let most = |format: usize| counts.iter().map(|both| both[format].per_million()).fold(0.0, f64::max);
    let largest = counts.iter().flatten().map(|count| count.largest).fold(0.0, f64::max);
    println!("| {:29} | {:4.0} | {:4.0} | {largest:13.2} |", kind.name, most(0), most(1));
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::tests::oracle::{Profile, double};

    /// The errors of Newton's step are those against the radius in 96 digits, also for exponents that are fractions.
    #[test]
    fn errors_are_those_of_the_oracle() {
        let geometries = generated![Geometry: Thirds, Hundredths, ManyHalves];
        let written: [&[(&str, &str)]; 3] = [
            &[("0.02", "2/3"), ("1e-3", "2")],
            &[("0.02", "2.37"), ("1e-3", "3.5")],
            &[("0.03", "0.5"), ("0.01", "2.5"), ("1e-3", "4"), ("1e-5", "6.5"), ("1e-7", "8.5")],
        ];
        for (geometry, terms) in geometries.iter().zip(written) {
            for y in [1e-3, 0.7, 1e3] {
                let exact = Exact::from(&Profile::of_decimals(terms).radius(&double(y)));
                for offset in [-3.0, 0.0, 1.0] {
                    let found = exact.nearest * (1.0 + offset * f64::EPSILON);
                    let expected = ulps(found, exact, f64::EPSILON);
                    let error = geometry.gap.error(found, Wide::of(y), f64::EPSILON);
                    assert!((error - expected).abs() < 1e-9, "{terms:?}, {y}: {error} instead of {expected}");
                }
            }
        }
    }
}
