//! A load history in 31 digits, and the pressure that it leaves.

use std::sync::OnceLock;

use super::exact::Profile;
use super::wide::Wide;

/// Everything that a contact is made of, exactly as given.
#[derive(Clone, Debug)]
pub(super) struct History {
    /// The geometry.
    pub(super) profile: Profile,
    m: Wide,
    chi: Wide,
    knots: Vec<(Wide, Wide)>,
}

/// A straight stretch of the load, or a jump if it takes no time.
struct Piece {
    start: Wide,
    end: Wide,
    /// F at both ends.
    forces: (Wide, Wide),
    /// χ ∫F up to the start.
    drained: Wide,
}

impl Piece {
    fn force_rate(&self) -> Wide {
        (self.forces.1 - self.forces.0) / (self.end - self.start)
    }

    /// Y at the time `x` after the start.
    fn hereditary(&self, chi: Wide, x: Wide) -> Wide {
        if (self.end - self.start).is_zero() {
            return self.forces.1 + self.drained;
        }
        let rate = self.force_rate();
        let mean = self.forces.0 + (rate * x).scaled(-1);
        self.forces.0 + rate * x + self.drained + chi * x * mean
    }
}

impl History {
    /// The contact of a geometry in a medium under a load through knots.
    pub(super) fn new(profile: Profile, (m, chi): (f64, f64), knots: &[(f64, f64)]) -> Self {
        let knots = knots.iter().map(|&(t, force)| (Wide::of(t), Wide::of(force))).collect();
        Self { profile, m: Wide::of(m), chi: Wide::of(chi), knots }
    }

    /// π m/4.
    pub(super) fn stiffness(&self) -> Wide {
        self.m * Wide::FRAC_PI_4
    }

    /// F(t).
    pub(super) fn force(&self, time: Wide) -> Wide {
        self.pieces(time).last().map_or(Wide::ZERO, |piece| piece.forces.1)
    }

    /// Y(t) = F + χ ∫F.
    pub(super) fn hereditary(&self, time: Wide) -> Wide {
        let last = self.pieces(time).pop();
        last.map_or(Wide::ZERO, |piece| piece.hereditary(self.chi, piece.end - piece.start))
    }

    /// The relative error of pressures: what still counts was laid while J grew by F/Y of itself, and J has an error of
    /// 2^-100.
    pub(super) fn precision(&self, time: Wide) -> f64 {
        (self.hereditary(time) / self.force(time)).scaled(-100).value()
    }

    /// m G(a, r).
    pub(super) fn undrained_pressure(&self, a: Wide, r: Wide) -> Wide {
        if r.is_below(a) { self.m * self.profile.pressure_kernel(a, r).value } else { Wide::ZERO }
    }

    /// The load up to a time; the first piece is the jump at 0.
    fn pieces(&self, time: Wide) -> Vec<Piece> {
        let Some(&(start, first)) = self.knots.first() else { return Vec::new() };
        let mut pieces = vec![Piece { start, end: start, forces: (Wide::ZERO, first), drained: Wide::ZERO }];
        let mut drained = Wide::ZERO;
        for (index, &(start, before)) in self.knots.iter().enumerate() {
            let next = self.knots.get(index + 1).copied();
            if time.is_below(start) {
                break;
            }
            let (knot, force) = next.unwrap_or((time, before));
            let (end, after) = if time.is_below(knot) {
                (time, before + (force - before) * (time - start) / (knot - start))
            } else {
                (knot, force)
            };
            if next.is_some() || start.is_below(end) {
                pieces.push(Piece { start, end, forces: (before, after), drained });
            }
            drained = drained + (self.chi * (end - start) * (before + after)).scaled(-1);
            if time.is_below(knot) {
                break;
            }
        }
        pieces
    }

    /// P(r, t) where the radius at `time` is `a`:
    ///
    /// ```text
    /// P(r, t) = (m/4) ∫ᵣᵃ δ₀′(s) (s² − r²) e^(−χ (t − τ(s))) ds
    /// ```
    ///
    /// where a jump of the load contributes the change of m G; none if a radius of the history cannot be found.
    pub(super) fn pressure(&self, time: Wide, a: Wide, r: Wide) -> Option<Wide> {
        let mut sum = Wide::ZERO;
        let mut before = Wide::ZERO;
        let pieces = self.pieces(time);
        let count = pieces.len();
        for (index, piece) in pieces.into_iter().enumerate() {
            let faded = (self.chi * (time - piece.end)).value();
            let after = if index + 1 == count {
                a
            } else {
                self.radius_under(piece.hereditary(self.chi, piece.end - piece.start), a)?
            };
            if faded < 100.0 && r.is_below(after) {
                let decay = (-(self.chi * (time - piece.end))).exp();
                let share = if (piece.end - piece.start).is_zero() {
                    self.undrained_pressure(after, r) - self.undrained_pressure(before, r)
                } else {
                    self.of_straight_piece(&piece, (before, after), r)?
                };
                sum = sum + decay * share;
            }
            before = after;
        }
        Some(sum)
    }

    fn radius_under(&self, hereditary: Wide, estimate: Wide) -> Option<Wide> {
        if !hereditary.is_positive() {
            return Some(Wide::ZERO);
        }
        self.profile.radius(hereditary / self.stiffness(), estimate)
    }

