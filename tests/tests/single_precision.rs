//! Single precision against double precision, at inputs that both hold exactly.

use core::f64::consts::FRAC_PI_4;

use cartcontact::load::Constant;
use cartcontact::{Contact, GapProfile, Medium, Scalar, gap_profile};
use tests::budget;
use tests::condition;
use tests::joint::joint;
use tests::kernel::{self, Kernel};
use tests::loads::{Announced, through};
use tests::measure::{Errors, Exact};
use tests::oracle::{Profile, double};
use tests::profiles::{Case, DECIMALS, Decimals, Paraboloid};
use tests::random::Stream;
use tests::reference;

/// The numbers that single precision holds with all their digits.
const NORMAL: core::ops::Range<f64> = f32::MIN_POSITIVE as f64..f32::MAX as f64;

/// Whether the coefficients have all their digits in single precision; those of the flat-ended geometry do not.
fn is_representable(case: Case) -> bool {
    case.terms.iter().all(|&(c, _)| NORMAL.contains(&c.abs()))
}

#[test]
fn kernels_in_single_precision_are_those_of_double_and_of_the_oracle() {
    let mut errors = kernel::errors_of_single();
    compare_reference_rows(&mut errors);
    compare_decimal_powers(&mut errors);
    errors.iter().for_each(Errors::check_worst);
}

fn compare_reference_rows(errors: &mut [Errors; 6]) {
    for row in reference::kernels().iter().filter(|row| is_representable(row.case)) {
        let (a, r) = (row.a as f32, row.r as f32);
        for (kernel, errors) in kernel::ALL.into_iter().zip(errors.iter_mut()) {
            let expected = (kernel.double)(row.case.double, f64::from(a), f64::from(r));
            if NORMAL.contains(&expected) {
                let place = (f64::from(a), f64::from(r));
                let condition = kernel.condition(&row.case.of_sizes(), place, expected);
                let found = (kernel.single)(row.case.single, a, r).value();
                errors.add(found, expected, condition, &(row.case, a, r));
            }
        }
    }
}

/// The largest accepted range; its end rounds up in single precision.
#[gap_profile(0.001 * r^2 - 86e-5 * r^4, max_radius = 0.9338592)]
struct Turning;

#[test]
fn a_range_ends_in_single_precision_where_it_was_proved() {
    let (single, double): (f32, f64) = (Turning.max_radius(), Turning.max_radius());
    assert_eq!(double, Turning::MAX_RADIUS);
    assert!(
        f64::from(single) <= double && f64::from(single) > double * (1.0 - 3.0 * f64::from(f32::EPSILON))
    );
}

#[test]
fn radii_in_single_precision_agree_with_double() {
    let mut errors = Errors::of_single(budget::RADIUS);
    for row in reference::radii().into_iter().filter(|row| is_representable(row.case)) {
        let load_integral = (row.y / (row.m * FRAC_PI_4)) as f32;
        let expected = row.case.double.radius(load_integral.into()).unwrap_or(f64::NAN);
        let found = row.case.single.radius(load_integral).map_or(f64::NAN, f64::from);
        errors.add(found, expected, 1.0, &(row.case, load_integral));
    }
    errors.check();
}

mod high_powers {
    use super::gap_profile;

    #[gap_profile(r^3.75)]
    pub(super) struct Quarters;
    #[gap_profile(r^4.75)]
    pub(super) struct HighQuarters;
    #[gap_profile(r^3.07)]
    pub(super) struct Decimal;
    #[gap_profile(r^6)]
    pub(super) struct Sixth;
    #[gap_profile(r^2 + r^8 + r^16)]
    pub(super) struct Mixed;
    #[gap_profile(r^64)]
    pub(super) struct Highest;
}

/// High powers round often, and on the axis nothing else allows for an error. With the coefficient 1 both precisions have
/// the same gap.
#[test]
fn peaks_of_high_powers_are_as_exact_as_others() {
    use high_powers::{Decimal, HighQuarters, Highest, Mixed, Quarters, Sixth};
    let mut errors = Errors::of_single(budget::PEAK_PRESSURE);
    add_peaks(&mut errors, &Quarters);
    add_peaks(&mut errors, &HighQuarters);
    add_peaks(&mut errors, &Decimal);
    add_peaks(&mut errors, &Sixth);
    add_peaks(&mut errors, &Mixed);
    add_peaks(&mut errors, &Highest);
    errors.check();
}

