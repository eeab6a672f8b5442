//! What a scene saves by the work that it does not need: each pair is a scene without a need, and the same scene with
//! the need, or without a visible sign that the need is absent.

mod scenes;

use std::hint::black_box;

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, gap_profile};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use scenes::{FORCE, NO_RESULT, Paraboloid, Patellofemoral, RATE, contact, loaded, pressure_at};

/// [`Paraboloid`] with a negligible second term.
#[gap_profile(0.025 * r^2 + 1e-40 * r^4)]
struct HiddenParaboloid;

/// [`Patellofemoral`] with a negligible odd power.
#[gap_profile(0.025 * r^2 + 1e-40 * r^3 + 1.09375e-4 * r^4)]
struct HiddenEven;

/// [`HiddenEven`] with exponents that are not quite whole.
#[gap_profile(0.025 * r^2.01 + 1e-40 * r^3.01 + 1.09375e-4 * r^4.01)]
struct HardlyWhole;

fn skipping(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("skipping");
    geometries(&mut group);
    histories(&mut group);
    questions(&mut group);
    group.finish();
}

type Group<'a> = BenchmarkGroup<'a, WallTime>;

fn pair(group: &mut Group<'_>, name: &str, scenes: [(&str, &dyn Fn() -> f64); 2]) {
    for (scene, run) in scenes {
        assert!(run().is_finite(), "{name}/{scene}: {NO_RESULT}");
        group.bench_function(format!("{name}/{scene}"), |b| b.iter(run));
    }
}

/// Work that a gap does not need.
fn geometries(group: &mut Group<'_>) {
    let (one, two) = (contact(Paraboloid), contact(HiddenParaboloid));
    pair(
        group,
        "one term",
        [("alone", &|| radius_at(&one, 200.0)), ("with a second one", &|| radius_at(&two, 200.0))],
    );
    let (even, odd) = (contact(Patellofemoral), contact(HiddenEven));
    pair(
        group,
        "even powers",
        [
            ("in the square of r", &|| pressure_at(&even, 200.0, 3.0)),
            ("in r", &|| pressure_at(&odd, 200.0, 3.0)),
        ],
    );
    let real = contact(HardlyWhole);
    pair(
        group,
        "whole powers",
        [
            ("multiplications", &|| pressure_at(&odd, 200.0, 3.0)),
            ("exponentials", &|| pressure_at(&real, 200.0, 3.0)),
        ],
    );
}

/// Work that a history does not need.
fn histories(group: &mut Group<'_>) {
    let joint = contact(Patellofemoral);
    pair(
        group,
        "memory",
        [
            ("t = 0: none", &|| pressure_at(&joint, 0.0, 3.0)),
            ("t = 200 s", &|| pressure_at(&joint, 200.0, 3.0)),
        ],
    );
    let undrained = loaded(Patellofemoral, 0.0, Constant(FORCE));
    pair(
        group,
        "drainage",
        [
            ("chi = 0: no memory", &|| pressure_at(&undrained, 200.0, 3.0)),
            ("chi = 0.0015/s", &|| pressure_at(&joint, 200.0, 3.0)),
        ],
    );
    // Falls between its knots must be ruled out too.
    let unknown = loaded(Patellofemoral, RATE, Unknown(FORCE));
    pair(
        group,
        "straight load",
        [
            ("says so", &|| pressure_at(&joint, 200.0, 3.0)),
            ("does not say so", &|| pressure_at(&unknown, 200.0, 3.0)),
        ],
    );
    // The memory of the medium lasts 20 s.
    let [short, long] = [100, 1000].map(|count| loaded(Patellofemoral, 0.05, rising_load(count)));
    pair(
        group,
        "faded history",
        [
            ("900 s of knots, the last 800 s count", &|| pressure_at(&short, 900.0, 3.0)),
            ("9900 s of knots, the last 800 s count", &|| pressure_at(&long, 9900.0, 3.0)),
        ],
    );
}

/// Results that are not asked for.
fn questions(group: &mut Group<'_>) {
    let joint = contact(Patellofemoral);
    pair(
        group,
        "outside the contact",
        [
            ("outside: zero", &|| pressure_at(&joint, 200.0, 20.0)),
            ("inside", &|| pressure_at(&joint, 200.0, 7.0)),
        ],
    );
    pair(
        group,
        "on demand",
        [
            ("radius only", &|| radius_at(&joint, 200.0)),
            ("radius, approach and peak pressure", &|| {
                joint
                    .at(black_box(200.0))
                    .map_or(f64::NAN, |now| now.radius() + now.approach() + now.peak_pressure())
            }),
        ],
    );
}

fn radius_at<P: GapProfile<f64>>(contact: &Contact<f64, P, Constant<f64>>, t: f64) -> f64 {
    contact.at(black_box(t)).map_or(f64::NAN, |now| now.radius())
}

/// A constant load that does not say that it is constant.
struct Unknown(f64);

impl Load<f64> for Unknown {
    fn force(&self, _t: f64) -> f64 {
        self.0
    }
    fn impulse(&self, t: f64) -> f64 {
        self.0 * t
    }
}

/// A load that rises every 10 s.
#[expect(clippy::expect_used, reason = "a benchmark has no use for an error")]
fn rising_load(count: u32) -> PiecewiseLinear<f64, Vec<(f64, f64)>> {
    let knots = (0..count).map(|k| (10.0 * f64::from(k), FORCE * (1.0 + f64::from(k + k % 2) / 1000.0)));
    PiecewiseLinear::new(knots.collect()).expect("a valid load")
}

criterion_group!(benches, skipping);
criterion_main!(benches);
