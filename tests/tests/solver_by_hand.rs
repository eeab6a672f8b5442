//! The solver by hand, with which the benchmarks compare the generated one, is right: a wrong one could be quicker.

#[path = "../../cartcontact/benches/scenes/by_hand.rs"]
mod by_hand;

use cartcontact::GapProfile;
use tests::measure::relative_error;
use tests::profiles::Patellofemoral;
use tests::random::Stream;

/// In ε. Of plain arithmetic the worst seen here is 2.2.
const ALLOWED: f64 = 4.0;

fn assert_right(name: &str, found: f64, expected: f64, argument: f64) {
    let error = relative_error(found, expected, f64::EPSILON);
    assert!(error <= ALLOWED, "{name} at {argument:e} is off by {error:.2} ε");
}

#[test]
fn radii_are_those_of_the_library() {
    let mut stream = Stream::of_case(1, 0);
    // The table of the solver by hand ends at 2e-13 and 4e6.
    let mut load_integrals: Vec<f64> = (0..2000).map(|_| stream.magnitude(-14.0, 8.0)).collect();
    load_integrals.push(0.0);
    let mut of_slice = vec![f64::NAN; load_integrals.len()];
    by_hand::radii(&load_integrals, &mut of_slice);
    for (&load_integral, of_slice) in load_integrals.iter().zip(of_slice) {
        let expected = Patellofemoral.radius(load_integral).unwrap_or(f64::NAN);
        assert_right("radius", by_hand::radius(load_integral), expected, load_integral);
        assert_right("radius of a slice", of_slice, expected, load_integral);
        if load_integral > 0.0 {
            assert_right(
                "radius by Newton's method",
                by_hand::radius_by_newton(load_integral),
                expected,
                load_integral,
            );
        }
    }
}

#[test]
fn functions_of_a_radius_are_those_of_the_library() {
    let mut stream = Stream::of_case(2, 0);
    for _ in 0..1000 {
        let (a, q) = (stream.magnitude(-2.0, 1.5), stream.between(0.0, 1.1));
        let profile = &Patellofemoral as &dyn GapProfile<f64>;
        assert_right("approach", by_hand::approach(a), profile.approach(a), a);
        assert_right("load integral", by_hand::load_integral(a), profile.load_integral(a), a);
        let (found, expected) = (by_hand::pressure_kernel(a, q * a), profile.pressure_kernel(a, q * a));
        assert_right("pressure kernel", found, expected, a);
    }
}
