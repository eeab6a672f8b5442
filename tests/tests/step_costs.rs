//! How many forces pressures take under loads that are not straight, and how many pieces a record has: of what pressures
//! are, nothing tells if they take more.

use cartcontact::ContactError;
use cartcontact::load::{Load, LoadError, Piece, PiecewiseLinear};
use tests::joint::joint;
use tests::loads::{Announced, CountingForces, Fall, Rise, through};
use tests::profiles::Patellofemoral;

const CHI: f64 = 0.0015;

/// Nearly all of its knots are passed before the edge reaches the radii next to it.
const RECORD: [(f64, f64); 7] =
    [(0.0, 10.0), (1.0, 20.0), (3.0, 20.0), (10.0, 40.0), (50.0, 39.5), (100.0, 50.0), (1000.0, 60.0)];

/// The most forces that any of many pressures takes, from the middle of the contact to the last digits before its edge.
fn most_forces(load: impl Load<f64>) -> Result<usize, ContactError> {
    let contact = joint(Patellofemoral, CHI, CountingForces::new(load));
    let mut most = 0;
    for k in 0..40 {
        let now = contact.at(1.25_f64.powi(k))?;
        for digits in 0..14 {
            contact.load().forces();
            assert!(now.pressure(now.radius() * (1.0 - 0.5 * 10f64.powi(-digits))) > 0.0);
            most = most.max(contact.load().forces());
        }
    }
    Ok(most)
}

/// When the edge passes a radius depends on the load: that is searched for, and steps begin there. If they were halved
/// until they do, most of these pressures would take more forces.
#[test]
fn pressures_next_to_the_edge_take_few_forces() -> Result<(), ContactError> {
    for (name, most) in [
        ("constant", most_forces(Announced::curved(through(&[(0.0, 30.0)])))?),
        ("ramp", most_forces(Announced::curved(through(&[(0.0, 20.0), (1e5, 1e4)])))?),
        ("rise", most_forces(Rise { start: 10.0, rise: 30.0, rate: 0.05 })?),
        ("decay", most_forces(Fall { force: 30.0, rate: 0.9 * CHI })?),
        ("record", most_forces(Announced::curved(through(&RECORD)))?),
    ] {
        println!("{name}: {most}");
        assert!(most < 850, "{name}: {most} forces");
    }
    Ok(())
}

/// A field follows the load once to see that it never falls, and then asks for some forces at each time.
#[test]
fn where_nothing_drains_no_history_is_followed() -> Result<(), ContactError> {
    let rise = Rise { start: 10.0, rise: 30.0, rate: 0.05 };
    let contact = joint(Patellofemoral, 0.0, CountingForces::new(rise));
    let radii: [f64; 100] = core::array::from_fn(|k| 0.062 * k as f64);
    // The contact of the only row has covered some of the radii since it began.
    for rows in [0..50, 50..51] {
        let times: Vec<f64> = rows.map(f64::from).collect();
        contact.load().forces();
        contact.radii(&times, &mut vec![0.0; times.len()])?;
        let searching = contact.load().forces();
        let mut pressures = vec![0.0; times.len() * radii.len()];
        contact.pressure_field(&times, &radii, &mut pressures)?;
        let forces = contact.load().forces();
        println!("{forces} forces, {searching} without pressures");
        assert!(forces < searching + 20 * times.len(), "{forces} forces");
        for (&time, row) in times.iter().zip(pressures.chunks(radii.len())) {
            let now = contact.at(time)?;
            for (&r, &pressure) in radii.iter().zip(row) {
                let error = (pressure - now.pressure(r)).abs();
                assert!(error <= 1e-14 * now.peak_pressure(), "{pressure} at {r}, {time}");
            }
        }
    }
    Ok(())
}

#[test]
fn a_held_force_is_one_piece() -> Result<(), LoadError> {
    let knots = [(0.0, 10.0), (5.0, 20.0), (6.0, 20.0), (7.0, 20.0), (7.0, 30.0), (8.0, 30.0), (9.0, 40.0)];
    let load = PiecewiseLinear::new(knots)?;
    let piece = |start, end| Piece { start, end };
    let expected = [
        piece((0.0, 10.0), (5.0, 20.0)),
        piece((5.0, 20.0), (7.0, 20.0)),
        piece((7.0, 20.0), (7.0, 30.0)),
        piece((7.0, 30.0), (8.0, 30.0)),
        piece((8.0, 30.0), (9.0, 40.0)),
        piece((9.0, 40.0), (9.5, 40.0)),
    ];
    let mut pieces = [piece((0.0, 0.0), (0.0, 0.0)); 8];
    let count = load.straight_pieces((0.0, 9.5), &mut pieces);
    assert_eq!(pieces[..count], expected);
    let count = load.straight_pieces((5.5, 6.5), &mut pieces);
    assert_eq!(pieces[..count], [piece((5.5, 20.0), (6.5, 20.0))]);
    Ok(())
}
