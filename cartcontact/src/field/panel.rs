//! The changes of all rows over a short time, from eight contact radii.
//!
//! Under a load that is straight from t₁ on, Eq. (28) integrated by parts over time reads, for radii r
//! covered at t₁,
//!
//! ```text
//! P(r, t) = e^(−χ (t − t₁)) [P(r, t₁) + ∫ q(τ) (a²(τ) − r²) dτ],    q(τ) = (2/π) Y′(τ)/a⁴(τ) · e^(χ (τ − t₁))
//! ```
//!
//! over τ from t₁ to t. For radii covered later it is the same from the time on at which the edge passes r. Here q and
//! q (a² − a₁²), with a₁ = a(t₁), are smooth functions of time alone. Over a short time they are polynomials of degree
//! 7 to full accuracy, found once from their values at the Chebyshev nodes, and a Gauss rule of four nodes integrates
//! them exactly between any two times.
//!
//! **When a panel is short enough** is read off the polynomials: their Chebyshev coefficients fall geometrically, so
//! the last two of the eight bound what is cut off. And χ times its duration is at most 1/8, so that e^(−x) − 1 is ten
//! terms of its series.
//!
//! **Accuracy.** The time is known exactly, so the rounding of radii enters only through a⁻⁴ and a² − r², and the
//! powers of the geometry do not multiply it.

use super::BLOCK;
use super::sweep::Changes;
use crate::Scalar;
use crate::contact::Contact;
use crate::dispatch::wide;
use crate::load::Load;
use crate::memory::{Edge, FEW_FOLDS, Line, decay_gain, not_negative};
use crate::numbers::cosines::cosine_of_sixteenths;
use crate::numbers::tabled::{Tabled, tabled};
use crate::profile::GapProfile;
use crate::quadrature::NODES_4;
use crate::scalar::smallest_normal;

/// The positive roots of the Chebyshev polynomial T₈.
const NODES: [f64; 4] =
    [cosine_of_sixteenths(1), cosine_of_sixteenths(3), cosine_of_sixteenths(5), cosine_of_sixteenths(7)];
/// The nodes, their squares and their reciprocals, in both formats.
const TABLED_NODES: [Tabled; 4] = tabled(NODES);
const SQUARES: [Tabled; 4] = {
    let [n0, n1, n2, n3] = NODES;
    tabled([n0 * n0, n1 * n1, n2 * n2, n3 * n3])
};
const PER_NODE: [Tabled; 4] = {
    let [n0, n1, n2, n3] = NODES;
    tabled([1.0 / n0, 1.0 / n1, 1.0 / n2, 1.0 / n3])
};

/// The positive nodes of the Gauss-Legendre rule of four nodes, with their weights.
const PAIRS: [[Tabled; 2]; 2] = {
    let [(inner, of_inner), (outer, of_outer)] = NODES_4;
    [tabled([inner, of_inner]), tabled([outer, of_outer])]
};

/// By how much q may have faded at the end of a panel from what it is in the middle.
///
/// What interpolation rounds is a share of q in the middle, but a radius that the edge passes last has a pressure in
/// proportion to q at the end, which vanishes where a load stops falling as fast as it may.
const LARGEST_FADING: f64 = 8.0;

