//! How far pressures are off under loads with many jumps and kinks of which no knot tells, as the documentation of
//! `Load` has it, against the same loads with their knots.

use cartcontact::ContactError;
use tests::budget;
use tests::condition::edge;
use tests::joint::joint;
use tests::loads::{Unannounced, through};
use tests::measure::relative_error;
use tests::profiles::Patellofemoral;
use tests::random::Stream;

const CHI: f64 = 0.0015;
const END: f64 = 400.0;

/// After 36 e-foldings: all that a pressure remembers.
const LATE_END: f64 = 24_000.0;

/// Random times up to another, in ascending order.
fn times(stream: &mut Stream, count: usize, end: f64) -> Vec<f64> {
    let mut times: Vec<f64> = (0..count).map(|_| stream.between(0.0, end)).collect();
    times.sort_by(f64::total_cmp);
    times
}

/// A load that rises from 50 N by 50 N, in so many jumps of different heights at random times.
fn jumps(stream: &mut Stream, count: usize, end: f64) -> Vec<(f64, f64)> {
    let mut force = 50.0;
    let mut knots = vec![(0.0, force)];
    for t in times(stream, count, end) {
        knots.push((t, force));
        force += stream.between(0.0, 100.0 / count as f64);
        knots.push((t, force));
    }
    knots
}

/// A load between 50 N and 100 N that changes its slope so often; it falls no faster than e^(−χ t).
fn kinks(stream: &mut Stream, count: usize, end: f64) -> Vec<(f64, f64)> {
    let (mut before, mut force) = (0.0, 60.0);
    let mut knots = vec![(0.0, force)];
    for t in times(stream, count, end) {
        let change = stream.between(-0.5, 0.9) * CHI * force * (t - before);
        force = (force + change).clamp(50.0, 100.0);
        knots.push((t, force));
        before = t;
    }
    knots
}

/// The largest relative error of pressures at a time in some loads, at radii up to nine tenths of the contact radius.
fn largest_error(
    (count, end): (usize, f64),
    knots: fn(&mut Stream, usize, f64) -> Vec<(f64, f64)>,
) -> Result<f64, ContactError> {
    let mut largest = 0.0_f64;
    for case in 0..5 {
        let load = through(&knots(&mut Stream::of_case(1, case), count, end));
        let told = joint(Patellofemoral, CHI, &load);
        let untold = joint(Patellofemoral, CHI, Unannounced(&load));
        let (told, untold) = (told.at(end)?, untold.at(end)?);
        for r in [0.0, 3.0, 6.0] {
            largest = largest.max(relative_error(untold.pressure(r), told.pressure(r), 1.0));
        }
    }
    Ok(largest)
}

/// The documented errors, while a load doubles within an e-folding and after all that a pressure remembers; forty jumps
/// cost no digits.
#[test]
fn pressures_are_as_exact_as_documented() -> Result<(), ContactError> {
    let no_digits = 2.0 * budget::PRESSURE.double * edge(1.0, 0.9) * f64::EPSILON;
    for (count, at_end, at_late_end) in
        [(40, no_digits, no_digits), (50, 1e-14, 1e-12), (500, 1e-12, 1e-12), (3000, 1e-12, 1e-12)]
    {
        for (end, documented) in [(END, at_end), (LATE_END, at_late_end)] {
            let error = largest_error((count, end), jumps)?;
            assert!(error <= documented, "{count} jumps up to {end}: {error:e}");
        }
    }
    for (count, at_end, at_late_end) in [(500, 1e-12, 1e-12), (3000, 1e-12, 1e-12), (10_000, 1e-12, 1e-10)] {
        for (end, documented) in [(END, at_end), (LATE_END, at_late_end)] {
            let error = largest_error((count, end), kinks)?;
            assert!(error <= documented, "{count} kinks up to {end}: {error:e}");
        }
    }
    Ok(())
}

/// A load that drops by a share of its force half-way between two of its knots, and the time at which it does.
fn dropping(mut knots: Vec<(f64, f64)>, first: usize, share: f64) -> (Vec<(f64, f64)>, f64) {
    let ((t, force), (next, next_force)) = (knots[first], knots[first + 1]);
    let (middle, mean) = (t + 0.5 * (next - t), 0.5 * (force + next_force));
    let after = knots.split_off(first + 1);
    knots.push((middle, mean));
    knots.push((middle, mean * (1.0 - share)));
    knots.extend(after.iter().map(|&(t, force)| (t, force * (1.0 - share))));
    (knots, middle)
}

#[test]
fn falls_between_a_thousand_knots_are_found() {
    for knots in [jumps, kinks] {
        for end in [END, LATE_END] {
            for case in 0..5 {
                // Pieces, not jumps, begin at knots of even number.
                let first = 400 + 100 * case as usize;
                let (knots, drop) = dropping(knots(&mut Stream::of_case(1, case), 1000, end), first, 1e-3);
                let load = through(&knots);
                let found = joint(Patellofemoral, CHI, Unannounced(&load)).at(end).err();
                let is_near = |since: f64| (since - drop).abs() < 1e-4 * end;
                let is_found = matches!(found, Some(ContactError::Receding { since, .. }) if is_near(since));
                assert!(is_found, "{drop} of {end}, case {case}: {found:?}");
            }
        }
    }
}

/// A load that jumps at random times, and in between falls by a share of what it may: F/(1 + χ Δt) from knot to knot.
fn falls(stream: &mut Stream, count: usize, share: f64) -> Vec<(f64, f64)> {
    let (mut before, mut force) = (0.0, 50.0);
    let mut knots = vec![(0.0, force)];
    for t in times(stream, count, END) {
        force /= 1.0 + share * CHI * (t - before);
        knots.push((t, force));
        force *= stream.between(1.0, 1.3);
        knots.push((t, force));
        before = t;
    }
    knots
}

/// A panel across a jump only knows about when what drains begins to grow.
#[test]
fn falls_as_fast_as_the_pressure_follows_are_not_refused_behind_a_jump() {
    for case in 0..200 {
        for (share, is_covered) in [(0.999_999, true), (1.001, false)] {
            let load = through(&falls(&mut Stream::of_case(2, case), 20, share));
            let untold = joint(Patellofemoral, CHI, Unannounced(&load));
            assert_eq!(untold.at(END).is_ok(), is_covered, "case {case}, {share} of the bound");
        }
    }
}
