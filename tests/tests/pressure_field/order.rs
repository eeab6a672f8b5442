//! The pressures of a field do not depend on the order of its radii, to the last bit.

use cartcontact::ContactError;
use cartcontact::load::{Constant, Load};
use tests::loads::{Rise, through};
use tests::profiles::Patellofemoral;

use super::{Joint, joint};

/// More columns than are taken at once, half of them or more outside the contact at the start.
const COUNT: usize = 1500;

fn ascending() -> Vec<f64> {
    (0..COUNT).map(|k| 0.01 * k as f64).collect()
}

/// Radii in the orders that a caller is likely to have, and shuffled.
fn orders() -> [(&'static str, Vec<f64>); 5] {
    let half = || ascending().into_iter().step_by(3);
    let pixel = |k: usize| 40.0_f64.recip() * (k as f64 - 19.5) * 15.0;
    let pixels = (0..1600).map(|k| pixel(k / 40).hypot(pixel(k % 40))).collect();
    [
        ("descending", ascending().into_iter().rev().collect()),
        ("diameter", half().rev().chain(half().skip(1)).collect()),
        ("shuffled", (0..COUNT).map(|k| 0.01 * (k * 617 % COUNT) as f64).collect()),
        ("repeated", (0..COUNT).map(|k| 0.1 * ((k / 3) * 7 % 150) as f64).collect()),
        ("pixels", pixels),
    ]
}

fn field(contact: &Joint<'_, f64, Patellofemoral>, radii: &[f64]) -> Result<Vec<f64>, ContactError> {
    // Some steps are short, some cover many radii, and one is so long that all memory fades.
    let times: Vec<f64> = (0..150).map(|row| f64::from(row * row) * 0.1).chain([1e5, 1e5 + 1.0]).collect();
    let mut values = vec![f64::NAN; times.len() * radii.len()];
    contact.pressure_field(&times, radii, &mut values)?;
    Ok(values)
}

fn check(load: &dyn Load<f64>) -> Result<(), ContactError> {
    let contact = joint(Patellofemoral, 0.0015, load);
    for (name, radii) in orders() {
        let mut sorted = radii.clone();
        sorted.sort_by(f64::total_cmp);
        let expected = field(&contact, &sorted)?;
        let values = field(&contact, &radii)?;
        for (row, expected) in values.chunks(radii.len()).zip(expected.chunks(radii.len())) {
            for (&r, value) in radii.iter().zip(row) {
                let expected = expected[sorted.partition_point(|&other| other < r)];
                assert_eq!(value.to_bits(), expected.to_bits(), "{name}, r = {r}");
            }
        }
    }
    Ok(())
}

#[test]
fn radii_come_in_any_order_under_a_constant_load() -> Result<(), ContactError> {
    check(&Constant(100.0))
}

#[test]
fn radii_come_in_any_order_under_a_load_of_many_knots() -> Result<(), ContactError> {
    let knots: Vec<(f64, f64)> =
        (0..100).map(|k| (f64::from(k) * 20.0, 20.0 + 0.05 * f64::from(k % 7))).collect();
    check(&through(&knots))
}

#[test]
fn radii_come_in_any_order_under_a_load_without_knots() -> Result<(), ContactError> {
    check(&Rise { start: 10.0, rise: 90.0, rate: 0.01 })
}