/// A period from `start` on during which pressures change like polynomials of time.
pub(super) struct Panel<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    start: Edge<T>,
    /// Reciprocal of half the duration.
    scale: T,
    /// q of the module documentation, and q (a² − a₁²), times half the duration.
    slope: Interpolant<T>,
    offset: Interpolant<T>,
    /// F′.
    force_rate: T,
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Panel<'a, T, P, L> {
    /// The longest panel from `start` to one of `times`, before which a straight load has no knot, and how many of them
    /// it reaches.
    ///
    /// Each attempt takes three quarters of the times of the one before. A march takes less time than a panel for a
    /// single row.
    pub(super) fn over(contact: &'a Contact<T, P, L>, start: Edge<T>, times: &[T]) -> Option<(Self, usize)> {
        let mut count = times.len();
        while count > 1 {
            if let Some(panel) = Self::until(contact, start, times[count - 1]) {
                return Some((panel, count));
            }
            count = count * 3 / 4;
        }
        None
    }

    /// The panel up to a time, before any knot of the load, if it is short enough.
    fn until(contact: &'a Contact<T, P, L>, start: Edge<T>, end: T) -> Option<Self> {
        let (load, chi) = (contact.load(), contact.medium().chi());
        let duration = end - start.time;
        let half = duration * T::constant(0.5);
        // The reciprocal of a subnormal number may overflow.
        if !(half >= smallest_normal() && chi * duration <= T::constant(FEW_FOLDS)) {
            return None;
        }
        let force = load.force(start.time);
        let rise = load.force_before(end) - force;
        let force_rate = rise / duration;
        if !rise.is_zero() && force_rate.abs() < smallest_normal() {
            return None;
        }
        let hereditary = force + chi * load.impulse(start.time);
        // q and q (a² − a₁²) at the time z after the start.
        let densities = |x: T| {
            let z = half * (T::one() + x);
            let gain = z * (force_rate + chi * (force + T::constant(0.5) * force_rate * z));
            let a = contact.radius_under_hereditary(hereditary + gain).ok()?;
            // Of a load that falls as fast as it may this is rounding, which may be negative: raised to zero it would
            // add up.
            let rate = force_rate + chi * (force + force_rate * z);
            let square = a * a;
            let growth = (T::one() + decay_gain(chi * z)) * square * square;
            let slope = T::frac_2_pi() * half * rate / growth;
            Some((slope, slope * ((a - start.radius) * (a + start.radius))))
        };
        let mut slopes = [(T::zero(), T::zero()); 4];
        let mut offsets = slopes;
        for (k, node) in TABLED_NODES.into_iter().enumerate() {
            let node: T = node.get();
            let (below, above) = (densities(-node)?, densities(node)?);
            slopes[k] = (below.0, above.0);
            offsets[k] = (below.1, above.1);
        }
        let (slope, offset) = (Interpolant::through(slopes), Interpolant::through(offsets));
        let size = slope.size();
        let resolved = slope.is_resolved(size) && offset.is_resolved(size * start.radius * start.radius);
        let lasts = slope.at(T::one()) * T::constant(LARGEST_FADING) >= size;
        (resolved && lasts).then(|| Self { contact, start, scale: half.recip(), slope, offset, force_rate })
    }

    /// The changes at `times`: from the time before (the first from the start), and from the start.
    pub(super) fn changes(&self, times: &[T], since_previous: &mut Changes<T>, since_start: &mut Changes<T>) {
        let (mut elapsed, mut durations) = ([T::zero(); BLOCK], [T::zero(); BLOCK]);
        let (elapsed, durations) = (&mut elapsed[..times.len()], &mut durations[..times.len()]);
        let mut previous = self.start.time;
        for ((elapsed, duration), &time) in elapsed.iter_mut().zip(&mut *durations).zip(times) {
            (*elapsed, *duration) = (time - self.start.time, time - previous);
            previous = time;
        }
        since_previous.slow_down();
        since_start.slow_down();
        wide(
            #[inline(always)]
            || self.integrate_steps(elapsed, durations, since_previous),
        );
        since_start.add_up(since_previous, times.len());
        wide(
            #[inline(always)]
            || self.fade(elapsed, since_previous, since_start),
        );
    }

    /// The changes of steps from row to row, before [`fade`](Self::fade).
    #[inline(always)]
    fn integrate_steps(&self, elapsed: &[T], durations: &[T], changes: &mut Changes<T>) {
        let (chi, square) = (self.contact.medium().chi(), self.start.radius * self.start.radius);
        for (row, (&elapsed, &duration)) in elapsed.iter().zip(durations).enumerate() {
            let (offset, slope) = self.integrals(elapsed, duration);
            changes.gain[row] = decay_gain(chi * duration);
            changes.on_axis[row] = offset + slope * square;
            changes.slope[row] = slope;
        }
    }

    /// Multiplies the integrals up to each time t by e^(−χ (t − t₁)).
    #[inline(always)]
    fn fade(&self, elapsed: &[T], since_previous: &mut Changes<T>, since_start: &mut Changes<T>) {
        let chi = self.contact.medium().chi();
        for (row, &elapsed) in elapsed.iter().enumerate() {
            let gain = decay_gain(chi * elapsed);
            since_start.gain[row] = gain;
            for changes in [&mut *since_previous, &mut *since_start] {
                changes.on_axis[row] += gain * changes.on_axis[row];
                changes.slope[row] += gain * changes.slope[row];
            }
        }
    }

    /// The pressure at a radius that the edge passes between two times of the panel.
    pub(super) fn first_pressure(&self, before: Edge<T>, now: Edge<T>, r: T) -> T {
        let (contact, chi) = (self.contact, self.contact.medium().chi());
        let deficit =
            contact.load_per_integral() * contact.profile().load_integral_drop(now.radius, now.radius - r);
        let (elapsed, duration) = (now.time - self.start.time, now.time - before.time);
        let force = contact.load().force_before(now.time);
        let line = Line::to(force, self.force_rate * duration, chi * duration);
        let (offset, slope) = self.integrals(elapsed, duration * line.age(deficit).min(T::one()));
        let faded = T::one() + decay_gain(chi * elapsed);
        not_negative(faded * (offset - slope * ((r - self.start.radius) * (r + self.start.radius))))
    }

    /// The integrals of `offset` and `slope` over a duration that ends when `elapsed` has passed since the start.
    #[inline(always)]
    fn integrals(&self, elapsed: T, duration: T) -> (T, T) {
        let half = duration * self.scale * T::constant(0.5);
        let middle = elapsed * self.scale - T::one() - half;
        let mut sums = (T::zero(), T::zero());
        for pair in PAIRS {
            let [distance, weight] = pair.map(|number| half * number.get::<T>());
            let (below, above) = (middle - distance, middle + distance);
            sums.0 += weight * (self.offset.at(below) + self.offset.at(above));
            sums.1 += weight * (self.slope.at(below) + self.slope.at(above));
        }
        sums
    }
}

