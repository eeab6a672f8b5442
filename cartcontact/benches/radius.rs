//! The contact radius: generated solvers beside the closed form (18), a run-time polynomial and `roots`.

mod scenes;

use std::hint::black_box;

use cartcontact::GapProfile;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use scenes::{FourTerm, Paraboloid, Patellofemoral, load_integrals, radius_by_roots, run_time};

fn radius(criterion: &mut Criterion) {
    let targets = load_integrals();
    let polynomial = run_time();

    let mut group = criterion.benchmark_group("radius");
    group.throughput(Throughput::Elements(targets.len() as u64));
    group.bench_function("powf, closed form (18)", |b| {
        b.iter(|| targets.iter().map(|&target| (black_box(target) * 480.0).powf(1.0 / 6.0)).sum::<f64>());
    });
    group.bench_function("generated, one term", |b| {
        b.iter(|| targets.iter().map(|&target| radius_of(&Paraboloid, target)).sum::<f64>());
    });
    group.bench_function("generated, two terms", |b| {
        b.iter(|| targets.iter().map(|&target| radius_of(&Patellofemoral, target)).sum::<f64>());
    });
    group.bench_function("generated, four terms", |b| {
        b.iter(|| targets.iter().map(|&target| radius_of(&FourTerm, target)).sum::<f64>());
    });
    group.bench_function("Polynomial, two terms", |b| {
        b.iter(|| targets.iter().map(|&target| radius_of(&polynomial, target)).sum::<f64>());
    });
    group.bench_function("roots, two terms", |b| {
        b.iter(|| targets.iter().map(|&target| radius_by_roots(black_box(target))).sum::<f64>());
    });
    group.finish();
}

fn radius_of(profile: &impl GapProfile<f64>, target: f64) -> f64 {
    profile.radius(black_box(target)).unwrap_or(0.0)
}

criterion_group!(benches, radius);
criterion_main!(benches);
