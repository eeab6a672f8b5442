//! One cold pressure, radius and memory integral included, compared with the formulas as printed.

mod scenes;

use std::hint::black_box;

use cartcontact::load::Load;
use cartcontact::{Contact, GapProfile};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use scenes::{
    Ball, Blunt, Cone, Fitted, NO_RESULT, Patellofemoral, RATE, ThreeTerm, as_printed, contact,
    hundred_knots, pressure_at, run_time,
};

/// With 6 nodes the relative error of the integral at t = 200 s and r = 3 mm is 3.5e-18; with 5 nodes it is 1.2e-15,
/// more than rounding.
const NODES: usize = 6;

fn pressure(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("pressure");
    let generated = contact(Patellofemoral);
    cold(&mut group, "generated, constant load", &generated, 200.0);
    // χ t = 30, nearly as much as is not faded.
    cold(&mut group, "constant load, after 30 e-foldings", &generated, 20_000.0);
    cold(&mut group, "three terms", &contact(ThreeTerm), 200.0);
    cold(&mut group, "a cone", &contact(Cone), 200.0);
    cold(&mut group, "two terms with a field", &contact(Ball { radius: 20.0 }), 200.0);
    cold(&mut group, "fractional powers", &contact(Blunt), 200.0);
    cold(&mut group, "powers such as r^2.37", &contact(Fitted), 200.0);
    cold(&mut group, "Polynomial, constant load", &contact(run_time()), 200.0);
    cold(&mut group, "generated, 100 knots that count", &hundred_knots(RATE), 200.0);
    cold(&mut group, "generated, 100 knots, 10 that count", &hundred_knots(2.0), 190.0);
    let printed = as_printed(NODES);
    assert!(printed.at(200.0, 3.0).is_ok(), "{NO_RESULT}");
    group.bench_function("as printed (25)-(27), gauss-quad and roots", |b| {
        b.iter(|| printed.at(black_box(200.0), black_box(3.0)));
    });
    group.finish();
}

/// The pressure at 3 mm, of which nothing is kept from one call to the next.
fn cold<P: GapProfile<f64>, L: Load<f64>>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    contact: &Contact<f64, P, L>,
    t: f64,
) {
    group.bench_function(name, |b| b.iter(|| pressure_at(contact, t, 3.0)));
}

criterion_group!(benches, pressure);
criterion_main!(benches);
