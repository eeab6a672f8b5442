//! Geometries whose range is known because the roots of δ₀′ were chosen.

use std::time::{Duration, Instant};

use num_traits::Zero;
use proc_macro2::Span;

use super::exact;
use super::random::{Random, SEED};
use crate::gap::coefficient::Coefficient;
use crate::gap::{Gap, Term};
use crate::number::{Rational, integer};
use crate::proof::{Proof, Wanted, prove};

/// The coefficients of a factor of δ₀′, in ascending order.
type Factor = Vec<Rational>;

/// Zero at `at`, positive below.
fn root(at: &str) -> Factor {
    vec![exact(at), -integer(1)]
}

/// (x - real)^2 + imaginary^2: no real root, but almost one.
fn pair(real: &str, imaginary: &str) -> Factor {
    let (real, imaginary) = (exact(real), exact(imaginary));
    vec![&real * &real + &imaginary * &imaginary, &real * -integer(2), integer(1)]
}

fn product(factors: &[Factor]) -> Factor {
    factors.iter().fold(vec![integer(1)], |product, factor| {
        let mut next = vec![Rational::zero(); product.len() + factor.len() - 1];
        for (i, a) in product.iter().enumerate() {
            for (j, b) in factor.iter().enumerate() {
                next[i + j] += a * b;
            }
        }
        next
    })
}

/// A gap from exponents and coefficients.
fn gap(terms: impl IntoIterator<Item = (Rational, Rational)>) -> Gap {
    let present = terms.into_iter().filter(|(_, coefficient)| !coefficient.is_zero());
    let terms = present.map(|(exponent, coefficient)| {
        let extent = Span::call_site().into();
        Term { exponent, coefficient: Coefficient::constant(coefficient), extent }
    });
    Gap { terms: terms.collect() }
}

fn written(terms: &[(&str, &str)]) -> Gap {
    gap(terms.iter().map(|(exponent, coefficient)| (exact(exponent), exact(coefficient))))
}

/// The gap with δ₀′(a) = 2 a q(a^step).
fn with_slope(q: &[Rational], step: &str) -> Gap {
    gap(q.iter().enumerate().map(|(power, value)| {
        let exponent = integer(2) + exact(step) * integer(power);
        let coefficient = value * (&exponent + integer(2)) / &exponent;
        (exponent, coefficient)
    }))
}

fn planted(factors: &[Factor]) -> Gap {
    with_slope(&product(factors), "1")
}

fn holds_up_to(gap: &Gap, radius: &Rational) -> bool {
    let proof = prove(gap, &Wanted::UpTo(radius, Span::call_site().into()));
    matches!(proof, Ok(Proof::OnRange | Proof::AllRadii { .. }))
}

fn up_to(gap: &Gap, radius: &str) -> bool {
    holds_up_to(gap, &exact(radius))
}

fn everywhere(gap: &Gap) -> bool {
    matches!(prove(gap, &Wanted::AllRadii), Ok(Proof::AllRadii { .. }))
}

fn message(gap: &Gap) -> String {
    prove(gap, &Wanted::AllRadii).err().unwrap().message(&[], |_| true)
}

#[test]
fn known_geometries() {
    assert!(everywhere(&written(&[("2", "0.025"), ("4", "1.09375e-4")])));
    assert!(everywhere(&written(&[("2", "0.05"), ("3", "-0.004"), ("4", "2e-4")])));
    let oblate = written(&[("2", "0.025"), ("4", "-1e-4")]);
    assert!(up_to(&oblate, "8.0") && up_to(&oblate, "13.69306") && !up_to(&oblate, "13.69307"));
    assert_eq!(
        message(&oblate),
        "the gap no longer exceeds its mean over the contact disc from r = 13.6931 on: beyond it the contact radius \
         is not determined; add `max_radius = 13.69306`"
    );
    assert!(message(&written(&[("2", "-1"), ("4", "1")])).contains("falls from the centre"));
}

#[test]
fn sparse_and_fractional_exponents_stay_small() {
    assert!(message(&written(&[("2", "1"), ("64", "-1e-30")])).contains("max_radius = 3.0"));
    let square = with_slope(&root("3"), "0.5");
    assert!(up_to(&square, "8.9999999999") && !up_to(&square, "9"));
    assert!(
        message(&square).contains("from r = 9 on") && message(&square).ends_with("`max_radius = 8.999999`")
    );
    // The range ends at 2, where x = a^0.5 is irrational.
    let irrational =
        with_slope(&product(&[vec![exact("2"), exact("0"), exact("-1")], pair("-1", "0")]), "0.5");
    assert!(!up_to(&irrational, "2") && up_to(&irrational, "1.9999999999"));
}

