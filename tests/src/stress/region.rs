//! The corners from which scenes are drawn.

use super::exact::Profile;
use super::fields;
use super::precision::Precision;
use super::scene::{Form, Scene};
use super::wide::Wide;
use crate::profiles::cases;
use crate::random::Stream;

/// Every so many cases the load has many knots; the number shares no factor with the cycles of regions and formats.
const RECORDS: u64 = 17;

/// A corner of the accepted input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Joints: what most users compute.
    Ordinary,
    /// Solvers generated for constant coefficients.
    Generated,
    /// Solvers generated for coefficients that are fields.
    Fields,
    /// Exponents from 0.25 to 64, whole or not.
    Exponents,
    /// Up to twelve terms whose sizes cross over by 1e30.
    Crossover,
    /// 1 − r/a down to 1e-15, and r = 0.
    Edge,
    /// Loads and moduli over 1e-150 to 1e150, in f32 over 1e-18 to 1e18.
    Magnitudes,
    /// Coefficients and radii whose powers are out of range although gap, load integral and pressure are not.
    Powers,
    /// Subnormal loads, times and rates.
    Subnormal,
    /// χ t from 0 through 1e-12 to 1e6.
    Memory,
    /// Loads with steep and with tiny steps.
    Steps,
    /// Loads that fall nearly as fast as e^(−χ t).
    Fall,
    /// Geometries whose δ₀′ is nearly zero inside the range.
    NearlyAdmissible,
    /// Loads of 4 to 200 knots, like measured ones.
    Record,
}

impl Region {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::Ordinary,
        Self::Generated,
        Self::Fields,
        Self::Exponents,
        Self::Crossover,
        Self::Edge,
        Self::Magnitudes,
        Self::Powers,
        Self::Subnormal,
        Self::Memory,
        Self::Steps,
        Self::Fall,
        Self::NearlyAdmissible,
        Self::Record,
    ];

    /// The region of a case: the last region for every 17th case, the others in turn.
    #[must_use]
    pub fn of_case(case: u64) -> Self {
        let others = Self::ALL.len() as u64 - 1;
        if case % RECORDS == RECORDS / 2 { Self::Record } else { Self::ALL[(case % others) as usize] }
    }

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary",
            Self::Generated => "generated",
            Self::Fields => "fields",
            Self::Exponents => "exponents",
            Self::Crossover => "crossover",
            Self::Edge => "edge",
            Self::Magnitudes => "magnitudes",
            Self::Powers => "powers",
            Self::Subnormal => "subnormal",
            Self::Memory => "memory",
            Self::Steps => "steps",
            Self::Fall => "fall",
            Self::NearlyAdmissible => "nearly admissible",
            Self::Record => "record",
        }
    }

    /// A scene of this region, for a format.
    pub fn draw<T: Precision>(self, stream: &mut Stream) -> Scene<f64> {
        let mut draft = match self {
            Self::Generated => Draft::generated(stream),
            Self::Fields => Draft::of_fields::<T>(stream),
            Self::Exponents => Draft::of_exponents::<T>(stream, |stream| stream.one_of(&ALL_EXPONENTS), 4),
            Self::Crossover => Draft::crossing_over::<T>(stream),
            Self::Powers => Draft::of_high_powers::<T>(stream),
            Self::NearlyAdmissible => Draft::nearly_admissible(stream),
            _ => Draft::ordinary::<T>(stream),
        };
        match self {
            Self::Edge if stream.once_in(10) => draft.inset = 1.0,
            Self::Edge => draft.inset = stream.magnitude(-15.0, 0.0),
            Self::Magnitudes => draft.of_any_size::<T>(stream),
            Self::Subnormal => draft.subnormal::<T>(stream),
            Self::Memory => draft.chi_t = stream.one_of(&[0.0, 1e-12, 1e6, f64::NAN]),
            _ => {}
        }
        if draft.chi_t.is_nan() {
            draft.chi_t = stream.magnitude(-12.0, 6.0);
        }
        draft.scene(self, stream)
    }
}

