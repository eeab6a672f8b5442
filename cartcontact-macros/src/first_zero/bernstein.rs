//! Bernstein's coefficients of a polynomial over part of an interval, and what they say about its roots there.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One, ToPrimitive, Zero};

use crate::first_zero::fixed_point::Numbers;
use crate::first_zero::powers::Powers;

/// A polynomial over a part in Bernstein's basis: p = Σ b_j C(n, j) x^j (1 − x)^(n−j) for x from 0 to 1.
///
/// The signs of b_0, …, b_n change as often as there are roots inside, or more often by an even number; if none
/// changes, there is no root. b_0 and b_n are the values at the ends (R. T. Farouki, Comput. Aided Geom. Des. 29 (2012)
/// 379-419, doi 10.1016/j.cagd.2012.03.001).
pub(crate) struct Bernstein {
    numbers: Numbers,
    /// Each number is less than this many units from the true one.
    error: i128,
    /// Whether a number is zero if the error leaves its sign open.
    is_exact: bool,
}

/// How often the sign changes at least and at most.
#[derive(PartialEq, Eq)]
#[cfg_attr(test, derive(Debug))]
pub(crate) struct SignChanges {
    pub(crate) least: usize,
    pub(crate) most: usize,
}

impl Bernstein {
    /// Rounding the powers adds less than two units to their error.
    pub(crate) fn new(powers: &Powers, is_exact: bool) -> Self {
        Bernstein { numbers: powers.bernstein(), error: powers.error + 2, is_exact }
    }

    /// The polynomial over both halves of the part, by de Casteljau's algorithm: means of neighbours do not enlarge the
    /// error, and rounding them adds one unit. The last `cut` digits are dropped.
    pub(crate) fn halves(self, cut: u64) -> [Bernstein; 2] {
        let degree = self.numbers.len().saturating_sub(1);
        let [left, right] = self.numbers.edges();
        let lower = left.shifted_down(&|index| index + cut as usize);
        let upper = right.shifted_down(&|index| degree - index + cut as usize);
        let error = (self.error >> cut.min(126)) + if cut > 0 { 2 } else { 1 };
        // Over a half, exact numbers are multiples of a finer unit and must be computed anew.
        let half = |numbers| Bernstein { numbers, error, is_exact: false };
        [half(lower), half(upper)]
    }

    /// The bits of the shortest number of known sign.
    pub(crate) fn shortest(&self) -> u64 {
        self.numbers.shortest(self.error)
    }

    /// An upper bound of the bits of the longest number.
    pub(crate) fn length(&self) -> u64 {
        self.numbers.length()
    }

    fn sign(&self, index: usize) -> Option<Ordering> {
        self.numbers.sign(index, self.error).or(self.is_exact.then_some(Ordering::Equal))
    }

    /// The sign at the lower end, if it is certain, and the sign changes along the coefficients. `exactly` gives the
    /// signs at the two ends if no others are uncertain.
    pub(crate) fn sign_changes(&self, exactly: &dyn Fn(u32) -> Ordering) -> (Option<Ordering>, SignChanges) {
        let mut signs: Vec<Option<Ordering>> =
            (0..self.numbers.len()).map(|index| self.sign(index)).collect();
        if let [first, between @ .., last] = signs.as_mut_slice()
            && between.iter().all(Option::is_some)
        {
            first.get_or_insert_with(|| exactly(0));
            last.get_or_insert_with(|| exactly(1));
        }
        (signs.first().copied().flatten(), SignChanges::along(&signs))
    }

    /// Whether the value at the lower end (0) or the upper end (1) is far enough from 0 for its sign to be known.
    pub(crate) fn knows_end(&self, end: u32) -> bool {
        let index = if end == 0 { 0 } else { self.numbers.len() - 1 };
        self.numbers.sign(index, self.error).is_some()
    }

    /// Where all roots of the part may lie, if there are `multiplicity` of them.
    ///
    /// Newton's method for a root of this multiplicity leads from both ends to points near the cluster.
    pub(crate) fn cluster(&self, multiplicity: usize) -> Cluster {
        let last = self.numbers.len() - 1;
        let lower = self.newton(multiplicity, 0, 1);
        let upper = (BigInt::one() << FINEST) - self.newton(multiplicity, last, last - 1);
        Cluster { agreement: FINEST.saturating_sub((&upper - &lower).bits()), twice: lower + upper }
    }

