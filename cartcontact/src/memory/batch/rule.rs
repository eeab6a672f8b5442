//! Which quadrature rule is long enough for a piece of a batch.
//!
//! e^(−age) changes by the piece's e-foldings. w(Y) = a⁻⁴ is nearly a power of Y; its singularity is where Y,
//! continued, is zero, further away than the root of |R| v + |B| v²/2 = Y. For every rule, [`RULES`] holds the most
//! e-foldings and the least distance that alone cause an error of ε/4 in Y′ w e^(−age), with any w between
//! Y^(−4/4.25) and Y^(−4/68) and any straight Y′, also one that vanishes at an end. What has since faded by e^(−x) may
//! have e^x times that error, which a rule of n nodes makes with e^(x/(2n+1)) times as many e-foldings.

use crate::Scalar;
use crate::load::Piece;
use crate::numbers::tabled::Tabled;
use crate::quadrature::Rule;

/// A rule, and which pieces are short enough for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortRule {
    pub(super) rule: &'static Rule,
    /// One over the most e-foldings of a piece.
    per_fold: Tabled,
    /// The least distance to the singularity from the end of a piece, in units of its duration.
    distance: Tabled,
    /// 1/(4 (2n + 1)), the factor of the e-foldings that have faded since.
    per_faded: Tabled,
}

/// Found by bisection in 40 digits, for ε/4 in f64, and rounded to the safe side. Half of both limits together makes an
/// error below ε/16. The distance of the rule of 4 nodes is half as much again, because closer to the singularity its
/// radii cannot be told from unresolved ones.
pub(super) const RULES: [ShortRule; 5] = [
    ShortRule::of(Rule::FOUR, 0.067, 75.0),
    ShortRule::of(Rule::SIX, 0.66, 6.8),
    ShortRule::of(Rule::EIGHT, 2.1, 2.5),
    ShortRule::of(Rule::TEN, 4.4, 1.3),
    ShortRule::of(Rule::TWELVE, 7.6, 0.82),
];

/// How the hereditary load Y grows along a piece.
pub(super) struct Growth<T> {
    /// χ times the duration.
    pub(super) folds: T,
    /// R and B of the [batch](super).
    pub(super) rate: T,
    pub(super) bend: T,
}

impl<T: Scalar> Growth<T> {
    pub(super) fn along(piece: &Piece<T>, chi: T) -> Self {
        let folds = chi * piece.duration();
        // A load that falls as fast as it may has Y′ = 0, which rounding can make negative. It stays negative, or else
        // roundings the other way would add up.
        let rate = piece.rise() + folds * piece.end.1;
        Self { folds, rate, bend: folds * piece.rise() }
    }

    pub(super) fn in_all(&self) -> T {
        self.rate - self.bend * T::constant(0.5)
    }
}

impl ShortRule {
    /// A rule with the most e-foldings of a piece and the least distance.
    const fn of(rule: &'static Rule, folds: f64, distance: f64) -> Self {
        let per_faded = 0.25 / (2 * rule.len() + 1) as f64;
        Self {
            rule,
            per_fold: Tabled::of(1.0 / folds),
            distance: Tabled::of(distance),
            per_faded: Tabled::of(per_faded),
        }
    }

    /// Whether the rule is long enough for a piece that ends with a hereditary load and of which e^(−faded) is left.
    pub(super) fn suffices<T: Scalar>(&self, growth: &Growth<T>, hereditary: T, faded: T) -> bool {
        // e^(faded/(2n+1)), or a little less.
        let root = T::one() + faded * self.per_faded.get::<T>();
        let square = root * root;
        let of_distance = square * square - growth.folds * self.per_fold.get::<T>();
        // |R| v + |B| v²/2 must be below Y at the v of the least distance.
        let v = T::one() + self.distance.get::<T>() / of_distance;
        let shortfall = v * (growth.rate.abs() + growth.bend.abs() * T::constant(0.5) * v);
        (of_distance > T::zero()) & (shortfall <= hereditary)
    }
}