/// Exponents of every kind: even, odd, halves, quarters, decimals, irrational numbers.
const ALL_EXPONENTS: [f64; 24] = [
    0.25,
    0.3,
    0.5,
    0.75,
    1.0,
    1.5,
    1.9,
    2.0,
    2.25,
    2.5,
    3.0,
    core::f64::consts::PI,
    4.0,
    5.0,
    6.0,
    7.3,
    8.0,
    10.5,
    12.0,
    17.0,
    24.75,
    31.4,
    48.0,
    64.0,
];

/// A scene without the knots of its load.
struct Draft {
    form: Form,
    terms: Vec<(f64, f64)>,
    max_radius: Option<f64>,
    m: f64,
    /// The contact radius at the time, or in one scene of four at the start.
    radius: f64,
    chi: f64,
    chi_t: f64,
    inset: f64,
    /// The force, if it does not follow from the radius.
    force: Option<f64>,
}

impl Draft {
    /// Terms of similar size at the radius `size`, each times ten to a power between −`spread` and `spread`.
    fn new(form: Form, exponents: &[f64], size: f64, spread: f64, stream: &mut Stream) -> Self {
        let gap = size * stream.magnitude(-3.0, 0.0);
        let terms =
            exponents.iter().map(|&n| (gap * stream.magnitude(-spread, spread) * size.powf(-n), n)).collect();
        Self {
            form,
            terms,
            max_radius: None,
            m: stream.magnitude(-2.0, 2.0),
            radius: size * stream.magnitude(-0.5, 0.2),
            chi: stream.magnitude(-6.0, 3.0),
            chi_t: stream.one_of(&[0.0, 0.01, 0.3, 1.0, 10.0, f64::NAN]),
            inset: stream.between(0.0, 1.0),
            force: None,
        }
    }

    fn ordinary<T: Precision>(stream: &mut Stream) -> Self {
        let draw = |stream: &mut Stream| match stream.below(4) {
            0 => 2.0 * (1 + stream.below(6)) as f64,
            1 => (1 + stream.below(12)) as f64,
            2 => (1 + stream.below(40)) as f64 / 4.0,
            _ => stream.between(0.25, 10.0),
        };
        Self::of_exponents::<T>(stream, draw, 4)
    }

    fn of_exponents<T: Precision>(
        stream: &mut Stream,
        draw: impl Fn(&mut Stream) -> f64,
        most: usize,
    ) -> Self {
        let mut exponents: Vec<f64> = (0..=stream.below(most)).map(|_| draw(stream)).collect();
        exponents.sort_by(f64::total_cmp);
        exponents.dedup();
        let highest = exponents.last().copied().unwrap_or(2.0);
        // This keeps coefficients and powers in range.
        let decades = (T::DECADES / (highest + 5.0)).min(2.0);
        let size = stream.magnitude(-decades, decades);
        Self::new(Form::Polynomial, &exponents, size, 1.0, stream)
    }

    fn crossing_over<T: Precision>(stream: &mut Stream) -> Self {
        let mut exponents: Vec<f64> = (0..12).map(|_| stream.below(130) as f64 / 4.0 + 0.25).collect();
        exponents.sort_by(f64::total_cmp);
        exponents.dedup();
        let spread = 15.0 * T::DECADES / 150.0;
        let mut draft = Self::new(Form::Polynomial, &exponents, 1.0, spread, stream);
        draft.radius = stream.magnitude(-0.3, 0.3);
        draft
    }

    fn generated(stream: &mut Stream) -> Self {
        let index = stream.below(11);
        let case = cases()[index];
        // In f32 the load integral of 1e-40 r^64 is out of range at 20.
        let end = case.max_radius.unwrap_or(if case.name == "FlatEnded" { 12.0 } else { 20.0 });
        let mut draft = Self::new(Form::Constant(index), &[2.0], 1.0, 0.0, stream);
        draft.terms = case.terms.to_vec();
        draft.max_radius = case.max_radius;
        draft.radius = end * stream.magnitude(-2.0, -0.1);
        draft.chi_t = draft.chi_t.min(1.0);
        draft
    }

