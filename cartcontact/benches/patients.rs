//! Many scenes with one question each: every patient has another geometry, other layers and another load.

mod scenes;

use std::hint::black_box;

use cartcontact::{Contact, Layer, Medium, load::Constant};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use scenes::{Ball, NO_RESULT};

/// What differs from patient to patient: radius, thickness, shear modulus, permeability and load.
type Patient = [f64; 5];

fn patients() -> Vec<Patient> {
    let share = |k: u32, stride: u32| f64::from(k * stride % 1024) / 1023.0;
    let patient = |k| {
        let thickness = 0.5 + share(k, 37);
        [
            10.0 + 30.0 * share(k, 389),
            thickness,
            0.1 + 0.4 * share(k, 113),
            1e-3,
            50.0 + 450.0 * share(k, 233),
        ]
    };
    (0..1024).map(patient).collect()
}

type Joint = Contact<f64, Ball<f64>, Constant<f64>>;

fn joint(&[radius, thickness, shear_modulus, permeability, load]: &Patient) -> Option<Joint> {
    let layer = Layer { thickness, shear_modulus, permeability };
    let medium = Medium::between(layer, layer).ok()?;
    Contact::new(Ball { radius }, medium, Constant(load)).ok()
}

/// Radius, approach and peak pressure at one time.
fn study(patient: &Patient) -> Option<f64> {
    let joint = joint(patient)?;
    let now = joint.at(200.0).ok()?;
    Some(now.radius() + now.approach() + now.peak_pressure())
}

fn scenes_of_patients(criterion: &mut Criterion) {
    let patients = patients();
    assert!(patients.iter().all(|patient| study(patient).is_some()), "{NO_RESULT}");
    let mut group = criterion.benchmark_group("scenes");
    group.throughput(Throughput::Elements(patients.len() as u64));
    group.bench_function("Contact::new", |b| {
        b.iter(|| {
            for patient in &patients {
                black_box(joint(black_box(patient)));
            }
        });
    });
    group.bench_function("study", |b| {
        b.iter(|| patients.iter().filter_map(|patient| study(black_box(patient))).sum::<f64>());
    });
    group.finish();
}

criterion_group!(benches, scenes_of_patients);
criterion_main!(benches);
