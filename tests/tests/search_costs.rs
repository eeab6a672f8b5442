//! How many forces the search of a history for falls takes: of what it finds, nothing tells if it takes more.

use cartcontact::Scalar;
use cartcontact::load::Load;
use tests::loads::{Announced, CountingForces, Fall, Knots, Rise, Unannounced, through};

const CHI: f64 = 0.02;

/// 50 (1 − cos t/100) in its rising half: at first all is rounding.
struct HalfCosine;

impl<T: Scalar> Load<T> for HalfCosine {
    fn force(&self, t: T) -> T {
        T::constant(50.0) * (T::one() - (t * T::constant(0.01)).cos())
    }

    /// Without cancellation: an impulse that is all rounding would contradict the force.
    fn impulse(&self, t: T) -> T {
        let x = t.value() * 0.01;
        let rest = if x < 0.5 {
            let square = x * x;
            x * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)))
        } else {
            x - x.sin()
        };
        T::constant(5000.0 * rest)
    }
}

/// A load with another unit of time, in which times are `per_unit` times as small.
struct InUnits<L> {
    load: L,
    per_unit: f64,
}

impl<T: Scalar, L: Load<T>> Load<T> for InUnits<L> {
    fn force(&self, t: T) -> T {
        self.load.force(t * T::constant(self.per_unit))
    }

    fn impulse(&self, t: T) -> T {
        self.load.impulse(t * T::constant(self.per_unit)) / T::constant(self.per_unit)
    }

    fn force_before(&self, t: T) -> T {
        self.load.force_before(t * T::constant(self.per_unit))
    }

    fn next_knot(&self, t: T) -> Option<T> {
        let next = self.load.next_knot(t * T::constant(self.per_unit));
        next.map(|knot| knot / T::constant(self.per_unit))
    }
}

/// How many forces the searches up to forty times take, from `first` on, each later by 2/5.
fn forces<T: Scalar>(load: impl Load<T>, first: f64) -> usize {
    let times: Vec<f64> = (0..40).map(|k| first * 1.4_f64.powi(k)).filter(|&t| t < 300.0).collect();
    let count = |per_unit: f64| {
        let load = CountingForces::new(InUnits { load: &load, per_unit });
        for &t in &times {
            let found = load.recession(T::constant(CHI * per_unit), T::constant(t / per_unit));
            assert_eq!(found, None, "{t}");
        }
        load.forces()
    };
    let forces = count(1.0);
    // Powers of two change no digit.
    for unit in [2f64.powi(-10), 2f64.powi(10)] {
        assert_eq!(count(unit), forces, "in units of {unit} s");
    }
    forces
}

/// What loads take, by name.
fn counts<T: Scalar>() -> [usize; 9] {
    let number = T::constant;
    let load = |knots: &[(f64, f64)]| -> Knots<T> {
        through(&knots.iter().map(|&(t, force)| (number(t), number(force))).collect::<Vec<_>>())
    };
    let first = 1e-3;
    // Before, the force is zero.
    let first_rounding = 1e4 * T::default_epsilon().sqrt().value();
    let teeth = |k: u32| (7.0 * f64::from(k), if k.is_multiple_of(2) { 100.0 } else { 110.0 });
    let stair = |k: u32| [k, k + 1].map(|end| (7.3 * f64::from(end), 100.0 + 5.0 * f64::from(k)));
    let curved = |knots: &[(f64, f64)]| forces::<T>(Announced::curved(load(knots)), first);
    let rising = |start| Rise { start: number(start), rise: number(90.0), rate: number(0.1) };
    [
        curved(&[(0.0, 100.0)]),
        curved(&[(0.0, 50.0), (1e5, 1e4)]),
        curved(&[(0.0, 0.0), (1e5, 1e4)]),
        curved(&(0..40).map(teeth).collect::<Vec<_>>()),
        forces::<T>(Fall { force: number(100.0), rate: number(0.9 * CHI) }, first),
        forces::<T>(rising(10.0), first),
        forces::<T>(rising(0.0), first),
        forces::<T>(HalfCosine, first_rounding),
        forces::<T>(Unannounced(load(&(0..30).flat_map(stair).collect::<Vec<_>>())), first),
    ]
}

/// The loads, with the numbers of forces in f64 and f32 when this was written.
const SEEN: [(&str, [usize; 2]); 9] = [
    ("constant", [874, 874]),
    ("ramp", [874, 874]),
    ("ramp from nothing", [874, 874]),
    ("sawtooth with knots", [3492, 3492]),
    ("decay", [1082, 1082]),
    ("rise", [1482, 1482]),
    ("rise from nothing", [1482, 15_630]),
    ("half a cosine", [678_044, 205_687]),
    ("jumps without knots", [114_882, 92_558]),
];

/// Another mathematical library rounds otherwise, hence a fifth more is allowed.
#[test]
fn searches_take_no_more_forces_than_they_did() {
    for (((name, seen), double), single) in SEEN.into_iter().zip(counts::<f64>()).zip(counts::<f32>()) {
        for (found, seen) in [double, single].into_iter().zip(seen) {
            println!("{name}: {found} of {seen}");
            assert!(5 * found <= 6 * seen, "{name}: {found} forces, once {seen}");
        }
    }
}
