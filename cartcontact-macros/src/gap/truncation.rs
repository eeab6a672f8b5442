//! What a series cut off at r^N neglects, with a bound relative to the gap.
//!
//! Let Φ be the gap with its surfaces exact, Φ_N the gap with their series up to r^N, and E = Φ − Φ_N. The condition
//! |E| ≤ ε Φ is
//!
//! ```text
//! (1 − ε) E ≤ ε Φ_N  and  −(1 + ε) E ≤ ε Φ_N
//! ```
//!
//! so that only E needs bounds. Its series is summed up to r^(2J), with e_j = Σ w c_j over the surfaces with their
//! weights w. The rest ([`crate::gap::series`]) is Σ w c_(J+1) F r^(2J+2). With a lower bound m and an upper bound M of
//! Σ w c_(J+1) F in the range, linear in r²,
//!
//! ```text
//! m r^(2J+2) ≤ E(r) − Σ e_j r^(2j) ≤ M r^(2J+2),    N < 2j ≤ 2J
//! ```
//!
//! leaves sums of powers with rational coefficients, and whether they have a zero in the range is decided exactly.
//! Coefficients are rounded only to keep them short: up in the bounds of ±E, down in Φ_N.

use core::cmp::Ordering;

use num_traits::{One, ToPrimitive, Zero};

use crate::first_zero::first_zero;
use crate::gap::like_terms::LikeTerms;
use crate::gap::series::Series;
use crate::gap::shape::Shape;
use crate::number::{Rational, ceil, floor, integer, three_digits};

/// The highest order: more terms than a smooth joint needs, and few enough to evaluate.
pub(crate) const HIGHEST_ORDER: u32 = 128;
/// J − N/2, the terms after the order that are summed: enough for m and M to be close unless the range ends near a rim,
/// and so few that fractional exponents, which multiply the degree of a proof, leave room for some orders.
const TERMS_AHEAD: u32 = 7;
/// Binary digits kept of a coefficient: the surfaces of a joint share far fewer.
const DIGITS: u64 = 256;
/// Binary digits kept of the powers of ρ for estimates.
const FEW_DIGITS: u64 = 64;
/// The number of radii at which a bound is estimated before it is proved.
const SAMPLES: u32 = 16;
/// An estimate may be too large by this share: sums of `f64` lose more only next to a zero of the gap.
const UNCERTAIN: f64 = 1e-6;

/// What this order neglects cannot be compared with a tolerance: beside fractional exponents the degree of the proof is
/// too high, and higher orders only raise it.
pub(crate) struct Unprovable {
    pub(crate) order: u32,
}

/// The number of terms of a series that an order asks for.
fn count(order: u32) -> usize {
    (order / 2 + TERMS_AHEAD + 1) as usize
}

type Powers = LikeTerms<Rational, Rational>;

/// A gap with constant surfaces on a range that ends inside all of them.
pub(crate) struct Neglected {
    /// The powers of the gap that no term of a series is added to.
    others: Powers,
    /// Their exponents, and their terms at the end of the range.
    others_at_end: Vec<(f64, f64)>,
    surfaces: Vec<Series>,
    /// For j = 1, 2, ..., as many as the highest order asks for.
    sums: Vec<Sum>,
    highest_order: u32,
    /// ρ
    radius: Rational,
}

/// e_j between two numbers of few digits.
struct Sum {
    below: Rational,
    above: Rational,
    /// The coefficient of r^(2j) in the powers of the gap, and its sum with e_j: what cancels leaves nothing.
    own: Rational,
    with_own: Rational,
    /// ρ^(2j), for estimates.
    scale: Rational,
    at_end: AtEnd,
}

/// The numbers of a sum times its scale: the terms at the end of the range.
struct AtEnd {
    below: f64,
    above: f64,
    own: f64,
    with_own: f64,
}

/// A bound of what follows the summed terms of the series, relative to the power of r that follows them.
struct Rest {
    at_centre: Rational,
    /// The increase up to the end of the range, in proportion to r².
    rise: Rational,
}

