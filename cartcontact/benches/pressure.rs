//! One cold pressure, radius and memory integral included, compared with the formulas as printed.

mod scenes;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
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
    group.bench_function("generated, constant load", |b| b.iter(|| pressure_at(&generated, 200.0, 3.0)));
    // χ t = 30, nearly as much as is not faded.
    group.bench_function("constant load, after 30 e-foldings", |b| {
        b.iter(|| pressure_at(&generated, 20_000.0, 3.0));
    });
    let three = contact(ThreeTerm);
    group.bench_function("three terms", |b| b.iter(|| pressure_at(&three, 200.0, 3.0)));
    let cone = contact(Cone);
    group.bench_function("a cone", |b| b.iter(|| pressure_at(&cone, 200.0, 3.0)));
    let of_a_field = contact(Ball { radius: 20.0 });
    group.bench_function("two terms with a field", |b| b.iter(|| pressure_at(&of_a_field, 200.0, 3.0)));
    let fractional = contact(Blunt);
    group.bench_function("fractional powers", |b| b.iter(|| pressure_at(&fractional, 200.0, 3.0)));
    let fitted = contact(Fitted);
    group.bench_function("powers such as r^2.37", |b| b.iter(|| pressure_at(&fitted, 200.0, 3.0)));
    let polynomial = contact(run_time::<f64>());
    group.bench_function("Polynomial, constant load", |b| b.iter(|| pressure_at(&polynomial, 200.0, 3.0)));
    let (slow, quick) = (hundred_knots(RATE), hundred_knots(2.0));
    group.bench_function("generated, 100 knots that count", |b| b.iter(|| pressure_at(&slow, 200.0, 3.0)));
    group.bench_function("generated, 100 knots, 10 that count", |b| {
        b.iter(|| pressure_at(&quick, 190.0, 3.0));
    });
    let printed = as_printed(NODES);
    assert!(printed.at(200.0, 3.0).is_ok(), "{NO_RESULT}");
    group.bench_function("as printed (25)-(27), gauss-quad and roots", |b| {
        b.iter(|| printed.at(black_box(200.0), black_box(3.0)));
    });
    group.finish();
}

criterion_group!(benches, pressure);
criterion_main!(benches);
