//! Single-precision contacts without the standard library and without allocation, as C would call them. NaN stands for
//! an error.

#![no_std]

use cartcontact::load::{Constant, Load, PiecewiseLinear};
use cartcontact::{Contact, GapProfile, Layer, Medium, Polynomial, gap_profile};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct Constants;

#[gap_profile(r^2 / (2 * radius) + r^4 / (8 * radius^3), positive)]
struct Ball {
    radius: f32,
}

#[gap_profile(0.02 * r^2.3)]
struct Fractional;

fn medium() -> Option<Medium<f32>> {
    let layer = Layer { thickness: 1.0_f32, shear_modulus: 0.25, permeability: 2e-3 };
    Medium::between(layer, layer).ok()
}

/// Contact radius, approach, peak pressure and the pressure at `r` under a load.
fn results(profile: impl GapProfile<f32>, load: impl Load<f32>, time: f32, r: f32) -> Option<[f32; 4]> {
    let contact = Contact::new(profile, medium()?, load).ok()?;
    let now = contact.at(time).ok()?;
    Some([now.radius(), now.approach(), now.peak_pressure(), now.pressure(r)])
}

/// The constants under a held load.
fn held(force: f32) -> Option<Contact<f32, Constants, Constant<f32>>> {
    Contact::new(Constants, medium()?, Constant(force)).ok()
}

/// Writes the results, or NaN.
fn write<const N: usize>(results: Option<[f32; N]>, written: &mut [f32; N]) {
    *written = results.unwrap_or([f32::NAN; N]);
}

#[unsafe(no_mangle)]
extern "C" fn radius_and_approach(force: f32, time: f32, written: &mut [f32; 2]) {
    let contact = held(force);
    let now = contact.as_ref().and_then(|contact| contact.at(time).ok());
    write(now.map(|now| [now.radius(), now.approach()]), written);
}

#[unsafe(no_mangle)]
extern "C" fn peak_pressure(force: f32, time: f32, written: &mut [f32; 3]) {
    let contact = held(force);
    let now = contact.as_ref().and_then(|contact| contact.at(time).ok());
    write(now.map(|now| [now.radius(), now.approach(), now.peak_pressure()]), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_constants(force: f32, time: f32, r: f32, written: &mut [f32; 4]) {
    write(results(Constants, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_field(radius: f32, force: f32, time: f32, r: f32, written: &mut [f32; 4]) {
    write(results(Ball { radius }, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_fractional_power(force: f32, time: f32, r: f32, written: &mut [f32; 4]) {
    write(results(Fractional, Constant(force), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_polynomial(terms: &[(f32, f32); 2], time: f32, r: f32, written: &mut [f32; 4]) {
    let polynomial = Polynomial::new(terms).ok();
    write(polynomial.and_then(|gap| results(gap, Constant(100.0), time, r)), written);
}

/// Of a record of times and forces.
fn of_knots(record: &[(f32, f32)], time: f32, r: f32, written: &mut [f32; 4]) {
    let load = PiecewiseLinear::new(record).ok();
    write(load.and_then(|load| results(Constants, load, time, r)), written);
}

#[unsafe(no_mangle)]
extern "C" fn of_ten_knots(record: &[(f32, f32); 10], time: f32, r: f32, written: &mut [f32; 4]) {
    of_knots(record, time, r, written);
}

#[unsafe(no_mangle)]
extern "C" fn of_a_hundred_knots(record: &[(f32, f32); 100], time: f32, r: f32, written: &mut [f32; 4]) {
    of_knots(record, time, r, written);
}

/// A load that rises steadily, in N/s.
struct Rise(f32);

impl Load<f32> for Rise {
    fn force(&self, t: f32) -> f32 {
        self.0 * t
    }
    fn impulse(&self, t: f32) -> f32 {
        0.5 * self.0 * t * t
    }
}

#[unsafe(no_mangle)]
extern "C" fn of_a_load(rate: f32, time: f32, r: f32, written: &mut [f32; 4]) {
    write(results(Constants, Rise(rate), time, r), written);
}

#[unsafe(no_mangle)]
extern "C" fn radii(times: &[f32; 8], written: &mut [f32; 8]) {
    if held(100.0).is_none_or(|contact| contact.radii(times, written).is_err()) {
        *written = [f32::NAN; 8];
    }
}

#[unsafe(no_mangle)]
extern "C" fn pressure_field(times: &[f32; 4], radii: &[f32; 4], written: &mut [f32; 16]) {
    if held(100.0).is_none_or(|contact| contact.pressure_field(times, radii, written).is_err()) {
        *written = [f32::NAN; 16];
    }
}
