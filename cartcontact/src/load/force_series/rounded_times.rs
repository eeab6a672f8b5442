//! Interpolation of forces at times that are rounded.
//!
//! After a long history neighbouring times are no small share of a step apart: the forces belong to places beside the
//! nodes. Where a node ξ is later than its rounded time by s, and v is the force then, f(ξ) = v + s f′(ξ) to first order
//! in s; the polynomial f is found by iteration.

use super::chebyshev::{Coefficients, DEGREE, abscissa, derivative, interpolate, left_out, sums_at};
use crate::Scalar;

/// The history is long if it is so many times as long as a step. In shorter ones the places of the nodes are rounded by
/// less than 2⁻³⁸ of the step, in single precision 2⁻⁹, which changes no pressure by more than rounding.
const LONG_HISTORY: f64 = 16_384.0;

/// Each round leaves a share of the error of up to N² s, the slope per value times the shift: a hundredth in a step of
/// 50 000 numbers. A smooth force has smaller slopes, so that shorter steps have few digits to lose, too.
const ROUNDS: usize = 8;

/// In a step of so many numbers or fewer, several nodes share a time. Between its ends the force is taken for straight:
/// what it does in between may as well be the rounding of its argument.
const FEW_NUMBERS: f64 = 32.0;

/// The polynomial through values at the rounded times of the nodes of a step, and what the polynomial through them at
/// the nodes themselves [leaves out](left_out).
pub(super) fn interpolate_at_rounded<T: Scalar>(
    values: &Coefficients<T>,
    times: &Coefficients<T>,
) -> (Coefficients<T>, T) {
    let at_nodes = interpolate(values);
    let rest = left_out(&at_nodes);
    let (start, end) = (times[DEGREE], times[0]);
    if end < (end - start) * T::constant(LONG_HISTORY) {
        return (at_nodes, rest);
    }
    if end - start <= end * T::default_epsilon() * T::constant(FEW_NUMBERS) {
        return (line_between_ends(values), T::zero());
    }
    let shifts = shifts_by_rounding(times);
    let mut shifted = at_nodes;
    for _ in 0..ROUNDS {
        let slope = derivative(&shifted);
        shifted = interpolate(&core::array::from_fn(|place| {
            let [slope] = sums_at([&slope], abscissa(place));
            values[place] + slope * shifts[place]
        }));
    }
    // Jumps, and forces that are all rounding, are no smoother at other places; nor is a sum that grows.
    (if left_out(&shifted) * T::constant(8.0) < rest { shifted } else { at_nodes }, rest)
}

fn line_between_ends<T: Scalar>(values: &Coefficients<T>) -> Coefficients<T> {
    let (end, start) = (values[0], values[DEGREE]);
    let mut line = [T::zero(); DEGREE + 1];
    [line[0], line[1]] = [end + start, end - start].map(|c| c * T::constant(0.5));
    line
}

/// By how much each node is later than its rounded time, in ξ.
fn shifts_by_rounding<T: Scalar>(times: &Coefficients<T>) -> Coefficients<T> {
    let (start, end) = (times[DEGREE], times[0]);
    let half = (end - start) * T::constant(0.5);
    core::array::from_fn(|place| ((end - times[place]) - half * (T::one() - abscissa(place))) / half)
}

#[cfg(test)]
mod tests {
    use crate::load::Load;
    use crate::load::force_series::{DEGREE, ForceSeries};

    /// A force that rises from a time on, with a slight curvature.
    struct Late(f64);

    impl Load<f64> for Late {
        fn force(&self, t: f64) -> f64 {
            let since = t - self.0;
            since + since * since / 1024.0
        }
        fn impulse(&self, t: f64) -> f64 {
            let since = t - self.0;
            since * since * (0.5 + since / 3072.0)
        }
    }

    /// Numbers near 1e8 are 1.5e-8 apart, so that the nodes of these steps are rounded by up to 1e-8 and 5e-5 of them.
    #[test]
    fn rounded_times_leave_digits() {
        for duration in [0.75, 2.0_f64.powi(-12)] {
            let start = 1e8;
            let series = ForceSeries::between(&Late(start), (start, start + duration), 0.02);
            // F − F(1) = −d (1 − ξ)/2 − d²/1024 (1 − ((1 + ξ)/2)²).
            let [d, square] = [duration, duration * duration / 1024.0];
            let mut exact = [0.0; DEGREE + 1];
            exact[..3].copy_from_slice(&[
                -d / 2.0 - square * 5.0 / 8.0,
                d / 2.0 + square / 2.0,
                square / 8.0,
            ]);
            for (c, exact) in series.variation.iter().zip(exact) {
                assert!((c - exact).abs() < 8.0 * f64::EPSILON * d, "{c}, {exact} in {duration}");
            }
        }
    }

    #[test]
    fn steps_of_few_numbers_are_straight() {
        let start = 1e8;
        let end = start + 4.0 * f64::EPSILON * start;
        let series = ForceSeries::between(&Late(start), (start, end), 0.02);
        let [last, first] = [series.last(), series.forces[ForceSeries::<f64>::START]];
        assert_eq!(series.variation[..3], [(first - last) * 0.5, (last - first) * 0.5, 0.0]);
    }
}
