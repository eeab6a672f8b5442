//! Contacts without the standard library and without allocation, as C would call them. NaN stands for an error.

#![no_std]

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, Layer, Medium, Polynomial, gap_profile};

/// In this precision are all numbers.
#[cfg(not(feature = "double"))]
type Real = f32;
#[cfg(feature = "double")]
type Real = f64;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct Constants;

#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3), positive)]
struct Ball<T> {
    radius: T,
}

#[gap_profile(0.02 * r^2.3)]
struct Fractional;

fn medium() -> Option<Medium<Real>> {
    let layer = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
    Medium::between(layer, layer).ok()
}

/// Contact radius, approach, peak pressure and the pressure at `r` under a load.
fn results(profile: impl GapProfile<Real>, load: impl Load<Real>, time: Real, r: Real) -> Option<[Real; 4]> {
    let contact = Contact::new(profile, medium()?, load).ok()?;
    let now = contact.at(time).ok()?;
    Some([now.radius(), now.approach(), now.peak_pressure(), now.pressure(r)])
}

/// The constants under a held load.
fn held(force: Real) -> Option<Contact<Real, Constants, Constant<Real>>> {
    Contact::new(Constants, medium()?, Constant(force)).ok()
}

/// Writes the results, or NaN.
fn write<const N: usize>(results: Option<[Real; N]>, written: &mut [Real; N]) {
    *written = results.unwrap_or([Real::NAN; N]);
}

#[unsafe(no_mangle)]
extern "C" fn radius_and_approach(force: Real, time: Real, written: &mut [Real; 2]) {
    let contact = held(force);
    let now = contact.as_ref().and_then(|contact| contact.at(time).ok());
    write(now.map(|now| [now.radius(), now.approach()]), written);
}

#[unsafe(no_mangle)]
extern "C" fn peak_pressure(force: Real, time: Real, written: &mut [Real; 3]) {
    let contact = held(force);
    let now = contact.as_ref().and_then(|contact| contact.at(time).ok());
    write(now.map(|now| [now.radius(), now.approach(), now.peak_pressure()]), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_constants(force: Real, time: Real, r: Real, written: &mut [Real; 4]) {
    write(results(Constants, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_field(radius: Real, force: Real, time: Real, r: Real, written: &mut [Real; 4]) {
    write(results(Ball { radius }, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_fractional_power(force: Real, time: Real, r: Real, written: &mut [Real; 4]) {
    write(results(Fractional, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_polynomial(terms: &[(Real, Real); 2], time: Real, r: Real, written: &mut [Real; 4]) {
    let polynomial = Polynomial::new(terms).ok();
    write(polynomial.and_then(|gap| results(gap, Constant(100.0), time, r)), written);
}

/// Of a record of times and forces.
fn of_knots(record: &[(Real, Real)], time: Real, r: Real, written: &mut [Real; 4]) {
    let load = PiecewiseLinear::new(record).ok();
    write(load.and_then(|load| results(Constants, load, time, r)), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_ten_knots(record: &[(Real, Real); 10], time: Real, r: Real, written: &mut [Real; 4]) {
    of_knots(record, time, r, written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_hundred_knots(record: &[(Real, Real); 100], time: Real, r: Real, written: &mut [Real; 4]) {
    of_knots(record, time, r, written);
}

/// A load that rises steadily, in N/s.
struct Rise(Real);

impl Load<Real> for Rise {
    fn force(&self, t: Real) -> Real {
        self.0 * t
    }
    fn impulse(&self, t: Real) -> Real {
        0.5 * self.0 * t * t
    }
}

#[unsafe(no_mangle)]
extern "C" fn of_a_load(rate: Real, time: Real, r: Real, written: &mut [Real; 4]) {
    write(results(Constants, Rise(rate), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn radii(times: &[Real; 8], written: &mut [Real; 8]) {
    if held(100.0).is_none_or(|contact| contact.radii(times, written).is_err()) {
        *written = [Real::NAN; 8];
    }
}

#[unsafe(no_mangle)]
extern "C" fn pressure_field(times: &[Real; 4], radii: &[Real; 4], written: &mut [Real; 16]) {
    if held(100.0).is_none_or(|contact| contact.pressure_field(times, radii, written).is_err()) {
        *written = [Real::NAN; 16];
    }
}
