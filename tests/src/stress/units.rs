//! One scene in other units.

use cartcontact::load::Load;

use super::examine::{Examination, Now};
use super::finding::{Fault, Tally};
use super::precision::Precision;
use super::scene::Form;
use super::solver::{contact, solver};

impl<T: Precision> Examination<'_, T> {
    /// Lengths, forces and times in units that differ by powers of two: the same bits.
    pub(super) fn units(&mut self, now: &Now<'_, '_, T>) {
        // Coefficients of constant geometries have no other units; the end of a range that is searched for is the zero
        // of a sum of exponentials of ln r, and rounded as such.
        let is_bound = matches!(self.scene.form, Form::Constant(_))
            || self.scene.terms.iter().any(|(c, _)| *c < T::zero());
        let lengths = if is_bound { 0 } else { 4 };
        for (length, force, time) in [(lengths, 0, 0), (-lengths, 5, 0), (0, -7, 3)] {
            let Some(scene) = self.scene.in_units(length, force, time) else { continue };
            let Ok(profile) = solver(&scene) else { continue };
            let Ok(contact) = contact(&scene, &*profile) else { continue };
            let r = self.place(now.radius(), self.scene.inset);
            let unit = T::power_of_two(length);
            let pressure = T::power_of_two(force) / (unit * unit);
            let expected = [now.radius() * unit, now.approach() * unit, now.pressure(r) * pressure];
            let forces = self.scene.knots.iter().map(|knot| knot.1).filter(|force| !force.is_zero());
            let least = forces.fold(T::infinity(), |least, force| least.min(force * self.scene.chi));
            let load_integral = self.contact.profile().load_integral(now.radius());
            let (impulse, last) = (self.least_impulse(), self.contact.load().impulse(self.scene.time));
            let intermediate = [
                least,
                load_integral,
                load_integral * T::power_of_two(5 * length),
                impulse,
                impulse * T::power_of_two(force + time),
                last,
                last * T::power_of_two(force + time),
            ];
            let has_room = |x: &T| {
                x.is_zero()
                    || (T::LEAST / T::EPSILON / T::EPSILON..T::MOST * T::EPSILON).contains(&x.value().abs())
            };
            // Nor may a number become zero in other units.
            let mut inputs = self.scene.numbers().zip(scene.numbers());
            if !expected.iter().chain(&intermediate).all(has_room)
                || !inputs.all(|(x, y)| has_room(&x) && has_room(&y) && x.is_zero() == y.is_zero())
            {
                continue;
            }
            self.findings.count(Tally::Units);
            let found = match contact.at(scene.time) {
                Ok(then) => [then.radius(), then.approach(), then.pressure(r * unit)],
                Err(error) => {
                    self.findings.fault(Fault::Refused, &error);
                    continue;
                }
            };
            if found != expected {
                let [found, expected] = [found, expected].map(|values| values.map(Precision::shown));
                let units = (length, force, time);
                self.findings.fault(
                    Fault::NotInvariant,
                    &format_args!("{found:?}, not {expected:?} in units 2^{units:?}"),
                );
            }
        }
    }

    /// The least impulse between two knots that is not zero, and zero if there is none.
    fn least_impulse(&self) -> T {
        let impulses =
            self.scene.knots.windows(2).map(|pair| (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1));
        let least = impulses.filter(|impulse| !impulse.is_zero()).fold(T::infinity(), T::min);
        if least.is_finite() { least } else { T::zero() }
    }
}
