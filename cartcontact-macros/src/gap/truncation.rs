//! What a series cut off at r^N neglects, bounded relative to the gap.
//!
//! Let Φ be the gap with its surfaces exact, and E what is cut off. Surface by surface, the terms c_j r^(2j) of a
//! series ([`crate::gap::surface`]) shrink at least by
//!
//! ```text
//! |c_(j+1)| r² / |c_j| = |κ| r²/R² (2j−1)/(2j+2) < q,    q = |κ| ρ²/R² < 1,    r ≤ ρ
//! ```
//!
//! on the range up to ρ, so all behind r^(2J) add up to at most M r^(2J+2) with M = Σ |w c_(J+1)| / (1 − q), summed
//! over the surfaces with their weights w; to |w c_(J+1)| alone where κ < 0, as the terms of a hyperboloid alternate.
//! The terms before that are added up with their signs, e_j = Σ w c_j:
//!
//! ```text
//! ±E(r) ≤ B±(r) = ±Σ e_j r^(2j) + M r^(2J+2),    N < 2j ≤ 2J
//!  Φ(r) ≥ D(r)  = the gap with its series up to r^(2J), − M r^(2J+2)
//! ```
//!
//! |E| ≤ ε Φ on (0, ρ] if neither ε D − B₊ nor ε D − B₋, sums of powers with rational coefficients, has a zero there,
//! which is decided exactly; only to keep them short, the coefficients of B are rounded up and those of D down. Where
//! the e_j have one sign, as those of two spheres have, one of the two suffices.

use core::cmp::Ordering;

use num_traits::{One, ToPrimitive, Zero};

use crate::first_zero::{End, first_zero};
use crate::gap::coefficient::Coefficient;
use crate::gap::like_terms::LikeTerms;
use crate::gap::rim::rim;
use crate::gap::shape::Shape;
use crate::gap::surface::Surface;
use crate::number::{Rational, floor, integer};

/// The highest order: more terms than a smooth joint needs, and few enough to evaluate.
pub(crate) const HIGHEST_ORDER: u32 = 128;
/// J − N/2: with it, M is small next to the first term that is cut off unless the range ends near the rim.
const TERMS_AHEAD: u32 = 24;
/// Of the coefficients in B and D, binary: the surfaces of a joint share far fewer.
const DIGITS: u64 = 256;
/// How many radii a bound is estimated at before it is proved.
const SAMPLES: u32 = 16;

/// The terms of a series that an order asks for.
fn count(order: u32) -> usize {
    (order / 2 + TERMS_AHEAD + 1) as usize
}

type Powers = LikeTerms<Rational, Rational>;

/// A gap with constant surfaces on a range that ends inside all of them.
pub(crate) struct Neglected {
    powers: Powers,
    surfaces: Vec<Series>,
    /// For j = 1, 2, ..., as many as the highest order asks for.
    sums: Vec<Bounds>,
    highest_order: u32,
    /// ρ
    radius: Rational,
}

/// Few digits on either side of e_j.
struct Bounds {
    below: Rational,
    above: Rational,
    /// What e_j adds to a power that the gap has itself: that sum is rounded down, so that what cancels leaves nothing.
    in_gap: Rational,
}

/// A weighted surface: w c_j for j = 1, 2, ..., and a bound of what they add up to from one on, in units of that.
struct Series {
    terms: Vec<Rational>,
    rest: Rational,
}

/// The range reaches the rim of a surface, given here.
pub(crate) struct BeyondRim(pub(crate) End);

