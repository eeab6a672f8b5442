//! Pressure fields, compared with filling the same memory and with the printed formulas at every point.

mod scenes;

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use scenes::printed::Pressure;
use scenes::{NO_RESULT, Patellofemoral, as_printed, contact, steps};

/// The numbers of times and radii.
const SHAPES: [(usize, usize); 3] = [(1000, 1000), (250, 4000), (4000, 250)];
/// The last time, in s, and the last radius, in mm.
const END: (f64, f64) = (400.0, 9.0);
/// With 8 nodes the relative error of the integral in the printed formulas is at most 3.7e-16, at 400 s and the first
/// contact radius, 7.146 mm; with 7 nodes it is 3.2e-14, more than rounding.
const NODES: usize = 8;

fn field(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("field");
    group.sample_size(20);
    let contact = contact(Patellofemoral);
    for (rows, columns) in SHAPES {
        let size = format!("{rows} x {columns}");
        let (times, radii) = (steps(rows, END.0), steps(columns, END.1));
        let mut values = vec![0.0; rows * columns];
        let solved = contact.pressure_field(&times, &radii, &mut values);
        assert!(solved.is_ok(), "{NO_RESULT}");
        group.throughput(Throughput::Elements(values.len() as u64));
        group.bench_function(BenchmarkId::new("fill with a constant", &size), |b| {
            b.iter(|| black_box(&mut values[..]).fill(black_box(1.5)));
        });
        group.bench_function(BenchmarkId::new("pressure_field", &size), |b| {
            b.iter(|| contact.pressure_field(black_box(&times), black_box(&radii), &mut values));
        });
    }
    // A hundredth of the points of the fields above; multiply by 100 to compare.
    let (printed, times, radii) = (as_printed(NODES), steps(100, END.0), steps(100, END.1));
    let mut values = vec![0.0; times.len() * radii.len()];
    fill_as_printed(&printed, &times, &radii, &mut values);
    // A sixth lies outside the contact.
    let inside = values.iter().filter(|value| **value > 0.0).count();
    assert!(values.iter().all(|value| *value >= 0.0) && 5 * inside > 4 * values.len(), "{NO_RESULT}");
    group.throughput(Throughput::Elements(values.len() as u64));
    group.bench_function("as printed (26)-(27) at every point/100 x 100", |b| {
        b.iter(|| fill_as_printed(&printed, &times, &radii, &mut values));
    });
    group.finish();
}

/// Nothing is shared between points: each finds the contact radii at its nodes again, which takes most of its time.
fn fill_as_printed(printed: &Pressure, times: &[f64], radii: &[f64], values: &mut [f64]) {
    for (row, &t) in values.chunks_exact_mut(radii.len()).zip(times) {
        for (value, &r) in row.iter_mut().zip(radii) {
            *value = printed.at(t, r).unwrap_or(f64::NAN);
        }
    }
    black_box(values);
}

criterion_group!(benches, field);
criterion_main!(benches);
