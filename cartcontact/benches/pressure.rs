//! One pressure, cold: radius and memory integral included; beside the formulas as printed.

mod scenes;

use std::hint::black_box;
use std::num::NonZeroUsize;

use cartcontact::load::PiecewiseLinear;
use cartcontact::{Contact, Medium};
use criterion::{Criterion, criterion_group, criterion_main};
use gauss_quad::GaussLegendre;
use scenes::{
    Ball, Blunt, LOAD, Patellofemoral, RATE, STIFFNESS, contact, pressure_as_printed, pressure_at, run_time,
};

fn pressure(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("pressure");
    group.bench_function("powf", |b| b.iter(|| black_box(3.7_f64).powf(black_box(1.0 / 6.0))));
    let generated = contact(Patellofemoral);
    group.bench_function("generated, constant load", |b| b.iter(|| pressure_at(&generated, 200.0, 3.0)));
    let of_a_field = contact(Ball { radius: 20.0 });
    group.bench_function("two terms with a field", |b| b.iter(|| pressure_at(&of_a_field, 200.0, 3.0)));
    let fractional = contact(Blunt);
    group.bench_function("fractional powers", |b| b.iter(|| pressure_at(&fractional, 200.0, 3.0)));
    let polynomial = contact(run_time());
    group.bench_function("Polynomial, constant load", |b| b.iter(|| pressure_at(&polynomial, 200.0, 3.0)));
    if let (Ok(slow), Ok(quick)) = (measured(RATE), measured(2.0)) {
        group
            .bench_function("generated, 100 knots that count", |b| b.iter(|| pressure_at(&slow, 200.0, 3.0)));
        group.bench_function("generated, 100 knots, 10 that count", |b| {
            b.iter(|| pressure_at(&quick, 190.0, 3.0));
        });
    }
    // 16 nodes leave 1e-15 of the integral at χ t = 0.3.
    if let Some(nodes) = NonZeroUsize::new(16) {
        let rule = GaussLegendre::new(nodes);
        group.bench_function("as printed (25)-(27), gauss-quad and roots", |b| {
            b.iter(|| pressure_as_printed(&rule, black_box(200.0), black_box(3.0)));
        });
    }
    group.finish();
}

type Measured = Contact<f64, Patellofemoral, PiecewiseLinear<f64, Vec<(f64, f64)>>>;

/// A load that rises through 100 knots, every second piece of it level.
fn measured(rate: f64) -> Result<Measured, Box<dyn std::error::Error>> {
    let knots = (0..100).map(|k| (2.0 * f64::from(k), LOAD * (0.2 + f64::from(k + k % 2) / 100.0))).collect();
    let medium = Medium::from_constants(STIFFNESS, rate)?;
    Ok(Contact::new(Patellofemoral, medium, PiecewiseLinear::new(knots)?)?)
}

criterion_group!(benches, pressure);
criterion_main!(benches);
