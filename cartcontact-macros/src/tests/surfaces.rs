//! Surfaces in a gap: their expansion, its order, and the bound of what it neglects.

use num_traits::Zero;
use proc_macro2::Span;

use super::{exact, on_ball, on_unit, shown};
use crate::gap::coefficient::Coefficient;
use crate::gap::surface::Surface;
use crate::number::{Rational, integer};

fn order(text: &str) -> u32 {
    on_unit(text).unwrap().truncation.unwrap().order
}

fn bound(text: &str) -> Rational {
    on_unit(text).unwrap().truncation.unwrap().error.unwrap()
}

/// The part of the sag of `conic(radius, k)` at `r` between two powers of r, as a sum of its series.
fn partial_sum(radius: &str, k: &str, r: &Rational, powers: core::ops::RangeInclusive<u32>) -> Rational {
    let [radius, k] = [radius, k].map(|text| Coefficient::constant(exact(text)));
    let terms = Surface::new(radius, Some(k), Span::call_site().into()).series(powers.end() / 2).unwrap();
    let terms = (1_u32..).zip(&terms).filter(|(j, _)| powers.contains(&(2 * j)));
    let terms = terms.map(|(j, c)| c.as_constant().unwrap() * r.pow(2 * j as i32));
    terms.fold(integer(0), |sum, term| sum + term)
}

#[test]
fn surfaces_are_expanded_exactly() {
    for (text, meaning) in [
        ("sphere(10) - sphere(20), order = 4", "0.025 r^2 + 1.09375e-4 r^4"),
        ("conic(10, 0) + conic(-20, 0), order = 4", "0.025 r^2 + 1.09375e-4 r^4"),
        ("conic(2, -1), order = 128", "0.25 r^2"),
        ("upper = sphere(10), lower = -sphere(20), order = 4", "0.025 r^2 + 1.09375e-4 r^4"),
        ("2*sphere(10) - sphere(20)*2 - 0.05*r^2, order = 4", "2.1875e-4 r^4"),
        ("sphere(2)/4 + r^3, order = 2", "0.0625 r^2 + 1 r^3"),
        ("sphere(1 + 1) + 0*sphere(3)^1, order = 6", "0.25 r^2 + 0.015625 r^4 + 0.001953125 r^6"),
    ] {
        assert_eq!(on_unit(text).as_ref().map(shown), Ok(meaning.to_owned()), "{text}");
    }
    let ball = on_ball("sphere(radius) - conic(2 * radius, radius - 1), order = 4").unwrap();
    assert_eq!(shown(&ball), "1/(4·radius) r^2 + 1/(8·radius^3) - 1/(64·radius^2) r^4");
}

#[test]
fn the_bound_holds_and_is_sharp() {
    for (radius, k, range, order) in [
        ("20", "0", "10", 4),
        ("20", "0", "18", 6),
        ("7.3", "2", "3.5", 8),
        ("20", "-0.75", "19", 2),
        ("5", "0", "4.5", 64),
        // The terms of a hyperboloid alternate.
        ("5", "-2", "4.5", 8),
        ("5", "-2", "4.5", 30),
        ("10", "-5.5", "4", 126),
    ] {
        let bound = bound(&format!("conic({radius}, {k}), order = {order}, max_radius = {range}"));
        let range = exact(range);
        let total = partial_sum(radius, k, &range, 2..=300);
        let ratio = partial_sum(radius, k, &range, order + 2..=300).abs() / total;
        assert!(
            bound >= ratio && bound <= &ratio * exact("1.1"),
            "{radius} {k} {range} {order}: {bound} {ratio}"
        );
    }
}

/// A sphere of radius n² + 1 falls by (n − 1)² at r = n² − 1, where the ratio is largest; the larger n, the nearer that
/// is to the rim.
#[test]
fn the_bound_holds_and_is_sharp_near_the_rim() {
    for n in [3, 10, 30, 100] {
        for order in [2, 4, 8, 32, 64, 128] {
            let [radius, range, fall] =
                [n * n + 1, n * n - 1, (n - 1) * (n - 1)].map(|length| format!("{length}e-3"));
            let bound = bound(&format!("sphere({radius}), order = {order}, max_radius = {range}"));
            let total = exact(&fall);
            let ratio = (&total - partial_sum(&radius, "0", &exact(&range), 2..=order)) / total;
            assert!(bound >= ratio && bound <= &ratio * exact("1.02"), "{n} {order}: {bound} {ratio}");
        }
    }
}

/// A hyperboloid of radius R and k = −2 falls by √(R² + r²) − R.
#[test]
fn the_bound_holds_and_is_sharp_near_the_rim_of_a_hyperboloid() {
    for (radius, range, fall) in [("4", "3", "1"), ("120", "119", "49")] {
        for order in [2, 4, 8, 32, 64, 128] {
            let bound = bound(&format!("conic({radius}, -2), order = {order}, max_radius = {range}"));
            let total = exact(fall);
            let ratio = (&total - partial_sum(radius, "-2", &exact(range), 2..=order)).abs() / total;
            assert!(bound >= ratio && bound <= &ratio * exact("1.03"), "{range} {order}: {bound} {ratio}");
        }
    }
}