    /// How far Newton's method leads from an end, in units of 2^-FINEST of the part; `neighbour` is the coefficient
    /// next to it. Zero if the method leads outside, as it may from an end amid the roots, or if the value is too small
    /// to be known: the roots are then near this end, if anywhere.
    fn newton(&self, multiplicity: usize, end: usize, neighbour: usize) -> BigInt {
        if self.numbers.sign(end, self.error).is_none() {
            return BigInt::zero();
        }
        let (value, next) = (self.numbers.value(end), self.numbers.value(neighbour));
        let degree = self.numbers.len() - 1;
        let (mut step, mut fall) = (&value * multiplicity, (&value - next) * degree);
        let inside = !fall.is_zero() && (fall < BigInt::zero()) == (value < BigInt::zero());
        if !inside {
            return BigInt::zero();
        }
        let excess = step.bits().min(fall.bits()).saturating_sub(FINEST + 64);
        step >>= excess;
        fall >>= excess;
        let position = (step << FINEST) / fall;
        if position <= BigInt::one() << (FINEST + 1) { position } else { BigInt::zero() }
    }
}

/// Newton's method is computed to 2^-FINEST of the part.
const FINEST: u64 = 2048;
/// The piece around a cluster is this many bits longer than the apparent spread of its roots.
const MARGIN: u64 = 1;
/// A piece that gains fewer bits than this is reached by halving as well.
const LEAST_GAIN: u64 = 5;

/// A point near which all roots of a part seem to lie.
pub(crate) struct Cluster {
    /// Its estimates from the two ends differ by less than 2^-agreement of the part.
    agreement: u64,
    /// The sum of the estimates, in units of 2^-FINEST of the part.
    twice: BigInt,
}

impl Cluster {
    /// A piece of at most `most_bits` bits: it starts at offset/2^bits and is 2^(2-bits) long. If the roots of the
    /// cluster are up to s away from their mean, s itself cancels in the estimates, which then differ by about s² only.
    /// So half of the bits in which they agree give a piece as long as s.
    pub(crate) fn piece(&self, most_bits: u64) -> Option<(BigInt, u64)> {
        let bits =
            (self.agreement / 2).min(most_bits).checked_sub(MARGIN).filter(|bits| *bits >= LEAST_GAIN)?;
        let centre: BigInt = &self.twice >> (FINEST + 1 - bits);
        let last: BigInt = (BigInt::one() << bits) - 4;
        let offset: BigInt = centre - 2;
        match offset.to_u8() {
            // A piece longer than half of what lies before it is extended to the start of the part.
            Some(1..8) => Some((BigInt::zero(), bits - 2)),
            _ => Some((offset.clamp(BigInt::zero(), last), bits)),
        }
    }
}

impl SignChanges {
    /// Zeros are skipped. An uncertain sign counts as whichever makes the changes fewest, and most.
    fn along(signs: &[Option<Ordering>]) -> Self {
        // The fewest and the most changes so far if the last sign was negative, and if it was positive.
        let mut ending: [Option<(usize, usize)>; 2] = [None, None];
        for sign in signs {
            let [negative, positive] = ending;
            let changed = |other: Option<(usize, usize)>| other.map(|(least, most)| (least + 1, most + 1));
            let to_negative = either(negative, changed(positive)).or(Some((0, 0)));
            let to_positive = either(positive, changed(negative)).or(Some((0, 0)));
            ending = match sign {
                Some(Ordering::Less) => [to_negative, None],
                Some(Ordering::Equal) => ending,
                Some(Ordering::Greater) => [None, to_positive],
                None => [to_negative, to_positive],
            };
        }
        let [negative, positive] = ending;
        let (least, most) = either(negative, positive).unwrap_or_default();
        SignChanges { least, most }
    }
}

