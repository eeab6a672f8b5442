//! What the library must accept, so that refusing it is a fault.

use super::precision::Precision;
use super::scene::Scene;
use super::wide::Wide;

/// Whether the coefficients have all their digits, and are not all zero.
pub(super) fn is_geometry<T: Precision>(terms: &[(T, T)]) -> bool {
    let has_digits = terms.iter().all(|(c, n)| {
        let least = T::LEAST * (n.value() + 2.0).powi(2) / n.value().min(1.0) * 2.0;
        c.is_finite() && (c.is_zero() || c.value().abs() >= least)
    });
    has_digits && terms.iter().any(|(c, _)| !c.is_zero())
}

/// Whether a contact can be made of the geometry, the constants of the medium and the load.
pub(super) fn is_contact<T: Precision>(scene: &Scene<T>) -> bool {
    let is_normal = |x: T| x.is_finite() && x.value() >= T::LEAST;
    let is_medium = is_normal(scene.m) && (scene.chi.is_zero() || is_normal(scene.chi));
    is_geometry(&scene.terms) && is_medium && is_load(&scene.knots)
}

/// Whether knots are finite and in order from 0, at most two of them at one time, with forces that are not negative and
/// slopes whose double the format holds.
fn is_load<T: Precision>(knots: &[(T, T)]) -> bool {
    let are_numbers =
        knots.iter().all(|(t, force)| t.is_finite() && force.is_finite() && *force >= T::zero());
    let begins = knots.first().is_some_and(|knot| knot.0.is_zero());
    let is_sorted = knots.is_sorted_by(|knot, next| knot.0 <= next.0);
    are_numbers && begins && is_sorted && knots.windows(3).all(|knots| knots[0].0 < knots[2].0) && {
        knots.windows(2).all(|pair| pair[0].0 == pair[1].0 || is_slope(pair[0], pair[1]))
    }
}

/// Whether twice a slope is in range, however it is rounded.
fn is_slope<T: Precision>(start: (T, T), end: (T, T)) -> bool {
    let [start_time, start, end_time, end] = [start.0, start.1, end.0, end.1].map(|x| Wide::of(x.value()));
    let slope = (end - start).abs() / (end_time - start_time);
    slope.scaled(1).value() <= T::MOST * (1.0 - 8.0 * T::EPSILON)
}

#[cfg(test)]
mod tests {
    use cartcontact::load::PiecewiseLinear;

    use super::*;

    #[test]
    fn what_is_a_load_is_accepted_and_nothing_else() {
        let loads: [(bool, &[(f64, f64)]); 12] = [
            (true, &[(0.0, 100.0)]),
            (true, &[(0.0, 0.0), (0.0, 1e300), (5.0, 5e-324), (5.0, 0.0)]),
            (true, &[(0.0, 0.0), (1e-300, 8e7)]),
            (false, &[]),
            (false, &[(1.0, 100.0)]),
            (false, &[(0.0, -1e-300)]),
            (false, &[(0.0, f64::NAN)]),
            (false, &[(0.0, 1.0), (f64::INFINITY, 1.0)]),
            (false, &[(0.0, 1.0), (2.0, 1.0), (1.0, 1.0)]),
            (false, &[(0.0, 1.0), (0.0, 2.0), (0.0, 3.0)]),
            (false, &[(0.0, 0.0), (1e-300, 1e8)]),
            (false, &[(0.0, 0.0), (5e-324, 1.0)]),
        ];
        for (is_good, knots) in loads {
            assert_eq!(is_load(knots), is_good, "{knots:?}");
            assert_eq!(PiecewiseLinear::new(knots).is_ok(), is_good, "{knots:?}");
        }
    }
}
