//! What a scene saves by what it does not need; each pair is the same scene without and with the need.

mod scenes;

use std::hint::black_box;

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, Medium};
use criterion::{Criterion, criterion_group, criterion_main};
use scenes::{LOAD, Patellofemoral, RATE, STIFFNESS, contact, run_time};

fn skipping(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("skipping");
    let joint = contact(Patellofemoral);

    group.bench_function("memory/t = 0: none", |b| b.iter(|| pressure_at(&joint, 0.0, 3.0)));
    group.bench_function("memory/t = 200 s", |b| b.iter(|| pressure_at(&joint, 200.0, 3.0)));

    group
        .bench_function("outside the contact/outside: zero", |b| b.iter(|| pressure_at(&joint, 200.0, 20.0)));
    group.bench_function("outside the contact/inside", |b| b.iter(|| pressure_at(&joint, 200.0, 7.0)));

    group.bench_function("on demand/radius only", |b| {
        b.iter(|| joint.at(black_box(200.0)).map_or(0.0, |now| now.radius()));
    });
    group.bench_function("on demand/radius, approach and peak pressure", |b| {
        b.iter(|| {
            joint.at(black_box(200.0)).map_or(0.0, |now| now.radius() + now.approach() + now.peak_pressure())
        });
    });

    let powers = contact(run_time());
    group.bench_function("whole exponents/multiplications", |b| b.iter(|| pressure_at(&joint, 200.0, 3.0)));
    group.bench_function("whole exponents/any exponent", |b| b.iter(|| pressure_at(&powers, 200.0, 3.0)));

    if let Ok((straight, unknown)) = loads() {
        group.bench_function("straight load/age by a formula", |b| {
            b.iter(|| pressure_at(&straight, 200.0, 3.0));
        });
        group.bench_function("straight load/age by iteration", |b| {
            b.iter(|| pressure_at(&unknown, 200.0, 3.0));
        });
    }
    if let Ok((short, long)) = histories() {
        group.bench_function("faded history/40 e-foldings of knots", |b| {
            b.iter(|| pressure_at(&short, 1000.0, 3.0));
        });
        group.bench_function("faded history/ten times as many knots", |b| {
            b.iter(|| pressure_at(&long, 10_000.0, 3.0));
        });
    }
    group.finish();
}

fn pressure_at<P: GapProfile<f64>, L: Load<f64>>(contact: &Contact<f64, P, L>, t: f64, r: f64) -> f64 {
    contact.at(black_box(t)).map_or(0.0, |now| now.pressure(black_box(r)))
}

/// A constant load that does not say that it is one.
struct Unknown(f64);

impl Load<f64> for Unknown {
    fn force(&self, _t: f64) -> f64 {
        self.0
    }
    fn impulse(&self, t: f64) -> f64 {
        self.0 * t
    }
}

type Joint<L> = Contact<f64, Patellofemoral, L>;
type Fault = Box<dyn std::error::Error>;

fn loads() -> Result<(Joint<Constant<f64>>, Joint<Unknown>), Fault> {
    let medium = Medium::from_constants(STIFFNESS, RATE)?;
    let straight = Contact::new(Patellofemoral, medium, Constant(LOAD))?;
    Ok((straight, Contact::new(Patellofemoral, medium, Unknown(LOAD))?))
}

type Knots = PiecewiseLinear<f64, Vec<(f64, f64)>>;

/// Loads that rise every 10 s up to 1000 s and 10 000 s, in a medium that forgets in 20 s.
fn histories() -> Result<(Joint<Knots>, Joint<Knots>), Fault> {
    let medium = Medium::from_constants(STIFFNESS, 0.05)?;
    let rising = |count: u32| {
        let knots = (0..count).map(|k| (10.0 * f64::from(k), LOAD * (1.0 + f64::from(k + k % 2) / 1000.0)));
        PiecewiseLinear::new(knots.collect())
    };
    let short = Contact::new(Patellofemoral, medium, rising(100)?)?;
    Ok((short, Contact::new(Patellofemoral, medium, rising(1000)?)?))
}

criterion_group!(benches, skipping);
criterion_main!(benches);