/// A polynomial of degree 7 on [−1, 1]: its even part and its odd part over x, as cubics in x² in Newton's
/// form on the squares of [`NODES`].
#[derive(Clone, Copy, Debug)]
struct Interpolant<T> {
    even: [T; 4],
    odd: [T; 4],
}

impl<T: Scalar> Interpolant<T> {
    /// The polynomial with the values (f(−x), f(x)) at the [`NODES`] x.
    fn through(values: [(T, T); 4]) -> Self {
        let half = T::constant(0.5);
        let (mut even, mut odd) = ([T::zero(); 4], [T::zero(); 4]);
        for (k, (below, above)) in values.into_iter().enumerate() {
            even[k] = half * (above + below);
            odd[k] = half * (above - below) * PER_NODE[k].get::<T>();
        }
        Self { even: divided_differences(even), odd: divided_differences(odd) }
    }

    #[inline(always)]
    fn at(&self, x: T) -> T {
        let square = x * x;
        let [s0, s1, s2] = [0, 1, 2].map(|k| square - SQUARES[k].get::<T>());
        let cubic = |[c0, c1, c2, c3]: [T; 4]| ((c3 * s2 + c2) * s1 + c1) * s0 + c0;
        cubic(self.even) + x * cubic(self.odd)
    }

    /// The size of the value in the middle.
    fn size(&self) -> T {
        self.at(T::zero()).abs()
    }

    /// Whether what is cut off is below the rounding of values of some size.
    ///
    /// The terms of degree 6 and 7 are T₆/32 and T₇/64. Coefficients that fall geometrically from `size` on reach
    /// 1024 ε at degree 6 if, in f64, each is 1/130 of the one before; then the first one left out, of degree 8, is
    /// ε/16. In single precision, where they may fall more slowly, the bound at degree 7 leaves 2 ε; and so it does
    /// wherever they fall more slowly from a smaller value.
    fn is_resolved(&self, size: T) -> bool {
        let (sixth, seventh) =
            (self.even[3] * T::constant(1.0 / 32.0), self.odd[3] * T::constant(1.0 / 64.0));
        let rounding = size * T::default_epsilon();
        sixth.abs() <= rounding * T::constant(1024.0) && seventh.abs() <= rounding * T::constant(8.0)
    }
}