impl Neglected {
    /// What orders up to the highest neglect; nothing if a coefficient is no number.
    pub(crate) fn new(
        shape: &Shape,
        radius: &Rational,
        highest_order: u32,
    ) -> Option<Result<Self, BeyondRim>> {
        let mut powers = Powers::default();
        for (exponent, monomial) in shape.powers.terms() {
            powers.add(exponent.clone(), monomial.coefficient.as_constant()?);
        }
        let mut surfaces = Vec::new();
        for surface in &shape.surfaces {
            match Series::new(surface, radius, highest_order)? {
                Ok(series) => surfaces.push(series),
                Err(beyond) => return Some(Err(beyond)),
            }
        }
        let sums = (0..count(highest_order)).map(|index| Bounds::of(&surfaces, &powers, index)).collect();
        Some(Ok(Neglected { powers, surfaces, sums, highest_order, radius: radius.clone() }))
    }

    /// Whether |E| ≤ ε Φ on the whole range.
    pub(crate) fn is_within(&self, tolerance: &Rational, order: u32) -> Result<bool, &'static str> {
        let (below, sides) = self.bounds(order);
        for side in sides {
            let mut difference = side;
            difference.map(|value| *value = -&*value);
            for (exponent, value) in below.iter() {
                difference.add(exponent.clone(), value * tolerance);
            }
            if !difference.first().is_some_and(|(_, value)| value.is_positive()) {
                return Ok(false);
            }
            if first_zero(&difference)?.is_some_and(|mut end| end.compare(&self.radius) != Ordering::Greater)
            {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A proved bound of |E|/Φ, an `f64` of three digits; nothing if that is above 1.
    pub(crate) fn bound(&self, order: u32) -> Result<Option<Rational>, &'static str> {
        let (below, sides) = self.bounds(order);
        if sides.iter().all(|side| side.is_empty()) {
            return Ok(Some(Rational::zero()));
        }
        // What underflows is bounded by the least number that it could be.
        let mut estimate = self.estimate(&below, &sides).max(f64::MIN_POSITIVE);
        let mut margin = 0.005;
        while estimate < 1.0 {
            let rounded = three_digits(estimate * (1.0 + margin));
            if let Some(rounded) = rounded
                && self.is_within(&rounded, order)?
            {
                return Ok(Some(rounded));
            }
            estimate *= 1.0 + margin;
            margin *= 2.0;
        }
        Ok(None)
    }

    /// The smallest order within a tolerance, if there is one.
    ///
    /// Bisection ends where the next lower order is not. Where the e_j have one sign no other is either: what M stands
    /// for includes the next term and the next M, so B falls and D rises with the order.
    pub(crate) fn smallest_order(&self, tolerance: &Rational) -> Result<Option<u32>, &'static str> {
        let (mut too_low, mut within) = (0, self.highest_order);
        if !self.is_within(tolerance, within)? {
            return Ok(None);
        }
        while within - too_low > 2 {
            let middle = (too_low + within) / 4 * 2;
            if self.is_within(tolerance, middle)? { within = middle } else { too_low = middle }
        }
        Ok(Some(within))
    }

    /// D, and B₊ and B₋ as far as neither is below the other.
    fn bounds(&self, order: u32) -> (Powers, Vec<Powers>) {
        let last = order / 2 + TERMS_AHEAD;
        let (mut below, mut over, mut under) = (self.powers.clone(), Powers::default(), Powers::default());
        let (mut rises, mut falls) = (false, false);
        for (j, sum) in (1..=last).zip(&self.sums) {
            let exponent = integer(2 * j);
            below.add(exponent.clone(), sum.in_gap.clone());
            if 2 * j > order {
                rises |= sum.above.is_positive();
                falls |= sum.below.is_negative();
                over.add(exponent.clone(), sum.above.clone());
                under.add(exponent, -&sum.below);
            }
        }
        let (rest, exponent) = (rest(&self.surfaces, last as usize), integer(2 * last + 2));
        below.add(exponent.clone(), -&rest);
        over.add(exponent.clone(), rest.clone());
        under.add(exponent, rest);
        let sides = match (rises, falls) {
            (true, true) => vec![over, under],
            (_, false) => vec![over],
            (false, true) => vec![under],
        };
        (below, sides)
    }