/// The largest ratio lies inside the range, and the terms of the hyperboloid alternate.
#[test]
fn the_bound_covers_the_whole_range() {
    let bound = bound("conic(5, -2) - 0.06*r^2 + 2e-5*r^6, order = 4, max_radius = 4.5");
    for step in [1, 20, 45, 60, 70, 75, 80, 85, 90] {
        let r = integer(step) / integer(20);
        let gap = partial_sum("5", "-2", &r, 2..=300) - exact("0.06") * r.pow(2) + exact("2e-5") * r.pow(6);
        let error = partial_sum("5", "-2", &r, 6..=300);
        assert!(gap.is_positive() && error.abs() <= &bound * gap, "{r}");
    }
    assert!(self::bound("conic(7, -1), order = 2, max_radius = 100").is_zero());
}

/// The rest opens with a higher power, to which the bound is relative.
#[test]
fn surfaces_may_lose_their_lowest_powers() {
    for gap in [
        "sphere(10) - r^2/20, order = 30, max_radius = 3",
        "sphere(10) - r^2/20, order = auto, tolerance = 1e-2, max_radius = 1",
        "sphere(3) - r^2/6, order = 12, max_radius = 0.5",
        "upper = sphere(7), lower = -r^2/14, order = 30, max_radius = 3",
        "conic(10, -0.5) - 0.05*r^2, order = 30, max_radius = 3",
        "sphere(10) - r^2/20 - r^4/8000, order = 30, max_radius = 3",
    ] {
        assert!(bound(gap) < exact("1e-2"), "{gap}");
    }
}

#[test]
fn a_bound_below_the_format_is_one_in_it() {
    let least = Rational::from_float(2.0 * f64::MIN_POSITIVE).unwrap();
    for gap in [
        "upper = sphere(10), lower = sphere(-20), order = 128, max_radius = 0.001",
        "sphere(1e80), order = 4, max_radius = 1",
        "sphere(1e200), order = auto, tolerance = 1e-6, max_radius = 1",
    ] {
        let bound = bound(gap);
        assert!(bound.is_positive() && bound < least, "{gap}: {bound}");
    }
}

#[test]
fn the_smallest_order_is_found() {
    for gap in ["sphere(10) - sphere(20), max_radius = 8", "conic(10, -3) - sphere(20), max_radius = 5"] {
        for tolerance in ["0.1", "1e-3", "1e-6", "1e-12"] {
            let gap = format!("{gap}, tolerance = {tolerance}");
            let found = order(&format!("{gap}, order = auto"));
            assert!(bound(&format!("{gap}, order = auto")) <= exact(tolerance) * exact("1.02"));
            assert_eq!(order(&format!("{gap}, order = {}", found + 2)), found + 2);
            if found > 2 {
                let messages = on_unit(&format!("{gap}, order = {}", found - 2)).err().unwrap();
                let remedy = format!("write `order = {found}`");
                assert!(messages.iter().all(|message| message.ends_with(&remedy)));
            }
        }
    }
}

/// If the terms have different signs, an order may be within a tolerance and the next one not.
#[test]
fn no_order_below_the_smallest_is_within() {
    for (gap, smallest) in [
        ("sphere(15) - conic(30, 4), tolerance = 1e-5, max_radius = 6", 6),
        ("conic(15, -0.6) - conic(30, 1), tolerance = 1e-6, max_radius = 7", 6),
        ("sphere(15) + conic(20, -3), tolerance = 1e-5, max_radius = 5", 6),
        ("sphere(10) + conic(12, -3), tolerance = 1e-3, max_radius = 4", 2),
    ] {
        assert_eq!(order(&format!("{gap}, order = auto")), smallest, "{gap}");
        for lower in (2..smallest).step_by(2) {
            let messages = on_unit(&format!("{gap}, order = {lower}")).err().unwrap();
            assert!(messages[0].ends_with(&format!("write `order = {smallest}`")), "{gap}: {messages:?}");
        }
    }
}

/// Fractional exponents multiply the degree of the polynomial in the proof.
#[test]
fn fractional_powers_may_stand_beside_surfaces() {
    let gap = "sphere(10) + 0.01*r^2.3, order = auto, tolerance = 1e-3, max_radius = 5";
    assert!(bound(gap) <= exact("1e-3"));
    assert!(bound("sphere(10) + 0.01*r^2.35, order = 4, max_radius = 5") < exact("0.05"));
    for (exponent, order, is_bounded) in [
        ("2.5", 128, true),
        ("2.3", 86, true),
        ("2.3", 88, false),
        ("2.35", 34, true),
        ("2.35", 36, false),
        ("2.37", 4, false),
        ("2.351", 4, false),
    ] {
        let gap = format!("sphere(10) + 0.01*r^{exponent}, order = {order}, max_radius = 5");
        assert_eq!(on_unit(&gap).unwrap().truncation.unwrap().error.is_some(), is_bounded, "{gap}");
    }
    let messages = on_unit("sphere(10) + 0.01*r^2.351, order = 4, tolerance = 0.1, max_radius = 5");
    let messages = messages.err().unwrap();
    assert!(messages.len() == 1 && messages[0].contains("beside these exponents"), "{messages:?}");
}