    fn of_fields<T: Precision>(stream: &mut Stream) -> Self {
        let index = stream.below(fields::EXPONENTS.len());
        let exponents = fields::EXPONENTS[index];
        let decades = (T::DECADES / (exponents[2] + 5.0)).min(2.0);
        let size = stream.magnitude(-decades, decades);
        Self::new(Form::Fields(index), &exponents, size, 2.0, stream)
    }

    /// One to three terms at a radius whose power alone is out of range.
    fn of_high_powers<T: Precision>(stream: &mut Stream) -> Self {
        let highest: f64 = stream.one_of(&[3.0, 6.0, 12.0, 17.5, 31.4, 64.0]);
        // C = gap/size^n and J ~ gap size⁴ are in range; a^n need not be.
        let decades = (2.0 * T::DECADES - 8.0) / (highest + 1.0).max(5.0);
        let size = 10_f64.powf(stream.between(0.5, 0.95) * decades * stream.one_of(&[-1.0, 1.0]));
        let exponents: Vec<f64> = [0.25, 2.0, highest].into_iter().skip(stream.below(3)).collect();
        let mut draft = Self::new(Form::Polynomial, &exponents, size, 0.5, stream);
        draft.radius = size * stream.between(0.8, 1.0);
        draft
    }

    /// δ₀′ ∝ a (1 − 2 b a/R + (a/R)²) with b just below 1: it nearly vanishes at a = R.
    fn nearly_admissible(stream: &mut Stream) -> Self {
        let size = stream.magnitude(-1.0, 2.0);
        let b = 1.0 - stream.magnitude(-12.0, -1.0);
        let gap = size * stream.magnitude(-3.0, 0.0);
        let shares = [(1.0, 2.0), (-2.0 * b * 5.0 / 6.0, 3.0), (0.75, 4.0)];
        let mut draft = Self::new(Form::Polynomial, &[2.0], size, 0.0, stream);
        draft.terms = shares.map(|(share, n)| (gap * share * size.powf(-n), n)).to_vec();
        draft.radius = size * stream.one_of(&[0.3, 0.9, 0.999, 1.0, 1.001, 1.1, 3.0]);
        draft
    }

    fn of_any_size<T: Precision>(&mut self, stream: &mut Stream) {
        self.m = stream.magnitude(-T::DECADES, T::DECADES);
        self.force = Some(stream.magnitude(-T::DECADES, T::DECADES));
        self.chi = stream.magnitude(-T::DECADES, T::DECADES);
    }

    fn subnormal<T: Precision>(&mut self, stream: &mut Stream) {
        let tiny = T::LEAST * stream.magnitude(T::EPSILON.log10() + 0.5, 0.0);
        match stream.below(4) {
            0 => self.force = Some(tiny),
            1 => self.m = tiny,
            2 => self.chi = tiny,
            _ => self.chi_t = tiny * self.chi,
        }
    }

    fn scene(self, region: Region, stream: &mut Stream) -> Scene<f64> {
        let terms = self.terms.iter().map(|&(c, n)| (Wide::of(c), n)).collect();
        let load_integral = Profile::new(terms).kernels(Wide::of(self.radius)).load_integral.value;
        let hereditary = load_integral * Wide::of(self.m) * Wide::FRAC_PI_4;
        // In most scenes the radius is the one at the time, in the others the one at the start.
        let grown = if stream.once_in(4) { 1.0 } else { 1.0 + self.chi_t };
        let force = self.force.unwrap_or_else(|| (hereditary / Wide::of(grown)).value());
        let time = if self.chi_t == 0.0 && stream.once_in(2) { 0.0 } else { self.chi_t / self.chi };
        let knots = match region {
            Region::Steps => steps(force, time, stream),
            Region::Fall => falls(force, time, self.chi, stream),
            Region::Record => record(force, time, self.chi, stream),
            Region::Memory | Region::Subnormal | Region::Powers => vec![(0.0, force)],
            _ => usual(force, time, self.chi, stream),
        };
        let chi = if self.chi_t == 0.0 && time != 0.0 { 0.0 } else { self.chi };
        Scene {
            form: self.form,
            terms: self.terms,
            max_radius: self.max_radius,
            m: self.m,
            chi,
            knots,
            time: if time.is_finite() { time } else { 0.0 },
            inset: self.inset,
        }
    }
}

