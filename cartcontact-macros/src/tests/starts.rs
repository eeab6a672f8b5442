//! Which geometries have a table of constants, and which begin at their leading term.

use super::{on_ball, on_unit};
use crate::closed_forms::ClosedForms;
use crate::geometry::Geometry;
use crate::start::roots::Reach;
use crate::start::{Start, seeds};

fn has_leading_term(geometry: &Geometry) -> bool {
    matches!(Start::of(geometry, &ClosedForms::of(&geometry.gap)), Some(Start::LeadingTerm))
}

/// Such a high power has no rows in which a step leads to the radius.
#[test]
fn constants_without_a_table_begin_at_their_leading_term() {
    let constant = on_unit("0.02 * r^2 + 1e-300 * r^400");
    assert!(constant.is_ok_and(|geometry| has_leading_term(&geometry)));
    let oblate = on_unit("0.02 * r^2 - 1e-300 * r^400, max_radius = 3");
    assert!(oblate.is_ok_and(|geometry| !has_leading_term(&geometry)));
    let of_fields = on_ball("radius * r^2 + 2 * r^3 + r^4");
    assert!(of_fields.is_ok_and(|geometry| has_leading_term(&geometry)));
}

/// In units of the last coefficient J would leave the format, or, in the first, if its highest power were formed.
#[test]
fn expansions_of_high_order_have_whole_tables() {
    for text in ["sphere(10), order = 40", "sphere(20), order = 64", "sphere(0.02), order = 48"] {
        let geometry = on_unit(&format!("{text}, max_radius = 0.01")).unwrap();
        let seeds = seeds::seeds(&geometry, &ClosedForms::of(&geometry.gap).stepped);
        assert_eq!(seeds.map(|seeds| seeds.table.rows.len()), Some(256), "{text}");
    }
}

/// A gap as wide as its radius is at 1e300, where J is infinite.
#[test]
fn there_is_no_window_beyond_the_format() {
    let sum = on_unit("1e-300 * r^2 + 1e-300 * r^3");
    assert!(sum.is_ok_and(|geometry| has_leading_term(&geometry)));
    let single =
        on_unit("1e-300 * r^2.5").map(|geometry| Start::of(&geometry, &ClosedForms::of(&geometry.gap)));
    assert!(matches!(single, Ok(Some(Start::Roots(roots))) if !matches!(roots.reach, Reach::Window)));
}