    /// The pressure that a straight piece between two radii leaves at its end.
    fn of_straight_piece(&self, piece: &Piece, (before, after): (Wide, Wide), r: Wide) -> Option<Wide> {
        // Contributions older than 100 e-foldings do not count; integrating them would waste nodes.
        let duration = piece.end - piece.start;
        let kept = if self.chi.is_positive() { duration.min(Wide::of(100.0) / self.chi) } else { duration };
        let oldest = if kept.is_below(duration) {
            self.radius_under(piece.hereditary(self.chi, duration - kept), after)?
        } else {
            before
        };
        let low = oldest.max(r);
        if !low.is_below(after) {
            return Some(Wide::ZERO);
        }
        let (chi, stiffness) = (self.chi, self.stiffness());
        let start = piece.hereditary(chi, Wide::ZERO);
        let (force_rate, rate) = (piece.force_rate(), piece.force_rate() + chi * piece.forces.0);
        let overlap = low - r;
        let integral = graded(after - low, |height| {
            let s = low + height;
            let here = self.profile.kernels(s);
            // Y(τ) − Y(start) = rate x + χ F′ x²/2, solved for x = τ − start.
            let rise = stiffness * here.load_integral.value - start;
            let root = (rate * rate + (chi * force_rate * rise).scaled(1)).max(Wide::ZERO).sqrt();
            let x = if (rate + root).is_positive() { rise.scaled(1) / (rate + root) } else { Wide::ZERO };
            let age = duration - x.min(duration).max(Wide::ZERO);
            here.approach_slope.value * ((overlap + height) * (s + r)) * (-(chi * age)).exp()
        });
        Some((self.m * integral).scaled(-2))
    }
}

/// ∫₀^length by Gauss–Legendre rules on panels that halve towards both ends.
///
/// Next to an end, where the integrand is a power of the distance, a panel is as long as its distance from the end, and
/// 16 nodes leave an error of 5.8^-32; the innermost panel, 2^-36 of the length, leaves less for roots of the distance.
fn graded(length: Wide, integrand: impl Fn(Wide) -> Wide) -> Wide {
    const PANELS: i64 = 36;
    let panel = |from: Wide, to: Wide| {
        let (middle, half) = ((from + to).scaled(-1), (to - from).scaled(-1));
        nodes().iter().fold(Wide::ZERO, |sum, &(node, weight)| {
            let offset = half * node;
            sum + weight * half * (integrand(middle - offset) + integrand(middle + offset))
        })
    };
    let mut sum = Wide::ZERO;
    for index in 1..=PANELS {
        let outer = length.scaled(-index);
        let inner = if index == PANELS { Wide::ZERO } else { outer.scaled(-1) };
        sum = sum + panel(inner, outer) + panel(length - outer, length - inner);
    }
    sum
}

/// The positive nodes of the 16-node rule and their weights, by Newton's method on the Legendre polynomial.
fn nodes() -> &'static [(Wide, Wide); 8] {
    static NODES: OnceLock<[(Wide, Wide); 8]> = OnceLock::new();
    NODES.get_or_init(|| {
        core::array::from_fn(|index| {
            let mut x = Wide::of((core::f64::consts::PI * (index as f64 + 0.75) / 16.5).cos());
            for _ in 0..5 {
                let (value, slope) = legendre(x);
                x = x - value / slope;
            }
            let slope = legendre(x).1;
            (x, Wide::of(2.0) / ((Wide::ONE - x * x) * slope * slope))
        })
    })
}

/// The Legendre polynomial of degree 16 and its slope.
fn legendre(x: Wide) -> (Wide, Wide) {
    let (mut before, mut now) = (Wide::ONE, x);
    for k in 2..=16 {
        let k = f64::from(k);
        let next = (Wide::of(2.0 * k - 1.0) * x * now - Wide::of(k - 1.0) * before) / Wide::of(k);
        (before, now) = (now, next);
    }
    (now, Wide::of(16.0) * (x * now - before) / (x * x - Wide::ONE))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_at_both_ends_are_integrated() {
        let integral = graded(Wide::ONE, |x| (x * (Wide::ONE - x)).sqrt());
        assert!(
            (integral.value() / (core::f64::consts::PI / 8.0) - 1.0).abs() < 3e-16,
            "{:e}",
            integral.value()
        );
    }

    #[test]
    fn pressures_are_those_of_the_reference() {
        for row in crate::reference::contacts().into_iter().step_by(7) {
            let history = History::new(Profile::new(row.case.exact_terms()), (row.m, row.chi), &row.knots);
            let (t, r) = (Wide::of(row.t), Wide::of(row.r));
            let y = history.hereditary(t) / history.stiffness();
            let a = history.profile.radius(y, Wide::of(row.radius.nearest)).unwrap_or(Wide::ZERO);
            assert_eq!(a.value(), row.radius.nearest, "{row:?}");
            for (r, expected) in [(r, row.pressure.nearest), (Wide::ZERO, row.peak_pressure.nearest)] {
                let found = history.pressure(t, a, r).map_or(f64::NAN, Wide::value);
                assert!((found / expected - 1.0).abs() < 3e-16, "{found:e} {row:?}");
            }
        }
    }
}