/// A load of one of the usual kinds.
fn usual(force: f64, time: f64, chi: f64, stream: &mut Stream) -> Vec<(f64, f64)> {
    match stream.below(5) {
        0 => vec![(0.0, 0.0), (time * stream.between(0.1, 2.0), force)],
        1 => vec![(0.0, force * stream.between(0.0, 1.0)), (time * stream.between(0.1, 2.0), force)],
        2 => steps(force, time, stream),
        3 => falls(force, time, chi, stream),
        _ => vec![(0.0, force)],
    }
}

fn steps(force: f64, time: f64, stream: &mut Stream) -> Vec<(f64, f64)> {
    let first = force * stream.one_of(&[0.0, 1e-6, 0.5, 1.0]);
    let mut knots = vec![(0.0, first)];
    let mut last = first.max(force * 1e-9);
    let mut now = 0.0;
    for _ in 0..=stream.below(4) {
        now += time * stream.one_of(&[1e-9, 0.01, 0.2, 0.5]);
        // Jumps, and slopes so steep that they are nearly jumps.
        let duration = if stream.once_in(2) { 0.0 } else { time * stream.magnitude(-9.0, -1.0) };
        knots.push((now, last));
        last *= 1.0 + stream.magnitude(-15.0, 3.0);
        now += duration;
        knots.push((now, last));
    }
    knots
}

fn falls(force: f64, time: f64, chi: f64, stream: &mut Stream) -> Vec<(f64, f64)> {
    let mut knots = vec![(0.0, force)];
    let (mut now, mut last) = (0.0, force);
    for _ in 0..=stream.below(3) {
        let duration = time * stream.magnitude(-3.0, 0.3);
        let margin = if stream.once_in(3) { 0.0 } else { stream.magnitude(-14.0, 0.0) };
        last = fallen(last, chi * duration, margin);
        now += duration;
        knots.push((now, last));
        if stream.once_in(3) {
            now += time * stream.magnitude(-3.0, 0.0);
            knots.push((now, last));
        }
    }
    knots
}

/// What is left of a force after a straight fall over some e-foldings: for a margin of zero F′ + χ F is 0 at its end.
fn fallen(force: f64, folds: f64, margin: f64) -> f64 {
    force / (1.0 + folds) * (1.0 + margin * folds)
}

/// A load like a measured one: pieces of similar or very different lengths that rise, hold, jump or fall, some as fast
/// as e^(−χ t).
fn record(force: f64, time: f64, chi: f64, stream: &mut Stream) -> Vec<(f64, f64)> {
    let most = stream.one_of(&[1.0, 1.0, 1.0, 1.3, 1.6, 2.3]);
    let count = stream.magnitude(0.6, most) as usize;
    let spread = stream.one_of(&[0.0, 0.5, 4.0]);
    let mean = time * stream.between(0.8, 1.5) / count as f64;
    let mut knots = vec![(0.0, if stream.once_in(4) { 0.0 } else { force })];
    let (mut now, mut last) = knots[0];
    for _ in 1..count {
        let duration = mean * stream.magnitude(-spread, spread / 4.0);
        let margin = if stream.once_in(4) { 0.0 } else { stream.magnitude(-3.0, 0.0) };
        last = match stream.below(8) {
            0 => last,
            1 => last + force * stream.magnitude(-15.0, 0.0),
            2..=4 => last + force * stream.magnitude(-3.0, -1.0),
            _ => fallen(last, chi * duration, margin),
        };
        now += if stream.once_in(10) && last > knots[knots.len() - 1].1 { 0.0 } else { duration };
        let is_third = knots.len() > 1 && knots[knots.len() - 2].0 == now;
        if !is_third {
            knots.push((now, last));
        }
    }
    knots
}
