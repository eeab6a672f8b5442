//! The patellofemoral joint of the paper's section 7: tables, and its figures 2 and 3.
//!
//! ```text
//! cargo run --release --example patellofemoral
//! ```
//!
//! A ball of radius 10 mm in a socket of 20 mm is described by two gap profiles, to second and to fourth order. The
//! example shows how much the fourth order matters, with the rate χ of drainage as it follows from the layers'
//! displacements and as the paper prints it. The figure of pressures uses only the former; the README shows a copy of
//! it, `figures/pressure.svg`.
//!
//! I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.

use std::error::Error;
use std::f64::consts::TAU;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use cartcontact::{Contact, ContactError, GapProfile, Layer, Medium, gap_profile, load};
use examples::figure::{self, Axis, Curve, Dash, Panel};
use examples::page::Ink;

/// Gap (4): ball and socket to second order.
#[gap_profile(0.025 * r^2)]
struct SecondOrder;

/// Gap (29): ball and socket to fourth order.
#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct FourthOrder;

/// Both layers, which are equal.
const LAYER: Layer<f64> = Layer { thickness: 1.0, shear_modulus: 0.25, permeability: 2e-3 };
/// The ratio of a matrix that does not widen when it is compressed.
const POISSON_RATIO: f64 = 0.0;
/// Held from t = 0 on, in N.
const FORCE: f64 = 100.0;
/// The times of the table, in s.
const TIMES: [f64; 3] = [0.0, 100.0, LAST_TIME];
const LAST_TIME: f64 = 200.0;
/// The times of figure 3, in s. At 100 s the pressures of gap (29) hide those that gap (4) has at 0 s.
const PRESSURE_TIMES: [f64; 3] = [0.0, 200.0, 400.0];
/// In mm, beyond the edge of all contacts shown.
const LARGEST_RADIUS: f64 = 9.0;

/// The folder of the figures, relative to the one in which the program runs.
const FOLDER: &str = "target/cartcontact";

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    let consistent = Medium::between(LAYER, LAYER)?;
    let printed = Medium::between_as_printed_2011(LAYER, LAYER)?;
    let mut out = io::stdout().lock();
    write_setting(&mut out, consistent, printed)?;
    write_states(&mut out, [consistent, printed])?;
    write_differences(&mut out, consistent, printed)?;

    let folder = Path::new(FOLDER);
    let history = folder.join("figure_2_history.svg");
    figure::write(&history, 68.0, &history_panels(consistent, printed)?)?;
    let pressure = folder.join("figure_3_pressure.svg");
    figure::write(&pressure, 80.0, &[pressure_panel(consistent)?])?;
    writeln!(out, "\nFigures\n  {}\n  {}", history.display(), pressure.display())?;
    Ok(())
}

/// The results of a contact at one time in the table and in figure 2.
struct State {
    time: f64,
    radius: f64,
    approach: f64,
    peak_pressure: f64,
}

/// The state at a time under a force that is held from t = 0 on.
fn state(
    profile: impl GapProfile<f64>,
    medium: Medium<f64>,
    force: f64,
    time: f64,
) -> Result<State, ContactError> {
    let contact = Contact::new(profile, medium, load::Constant(force))?;
    let now = contact.at(time)?;
    Ok(State { time, radius: now.radius(), approach: now.approach(), peak_pressure: now.peak_pressure() })
}

fn write_setting(out: &mut impl Write, consistent: Medium<f64>, printed: Medium<f64>) -> io::Result<()> {
    let Layer { thickness, shear_modulus, permeability } = LAYER;
    writeln!(out, "Patellofemoral joint, {FORCE} N held for {LAST_TIME} s\n")?;
    writeln!(out, "gap (4)   0.025 r²                   ball in socket to second order")?;
    writeln!(out, "gap (29)  0.025 r² + 1.09375e-4 r⁴   ball in socket to fourth order")?;
    writeln!(out, "layers    two, each {thickness} mm thick, shear modulus {shear_modulus} MPa,")?;
    writeln!(out, "          permeability {permeability} mm⁴/(N s)")?;
    writeln!(out, "χ         {:.4}/s from the layers' displacements (consistent),", consistent.chi())?;
    writeln!(out, "          {:.4}/s as the paper prints it\n", printed.chi())
}

fn write_states(out: &mut impl Write, media: [Medium<f64>; 2]) -> Result<(), Box<dyn Error>> {
    writeln!(out, "                    radius (mm)       approach (mm)    peak pressure (MPa)")?;
    writeln!(out, "  χ (1/s)  t (s)  gap (4) gap (29)  gap (4) gap (29)   gap (4) gap (29)")?;
    for medium in media {
        for time in TIMES {
            let second = state(SecondOrder, medium, FORCE, time)?;
            let fourth = state(FourthOrder, medium, FORCE, time)?;
            write!(out, "{:>9.4} {:>6}", medium.chi(), time)?;
            write!(out, "  {:>7.3} {:>8.3}", second.radius, fourth.radius)?;
            write!(out, "  {:>7.4} {:>8.4}", second.approach, fourth.approach)?;
            writeln!(out, "   {:>7.4} {:>8.4}", second.peak_pressure, fourth.peak_pressure)?;
        }
    }
    let ratio = state(FourthOrder, media[0], FORCE, 0.0)?.radius / LAYER.thickness;
    let diffusion = LAYER.diffusion_time(POISSON_RATIO)?;
    writeln!(out, "\nThe model is the limit of a contact that is wide compared with the thickness of")?;
    writeln!(out, "the layers, and of times that are short compared with the diffusion of fluid")?;
    writeln!(out, "through them. Here the radius is at least {ratio:.1} thicknesses, and the diffusion")?;
    writeln!(out, "time is {diffusion:.0} s, for a Poisson's ratio of {POISSON_RATIO}.")?;
    Ok(())
}