impl Neglected {
    /// What orders up to the highest neglect; nothing if a coefficient is not a number, or if the range reaches a rim.
    pub(crate) fn new(shape: &Shape, radius: &Rational, highest_order: u32) -> Option<Self> {
        let mut others = Powers::default();
        for (exponent, monomial) in shape.powers.terms() {
            others.add(exponent.clone(), monomial.coefficient.as_constant()?);
        }
        let mut surfaces = Vec::new();
        for surface in &shape.surfaces {
            surfaces.push(Series::new(surface, radius, count(highest_order))?);
        }
        let (square, mut scale) = (radius * radius, Rational::one());
        let sums = (0..count(highest_order)).map(|index| {
            scale = floor(&(&scale * &square), FEW_DIGITS);
            Sum::of(&surfaces, others.take(&integer(2 * (index + 1))), index, &scale)
        });
        let sums = sums.collect();
        let others_at_end = others.iter().map(|(exponent, value)| at_end(radius, exponent, value)).collect();
        Some(Neglected { others, others_at_end, surfaces, sums, highest_order, radius: radius.clone() })
    }

    /// Whether |E| ≤ ε Φ on the whole range.
    pub(crate) fn is_within(&self, tolerance: &Rational, order: u32) -> Result<bool, Unprovable> {
        for (powers, factor) in self.sides(order, tolerance) {
            let mut difference = self.kept(order);
            difference.map(|value| *value = &*value * tolerance);
            for (exponent, value) in powers {
                difference.add(exponent, -value * &factor);
            }
            if !difference.first().is_some_and(|(_, value)| value.is_positive()) {
                return Ok(false);
            }
            let end = first_zero(&difference).map_err(|_| Unprovable { order })?;
            if end.is_some_and(|mut end| end.compare(&self.radius) != Ordering::Greater) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A proved bound of |E|/Φ, an `f64` of three digits; nothing if that is above 1.
    pub(crate) fn bound(&self, order: u32) -> Result<Option<Rational>, Unprovable> {
        if self.sides(order, &Rational::zero()).is_empty() {
            return Ok(Some(Rational::zero()));
        }
        // A value that underflows is bounded by the least number that it could be.
        let mut estimate = self.estimate(order).max(f64::MIN_POSITIVE);
        // Half a unit of the third digit.
        let mut margin = 0.005;
        while estimate < 1.0 {
            let rounded = three_digits(estimate * (1.0 + margin));
            if let Some(rounded) = rounded.filter(|rounded| *rounded < Rational::one())
                && self.is_within(&rounded, order)?
            {
                return Ok(Some(rounded));
            }
            estimate *= 1.0 + margin;
            margin *= 2.0;
        }
        Ok(None)
    }

    /// The smallest order within a tolerance, if there is one. If the e_j have different signs, an order within it may
    /// be followed by one that is not, so all are tried from the lowest on.
    pub(crate) fn smallest_order(&self, tolerance: &Rational) -> Result<Option<u32>, Unprovable> {
        let wanted = tolerance.to_f64().max(f64::MIN_POSITIVE) * (1.0 + UNCERTAIN);
        for order in (2..=self.highest_order).step_by(2) {
            if self.estimate(order) <= wanted && self.is_within(tolerance, order)? {
                return Ok(Some(order));
            }
        }
        Ok(None)
    }

    /// Φ_N, or a lower bound of it.
    fn kept(&self, order: u32) -> Powers {
        let mut kept = self.others.clone();
        for (j, sum) in (1..).zip(&self.sums) {
            let value = if 2 * j <= order { &sum.with_own } else { &sum.own };
            kept.add(integer(2 * j), value.clone());
        }
        kept
    }

    /// The bounds of E and −E with the factors that they have when they are compared with ε Φ_N, except a bound that is
    /// nowhere positive: it is below the share of Φ_N where that is positive, which the other bound implies.
    fn sides(&self, order: u32, tolerance: &Rational) -> Vec<(Powers, Rational)> {
        let (mut over, mut under) = (Powers::default(), Powers::default());
        let (first, last) = (order / 2, order / 2 + TERMS_AHEAD);
        for (j, sum) in (1..=last).zip(&self.sums).skip(first as usize) {
            over.add(integer(2 * j), sum.above.clone());
            under.add(integer(2 * j), -&sum.below);
        }
        let [below, above] = self.rest(last as usize);
        let square = &self.radius * &self.radius;
        over.add(integer(2 * last + 2), above.at_centre);
        over.add(integer(2 * last + 4), ceil(&(above.rise / &square), DIGITS));
        under.add(integer(2 * last + 2), -below.at_centre);
        under.add(integer(2 * last + 4), ceil(&(-below.rise / &square), DIGITS));
        let sides = [(over, Rational::one() - tolerance), (under, Rational::one() + tolerance)];
        let is_somewhere_positive = |powers: &Powers| powers.iter().any(|(_, value)| value.is_positive());
        sides.into_iter().filter(|(powers, _)| is_somewhere_positive(powers)).collect()
    }

    /// m and M, if the first term that is not summed has this index.
    fn rest(&self, index: usize) -> [Rest; 2] {
        let (mut least, mut most) = (Vec::new(), Vec::new());
        for series in &self.surfaces {
            let (first, at_end) = (&series.terms[index], &series.tails_at_end[index]);
            let constant = Rest { at_centre: first * &series.least_tail, rise: Rational::zero() };
            let chord = Rest { at_centre: first.clone(), rise: first * (at_end - Rational::one()) };
            let [lower, upper] = if first.is_negative() { [chord, constant] } else { [constant, chord] };
            least.push(lower);
            most.push(upper);
        }
        let sum = |rests: &[Rest], rounded: fn(&Rational, u64) -> Rational| Rest {
            at_centre: rounded(&unreduced_sum(rests.iter().map(|rest| &rest.at_centre)), DIGITS),
            rise: rounded(&unreduced_sum(rests.iter().map(|rest| &rest.rise)), DIGITS),
        };
        [sum(&least, floor), sum(&most, ceil)]
    }

    /// The smallest ε at some radii, in `f64`: not a bound, but near the smallest ε. Infinite if there is none.
    fn estimate(&self, order: u32) -> f64 {
        let (first, last) = ((order / 2) as usize, (order / 2 + TERMS_AHEAD) as usize);
        let scale = &self.sums[last].scale;
        let rests = self.rest(last).map(|rest| [rest.at_centre, rest.rise].map(|part| product(&part, scale)));
        let ratio = |sample: u32| {
            let x = f64::from(sample) / f64::from(SAMPLES);
            let mut gap: f64 = self.others_at_end.iter().map(|(n, term)| term * x.powf(*n)).sum();
            let (mut least, mut most, mut power) = (0.0, 0.0, 1.0);
            for (index, sum) in self.sums.iter().enumerate() {
                power *= x * x;
                gap += power * if index < first { sum.at_end.with_own } else { sum.at_end.own };
                let [below, above] = match index {
                    _ if index == last => rests.map(|[at_centre, rise]| at_centre + x * x * rise),
                    _ if (first..last).contains(&index) => [sum.at_end.below, sum.at_end.above],
                    _ => continue,
                };
                least += power * below;
                most += power * above;
            }
            if gap > 0.0 && gap + least > 0.0 {
                (most / (gap + most)).max(-least / (gap + least)).max(0.0)
            } else {
                f64::INFINITY
            }
        };
        (1..=SAMPLES).map(ratio).fold(0.0, f64::max)
    }
}

/// The exponent, and the term at the end of the range. The term is exact until it is rounded, as powers of lengths in
/// metres would leave the range of an `f64`.
fn at_end(radius: &Rational, exponent: &Rational, value: &Rational) -> (f64, f64) {
    let whole = exponent.floor();
    let term = value * radius.pow(whole.to_i32().unwrap_or(0));
    let rest = radius.to_f64().powf((exponent - whole).to_f64());
    (exponent.to_f64(), term.to_f64() * rest)
}

impl Sum {
    /// The sum for j = index + 1, where the powers of the gap have the coefficient `own`.
    fn of(surfaces: &[Series], own: Option<Rational>, index: usize, scale: &Rational) -> Self {
        let sum = unreduced_sum(surfaces.iter().filter_map(|series| series.terms.get(index)));
        let (below, above) = (floor(&sum, DIGITS), ceil(&sum, DIGITS));
        let with_own = own.as_ref().map_or_else(|| below.clone(), |own| floor(&(own + sum), DIGITS));
        let own = own.unwrap_or_else(Rational::zero);
        let at_end = AtEnd {
            below: product(&below, scale),
            above: product(&above, scale),
            own: product(&own, scale),
            with_own: product(&with_own, scale),
        };
        Sum { below, above, own, with_own, scale: scale.clone(), at_end }
    }
}

/// Without reducing, as numbers beside lengths such as 1e-300 have thousands of digits.
fn product(value: &Rational, scale: &Rational) -> f64 {
    Rational::new_raw(value.numer() * scale.numer(), value.denom() * scale.denom()).to_f64()
}

/// Without reducing by greatest common divisors, which take most of the time of such a sum.
fn unreduced_sum<'a>(terms: impl Iterator<Item = &'a Rational>) -> Rational {
    terms.fold(Rational::zero(), |sum, term| {
        let numerator = sum.numer() * term.denom() + term.numer() * sum.denom();
        Rational::new_raw(numerator, sum.denom() * term.denom())
    })
}
