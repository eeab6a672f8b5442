//! Every public result of one scene, compared with the exact one.

use cartcontact::load::{LoadError, PiecewiseLinear};
use cartcontact::{ContactError, GapProfile, Snapshot};

use super::condition;
use super::exact::Profile;
use super::finding::{Fault, Findings, Quantity, Tally};
use super::history::History;
use super::precision::Precision;
use super::scene::Scene;
use super::solver::{Loaded, contact, solver};
use super::usable;
use super::wide::Wide;
use crate::budget;
use crate::condition::edge;
use crate::quadrature::Graded;

/// The most knots for which the balance is examined: the number of its pressures and the time of each grow with them.
const MOST_KNOTS: usize = 30;

/// How much of a scene is examined.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Depth {
    /// The pressure after drainage, against its integral in 31 digits: some milliseconds.
    pub(super) memory: bool,
    /// The balance of pressure and load, from some thousand pressures: some milliseconds.
    pub(super) balance: bool,
}

/// Computes a scene and reports what is found.
pub(super) fn examine<T: Precision>(scene: &Scene<T>, depth: Depth, findings: &mut dyn Findings) {
    let profile = match solver(scene) {
        Ok(profile) => profile,
        Err(error) => return turned_away(&error, usable::is_geometry(&scene.terms), findings),
    };
    let contact = match contact(scene, &*profile) {
        Ok(contact) => contact,
        Err(error) => return turned_away(&error, usable::is_contact(scene), findings),
    };
    let examination = Examination { scene, contact, exact: exact(scene), findings };
    examination.run(depth);
}

/// Notes a scene for which no contact could be made, which is a fault if the scene is usable.
fn turned_away(error: &dyn core::fmt::Display, is_usable: bool, findings: &mut dyn Findings) {
    if is_usable {
        findings.fault(Fault::Refused, error);
    }
    findings.count(Tally::Refused);
}

fn exact<T: Precision>(scene: &Scene<T>) -> History {
    let knots: Vec<_> = scene.knots.iter().map(|&(t, force)| (t.value(), force.value())).collect();
    History::new(Profile::new(scene.exact_terms()), (scene.m.value(), scene.chi.value()), &knots)
}

pub(super) struct Examination<'a, T: Precision> {
    pub(super) scene: &'a Scene<T>,
    pub(super) contact: Loaded<'a, T>,
    exact: History,
    pub(super) findings: &'a mut dyn Findings,
}

