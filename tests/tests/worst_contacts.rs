//! The scenes in which contact radii and peak pressures are off by the most, of millions of random ones in single precision
//! and some thousands in double precision.

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, GapProfile, Medium, Scalar, gap_profile};
use tests::budget;
use tests::measure::Errors;
use tests::oracle::{Oracle, Profile};
use tests::profiles::Patellofemoral;

/// The degree of its J is 4.25: what is rounded before the inversion counts for the most.
#[gap_profile(0.37 * r^0.25)]
struct Cusp;

#[gap_profile(0.37 * r)]
struct Cone;

#[gap_profile(1e-9 * r^12)]
struct Flat;

/// A medium, the knots of a load and a time.
#[derive(Clone, Copy, Debug)]
struct Scene {
    m: f64,
    chi: f64,
    knots: &'static [(f64, f64)],
    t: f64,
}

impl Scene {
    /// a(t) and P(0, t) of the scene as the format has it.
    fn solved<T: Scalar>(self, profile: &dyn GapProfile<T>, format: fn(f64) -> T) -> [f64; 2] {
        let knots: Vec<(T, T)> = self.knots.iter().map(|&(t, force)| (format(t), format(force))).collect();
        let solve = || {
            let medium = Medium::from_constants(format(self.m), format(self.chi))?;
            let contact = Contact::new(profile, medium, PiecewiseLinear::new(knots)?)?;
            let now = contact.at(format(self.t))?;
            Ok([now.radius(), now.peak_pressure()].map(T::value))
        };
        solve().unwrap_or_else(|error: Box<dyn core::error::Error>| unreachable!("{self:?}: {error}"))
    }
}

/// A geometry and its terms, as they are written.
type Geometry = (&'static dyn GapProfile<f64>, &'static [(&'static str, &'static str)]);

#[test]
fn nothing_in_double_precision_is_off_by_more_than_the_table_says() {
    let joint = Scene {
        m: 0.07161713504754577,
        chi: 0.002651048987712809,
        knots: &[(0.0, 0.035139322685230845), (226.0961229836018, 0.06357830700630666)],
        t: 2288.6045373207407,
    };
    let cusp = Scene {
        m: 0.1599530303489287,
        chi: 0.011921303605634256,
        knots: &[(0.0, 0.0016840988734386903), (618.2319493567703, 0.0023356688996778695)],
        t: 755.3415283920516,
    };
    let flat = Scene {
        m: 53.954873198411754,
        chi: 0.0011816310136374183,
        knots: &[(0.0, 1.556445627179439)],
        t: 8521.720144626282,
    };
    let scenes: [(Scene, Geometry); 3] = [
        (joint, (&Patellofemoral, &[("0.025", "2"), ("1.09375e-4", "4")])),
        (cusp, (&Cusp, &[("0.37", "0.25")])),
        (flat, (&Flat, &[("1e-9", "12")])),
    ];
    let (mut radius, mut peak) = (Errors::of(budget::CONTACT_RADIUS), Errors::of(budget::PEAK_PRESSURE));
    for (scene, (profile, terms)) in scenes {
        let oracle = Oracle::new(Profile::of_decimals(terms), scene.m, scene.chi, scene.knots);
        let [a, p] = scene.solved(profile, |x| x);
        radius.add(a, &oracle.radius(scene.t), 1.0, &scene);
        peak.add(p, &oracle.pressure(0.0, scene.t), 1.0, &scene);
    }
    radius.check_worst();
    peak.check_worst();
}

#[test]
fn nothing_in_single_precision_is_off_by_more_than_the_table_says() {
    let cusp = Scene {
        m: 11.778712,
        chi: 0.0047167954,
        knots: &[(0.0, 155.20648), (53.201637, 217.35959)],
        t: 6475.3433,
    };
    let cone = Scene { m: 23.864597, chi: 0.0030777745, knots: &[(0.0, 25.428856)], t: 6484.3237 };
    let flat = Scene {
        m: 37.002094,
        chi: 0.0035456542,
        knots: &[(0.0, 280.2626), (64.28322, 502.4362)],
        t: 5973.8535,
    };
    let scenes: [(Scene, &dyn GapProfile<f32>, &dyn GapProfile<f64>); 3] =
        [(cusp, &Cusp, &Cusp), (cone, &Cone, &Cone), (flat, &Flat, &Flat)];
    let (mut radius, mut peak) =
        (Errors::of_single(budget::CONTACT_RADIUS), Errors::of_single(budget::PEAK_PRESSURE));
    for (scene, single, double) in scenes {
        let [a, p] = scene.solved(single, |x| x as f32);
        let [exact_a, exact_p] = scene.solved(double, |x| f64::from(x as f32));
        radius.add(a, exact_a, 1.0, &scene);
        peak.add(p, exact_p, 1.0, &scene);
    }
    radius.check_worst();
    peak.check_worst();
}