#[test]
fn a_touching_root_ends_the_range() {
    for multiplicity in 1..6 {
        let touching = planted(&vec![root("2.5"); multiplicity]);
        assert!(up_to(&touching, "2.4999999999999996") && !up_to(&touching, "2.5"));
        assert!(message(&touching).contains("from r = 2.5 on"));
        assert!(message(&touching).ends_with("`max_radius = 2.499999`"));
    }
    assert!(everywhere(&planted(&[pair("2.5", "1e-30")])));
}

/// δ₀′ = 2 a (1 - a/2 + 1e-600 a^64): the range ends about 4e-581 beyond 2, or as much before it.
#[test]
fn a_root_next_to_the_end_of_the_range_is_told_apart() {
    for (sign, holds) in [(1, true), (-1, false)] {
        let mut q = vec![Rational::zero(); 65];
        q[..2].clone_from_slice(&[exact("1"), exact("-0.5")]);
        q[64] = integer(10).pow(-600) * integer(sign);
        assert_eq!(up_to(&with_slope(&q, "1"), "2"), holds);
    }
}

#[test]
fn ends_of_all_magnitudes_are_found() {
    for (end, remedy) in [
        ("1e-250", "9.999999e-251"),
        ("123456789", "1.234567e8"),
        ("1e250", "9.999999e249"),
        // The `f64` next to 0.1 lies beyond this end.
        ("0.100000000000000001", "0.0999999"),
    ] {
        let gap = planted(&[root(end), pair("1", "1"), pair("1e-9", "1e-12")]);
        assert!(message(&gap).ends_with(&format!("`max_radius = {remedy}`")), "{}", message(&gap));
        assert!(up_to(&gap, remedy) && !up_to(&gap, end));
    }
    // 2 a - 8/3 b a^3 = 0.
    let falling =
        |first, second| message(&gap([("2", first), ("4", second)].map(|(n, c)| (exact(n), exact(c)))));
    for (first, second, shown, remedy) in [
        ("1e-300", "-1e300", "8.66025e-301", "`max_radius = 8.660254e-301`"),
        ("1e-350", "-1e300", "8.66025e-326", "a smaller unit of length"),
        ("4e-370", "-3e270", "1e-320", "a smaller unit of length"),
        ("1e380", "-1e-350", "8.66025e364", "`max_radius = 1e307`"),
    ] {
        let message = falling(first, second);
        assert!(message.contains(&format!("r = {shown} on")) && message.ends_with(remedy), "{message}");
    }
    // a^0.001 = 4001/4.002.
    let slow = message(&written(&[("2", "1"), ("2.001", "-1e-3")]));
    assert!(slow.contains("r = 1e2999 on") && slow.ends_with("`max_radius = 1e307`"), "{slow}");
}

/// δ₀′ = 2 a (1 - (1 - 1e-20) (a/10)^49): the exponent of 10 comes from 49 log10(10) (1/49), which `f64` rounds below 1.
#[test]
fn an_end_above_a_power_of_ten_has_its_exponent() {
    let mut q = vec![Rational::zero(); 50];
    q[0] = integer(1);
    q[49] = exact("-99999999999999999999e-69");
    let message = message(&with_slope(&q, "1"));
    assert!(message.contains("r = 10 on") && message.ends_with("`max_radius = 10`"), "{message}");
}

/// δ₀′ = 2 a (b - x) (x^5 - 2.8^5)/(x - 2.8) with x = a^0.2: of the roots of x^5 = 2.8^5 it has those that are not real.
#[test]
fn a_root_is_not_taken_for_another_of_the_same_power() {
    let others = ["61.4656", "21.952", "7.84", "2.8", "1"].map(exact).to_vec();
    for (b, holds) in [("2.800000000001", true), ("2.8", false), ("2.799999999999", false)] {
        let gap = with_slope(&product(&[root(b), others.clone()]), "0.2");
        assert_eq!(up_to(&gap, "172.10368"), holds, "{b}");
    }
}

#[test]
fn roots_next_to_their_bounds_are_found() {
    let slope = |q: &[i64]| with_slope(&q.iter().map(|&c| integer(c)).collect::<Factor>(), "1");
    for (q, below, above) in [
        (&[1, -1, -3, -7, -15][..], "0.3", "0.33"),
        (&[15, 7, 3, 1, -1], "3", "3.2"),
        (&[127, 31, 7, -1], "10.9", "11"),
    ] {
        assert!(up_to(&slope(q), below) && !up_to(&slope(q), above), "{q:?}");
    }
}

/// δ₀′/(2 a) = 20.0005 - 21 a + a^20 dips below zero from 1.0005 on; at 2 the last term outweighs the others.
#[test]
fn a_dip_before_a_term_that_outweighs_the_others_ends_the_range() {
    let mut q = vec![Rational::zero(); 21];
    q[..2].clone_from_slice(&[exact("20.0005"), exact("-21")]);
    q[20] = integer(1);
    let dip = with_slope(&q, "1");
    assert!(up_to(&dip, "1.0005") && !up_to(&dip, "1.001"));
}