impl<T: Precision> Examination<'_, T> {
    fn run(mut self, depth: Depth) {
        let contact = self.contact;
        let time = Wide::of(self.scene.time.value());
        let hereditary = self.exact.hereditary(time);
        let y = hereditary / self.exact.stiffness();
        // A load that rounds to zero is no load, and so is one whose force and impulse do.
        let rounds_to_zero = |x: f64| x < T::LEAST * T::EPSILON;
        let [force, impulse] = [self.exact.force(time).value(), self.impulse(time, y)];
        if rounds_to_zero(hereditary.value()) || rounds_to_zero(force) && rounds_to_zero(impulse) {
            self.findings.count(Tally::Unsolved);
            return self.unloaded();
        }
        let now = contact.at(self.scene.time);
        let found = now.as_ref().map_or(f64::NAN, |now| now.radius().value());
        let estimate = if found > 0.0 { Wide::of(found) } else { self.exact.profile.one_term_radius(y) };
        let radius = self.exact.profile.radius(y, estimate);
        let is_solved = now.is_ok() && radius.is_some();
        self.findings.count(if is_solved { Tally::Solved } else { Tally::Unsolved });
        match (now, radius) {
            (Ok(now), Some(a)) => self.solved(&now, a, depth),
            (Ok(_), None) => self.accepted(found, y),
            (Err(error), _) => {
                self.refused(&error, self.scene.time);
            }
        }
    }

    /// No load, no contact.
    fn unloaded(&mut self) {
        match self.contact.at(self.scene.time) {
            Ok(now) if now.radius().is_zero() && now.peak_pressure().is_zero() => {}
            Ok(now) => self.findings.fault(Fault::Accepted, &now.radius().value()),
            Err(error) => self.findings.fault(Fault::Refused, &error),
        }
    }

    /// A radius beyond the last exact one is right if rounding cannot tell J there from the load.
    fn accepted(&mut self, found: f64, y: Wide) {
        let load_integral = self.exact.profile.kernels(Wide::of(found)).load_integral;
        let error = ((load_integral.value - y) / load_integral.size).value().abs() / T::EPSILON;
        if error > T::allowed(Quantity::LoadIntegral.allowance()) {
            self.findings
                .fault(Fault::Accepted, &format_args!("radius {found:e}, where J is off by {error:.1} ε"));
        }
    }

    /// An error at a time is right beyond the admissible range, and where J, a J′ or a term of that leaves the format.
    fn refused(&mut self, error: &ContactError, time: T) {
        let time = Wide::of(time.value());
        let y = self.exact.hereditary(time) / self.exact.stiffness();
        let estimate = || self.exact.profile.one_term_radius(y);
        let radius = if y.is_positive() { self.exact.profile.radius(y, estimate()) } else { None };
        let is_right = match (error, radius) {
            (ContactError::BeyondRange { max_radius, .. }, Some(a)) => {
                // Rounding of J may hide whether a radius next to the end of the range is inside.
                let slack = 4.0 * T::EPSILON * condition::of_radius(&self.exact.profile.kernels(a));
                a.value() > max_radius * (1.0 - slack)
            }
            (ContactError::BeyondRange { .. }, None) => true,
            (ContactError::InvalidTime { time }, _) => !time.is_finite(),
            (ContactError::Load(LoadError::InvalidImpulse { .. }), _) => {
                self.impulse(time, y) > T::MOST * (1.0 - 8.0 * T::EPSILON)
            }
            (ContactError::Unrepresentable { .. }, radius) => self.is_out_of_range(time, y, radius),
            (_, radius) => {
                let slope = radius.map_or(y, |a| self.exact.profile.kernels(a).log_slope.value);
                slope.value() > T::MOST
            }
        };
        if !is_right {
            self.findings.fault(Fault::Refused, error);
        }
    }

    /// ∫F up to a time, from Y/(π m/4).
    fn impulse(&self, time: Wide, y: Wide) -> f64 {
        (y * self.exact.stiffness() - self.exact.force(time)).value() / self.scene.chi.value()
    }

    /// Whether a number that needs all its digits lacks some.
    fn is_out_of_range(&self, time: Wide, y: Wide, radius: Option<Wide>) -> bool {
        let force = self.exact.force(time).value();
        let chi = self.scene.chi.value();
        let impulse = self.impulse(time, y);
        let fourth = radius.map_or(0.0, |a| (a * a * a * a).value());
        let slope = radius.map_or(0.0, |a| (y / (a * a * a * a * a)).value());
        let curvature = if fourth > 0.0 { force / fourth } else { 0.0 };
        // Terms of both signs may be far larger than their sum.
        let growth = radius.map_or(0.0, |a| self.exact.profile.kernels(a).log_slope.size.value());
        let of_force = force / self.exact.stiffness().value();
        let drained_slope = curvature / self.exact.stiffness().value();
        let numbers =
            [y.value(), force, force * chi, of_force, impulse, fourth, slope, curvature, drained_slope];
        numbers.into_iter().any(|x| x < T::LEAST * (1.0 + 4.0 * T::EPSILON))
            || fourth > T::MOST * (1.0 - 8.0 * T::EPSILON)
            || (y * self.exact.stiffness()).value() > T::MOST * (0.5 - 8.0 * T::EPSILON)
            || growth > T::MOST * (0.5 - 8.0 * T::EPSILON)
    }

    fn solved(&mut self, now: &Now<'_, '_, T>, a: Wide, depth: Depth) {
        let here = self.exact.profile.kernels(a);
        let found = now.radius().value();
        let condition = condition::of_radius(&here);
        let is_mixed = self.scene.terms.iter().any(|(c, _)| *c < T::zero());
        let of_radius = if is_mixed { condition * budget::RADIUS_OF_DIFFERENCES } else { condition };
        self.measure(Quantity::Radius, found, a, of_radius);
        if !(found > 0.0 && found.is_finite()) {
            self.findings
                .fault(Fault::NotANumber, &format_args!("radius {found:e} instead of {:e}", a.value()));
            return;
        }
        let degree = (a * here.approach_slope.value / here.approach.value).value();
        self.measure(
            Quantity::ContactApproach,
            now.approach().value(),
            here.approach.value,
            // The approach belongs to the radius found, which may be off by all that is allowed for a radius.
            of_radius * (budget::ROUNDINGS_OF_APPROACH + degree),
        );
        self.kernels(now);
        // Pressures remember all radii of the history, of which the flattest is the least certain.
        let flattest = self.exact.profile.flattest_radius(a);
        let on_the_way = flattest.map_or(1.0, |s| condition::of_radius(&self.exact.profile.kernels(s)));
        let kernel = self.exact.profile.pressure_kernel(a, Wide::ZERO).condition();
        let of_fall = self.condition_of_fall(now.force());
        let condition = condition.max(on_the_way) * kernel * of_fall;
        self.pressures(now, a, condition, depth);
        self.field(now, condition);
        self.units(now);
        if depth.balance && self.scene.knots.len() <= MOST_KNOTS {
            // The pressure carries J of the radius that was found, whose error J magnifies to that of its own terms.
            self.balance(now, on_the_way.max(here.load_integral.condition()) * of_fall);
        }
    }

    /// Y/F under a load that falls, if terms of both signs make the radii on the way uncertain: what they carry is so
    /// much less than what they carried.
    fn condition_of_fall(&self, force: T) -> f64 {
        let (knots, time) = (&self.scene.knots, self.scene.time);
        let falls = knots.windows(2).any(|pair| pair[1].1 < pair[0].1 && pair[0].0 < time);
        if !falls || self.scene.terms.iter().all(|(c, _)| *c >= T::zero()) {
            return 1.0;
        }
        let hereditary = self.exact.hereditary(Wide::of(time.value()));
        (hereditary / Wide::of(force.value())).value().max(1.0)
    }

    /// A distance from the axis by its distance from the edge.
    pub(super) fn place(&self, radius: T, inset: f64) -> T {
        T::constant(radius.value() * (1.0 - inset)).min(radius)
    }

    fn kernels(&mut self, now: &Now<'_, '_, T>) {
        let profile = *self.contact.profile();
        let a = now.radius();
        let r = self.place(a, self.scene.inset);
        let exact = self.exact.profile.kernels(Wide::of(a.value()));
        let sums = [
            (Quantity::Gap, profile.gap(a), exact.gap),
            (Quantity::Approach, profile.approach(a), exact.approach),
            (Quantity::ApproachSlope, profile.approach_slope(a), exact.approach_slope),
            (Quantity::LoadIntegral, profile.load_integral(a), exact.load_integral),
            (Quantity::LogKernel, profile.log_kernel(a), exact.log_kernel),
        ];
        let length = (self.scene.terms.len() as f64 / budget::TERMS).max(1.0);
        for (quantity, found, exact) in sums {
            self.measure(quantity, found.value(), exact.value, exact.condition() * length);
        }
        if r < a {
            let exact = self.exact.profile.pressure_kernel(Wide::of(a.value()), Wide::of(r.value()));
            let found = profile.pressure_kernel(a, r).value();
            self.measure(Quantity::PressureKernel, found, exact.value, exact.condition() * length);
        }
    }

    fn pressures(&mut self, now: &Now<'_, '_, T>, a: Wide, condition: f64, depth: Depth) {
        self.course(now, a, condition);
        let is_undrained = (self.scene.chi * self.scene.time).is_zero();
        let time = Wide::of(self.scene.time.value());
        let is_known = depth.memory && self.exact.precision(time) < T::EPSILON / 8.0;
        let r = self.place(now.radius(), self.scene.inset);
        for (quantity, r) in [(Quantity::PeakPressure, T::zero()), (Quantity::Pressure, r)] {
            if r >= now.radius() {
                continue;
            }
            let exact = Wide::of(r.value());
            let expected = if is_undrained {
                Some(self.exact.undrained_pressure(a, exact))
            } else if is_known {
                self.exact.pressure(time, a, exact)
            } else {
                None
            };
            let edge = if quantity == Quantity::Pressure { edge(now.radius(), r) } else { 1.0 };
            if let Some(expected) = expected {
                self.measure(quantity, now.pressure(r).value(), expected, edge * condition);
            }
        }
    }

    /// Pressures are finite, not negative, and fall from the axis to the edge.
    ///
    /// Either of two pressures may be off by a share of itself. The exact pressures rise for certain if the outer one
    /// minus its share exceeds the inner one plus its share; next to the edge the share may be the whole pressure.
    fn course(&mut self, now: &Now<'_, '_, T>, a: Wide, condition: f64) {
        let is_representable = self.exact.undrained_pressure(a, Wide::ZERO).value() <= T::MOST / 16.0;
        let (mut inner, mut most) = (f64::INFINITY, f64::INFINITY);
        for inset in [1.0, 0.7, 0.3, 0.01, 1e-6, 1e-12, 1e-15, 0.0] {
            let r = self.place(now.radius(), inset);
            let pressure = now.pressure(r).value();
            let edge = edge(now.radius(), r);
            let share = T::allowed(Quantity::Pressure.allowance()) * T::EPSILON * edge * condition;
            let place = format_args!("P(a (1 − {inset:e})) = {pressure:e}, {inner:e} further in");
            if pressure < 0.0 {
                self.findings.fault(Fault::NegativePressure, &place);
            } else if pressure.is_nan() || is_representable && pressure.is_infinite() {
                self.findings.fault(Fault::NotANumber, &place);
            } else if pressure / (1.0 + share) > most + 16.0 * T::LEAST * T::EPSILON {
                self.findings.fault(Fault::RisingPressure, &place);
            }
            inner = pressure;
            most = if share < 1.0 { pressure / (1.0 - share) } else { most };
        }
    }

    /// A field at two times agrees with the snapshot at the second.
    fn field(&mut self, now: &Now<'_, '_, T>, condition: f64) {
        let third = self.scene.time * T::constant(1.0 / 3.0);
        let times = [third, self.scene.time];
        let radii = [T::zero(), self.place(now.radius(), 0.4), self.place(now.radius(), self.scene.inset)];
        let mut values = [T::zero(); 6];
        if let Err(error) = self.contact.pressure_field(&times, &radii, &mut values) {
            // The snapshot at the second time was not refused.
            self.refused(&error, third);
            return;
        }
        for (&r, value) in radii.iter().zip(&values[3..]) {
            let expected = now.pressure(r).value();
            if value.value() < 0.0 {
                self.findings.fault(Fault::NegativePressure, &format_args!("{:e} in a field", value.value()));
            }
            if expected.is_finite() && r < now.radius() {
                // If one of two pressures next to the edge is 0, the other is the scale.
                let (found, scale) = (value.value(), value.value().max(expected));
                let condition =
                    condition * edge(now.radius(), r) * if expected > 0.0 { scale / expected } else { 1.0 };
                let (found, expected) = if expected > 0.0 { (found, expected) } else { (expected, found) };
                self.measure(Quantity::Field, found, Wide::of(expected), condition);
            }
        }
    }

    /// 2π ∫₀ᵃ P r dr = F, between the radii at which the pressure has a kink.
    fn balance(&mut self, now: &Now<'_, '_, T>, condition: f64) {
        let force = now.force().value();
        let a = now.radius();
        let greatest = self.exact.undrained_pressure(Wide::of(a.value()), Wide::ZERO).value();
        if !(force > T::LEAST / T::EPSILON && greatest < T::MOST / 16.0 && greatest > T::LEAST / T::EPSILON) {
            return;
        }
        // What the kernel of a high power is multiplied up from is smaller than the kernel by as much.
        let highest = self.contact.profile().highest_exponent().value();
        if greatest / self.scene.m.value() / (2.0 * (highest + 2.0).powi(2)) < T::LEAST {
            return;
        }
        let mut borders = vec![0.0];
        for &(time, _) in self.scene.knots.iter().filter(|knot| knot.0 <= self.scene.time) {
            // An earlier contact may be refused, and the kink at its edge is then anywhere.
            let Some(radii) = self.radii_at(time, a) else { return };
            borders.extend(radii);
        }
        let flattest = self.exact.profile.flattest_radius(Wide::of(a.value()));
        borders.extend(flattest.map(|s| s.value() / a.value()));
        borders.push(1.0);
        borders.sort_by(f64::total_cmp);
        let rule = Graded::new(10, 24);
        let shares = borders.windows(2).filter(|ends| ends[0] < ends[1]).map(|ends| {
            rule.integrate(ends[0], ends[1], |q| now.pressure(T::constant(q * a.value())).value() * q)
        });
        let carried = core::f64::consts::TAU * shares.sum::<f64>();
        // In two factors, because a² may be out of range.
        let carried = Wide::of(carried) * Wide::of(a.value()) * Wide::of(a.value());
        self.measure(Quantity::Balance, carried.value(), Wide::of(force), condition);
    }

    /// The radii just before and at a time, as shares of the radius `a`; none if the contact is refused there.
    fn radii_at(&self, time: T, a: T) -> Option<[f64; 2]> {
        let before = time * (T::one() - T::constant(T::EPSILON * 4.0));
        let share = |time| Some((self.contact.at(time).ok()?.radius() / a).value().min(1.0));
        Some([share(before)?, share(time)?])
    }

    /// Notes an error as a share of the allowed one: in units of ε, relative to the smallest normal number at least.
    fn measure(&mut self, quantity: Quantity, found: f64, expected: Wide, condition: f64) {
        let value = expected.value();
        let is_out_of_range = value.abs() > T::MOST * (1.0 - T::EPSILON);
        let is_wrong = if is_out_of_range {
            // Infinity and numbers next to it are right.
            found.is_nan() || found.abs() < T::MOST * (1.0 - 64.0 * T::EPSILON * condition)
        } else {
            !found.is_finite()
        };
        if is_wrong {
            let about = format_args!("{} {found:e} instead of {value:e}", quantity.symbol());
            self.findings.fault(Fault::NotANumber, &about);
        }
        // What may be off by anything must not count as measured.
        if is_wrong || is_out_of_range || condition.is_infinite() {
            return;
        }
        let scale = expected.abs().max(Wide::of(T::LEAST));
        let error = ((Wide::of(found) - expected) / scale).value().abs() / T::EPSILON;
        let share = error / condition / T::allowed(quantity.allowance());
        self.findings.error(quantity, if share.is_nan() { f64::INFINITY } else { share });
    }
}

pub(super) type Now<'c, 'a, T> = Snapshot<'c, T, &'a dyn GapProfile<T>, PiecewiseLinear<T, &'a [(T, T)]>>;
