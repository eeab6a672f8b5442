//! Instructions of the hot functions, counted by valgrind; `.ci/instructions` compares the counts with those in
//! `instructions.txt`.
//!
//! Functions of a number are called for 1024 numbers, one by one, so that the code around the calls hardly counts.
#![allow(missing_docs, reason = "the modules that the attribute makes have no documentation")]

mod scenes;

use std::hint::black_box;

use cartcontact::load::Load;
use cartcontact::{Contact, GapProfile, Scalar, gap_profile};
use gungraun::prelude::*;
use scenes::{
    Ball, Blunt, BluntBall, Fitted, FlatBall, FourTerm, NO_RESULT, Paraboloid, Patellofemoral, RATE,
    RoundBall, Settling, ThreeFields, ThreeFieldsOfHalves, ThreeTerm, by_hand, contact, load_integrals,
    run_time, steps, times,
};

/// Powers with many missing between them.
#[gap_profile(0.025 * r^2 + 1e-12 * r^12)]
struct Steep;

#[gap_profile(sphere(20), order = 24, max_radius = 15)]
struct Sphere;

/// A profile with load integrals and places for their radii.
fn targets<T: Scalar, P>(profile: P) -> (P, Vec<T>, Vec<T>) {
    let targets = load_integrals();
    let radii = vec![T::zero(); targets.len()];
    (profile, targets, radii)
}

/// A profile with contact radii and places for values there.
fn radii<P>(profile: P) -> (P, Vec<f64>, Vec<f64>) {
    let (profile, mut radii, values) = targets(profile);
    radii.iter_mut().for_each(|target| *target = by_hand::radius(*target));
    (profile, radii, values)
}

type Given<P, T> = (P, Vec<T>, Vec<T>);

/// The values of a function; the compiler must not compute several of them at a time.
#[inline(always)]
fn each<P, T: Scalar>((profile, arguments, mut values): Given<P, T>, f: impl Fn(&P, T) -> T) -> Given<P, T> {
    for (value, &argument) in values.iter_mut().zip(&arguments) {
        *value = f(&profile, black_box(argument));
    }
    (profile, arguments, values)
}

/// Asserts that all radii are positive, after the measurement, which an extra call before it might change.
fn assert_solved<P, T: Scalar>((_, _, radii): Given<P, T>) {
    assert!(radii.iter().all(|&radius| radius > T::zero()), "{NO_RESULT}");
}

#[library_benchmark(setup = targets::<f64, _>, teardown = assert_solved)]
#[bench::one_term(Paraboloid)]
#[bench::one_term_of_any_power(BluntBall)]
#[bench::two_terms(Patellofemoral)]
#[bench::three_terms(ThreeTerm)]
#[bench::four_terms(FourTerm)]
#[bench::fractional_powers(Fitted)]
#[bench::one_term_with_a_field(FlatBall { radius: 20.0 })]
#[bench::two_terms_with_a_field(Ball { radius: 20.0 })]
#[bench::three_terms_with_a_field(RoundBall { radius: 20.0 })]
#[bench::three_terms_with_three_fields(ThreeFields { b: 0.02, c: 1e-4, d: 2e-6 })]
#[bench::three_halves_with_three_fields(ThreeFieldsOfHalves { b: 0.02, c: 1e-4, d: 2e-6 })]
#[bench::polynomial(run_time())]
fn radius<P: GapProfile<f64>>(given: Given<P, f64>) -> Given<P, f64> {
    each(given, |profile, target| profile.radius(target).unwrap_or(0.0))
}

#[library_benchmark(setup = targets::<f32, _>, teardown = assert_solved)]
#[bench::two_terms(Patellofemoral)]
fn radius_f32<P: GapProfile<f32>>(given: Given<P, f32>) -> Given<P, f32> {
    each(given, |profile, target| profile.radius(target).unwrap_or(0.0))
}

#[library_benchmark(setup = targets::<f64, _>)]
#[bench::by_hand(())]
fn radius_by_hand(given: Given<(), f64>) -> Given<(), f64> {
    each(given, |(), target| by_hand::radius(target))
}

#[library_benchmark(setup = targets::<f64, _>, teardown = assert_solved)]
#[bench::one_term(Paraboloid)]
#[bench::one_term_of_any_power(BluntBall)]
#[bench::two_terms(Patellofemoral)]
#[bench::four_terms(FourTerm)]
#[bench::fractional_powers(Fitted)]
#[bench::one_term_with_a_field(FlatBall { radius: 20.0 })]
#[bench::two_terms_with_a_field(Ball { radius: 20.0 })]
#[bench::two_terms_with_a_field_outside_the_table(Ball { radius: 2e4 })]
#[bench::three_terms_with_a_field(RoundBall { radius: 20.0 })]
#[bench::three_terms_with_three_fields(ThreeFields { b: 0.02, c: 1e-4, d: 2e-6 })]
#[bench::three_halves_with_three_fields(ThreeFieldsOfHalves { b: 0.02, c: 1e-4, d: 2e-6 })]
fn radii_of_a_slice<P: GapProfile<f64>>((profile, targets, mut radii): Given<P, f64>) -> Given<P, f64> {
    // `assert_solved` checks the result.
    let _ = profile.radii(&targets, &mut radii);
    (profile, targets, radii)
}

/// A contact with times and places for its radii.
fn at_times<L>(contact: Contact<f64, Patellofemoral, L>) -> Given<Contact<f64, Patellofemoral, L>, f64> {
    let times = times();
    let radii = vec![0.0; times.len()];
    (contact, times, radii)
}

