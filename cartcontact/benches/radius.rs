//! The contact radius, in units of `powf`, which is the cost of the closed form (18) of a single power.
//!
//! Throughput is the time of one of many independent values, latency that of one value in a chain where each load
//! integral waits for the radius before it. All functions are measured in the same two loops, including `powf`; the
//! library's path for slices has its own. The generated solvers are compared with one written by hand for its
//! geometry, the run-time polynomial, and `roots`.

mod scenes;

use std::convert::Infallible;
use std::hint::black_box;
use std::time::Duration;

use cartcontact::{GapProfile, Scalar};
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
    at_times(&mut group, &times());
    group.finish();

    let mut group = start(criterion, "radius f32");
    let targets = load_integrals::<f32>();
    throughput(&mut group, "powf", &targets, powf());
    profile(&mut group, "two terms", &targets, &Patellofemoral);
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

fn solvers(group: &mut Group<'_>, targets: &[f64]) {
    function(group, "powf", targets, powf());
    profile(group, "one term", targets, &Paraboloid);
    profile(group, "one term, r^2.3", targets, &BluntBall);
    profile(group, "one term, a cone", targets, &Cone);
    profile(group, "two terms", targets, &Patellofemoral);
    latency(group, "two terms", targets, solver(&Patellofemoral));
    profile(group, "three terms", targets, &ThreeTerm);
    latency(group, "three terms", targets, solver(&ThreeTerm));
    profile(group, "four terms", targets, &FourTerm);
    profile(group, "two terms, fractional powers", targets, &Blunt);
    latency(group, "two terms, fractional powers", targets, solver(&Blunt));
    profile(group, "two terms, powers such as r^2.37", targets, &Fitted);
    profile(group, "one term with a field", targets, &FlatBall { radius: black_box(20.0) });
    profile(group, "two terms with a field", targets, &Ball { radius: black_box(20.0) });
    let flat = Ball { radius: black_box(2e4) };
    profile(group, "two terms with a field, outside the table", targets, &flat);
    profile(group, "three terms with a field", targets, &RoundBall { radius: black_box(20.0) });
    let [b, c, d] = black_box([0.02, 1e-4, 2e-6]);
    profile(group, "three terms with three fields", targets, &ThreeFields { b, c, d });
    profile(group, "three halves with three fields", targets, &ThreeFieldsOfHalves { b, c, d });
    throughput(group, "two terms, Polynomial", targets, solver(&black_box(run_time())));
    function(group, "two terms, by hand", targets, by_hand::radius);
    slice(group, "two terms, by hand", targets, |targets, radii| {
        by_hand::radii(targets, radii);
        Ok::<_, Infallible>(())
    });
    throughput(group, "two terms, by hand, Newton", targets, by_hand::radius_by_newton);
    throughput(group, "two terms, roots", targets, radius_by_roots);
}

/// Radii of contacts under a constant load.
fn at_times(group: &mut Group<'_>, times: &[f64]) {
    let (two, three) = (contact(Patellofemoral), contact(ThreeTerm));
    throughput(group, "two terms, Contact::at", times, |time| two.at(time).map_or(0.0, |now| now.radius()));
    slice(group, "two terms, Contact::radii", times, |times, radii| two.radii(times, radii));
    slice(group, "three terms, Contact::radii", times, |times, radii| three.radii(times, radii));
}

fn powf<T: Scalar>() -> impl Fn(T) -> T {
    let sixth = black_box(T::constant(1.0 / 6.0));
    move |target| target.powf(sixth)
}

fn solver<T: Scalar, P: GapProfile<T>>(profile: &P) -> impl Fn(T) -> T {
    move |target| profile.radius(target).unwrap_or(T::zero())
}

/// The throughput of the contact radius, one by one and of a slice.
fn profile<T: Scalar>(group: &mut Group<'_>, name: &str, targets: &[T], profile: &impl GapProfile<T>) {
    throughput(group, name, targets, solver(profile));
    slice(group, name, targets, |targets, radii| profile.radii(targets, radii));
}

/// The throughput and the latency of a function.
fn function<T: Scalar>(group: &mut Group<'_>, name: &str, arguments: &[T], f: impl Fn(T) -> T) {
    throughput(group, name, arguments, &f);
    latency(group, name, arguments, f);
}

/// The throughput of a function whose results are positive.
fn throughput<T: Scalar>(group: &mut Group<'_>, name: &str, arguments: &[T], f: impl Fn(T) -> T) {
    assert!(arguments.iter().all(|&argument| f(argument) > T::zero()), "{name}: {NO_RESULT}");
    group.throughput(Throughput::Elements(arguments.len() as u64));
    let mut values = vec![T::zero(); arguments.len()];
    group.bench_function(BenchmarkId::new("throughput", name), |bencher| {
        bencher.iter(|| {
            for (value, &argument) in black_box(&mut values[..]).iter_mut().zip(black_box(arguments)) {
                *value = f(argument);
            }
        });
    });
}

fn latency<T: Scalar>(group: &mut Group<'_>, name: &str, arguments: &[T], f: impl Fn(T) -> T) {
    group.throughput(Throughput::Elements(arguments.len() as u64));
    // The link is so small that it changes no argument.
    let link = black_box(T::constant(1e-30));
    group.bench_function(BenchmarkId::new("latency", name), |bencher| {
        bencher.iter(|| {
            black_box(arguments).iter().fold(T::zero(), |last, &argument| f(argument + last * link))
        });
    });
}

/// The throughput of a function of slices.
fn slice<T: Scalar, E>(
    group: &mut Group<'_>,
    name: &str,
    arguments: &[T],
    f: impl Fn(&[T], &mut [T]) -> Result<(), E>,
) {
    group.throughput(Throughput::Elements(arguments.len() as u64));
    let mut values = vec![T::zero(); arguments.len()];
    assert!(f(arguments, &mut values).is_ok(), "{name}: {NO_RESULT}");
    group.bench_function(BenchmarkId::new("slice", name), |bencher| {
        bencher.iter(|| f(black_box(arguments), black_box(&mut values)));
    });
}

criterion_group!(benches, radius, evaluators);
criterion_main!(benches);