fn either(left: Option<(usize, usize)>, right: Option<(usize, usize)>) -> Option<(usize, usize)> {
    match (left, right) {
        (Some(left), Some(right)) => Some((left.0.min(right.0), left.1.max(right.1))),
        (left, right) => left.or(right),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::first_zero::fixed_point::binomials;
    use crate::first_zero::integer_polynomial::IntegerPolynomial;
    use crate::first_zero::part::{Part, Whole};
    use crate::first_zero::source::Source;

    fn over(source: &Source<'_>, part: &Part, digits: u64) -> Bernstein {
        Bernstein::new(&source.powers_over(part, digits), false)
    }

    fn interval<'a>(whole: &'a Whole<'a>, digits: u64) -> Source<'a> {
        Source::whole(whole).near(Part::whole(), whole.powers(digits), digits, 0)
    }

    /// Coefficients of very different lengths and mixed signs.
    fn polynomial(degree: usize) -> IntegerPolynomial {
        let coefficients = (0..=degree as u64).map(|power| {
            let size = BigInt::from(power * 7919 + 1) << (power * 37 % 101);
            if power % 3 == 1 { -size } else { size }
        });
        IntegerPolynomial::new(coefficients.collect())
    }

    fn parts() -> Vec<Part> {
        let whole = Part::whole();
        let [half, deep] = [(1, 1, 1), (123_456_789, 40, 38)].map(|(o, b, w)| whole.within(&o.into(), b, w));
        let deeper = deep.within(&5.into(), 3, 3);
        vec![whole, half, deep, deeper]
    }

    /// Bernstein's coefficients by their definition over the whole, and by blossoming over a part: b_j is the mean of
    /// all products of the ends, so that for the power m it is Σ_i C(j, i) C(n−j, m−i)/C(n, m) upper^i lower^(m−i).
    fn coefficient(whole: &Whole<'_>, part: &Part, j: usize) -> (BigInt, BigInt) {
        let n = whole.polynomial.degree();
        let [lower, upper] = [0, 1].map(|end| part.end(end));
        let all = binomials(n);
        let common: BigInt = all.iter().product();
        let terms = whole.polynomial.coefficients().iter().enumerate().map(|(m, c)| {
            let products = (0..=m.min(j)).filter(|i| m - i <= n - j).map(|i| {
                &binomials(j)[i] * &binomials(n - j)[m - i] * upper.pow(i as u32) * lower.pow((m - i) as u32)
            });
            (c * products.sum::<BigInt>() * (&common / &all[m])) << (part.bits * (n - m) as u64)
        });
        (terms.sum(), common << (part.bits * n as u64))
    }

    #[test]
    fn numbers_are_as_near_as_they_say() {
        for degree in [1, 5, 20] {
            let polynomial = polynomial(degree);
            let whole = Whole::new(&polynomial, 0);
            let digits = whole.length + 10;
            let close = |local: &Bernstein, part: &Part, cut: u64| {
                for j in 0..=degree {
                    let (value, unit) = coefficient(&whole, part, j);
                    let difference = ((local.numbers.value(j) * &unit) << cut) - (value << 10_u32);
                    assert!(
                        difference.magnitude() < ((unit * local.error) << cut).magnitude(),
                        "{degree}: {part:?}, {j}"
                    );
                }
            };
            for part in parts() {
                let source = interval(&whole, digits);
                let near = source.clone().near(part.clone(), source.powers_over(&part, digits), digits, 0);
                close(&over(&near, &part, digits), &part, 0);
                for (start, bits) in
                    [(0, 5), (8, 5), (1_000_000, 21)].map(|(start, bits)| (start.into(), bits))
                {
                    let piece = part.within(&start, bits, bits - 2);
                    for cut in [0, 1, 8] {
                        close(&over(&near, &piece, digits - cut), &piece, cut);
                    }
                }
                for cut in [0, 1, 8] {
                    let halves = over(&near, &part, digits).halves(cut);
                    for (offset, half) in halves.iter().enumerate() {
                        close(half, &part.within(&offset.into(), 1, 1), cut);
                    }
                }
            }
        }
    }

    /// Three roots near 5/3 of the interval from 1 to 2, and a fourth far away.
    #[test]
    fn clusters_are_met() {
        let factor = |polynomial: Vec<BigInt>, [constant, slope]: [i64; 2]| -> Vec<BigInt> {
            let shifted = core::iter::once(BigInt::zero()).chain(polynomial.iter().map(|c| c * slope));
            let constants = polynomial.iter().map(|c| c * constant).chain([BigInt::zero()]);
            shifted.zip(constants).map(|(high, low)| high + low).collect()
        };
        let roots =
            [[5_000_001, -3_000_000], [5_000_000, -3_000_000], [4_999_998, -3_000_000], [1 << 40, -1]];
        let polynomial = IntegerPolynomial::new(roots.into_iter().fold(vec![BigInt::one()], factor));
        let whole = Whole::new(&polynomial, 0);
        let source = interval(&whole, 300);
        let local = over(&source, &Part::whole(), 300);
        let Some((offset, bits)) = local.cluster(3).piece(u64::MAX) else { unreachable!() };
        let piece = Part::whole().within(&offset, bits, bits - 2);
        let changes = over(&source, &piece, 300).sign_changes(&|end| whole.sign_at(&piece, end)).1;
        assert!(bits > 8 && changes == SignChanges { least: 3, most: 3 });
        assert_eq!(local.cluster(2).piece(u64::MAX), None);
    }

    #[test]
    fn uncertain_signs_make_a_range() {
        let signs = [1, 0, 2, -1, 2, 1].map(|sign: i32| (sign != 2).then(|| sign.cmp(&0)));
        assert_eq!(SignChanges::along(&signs), SignChanges { least: 2, most: 2 });
        let signs = [1, 2, 1, 2, -1].map(|sign: i32| (sign != 2).then(|| sign.cmp(&0)));
        assert_eq!(SignChanges::along(&signs), SignChanges { least: 1, most: 3 });
    }
}
