//! The radius of a single term comes from a table of roots, or of seeds, whatever its power is.

use super::on_ball;
use crate::closed_forms::ClosedForms;
use crate::start::Start;
use crate::start::roots::Reach;
use crate::start::table::ROWS_PER_OCTAVE;

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

/// Sixteenths of octaves where a period of k octaves, p = k/q, has 16 at the most, and quarters otherwise.
#[test]
fn periods_have_all_their_rows_in_the_table() {
    for (power, rows) in
        [("1/5", 84), ("0.25", 68), ("1/2", 144), ("0.8", 96), ("12", 256), ("13", 68), ("60", 256)]
    {
        let Some(Start::Roots(roots)) = start(&format!("radius * r^({power})")) else {
            unreachable!("{power}")
        };
        assert!(matches!(roots.reach, Reach::Periods { .. }), "{power}");
        assert_eq!(roots.table.rows.len(), rows, "{power}");
    }
}

/// Up to 2¹⁰⁰, beyond which sums of load integrals would leave single precision; the table goes on.
#[test]
fn single_precision_has_no_rows_near_its_end() {
    let Some(Start::Roots(roots)) = start("1e-10 * r^2.5") else { unreachable!("there is no table") };
    let (first, count) = roots.table.single;
    assert_eq!(first + count as i32, 100 * ROWS_PER_OCTAVE);
    assert!(roots.table.first + roots.table.rows.len() as i32 > 110 * ROWS_PER_OCTAVE);
}