fn write_differences(
    out: &mut impl Write,
    consistent: Medium<f64>,
    printed: Medium<f64>,
) -> Result<(), Box<dyn Error>> {
    let reduced_force = FORCE / TAU;
    let reduced = format!("{FORCE}/(2π) N = {reduced_force:.1} N, χ as printed");
    let rows = [
        ("quoted in the paper".to_owned(), [2.3, 3.3, 4.6]),
        (format!("{FORCE} N, χ as printed"), differences(printed, FORCE)?),
        (format!("{FORCE} N, χ consistent"), differences(consistent, FORCE)?),
        (reduced, differences(printed, reduced_force)?),
    ];
    writeln!(out, "\nDifference between the gaps at {LAST_TIME} s, relative to gap (29)\n")?;
    writeln!(out, "{:40}  radius  peak pressure  approach", "")?;
    for (name, [radius, peak_pressure, approach]) in rows {
        writeln!(out, "{name:40} {radius:>5.1} % {peak_pressure:>12.1} % {approach:>7.1} %")?;
    }
    writeln!(out, "\nThe parameters that the paper states do not give the differences that it quotes.")?;
    writeln!(out, "A load smaller by the factor 2π does, to within 0.2 points, so its curves seem")?;
    writeln!(out, "to be for that load. The table and the figures here are for {FORCE} N.")?;
    Ok(())
}

/// By how many per cent radius, peak pressure and approach differ between the gaps at the last time.
fn differences(medium: Medium<f64>, force: f64) -> Result<[f64; 3], ContactError> {
    let second = state(SecondOrder, medium, force, LAST_TIME)?;
    let fourth = state(FourthOrder, medium, force, LAST_TIME)?;
    let per_cent = |value: f64, reference: f64| 100.0 * (value / reference - 1.0).abs();
    Ok([
        per_cent(second.radius, fourth.radius),
        per_cent(second.peak_pressure, fourth.peak_pressure),
        per_cent(second.approach, fourth.approach),
    ])
}

/// Figure 2: radius, approach and peak pressure against time.
fn history_panels(consistent: Medium<f64>, printed: Medium<f64>) -> Result<[Panel; 3], ContactError> {
    let histories = [
        ("gap (4), χ consistent", Ink::Blue, Dash::Solid, history(SecondOrder, consistent)?),
        ("gap (4), χ as printed", Ink::Blue, Dash::Dashed, history(SecondOrder, printed)?),
        ("gap (29), χ consistent", Ink::Vermilion, Dash::Solid, history(FourthOrder, consistent)?),
        ("gap (29), χ as printed", Ink::Vermilion, Dash::Dashed, history(FourthOrder, printed)?),
    ];
    let panel = |label, decimals, quantity: fn(&State) -> f64| Panel {
        title: None,
        x: Axis { label: "time (s)", decimals: 0 },
        x_end: LAST_TIME,
        y: Axis { label, decimals },
        curves: histories
            .iter()
            .map(|(name, ink, dash, states)| Curve {
                name: (*name).to_owned(),
                ink: *ink,
                dash: *dash,
                points: states.iter().map(|state| (state.time, quantity(state))).collect(),
            })
            .collect(),
    };
    Ok([
        panel("contact radius (mm)", 1, |state| state.radius),
        panel("approach (mm)", 2, |state| state.approach),
        panel("peak pressure (MPa)", 1, |state| state.peak_pressure),
    ])
}

/// The states under the force of the example, at enough times for a smooth curve.
fn history(profile: impl GapProfile<f64>, medium: Medium<f64>) -> Result<Vec<State>, ContactError> {
    evenly_spaced(LAST_TIME, 40).map(|time| state(&profile, medium, FORCE, time)).collect()
}

/// Figure 3: pressure against radius at three times.
fn pressure_panel(medium: Medium<f64>) -> Result<Panel, ContactError> {
    let mut curves = pressure_curves("0.025 r²", Ink::Blue, SecondOrder, medium)?;
    curves.extend(pressure_curves("0.025 r² + 1.09·10⁻⁴ r⁴", Ink::Vermilion, FourthOrder, medium)?);
    Ok(Panel {
        title: Some(format!("two gaps (mm) under {FORCE} N held from 0 s on, χ = {:.4}/s", medium.chi())),
        x: Axis { label: "radius (mm)", decimals: 0 },
        x_end: LARGEST_RADIUS,
        y: Axis { label: "pressure (MPa)", decimals: 1 },
        curves,
    })
}

/// One curve for each time.
fn pressure_curves(
    gap: &str,
    ink: Ink,
    profile: impl GapProfile<f64>,
    medium: Medium<f64>,
) -> Result<Vec<Curve>, ContactError> {
    let radii: Vec<f64> = evenly_spaced(LARGEST_RADIUS, 180).collect();
    let mut pressures = vec![0.0; PRESSURE_TIMES.len() * radii.len()];
    let contact = Contact::new(profile, medium, load::Constant(FORCE))?;
    contact.pressure_field(&PRESSURE_TIMES, &radii, &mut pressures)?;

    let dashes = [Dash::Solid, Dash::Dashed, Dash::Dotted];
    let rows = PRESSURE_TIMES.iter().zip(dashes).zip(pressures.chunks(radii.len()));
    Ok(rows
        .map(|((time, dash), row)| Curve {
            name: format!("{gap}, {time} s"),
            ink,
            dash,
            // The curve ends at the edge of the contact.
            points: radii.iter().copied().zip(row.iter().copied()).filter(|point| point.1 > 0.0).collect(),
        })
        .collect())
}

/// The numbers from 0 to `end` in equal steps.
fn evenly_spaced(end: f64, steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| end * f64::from(step) / f64::from(steps))
}
