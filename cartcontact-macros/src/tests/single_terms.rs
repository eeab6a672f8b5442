//! The radius of a single term comes from a table of roots, or of seeds, whatever its power is.

use super::on_ball;
use crate::closed_forms::ClosedForms;
use crate::start::Start;
use crate::start::roots::Reach;

fn start(text: &str) -> Option<Start> {
    let geometry = on_ball(text).unwrap_or_else(|messages| unreachable!("{text}: {messages:?}"));
    Start::of(&geometry, &ClosedForms::of(&geometry.gap))
}

#[test]
fn every_power_has_a_table() {
    for power in
        ["0.37", "1.1", "1.37", "1.55", "1.74", "2.37", "3.14159", "12.3", "2.3333333333333", "300.7"]
    {
        for c in ["0.03", "radius"] {
            let text = format!("{c} * r^{power}");
            assert!(matches!(start(&text), Some(Start::Roots(_))), "{text}");
        }
    }
}

#[test]
fn powers_without_short_periods_take_spans_where_there_is_no_window() {
    for text in ["radius * r^2.37", "0.03 * r^1.74", "0.03 * r^12.3"] {
        let Some(Start::Roots(roots)) = start(text) else { unreachable!("{text} has no table") };
        assert!(matches!(roots.reach, Reach::Spans(_)), "{text}");
    }
    for text in ["0.03 * r^2.37", "0.03 * r^3.14159"] {
        let Some(Start::Roots(roots)) = start(text) else { unreachable!("{text} has no table") };
        assert!(matches!(roots.reach, Reach::Window), "{text}");
    }
}
