//! A short stress campaign; `cargo run --release -p tests --bin stress -- --cases 1000000` is the long one.

use tests::random::Stream;
use tests::stress::campaign::Campaign;
use tests::stress::soundness;

/// A multiple of the cycles of regions and formats.
const CASES: u64 = 2080;

#[test]
fn errors_are_within_their_bounds_everywhere() {
    let campaign = Campaign { seed: 1 };
    let mut report = campaign.report();
    (0..CASES).for_each(|case| campaign.run(case, &mut report));
    assert!(report.holds(), "{report}");
}

#[test]
fn any_input_is_sound() {
    for case in 0..2000 {
        let mut stream = Stream::of_case(2, case);
        let scene = soundness::scene(&mut || stream.bits());
        let found = soundness::check(&scene);
        assert!(found.is_ok(), "case {case}: {}", found.err().unwrap_or_default());
    }
}

#[test]
fn a_case_can_be_drawn_again() {
    let campaign = Campaign { seed: 5 };
    let [mut all, mut one, mut others] = [campaign.report(), campaign.report(), campaign.report()];
    (0..52).for_each(|case| campaign.run(case, &mut all));
    (0..51).for_each(|case| campaign.run(case, &mut others));
    campaign.run(51, &mut one);
    one.merge(others);
    assert_eq!(one.to_string(), all.to_string());
}
