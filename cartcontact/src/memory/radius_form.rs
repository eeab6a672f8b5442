//! The memory integrals over the radius: ∫ δ₀′(s) e^(−χ age(s)) {s² − low², 1} ds.
//!
//! The variable is the depth below the edge: after a long history the integrand is a thin layer there, in
//! which rounded radii would be too coarse. It is taken in panels as long as the finest rule integrates to full
//! accuracy, usually one. What is left below a panel is at most e^(−χ age) (δ₀(s) − δ₀(low)), because ages only
//! grow inwards; the march ends when that no longer counts. For the same reason a panel needs fewer digits by as
//! many e-foldings as it begins below the edge.
//!
//! **Termination.** J is convex, so under a constant load the e-foldings u = χ age are a concave function of the depth,
//! whose slope is below u/depth; the march ends before u is 60. A panel spans 0.6 B/slope at least, see
//! [`continuation`], which is above an eighth of the depth it begins at. Panels are never made shorter than that, for
//! whatever load or rounding, so depths grow like (9/8)^k at least; a first panel without length, from a slope
//! beyond the largest number, is the last one.
//!
//! Under a profile with fractional exponents the innermost quarter, [`increment_of_core`], takes s^(1/4)
//! instead. That makes multiples of 1/4 whole and leaves of other powers s^n a singularity of order
//! 4 (n+2) − 1, at least 7; outside the core the singularity at r = 0 is far enough for any rule.

use super::Increment;
use super::quadrature::{Continuation, Rule, digits, logarithm_from_below};
use super::stretch::Stretch;
use crate::load::Load;
use crate::{GapProfile, Scalar};

pub(super) fn increment<T, P, L>(stretch: &Stretch<'_, T, P, L>) -> Increment<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let (profile, chi) = (stretch.contact.profile(), stretch.contact.medium().chi());
    let (low, high) = (stretch.low, stretch.high);
    let deepest = high - low;
    let core = if profile.is_smooth_at_centre() { deepest } else { deepest.min(high * T::constant(0.75)) };
    let negligible = T::default_epsilon() * T::constant(0.0625);

    let mut sum = Increment::zero();
    let (mut depth, mut age) = (T::zero(), T::zero());
    while depth < core {
        let digits = (digits::<T>() - chi * age).max(T::one());
        let continuation = continuation(stretch, depth, age, core - depth);
        let (end, rule) = match continuation.rule(core - depth, digits) {
            Some(rule) => (core, rule),
            None => (panel_end(&continuation, digits, depth, core), Rule::FINEST),
        };
        add_panel(stretch, rule, (depth, end), &mut sum);
        depth = end;
        if depth < deepest {
            age = stretch.age_at(depth);
            let top = high - depth;
            let rest = (-(chi * age)).exp() * (profile.approach(top) - profile.approach(low));
            let rest_offset = rest * ((top - low) * (top + low));
            if rest <= sum.slope * negligible && rest_offset <= sum.offset * negligible {
                return sum;
            }
        }
    }
    if core < deepest {
        increment_of_core(stretch, high - core, &mut sum);
    }
    sum
}

/// Where the longest panel ends that begins at a depth.
fn panel_end<T: Scalar>(continuation: &Continuation<T>, digits: T, depth: T, core: T) -> T {
    let end = depth + continuation.longest(digits).max(depth * T::constant(0.125));
    // At the core also where rounding has left no panel, or none that is a number.
    if depth < end && end < core { end } else { core }
}

/// Adds the integrals over the depths from `start` to `end`.
fn add_panel<T, P, L>(
    stretch: &Stretch<'_, T, P, L>,
    rule: Rule,
    (start, end): (T, T),
    sum: &mut Increment<T>,
) where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    for (depths, weights) in rule.on(start, end) {
        let densities = stretch.weighted_densities(depths, weights);
        let mut radii = depths;
        for radius in &mut radii {
            *radius = stretch.high - *radius;
        }
        sum.add_eight(densities, radii, stretch.low);
    }
}

/// Adds the radii from `low` to `top`, at most a quarter of the contact radius, in the variable s^(1/4).
fn increment_of_core<T, P, L>(stretch: &Stretch<'_, T, P, L>, top: T, sum: &mut Increment<T>)
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let fourth_root = |s: T| if s.is_zero() { s } else { s.sqrt().sqrt() };
    for (x, weight) in Rule::FINEST.nodes(fourth_root(stretch.low), fourth_root(top)) {
        let cube = x * x * x;
        let s = (cube * x).max(stretch.low);
        let slope = T::constant(4.0) * cube;
        sum.add(weight * slope * stretch.density(stretch.high - s), s, stretch.low);
    }
}

/// How far beyond the edge s of a panel the integrand may be continued.
///
/// Within the distance y s the powers s^(n+1), n being the highest exponent, grow by less than (n+1) y
/// e-foldings. The e-foldings u of the age are at most those of a power s^p with the slope that they have at the
/// edge, p = n + 4: they grow by (K/p)((1 + y)^p − 1), at most (K/p)(e^(p y) − 1), with K = s u′. So y is where
/// either of them reaches a budget B; what the other adds by then follows from convexity.
///
/// The fewest nodes need a B between T/12, for panels over which the integrand hardly changes, and T/3, for those
/// over which it changes by many e-foldings; both minima are flat.
fn continuation<T, P, L>(stretch: &Stretch<'_, T, P, L>, depth: T, age: T, length: T) -> Continuation<T>
where
    T: Scalar,
    P: GapProfile<T>,
    L: Load<T>,
{
    let (highest, one) = (stretch.contact.profile().highest_exponent(), T::one());
    let (powers, degree) = (highest + one, highest + T::constant(4.0));
    let top = stretch.high - depth;
    // One e-folding at least: more room would be of no use, and K may be zero.
    let folds = stretch.relative_slope(depth, age).max(one);
    let (change, digits) = ((folds + powers) * (length / top), digits::<T>());
    let budget =
        (digits * T::constant(1.0 / 12.0) + change * T::constant(0.5)).min(digits * T::constant(1.0 / 3.0));
    let of_age = logarithm_from_below(one + budget * degree / folds) * degree.recip();
    let relative = (budget * powers.recip()).min(of_age);
    Continuation {
        extension: relative * top,
        growth: relative * (powers + budget / of_age),
        clearance: stretch.clearance(depth),
    }
}
