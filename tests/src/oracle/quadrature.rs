//! Integrals to more than 40 digits by the double-exponential rule.
//!
//! With x = low + (high − low)/(1 + e^(−π sinh u)) the integrand falls off doubly exponentially in u, whatever power
//! or logarithm it begins with at the ends, and the trapezoidal rule converges geometrically: halving its
//! step doubles the digits that are right.
//!
//! **Error.** Steps are halved until two results differ by less than the tolerance. The difference is the error of the
//! last result but one; the last has about twice as many digits right.
//!
//! Source: H. Takahasi and M. Mori, "Double exponential formulas for numerical integration", Publ. RIMS 9 (1974),
//! doi 10.2977/prims/1195192451.

use std::sync::OnceLock;

use super::number::{BITS, Real, pi, size, whole};

/// The step of the finest level is 2^−9; no integrand here needs more than 2^−6.
const LEVELS: usize = 10;

/// A node near an end of the unit interval; its mirror image is a node too.
struct Node {
    /// The distance to the end.
    inset: Real,
    weight: Real,
}

/// The nodes that level k, with the step 2^−k, adds to those of the levels before.
fn level(k: usize) -> &'static [Node] {
    static NODES: [OnceLock<Vec<Node>>; LEVELS] = [const { OnceLock::new() }; LEVELS];
    NODES[k].get_or_init(|| {
        let pi = pi();
        let step = whole(1) / whole(1 << k);
        let (first, stride) = if k == 0 { (0, 1) } else { (1, 2) };
        let node = |index: i64| {
            let rise = (&step * whole(index)).exp();
            let fall = whole(1) / &rise;
            let growth = (&pi * (&rise - &fall) / whole(2)).exp();
            let inset = whole(1) / (whole(1) + growth);
            let weight = &pi * (rise + fall) / whole(2) * &inset * (whole(1) - &inset);
            Node { inset, weight }
        };
        let least = whole(1) >> BITS as isize;
        (first..).step_by(stride).map(node).take_while(|node| node.inset > least).collect()
    })
}

/// The integrals of several functions from `low` to `high`, to `tolerance` relative to those of their absolute values.
///
/// # Panics
///
/// If they do not converge.
pub fn integrate<const N: usize>(
    low: &Real,
    high: &Real,
    tolerance: &Real,
    integrand: impl Fn(&Real) -> [Real; N],
) -> [Real; N] {
    let length = high - low;
    let mut sums = [const { Real::ZERO }; N].map(|zero| zero.with_precision(BITS).value());
    let mut sizes = sums.clone();
    let mut before: Option<[Real; N]> = None;
    for k in 0..LEVELS {
        for (index, node) in level(k).iter().enumerate() {
            let mut add = |x: &Real| {
                for (i, value) in integrand(x).into_iter().enumerate() {
                    let share = value * &node.weight;
                    sums[i] += &share;
                    sizes[i] += size(share);
                }
            };
            let inset = &length * &node.inset;
            add(&(low + &inset));
            if k > 0 || index > 0 {
                add(&(high - &inset));
            }
        }
        let step = &length / whole(1 << k);
        let results = sums.clone().map(|sum| sum * &step);
        let agree = before.is_some_and(|before| {
            let differences = before.iter().zip(&results).map(|(x, y)| size(x - y));
            differences.zip(&sizes).all(|(difference, of_sizes)| difference <= tolerance * (of_sizes * &step))
        });
        if agree {
            return results;
        }
        before = Some(results);
    }
    unreachable!("no convergence between {low} and {high}")
}

#[cfg(test)]
mod tests {
    use super::super::number::decimal;
    use super::*;

    #[test]
    fn powers_and_logarithms_are_integrated() {
        // ∫ x^(1/2) dx = 2/3, ∫ −ln x dx = 1, ∫ e^(−50 x) dx = (1 − e^(−50))/50.
        let tolerance = decimal("1e-45");
        let found =
            integrate(&whole(0), &whole(1), &tolerance, |x| [x.sqrt(), -x.ln(), (whole(-50) * x).exp()]);
        let expected = [whole(2) / whole(3), whole(1), (whole(1) - whole(-50).exp()) / whole(50)];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(size(found / expected - whole(1)) < tolerance);
        }
    }
}