/// The reciprocals of the distances between the square of each node and that of the one, two and three places before
/// it, where there is one.
const PER_DISTANCE: [[Tabled; 4]; 3] = {
    let mut reciprocals = [[Tabled::of(0.0); 4]; 3];
    let mut order = 1;
    while order < 4 {
        let mut k = order;
        while k < 4 {
            let distance = NODES[k] * NODES[k] - NODES[k - order] * NODES[k - order];
            reciprocals[order - 1][k] = Tabled::of(1.0 / distance);
            k += 1;
        }
        order += 1;
    }
    reciprocals
};

/// The coefficients of Newton's form on the squares of [`NODES`].
fn divided_differences<T: Scalar>(mut values: [T; 4]) -> [T; 4] {
    for order in 1..4 {
        for k in (order..4).rev() {
            values[k] = (values[k] - values[k - 1]) * PER_DISTANCE[order - 1][k].get::<T>();
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Medium, Polynomial, load};

    #[test]
    fn polynomials_up_to_degree_7_are_exact() {
        let f = |x: f64| 1.0 + x * (0.5 + x * (-0.25 + x * x * x * (0.125 - 0.0625 * x * x)));
        let polynomial = Interpolant::through(NODES.map(|x| (f(-x), f(x))));
        for k in -50..=50 {
            let x = f64::from(k) / 50.0;
            assert!((polynomial.at(x) - f(x)).abs() < 4.0 * f64::EPSILON, "{x}");
        }
    }

    #[test]
    fn a_polynomial_knows_when_it_falls_short() {
        let exponential = |c: f64| Interpolant::through(NODES.map(|x| ((-c * x).exp(), (c * x).exp())));
        // The first coefficient left out, 2 I₈(c), is 1e-19 for c = 0.03 and 8e-16 for c = 0.09.
        assert!(exponential(0.03).is_resolved(1.0));
        assert!(!exponential(0.09).is_resolved(1.0));
        assert!(!exponential(f64::NAN).is_resolved(1.0));
        // Either part alone.
        assert!(!Interpolant::through(NODES.map(|x| (x.cosh(), x.cosh()))).is_resolved(1.0));
        assert!(!Interpolant::through(NODES.map(|x| (-x.sinh(), x.sinh()))).is_resolved(1.0));
    }

    /// The changes computed with wide vectors, beside the same arithmetic row by row.
    fn check<T: Scalar>() -> Option<()> {
        let medium = Medium::from_constants(T::constant(0.375), T::constant(0.0015)).ok()?;
        let gap = Polynomial::new([(T::constant(0.025), T::constant(2.0))]).ok()?;
        let contact = Contact::new(gap, medium, load::Constant(T::constant(100.0))).ok()?;
        let time = T::constant(10.0);
        let start = Edge { time, radius: contact.radius_at(time).ok()? };
        let times = [10.5, 10.5, 11.0, 12.0, 12.25, 12.5, 13.0, 14.0, 15.0, 15.5, 16.0].map(T::constant);
        let (panel, count) = Panel::over(&contact, start, &times)?;
        assert_eq!(count, times.len());
        let (mut since_previous, mut since_start) = (Changes::none(), Changes::none());
        panel.changes(&times, &mut since_previous, &mut since_start);
        let mut previous = time;
        for (row, &now) in times.iter().enumerate() {
            let (offset, slope) = panel.integrals(now - time, now - previous);
            let gain = decay_gain(medium.chi() * (now - time));
            let on_axis = offset + slope * (start.radius * start.radius);
            assert!(since_start.gain[row] == gain);
            assert!(since_previous.gain[row] == decay_gain(medium.chi() * (now - previous)));
            assert!(since_previous.slope[row] == slope + gain * slope);
            assert!(since_previous.on_axis[row] == on_axis + gain * on_axis);
            previous = now;
        }
        Some(())
    }

    #[test]
    fn wide_vectors_change_no_bit() {
        assert!(check::<f64>().is_some());
        assert!(check::<f32>().is_some());
    }
}
