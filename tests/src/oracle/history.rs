//! The contact under a load history, with the memory integral as printed.

use super::number::{Real, decimal, double, pi, whole};
use super::profile::Profile;
use super::quadrature::integrate;

/// The solution for a geometry, a medium and a piecewise-linear load.
#[derive(Clone, Debug)]
pub struct Oracle {
    profile: Profile,
    m: Real,
    chi: Real,
    pieces: Vec<Piece>,
}

/// A stretch of history on which the load is F₀ + F′ (τ − start), and ∫F up to its start.
#[derive(Clone, Debug)]
struct Piece {
    start: Real,
    force: Real,
    rate: Real,
    impulse: Real,
}

impl Piece {
    fn force_at(&self, t: &Real) -> Real {
        &self.force + &self.rate * (t - &self.start)
    }

    fn impulse_at(&self, t: &Real) -> Real {
        &self.impulse + (t - &self.start) * (&self.force + self.force_at(t)) / whole(2)
    }

    /// Y = F + χ ∫F.
    fn hereditary(&self, chi: &Real, t: &Real) -> Real {
        self.force_at(t) + chi * self.impulse_at(t)
    }
}

impl Oracle {
    /// The solution for a geometry, the constants m and χ, and the knots (time, force) of a load that is linear between
    /// them and constant after the last; the first is at time 0, and two at the same time are a step.
    ///
    /// # Panics
    ///
    /// If there are no knots.
    #[must_use]
    pub fn new(profile: Profile, m: f64, chi: f64, knots: &[(f64, f64)]) -> Self {
        let (mut pieces, mut impulse) = (Vec::new(), whole(0));
        for pair in knots.windows(2) {
            let [(start, force), (end, next)] =
                [pair[0], pair[1]].map(|(t, force)| (double(t), double(force)));
            if end > start {
                let rate = (&next - &force) / (&end - &start);
                let piece = Piece { start, force, rate, impulse };
                impulse = piece.impulse_at(&end);
                pieces.push(piece);
            }
        }
        let &(start, force) = knots.last().unwrap_or_else(|| unreachable!("no knots"));
        pieces.push(Piece { start: double(start), force: double(force), rate: whole(0), impulse });
        Self { profile, m: double(m), chi: double(chi), pieces }
    }

    /// The geometry.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// a(t): Eq. (14).
    #[must_use]
    pub fn radius(&self, t: f64) -> Real {
        self.radius_at(&double(t))
    }

    /// δ₀(t): Eq. (10).
    #[must_use]
    pub fn approach(&self, t: f64) -> Real {
        self.profile.approach(&self.radius(t))
    }

    /// F(t).
    #[must_use]
    pub fn force(&self, t: f64) -> Real {
        let t = double(t);
        self.piece_at(&t).force_at(&t)
    }

    /// P(r, t): Eq. (28) with K⁻¹ as printed.
    #[must_use]
    pub fn pressure(&self, r: f64, t: f64) -> Real {
        let [pressure] = self.pressures([r], t);
        pressure
    }

    /// The pressures at several radii, which share the contact radii of the history.
    #[must_use]
    pub fn pressures<const N: usize>(&self, radii: [f64; N], t: f64) -> [Real; N] {
        let (radii, t) = (radii.map(double), double(t));
        let points = radii.each_ref().map(|r| self.profile.at(r));
        let a = self.radius_at(&t);
        let edge = self.profile.at(&a);
        let mut pressures = points.each_ref().map(|point| edge.pressure_kernel(point));
        let covered = radii.each_ref().map(|r| if *r < a { self.time_of_covering(r) } else { t.clone() });
        // The error is 1e-45 or less: a result has about twice the digits in which it agrees with the one before.
        let tolerance = decimal("1e-30");
        for ends in self.panels(&covered, &t).windows(2) {
            let shares: [Real; N] = integrate(&ends[0], &ends[1], &tolerance, |time| {
                let edge = self.profile.at(&self.radius_at(time));
                let share = (-(&self.chi * (&t - time))).exp();
                // Decided by time: at the ends of a panel, a rounded radius may seem covered a little too early.
                let counts = covered.each_ref().map(|first| *first <= ends[0]);
                core::array::from_fn(|i| {
                    if counts[i] { edge.pressure_kernel(&points[i]) * &share } else { whole(0) }
                })
            });
            for (pressure, share) in pressures.iter_mut().zip(shares) {
                *pressure -= &self.chi * share;
            }
        }
        pressures.map(|pressure| pressure * &self.m)
    }

    /// The piece that applies at a time, the later one at a knot.
    fn piece_at(&self, t: &Real) -> &Piece {
        let later = self.pieces.partition_point(|piece| piece.start <= *t);
        &self.pieces[later.saturating_sub(1)]
    }

    fn radius_at(&self, t: &Real) -> Real {
        let hereditary = self.piece_at(t).hereditary(&self.chi, t);
        self.profile.radius(&(hereditary / self.stiffness()))
    }

    /// π m/4.
    fn stiffness(&self) -> Real {
        pi() * &self.m / whole(4)
    }

    /// The first time at which the contact covers r.
    ///
    /// On a piece Y rises by b z + χ F′ z²/2 in the time z from its start, where b = F′ + χ F₀ is the slope of Y.
    ///
    /// # Panics
    ///
    /// If it never does.
    fn time_of_covering(&self, r: &Real) -> Real {
        let wanted = self.stiffness() * self.profile.load_integral(r);
        for (index, piece) in self.pieces.iter().enumerate() {
            let missing = &wanted - piece.hereditary(&self.chi, &piece.start);
            if missing <= Real::ZERO {
                return piece.start.clone();
            }
            let slope = &piece.rate + &self.chi * &piece.force;
            let radicand = &slope * &slope + whole(2) * &self.chi * &piece.rate * &missing;
            if radicand >= Real::ZERO && slope > Real::ZERO {
                let time = &piece.start + whole(2) * missing / (slope + radicand.sqrt());
                if self.pieces.get(index + 1).is_none_or(|next| time < next.start) {
                    return time;
                }
            }
        }
        unreachable!("the contact never covers {r}")
    }

    /// Times between which the memory integrand is smooth and fades by 20 e-foldings at most; among them are the knots
    /// and the times in `covered`, at which a radius begins to count.
    ///
    /// Contributions older than 140 e-foldings are below 1e-60 of G(a(t), r) and left out.
    fn panels(&self, covered: &[Real], last: &Real) -> Vec<Real> {
        let Some(first) = covered.iter().min().filter(|_| self.chi > Real::ZERO) else { return Vec::new() };
        let fading = |folds: i64| last - whole(folds) / &self.chi;
        let first = first.clone().max(fading(140));
        let knots = self.pieces.iter().map(|piece| piece.start.clone());
        let fadings = (1..7).map(|count| fading(20 * count));
        let mut borders: Vec<Real> = knots.chain(fadings).chain(covered.iter().cloned()).collect();
        borders.retain(|border| *border > first && border < last);
        borders.extend([first, last.clone()]);
        borders.sort();
        borders.dedup();
        borders
    }
}