#[test]
fn random_roots_are_found() {
    let mut random = Random(SEED);
    for _ in 0..60 {
        let roots: Vec<usize> = (0..1 + random.below(8)).map(|_| 1 + random.below(30)).collect();
        let real = roots.iter().map(|at| root(&format!("{at}e-1")));
        let pairs = (0..random.below(4))
            .map(|_| pair(&format!("{}e-1", 1 + random.below(30)), &format!("1e-{}", random.below(40))));
        let pairs = pairs.collect::<Vec<_>>();
        let gap = planted(&real.chain(pairs).collect::<Vec<_>>());
        let first = Rational::new((*roots.iter().min().unwrap()).into(), 10.into());
        assert!(!holds_up_to(&gap, &first) && holds_up_to(&gap, &(first * exact("0.999999"))), "{roots:?}");
    }
}

/// δ₀′ = 2 a (2 (10 a - 1)^2 - a^64): two roots 1e-33 apart (Mignotte).
fn nearly_touching() -> Gap {
    let mut q = vec![Rational::zero(); 65];
    q[..3].clone_from_slice(&[exact("2"), exact("-40"), exact("200")]);
    q[64] = exact("-1");
    with_slope(&q, "1")
}

/// δ₀′ = 2 a (2 (1e20 a - 1)^2 + a^64): a minimum of 1e-1280 that is never 0.
fn nearly_touching_from_above() -> Gap {
    let mut q = vec![Rational::zero(); 65];
    q[..3].clone_from_slice(&[exact("2"), exact("-4e20"), exact("2e40")]);
    q[64] = exact("1");
    with_slope(&q, "1")
}

/// δ₀′ = 2 a ((1e20 x - 1)^2 - x^48) with x = a^0.1: a root at 1e-20 (1 - 1e-480), and another one next to it.
fn nearly_touching_at_a_number() -> Gap {
    let mut q = product(&vec![vec![exact("1"), exact("-1e20")]; 2]);
    q.resize(49, Rational::zero());
    q[48] = exact("-1");
    with_slope(&q, "0.1")
}

#[test]
fn a_root_next_to_a_number_is_told_apart() {
    let gap = nearly_touching_at_a_number();
    let below = |power| exact("1e-200") * (integer(1) - integer(10).pow(power));
    assert!(holds_up_to(&gap, &below(-478)) && !holds_up_to(&gap, &below(-480)) && !up_to(&gap, "1e-200"));
}

/// δ₀′ = 2 a ((1 - 1e100 a)^3 - a^64): three roots within 1e-2233.
fn cluster_of_three() -> Gap {
    let mut q = product(&vec![vec![exact("1"), exact("-1e100")]; 3]);
    q.resize(65, Rational::zero());
    q[64] = exact("-1");
    with_slope(&q, "1")
}

/// δ₀′ = 2 a ((1e9 a - 1)^4 + a^64): two pairs of roots 1e-144 apart, all within 1e-140.
fn cluster_of_four() -> Gap {
    let mut q = product(&vec![vec![exact("1"), exact("-1e9")]; 4]);
    q.resize(65, Rational::zero());
    q[64] = exact("1");
    with_slope(&q, "1")
}

/// δ₀′ = 2 a (T_64(2 a - 1) + 1 + 1e-40) with Chebyshev's polynomial: 32 minima just above 0.
fn chebyshev_from_above() -> Gap {
    let (mut last, mut next) = (vec![integer(1)], vec![integer(-1), integer(2)]);
    for _ in 1..64 {
        let mut after = product(&[vec![integer(-2), integer(4)], next.clone()]);
        after.iter_mut().zip(&last).for_each(|(value, own)| *value += -own);
        last = core::mem::replace(&mut next, after);
    }
    next[0] += exact("1") + exact("1e-40");
    with_slope(&next, "1")
}

/// δ₀′ = 2 a (∏ (a − c)² + 1e-1000), with 32 c that are 1e-9 apart: minima of 1e-1000 in a cluster.
fn squares_from_above() -> Gap {
    let twice = (0..64).map(|index| root(&format!("1.0000000{:02}", index / 2)));
    let mut q = product(&twice.collect::<Vec<_>>());
    q[0] += integer(10).pow(-1000);
    with_slope(&q, "1")
}

/// Alternating signs, and magnitudes in no order.
fn of_all_magnitudes() -> Gap {
    gap((0..=64_usize).map(|power| {
        let (first, rest, size) = (1 + power % 9, 1_234_567 * (power + 1), power * 7919 % 601);
        let coefficient = exact(&format!("{first}.{rest}e300")) * integer(10).pow(-(size as i32));
        (integer(power + 2), if power % 2 == 0 { coefficient } else { -coefficient })
    }))
}

