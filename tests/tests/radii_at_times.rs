//! Radii and approaches at many times equal those at single times to the last bit, and so do the faults.

use cartcontact::load::{Constant, Load};
use cartcontact::{Contact, ContactError, GapProfile, Scalar};
use tests::joint::joint;
use tests::loads::{CountingSearches, histories};
use tests::profiles::{MixedSign, Oblate, Patellofemoral, RealPowers, SixTerm};

const CHI: f64 = 0.0015;

/// Less than a block, a block and one more time, and several blocks.
const LENGTHS: [usize; 4] = [1, 255, 257, 1000];

fn assert_same<T: Scalar, P: GapProfile<T>, L: Load<T>>(contact: &Contact<T, P, L>, name: &str) {
    for length in LENGTHS {
        let times: Vec<T> = (0..length).map(|k| T::constant((k * 389 % length) as f64 * 3.0)).collect();
        let (mut radii, mut approaches) = (vec![T::zero(); length], vec![T::zero(); length]);
        assert_eq!(contact.radii(&times, &mut radii), Ok(()), "{name}, {length}");
        assert_eq!(contact.approaches(&times, &mut approaches), Ok(()), "{name}, {length}");
        for (&time, found) in times.iter().zip(radii.into_iter().zip(approaches)) {
            let single = contact.at(time).map(|now| (now.radius(), now.approach()));
            assert_eq!(single, Ok(found), "{name}, {length}, time {time}");
        }
    }
}

#[test]
fn many_times_have_the_radii_of_single_ones_under_every_history() {
    for (name, load) in histories(CHI) {
        assert_same(&joint(Patellofemoral, CHI, &load), name);
        assert_same(&joint(SixTerm, CHI, &load), name);
        assert_same(&joint(RealPowers, CHI, &load), name);
        assert_same(&joint(MixedSign, CHI, &load), name);
    }
}

/// Searching a user-defined load takes as long as many radii.
#[test]
fn a_history_is_searched_once_for_all_times() {
    for (name, load) in histories(CHI) {
        let load = CountingSearches::new(load);
        let contact = joint(Patellofemoral, CHI, &load);
        let times: Vec<f64> = (0..6400).map(|k| f64::from(k) * 0.3).collect();
        assert_eq!(contact.radii(&times, &mut vec![0.0; times.len()]), Ok(()), "{name}");
        assert_eq!(load.searches(), 1, "{name}");
    }
}

/// This holds even where the numbers of a block are beyond the usual sizes.
#[test]
fn many_times_have_the_radii_of_single_ones_under_loads_of_every_size() {
    for exponent in (-280..=280).step_by(10) {
        let load = Constant(10f64.powi(exponent));
        assert_same(&joint(Patellofemoral, CHI, load), &format!("{load:?}"));
    }
    for exponent in -30..=30 {
        let load = Constant(10f32.powi(exponent));
        assert_same(&joint(Patellofemoral, CHI, load), &format!("{load:?}"));
    }
}

#[test]
fn no_load_makes_no_contact_at_any_time() {
    fn check<T: Scalar>(name: &str)
    where
        Patellofemoral: GapProfile<T>,
    {
        let contact = joint(Patellofemoral, CHI, Constant(T::zero()));
        assert_same(&contact, name);
        let mut radii = [T::infinity(); 2];
        assert_eq!(contact.radii(&[T::zero(), T::constant(200.0)], &mut radii), Ok(()), "{name}");
        assert_eq!(radii, [T::zero(); 2], "{name}");
    }
    check::<f64>("f64");
    check::<f32>("f32");
}

/// The first fault among many times is the one of that time alone.
fn assert_refused<P: GapProfile<f64>, L: Load<f64>>(contact: &Contact<f64, P, L>, fault: f64) {
    let mut times: Vec<f64> = (0..600).map(f64::from).collect();
    times[300] = fault;
    times[500] = -1.0;
    let expected: Option<ContactError> = contact.at(fault).err();
    assert!(expected.is_some(), "{fault}");
    let of_radii = contact.radii(&times, &mut [0.0; 600]).err();
    let of_approaches = contact.approaches(&times, &mut [0.0; 600]).err();
    // Errors may hold NaN, so they are compared as text.
    for found in [of_radii, of_approaches] {
        assert_eq!(format!("{found:?}"), format!("{expected:?}"));
    }
}

#[test]
fn the_first_time_without_a_radius_is_named() {
    for fault in [f64::NAN, f64::INFINITY, -f64::INFINITY, -1e-300] {
        assert_refused(&joint(Patellofemoral, CHI, Constant(100.0)), fault);
    }
    assert_refused(&joint(Oblate, CHI, Constant(50.0)), 1e6);
}

/// A load with an invalid force or impulse at one time.
struct Faulty {
    force: f64,
    impulse: f64,
    at: f64,
}

impl Load<f64> for Faulty {
    fn force(&self, t: f64) -> f64 {
        if t == self.at { self.force } else { 100.0 }
    }
    fn impulse(&self, t: f64) -> f64 {
        if t == self.at { self.impulse } else { 100.0 * t }
    }
    fn recession(&self, _chi: f64, _t: f64) -> Option<f64> {
        None
    }
}

#[test]
fn loads_that_are_none_are_named() {
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        let at = 300.5;
        assert_refused(&joint(Patellofemoral, CHI, Faulty { force: bad, impulse: 3e4, at }), at);
        assert_refused(&joint(Patellofemoral, CHI, Faulty { force: 100.0, impulse: bad, at }), at);
    }
}