    /// The largest B/D at some radii, in `f64`: not a bound, but near the smallest. Infinite where there is none.
    fn estimate(&self, below: &Powers, sides: &[Powers]) -> f64 {
        let scaled = |powers: &Powers| -> Vec<(f64, f64)> {
            powers.iter().map(|(exponent, value)| self.at_end(exponent, value)).collect()
        };
        let (below, sides) = (scaled(below), sides.iter().map(scaled).collect::<Vec<_>>());
        let ratio = |sample: u32| {
            let x = f64::from(sample) / f64::from(SAMPLES);
            let value =
                |terms: &Vec<(f64, f64)>| terms.iter().map(|(n, term)| term * x.powf(*n)).sum::<f64>();
            let gap = value(&below);
            let neglected = sides.iter().map(value).fold(0.0, f64::max);
            if gap > 0.0 { neglected / gap } else { f64::INFINITY }
        };
        (1..=SAMPLES).map(ratio).fold(0.0, f64::max)
    }

    /// The exponent, and the term at the end of the range: exact until it is rounded, as powers of lengths in metres
    /// would leave the range of an `f64`.
    fn at_end(&self, exponent: &Rational, value: &Rational) -> (f64, f64) {
        let whole = exponent.floor();
        let term = value * self.radius.pow(whole.to_i32().unwrap_or(0));
        let fraction = (exponent - whole).to_f64().unwrap_or(0.0);
        let rest = self.radius.to_f64().unwrap_or(0.0).powf(fraction);
        (exponent.to_f64().unwrap_or(0.0), term.to_f64().unwrap_or(f64::NAN) * rest)
    }
}

impl Series {
    fn new(surface: &Surface, range: &Rational, highest_order: u32) -> Option<Result<Self, BeyondRim>> {
        let (radius, shape) = (surface.radius.as_constant()?, surface.shape.as_constant()?);
        let relative = range / &radius;
        let ratio = shape.abs() * &relative * &relative;
        if ratio >= Rational::one() {
            return rim(surface).map(|rim| Err(BeyondRim(rim)));
        }
        let terms = surface.series(count(highest_order) as u32).ok()?;
        let terms = terms.iter().map(Coefficient::as_constant).collect::<Option<_>>()?;
        let rest = if shape.is_negative() { Rational::one() } else { (Rational::one() - ratio).recip() };
        Some(Ok(Series { terms, rest }))
    }
}

impl Bounds {
    /// Those for j = index + 1.
    fn of(surfaces: &[Series], powers: &Powers, index: usize) -> Self {
        let sum = unreduced_sum(surfaces.iter().filter_map(|series| series.terms.get(index)).cloned());
        let (below, above) = (floor(&sum, DIGITS), -floor(&-&sum, DIGITS));
        let exponent = integer(2 * (index + 1));
        let in_gap = match powers.iter().find(|(power, _)| *power == exponent) {
            Some((_, own)) => floor(&(own + sum), DIGITS) - own,
            None => below.clone(),
        };
        Bounds { below, above, in_gap }
    }
}

/// Not below M, where the first term that is not summed has this index.
fn rest(surfaces: &[Series], index: usize) -> Rational {
    let of_series = |series: &Series| {
        let first = series.terms.get(index)?;
        Some(-floor(&-first.abs(), DIGITS) * &series.rest)
    };
    unreduced_sum(surfaces.iter().filter_map(of_series))
}

/// Without the greatest common divisors that take most of the time of such a sum.
fn unreduced_sum(terms: impl Iterator<Item = Rational>) -> Rational {
    terms.fold(Rational::zero(), |sum, term| {
        let numerator = sum.numer() * term.denom() + term.numer() * sum.denom();
        Rational::new_raw(numerator, sum.denom() * term.denom())
    })
}

/// The number rounded to three digits, as the exact value of the `f64` that they are read as.
pub(crate) fn three_digits(value: f64) -> Option<Rational> {
    format!("{value:.2e}").parse::<f64>().ok().and_then(Rational::from_float)
}