/// With one more the proof would be left out, although both ranges end beyond 1.
#[test]
fn exponents_may_differ_by_1024_steps() {
    let gap = |last| written(&[("2", "1"), ("2.5", "1"), (last, "-1e-9")]);
    assert!(up_to(&gap("514"), "1"));
    assert!(!up_to(&gap("514.5"), "1"));
}

#[test]
fn two_exponents_may_have_three_decimals() {
    for (first, last) in [("0.001", "1024"), ("2.001", "66.002"), ("2", "1023.999")] {
        let gap = written(&[(first, "1"), (last, "-1e-9")]);
        assert!(up_to(&gap, "1") && !up_to(&gap, "2"), "{first}, {last}");
    }
}

#[test]
fn degree_64_is_decided_at_once() {
    let repeat = |count: usize, factor: Factor| vec![factor; count];
    let integers = |from: u32| (from..from + 64).map(|at| root(&at.to_string())).collect::<Vec<_>>();
    let twice = (0..64).map(|index| root(&format!("{}.125", 3 + index / 2))).collect::<Vec<_>>();
    let close = [root("1"), root(&format!("1.{}1", "0".repeat(99)))];
    let apart = (0..31).map(|index| pair(&(index - 10).to_string(), "0.5"));
    let pairs =
        (1..9).map(|at| pair(&at.to_string(), "1e-12")).chain((10..34).map(|at| pair("-1", &at.to_string())));
    let cluster =
        (0..8).map(|at| pair(&format!("1.{}{}", "0".repeat(30), 101 + at), &format!("1e-{}", 30 + at)));
    let near = (1..33).map(|at| pair(&format!("{at}e-1"), "1e-9"));
    let apart9 = (0..32).map(|k| pair(&format!("1e{}", 9 * k - 144), &format!("1e{}", 9 * k - 174)));
    let nested = |deepest: &str| {
        let at = |place: u32| [place % 4, place / 4 % 4].map(|digit| format!("00000000{digit}")).join("");
        let pairs = (0..32).map(|place| pair(&format!("1.{}00000000{}", at(place), place / 16), deepest));
        pairs.collect::<Vec<_>>()
    };
    // By bisection, in decimals of 60 digits.
    let of_these = "3.511123195420215876715076562868502487";
    let among = "1.00000000200000000100000000000000005";
    let cases = [
        ("64 roots", planted(&integers(1)), Some("1")),
        ("one root, 64 times", planted(&repeat(64, root("7.25"))), Some("7.25")),
        ("32 roots, twice each", planted(&twice), Some("3.125")),
        ("two roots 1e-100 apart", planted(&close.into_iter().chain(apart).collect::<Vec<_>>()), Some("1")),
        ("8 pairs 1e-12 off the axis", planted(&pairs.collect::<Vec<_>>()), None),
        ("32 pairs 1e-9 off the axis", planted(&near.collect::<Vec<_>>()), None),
        ("8 pairs within 1e-30", planted(&cluster.collect::<Vec<_>>()), None),
        ("clusters on three scales", planted(&nested("1e-40")), None),
        ("a root in clusters", planted(&[nested("1e-20"), vec![root(among)]].concat()), Some(among)),
        ("4 roots within 1e-140", cluster_of_four(), None),
        ("a minimum of 1e-1280", nearly_touching_from_above(), None),
        ("32 minima of 1e-40", chebyshev_from_above(), None),
        ("32 minima of 1e-1000 within 1e-7", squares_from_above(), None),
        ("32 pairs of sizes 1e9 apart", planted(&apart9.collect::<Vec<_>>()), None),
        ("two roots 1e-33 apart", nearly_touching(), Some("0.1")),
        ("two roots 1e-500 apart", nearly_touching_at_a_number(), Some("1e-200")),
        ("3 roots within 1e-2233", cluster_of_three(), Some("1e-100")),
        ("coefficients from 1e-300 to 1e300", of_all_magnitudes(), Some(of_these)),
    ];
    for (name, gap, end) in cases {
        let start = Instant::now();
        let proof = prove(&gap, &Wanted::AllRadii);
        let elapsed = start.elapsed();
        println!("{name}: {elapsed:?}, {:?}", proof.as_ref().map_err(|fault| fault.message(&[], |_| true)));
        assert_eq!(proof.is_ok(), end.is_none(), "{name}");
        if let Some(end) = end {
            assert!(holds_up_to(&gap, &(exact(end) * exact("0.99999999999999999999"))), "{name}");
            assert!(!holds_up_to(&gap, &(exact(end) * exact("1.00000000000000000001"))), "{name}");
        }
        let limit = if cfg!(debug_assertions) { Duration::from_secs(20) } else { Duration::from_millis(500) };
        assert!(elapsed < limit, "{name} took {elapsed:?}");
    }
}
