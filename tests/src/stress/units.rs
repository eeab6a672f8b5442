//! One scene in other units.

use cartcontact::load::Load;

use super::examine::{Examination, Now};
use super::finding::{Fault, Tally};
use super::precision::Precision;
use super::scene::{Form, Scene};
use super::solver::{contact, solver};

impl<T: Precision> Examination<'_, T> {
    /// Lengths, forces and times in units that differ by powers of two give the same bits.
    pub(super) fn units(&mut self, now: &Now<'_, '_, T>) {
        // Constant geometries cannot be expressed in other units; with negative terms the end of the range is searched
        // for as the zero of a sum of exponentials of ln r, and rounded as such.
        let is_bound = matches!(self.scene.form, Form::Constant(_))
            || self.scene.terms.iter().any(|(c, _)| *c < T::zero());
        let lengths = if is_bound { 0 } else { 4 };
        for units in [(lengths, 0, 0), (-lengths, 5, 0), (0, -7, 3)] {
            if let Some(scene) = self.scene.in_units(units.0, units.1, units.2) {
                self.compare_with(now, &scene, units);
            }
        }
    }

    /// Compares with the same scene in other units: lengths, forces and times are multiplied by 2 to these powers.
    fn compare_with(&mut self, now: &Now<'_, '_, T>, scene: &Scene<T>, units: (i32, i32, i32)) {
        let (length, force, _) = units;
        let r = self.place(now.radius(), self.scene.inset);
        let unit = T::power_of_two(length);
        let pressure = T::power_of_two(force) / (unit * unit);
        let expected = [now.radius() * unit, now.approach() * unit, now.pressure(r) * pressure];
        if !(expected.iter().all(has_room) && self.has_room_in(scene, now.radius(), units)) {
            return;
        }
        self.findings.count(Tally::Units);
        match results(scene, r * unit) {
            Err(error) => self.findings.fault(Fault::Refused, &error),
            Ok(found) if found == expected => {}
            Ok(found) => {
                let [found, expected] = [found, expected].map(|values| values.map(T::value));
                self.findings.fault(
                    Fault::NotInvariant,
                    &format_args!("{found:?}, not {expected:?} in units 2^{units:?}"),
                );
            }
        }
    }

    /// Whether the input and the intermediate results of a radius keep their digits in these and in other units.
    fn has_room_in(&self, scene: &Scene<T>, radius: T, (length, force, time): (i32, i32, i32)) -> bool {
        // No number may become zero in other units.
        let mut inputs = self.scene.numbers().zip(scene.numbers());
        let forces = self.scene.knots.iter().map(|knot| knot.1).filter(|force| !force.is_zero());
        let least = forces.fold(T::infinity(), |least, force| least.min(force * self.scene.chi));
        let load_integral = self.contact.profile().load_integral(radius);
        let (impulse, last) = (self.least_impulse(), self.contact.load().impulse(self.scene.time));
        let (steepest, slope_unit) = (self.steepest_slope(), T::power_of_two(force - time));
        let impulse_unit = T::power_of_two(force + time);
        let intermediate = [
            least,
            load_integral,
            load_integral * T::power_of_two(5 * length),
            impulse,
            impulse * impulse_unit,
            last,
            last * impulse_unit,
            steepest,
            steepest * slope_unit,
        ];
        intermediate.iter().all(has_room)
            && inputs.all(|(x, y)| has_room(&x) && has_room(&y) && x.is_zero() == y.is_zero())
    }

    /// The largest size of a slope between two knots.
    fn steepest_slope(&self) -> T {
        let pairs = self.scene.knots.windows(2).filter(|pair| pair[0].0 < pair[1].0);
        let slopes = pairs.map(|pair| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs());
        slopes.fold(T::zero(), T::max)
    }

    /// Twice the least impulse between two knots that is not zero; zero if there is none.
    fn least_impulse(&self) -> T {
        let impulses =
            self.scene.knots.windows(2).map(|pair| (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1));
        let least = impulses.filter(|impulse| !impulse.is_zero()).fold(T::infinity(), T::min);
        if least.is_finite() { least } else { T::zero() }
    }
}

/// Whether a number is zero, or so far from the ends of the range that intermediate results have all their digits.
fn has_room<T: Precision>(x: &T) -> bool {
    x.is_zero() || (T::LEAST / T::EPSILON / T::EPSILON..T::MOST * T::EPSILON).contains(&x.value().abs())
}

/// Radius, approach and the pressure at a distance from the axis.
fn results<T: Precision>(scene: &Scene<T>, r: T) -> Result<[T; 3], Box<dyn core::error::Error>> {
    let profile = solver(scene)?;
    let contact = contact(scene, &*profile)?;
    let now = contact.at(scene.time)?;
    Ok([now.radius(), now.approach(), now.pressure(r)])
}
