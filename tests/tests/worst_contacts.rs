//! The scenes with the largest errors of contact radii and, in single precision, of peak pressures, of millions of random
//! scenes in single precision and tens of thousands in double precision.

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, GapProfile, Medium, Scalar, gap_profile};
use tests::budget;
use tests::measure::Errors;
use tests::oracle::{Oracle, Profile};
use tests::profiles::Patellofemoral;

/// The degree of its J is 4.25, so that rounding before the inversion counts most.
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
    /// a(t) and P(0, t) of the scene in a format.
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

/// A geometry and its terms as written.
type Geometry = (&'static dyn GapProfile<f64>, &'static [(&'static str, &'static str)]);

#[test]
fn nothing_in_double_precision_is_off_by_more_than_the_table_says() {
    let cusp = Scene {
        m: 19.319544883900978,
        chi: 0.006494187047439116,
        knots: &[(0.0, 1.1771553379847324)],
        t: 4086.643725589503,
    };
    let cone = Scene {
        m: 0.05249569332074722,
        chi: 0.001672794954527616,
        knots: &[
            (0.0, 0.6562628580908265),
            (5907.632279731207, 1.0057956950311702),
            (10038.348004953448, 0.708869608550861),
            (11891.143181237134, 1.2505001071579043),
            (18581.713722734497, 0.7488883319213403),
            (20186.509269249553, 1.102089667646603),
            (25802.820285992446, 1.0186259669522266),
            (29591.362412513605, 0.7116207525234353),
            (35570.60097151232, 0.8748736093449391),
        ],
        t: 34750.39815725618,
    };
    let flat = Scene {
        m: 0.04409475353055249,
        chi: 0.008806341751290825,
        knots: &[(0.0, 1.022743863561472), (180.8491414422973, 0.4244588506606732)],
        t: 946.1175660753303,
    };
    let scenes: [(Scene, Geometry); 3] = [
        (cusp, (&Cusp, &[("0.37", "0.25")])),
        (cone, (&Cone, &[("0.37", "1")])),
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
    let joint = Scene {
        m: 1.2211338,
        chi: 0.00376677,
        knots: &[(0.0, 0.22025336), (422.3748, 0.25338143)],
        t: 4552.1797,
    };
    let unloaded = Scene {
        m: 17.554127,
        chi: 0.009947905,
        knots: &[(0.0, 175.03012), (2525.8416, 34.11327)],
        t: 3760.6902,
    };
    let cusp = Scene { m: 0.017180292, chi: 0.0019748153, knots: &[(0.0, 50.19221)], t: 2599.6624 };
    let flat = Scene {
        m: 0.09112221,
        chi: 0.0020657934,
        knots: &[(0.0, 0.11303882), (2121.9963, 0.16242254)],
        t: 5855.2075,
    };
    let scenes: [(Scene, &dyn GapProfile<f32>, &dyn GapProfile<f64>); 4] = [
        (joint, &Patellofemoral, &Patellofemoral),
        (unloaded, &Patellofemoral, &Patellofemoral),
        (cusp, &Cusp, &Cusp),
        (flat, &Flat, &Flat),
    ];
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
