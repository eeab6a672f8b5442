//! Many scenes with one question each: every patient has another geometry, other layers and another load. The joint is
//! that of the example `parametric_study`.

mod scenes;

use std::hint::black_box;

use cartcontact::{Contact, Layer, Medium, gap_profile, load::Constant};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use scenes::NO_RESULT;

/// A femoral condyle in the hollow of a tibial plateau.
#[gap_profile(
    (1/condyle - 1/plateau) * r^2 / 2 + (1/condyle^3 - 1/plateau^3) * r^4 / 8,
    max_radius = 3/4 * condyle
)]
struct Knee {
    condyle: f64,
    plateau: f64,
}

/// Both radii in mm, thickness in mm, shear modulus in MPa, permeability in mm⁴/(N s), the same for all, and load in N.
type Patient = [f64; 6];

fn patients() -> Vec<Patient> {
    let share = |k: u32, stride: u32| f64::from(k * stride % 1024) / 1023.0;
    let patient = |k| {
        let thickness = 0.5 + share(k, 37);
        let condyle = 20.0 + 20.0 * share(k, 389);
        [
            condyle,
            condyle * (1.5 + share(k, 611)),
            thickness,
            0.1 + 0.4 * share(k, 113),
            1e-3,
            50.0 + 450.0 * share(k, 233),
        ]
    };
    (0..1024).map(patient).collect()
}

type Joint = Contact<f64, Knee, Constant<f64>>;

fn joint(&[condyle, plateau, thickness, shear_modulus, permeability, load]: &Patient) -> Option<Joint> {
    let layer = Layer { thickness, shear_modulus, permeability };
    let medium = Medium::between(layer, layer).ok()?;
    Contact::new(Knee { condyle, plateau }, medium, Constant(load)).ok()
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