#[library_benchmark(setup = at_times, teardown = assert_solved)]
#[bench::constant_load(contact(Patellofemoral))]
fn radii_at_times<P: GapProfile<f64>, L: Load<f64>>(
    (contact, times, mut radii): Given<Contact<f64, P, L>, f64>,
) -> Given<Contact<f64, P, L>, f64> {
    // `assert_solved` checks the result.
    let _ = contact.radii(&times, &mut radii);
    (contact, times, radii)
}

#[library_benchmark(setup = at_times, teardown = assert_solved)]
#[bench::constant_load(contact(Patellofemoral))]
fn radius_at_a_time<P: GapProfile<f64>, L: Load<f64>>(
    given: Given<Contact<f64, P, L>, f64>,
) -> Given<Contact<f64, P, L>, f64> {
    each(given, |contact, time| contact.at(time).map_or(0.0, |now| now.radius()))
}

#[library_benchmark(setup = radii)]
#[bench::two_terms(Patellofemoral)]
fn approach<P: GapProfile<f64>>(given: Given<P, f64>) -> Given<P, f64> {
    each(given, |profile, a| profile.approach(a))
}

#[library_benchmark(setup = radii)]
#[bench::two_terms(Patellofemoral)]
fn load_integral<P: GapProfile<f64>>(given: Given<P, f64>) -> Given<P, f64> {
    each(given, |profile, a| profile.load_integral(a))
}

#[library_benchmark(setup = radii)]
#[bench::two_terms(Patellofemoral)]
fn pressure_kernel<P: GapProfile<f64>>(given: Given<P, f64>) -> Given<P, f64> {
    each(given, |profile, a| profile.pressure_kernel(a, 3.0))
}

fn assert_positive(pressure: f64) {
    assert!(pressure > 0.0, "{NO_RESULT}");
}

#[library_benchmark(teardown = assert_positive)]
#[bench::constant_load(contact(Patellofemoral))]
#[bench::fractional_powers(contact(Blunt))]
#[bench::decimal_powers(contact(Fitted))]
#[bench::sparse_powers(contact(Steep))]
#[bench::long_expansion(contact(Sphere))]
#[bench::a_field(contact(Ball { radius: 20.0 }))]
#[bench::polynomial(contact(run_time()))]
#[bench::hundred_knots(scenes::hundred_knots(RATE))]
#[bench::fifty_steps(scenes::fifty_steps(RATE))]
#[bench::curved_load(scenes::loaded(Patellofemoral, RATE, Settling))]
fn cold_pressure<P: GapProfile<f64>, L: Load<f64>>(contact: Contact<f64, P, L>) -> f64 {
    contact.at(black_box(200.0)).map_or(0.0, |now| now.pressure(black_box(3.0)))
}

#[library_benchmark(teardown = assert_positive)]
#[bench::constant_load(contact(Patellofemoral))]
#[bench::decimal_powers(contact(Fitted))]
#[bench::long_expansion(contact(Sphere))]
#[bench::three_terms_with_a_field(contact(RoundBall { radius: 20.0 }))]
fn peak_pressure<P: GapProfile<f64>, L: Load<f64>>(contact: Contact<f64, P, L>) -> f64 {
    contact.at(black_box(200.0)).map_or(0.0, |now| now.peak_pressure())
}

struct Field<L> {
    contact: Contact<f64, Patellofemoral, L>,
    times: Vec<f64>,
    radii: Vec<f64>,
    values: Vec<f64>,
}

/// A field of 100 times up to the last and 100 radii in some order, some of them outside the contact.
fn empty<L>(contact: Contact<f64, Patellofemoral, L>, last: f64, put_in_order: fn(&mut [f64])) -> Field<L> {
    let (times, mut radii) = (steps(100, last), steps(100, 9.0));
    put_in_order(&mut radii);
    Field { contact, times, radii, values: vec![0.0; 10_000] }
}

fn ascending(_: &mut [f64]) {}

fn shuffled(radii: &mut [f64]) {
    let count = radii.len();
    (0..count).for_each(|k| radii.swap(k, 37 * k % count));
}

/// Asserts that there is a pressure at all times, as there is on the axis.
fn assert_filled<L>(field: Field<L>) {
    let mut rows = field.values.chunks(field.radii.len());
    assert!(rows.all(|row| row.iter().any(|&pressure| pressure > 0.0)), "{NO_RESULT}");
}

#[library_benchmark(setup = empty, teardown = assert_filled)]
#[bench::constant_load(contact(Patellofemoral), 400.0, ascending)]
#[bench::hundred_knots(scenes::hundred_knots(RATE), 400.0, ascending)]
#[bench::distant_times(contact(Patellofemoral), 4000.0, ascending)]
#[bench::descending_radii(contact(Patellofemoral), 400.0, <[f64]>::reverse)]
#[bench::shuffled_radii(contact(Patellofemoral), 400.0, shuffled)]
fn field<L: Load<f64>>(mut field: Field<L>) -> Field<L> {
    // `assert_filled` checks the result.
    let _ = field.contact.pressure_field(&field.times, &field.radii, &mut field.values);
    field
}

library_benchmark_group!(
    name = profile,
    benchmarks = [
        radius,
        radius_f32,
        radius_by_hand,
        radii_of_a_slice,
        radii_at_times,
        radius_at_a_time,
        approach,
        load_integral,
        pressure_kernel
    ]
);
library_benchmark_group!(name = pressure, benchmarks = [cold_pressure, peak_pressure, field]);
main!(library_benchmark_groups = [profile, pressure]);
