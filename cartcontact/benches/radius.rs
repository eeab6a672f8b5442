//! The contact radius, in units of `powf`, which is the cost of the closed form (18) of a single power.
//!
//! Throughput is the time of one of many independent values, latency that of one value in a chain where each load
//! integral waits for the radius before it. All functions are measured in the same two loops, including `powf`; the
//! library's path for slices has its own. The generated solvers are compared with one written by hand for its
//! geometry, the run-time polynomial, and `roots`.

mod scenes;

use std::hint::black_box;
use std::time::Duration;

use cartcontact::{GapProfile, RadiusError, Scalar};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use scenes::{
    Ball, Blunt, BluntBall, Cone, Fitted, FlatBall, FourTerm, NO_RESULT, Paraboloid, Patellofemoral,
    RoundBall, ThreeFields, ThreeFieldsOfHalves, ThreeTerm, by_hand, contact, load_integrals,
    radius_by_roots, run_time, times,
};

type Group<'a> = BenchmarkGroup<'a, WallTime>;

fn radius(criterion: &mut Criterion) {
    let mut group = start(criterion, "radius f64");
    let targets = load_integrals::<f64>();
    solvers(&mut group, &targets);
    function(&mut group, "two terms, by hand", &targets, by_hand::radius);
    function(&mut group, "two terms, by hand, Newton", &targets, by_hand::radius_by_newton);
    function(&mut group, "two terms, roots", &targets, radius_by_roots);
    slice(&mut group, "two terms, by hand", &targets, |targets, radii| {
        by_hand::radii(targets, radii);
        Ok(())
    });
    at_times(&mut group, "one term", Paraboloid);
    at_times(&mut group, "two terms", Patellofemoral);
    at_times(&mut group, "three terms", ThreeTerm);
    group.finish();

    let mut group = start(criterion, "radius f32");
    solvers(&mut group, &load_integrals::<f32>());
    group.finish();
}

/// The generated evaluators and the same functions written by hand.
fn evaluators(criterion: &mut Criterion) {
    let mut group = start(criterion, "evaluators f64");
    let mut radii: Vec<f64> = load_integrals();
    radii.iter_mut().for_each(|y| *y = by_hand::radius(*y));
    function(&mut group, "approach", &radii, |a| Patellofemoral.approach(a));
    function(&mut group, "approach, by hand", &radii, by_hand::approach);
    function(&mut group, "load integral", &radii, |a| Patellofemoral.load_integral(a));
    function(&mut group, "load integral, by hand", &radii, by_hand::load_integral);
    function(&mut group, "pressure kernel", &radii, |a| Patellofemoral.pressure_kernel(a, 3.0));
    function(&mut group, "pressure kernel, by hand", &radii, |a| by_hand::pressure_kernel(a, 3.0));
    group.finish();
}

fn start<'a>(criterion: &'a mut Criterion, name: &str) -> Group<'a> {
    let mut group = criterion.benchmark_group(name);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
    group
}

fn solvers<T: Scalar>(group: &mut Group<'_>, targets: &[T]) {
    let sixth = black_box(T::constant(1.0 / 6.0));
    function(group, "powf", targets, |target| target.powf(sixth));
    profile(group, "one term", targets, &Paraboloid);
    profile(group, "one term, r^2.3", targets, &BluntBall);
    profile(group, "one term, a cone", targets, &Cone);
    profile(group, "two terms", targets, &Patellofemoral);
    profile(group, "three terms", targets, &ThreeTerm);
    profile(group, "four terms", targets, &FourTerm);
    profile(group, "two terms, fractional powers", targets, &Blunt);
    profile(group, "two terms, powers such as r^2.37", targets, &Fitted);
    profile(group, "one term with a field", targets, &FlatBall { radius: black_box(T::constant(20.0)) });
    profile(group, "two terms with a field", targets, &Ball { radius: black_box(T::constant(20.0)) });
    let flat = Ball { radius: black_box(T::constant(2e4)) };
    profile(group, "two terms with a field, outside the table", targets, &flat);
    let round_ball = RoundBall { radius: black_box(T::constant(20.0)) };
    profile(group, "three terms with a field", targets, &round_ball);
    let [b, c, d] = [0.02, 1e-4, 2e-6].map(|value| black_box(T::constant(value)));
    profile(group, "three terms with three fields", targets, &ThreeFields { b, c, d });
    profile(group, "three halves with three fields", targets, &ThreeFieldsOfHalves { b, c, d });
    let polynomial = run_time::<T>();
    profile(group, "two terms, Polynomial", targets, &black_box(polynomial));
}

fn profile<T: Scalar>(group: &mut Group<'_>, name: &str, targets: &[T], profile: &impl GapProfile<T>) {
    assert!(targets.iter().all(|&target| profile.radius(target).is_ok()), "{name}: {NO_RESULT}");
    function(group, name, targets, |target| profile.radius(target).unwrap_or(T::zero()));
    slice(group, name, targets, |targets, radii| profile.radii(targets, radii));
}

/// The throughput and the latency of a function.
fn function<T: Scalar>(group: &mut Group<'_>, name: &str, arguments: &[T], f: impl Fn(T) -> T) {
    group.throughput(Throughput::Elements(arguments.len() as u64));
    let mut values = vec![T::zero(); arguments.len()];
    group.bench_function(BenchmarkId::new("throughput", name), |bencher| {
        bencher.iter(|| {
            for (value, &argument) in black_box(&mut values[..]).iter_mut().zip(black_box(arguments)) {
                *value = f(argument);
            }
        });
    });
    // The link is so small that it changes no argument.
    let link = black_box(T::constant(1e-30));
    group.bench_function(BenchmarkId::new("latency", name), |bencher| {
        bencher.iter(|| {
            black_box(arguments).iter().fold(T::zero(), |last, &argument| f(argument + last * link))
        });
    });
}

/// The throughput of a function of slices.
fn slice<T: Scalar>(
    group: &mut Group<'_>,
    name: &str,
    arguments: &[T],
    f: impl Fn(&[T], &mut [T]) -> Result<(), RadiusError>,
) {
    group.throughput(Throughput::Elements(arguments.len() as u64));
    let mut values = vec![T::zero(); arguments.len()];
    assert!(f(arguments, &mut values).is_ok(), "{name}: {NO_RESULT}");
    group.bench_function(BenchmarkId::new("slice", name), |bencher| {
        bencher.iter(|| f(black_box(arguments), black_box(&mut values)));
    });
}

/// The throughput of the radii of a contact under a constant load, at many times at once and one by one.
fn at_times(group: &mut Group<'_>, name: &str, profile: impl GapProfile<f64>) {
    let (contact, times) = (contact(profile), times());
    assert!(times.iter().all(|&time| contact.at(time).is_ok()), "{name}: {NO_RESULT}");
    group.throughput(Throughput::Elements(times.len() as u64));
    let mut radii = vec![0.0; times.len()];
    assert!(contact.radii(&times, &mut radii).is_ok(), "{name}: {NO_RESULT}");
    group.bench_function(BenchmarkId::new("Contact::radii", name), |bencher| {
        bencher.iter(|| contact.radii(black_box(&times), black_box(&mut radii)));
    });
    group.bench_function(BenchmarkId::new("Contact::at", name), |bencher| {
        bencher.iter(|| {
            for (radius, &time) in black_box(&mut radii[..]).iter_mut().zip(black_box(&times)) {
                *radius = contact.at(time).map_or(0.0, |now| now.radius());
            }
        });
    });
}

criterion_group!(benches, radius, evaluators);
criterion_main!(benches);
