//! Contact radii of a single term whose power is a fraction with a long numerator, so that no few octaves are a period.

use cartcontact::gap_profile;
use tests::budget;
use tests::inversion::Inversion;
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::random::Stream;

use super::checks::{assert_same_in_other_units, assert_slices_are_right, load_integrals_of_any_size};

macro_rules! powers {
    ($($name:ident $constant:ident: $decimal:literal, $gap:expr, $constant_gap:expr;)*) => {
        $(
            #[gap_profile($gap)]
            struct $name<T> {
                c: T,
            }

            #[gap_profile($constant_gap)]
            struct $constant;
        )*

        const KINDS: &[Kind] = &[$(Kind {
            decimal: $decimal,
            double: |c| Box::new($name { c }),
            single: |c| Box::new($name { c }),
            constant: (&$constant, &$constant),
        }),*];
    };
}

powers! {
    Root RootOfOwn: "0.37", c * r^0.37, 0.03125 * r^0.37;
    Cone ConeOfOwn: "1.1234", c * r^1.1234, 0.03125 * r^1.1234;
    Blunt BluntOfOwn: "1.74", c * r^1.74, 0.03125 * r^1.74;
    Pi PiOfOwn: "3.141592653589793", c * r^3.141592653589793, 0.03125 * r^3.141592653589793;
    Near NearOfOwn: "2.000000000001", c * r^2.000000000001, 0.03125 * r^2.000000000001;
    Flat FlatOfOwn: "12.3", c * r^12.3, 0.03125 * r^12.3;
    Flatter FlatterOfOwn: "70.01", c * r^70.01, 0.03125 * r^70.01;
}

struct Kind {
    decimal: &'static str,
    double: fn(f64) -> Box<dyn Inversion<f64>>,
    single: fn(f32) -> Box<dyn Inversion<f32>>,
    /// The geometry with the coefficient 2⁻⁵, in both formats.
    constant: (&'static dyn Inversion<f64>, &'static dyn Inversion<f32>),
}

const CONSTANT: f64 = 0.03125;

impl Kind {
    fn power(&self) -> f64 {
        4.0 + self.decimal.parse::<f64>().unwrap_or(f64::NAN)
    }

    /// The exact radius, from an oracle for the coefficient 1.
    fn exact(&self, oracle: &Profile, (c, load_integral): (f64, f64)) -> Exact {
        Exact::from(&oracle.radius(&(double(load_integral) / double(c))))
    }

    /// A load integral whose radius is within 10^±`decades`.
    fn load_integral(&self, stream: &mut Stream, c: f64, decades: f64) -> f64 {
        c * 10f64.powf(self.power() * stream.between(-decades, decades)) / self.power()
    }
}

#[test]
fn radii_are_exact() {
    let (mut errors, mut errors_of_single) = (Errors::of(budget::RADIUS), Errors::of_single(budget::RADIUS));
    for (index, kind) in (0..).zip(KINDS) {
        let oracle = Profile::of_decimals(&[("1", kind.decimal)]);
        let mut stream = Stream::of_case(1, index);
        for round in 0..200 {
            let is_constant = round % 4 == 0;
            let c = if is_constant { CONSTANT } else { stream.magnitude(-100.0, 100.0) };
            let load_integral = kind.load_integral(&mut stream, c, 180.0 / kind.power());
            let found = if is_constant {
                kind.constant.0.radius(load_integral)
            } else {
                (kind.double)(c).radius(load_integral)
            };
            let place = (kind.decimal, c, load_integral);
            let expected = kind.exact(&oracle, (c, load_integral));
            errors.add(found.unwrap_or(f64::NAN), expected, 1.0, &place);

            let c = if is_constant { CONSTANT as f32 } else { stream.magnitude(-10.0, 10.0) as f32 };
            let load_integral = kind.load_integral(&mut stream, c.into(), 24.0 / kind.power()) as f32;
            let found = if is_constant {
                kind.constant.1.radius(load_integral)
            } else {
                (kind.single)(c).radius(load_integral)
            };
            let place = (kind.decimal, c, load_integral);
            let expected = kind.exact(&oracle, (c.into(), load_integral.into()));
            errors_of_single.add(found.unwrap_or(f32::NAN).into(), expected, 1.0, &place);
        }
    }
    errors.check();
    errors_of_single.check();
}

#[test]
fn other_units_of_load_change_no_digit() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(2, index);
        for _ in 0..1000 {
            let c = stream.magnitude(-3.0, 3.0);
            let load_integral = kind.load_integral(&mut stream, c, 100.0 / kind.power());
            let size = stream.power_of_two(500);
            let profiles = [&*(kind.double)(c), &*(kind.double)(c * size)];
            assert_same_in_other_units(profiles, load_integral, [1.0, size], &(kind.decimal, c));
        }
    }
}

#[test]
fn slices_have_the_same_radii() {
    for (index, kind) in (0..).zip(KINDS) {
        let mut stream = Stream::of_case(3, index);
        let c = stream.magnitude(-3.0, 3.0);
        let (profile, single) = ((kind.double)(c), (kind.single)(c as f32));
        let load_integrals = load_integrals_of_any_size(&mut stream, 200.0);
        for profiles in [(&*profile, &*single), kind.constant] {
            assert_slices_are_right(profiles, &load_integrals, &kind.decimal);
        }
    }
}