/// Peak pressures at once, and after a fifth of the fluid's pressure has drained.
fn add_peaks<P: GapProfile<f32> + GapProfile<f64>>(errors: &mut Errors, profile: &P) {
    fn peak<T: Scalar>(profile: &dyn GapProfile<T>, m: f32, force: f32, chi: f32) -> f64 {
        let [m, force, chi] = [m, force, chi].map(|number| T::constant(number.into()));
        let contact = Medium::from_constants(m, chi)
            .ok()
            .and_then(|medium| Contact::new(profile, medium, Constant(force)).ok());
        contact
            .and_then(|contact| Some(contact.at(T::one()).ok()?.peak_pressure().value()))
            .unwrap_or(f64::NAN)
    }
    let mut stream = Stream::of_case(9, 0);
    for _ in 0..20_000 {
        let (m, force) = (stream.between(0.5, 1.0) as f32, stream.magnitude(-4.0, 4.0) as f32);
        for chi in [0.0, 0.25] {
            let expected = peak::<f64>(profile, m, force, chi);
            errors.add(peak::<f32>(profile, m, force, chi), expected, 1.0, &(m, force, chi));
        }
    }
}

/// The time since the last knot is rounded: what is left of a later time without it may lie a rounding before that
/// knot, where the force is another.
#[test]
fn jumps_soon_after_the_start_are_where_their_knots_are() -> Result<(), Box<dyn core::error::Error>> {
    let mut errors = Errors::of_single(budget::PEAK_PRESSURE);
    for start in [0.1_f32, 1e-3, 1.063_326_5e-9] {
        let knots = [(0.0, 50.0), (start, 50.0), (start, 80.0), (1.0, 90.0)];
        let curved = joint(Paraboloid, 0.5, Announced::curved(through(&knots)));
        let exact = knots.map(|(t, force)| (f64::from(t), f64::from(force)));
        let straight = joint(Paraboloid, 0.5, through(&exact));
        let (found, expected) = (curved.at(1.0)?.peak_pressure(), straight.at(1.0)?.peak_pressure());
        errors.add(found.into(), expected, 1.0, &start);
    }
    errors.check();
    Ok(())
}

#[test]
fn contacts_in_single_precision_agree_with_double() {
    let (mut radius, mut approach) =
        (Errors::of_single(budget::CONTACT_RADIUS), Errors::of_single(budget::CONTACT_APPROACH));
    let (mut pressure, mut peak) =
        (Errors::of_single(budget::PRESSURE), Errors::of_single(budget::PEAK_PRESSURE));
    for row in reference::contacts().into_iter().filter(|row| is_representable(row.case)) {
        let single = row.solved(row.case.single, |x| x as f32);
        let double = row.solved(row.case.double, |x| f64::from(x as f32));
        let condition = condition::of_radius(row.case.double, &row.case.of_sizes(), double[0]);
        let of_approach = condition::of_approach(row.case.double, double[0]);
        radius.add(single[0], double[0], condition, &row);
        approach.add(single[1], double[1], condition * of_approach, &row);
        pressure.add(single[2], double[2], condition::edge(double[0], f64::from(row.r as f32)), &row);
        peak.add(single[3], double[3], 1.0, &row);
    }
    radius.check();
    approach.check();
    pressure.check_worst();
    peak.check();
}

/// Single precision does not tell the fraction of its exponent from 1/4.
#[gap_profile(0.2 * r^2.25000001)]
struct NextToQuarters;

fn compare_decimal_powers(errors: &mut [Errors; 6]) {
    compare_with_oracle(&Decimals, &DECIMALS, |step| 0.01 * 1.17_f32.powi(step), errors);
    compare_with_oracle(&NextToQuarters, &[("0.2", "2.25000001")], |step| 10_f32.powi(step - 30), errors);
}

fn compare_with_oracle(
    profile: &dyn GapProfile<f32>,
    terms: &[(&str, &str)],
    radius: fn(i32) -> f32,
    errors: &mut [Errors; 6],
) {
    let oracle = Profile::of_decimals(terms);
    for step in 0..60 {
        let a = radius(step);
        let r = a * (1.0 - 0.8_f32.powi(step));
        let (exact_a, exact_r) = (double(f64::from(a)), double(f64::from(r)));
        for (Kernel { single, oracle: define, .. }, errors) in kernel::ALL.into_iter().zip(errors.iter_mut())
        {
            let expected = Exact::from(&define(&oracle, &exact_a, &exact_r));
            if NORMAL.contains(&expected.nearest) {
                errors.add(single(profile, a, r).value(), expected, 1.0, &(a, r));
            }
        }
    }
}
